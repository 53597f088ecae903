"""From bytes to judged samples (spec/samples.md): sequence, sample rate, stuck, range, readings."""

from typing import NamedTuple

import flags
from arithmetic import u32

UNKNOWN = None             # a time that is not known


# Sequence

class Sequence:
    def __init__(self, period):
        self.period = period
        self.newest = None
        self.time = UNKNOWN
        self.late = 0
        self.doubt = 0
        self.doubtful = False              # the sample judged last

    def judge(self, number, now=UNKNOWN):
        """(flags, missing, whether the sample is late)"""
        self.doubtful = False
        if self.newest is None:
            self._take(number, now)
            return 0, 0, False
        s = (number - self.newest - 1) % 65536
        clock = now is not UNKNOWN and self.time is not UNKNOWN
        e = self._samples_since(now) - 1 if clock else 0
        m = s + 65536 * ((e - s + 32767) // 65536)
        contradicts = clock and abs(m - e) > 64 + (e >> 5)
        if m < 0 and not contradicts:
            self.late += 1
            if self.late < 8:
                return flags.SEQUENCE_GAP, 0, True
        if m < 0 or contradicts:
            m = e if clock else 7
            self.doubt = 10_000_000 // self.period
        if not clock:
            self._doubt(max(m, 0))
        self._take(number, now)
        return flags.SEQUENCE_GAP if s != 0 or m > 0 else 0, max(m, 0), False

    def _doubt(self, missing):
        self.doubt += 50 * missing
        self.doubtful = self.doubt > 10_000_000 // self.period
        self.doubt = 0 if self.doubtful else max(self.doubt - 1, 0)

    def _samples_since(self, now):
        return min(2**30, (u32(now - self.time) * ((1000 << 20) // self.period) + 2**19) >> 20)

    def _take(self, number, now):
        self.late = 0
        self.newest = number
        self.time = now


# Sample rate

class SampleRate:
    def __init__(self, period, part):
        self.period = period
        self.part = part
        self.since = UNKNOWN
        self.count = 0
        self.off = False

    def judge(self, elapsed, now=UNKNOWN):
        """elapsed: 0 of a late sample."""
        if now is UNKNOWN:
            return 0
        counted = self.since is not UNKNOWN
        if counted:
            self.count += elapsed
            passed = u32(now - self.since) * 1000
            wrong = self.part * abs(self.count * self.period - passed) > max(passed, 10_000_000)
            if wrong:
                self.off = True
            elif passed >= 10_000_000:
                self.off = False
            counted = not wrong and passed < 10_000_000
        if not counted:
            self.since = now
            self.count = 0
        return flags.SAMPLE_RATE if self.off else 0


# Stuck

class Stuck:
    def __init__(self, samples, band):
        self.samples = samples
        self.band = band
        self.run = []                      # lowest and highest of it
        self.length = 0

    def judge(self, counts):
        self.run = [min([*self.run, counts]), max([*self.run, counts])]
        if self.run[1] - self.run[0] > self.band:
            self.run = [counts, counts]
            self.length = 0
        self.length = min(self.length + 1, self.samples)
        return flags.GYRO_STUCK if 0 < self.samples == self.length else 0


# Range and rate of change

class Rate:
    def __init__(self, period, limit, step):
        """limit: the table's range; step: twice the table's word."""
        self.range = limit
        self.step = step
        self.set = 39 * limit // 40
        self.clear = 37 * limit // 40
        self.hold = -(-50_000 // period)
        self.out = False
        self.inside = self.hold
        self.accepted = None
        self.last = 0
        self.since = self.unseen = 0
        self.turned = False
        self.mirrored = False

    def judge(self, rate, elapsed, trusted):
        judged = flags.RATE_OUT_OF_RANGE if self._out_of_range(rate, elapsed) else 0
        if self._jumps(rate, elapsed, trusted):
            judged |= flags.RATE_JUMP
        return judged

    def _out_of_range(self, rate, elapsed):
        if abs(rate) >= self.set:
            self.out = True
            self.inside = 0
        elif abs(rate) > self.clear:
            self.inside = 0
        elif self.out:
            self.inside = min(self.inside + elapsed, self.hold)
            self.out = self.inside < self.hold
        return self.out

    def _jumps(self, rate, elapsed, trusted):
        self.since = min(self.since + elapsed, 2**30)
        self.unseen = min(self.unseen + elapsed, 2**30)
        if self.step * self.unseen >= self.range:
            self.turned = True
        jump = self.accepted is not None and self._too_far(rate, elapsed)
        self.last = rate
        if trusted:
            self.unseen = 0
            if not jump and abs(rate) < self.set:
                self.accepted = rate
                self.since = 0
                self.turned = self.mirrored = False
        return jump

    def _too_far(self, rate, elapsed):
        far = abs(rate - self.accepted)
        if far <= self.step:
            return False
        if 2 * abs(rate) <= self.step:
            self.mirrored = False
        leaps = far > self.step * self.since or abs(rate - self.last) > self.step * elapsed
        if leaps and abs(rate + self.accepted) <= self.step:
            self.mirrored = True
        return leaps or ((far > self.range or self.mirrored) and not self.turned)


# Readings

NONE, GOOD, GOOD_ANEW = 0, 1, 2        # what use a reading is of
LONGEST = 3_600_000_000                # us
POWER_ON = 85 << 16


class Limits(NamedTuple):
    min: int
    max: int
    step: int


COIL = Limits(-4587520, 8519680, 131072)


class Reading:
    """The monitor of the coil's temperature, or of an extension input."""

    def __init__(self, limits, thermal_mass, period):
        self.min, self.max = limits.min, limits.max
        self.step = u32(limits.step)
        self.thermal_mass = thermal_mass
        self.period = period
        self.confirmed = False                     # "started"
        self.frozen = self.refused = False
        self.last = 0
        self.before = -2**31
        self.agreed = self.since = self.unchanged = self.minute = 0
        self.resolution = 2**32 - 1
        self.large = self.moved = 0
        self.at_minute = self.minute_before = 0

    def judge(self, x, valid, elapsed):
        """(flags, use)"""
        us = min(elapsed * self.period, LONGEST)
        self.since = min(self.since + us, LONGEST)
        if not valid or x < self.min or x > self.max:
            return flags.TEMPERATURE_INVALID, NONE
        agrees = abs(x - self.before) <= self.step
        self.agreed = min(self.agreed + us, LONGEST) if agrees else 0
        self.before = x
        if not self.confirmed:
            return self._first(x, us)
        if self._jumps(x, agrees):
            self.refused = self.refused or not self._reached(x)
            return flags.TEMPERATURE_INVALID | flags.TEMPERATURE_JUMP, NONE
        anew = self.frozen or (self.refused and abs(x - self.last) > self.step)
        self.follow(x, us)
        self.frozen = self._freezes()
        if self.frozen:
            return flags.TEMPERATURE_INVALID | flags.TEMPERATURE_FROZEN, NONE
        self.refused = False
        return 0, GOOD_ANEW if anew else GOOD

    def _first(self, x, us):
        if self._power_on(x):
            return flags.TEMPERATURE_INVALID | flags.TEMPERATURE_JUMP, NONE
        use = GOOD if self.agreed > 0 else GOOD_ANEW
        if self.agreed >= 500_000:
            self.follow(x, us)
        return 0, use

    def _jumps(self, x, agrees):
        if self._power_on(x):
            return abs(x - self.last) > 65536
        return abs(x - self.last) > self.step and not (agrees and self.agreed >= 500_000 and self._reached(x))

    def _freezes(self):
        return self.unchanged >= 60_000_000 and (
            self.large >= 4
            or (self.thermal_mass and self.moved >= 16384 and self.moved // 4 >= self.resolution
                and self.unchanged >= 120_000_000))

    def _power_on(self, x):
        return self.thermal_mass and x == POWER_ON

    def _reached(self, x):
        return not self.thermal_mass or (abs(x - self.last) - self.step) * 1_000_000 <= 65536 * self.since

    def follow(self, x, us):
        if not self.confirmed:
            self.last = self.at_minute = self.minute_before = x
        self.confirmed = True
        self.since = 0
        if x == self.last:
            self.unchanged = min(self.unchanged + us, LONGEST)
        else:
            self._change_to(x)
        self.minute = min(self.minute + us, LONGEST)
        if self.minute >= 60_000_000:
            self.minute = 0
            self.minute_before = self.at_minute
            self.at_minute = x

    def _change_to(self, x):
        change = abs(x - self.last)
        self.resolution = min(self.resolution, change)
        if change // 8 < self.resolution:
            self.large = max(self.large - 1, 0)
        else:
            self.large = min(self.large + 1, 8)
        self.moved = abs(x - self.minute_before)
        self.unchanged = 0
        self.last = x


# Order

class Verdict(NamedTuple):
    flags: int
    late: bool
    missing: int
    use: int               # of the temperature
    confirmed: bool        # the temperature
    doubtful: bool         # the time that has passed


class Judge:
    """The judging of samples. The inputs' readings are judged by the pipeline, when their records come."""

    def __init__(self, table):
        self.sequence = Sequence(table.period)
        self.stuck = Stuck(table.stuck_samples, table.stuck_band)
        self.sample_rate = SampleRate(table.period, table.sample_rate_part)
        self.rate = Rate(table.period, table.range, 2 * table.step)
        self.temperature = Reading(COIL, True, table.period)

    def judge(self, sample, rate, now=UNKNOWN):
        judged, missing, late = self.sequence.judge(sample.number, now)
        elapsed = 1 if late else missing + 1
        if not sample.gyro_valid:
            judged |= flags.GYRO_INVALID
        judged |= self.stuck.judge(sample.counts)
        judged |= self.sample_rate.judge(0 if late else elapsed, now)
        trusted = not judged & (flags.GYRO_INVALID | flags.GYRO_STUCK)
        judged |= self.rate.judge(rate, elapsed, trusted)
        temperature_flags, use = self.temperature.judge(sample.temperature, sample.temperature_valid, elapsed)
        return Verdict(judged | temperature_flags, late, missing, use, self.temperature.confirmed,
                       self.sequence.doubtful)
