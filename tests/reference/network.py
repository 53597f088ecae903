"""Network (spec/effects.md)."""

from typing import NamedTuple

from arithmetic import INT32_MAX, clamp, round_shift, sat32
from functions import activation
from thermal import Lag

TRAINED, CHANGE, LAGGED, BLOCKS, RATE, FIRST_INPUT = range(6)     # signals


class NetworkInput(NamedTuple):
    signal: int
    decay: int
    centre: int
    reach: int
    shift: int


class Neuron(NamedTuple):
    bias: int
    weights: tuple
    output_weight: int


class NetworkTable(NamedTuple):
    inputs: tuple
    hidden_shift: int
    output_shift: int
    neurons: tuple
    output_bias: int
    linear: bool
    centre: int
    amplitude: int


class Network:
    def __init__(self, table):
        """table: None where there are no hidden neurons."""
        self.table = table
        self.lags = [Lag(each.decay) for each in table.inputs] if table else []
        self.clamped = False           # an input, but for that of the time, in the last step

    @property
    def needs(self):
        """Extension inputs."""
        inputs = self.table.inputs if self.table else ()
        return {each.signal - FIRST_INPUT for each in inputs if each.signal >= FIRST_INPUT}

    def reset(self, signals):
        for lag in self.lags:
            lag.reset(signals.trained << 24)

    def drift(self, signals):
        """Its step: the drift, F 20."""
        table = self.table
        if table is None:
            return 0
        self.clamped = False
        inputs = [self._input(each, lag, signals) for each, lag in zip(table.inputs, self.lags)]
        total = (table.output_bias << 32) + 2**31
        for neuron in table.neurons:
            total += neuron.output_weight * self._hidden(neuron, inputs)
        return round_shift(table.amplitude * self._output(total >> 32), 26) + (table.centre << 4)

    def _input(self, each, lag, signals):
        means = signals.means
        if each.signal == LAGGED:
            value = round_shift(lag.step(signals.trained << 24), 24)
        else:
            value = (signals.trained, signals.change, None, means.blocks, means.rate, *means.inputs)[each.signal]
        off = sat32(value - each.centre)
        if abs(off) > each.reach and each.signal != BLOCKS:
            self.clamped = True
        return clamp(off, -each.reach, each.reach) << each.shift

    def _hidden(self, neuron, inputs):
        total = (neuron.bias << 32) + 2**31 + sum(w * x for w, x in zip(neuron.weights, inputs))
        return activation((total >> 32) << (8 + self.table.hidden_shift))

    def _output(self, v):
        shift = self.table.output_shift
        if not self.table.linear:
            return activation(v << (8 + shift))
        limit = INT32_MAX >> (3 + shift)
        return clamp(v, -limit, limit) << (3 + shift)
