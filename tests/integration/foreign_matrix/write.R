# R: write.table with each of its separators, decimal marks, quotes and row names; times as numbers and as POSIXct.
row <- 0:39
t <- 0.5 * row
celsius <- 21.5 + 0.125 * row
dph <- 7.25 + 0.5 * ((7 * row) %% 11)
options(digits.secs = 3)
times <- list(time_s = t, time_ms = 1000 * t, Time = t, timestamp = 1709625600 + t,
              DateTime = format(as.POSIXct(1709625600 + t, origin = "1970-01-01", tz = "UTC"), "%Y-%m-%d %H:%M:%OS3"),
              Date = format(as.POSIXct(1709625600 + t, origin = "1970-01-01", tz = "UTC"), "%d.%m.%Y %H:%M:%OS3"))
temperatures <- list("temperature_degc" = celsius, "T.K" = celsius + 273.15, "Temp (degF)" = 32 + 1.8 * celsius)
rates <- list("rate_dph" = dph, "Gyro [deg/s]" = dph / 3600, "rate_mdps" = dph / 3.6, "Gyro" = dph)
layouts <- list(csv = list(sep = ","), csv2 = list(sep = ";", dec = ","), tab = list(sep = "\t"),
                tab2 = list(sep = "\t", dec = ","), blank = list(sep = " "), comma2 = list(sep = ",", dec = ","))
for (a in seq_along(times)) for (b in seq_along(temperatures)) for (c in seq_along(rates)) {
  for (d in seq_along(layouts)) for (names in c(FALSE, TRUE)) {
    if (sum(c(a, b, c, d) > 1, names) > 2) next
    data <- data.frame(times[[a]], temperatures[[b]], rates[[c]])
    names(data) <- c(names(times)[a], names(temperatures)[b], names(rates)[c])
    file <- sprintf("R_%s_%d_%d_%s_%s.csv", names(times)[a], b, c, names(layouts)[d], names)
    do.call(write.table, c(list(data, file, row.names = names), layouts[[d]]))
  }
}
