"""The vectors: spec_functions.txt line by line, and spec_stream.txt sample by sample."""

import os
from collections import Counter

import functions
from arithmetic import (DeltaAngle, crc16, crc32, rate_float, round_divide, round_shift)
from denoiser import FIXED, HARD, HEURSURE, SOFT, SQTWOLOG, Denoiser, noise_shift
from effects import FOLLOWING, FOR_A_BLOCK, drift_of
from expressions import Expressions
from network import Network
from pipeline import Replay
from samples import COIL, Reading, SampleRate, Sequence
from table import read
from thermal import Derivative, Lag, Means, Play, Signals

SHOWN = 10                             # differences that are shown


class BadVectors(ValueError):
    pass


def _lines(path):
    try:
        with open(path, encoding="ascii") as file:
            return [(number, line.split()) for number, line in enumerate(file, 1)
                    if line.strip() and not line.startswith("#")]
    except UnicodeDecodeError:
        raise BadVectors(f"{path}: these are no vectors") from None


def _integers(words, path, number):
    try:
        return [int(word) for word in words]
    except ValueError:
        raise BadVectors(f"{path}: line {number}: a number is none") from None


def _bytes(words, path, number):
    try:
        return bytes.fromhex("".join(words))
    except ValueError:
        raise BadVectors(f"{path}: line {number}: these are no bytes") from None


# spec_stream.txt

def _table_of(path):
    for number, words in _lines(path):
        if words[0] == "table":
            return read(_integers(words[1:], path, number))
    raise BadVectors(f"{path}: there is no table")


class StreamCheck:
    """Compares the bytes that each sample causes; a `>` line is followed by the `<` lines of its samples."""

    def __init__(self, table):
        self.replay = Replay(table)
        self.waiting = []
        self.samples = self.equal = 0
        self.differences = []

    def send(self, number, data):
        self.all_compared(number)
        self.waiting = list(self.replay.feed(data))

    def expect(self, number, data):
        self.samples += 1
        sent = self.waiting.pop(0) if self.waiting else b""
        if sent == data:
            self.equal += 1
        else:
            self.differences.append(f"line {number}, sample {self.samples - 1}: {sent.hex()} instead of {data.hex()}")

    def all_compared(self, number):
        if self.waiting:
            self.differences.append(f"line {number}: before it {len(self.waiting)} samples were answered too many")


def check_stream(path):
    """(report lines, whether all is equal)"""
    check = StreamCheck(_table_of(path))
    for number, words in _lines(path):
        if words[0] == ">":
            check.send(number, _bytes(words[1:], path, number))
        elif words[0] == "<":
            check.expect(number, _bytes(words[1:], path, number))
    check.all_compared("at the end")
    report = [f"{check.equal} of {check.samples} samples are answered alike"]
    return report + check.differences[:SHOWN], not check.differences


# spec_functions.txt

def _flattened(value):
    return [int(each) for each in value] if isinstance(value, (tuple, list)) else [int(value)]


