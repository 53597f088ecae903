# NumPy: savetxt with each separator, format and kind of header.
import itertools
import numpy as np

row = np.arange(40)
t, celsius, dph = 0.5 * row, 21.5 + 0.125 * row, 7.25 + 0.5 * (7 * row % 11)
times = {"time_s": t, "time_us": 1e6 * t, "t": t, "stamp_time": 1000 * t, "timestamp_ms": 1000 * (1709625600 + t),
         "mjd_time": 60374.5 + t / 86400, "FileTime": 133541298150000000 + 1e7 * t}
temperatures = {"temp_degC": celsius, "temperature/K": celsius + 273.15, "temp_cdegC": 100 * celsius}
rates = {"rate_dph": dph, "gyro_z_dps": dph / 3600, "wz(rad/s)": np.radians(dph / 3600), "rate_dpm": dph / 60}
separators = {"comma": ",", "semicolon": ";", "tab": "\t", "blank": " "}
headers = {"commented": "# ", "plain": ""}
formats = {"long": "%.18e", "short": "%.15g"}
for choice in itertools.product(times, temperatures, rates, separators, headers, formats):
    defaults = [next(iter(d)) for d in (times, temperatures, rates, separators, headers, formats)]
    if sum(a != b for a, b in zip(choice, defaults)) > 2:
        continue
    time, temperature, rate, separator, header, form = choice
    s = separators[separator]
    name = "numpy_" + "_".join(choice).replace("/", "") + ".csv"
    np.savetxt(name, np.c_[times[time], temperatures[temperature], rates[rate]], delimiter=s, fmt=formats[form],
               header=s.join([time, temperature, rate]), comments=headers[header])
