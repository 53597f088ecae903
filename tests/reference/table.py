"""Model table, and the slot that it may come in (SPEC.md)."""

import struct
from typing import NamedTuple

import flags
from arithmetic import INT32_MAX, INT32_MIN, crc32, i16
from cost import INSTRUCTIONS_PER_US, sample_cost
from denoiser import DenoiserTable, noise_shift
from effects import FOLLOWING, FOR_A_BLOCK
from expressions import BadProgram, decode
from network import LAGGED, NetworkInput, NetworkTable, Neuron
from samples import Limits

TABLE_MAGIC = 0x464F474D
TABLE_LAYOUT = 9
SLOT_MAGIC = 0x53474F46
SLOT_LAYOUT = 1

# why a table is refused
MISSING, OTHER_LAYOUT, DAMAGED, OUT_OF_RANGE, FRAMES_TOO_LONG, SAMPLE_TOO_DEAR = 1, 2, 3, 4, 8, 9

BYTES_OF_FRAMES = (36, 28, 64)         # of a sample: KVH, compact, both
FASTEST_SENSOR_LINE, FASTEST_OUTPUT_LINE = 2_000_000, 4_147_200         # bits per second
BITS_OF_FORMATS = (10, 11, 11, 12, 11, 12)      # a byte: 8N1, 8N2, 8E1, 8E2, 8O1, 8O2


class Refused(ValueError):
    def __init__(self, reason, text):
        super().__init__(text)
        self.reason = reason


class EffectTable(NamedTuple):
    id: int
    constants: tuple
    coefficients: tuple


class Line(NamedTuple):
    bits_per_second: int
    bits_per_byte: int


class Table(NamedTuple):
    # header
    serial: bytes
    processor: tuple
    # calibration
    period: int
    sample_rate_part: int
    samples_per_block: int
    multiplier: int
    shift: int
    range: int
    step: int
    stuck_samples: int
    stuck_band: int
    # thermal
    decay: int
    gain: int
    min_temperature: int
    max_temperature: int
    hold_blocks: int
    accurate_blocks: int
    settle_blocks: int
    # inputs: limits
    inputs: tuple
    # effects
    fraction: int
    effects: tuple
    # expressions
    expression_coefficients: tuple
    program: list
    network: NetworkTable              # None without hidden neurons
    denoiser: DenoiserTable
    # output
    frames: int
    delta_angle: bool
    undelayed: bool
    chosen: int
    sensor_line: Line
    output_line: Line


class Words:
    """The words of a table, one after another."""

    def __init__(self, words):
        self.words = words
        self.position = 0

    def next(self, what, lo=INT32_MIN, hi=INT32_MAX):
        if self.position >= len(self.words):
            raise Refused(OUT_OF_RANGE, f"the model table ends before its {what}")
        word = self.words[self.position]
        if not lo <= word <= hi:
            raise Refused(OUT_OF_RANGE, f"word {self.position} of the model table, {what}: {word} is not {lo}...{hi}")
        self.position += 1
        return word

    def several(self, count, what, lo=INT32_MIN, hi=INT32_MAX):
        return tuple(self.next(what, lo, hi) for _ in range(count))

    def counted(self, most, what):
        return self.several(self.next("count of the " + what, 0, most), what)

    def require(self, holds, what):
        if not holds:
            raise Refused(OUT_OF_RANGE, f"model table, before word {self.position}: {what}")


def read_file(data):
    """The table in a file: a slot, or the table alone."""
    if len(data) % 4 != 0:
        raise Refused(MISSING, "the model table is no whole number of words")
    words = struct.unpack(f"<{len(data) // 4}i", data)
    if words and words[0] == SLOT_MAGIC:
        words = inside_of_slot(words)
    return read(words)


def inside_of_slot(words):
    """Model slots."""
    if len(words) < 5 or not 0 <= words[3] <= 4091:
        raise Refused(DAMAGED, "the slot is cut off, or its number of words is wrong")
    if words[1] != SLOT_LAYOUT:
        raise Refused(OTHER_LAYOUT, f"the slot has layout {words[1]}, not {SLOT_LAYOUT}")
    if len(words) != words[3] + 5:
        raise Refused(DAMAGED, f"the slot has {len(words)} words, not {words[3] + 5}")
    if crc32(_bytes(words)) != 0xFFFFFFFF:
        raise Refused(DAMAGED, "the slot's seal is wrong")
    return words[4:-1]


