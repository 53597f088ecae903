"""Counts what each part of a model table costs a sample, and compares it with its share of the bound (SPEC.md).

sample_bound.py SAMPLE_COST.elf FOLDER TAPS LEVELS

Each table is an empty one and a part more: an effect, a program of one operation, a network, a denoiser. Each sample
ends a block, so that everything comes together, and has a record of each input that the model needs. What a sample
takes more than with the empty table is no more than the part's share of the bound, and the whole no more than the
bound: a sample of the dearest that fill the buffer of the sensor line, and the dearest of all, which may start the
model. QEMU's timer counts instructions. Exit code 1 where one is more.
"""

import os
import random
import sys
from typing import NamedTuple

here = os.path.dirname(__file__)
sys.path[:0] = [os.path.join(here, "..", "bench"), os.path.join(here, "..", "reference")]
import cost as costs  # noqa: E402
import random_cases as cases  # noqa: E402
import table as tables  # noqa: E402
import worst_instructions as search  # noqa: E402

BIG = cases.BIG
PERIOD = 2000                          # us; a temperature is confirmed after 250 samples
SAMPLES = 400
DRAWS = 2
RHYTHM = [PERIOD, 50, 1, 2**30, 30, BIG, BIG, 0, 0, 2**27, 2**25, -70 << 16, 130 << 16, 0, 60, 6]
OUTPUT = [2 | 4, 0x00432487, 921600, 921600]
ANY_SIGNAL = [0, -2**31, BIG]
NONE = {"effects": [20, 0], "program": [0, 0], "network": [0, 0], "denoiser": [0, 0, 2, 0]}


def effect(number):
    def draw(r):
        while True:
            fraction, count, *words = cases.effect_words(r)
            for _ in range(count):
                constants = words[1]
                size = 3 + constants + words[2 + constants]
                if words[0] == number:
                    return {"effects": [fraction, 1, *words[:size]]}
                words = words[size:]
    return draw


def program(unit):
    """As many units as fit into 120 words."""
    def draw(r):
        words = [*ANY_SIGNAL]
        while len(words) < 120 - 3:
            words += unit(r)
        words.append(20)
        return {"program": [1, 1000, len(words), *words]}
    return draw


def states(operation, top):
    """All eight that there may be."""
    def draw(r):
        words = [*ANY_SIGNAL, *(word for _ in range(8) for word in (operation, r.randrange(1, top))), 20]
        return {"program": [1, 1000, len(words), *words]}
    return draw


def network(hidden):
    def draw(r):
        while True:
            words = search.network(r)
            if words[:2] == [4, hidden]:
                return {"network": words}
    return draw


def denoiser(taps, levels):
    def draw(r):
        while True:
            words = search.denoiser(r, taps, levels)
            if words[0] == levels and words[2] == 2 and 0 < words[-1] < 2**22:
                return {"denoiser": words}
    return draw


def word(operation, k):
    return cases.i32(operation | (k & 0xFFFFFF) << 8)


UNITS = {
    "signal": lambda r: [*ANY_SIGNAL, 4], "duplicate": lambda r: [2, 4], "over": lambda r: [2, 3, 4, 4],
    "shift": lambda r: [word(5, r.randrange(-31, 63))], "add": lambda r: [2, 6], "subtract": lambda r: [2, 7],
    "multiply": lambda r: [2, word(8, r.randrange(63))],
    "divide": lambda r: [1, search.magnitude(r), word(9, r.choice([30, r.randrange(31)]))],
    "divide by itself": lambda r: [2, word(9, 30)],
    "negate": lambda r: [10], "absolute": lambda r: [11], "min": lambda r: [2, 12], "max": lambda r: [2, 13],
    "sine": lambda r: [word(14, r.randrange(63))], "cosine": lambda r: [word(15, r.randrange(63))],
    "decay": lambda r: [16], "tanh": lambda r: [17],
}


def parts(taps, levels):
    result = {f"effect {number}": effect(number) for number in [*tables.FOR_A_BLOCK, *tables.FOLLOWING]}
    result.update({name: program(unit) for name, unit in UNITS.items()})
    result.update({"lag": states(18, BIG), "play": states(19, 2**30)})
    result.update({"8 outputs": lambda r: {"program": [8, *[1000] * 8, 32, *[*ANY_SIGNAL, 20] * 8]}})
    result.update({f"network 4-{hidden}": network(hidden) for hidden in (1, 10, 32)})
    result.update({f"denoiser {taps} x {count}": denoiser(taps, count) for count in (1, 2, 5, levels)})
    return result


class World(cases.World):
    """Without faults; each sample with all inputs, which are good."""
    FAULTS = (None,)

    def _records(self, fault):
        out = b""
        for number in self.needs:
            body = bytes([0xC3, number, 0]) + cases.struct.pack("<i", int(self.START[number] * 65536))
            out += b"\xA5" + body + cases.struct.pack("<H", cases.crc16(body))
        return out


class Counted(NamedTuple):
    """Instructions and their bounds: of a sample, of the dearest that fill the buffer; of the dearest sample, which may
    start the model."""
    sample: float
    sample_bound: int
    dearest: int
    dearest_bound: int

    def less(self, other):
        return Counted(*(a - b for a, b in zip(self, other)))

    @property
    def holds(self):
        return self.sample <= self.sample_bound and self.dearest <= self.dearest_bound

    def __str__(self):
        return (f"{self.sample:.0f} of {self.sample_bound}, the dearest sample {self.dearest} of {self.dearest_bound}"
                + ("" if self.holds else ": MORE"))


def counted(image, folder, part, seed):
    """None where the table is refused."""
    r = random.Random(seed)
    words = {**NONE, **part(r)}
    needs = cases.needed(r, words["effects"], words["program"], words["network"])
    try:
        sealed = search.sealed(search.words_of(RHYTHM, needs, [*sum(words.values(), []), *OUTPUT]))
        table = tables.read(sealed)
    except tables.Refused:
        return None
    world = World(random.Random(seed), needs)
    stream = [world.next() for _ in range(SAMPLES)]
    dearest, of_buffer = search.counted(image, folder, cases.slot(sealed), b"".join(stream))
    return Counted(search.of_sample(of_buffer, stream), costs.sample_cost(table), dearest, search.start_cost(table))


def most(image, folder, part):
    """Of some draws, the one nearest to its bound."""
    found = [counted(image, folder, part, seed) for seed in range(DRAWS)]
    return max((each for each in found if each), key=lambda each: each.sample / each.sample_bound)


def main(image, folder, taps, levels):
    os.makedirs(folder, exist_ok=True)
    empty = most(image, folder, lambda r: {})
    print(f"empty table: {empty}, beside {search.SELF_TEST * PERIOD} for the self-test")
    hold = empty.holds
    for name, part in parts(int(taps), int(levels)).items():
        found = most(image, folder, part)
        print(f"{name}: {found.less(empty)}", flush=True)
        hold = hold and found.holds and found.less(empty).holds
    return 0 if hold else 1


if __name__ == "__main__":
    if len(sys.argv) != 5:
        sys.exit(__doc__)
    sys.exit(main(*sys.argv[1:]))
