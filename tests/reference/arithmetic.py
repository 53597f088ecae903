"""Arithmetic (spec/arithmetic.md): notation, CRCs, IEEE singles. The elementary functions are in functions.py."""

INT32_MIN = -2**31
INT32_MAX = 2**31 - 1


# Notation. `//`, `>>`, `<<` and `%` of Python are those of the specification.

def round_shift(x, n):
    return x if n == 0 else (x + (1 << (n - 1))) >> n


def round_divide(a, b):
    return (2 * a + b) // (2 * b)


def truncated_quotient(a, b):
    """trunc(a / b), b > 0."""
    return a // b if a >= 0 else -(-a // b)


def clamp(x, lo, hi):
    return lo if x < lo else hi if hi < x else x


def sat32(x):
    return INT32_MIN if x < INT32_MIN else INT32_MAX if INT32_MAX < x else x


def i16(x):
    return (x + 2**15) % 2**16 - 2**15


def i32(x):
    return (x + 2**31) % 2**32 - 2**31


def u32(x):
    return x % 2**32


def upper(a, b):
    """H(a, b): the upper word of the product."""
    return (a * b) >> 32


def product(a, b):
    """P(a, b): a product of numbers at F 30."""
    return (a * b + 2**29) >> 30


def top(x):
    """floor(log2 x), x > 0."""
    return x.bit_length() - 1


def scaled(x, n):
    """S(x, n) of effects.md: a saturating shift, to the right where n > 0."""
    return sat32(round_shift(x, n) if n >= 0 else x << -n)


# CRCs

def _crc_steps(width, polynomial):
    """What eight steps make of each byte at the top of the register."""
    steps = []
    for byte in range(256):
        crc = byte << (width - 8)
        for _ in range(8):
            crc = (crc << 1) ^ (polynomial if crc >> (width - 1) else 0)
            crc %= 1 << width
        steps.append(crc)
    return steps


_STEPS16 = _crc_steps(16, 0x1021)
_STEPS32 = _crc_steps(32, 0x04C11DB7)


def crc16(data, crc=0xFFFF):
    for byte in data:
        crc = ((crc << 8) & 0xFFFF) ^ _STEPS16[(crc >> 8) ^ byte]
    return crc


def crc32(data, crc=0xFFFFFFFF):
    for byte in data:
        crc = ((crc << 8) & 0xFFFFFFFF) ^ _STEPS32[(crc >> 24) ^ byte]
    return crc


# IEEE singles

def float_bits(negative, exponent, mantissa):
    bits = ((exponent + 127) << 23) + mantissa - 2**23
    return bits | (negative << 31)


def rate_float(rate):
    """The rate (F 10, deg/h) as a single, in rad/s."""
    if rate == 0:
        return 0
    p = abs(rate) * 2729258392
    n = top(p) - 23
    return float_bits(rate < 0, top(p) - 59, (p + (1 << (n - 1))) >> n)


class DeltaAngle:
    """Delta angle: the angle of each sample period; what a float does not hold is left for the next one."""

    def __init__(self, period):
        self.period = period
        self.sum = 0

    def step(self, rate):
        self.sum += rate * self.period * 5723669695
        a = self.sum >> 32
        if a == 0:
            return 0
        highest = top(abs(a))
        n = max(0, highest - 23)
        kept = round_shift(abs(a), n)
        self.sum -= (kept << n << 32) * (1 if a > 0 else -1)
        return float_bits(a < 0, highest - 48, kept << (23 + n - highest))