def _bytes(words):
    return struct.pack(f"<{len(words)}i", *words)


def read(words):
    _check_frame(words)
    r = Words(words[:-1])
    table = Table(*_header(r), *_calibration(r), *_thermal(r), _inputs(r), *_effects(r), *_expressions(r),
                  _network(r), _denoiser(r), *_output(r))
    r.require(r.position == len(r.words), "words are left over")
    bits = table.output_line.bits_per_byte * BYTES_OF_FRAMES[table.frames]
    if bits * 10**6 > table.period * table.output_line.bits_per_second:
        raise Refused(FRAMES_TOO_LONG, f"{bits} bits do not fit into a sample period of {table.period} us")
    cost = sample_cost(table)
    if cost > INSTRUCTIONS_PER_US * table.period:
        raise Refused(SAMPLE_TOO_DEAR, f"{cost} instructions are too many for a sample period of {table.period} us")
    return table


def _check_frame(words):
    if not 5 <= len(words) <= 4096 or words[0] != TABLE_MAGIC:
        raise Refused(MISSING, "this is no model table")
    if words[1] != TABLE_LAYOUT:
        raise Refused(OTHER_LAYOUT, f"the model table has layout {words[1]}, not {TABLE_LAYOUT}")
    if words[2] != len(words):
        raise Refused(DAMAGED, f"the model table has {len(words)} words, not {words[2]}")
    if crc32(_bytes(words[:-1])) != words[-1] % 2**32:
        raise Refused(DAMAGED, "the CRC of the model table is wrong")


# header, calibration, thermal, inputs

def _header(r):
    """A replay needs nothing of it, and asks of no processor."""
    r.several(4, "magic, layout, number of words, CRC-32 of the model file")
    serial = _bytes(r.several(4, "serial number"))
    r.require(serial[15] == 0, "the last byte of the serial number is not 0")
    return serial, r.several(3, "number of the processor")


def _calibration(r):
    return (r.next("sample period", 1), r.next("part of the sample rate", 1, 1000), r.next("samples per block", 1),
            r.next("multiplier", 2**30), r.next("shift", 0, 62), r.next("range", 1), r.next("largest step", 1),
            r.next("stuck samples", 0), r.next("stuck band", 0))


def _thermal(r):
    decay, gain = r.next("decay", 1), r.next("rate gain", 1)
    lowest = r.next("min trained temperature", -70 << 16, 130 << 16)
    highest = r.next("max trained temperature", lowest, 130 << 16)
    blocks = [r.next(what, 0) for what in ("hold blocks", "accurate blocks", "settle blocks")]
    return (decay, gain, lowest, highest, *blocks)


def _inputs(r):
    return tuple(Limits(*r.several(3, "limits of an input")) for _ in range(r.next("count of inputs", 0, 5)))


# effects

def _effects(r):
    fraction = r.next("coefficient fraction", 10, 40)
    effects = tuple(_effect(r) for _ in range(r.next("count of effects", 0, 32)))
    ids = [effect.id for effect in effects]
    r.require(len(set(ids)) == len(ids), "an effect is there twice")
    return fraction, effects


def _effect(r):
    number = r.next("id of an effect", 0, 31)
    kind = FOR_A_BLOCK.get(number) or FOLLOWING.get(number)
    r.require(kind is not None, f"no board has effect {number}")
    r.next("count of constants", len(kind.constants), len(kind.constants))
    constants = tuple(r.next(f"constant of effect {number}", lo, hi) for lo, hi in kind.constants)
    if number in FOLLOWING:
        r.require(kind.accepts(constants), f"constants of effect {number}")
    count = kind.counts(constants)
    r.next("count of coefficients", count, count)
    return EffectTable(number, constants, r.several(count, "coefficients"))


# expressions

