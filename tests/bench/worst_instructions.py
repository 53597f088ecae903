"""Searches the model table and the sensor stream with which a sample comes nearest to the bound of its cost.

worst_instructions.py SAMPLE_COST.elf FOLDER TAPS LEVELS [RUNS] [SEED]

A table has parts: rhythm, effects, expressions, network, denoiser, output; the stream is one more. Each is drawn from a
seed, over what the validator accepts; the denoiser's filters and levels are those of the image. At first all parts are
drawn together. Then one part at a time is drawn anew, and kept where the nearer of two shares became larger:

* of as many bytes as the buffer of the sensor line holds: what its samples took of their cost (SPEC.md)
* of the dearest 16 bytes, those of a sample: what they took of the cost of one that starts the model, which is that of
  three more steps and of keeping the state

QEMU's timer counts instructions. Both bounds allow 2 more for each us of the sample period, for the self-test. Prints
each step forward. First of tables whose model makes one step a sample, then of those that catch up with a hold in more.
FOLDER/table.bin and in.bin are the nearest. Exit code 1 where a bound is broken, or nothing was accepted.
"""

import os
import random
import re
import struct
import subprocess
import sys
from typing import NamedTuple

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "reference"))
import cost as costs  # noqa: E402
import random_cases as cases  # noqa: E402
import table as tables  # noqa: E402
from arithmetic import crc32  # noqa: E402

SAMPLES = 2100                         # all of ten levels come together twice
TABLE_AT = 0x0800C000
PERIOD_AT = 11                         # the word behind the header
BUFFER = 1024                          # bytes of the sensor line
SELF_TEST = 2                          # instructions per us of the sample period
PARTS = ("rhythm", "effects", "network", "denoiser", "output", "stream", "expressions", "expressions", "expressions",
         "expressions")                # drawn in turn; the dearest part most often
BIG = cases.BIG


def magnitude(r, bits=31):
    """Of any size, of either sign."""
    return r.choice([-1, 1]) * r.randrange(1 << r.randrange(1, bits))


def rhythm(r, catches_up):
    """Calibration, thermal. Blocks of few samples, so that all that is dear comes together within the stream. After a
    hold the model makes one step a sample if a block has more samples than a hold has blocks, else up to 64."""
    samples = r.choice([1, 1, 1, 2, 5])
    hold = r.choice([1, 5, 60, 63, BIG]) * samples if catches_up else r.randrange(samples)
    calibration = [r.choice([1000, 1000, 5000, 700000]), r.randrange(1, 1001), samples,
                   r.randrange(2**30, BIG), r.randrange(25, 35), r.randrange(1, BIG), r.randrange(1, BIG),
                   r.choice([0, 4, 200]), r.choice([0, 1, 200, BIG])]
    low = r.randrange(-70 << 16, 60 << 16)
    thermal = [r.randrange(1, 2**28), r.randrange(1, 2**26), low, r.randrange(low, 130 << 16),
               min(hold, BIG), *(r.choice([0, 1, 6, 60, BIG]) for _ in range(2))]
    return calibration + thermal


def expressions(r):
    """Segments of a chain of operations each, in up to all words that a program may have."""
    outputs = r.randrange(9)
    if outputs == 0:
        return [0, 0]
    whole = r.choice([40, 512, 512])
    states = 8

    def word(op, bits=0):
        return cases.i32(op | (bits & 0xFFFFFF) << 8)

    def unit(kind):
        if kind in (7, 6, 12, 13):
            return [*r.choice([[2], [1, magnitude(r)]]), word(kind)]
        if kind == 8:
            return [*r.choice([[2], [1, magnitude(r)]]), word(8, r.randrange(63))]
        if kind == 9:
            return [*r.choice([[2], [1, magnitude(r)]]), word(9, r.randrange(31))]
        if kind == 5:
            return [word(5, r.randrange(-31, 63))]
        if kind in (14, 15):
            return [word(kind, r.randrange(63))]
        if kind == 18:
            return [18, r.randrange(1, BIG)]
        if kind == 19:
            return [19, r.randrange(2**30)]
        return [kind]                  # negate, absolute, decay, tanh

    kinds = r.sample([5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19], r.choice([1, 1, 2, 3]))
    words = []
    for i in range(outputs):
        segment = [word(0, r.randrange(9)), -2**31, BIG] if r.random() < 0.7 else [1, magnitude(r)]
        chain = [unit(kind) for kind in kinds]
        while True:
            if r.random() < 0.3:
                chain = [unit(kind) for kind in kinds]
            free = whole // outputs - len(segment) - 1
            for one in chain:
                kind = one[0] & 0xFF
                if len(one) > free or (kind in (18, 19) and states == 0):
                    free = -1
                    break
                states -= kind in (18, 19)
                segment += one
                free -= len(one)
            if free <= 0:
                break
        words += [*segment, word(20, r.randrange(-31, 63))]
    return [outputs, *(magnitude(r) for _ in range(outputs)), len(words), *words]


