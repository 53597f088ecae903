# gnuplot: a table of what it plots, behind a header; its numbers have six digits.
set samples 40
row(x) = int(x + 0.5)
dph(x) = 7.25 + 0.5 * ((7 * row(x)) % 11)
celsius(x) = 21.5 + 0.125 * row(x)
do for [separator in "comma tab whitespace"] {
  mark = separator eq "comma" ? "," : separator eq "tab" ? "\t" : " "
  do for [time in "time_s time_ms t"] {
    do for [rate in "rate_dph gyro_dps"] {
      file = "gnuplot_" . time . "_" . rate . "_" . separator . ".csv"
      set print file
      print time . mark . "temp_degC" . mark . rate
      unset print
      per_s = time eq "time_ms" ? 1000 : 1
      per_dph = rate eq "rate_dph" ? 1 : 3600.
      if (separator eq "comma") { set table file append separator comma }
      if (separator eq "tab") { set table file append separator tab }
      if (separator eq "whitespace") { set table file append separator whitespace }
      plot [0:39] '+' using (0.5 * row($1) * per_s):(celsius($1)):(dph($1) / per_dph) with table
      unset table
    }
  }
}
