# pandas: to_csv with each separator, decimal mark, quoting, index and encoding; times as numbers and as dates.
import csv
import itertools
import numpy as np
import pandas as pd

row = np.arange(40)
t, celsius, dph = 0.5 * row, 21.5 + 0.125 * row, 7.25 + 0.5 * (7 * row % 11)
dates = pd.to_datetime(1709625600 * 10**9 + (1e9 * t).astype("int64"))
times = {"time_s": t, "Time [ms]": 1000 * t, "time": t, "timestamp": dates, "utc": dates.tz_localize("UTC"),
         "epoch_ns": dates.astype("int64")}
temperatures = {"temp_degC": celsius, "T [K]": celsius + 273.15}
rates = {"rate_dph": dph, "gyro [deg/s]": dph / 3600, "gyro": dph}
layouts = {"comma": {}, "semicolon": {"sep": ";", "decimal": ","}, "tab": {"sep": "\t"},
           "quoted": {"quoting": csv.QUOTE_NONNUMERIC}, "all_quoted": {"quoting": csv.QUOTE_ALL, "decimal": ","},
           "utf16": {"encoding": "utf-16"}, "bom": {"encoding": "utf-8-sig"}, "crlf": {"lineterminator": "\r\n"}}
indices = {"without": False, "with": True}
for choice in itertools.product(times, temperatures, rates, layouts, indices):
    if sum(a != next(iter(d)) for a, d in zip(choice, (times, temperatures, rates, layouts, indices))) > 2:
        continue
    time, temperature, rate, layout, index = choice
    data = pd.DataFrame({time: times[time], temperature: temperatures[temperature], rate: rates[rate]})
    name = "pandas_" + "_".join(choice).replace("/", "").replace(" ", "") + ".csv"
    data.to_csv(name, index=indices[index], **layouts[layout])