def network(r):
    count = r.randrange(5)
    if count == 0:
        return [0, 0]
    hidden = r.choice([1, 10, 32, 32])
    words = [count, hidden]
    for _ in range(count):
        signal, shift = r.randrange(10), r.randrange(31)
        words += [signal, r.randrange(1, BIG) if signal == 2 else 0, magnitude(r),
                  r.randrange(1, max(2, BIG >> shift)), shift]
    words += [r.randrange(17), r.randrange(17)]
    for _ in range(hidden):
        words += [magnitude(r, 29), *[magnitude(r, 30) if i < count else 0 for i in range(4)], magnitude(r, 27)]
    return words + [magnitude(r, 29), r.randrange(2), magnitude(r), magnitude(r)]


def shares(r, count, whole):
    """So many integers that sum up to the whole."""
    cuts = sorted(r.randrange(whole + 1) for _ in range(count - 1))
    return [b - a for a, b in zip([0, *cuts], [*cuts, whole])]


def denoiser(r, taps, most):
    """Of an image for filters of so many taps."""
    levels = r.choice([*range(most + 1), most, most])
    if levels == 0:
        return [0, 0, r.randrange(3), r.randrange(2)]
    half = taps // 2
    low = [tap for pair in zip(shares(r, half, 2**30), shares(r, half, 2**30)) for tap in pair]
    sl = [tap for pair in zip(shares(r, half, 2**14), shares(r, half, 2**14)) for tap in pair]
    sh = [(-1)**(i + 1) * sl[-1 - i] for i in range(taps)]
    scale = r.choice([0, 300, 20000, 3000000, 40000000])
    return [levels, taps, r.randrange(3), r.randrange(2), *low,
            *(cases.i32((b << 16) | (a & 0xFFFF)) for a, b in zip(sl, sh)),
            *(min(int(scale * r.uniform(0.1, 1.5)), 2**27) for _ in range(levels))]


def output(r):
    return [r.choice([frames + options for frames in range(3) for options in range(0, 32, 4)]),
            0x00432487 | (r.getrandbits(32) & 0x000CD378), *cases.lines(r)]


def sealed(words):
    """With their number and CRC."""
    words = [*words[:2], len(words) + 1, *words[3:]]
    return [*words, cases.i32(crc32(cases.pack(words)))]


def at_period(words, period):
    return sealed([*words[:PERIOD_AT], period, *words[PERIOD_AT + 1:]])


def words_of(r, needs, parts):
    header = [0x464F474D, tables.TABLE_LAYOUT, 0, 123, 0x31, 0, 0, 0, 0, 0, 0]
    inputs = [len(needs)] + [word for number in needs for word in cases.LIMITS[3 * number:3 * number + 3]]
    return [*header, *r, *inputs, *parts]


