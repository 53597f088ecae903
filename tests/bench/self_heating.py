#!/usr/bin/env python3
"""self_heating.py FOGCOMP [--gyros N] [--first N]: is the model that `info` proposes right where it has not been?
Gyros whose drift is a cubic of the temperature warm themselves up, so that the temperature's rate is a function of the
temperature. Each is fitted as `info` proposes, with the usual first model, and with a cubic. The error is that of the
drift in a chamber that heats and cools by the same temperatures. Prints a table of Markdown."""
import argparse, concurrent.futures, csv, math, os, random, re, statistics, subprocess, tempfile

USUAL = "bias,bias_temperature:order=2,temperature_rate"
CUBIC = "bias,bias_temperature:order=3"


def run(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode > 1:
        raise RuntimeError(" ".join(map(str, command)) + ": " + done.stderr)
    return done.stdout


def record(path, seconds, temperature, drift, sigma_dph, draw):
    with open(path, "w") as out:
        out.write("time_s,temperature_degc,rate_dph\n")
        for i in range(seconds):
            degc = temperature(i)
            out.write(f"{i},{degc:.4f},{drift(degc) + draw.gauss(0, sigma_dph):.4f}\n")


def rms_error(tool, model, recording, drift, folder):
    applied = os.path.join(folder, "applied.csv")
    run(tool, "apply", model, recording, "-o", applied)
    with open(applied, newline="") as lines:
        errors = [float(row["drift_dph"]) - drift(float(row["temperature_degc"])) for row in csv.DictReader(lines)]
    return statistics.pstdev(errors)


def gyro(tool, number):
    """rms error of each model, deg/h, and without one."""
    draw = random.Random(number)
    slope, cube = draw.uniform(-60, 60), draw.uniform(-20, 20)
    cold, rise, tau_s = draw.uniform(-10, 20), draw.uniform(25, 55), draw.uniform(200, 900)

    def drift(degc):
        x = (degc - 35) / 25
        return 100 + slope * x + cube * x ** 3

    with tempfile.TemporaryDirectory() as folder:
        own, unseen, model = (os.path.join(folder, name) for name in ("own.csv", "unseen.csv", "gyro.model"))
        sigma_dph = draw.uniform(3, 8)
        record(own, int(tau_s * draw.uniform(3, 8)), lambda t: cold + rise * (1 - math.exp(-t / tau_s)), drift,
               sigma_dph, draw)
        record(unseen, 14400, lambda t: cold + rise * (1 - abs(t / 7200 - 1)), drift, sigma_dph, draw)
        proposed = re.search(r"next: fogcomp fit .* --effects (\S+)", run(tool, "info", own)).group(1)
        errors = []
        for effects in (proposed, USUAL, CUBIC):
            run(tool, "fit", own, "-o", model, "--effects", effects)
            errors.append(rms_error(tool, model, unseen, drift, folder))
        temperatures = [cold + rise * (1 - abs(t / 7200 - 1)) for t in range(14400)]
        return errors + [statistics.pstdev(map(drift, temperatures))]


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("fogcomp")
    parser.add_argument("--gyros", type=int, default=24)
    parser.add_argument("--first", type=int, default=1)
    given = parser.parse_args()
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        numbers = range(given.first, given.first + given.gyros)
        results = list(pool.map(lambda n: gyro(given.fogcomp, n), numbers))
    print("| model | median error, deg/h | worst | worse than a cubic by half | worse than no model |")
    print("|---|---|---|---|---|")
    for i, name in enumerate(("what `info` proposes", f"`{USUAL}`", f"`{CUBIC}`", "none")):
        errors = [r[i] for r in results]
        worse = [sum(r[i] > limit(r) for r in results) for limit in (lambda r: 1.5 * r[2], lambda r: r[3])]
        print(f"| {name} | {statistics.median(errors):.2f} | {max(errors):.2f} | {worse[0]} | {worse[1]} |")


if __name__ == "__main__":
    main()
