"""Denoiser (spec/denoiser.md): filter bank, thresholds, outlier gate.

Windows are kept the oldest first, so the taps are kept reversed where the text has the newest first.
"""

from collections import deque
from operator import mul
from typing import NamedTuple

from arithmetic import i32, round_shift, sat32

FIXED, SQTWOLOG, HEURSURE = range(3)       # rules
SOFT, HARD = range(2)                      # modes


class DenoiserTable(NamedTuple):
    levels: int
    rule: int
    mode: int
    low: tuple
    sl: tuple
    sh: tuple
    expected: tuple

    @property
    def taps(self):
        return len(self.low)

    @property
    def high(self):
        return tuple((-1)**i * self.low[-1 - i] for i in range(self.taps))

    @property
    def delay(self):
        return (self.taps - 1) * (2**self.levels - 1) if self.levels else 0


# Samples that come in

class Denoiser:
    def __init__(self, table):
        self.delay = table.delay
        self.bank = Bank(table) if table.levels else None
        self.filling_left = self.delay + 1
        self.follows = False
        self.last = 0                                          # the last sample that came in
        self.valid = deque([True] * self.delay, maxlen=self.delay + 1)
        self.primed = False

    @property
    def filling(self):
        return self.filling_left > 0

    def denoise(self, rate, valid):
        """(denoised rate, whether it is valid)"""
        if self.bank is None:
            return self._without_levels(rate, valid)
        if not self.primed:
            return self._first(rate, valid)
        if self.filling_left > 0:
            self.filling_left -= 1
        if not valid:
            rate = self.last
        self.last = rate
        denoised = self.bank.step(rate, self.follows)
        if self.bank.gate.outlier:
            self.valid[-1] = False
        self.valid.append(valid)
        self.follows = self.valid[0] and not self.filling
        return denoised, self.valid[0]

    def _first(self, rate, valid):
        if not valid:
            return 0, False
        self.bank.prime(rate)
        self.last = rate
        self.valid.append(True)
        self.primed = True
        self.filling_left -= 1
        return rate, True

    def _without_levels(self, rate, valid):
        if valid:
            self.last = rate
            self.filling_left = 0
        return self.last, valid


# Outlier gate

class OutlierGate:
    """The line of samples, as the gate leaves them; `line[-1]` is x[n]."""
    SPARE = 4096                           # samples that the line may be longer than needed

    def __init__(self, delay):
        self.needed = delay + 3
        self.line = []
        self.withheld = None
        self.before = 0
        self.outlier = False               # the sample before the last one

    def prime(self, rate):
        self.line = [rate] * self.needed

    def push(self, v, limit):
        line = self.line
        if len(line) > self.needed + self.SPARE:
            del line[:-self.needed]
        self.outlier = False
        if self.withheld is not None:
            self.outlier = self._is_outlier(self.withheld, v, line[-1], limit)
            if not self.outlier:
                line[-1] = self.withheld
            self.withheld = None
            line.append(v)
        elif limit == 0 or abs(v - line[-1]) <= limit:
            line.append(v)
        else:
            self.withheld = v
            self.before = line[-2]
            line.append(line[-1])

    def _is_outlier(self, w, v, last, limit):
        lo, hi = min(v, last), max(v, last)
        off = w - hi if w > hi else lo - w if w < lo else 0
        return off > limit + (hi - lo) + abs(last - self.before)


# Bank