class FunctionVectors:
    """A method `name` gives the results of a line for its arguments; those with a state go from line to line."""

    FILTERS = {"fixed_hard": (FIXED, HARD), "sqtwolog_soft": (SQTWOLOG, SOFT), "heursure_soft": (HEURSURE, SOFT)}
    THRESHOLDS = (150689, 106553, 75344)
    DECAY, GAIN, RADIUS, START = 70402888, 33001354, 3 << 22, 20

    def __init__(self, table):
        self.table = table
        self.signals_given = []
        self.states = {}
        self.angle = DeltaAngle(5000)
        self.lag_of_20 = Lag(self.DECAY)
        self.lag_of_20.reset(self.START << 40)
        self.derivative_of_20 = Derivative(self.DECAY, self.GAIN)
        self.derivative_of_20.reset(self.START << 16)
        self.play_of_20 = Play(self.RADIUS)
        self.play_of_20.reset(self.START << 22)
        self.monitor = Reading(COIL, True, 200000)
        self.sequences = Sequence(5000), Sequence(5000)
        self.rate_monitor = SampleRate(5000, 50)

    def result(self, name, arguments):
        if name.startswith("denoise_"):
            return self.denoise(name[len("denoise_"):], *arguments)
        return getattr(self, name)(*arguments)

    # arithmetic.md

    round_shift = staticmethod(round_shift)
    round_shift32 = staticmethod(round_shift)
    round_divide = staticmethod(round_divide)
    exponential = staticmethod(functions.exponential)
    sine_cosine = staticmethod(functions.sine_cosine)
    logistic = staticmethod(functions.logistic)
    tanh = staticmethod(functions.tanh)
    activation = staticmethod(functions.activation)
    logarithm = staticmethod(functions.logarithm)
    rate_float = staticmethod(rate_float)

    @staticmethod
    def crc16(count):
        return crc16(b"123456789\xFF"[:count])

    @staticmethod
    def crc32(count):
        return crc32(b"123456789\xFF"[:count])

    def delta_angle(self, rate):
        return self.angle.step(rate)

    # effects.md

    def lag(self, x):
        return self.lag_of_20.step(x << 24)

    def derivative(self, x):
        return self.derivative_of_20.step(x)

    def play(self, x):
        return self.play_of_20.step(x), self.play_of_20.known

    def give_signals(self, values):
        trained, change, blocks, rate, *inputs = values
        self.signals_given.append(Signals(trained, change, Means(trained, blocks, rate, tuple(inputs))))

    def _stepped(self, key, state, reset):
        """The state of this key, reset with signals 0 when it is made."""
        if key not in self.states:
            reset(state, self.signals_given[0])
            self.states[key] = state
        return self.states[key]

    def effect(self, number, i):
        entry = next(each for each in self.table.effects if each.id == number)
        signals = self.signals_given[i]
        if number in FOLLOWING:
            effect = FOLLOWING[number](entry.constants, entry.coefficients, self.table.fraction)
            effect.make(signals)
            return 0, effect.drift(signals.means.rate)
        effect = FOR_A_BLOCK[number](entry.constants)
        effect = self._stepped(number, effect, lambda state, first: state.reset(first))
        return drift_of(entry.coefficients, effect.regressors(signals), self.table.fraction), 0

    def expressions(self, i):
        expressions = self._stepped("expressions", Expressions(self.table.program),
                                    lambda state, first: state.run(first, restart=True))
        regressors = expressions.run(self.signals_given[i])
        return *regressors, drift_of(self.table.expression_coefficients, regressors, self.table.fraction)

    def network(self, i):
        network = self._stepped("network", Network(self.table.network), lambda state, first: state.reset(first))
        return network.drift(self.signals_given[i])

    # denoiser.md

    def _denoiser_table(self, rule, mode):
        return self.table.denoiser._replace(rule=rule, mode=mode, expected=self.THRESHOLDS)

    def noise_shift(self, rule):
        return noise_shift(self._denoiser_table(rule, SOFT))

    def denoise(self, filters, _, rate, valid):
        if filters not in self.states:
            self.states[filters] = Denoiser(self._denoiser_table(*self.FILTERS[filters]))
        return self.states[filters].denoise(rate, bool(valid))

    # samples.md

    def reading(self, x, valid, elapsed):
        judged, use = self.monitor.judge(x, valid, elapsed)
        return judged, use, self.monitor.confirmed

    def sequence(self, number, ms):
        without, with_clock = self.sequences
        return (*without.judge(number), without.doubtful, *with_clock.judge(number, ms), with_clock.doubtful)

    def sample_rate(self, elapsed, ms):
        return self.rate_monitor.judge(elapsed, None if ms < 0 else ms)


def _tables_report():
    good = functions.sums_of_tables() == functions.SUMS_OF_TABLES
    return [] if good else ["the sums of the tables E, T, R, L, N are wrong"]


def _vector(words, path, number):
    """name, arguments, results"""
    if "->" not in words:
        raise BadVectors(f"{path}: line {number} is no vector")
    split = words.index("->")
    return words[0], _integers(words[1:split], path, number), _integers(words[split + 1:], path, number)


def check_functions(path):
    """(report lines, whether all is equal)"""
    vectors = FunctionVectors(_table_of(os.path.join(os.path.dirname(path) or ".", "spec_stream.txt")))
    lines, equal = Counter(), Counter()
    differences = _tables_report()
    for number, words in _lines(path):
        name, arguments, expected = _vector(words, path, number)
        if name == "signals":
            vectors.give_signals(expected)
            continue
        try:
            result = _flattened(vectors.result(name, arguments))
        except (AttributeError, TypeError, KeyError, IndexError, StopIteration):
            raise BadVectors(f"{path}: line {number}: {name} is not known with such arguments") from None
        lines[name] += 1
        if result == expected:
            equal[name] += 1
        else:
            differences.append(f"line {number}, {name} {arguments}: {result} instead of {expected}")
    report = [f"{name}: {equal[name]} of {lines[name]}" for name in lines]
    report.append(f"all: {sum(equal.values())} of {sum(lines.values())} lines are alike")
    return report + differences[:SHOWN], not differences
