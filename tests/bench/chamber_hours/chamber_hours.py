#!/usr/bin/env python3
"""chamber_hours.py FOGCOMP [--gyros N] [--first N] [--use BOX] [--lots N]: what chamber hours are worth. Simulated
gyros, each of another coil, housing, noise and size of its effects, are recorded in the reference paper's programme
and in planned ones. One model is fitted to each recording. Its error is that of its drift on programmes that it has not
seen, which are simulated without noise. With --lots: what sisters of one lot teach a run of 3 h. Prints tables of
Markdown."""
import argparse, concurrent.futures, json, math, os, random, statistics, subprocess, tempfile

EFFECTS = "bias,bias_temperature,temperature_rate,temperature_rate_product,shupe,warm_up"
HOURS = (6, 8)
SHORT = 3  # hours, with what sisters teach
SISTERS = 15
SPREAD = 0.2  # of a size from gyro to gyro of a lot, relative
DEPARTURE = 5  # spreads, of the one size in which an outlier is unlike its lot
UNSEEN = {
    "steps": "start 20 degC\nrandom_steps -35 degC to 55 degC at 1 degC/min every 70 min for 12 h\n",
    "reversed": None,  # ready-made: soaks and ramps of 0.5 degC/min, as the paper's
}


def log_uniform(draw, low, high):
    return low * (high / low) ** draw.random()


def sizes_of(seed):
    """{effect: {parameter: size}} of a gyro: as EFFECTS.md has them, coil and housing within a factor."""
    draw = random.Random(seed)
    sign = lambda: draw.choice((-1, 1))
    rate = sign() * log_uniform(draw, 0.05, 0.3)
    sizes = {
        "bias": {"value_dph": sign() * log_uniform(draw, 0.01, 1)},
        "bias_temperature": {"slope": sign() * log_uniform(draw, 1e-4, 1e-3),
                             "curvature": sign() * log_uniform(draw, 1e-6, 5e-5)},
        "temperature_rate": {"coefficient": rate},
        "temperature_rate_product": {"coefficient": sign() * rate * log_uniform(draw, 1e-3, 1e-2)},
        "shupe": {"asymmetry_m": sign() * log_uniform(draw, 0.05, 0.5)},
        "warm_up": {"amplitude_dph": sign() * log_uniform(draw, 0.01, 0.1), "tau_s": log_uniform(draw, 300, 1800)},
        "coil": {"layers": draw.choice((24, 32, 40, 48)), "turns": draw.randint(50, 90)},
        "housing": {"housing_j_per_k": log_uniform(draw, 300, 1200), "to_air_w_per_k": log_uniform(draw, 0.4, 1)},
    }
    noise = f"white={log_uniform(draw, 5e-4, 3e-3):.4g},flicker={log_uniform(draw, 1e-3, 4e-3):.4g}"
    return sizes, noise


def options_of(sizes):
    """Options of `simulate`."""
    options = ["--preset", "none"]
    for name, values in sizes.items():
        options += ["--effect", name + ":" + ",".join(f"{k}={v:.4g}" for k, v in values.items())]
    return options


# Sizes that have a coefficient of their own in the model.
DEPARTING = [("bias_temperature", "slope"), ("bias_temperature", "curvature"), ("temperature_rate", "coefficient"),
             ("temperature_rate_product", "coefficient"), ("shupe", "asymmetry_m"), ("warm_up", "amplitude_dph")]


def sister(lot, number, departs):
    """A gyro of a lot: the lot's noise and sizes, which spread; `departs`: the one that is off."""
    sizes, noise = sizes_of(1000 * lot)
    draw = random.Random(1000 * lot + 1 + number)
    for effect, values in sizes.items():
        spread = 0 if effect == "coil" else 0.1 if effect == "housing" else SPREAD
        for name in values:
            values[name] *= draw.gauss(1, spread)
    if departs:
        effect, name = departs
        sizes[effect][name] = sizes_of(1000 * lot)[0][effect][name] * (1 + draw.choice((-1, 1)) * DEPARTURE * SPREAD)
    return options_of(sizes), noise


