#!/usr/bin/env python3
"""chamber_hours.py FOGCOMP [--gyros N] [--first N] [--use BOX]: what chamber hours are worth. Simulated gyros, each of
another coil, housing, noise and size of its effects, are recorded in the reference paper's programme and in planned
ones. One model is fitted to each recording. Its error is that of its drift on programmes that it has not seen, which
are simulated without noise. Prints a table of Markdown."""
import argparse, concurrent.futures, json, math, os, random, statistics, subprocess, tempfile

EFFECTS = "bias,bias_temperature,temperature_rate,temperature_rate_product,shupe,warm_up"
HOURS = (6, 8)
UNSEEN = {
    "steps": "start 20 degC\nrandom_steps -35 degC to 55 degC at 1 degC/min every 70 min for 12 h\n",
    "reversed": None,  # ready-made: soaks and ramps of 0.5 degC/min, as the paper's
}


def log_uniform(draw, low, high):
    return low * (high / low) ** draw.random()


def gyro(seed):
    """Options of `simulate`: sizes as the catalogue has them (EFFECTS.md), coil and housing within a factor."""
    draw = random.Random(seed)
    sign = lambda: draw.choice((-1, 1))
    rate = sign() * log_uniform(draw, 0.05, 0.3)
    effects = {
        "bias": f"value_dph={sign() * log_uniform(draw, 0.01, 1):.4g}",
        "bias_temperature": f"slope={sign() * log_uniform(draw, 1e-4, 1e-3):.4g},"
                            f"curvature={sign() * log_uniform(draw, 1e-6, 5e-5):.4g}",
        "temperature_rate": f"coefficient={rate:.4g}",
        "temperature_rate_product": f"coefficient={sign() * rate * log_uniform(draw, 1e-3, 1e-2):.4g}",
        "shupe": f"asymmetry_m={sign() * log_uniform(draw, 0.05, 0.5):.4g}",
        "warm_up": f"amplitude_dph={sign() * log_uniform(draw, 0.01, 0.1):.4g},"
                   f"tau_s={log_uniform(draw, 300, 1800):.4g}",
        "coil": f"layers={draw.choice((24, 32, 40, 48))},turns={draw.randint(50, 90)}",
        "housing": f"housing_j_per_k={log_uniform(draw, 300, 1200):.4g},"
                   f"to_air_w_per_k={log_uniform(draw, 0.4, 1):.4g}",
    }
    noise = f"white={log_uniform(draw, 5e-4, 3e-3):.4g},flicker={log_uniform(draw, 1e-3, 4e-3):.4g}"
    options = ["--preset", "none"]
    for name, values in effects.items():
        options += ["--effect", f"{name}:{values}"]
    return options, noise


def fogcomp(*words):
    found = subprocess.run([tool, *words], capture_output=True, text=True)
    if found.returncode:
        raise RuntimeError(f"fogcomp {' '.join(words)}: {found.stderr}")
    return found.stdout


def errors_of(seed):
    """{programme: {unseen: rms error, deg/h}} of one gyro."""
    options, noise = gyro(seed)
    name = lambda what: os.path.join(scratch, f"{seed}_{what}")
    runs = {}
    for unseen, profile in unseen_profiles.items():
        runs[unseen] = name(unseen + ".csv")
        fogcomp("simulate", "-o", runs[unseen], "--profile", profile, *options, "--seed", str(seed + 1000))
    errors = {}
    for programme, profile in programmes.items():
        run, model = name("run.csv"), name("gyro.model")
        fogcomp("simulate", "-o", run, "--profile", profile, *options, "--noise", noise, "--seed", str(seed))
        fogcomp("fit", run, "-o", model, "--effects", EFFECTS)
        judged = json.loads(fogcomp("compare", model, *runs.values(), "--json"))["runs"]
        errors[programme] = {u: r["residual_rms_dph"] for u, r in zip(runs, judged)}
    return errors


parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("fogcomp")
parser.add_argument("--gyros", type=int, default=30)
parser.add_argument("--first", type=int, default=1)
parser.add_argument("--use", default="T:-40..60,ramp:1")
parser.add_argument("--jobs", type=int, default=2)
asked = parser.parse_args()
tool = os.path.realpath(asked.fogcomp)
with tempfile.TemporaryDirectory() as scratch:
    programmes, expected = {"paper": "paper"}, {}
    for hours in HOURS:
        profile = os.path.join(scratch, f"{hours}.profile")
        fogcomp("plan", "--effects", EFFECTS, "--use", asked.use, "--hours", str(hours), "-o", profile)
        programmes[f"planned {hours} h"] = profile
    compared = fogcomp("plan", "--compare", *programmes.values(), "--effects", EFFECTS, "--use", asked.use, "--json")
    for programme, one in zip(programmes, json.loads(compared)["programmes"]):
        expected[programme] = one["sigma_dph"]
    unseen_profiles = {}
    for unseen, text in UNSEEN.items():
        unseen_profiles[unseen] = unseen
        if text:
            unseen_profiles[unseen] = os.path.join(scratch, unseen + ".profile")
            with open(unseen_profiles[unseen], "w") as file:
                file.write(text)
    seeds = range(asked.first, asked.first + asked.gyros)
    with concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
        all_errors = list(pool.map(errors_of, seeds))

print(f"{asked.gyros} gyros from seed {asked.first}, box of use {asked.use}\n")
print("| programme | foretold, deg/h | " + " | ".join(f"{u}: rms, deg/h | to the paper's | worst" for u in UNSEEN) + " |")
print("|---|---|" + "---|---|---|" * len(UNSEEN))
for programme in programmes:
    cells = [programme, f"{expected[programme]:.4f}"]
    for unseen in UNSEEN:
        own = [errors[programme][unseen] for errors in all_errors]
        ratios = [errors[programme][unseen] / errors["paper"][unseen] for errors in all_errors]
        cells += [f"{math.sqrt(statistics.fmean(e * e for e in own)):.4f}", f"{statistics.median(ratios):.2f}",
                  f"{max(ratios):.2f}"]
    print("| " + " | ".join(cells) + " |")