def _expressions(r):
    coefficients = r.counted(8, "coefficients of the expressions")
    words = r.counted(512, "words of the program")
    try:
        return coefficients, decode(words, len(coefficients))
    except BadProgram as error:
        raise Refused(OUT_OF_RANGE, f"program of the expressions: {error}") from None


# network

def _network(r):
    count = r.next("count of network inputs", 0, 4)
    hidden = r.next("count of hidden neurons", 0, 32)
    if hidden == 0:
        return None
    r.require(count > 0, "a network without an input")
    inputs = tuple(_network_input(r) for _ in range(count))
    shifts = r.several(2, "shift of the neurons", 0, 16)
    neurons = tuple(_neuron(r, count) for _ in range(hidden))
    bias = r.next("bias of the output")
    total = sum(abs(neuron.output_weight) for neuron in neurons) + 2 * abs(bias)
    r.require(total < 2**32 - 1, "the weights in the output are too large")
    linear = bool(r.next("whether the output is linear", 0, 1))
    return NetworkTable(inputs, *shifts, neurons, bias, linear, *r.several(2, "centre, amplitude"))


def _network_input(r):
    signal = r.next("signal of the network", 0, 9)
    lagged = signal == LAGGED
    decay = r.next("decay of a network input", int(lagged), INT32_MAX if lagged else 0)
    centre, reach = r.next("centre of a network input"), r.next("reach of a network input", 1)
    shift = r.next("shift of a network input", 0, 30)
    r.require(reach <= INT32_MAX >> shift, "reach of a network input")
    return NetworkInput(signal, decay, centre, reach, shift)


def _neuron(r, inputs):
    bias, *weights, output_weight = r.several(6, "hidden neuron")
    r.require(not any(weights[inputs:]), "a weight without an input is not 0")
    r.require(sum(map(abs, weights)) + 2 * abs(bias) < 2**32 - 1, "the weights of a hidden neuron are too large")
    return Neuron(bias, tuple(weights), output_weight)


# denoiser

def _denoiser(r):
    levels, taps = r.next("levels", 0, 10), r.next("taps", 0, 30)
    r.require(taps % 2 == 0 and (taps == 0) == (levels == 0), "number of taps")
    rule, mode = r.next("rule", 0, 2), r.next("mode", 0, 1)
    low, synthesis = r.several(taps, "low-pass taps"), r.several(taps, "synthesis taps")
    sl, sh = tuple(i16(word) for word in synthesis), tuple(word >> 16 for word in synthesis)
    table = DenoiserTable(levels, rule, mode, low, sl, sh, r.several(levels, "thresholds", 0))
    if levels > 0:
        _check_filters(r, table)
        r.require(noise_shift(table) is not None, "there is no noise shift for the thresholds")
    return table


def _check_filters(r, table):
    taps, low, sl, sh = range(table.taps), table.low, table.sl, table.sh
    r.require(sum(low[0::2]) == sum(low[1::2]) == 2**30, "sums of the low-pass taps")
    r.require(sum(map(abs, low)) < 2**32 - 1, "magnitudes of the low-pass taps")
    r.require(sum(sl[0::2]) == sum(sl[1::2]) == 2**14, "sums of the synthesis taps")
    r.require(all(sh[i] == (-1)**(i + 1) * sl[-1 - i] for i in taps), "synthesis taps")


# output

def _output(r):
    frames = r.next("frames", 0, 30)
    r.require(frames % 4 <= 2, "frames")
    chosen = r.next("flags with which no rate is valid", 0)
    r.require(chosen & flags.BOLD == flags.BOLD and chosen & ~(flags.BOLD | flags.OF_CHOICE) == 0,
              "flags with which no rate is valid")
    return (frames % 4, bool(frames & 4), bool(frames & 16), chosen, _line(r, "sensor line", FASTEST_SENSOR_LINE),
            _line(r, "output line", FASTEST_OUTPUT_LINE))


def _line(r, what, fastest):
    word = r.next(what, 0, 6 * 2**24 - 1)
    r.require(9600 <= word % 2**24 <= fastest, f"bit rate of the {what}")
    return Line(word % 2**24, BITS_OF_FORMATS[word >> 24])
