#!/usr/bin/env bash
# Package:  Debian 12 octave 7.3.0-2: textscan().
# Expected: a decimal number is read as the nearest double, as str2double() and dlmread() read it; %d64 reads an int64.
# Seen:     textscan() builds the number digit by digit, and is up to a few units of the last place off. More than a
#           third of temperatures with four decimals are not the double that str2double() gives. %d64 goes through a
#           double: a time stamp of 19 digits comes 277 ns early.
# Matters:  a replay that must agree bit for bit differs by the reader alone. Time stamps in nanoseconds take a jitter
#           of a quarter of a microsecond, although their type says int64.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
enter_scratch
debian octave=7.3.0-2
cat >scan.m <<'M'
stamp = textscan("1700000000123456789", "%d64"){1};
printf("%s %d\n", class(stamp), stamp);
text = arrayfun(@(i) sprintf("%.4f", i / 1e4), 200001:300000, "UniformOutput", false);
exact = str2double(text)';
file = fopen("temperature.csv", "w");
fprintf(file, "%s\n", text{:});
fclose(file);
file = fopen("temperature.csv");
scanned = textscan(file, "%f"){1};
fclose(file);
printf("of 100000: textscan %d off, dlmread %d off\n", sum(scanned != exact), sum(dlmread("temperature.csv") != exact));
M
stated 'int64 1700000000123456512
of 100000: textscan 38800 off, dlmread 0 off' "$(octave-cli --no-history -q scan.m)"
