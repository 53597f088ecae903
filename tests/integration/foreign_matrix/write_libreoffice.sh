#!/usr/bin/env bash
# LibreOffice: a table that it read, saved with each separator, quoting and encoding, in an English and a German
# setting; times as numbers and as dates.
set -euo pipefail
awk 'BEGIN {
  split("time_s,time_s,Time [ms],timestamp", times, ",")
  split("rate_dph,gyro [deg/s],gyro [deg/s],rate_dph", rates, ",")
  for (t = 1; t <= 4; t++) {
    file = "table" t ".txt"
    print times[t] ",temp_degC," rates[t] >file
    for (i = 0; i < 40; i++) {
      time = t == 4 ? sprintf("2024-03-05 12:00:%02d.%d", i / 2, i % 2 * 5) : 0.5 * i * (t == 3 ? 1000 : 1)
      printf "%s,%.10g,%.10g\n", time, 21.5 + 0.125 * i, (7.25 + 0.5 * (7 * i % 11)) / (t % 4 > 1 ? 3600 : 1) >file
    }
  }
}'
csv='Text - txt - csv (StarCalc)' utf8=76 utf16=65535
for locale in en-US de-DE; do
  mkdir -p "$locale/user"
  cat >"$locale/user/registrymodifications.xcu" <<END
<?xml version="1.0" encoding="UTF-8"?>
<oor:items xmlns:oor="http://openoffice.org/2001/registry" xmlns:xs="http://www.w3.org/2001/XMLSchema">
<item oor:path="/org.openoffice.Setup/L10N"><prop oor:name="ooSetupSystemLocale" oor:op="fuse"><value>$locale</value></prop></item>
</oor:items>
END
  # Separator (its code), quotes (their code), encoding, first line, formats, language, all texts quoted, as shown.
  for layout in comma:44,34,$utf8,1,,0,false,true quoted:59,34,$utf8,1,,0,true,true utf16:9,34,$utf16,1,,0,false,true; do
    soffice --headless "-env:UserInstallation=file://$PWD/$locale" "--infilter=$csv:44,34,$utf8,1,,1033,false,true" \
      --convert-to "csv:$csv:${layout#*:}" --outdir out table*.txt
    for file in out/*.csv; do mv "$file" "libreoffice_${locale%-*}_${layout%%:*}_$(basename "$file")"; done
  done
done