class Merge:
    """Of one level: the newest pairs of coarse and removed, the newest first."""

    def __init__(self, table):
        self.even_low, self.odd_low = table.sl[0::2], table.sl[1::2]
        self.even_high, self.odd_high = table.sh[0::2], table.sh[1::2]
        self.coarse = [0] * (table.taps // 2)
        self.removed = [0] * (table.taps // 2)

    def step(self, coarse, removed):
        c, r = self.coarse, self.removed
        c.insert(0, coarse)
        c.pop()
        r.insert(0, removed)
        r.pop()
        even = (2**13 + sum(map(mul, c, self.even_low)) + sum(map(mul, r, self.even_high))) >> 14
        odd = (2**13 + sum(map(mul, c, self.odd_low)) + sum(map(mul, r, self.odd_high))) >> 14
        return even, odd


class Level:
    """What a level keeps: its inputs (not of level 0), its queue, its pairs, odd_l."""

    def __init__(self, table, number):
        self.merge = Merge(table)
        self.odd = 0
        self.waiting = 0
        self.inputs = deque([0] * table.taps, maxlen=table.taps)
        late = (table.taps - 1) * (2**(table.levels - 1 - number) - 1)
        self.queue = deque([0] * (late + 1), maxlen=late + 1)

    def delayed(self, removed):
        """What was put into the queue P_l puts before this one."""
        self.queue.append(removed)
        return self.queue[0]

    def up(self, coarse, removed):
        even, self.odd = self.merge.step(coarse, removed)
        return even


class Bank:
    def __init__(self, table):
        self.table = table
        self.delay = table.delay
        self.shift = noise_shift(table)
        self.low, self.high = table.low[::-1], table.high[::-1]
        self.thresholds = Thresholds(table, self.shift)
        self.gate = OutlierGate(self.delay)
        self.levels = [Level(table, number) for number in range(table.levels)]
        self.number = 0

    def prime(self, rate):
        self.gate.prime(rate)
        for level in self.levels:
            level.inputs.extend([rate] * self.table.taps)
        self.number = 1

    def step(self, v, follows):
        self.gate.push(v, self.thresholds.limit)
        m = self.number
        self.number = (m + 1) % 2**32
        if m % 2 == 1:
            self.thresholds.choose_one()
            noise = self.levels[0].odd
        else:
            noise = self._pair(m, follows)
        return sat32(self.gate.line[-1 - self.delay] - (((noise << self.shift) + 32) >> 6))

    def _pair(self, m, follows):
        taps, line = self.table.taps, self.gate.line
        oldest = len(line) - 1 - self.delay
        a, d = self._split(line[-taps:], line[oldest:oldest + taps])
        removed = [self._remove(d, 0, follows)]
        coarse = 0
        for number in range(1, self.table.levels):
            m //= 2
            level = self.levels[number]
            if m % 2 == 1:
                level.waiting = a
                coarse = level.odd
                break
            level.inputs.append(level.waiting)
            level.inputs.append(a)
            a, d = self._split(level.inputs, level.inputs)
            removed.append(level.delayed(self._remove(d, number, follows)))
        for level, r in zip(reversed(self.levels[:len(removed)]), reversed(removed)):
            coarse = level.up(coarse, r)
        return coarse

    def _split(self, newest, oldest):
        approximation = sat32((2**30 + sum(map(mul, self.low, newest))) >> 31)
        detail = sat32((2**24 + sum(map(mul, self.high, oldest))) >> 25)
        return approximation, detail

    def _remove(self, d, number, follows):
        t = self.thresholds.adapt(number, abs(d), follows)
        if abs(d) <= t:
            v = d
        elif self.table.mode == HARD:
            v = 0
        else:
            v = t if d > 0 else -t
        return round_shift(v, self.shift)


# Thresholds

class Thresholds:
    def __init__(self, table, shift):
        self.rule = table.rule
        self.expected = table.expected
        self.shift = shift
        self.gain = 65536
        self.limit = self.expected[0] >> 5                     # of the outlier gate
        self.histograms = [Histogram() for _ in self.expected]
        for number in range(table.levels):
            self.adapt(number, 0, False)

    def adapt(self, number, magnitude, follows):
        """now: the threshold of this detail."""
        if self.rule == FIXED:
            return self.expected[number]
        if number == 0 and follows:
            self._follow(magnitude)
        universal = self._universal(number)
        if number == 0:
            self.limit = universal >> 5
        if self.rule == SQTWOLOG:
            return universal
        histogram = self.histograms[number]
        now = (universal >> 4) * histogram.sixteenths
        histogram.take(magnitude >> self.shift, universal >> self.shift)
        return now

    def _universal(self, number):
        return (self.expected[number] * self.gain) >> 16

    def _follow(self, magnitude):
        step = self.gain >> 9
        median = (self._universal(0) * 887) >> 12
        if magnitude > median:
            self.gain = min(self.gain + step, 262144)
        elif self.gain > 512:
            self.gain -= step

    def choose_one(self):
        for histogram in self.histograms:
            if histogram.full:
                histogram.choose()
                return


class Histogram:
    def __init__(self):
        self.sixteenths = 16
        self._clear()

    def _clear(self):
        self.counts = [0] * 16
        self.energy = 0
        self.details = 0

    @property
    def full(self):
        return self.details >= 128

    def take(self, mag, u):
        if u == 0:
            return
        q = 256 if mag >= 4 * u else mag * 64 // u
        if q < 64:
            self.counts[q // 4] += 1
        self.energy += (q * q + 128) // 256
        self.details += 1

    def choose(self):
        self.sixteenths = 16 if self.energy < 557 else self._best()
        self._clear()

    def _best(self):
        below = squares = 0
        risks = []
        for j in range(1, 17):
            n = self.counts[j - 1]
            edge = 4 * j
            mid = edge - 2
            below += n
            squares += n * (mid * mid + 1)
            risks.append(i32(squares + (128 - below) * edge * edge) - 2 * 422 * below)
        return 1 + risks.index(min(risks))


# Noise shift

def noise_shift(table):
    """None for a table that has to be refused."""
    gain = max(sum(map(abs, table.sl[0::2])), sum(map(abs, table.sl[1::2])))
    if gain >= 2**16 or any(t >= 2**30 for t in table.expected):
        return None
    for s in range(16):
        if _holds(table, gain, s):
            return s
    return None


def _holds(table, gain, s):
    noise = 0
    for t in reversed(table.expected):
        removed = ((t if table.rule == FIXED else 4 * t) >> s) + 1
        noise = ((gain * (noise + removed)) >> 14) + 1
        if removed > 32767 or noise > 32767:
            return False
    return True
