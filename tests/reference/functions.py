"""Elementary functions (spec/arithmetic.md): exponential to hyperbolic tangent."""

import math

from arithmetic import clamp, i32, product, round_shift, sat32, top, u32, upper


def _nearest(x):
    return math.floor(x + 0.5)


# Exponential

E = [_nearest(2**30 * 2**(-i / 16)) for i in range(16)]


def exponential(x):
    """exp(-x): x at F 26, the result at F 30."""
    if x < 0:
        return 2**30
    y = round_shift(x * 1549082005, 24)
    nodes = round_shift(y, 28)
    t = y - (nodes << 28)
    z = round_shift(t * 1488522236, 33)
    s = 178956971 - product(z, 44739243)
    s = 2**29 - product(z, s)
    s = 2**30 - product(z, s)
    s = 2**30 - product(z, s)
    f = product(E[nodes % 16], s)
    h = nodes // 16
    return 0 if h > 31 else round_shift(f, h)


# Sine and cosine

T = [_nearest(2**30 * math.sin(2 * math.pi * i / 64)) for i in range(17)]


def _sine_of_node(k):
    """S(k): the sine of k / 64 turns."""
    k %= 64
    j = k % 32
    sine = T[j] if j <= 16 else T[32 - j]
    return -sine if k >= 32 else sine


def sine_cosine(phase):
    """Of phase / 2^32 turns, at F 30."""
    node = u32(phase + 2**25) >> 26
    t = i32(phase - (node << 26))
    d = round_shift(t * 1686629713, 30)
    q = product(d, d)
    c = 2**30 - product(q, 2**29 - product(q, 44739243))
    s = d - product(d, product(q, 178956971))
    ns, nc = _sine_of_node(node), _sine_of_node(node + 16)
    return product(ns, c) + product(nc, s), product(nc, c) - product(ns, s)


# Natural logarithm

R = [_nearest(2**30 / (1 + i / 16)) for i in range(17)]
L = [_nearest(2**30 * math.log(1 + i / 16)) for i in range(17)]


def logarithm(x, fraction):
    """ln(x / 2^fraction), x > 0, at F 26."""
    e = top(x)
    m = round_shift(x, e - 30) if e > 30 else x << (30 - e)
    node = round_shift(m - 2**30, 26)
    d = m - 2**30 - (node << 26)
    u = product(d, R[node])
    s = 2**28 - product(u, 214748365)
    s = 357913941 - product(u, s)
    s = 2**29 - product(u, s)
    s = 2**30 - product(u, s)
    logarithm_of_m = L[node] + product(u, s)
    return sat32(round_shift((e - fraction) * 762123384786 + (logarithm_of_m << 10), 14))


# Logistic and hyperbolic tangent

N = {i: _nearest(2**31 * (1 / (1 + math.exp(-i / 8)) - 0.5)) for i in range(-128, 129)}


def _near(node, d, order):
    """tanh(x / 2) at F 30, x at the distance d from a node."""
    h = N[node]
    square = upper(h, h)
    slope = 2**28 - square
    if order == 3:
        third = square - 0x05580000
    else:
        third = square - 0x05555555 + (upper(upper(h, 0x0AAAAAAB - square), d) >> 2)
    second = (upper(third, d) >> 2) - h
    first = slope + (upper(upper(slope, second), d) >> 2)
    return h + (upper(first, d) >> 2)


def _symmetric(x):
    p = x << 8
    return _near(round_shift(p, 32), i32(p), 4)


def logistic(x):
    """1 / (1 + exp(-x)): x at F 27, the result at F 30."""
    return 2**29 + round_shift(_symmetric(x), 1)


def tanh(x):
    """x at F 27, the result at F 30."""
    return _symmetric(sat32(2 * x))


def activation(p):
    """tanh(p / 2): p at F 35, the result at F 30."""
    return _near(clamp(round_shift(p, 32), -128, 127), i32(p), 3)


def sums_of_tables():
    """The sums that the specification gives for a check: E, T, R, L, N[1...128]."""
    return sum(E), sum(T), sum(R), sum(L), sum(N[i] for i in range(1, 129))


SUMS_OF_TABLES = (12663029612, 11465129380, 12717676515, 7005821586, 126062055176)
