"""Lag, play, and the thermal stage (spec/effects.md); block means and signals."""

from typing import NamedTuple

from arithmetic import clamp, i32, round_shift, sat32


class Means(NamedTuple):
    """Of a block: temperature (F 16), blocks since power-on, input rate (F 10), the five extension inputs (F 16)."""
    temperature: int
    blocks: int
    rate: int
    inputs: tuple


class Signals(NamedTuple):
    """What the effects, the expressions and the network see of a block."""
    trained: int           # T', F 16
    change: int            # the temperature rate, F 25
    means: Means


# Lag, play

class Lag:
    def __init__(self, decay):
        self.decay = decay
        self.y = 0

    def reset(self, x):
        self.y = x

    def step(self, x):
        self.y += round_shift(sat32(round_shift(x - self.y, 18)) * self.decay, 13)
        return self.y


class Play:
    def __init__(self, radius):
        self.radius = radius
        self.y, self.lo, self.hi = 0, 1 << 22, 0

    def reset(self, x):
        below, above = i32(x - self.radius), i32(x + self.radius)
        self.y = x if self.lo > self.hi else clamp(self.y, below, above)
        self.lo, self.hi = below, above

    def step(self, x):
        below, above = i32(x - self.radius), i32(x + self.radius)
        self.y = clamp(self.y, below, above)
        self.lo = clamp(self.lo, below, above)
        self.hi = clamp(self.hi, below, above)
        return self.y

    def forget(self):
        """Before a step whose x may have come another way than it seems."""
        self.lo, self.hi = -2**31, 2**31 - 1

    @property
    def known(self):
        """Whether its history is known."""
        return self.lo == self.hi


# Thermal stage

class Derivative:
    """Of x at F 16 in degC, per minute at F 25."""

    def __init__(self, decay, gain):
        self.one = Lag(decay)
        self.two = Lag(decay)
        self.gain = gain

    def reset(self, x):
        self.one.reset(x << 24)
        self.two.reset(x << 24)

    def step(self, x):
        self.one.step(x << 24)
        ahead = sat32(round_shift(self.one.y - self.two.y, 14))
        self.two.step(self.one.y)
        return clamp(sat32(round_shift(ahead * self.gain, 25)), -2**30, 2**30)


class ThermalStage:
    def __init__(self, table):
        self.min, self.max = table.min_temperature, table.max_temperature
        self.derivative = Derivative(table.decay, table.gain)

    def reset(self, means):
        self.derivative.reset(means.temperature)
        return self._signals(means, 0)

    def step(self, means):
        return self._signals(means, self.derivative.step(means.temperature))

    @staticmethod
    def clamps(signals):
        return signals.trained != signals.means.temperature or abs(signals.change) == 2**30

    def _signals(self, means, change):
        return Signals(clamp(means.temperature, self.min, self.max), change, means)