def table_and_stream(seeds, shape, catches_up):
    """A slot, its table as read, a stream. The sample period is the one drawn, or as many ms as the cost takes."""
    r = {part: random.Random(seeds[part]) for part in PARTS}
    effects = cases.effect_words(r["effects"])
    programs, net = expressions(r["expressions"]), network(r["network"])
    needs = cases.needed(r["rhythm"], effects, programs, net)
    words = words_of(rhythm(r["rhythm"], catches_up), needs,
                     [*effects, *programs, *net, *denoiser(r["denoiser"], *shape), *output(r["output"])])
    cost = costs.sample_cost(tables.read(at_period(words, BIG)))           # or it is refused
    ms = -(-cost // (1000 * costs.INSTRUCTIONS_PER_US))
    words = at_period(words, max(words[PERIOD_AT], 1000 * ms))
    world = cases.World(r["stream"], needs)
    stream = [world.next() for _ in range(150 if catches_up else SAMPLES)]
    return cases.slot(words), tables.read(words), stream


def counted(image, folder, slot, stream):
    """Instructions of the dearest 16 bytes, and of the dearest that fill the buffer; None without a sample."""
    for name, data in (("tried.bin", slot), ("in.bin", stream)):
        cases.write(os.path.join(folder, name), data)
    said = subprocess.run(
        ["qemu-system-arm", "-M", "netduinoplus2", "-display", "none", "-monitor", "none", "-icount",
         "shift=0,sleep=off", "-semihosting-config", "enable=on,target=native", "-device",
         f"loader,addr={TABLE_AT},file=tried.bin,force-raw=on", "-serial", "null", "-serial", "null", "-serial",
         "stdio", "-kernel", os.path.abspath(image)], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True,
        timeout=600, check=False).stdout.decode()
    most = re.search(rf"any 16 bytes: count \d+ mean \d+ max (\d+)\s+any {BUFFER} bytes: count \d+ mean \d+ max (\d+)",
                     said)
    return most and (int(most[1]), int(most[2]))


def start_cost(table):
    """Of a sample that starts the model."""
    return costs.sample_cost(table) + 3 * costs.step_cost(table) + costs.keep_cost(table)


def of_sample(instructions_of_buffer, stream):
    return instructions_of_buffer / BUFFER * sum(map(len, stream)) / len(stream)


class Share(NamedTuple):
    """Of its bound, what a table took."""
    share: float
    what: str


def share(image, folder, slot, table, stream):
    """The larger of the two shares."""
    found = counted(image, folder, slot, b"".join(stream))
    if not found:
        return Share(0, "no sample")
    self_test = SELF_TEST * table.period
    sample, start = costs.sample_cost(table) + self_test, start_cost(table) + self_test
    of_buffer = of_sample(found[1], stream)
    return max(Share(found[0] / start, f"{found[0]} of {start} instructions by the dearest sample"),
               Share(of_buffer / sample, f"{of_buffer:.0f} of {sample} instructions by a sample in a full buffer"))


def tried(image, folder, seeds, shape, catches_up):
    try:
        return share(image, folder, *table_and_stream(seeds, shape, catches_up))
    except tables.Refused:
        return Share(0, "refused")


def search(image, folder, shape, catches_up, runs, seed, first=None):
    """The largest share, and the seeds that make it; from `first` on, if it is given."""
    r = random.Random(seed)
    worst, seeds = Share(0, "nothing was accepted"), first
    for run in range(runs):
        parts = PARTS if seeds is None or (first is None and run < runs // 8) else [PARTS[run % len(PARTS)]]
        drawn = {**(seeds or {}), **{part: r.getrandbits(32) for part in parts}}
        found = tried(image, folder, drawn, shape, catches_up)
        if found > worst:
            worst, seeds = found, drawn
            said = parts[0] if len(parts) == 1 else "all parts"
            print(f"  run {run}, {said} drawn: {found.share:.2f}: {found.what}", flush=True)
    slot, _, stream = table_and_stream(seeds, shape, catches_up)
    for name, data in (("table.bin", slot), ("in.bin", b"".join(stream))):
        cases.write(os.path.join(folder, name), data)
    return worst, seeds


def main(image, folder, taps, levels, runs=200, seed=1):
    os.makedirs(folder, exist_ok=True)
    shape = int(taps), int(levels)
    worst, seeds = search(image, folder, shape, False, int(runs), int(seed))
    print(f"one step a sample: {worst.share:.2f}: {worst.what}", flush=True)
    catching_up, _ = search(image, folder, shape, True, int(runs) // 16, int(seed), seeds)
    print(f"up to 64 steps a sample: {catching_up.share:.2f}: {catching_up.what}")
    return 0 if 0 < worst.share <= 1 and 0 < catching_up.share <= 1 else 1


if __name__ == "__main__":
    if not 5 <= len(sys.argv) <= 7:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
