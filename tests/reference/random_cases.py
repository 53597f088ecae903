"""Model tables, and sensor streams full of faults, at random: what two implementations are compared on.

random_cases.py FOLDER FIRST LAST    NNN_table.bin (a slot) and NNN_stream.bin of each seed
random_cases.py --damage STREAM OUT  a recording's stream with faults in it
random_cases.py --cost FOLDER SEED   NNN_fits.bin and NNN_dear.bin: the table of a seed with the shortest sample period
                                     that its cost allows, and with 1 us less; neither where its frames take longer
"""

import os
import random
import struct
import sys

import cost
import pipeline
import table
from arithmetic import crc16, crc32

BIG = 2**31 - 1


def i32(x):
    return (x + 2**31) % 2**32 - 2**31


def pack(words):
    return struct.pack(f"<{len(words)}i", *words)


def sym8():
    """The filters of the golden vectors' table."""
    with open(os.path.join(os.path.dirname(__file__), "..", "golden", "spec_stream.txt")) as file:
        words = next(line for line in file if line.startswith("table "))
    return table.read([int(word) for word in words.split()[1:]]).denoiser


def filters(r):
    """levels, (low, sl)"""
    levels = r.choice([0, 1, 1, 2, 3, 4])
    kind = r.choice(["haar", "db2", "sym8"]) if levels else "none"
    if kind == "none":
        return 0, [], []
    if kind == "haar":
        return levels, [2**30] * 2, [2**14] * 2
    if kind == "db2":
        low = [-138948171, 240665291, 898272000, 0]
        low[2], low[3] = 2**30 - low[0], 2**30 - low[1]
        sl = [7913, 13706, 0, 0]
        sl[2], sl[3] = 2**14 - sl[0], 2**14 - sl[1]
        return levels, low, sl
    given = sym8()
    return min(levels, 3), list(given.low), list(given.sl)


def denoiser_words(r):
    levels, low, sl = filters(r)
    k = len(low)
    sh = [(-1)**(i + 1) * sl[k - 1 - i] for i in range(k)]
    words = [levels, k, r.randrange(3), r.randrange(2)] + low
    words += [i32((b << 16) | (a & 0xFFFF)) for a, b in zip(sl, sh)]
    scale = r.choice([0, 300, 20000, 200000, 3000000, 40000000])
    return words + [min(int(scale * 0.7**j * r.uniform(0.5, 1.5)), 2**27) for j in range(levels)]


def temperature(r, lo=-10, hi=45):
    return int(r.uniform(lo, hi) * 65536)


LIMITS = (-4587520, 8519680, 131072, -26214400, 26214400, 3276800, 0, 131072000, 655360, 0, 786432, 65536,
          0, 2621440, 524288)


