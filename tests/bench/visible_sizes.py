#!/usr/bin/env python3
"""visible_sizes.py FOGCOMP [--gyros N] [--first N]: how often an effect is found that is as large as `diagnose` says.
Clean gyros are simulated: bias, its temperature sensitivity, white and flicker noise. Each is diagnosed. Then each
effect that could have been seen is added to its rate, at a random shape, 0.5, 1 and 2 times the size that was stated.
Seen: P(nothing missing) is below 0.5. Named: the effect, or a set of rivals that has it. Prints a table of Markdown."""
import argparse, concurrent.futures, csv, json, math, os, random, subprocess, tempfile

PROFILES = ("paper", "random_steps", "ramp_rates", "reversed")
BASE = "bias,bias_temperature:order=2"
TIMES = (0.5, 1, 2)
HAVE = {"bias", "bias_temperature", "bias_step"}  # the gyro's own, and jumps, which have no size of their own


def run(*command):
    done = subprocess.run([str(c) for c in command], capture_output=True, text=True)
    if done.returncode > 1:
        raise RuntimeError(" ".join(map(str, command)) + ": " + done.stderr)
    return done.stdout


def shape_of(effect, draw):
    """EFFECT:PARAMETER=VALUE,... at a random place, on the scale of its bounds; optional parts stay away."""
    parts = []
    for one in effect["parameters"]:
        low, high = one["min"], one["max"]
        if one["default"] == 0 or one["name"] == "order":
            continue
        at = draw.random()
        value = low * (high / low) ** at if low > 0 and high / low > 20 else low + at * (high - low)
        parts.append(f"{one['name']}={value:.5g}")
    return effect["effect"] + (":" + ",".join(parts) if parts else "")


def table_of(path):
    """Names of the columns; rows of cells."""
    with open(path, newline="") as lines:
        head, *rows = csv.reader(lines)
    return head, rows


def diagnose(tool, folder, recording):
    model = os.path.join(folder, "base.model")
    run(tool, "fit", recording, "-o", model, "--effects", BASE)
    return json.loads(run(tool, "diagnose", model, recording, "--json"))


def found(diagnosis, name):
    return diagnosis["nothing_missing"] < 0.5, name in [diagnosis["effect"], *diagnosis["confusable"]]


def gyro(tool, number, catalogue):
    """[(effect, times, seen, named)] of one gyro."""
    draw = random.Random(number)
    noise = f"white={10 ** draw.uniform(-3.3, -2):.4g},flicker={10 ** draw.uniform(-3.3, -2.3):.4g}"
    results = []
    with tempfile.TemporaryDirectory() as folder:
        clean = os.path.join(folder, "clean.csv")
        run(tool, "simulate", "-o", clean, "--profile", PROFILES[number % len(PROFILES)], "--preset", "none",
            "--seed", number, "--noise", noise, "--effect", f"bias:value_dph={draw.uniform(-1, 1):.4g}",
            "--effect", f"bias_temperature:slope={draw.uniform(-1e-3, 1e-3):.4g}")
        head, rows = table_of(clean)
        at = head.index("rate_dph")
        for candidate in diagnose(tool, folder, clean)["candidates"]:
            name, size = candidate["effect"], candidate["visible_from_dph"]
            if name in HAVE or name not in catalogue:
                continue
            only, parts = os.path.join(folder, "only.model"), os.path.join(folder, "parts.csv")
            try:
                run(tool, "fit", clean, "-o", only, "--effects", "bias," + shape_of(catalogue[name], draw))
            except RuntimeError:  # of no size on this programme
                continue
            run(tool, "apply", only, clean, "-o", parts)
            names, values = table_of(parts)
            drift = [float(row[names.index(f"drift_{name}_dph")]) for row in values]
            mean = sum(drift) / len(drift)
            rms = math.sqrt(sum((d - mean) ** 2 for d in drift) / len(drift))
            if rms == 0:
                continue
            for times in TIMES:
                hidden = os.path.join(folder, "hidden.csv")
                with open(hidden, "w", newline="") as out:
                    writer = csv.writer(out, lineterminator="\n")
                    writer.writerow(head)
                    for cells, value in zip(rows, drift):
                        rate = float(cells[at]) + times * size * (value - mean) / rms
                        writer.writerow(cells[:at] + [f"{rate:.9g}"] + cells[at + 1:])
                results.append((name, times, *found(diagnose(tool, folder, hidden), name)))
    return results


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("fogcomp")
    parser.add_argument("--gyros", type=int, default=24)
    parser.add_argument("--first", type=int, default=1)
    given = parser.parse_args()
    catalogue = {e["effect"]: e for e in json.loads(run(given.fogcomp, "effects", "--json"))["effects"]}
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        numbers = range(given.first, given.first + given.gyros)
        results = [one for some in pool.map(lambda n: gyro(given.fogcomp, n, catalogue), numbers) for one in some]
    heads = [f"{what}{t}" for what in ("seen at ", "named at ") for t in TIMES]
    print("| effect | gyros | " + " | ".join(heads) + " |")
    print("|" + "---|" * (2 + len(heads)))
    for name in sorted({r[0] for r in results}) + ["all"]:
        own = [r for r in results if name in (r[0], "all")]
        at = {t: [r for r in own if r[1] == t] for t in TIMES}
        shares = [sum(r[what] for r in at[t]) / len(at[t]) for what in (2, 3) for t in TIMES]
        print(f"| {name} | {len(at[1])} | " + " | ".join(f"{s:.2f}" for s in shares) + " |")


if __name__ == "__main__":
    main()
