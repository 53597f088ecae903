% Octave: fprintf for the header, dlmwrite for the rows.
row = (0:39)';
t = 0.5 * row;
celsius = 21.5 + 0.125 * row;
dph = 7.25 + 0.5 * mod(7 * row, 11);
times = {"time_s", t; "time_ms", 1000 * t; "time", t; "elapsed", 1000 * t; "datenum", 739316.5 + t / 86400; ...
         "timestamp", 1709625600 + t; "unix_ns", 1e9 * (1709625600 + t)};
temperatures = {"temp_degC", celsius; "T [K]", celsius + 273.15; "coil_temp_degF", 32 + 1.8 * celsius};
rates = {"rate_dph", dph; "gyro_dps", dph / 3600; "omega_rad_s", dph * pi / 180 / 3600; "wz", dph};
separators = {"comma", ","; "semicolon", ";"; "tab", "\t"; "blank", " "; "bar", "|"};
for a = 1:rows(times) for b = 1:rows(temperatures) for c = 1:rows(rates) for d = 1:rows(separators)
  if (sum([a b c d] > 1) > 2) continue; end
  name = sprintf("octave_%s_%s_%s_%s.csv", times{a, 1}, temperatures{b, 1}(1:2), rates{c, 1}, separators{d, 1});
  s = separators{d, 2};
  file = fopen(name, "w");
  fprintf(file, ["%s" s "%s" s "%s\n"], times{a, 1}, temperatures{b, 1}, rates{c, 1});
  fclose(file);
  dlmwrite(name, [times{a, 2}, temperatures{b, 2}, rates{c, 2}], "-append", "delimiter", s, "precision", "%.15g");
end end end end