def fogcomp(*words):
    found = subprocess.run([tool, *words], capture_output=True, text=True)
    if found.returncode > (words[0] == "batch"):  # 1: a gyro has no result, the others teach
        raise RuntimeError(f"fogcomp {' '.join(words)}: {found.stderr}")
    return found.stdout


def record(options, noise, profile, file, seed):
    fogcomp("simulate", "-o", file, "--profile", profile, *options, "--noise", noise, "--seed", str(seed))


def unseen_runs(options, stem, seed):
    runs = [f"{stem}{unseen}.csv" for unseen in unseen_profiles]
    for run, profile in zip(runs, unseen_profiles.values()):
        fogcomp("simulate", "-o", run, "--profile", profile, *options, "--seed", str(seed + 1000))
    return runs


def judged(model, runs):
    """{unseen: rms error, deg/h}"""
    found = json.loads(fogcomp("compare", model, *runs, "--json"))["runs"]
    return {u: r["residual_rms_dph"] for u, r in zip(unseen_profiles, found)}


def errors_of(seed):
    """{programme: {unseen: rms error}} of one gyro."""
    sizes, noise = sizes_of(seed)
    stem = os.path.join(scratch, f"{seed}_")
    runs = unseen_runs(options_of(sizes), stem, seed)
    errors = {}
    for programme, profile in programmes.items():
        record(options_of(sizes), noise, profile, stem + "run.csv", seed)
        fogcomp("fit", stem + "run.csv", "-o", stem + "gyro.model", "--effects", EFFECTS)
        errors[programme] = judged(stem + "gyro.model", runs)
    return errors


def lot_file(lot):
    """What the sisters of a lot teach, recorded in the paper's programme; one in ten departs."""
    folder = os.path.join(scratch, f"lot{lot}")
    for number in range(SISTERS):
        options, noise = sister(lot, number, DEPARTING[(lot + number) % len(DEPARTING)] if number % 10 == 9 else None)
        os.makedirs(os.path.join(folder, f"S{number}"))
        record(options, noise, "paper", os.path.join(folder, f"S{number}", "run.csv"), number + 1)
    fogcomp("batch", folder, "-o", folder + "_out", "--effects", EFFECTS, "--jobs", str(asked.jobs), "--lot")
    return folder + "_out/gyros.lot"


def lot_errors_of(task):
    """{fit: {unseen: rms error}} of a gyro of the lot that is none of the sisters; in what it was found unlike them."""
    lot, taught, number, departs = task
    options, noise = sister(lot, number, departs)
    stem = os.path.join(scratch, f"{lot}_{number}_")
    runs = unseen_runs(options, stem, number)
    errors = {}
    for name, profile, known in (("paper", "paper", False), (f"planned {SHORT} h", short, False),
                                 (f"planned {SHORT} h, lot", short, True)):
        record(options, noise, profile, stem + "run.csv", number + 1)
        what = ["--lot", taught] if known else ["--effects", EFFECTS]
        said = json.loads(fogcomp("fit", stem + "run.csv", "-o", stem + "gyro.model", *what, "--json"))
        errors[name] = judged(stem + "gyro.model", runs)
    return errors, [u["name"] for u in said["prior"]["unknowns"] if u["moved"]]


def table(names, all_errors, foretold):
    heads = "".join(f" {u}: rms, deg/h | to the paper's | worst |" for u in UNSEEN)
    print("| programme | foretold, deg/h |" + heads + "\n|---|---|" + "---|---|---|" * len(UNSEEN))
    for name in names:
        cells = [name, f"{foretold[name]:.4f}" if name in foretold else "-"]
        for unseen in UNSEEN:
            own = [errors[name][unseen] for errors in all_errors]
            ratios = [errors[name][unseen] / errors["paper"][unseen] for errors in all_errors]
            cells += [f"{math.sqrt(statistics.fmean(e * e for e in own)):.4f}", f"{statistics.median(ratios):.2f}",
                      f"{max(ratios):.2f}"]
        print("| " + " | ".join(cells) + " |")