def effect_words(r):
    def small():
        return r.choice([r.randrange(-30000, 30000), r.randrange(-300000, 300000)])
    constants = {
        0: (), 1: (r.randrange(1, 10),), 2: (), 3: (r.randrange(1, 2**28),), 4: (r.randrange(1, 2**28),), 5: (),
        6: (r.randrange(1, 2**28), r.randrange(1, 2**26)),
        7: (r.randrange(1, BIG), r.choice([0, r.randrange(1, BIG)]), r.choice([0, r.randrange(-2**31, BIG)])),
        8: (r.randrange(1, 2**25), r.randrange(1, 2**30), r.choice([0, r.randrange(1, 2**23)]),
            r.randrange(-2**30, 2**30)),
        9: (temperature(r) << 6, r.randrange(1, 2**29), r.choice([0, r.randrange(1, 2**28), BIG])),
        11: (r.choice([r.randrange(1, 2**22), BIG]),),
        12: (r.choice([1, r.randrange(1, 2**20), BIG]), r.choice([0, r.randrange(2**27), BIG]),
             r.choice([1, 1 << 16, r.randrange(1, 2**31), BIG])), 13: (), 14: (), 15: (),
        17: (),
        10: (r.randrange(1, 4), temperature(r), r.choice([0, r.randrange(-2**28, 2**28), r.randrange(-BIG, BIG)])),
        18: (r.randrange(2, 6), r.choice([1, 368640000, BIG, 5000])),
        19: None,
    }
    dead = r.choice([1, 36864, 10**7])
    constants[19] = (dead, min(2**32 // dead, BIG, 3 * 2**41 // dead))
    chosen = r.sample(sorted(constants), r.choice([0, 2, 5, 9, len(constants)]))
    words = [r.choice([10, 16, 20, 20, 24]), len(chosen)]
    for number in chosen:
        c = constants[number]
        kind = table.FOR_A_BLOCK.get(number) or table.FOLLOWING[number]
        count = kind.counts(c)
        scale = r.choice([200, 10000]) if number in table.FOLLOWING else 1
        coefficients = [max(-BIG, min(BIG, small() * scale)) for _ in range(count)]
        words += [number, len(c), *c, count, *coefficients]
    return words


def expression_words(r):
    if r.random() < 0.3:
        return [0, 0]
    programs = [
        # play of the rate / second temperature, division with both signs and with zero
        [3 << 8, -10**7, 10**7, 1, 1000, 9 + (10 << 8), 19, r.choice([0, 5, 2**20]), 20 + (r.randrange(-3, 4) << 8)],
        [0 << 8, -655360, 3276800, 1 << 8, -10**6, 10**6, 9 + (r.randrange(0, 31) << 8), 20],
        [1 << 8, -10**6, 10**6, 0 << 8, -2**31, BIG, 9 + (8 << 8), 11, 20],
        [1 << 8, -10**8, 10**8, 2, 7, 20 + (2 << 8)],
        [2 << 8, 0, 1000, 1, 0, 9 + (3 << 8), 20 + (3 << 8)],
        [0 << 8, -2**31, BIG, 2, 14 + (16 << 8), 3, 15 + (18 << 8), 12, 4, 20],
        [1 << 8, -2**31, BIG, 18, r.randrange(1, 2**29), 17, 20 + (2 << 8)],
        [r.choice([4, 5, 8]) << 8, -2**31, BIG, 19, r.choice([1, 2**19, 2**30 - 1]), 16, 20 + (2 << 8)],
        [3 << 8, -2**31, BIG, 1, -2**31, 7, 10, 5 + (r.choice([-31, -3, 0, 5, 62]) & 0xFFFFFF) * 256, 20],
        [1, -2**31, 10, 1, -2**31, 11, 13, 20 + (5 << 8)],
        [1, 2**30, 0 << 8, 0, 0, 6, 19, 2**30 - 1, 20],
    ]
    chosen = r.sample(programs, r.randrange(1, 6))
    words = [i32(word) for program in chosen for word in program]
    coefficients = [r.randrange(-60000, 60000) for _ in chosen]
    return [len(coefficients), *coefficients, len(words), *words]


def network_words(r):
    count = r.choice([0, 1, 3, 4])
    if count == 0:
        return [0, 0]
    words = [count, 3]
    for _ in range(count):
        signal = r.choice([0, 1, 2, 3, 4, 5, 9])
        shift = r.randrange(0, 12)
        words += [signal, r.randrange(1, 2**28) if signal == 2 else 0, r.randrange(-10**6, 10**6),
                  r.randrange(1, BIG >> shift), shift]
    words += [r.randrange(0, 5), r.randrange(0, 5)]
    for _ in range(3):
        words += [r.randrange(-2**28, 2**28), *[r.randrange(-2**29, 2**29) if i < count else 0 for i in range(4)],
                  r.randrange(-2**29, 2**29)]
    return words + [r.randrange(-2**28, 2**28), r.randrange(2), r.randrange(-10**6, 10**6), r.randrange(-10**6, 10**6)]


def table_words(r, period):
    def blocks():
        return r.choice([0, 1, 2, 3, 6, 12, 60])
    head = [0x464F474D, table.TABLE_LAYOUT, 0, 123, 0x31, 0, 0, 0, 0, 0, 0]
    calibration = [period, r.randrange(1, 1001), r.choice([1, 2, 3, 5, 8, 20]), 2**30, r.choice([29, 30, 30]),
                   r.choice([40000000, 2 * 10**9, BIG]),
                   r.choice([500, 20000, 1000000, 10**8, BIG]), r.choice([0, 4, 6]), r.choice([0, 1, 9, 200, BIG])]
    thermal = [r.randrange(1, 2**28), r.randrange(1, 2**26), temperature(r, -15, 10), temperature(r, 12, 45),
               blocks(), blocks(), blocks()]
    if r.random() < 0.15:
        limits = [-2**31, BIG, r.choice([0, -1, BIG])] * 5
    else:
        limits = list(LIMITS)
    effects, expressions, network = effect_words(r), expression_words(r), network_words(r)
    needs = needed(r, effects, expressions, network)
    inputs = [len(needs)] + [word for number in needs for word in limits[3 * number:3 * number + 3]]
    output = [r.choice([0, 1, 2, 2, 2, 4, 6, 6, 16, 18, 20, 22]), 0x00432487 | (r.getrandbits(32) & 0x000CD378), *lines(r)]
    words = head + calibration + thermal + inputs + effects + expressions + network + denoiser_words(r) + output
    words[2] = len(words) + 1
    return words + [i32(crc32(pack(words)))], needs


def lines(r):
    """Sensor and output; the latter always fast enough."""
    return [r.choice([921600, 2000000, 9600]) | r.randrange(6) << 24, r.choice([921600, 4147200]) | r.randrange(6) << 24]


def needed(r, effects, expressions, network):
    """As a board finds them: with a table that has words for none."""
    words = [0x464F474D, table.TABLE_LAYOUT, 0, 0] + [0] * 7 + [5000, 1, 1, 2**30, 30, 1, 1, 0, 0, 1, 1, 0, 0, 0, 0, 0, 0]
    words += effects + expressions + network + [0, 0, 0, 0, 0, 0x00432487, 921600, 921600]
    words[2] = len(words) + 1
    words.append(i32(crc32(pack(words))))
    return pipeline.Pipeline(table.read(words)).course.block.needs


def slot(words):
    body = pack([0x53474F46, 1, 1, len(words)] + words)
    return body + struct.pack(">I", crc32(body) ^ 0x46AF6449)


class World:
    """What the sensors of a stream do."""
    START = {0: 21.0, 1: 5.0, 2: 90.0, 3: 5.0, 4: 0.4}

    def __init__(self, r, needs):
        self.r = r
        self.needs = needs
        self.number = r.randrange(65536)
        self.rate = 0.0
        self.noise = r.choice([0, 3, 200, 30000])
        self.swing = r.choice([0, 1000, 500000, 2 * 10**8])
        self.celsius = r.uniform(0, 30)
        self.drifting = r.choice([0.0, 0.002, 0.05])
        self.live = r.choice([0, 20, 900])
        self.inputs = dict(self.START)
        self.counts = 0
        self.fault = None
        self.left = 0

    FAULTS = ("gyro", "temperature", "stuck", "range", "jump", "spike", "frozen", "warm", "85", "inputs", "bad_input",
              "gap", "big_gap", "late", "renumber", "repeat", "cut", "damage", "cold", "hot", "both", "bad_sample",
              "85_on", "burst", "sign",
              "reserved", "reserved", "reserved")  # the last: frames that are none though their CRC is right

    def next(self):
        r = self.r
        if self.left == 0:
            self.fault = r.choice(self.FAULTS) if r.random() < 0.03 else None
            self.left = r.choice([1, 1, 2, 5, 20, 60]) if self.fault else r.choice([1, 5])
            if self.fault == "frozen":
                self.left = r.choice([20, 400, 700])
        self.left -= 1
        f = self.fault
        self.number = (self.number + 1) % 65536
        if f == "gap":
            self.number = (self.number + r.choice([1, 2, 5, 9])) % 65536
        if f == "big_gap" and self.left == 0:
            self.number = (self.number + r.choice([40, 200, 3000, 32700])) % 65536
        if f == "renumber" and self.left == 0:
            self.number = r.randrange(65536)
        return self._records(f) + self._sample(f)

    def _records(self, f):
        r, out = self.r, b""
        for number in self.needs + ([r.randrange(5)] if r.random() < 0.05 else []):
            if r.random() < 0.4 or f == "inputs":
                continue
            self.inputs[number] += r.gauss(0, 0.001 * self.START[number])
            value = int(self.inputs[number] * 65536)
            if f == "bad_input":
                value = r.choice([BIG, -2**31, 0, int(value * 1.6), 85 << 16])
            if f == "85_on":
                value = 85 << 16
            for _ in range(r.choice([1, 1, 1, 2])):
                which, reserved = (number, 0) if f != "reserved" else r.choice([(number, 1), (number | 8, 0), (5, 0)])
                body = bytes([0xC3, which, reserved]) + struct.pack("<i", value)
                out += b"\xA5" + body + struct.pack("<H", crc16(body))
        return out

    def _sample(self, f):
        r = self.r
        self.rate += r.gauss(0, self.swing / 30)
        self.rate *= 0.99
        if f != "frozen":
            self.celsius += r.gauss(self.drifting, 0.002 * bool(self.live))
        if not -9 < self.celsius < 60:
            self.drifting = -self.drifting
        if f != "stuck":
            self.counts = int(self.rate + r.gauss(0, self.noise))
        counts = self.counts
        if f == "sign":
            counts = -counts
        if f == "range":
            counts = r.choice([BIG, -2**31, 39500000, 38000000])
        if f == "jump" and self.left == 0:
            self.rate += r.choice([3e6, -3e7, 1.5e6])
        if f == "spike":
            counts += r.choice([0, 0, 400, -3000, 50000, 900000])
        if f == "burst":
            counts += (self.left % 2) * r.choice([5000, 100000, 1500000])
        heat = int(self.celsius * 65536) + r.randrange(-self.live - 1, self.live + 1)
        if f == "frozen":
            heat = int(self.celsius * 65536)
        if f == "warm" and self.left == 0:
            self.celsius += r.choice([2.2, 2.6, 2.4, -2.5, 3, -6, 15])
        if f == "cold":
            self.celsius -= 0.7
        if f == "hot":
            self.celsius += 0.7
        if f in ("85", "85_on"):
            heat = 85 << 16
        status = (0 if f in ("gyro", "both") else 1) | (0 if f in ("temperature", "both") else 2)
        if f == "85" and r.random() < 0.5:
            heat = r.choice([BIG, -2**31, 130 << 16, -71 << 16])
        number = self.number
        if f == "late":
            number = (number - r.randrange(2, 2000)) % 65536
        if f == "repeat":
            self.number = number = (number - 1) % 65536
        reserved = 0
        if f == "reserved":
            status, reserved = r.choice([(status, 1), (status, 128), (status | 4, 0), (status | 128, 0), (status, 0)])
        body = struct.pack("<HiiBB", number, max(-2**31, min(BIG, counts)), max(-2**31, min(BIG, heat)), status,
                           reserved)
        frame = b"\xA5\x5A" + body + struct.pack("<H", crc16(body))
        if f == "cut":
            return frame[:r.randrange(16)]
        if f == "damage":
            i = r.randrange(16)
            return frame[:i] + bytes([frame[i] ^ (1 << r.randrange(8))]) + frame[i + 1:]
        if f == "bad_sample":
            return b"\xA5" * r.randrange(3) + frame
        return frame


def case(seed):
    r = random.Random(seed)
    period = r.choice([5000, 100000, 200000, 200000, 700000])
    words, needs = table_words(r, period)
    world = World(r, needs)
    stream = b"".join(world.next() for _ in range(r.choice([300, 800, 1500, 1500, 4000])))
    return slot(words), stream


def damaged(stream):
    """With flags cleared, rates and temperatures that jump or stand, frames lost, late, twice or torn."""
    r = random.Random(1)
    frames = [stream[i:i + 16] for i in range(0, len(stream), 16)]
    out = []
    held = None
    i = 0
    while i < len(frames):
        fault = r.choice(World.FAULTS) if r.random() < 0.002 else None
        for _ in range(r.choice([1, 1, 3, 40, 250]) if fault else r.choice([1, 50])):
            if i == len(frames):
                break
            number, counts, heat, status = struct.unpack("<HiiB", frames[i][2:13])
            i += 1
            if fault in ("gap", "big_gap"):
                continue
            held = (counts, heat) if fault is None else held
            status = {"gyro": 2, "temperature": 1, "both": 0}.get(fault, status)
            if fault in ("stuck", "frozen"):
                counts, heat = (held[0], heat) if fault == "stuck" else (counts, held[1])
            if fault in ("85", "85_on"):
                heat = 85 << 16
            if fault in ("spike", "jump", "range"):
                counts += {"spike": 3000, "jump": 10**6, "range": BIG // 2}[fault]
            if fault in ("late", "renumber"):
                number = (number - 700) % 65536
            body = struct.pack("<HiiBB", number, max(-2**31, min(BIG, counts)), heat, status, 0)
            frame = b"\xA5\x5A" + body + struct.pack("<H", crc16(body))
            out += [frame[:r.randrange(16)] if fault == "cut" else frame] * (2 if fault == "repeat" else 1)
            if fault == "damage":
                out[-1] = out[-1][:7] + bytes([out[-1][7] ^ 4]) + out[-1][8:]
    return b"".join(out)


def at_period(words, period):
    changed = [*words[:11], period, *words[12:-1]]
    return [*changed, i32(crc32(pack(changed)))]


def at_its_cost(seed):
    """(fits, dear), or None."""
    words, _ = table_words(random.Random(seed), BIG)
    shortest = -(-cost.sample_cost(table.read(words)) // cost.INSTRUCTIONS_PER_US)
    try:
        table.read(at_period(words, shortest - 1))
    except table.Refused as error:
        if error.reason != table.SAMPLE_TOO_DEAR:
            return None
    return slot(at_period(words, shortest)), slot(at_period(words, shortest - 1))


def write(path, data):
    with open(path, "wb") as file:
        file.write(data)


def main(arguments):
    if arguments[0] == "--damage":
        with open(arguments[1], "rb") as file:
            write(arguments[2], damaged(file.read()))
        return
    if arguments[0] == "--cost":
        for name, data in zip(("fits", "dear"), at_its_cost(int(arguments[2])) or ()):
            write(os.path.join(arguments[1], f"{int(arguments[2]):03}_{name}.bin"), data)
        return
    for seed in range(int(arguments[1]), int(arguments[2]) + 1):
        slot_bytes, stream = case(seed)
        write(os.path.join(arguments[0], f"{seed:03}_table.bin"), slot_bytes)
        write(os.path.join(arguments[0], f"{seed:03}_stream.bin"), stream)


if __name__ == "__main__":
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    main(sys.argv[1:])
