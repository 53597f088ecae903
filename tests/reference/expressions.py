"""Expressions (spec/effects.md): what a program may be, and what it makes of a block's signals."""

from typing import NamedTuple

from arithmetic import INT32_MAX, clamp, round_divide, round_shift, sat32, scaled
from functions import exponential, sine_cosine, tanh
from thermal import Lag, Play

STACK = 16
STATES = 8
SIGNALS_BEFORE_INPUTS = 4
ELAPSED = 2

(SIGNAL, CONSTANT, DUPLICATE, OVER, NIP, SHIFT, ADD, SUBTRACT, MULTIPLY, DIVIDE, NEGATE, ABSOLUTE, MIN, MAX, SINE,
 COSINE, DECAY, TANH, LAG, PLAY, OUTPUT) = range(21)


class Shape(NamedTuple):
    """Of an operation: the range of k, further words, how many values it pops and pushes."""
    k_min: int
    k_max: int
    words: int
    pops: int
    pushes: int


SHAPES = {
    SIGNAL: Shape(0, 8, 2, 0, 1),
    CONSTANT: Shape(0, 0, 1, 0, 1),
    DUPLICATE: Shape(0, 0, 0, 1, 2),
    OVER: Shape(0, 0, 0, 2, 3),
    NIP: Shape(0, 0, 0, 2, 1),
    SHIFT: Shape(-31, 62, 0, 1, 1),
    ADD: Shape(0, 0, 0, 2, 1),
    SUBTRACT: Shape(0, 0, 0, 2, 1),
    MULTIPLY: Shape(0, 62, 0, 2, 1),
    DIVIDE: Shape(0, 30, 0, 2, 1),
    NEGATE: Shape(0, 0, 0, 1, 1),
    ABSOLUTE: Shape(0, 0, 0, 1, 1),
    MIN: Shape(0, 0, 0, 2, 1),
    MAX: Shape(0, 0, 0, 2, 1),
    SINE: Shape(0, 62, 0, 1, 1),
    COSINE: Shape(0, 62, 0, 1, 1),
    DECAY: Shape(0, 0, 0, 1, 1),
    TANH: Shape(0, 0, 0, 1, 1),
    LAG: Shape(0, 0, 1, 1, 1),
    PLAY: Shape(0, 0, 1, 1, 1),
    OUTPUT: Shape(-31, 62, 0, 1, 0),
}


class Operation(NamedTuple):
    code: int
    k: int
    words: tuple


class BadProgram(ValueError):
    pass


def decode(words, outputs):
    """The operations of a program that a reader accepts; else BadProgram."""
    program = []
    position = depth = 0
    while position < len(words):
        operation = _operation_at(words, position)
        shape = SHAPES[operation.code]
        if depth < shape.pops:
            raise BadProgram(f"the stack runs empty at word {position}")
        depth += shape.pushes - shape.pops
        if depth > STACK:
            raise BadProgram(f"more than {STACK} values on the stack at word {position}")
        position += 1 + shape.words
        program.append(operation)
    if depth != 0:
        raise BadProgram("the stack is not empty at the end")
    codes = [operation.code for operation in program]
    if codes.count(LAG) + codes.count(PLAY) > STATES:
        raise BadProgram(f"more than {STATES} lags and plays")
    if codes.count(OUTPUT) != outputs:
        raise BadProgram(f"{codes.count(OUTPUT)} outputs for {outputs} coefficients")
    return program


def _operation_at(words, position):
    code, k = words[position] % 256, words[position] >> 8
    shape = SHAPES.get(code)
    if shape is None or not shape.k_min <= k <= shape.k_max:
        raise BadProgram(f"no operation is word {position}")
    further = tuple(words[position + 1:position + 1 + shape.words])
    if len(further) < shape.words:
        raise BadProgram("it ends within an operation")
    if ((code == SIGNAL and further[0] > further[1]) or (code == LAG and further[0] <= 0)
            or (code == PLAY and not 0 <= further[0] < 2**30)):
        raise BadProgram(f"out of range: what follows word {position}")
    return Operation(code, k, further)


def divide(a, b, k):
    if b > 0:
        return sat32(round_divide(a << k, b))
    if b < 0:
        return sat32(round_divide(-(a << k), min(-b, INT32_MAX)))
    return -INT32_MAX if a < 0 else INT32_MAX


def angle(b, k):
    """Of radians at F k: the phase that sine_cosine takes."""
    return round_shift(b * 683565276, k)


# What an operation of one operand pushes for b, k; one of two for a, b, k.
OF_ONE = {
    SHIFT: scaled,
    NEGATE: lambda b, k: sat32(-b),
    ABSOLUTE: lambda b, k: sat32(abs(b)),
    SINE: lambda b, k: sine_cosine(angle(b, k))[0],
    COSINE: lambda b, k: sine_cosine(angle(b, k))[1],
    DECAY: lambda b, k: exponential(b),
    TANH: lambda b, k: tanh(b),
}
OF_TWO = {
    NIP: lambda a, b, k: b,
    ADD: lambda a, b, k: sat32(a + b),
    SUBTRACT: lambda a, b, k: sat32(a - b),
    MULTIPLY: lambda a, b, k: scaled(a * b, k),
    DIVIDE: divide,
    MIN: lambda a, b, k: min(a, b),
    MAX: lambda a, b, k: max(a, b),
}


class Expressions:
    def __init__(self, program):
        self.program = program
        self.states = [(Lag if operation.code == LAG else Play)(operation.words[0])
                       for operation in program if operation.code in (LAG, PLAY)]
        self.plays = [state for state in self.states if isinstance(state, Play)]
        self.clamped = False           # a signal but the time, in the last run

    @property
    def needs(self):
        """Extension inputs."""
        return {operation.k - SIGNALS_BEFORE_INPUTS for operation in self.program
                if operation.code == SIGNAL and operation.k >= SIGNALS_BEFORE_INPUTS}

    def run(self, signals, restart=False):
        """The regressors, F 28."""
        means = signals.means
        values = (signals.trained, signals.change, means.blocks, means.rate) + tuple(means.inputs)
        stack = []
        regressors = []
        states = iter(self.states)
        self.clamped = False
        for code, k, words in self.program:
            if code == SIGNAL:
                stack.append(clamp(values[k], *words))
                self.clamped |= stack[-1] != values[k] and k != ELAPSED
            elif code == CONSTANT:
                stack.append(words[0])
            elif code == DUPLICATE:
                stack.append(stack[-1])
            elif code == OVER:
                stack.append(stack[-2])
            elif code in OF_TWO:
                b, a = stack.pop(), stack.pop()
                stack.append(OF_TWO[code](a, b, k))
            elif code in OF_ONE:
                stack.append(OF_ONE[code](stack.pop(), k))
            elif code == LAG:
                stack.append(self._lag(next(states), stack.pop(), restart))
            elif code == PLAY:
                stack.append(self._play(next(states), stack.pop(), restart))
            else:
                regressors.append(scaled(stack.pop(), k))
        return regressors

    @staticmethod
    def _lag(lag, b, restart):
        if restart:
            lag.reset(b << 18)
        return sat32(round_shift(lag.step(b << 18), 18))

    def _play(self, play, b, restart):
        x = clamp(b, -2**30, 2**30)
        if restart:
            play.reset(x)
        if self.clamped:
            play.forget()
        return play.step(x)