def plan(hours):
    profile = os.path.join(scratch, f"{hours}.profile")
    fogcomp("plan", "--effects", EFFECTS, "--use", asked.use, "--hours", str(hours), "-o", profile)
    return profile


def programmes_table():
    programmes.update({"paper": "paper"}, **{f"planned {hours} h": plan(hours) for hours in HOURS})
    compared = fogcomp("plan", "--compare", *programmes.values(), "--effects", EFFECTS, "--use", asked.use, "--json")
    foretold = {p: one["sigma_dph"] for p, one in zip(programmes, json.loads(compared)["programmes"])}
    all_errors = list(pool.map(errors_of, range(asked.first, asked.first + asked.gyros)))
    print(f"{asked.gyros} gyros from seed {asked.first}, box of use {asked.use}\n")
    table(programmes, all_errors, foretold)


def lots_table():
    """Each second gyro departs, in each size in turn: more than of a lot, to count what becomes of them."""
    tasks = []
    for lot in range(asked.first, asked.first + asked.lots):
        taught = lot_file(lot)
        for number in range(asked.gyros):
            departs = DEPARTING[(lot + number // 2) % len(DEPARTING)] if number % 2 else None
            tasks.append((lot, taught, 100 + number, departs))
    found = list(zip(tasks, pool.map(lot_errors_of, tasks)))
    names = list(found[0][1][0])
    for title, departing in (("like their lot", False), (f"one size {DEPARTURE} spreads off", True)):
        own = [result for task, result in found if bool(task[3]) == departing]
        print(f"\n{len(own)} gyros of {asked.lots} lots from seed {asked.first}, {title}; {SISTERS} sisters\n")
        table(names, [errors for errors, _ in own], {})
        for unseen in UNSEEN:
            ratios = [errors[names[2]][unseen] / errors[names[1]][unseen] for errors, _ in own]
            print(f"\n{unseen}: error with the lot to that without: median {statistics.median(ratios):.2f}, worst "
                  f"{max(ratios):.2f}; made worse: {sum(ratio > 1 for ratio in ratios)} of {len(ratios)}", end="")
        print(f"\nsaid to be unlike the lot: {sum(1 for _, unlike in own if unlike)} of {len(own)}")
    if asked.each:
        for (lot, _, number, departs), (errors, unlike) in found:
            print(lot, number, ".".join(departs) if departs else "like", "said:", ",".join(unlike) or "like", *(
                f"{unseen} " + " ".join(f"{errors[name][unseen]:.4f}" for name in names) for unseen in UNSEEN))


parser = argparse.ArgumentParser(description=__doc__)
parser.add_argument("fogcomp")
parser.add_argument("--gyros", type=int, default=30)
parser.add_argument("--first", type=int, default=1)
parser.add_argument("--use", default="T:-40..60,ramp:1")
parser.add_argument("--lots", type=int, default=0, help="so many lots, from seed --first; --gyros: of each")
parser.add_argument("--each", action="store_true", help="a line for each gyro of a lot, too")
parser.add_argument("--jobs", type=int, default=2)
asked = parser.parse_args()
tool = os.path.realpath(asked.fogcomp)
short, programmes = None, {}
with tempfile.TemporaryDirectory() as scratch, concurrent.futures.ThreadPoolExecutor(asked.jobs) as pool:
    unseen_profiles = {}
    for unseen, text in UNSEEN.items():
        unseen_profiles[unseen] = unseen
        if text:
            unseen_profiles[unseen] = os.path.join(scratch, unseen + ".profile")
            with open(unseen_profiles[unseen], "w") as file:
                file.write(text)
    if asked.lots:
        short = plan(SHORT)
        lots_table()
    else:
        programmes_table()
