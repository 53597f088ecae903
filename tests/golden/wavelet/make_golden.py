#!/usr/bin/env python3
"""Writes the golden vectors beside this file: PyWavelets' filters, decompositions and
reconstructions, and threshold rules computed with numpy by full sorting.

    apt-get install python3-pywt python3-mpmath
    python3 tests/golden/wavelet/make_golden.py

The versions that made them are in the first line of each file. The symlets are transformed with
refined filters (refine() below), because PyWavelets' tables of sym2 to sym8 are orthonormal to
5e-12 only; its own taps are in filters.txt all the same.
"""
import os

import mpmath
import numpy as np
import pywt

FOLDER = os.path.dirname(os.path.abspath(__file__))
MADE_BY = f"# PyWavelets {pywt.__version__}, numpy {np.__version__}, mpmath {mpmath.__version__}\n"
FAMILIES = (
    ["haar"]
    + [f"db{i}" for i in range(2, 11)]
    + [f"sym{i}" for i in range(2, 11)]
    + [f"coif{i}" for i in range(1, 6)]
)
RULES = ["heursure", "sqtwolog", "rigrsure", "minimaxi"]


def refine(taps):
    """Newton's method in 40 digits on orthonormality and vanishing moments of a symlet."""
    mpmath.mp.dps = 40
    n = len(taps)
    half = n // 2
    h = mpmath.matrix([mpmath.mpf(tap) for tap in taps])
    moment = lambda i, m: (-1) ** i * (mpmath.mpf(2 * i - n + 1) / n) ** m
    for _ in range(6):
        residual = mpmath.matrix(n, 1)
        jacobian = mpmath.matrix(n, n)
        for k in range(half):
            residual[k] = sum(h[i] * h[i + 2 * k] for i in range(n - 2 * k)) - (k == 0)
            residual[half + k] = sum(moment(i, k) * h[i] for i in range(n))
            for i in range(n):
                above = h[i + 2 * k] if i + 2 * k < n else 0
                below = h[i - 2 * k] if i >= 2 * k else 0
                jacobian[k, i] = above + below
                jacobian[half + k, i] = moment(i, k)
        h -= mpmath.lu_solve(jacobian, residual)
    return [float(tap) for tap in h]


def wavelet(name):
    own = pywt.Wavelet(name)
    if not name.startswith("sym"):
        return own
    low = np.array(refine(own.dec_lo))
    high = low[::-1] * np.where(np.arange(len(low)) % 2 == 0, -1, 1)
    return pywt.Wavelet(name, filter_bank=[low, high, low[::-1], high[::-1]])


def signal(size):
    """The same integers in every language."""
    i = np.arange(size, dtype=np.int64)
    return (((i * i * 7919 + i * 104729 + 31) % 2003) - 1001) / 1024.0


def line(name, values):
    return " ".join([name] + [f"{value:.17g}" for value in np.atleast_1d(values)]) + "\n"


def rigrsure(x):
    squares = np.sort(np.abs(x)) ** 2
    n = len(x)
    k = np.arange(1, n + 1)
    risks = n - 2 * k + np.cumsum(squares) + (n - k) * squares
    return np.sqrt(squares[np.argmin(risks)])


def threshold(rule, x):
    n = len(x)
    universal = np.sqrt(2 * np.log(n))
    if rule == "sqtwolog":
        return universal
    if rule == "minimaxi":
        return 0.0 if n <= 32 else 0.3936 + 0.1829 * np.log2(n)
    if rule == "rigrsure":
        return rigrsure(x)
    excess = np.mean(x**2) - 1
    if excess < np.log2(n) ** 1.5 / np.sqrt(n):
        return universal
    return min(universal, rigrsure(x))


def write(name, lines):
    with open(os.path.join(FOLDER, name), "w", encoding="ascii") as out:
        out.write(MADE_BY)
        out.writelines(lines)


def main():
    write("filters.txt", [line(name, pywt.Wavelet(name).dec_lo) for name in FAMILIES])

    lines = []
    for name in FAMILIES:
        for mode in ["symmetric", "periodic"]:
            for size, levels in [(1, 1), (2, 2), (7, 1), (15, 2), (16, 1), (17, 3), (33, 2)]:
                parts = pywt.wavedec(signal(size), wavelet(name), mode=mode, level=levels)
                lines.append(f"case {name} {mode} {size} {levels}\n")
                lines.append(line("approximation", parts[0]))
                lines += [line("detail", part) for part in parts[:0:-1]]
    write("decompositions.txt", lines)

    lines = []
    for size in [1, 2, 5, 31, 33, 64, 100, 1000]:
        # Noise of about 1 alone, and with a strong signal in a tenth of the values.
        for strength in [0, 30]:
            x = signal(size) * 1.7
            x[::10] *= 1 + strength
            lines.append(f"case {size} {strength}\n")
            lines.append(line("noise", np.median(np.abs(x)) / 0.6745))
            for rule in RULES:
                for sigma in [1.0, 0.37]:
                    lines.append(line(f"{rule} {sigma}", sigma * threshold(rule, x / sigma)))
    write("thresholds.txt", lines)

    lines = []
    ramp = 4 * np.sin(np.arange(700) / 60.0)
    for name, mode in [("sym8", "symmetric"), ("db3", "periodic"), ("coif2", "symmetric")]:
        for rule in RULES:
            for shrink in ["soft", "hard"]:
                parts = pywt.wavedec(signal(700) + ramp, wavelet(name), mode=mode, level=4)
                for i in range(1, len(parts)):
                    sigma = np.median(np.abs(parts[i])) / 0.6745
                    limit = sigma * threshold(rule, parts[i] / sigma)
                    # rigrsure chooses a coefficient's own magnitude, which does not pass it;
                    # the margin keeps that clear of the rounding of sigma.
                    if shrink == "hard":
                        parts[i] = parts[i] * (np.abs(parts[i]) > limit * (1 + 1e-12))
                    else:
                        parts[i] = pywt.threshold(parts[i], limit, shrink)
                result = pywt.waverec(parts, wavelet(name), mode=mode)[:700]
                lines.append(f"case {name} {mode} {rule} {shrink}\n")
                lines.append(line("result", result[::7]))
    write("denoised.txt", lines)


main()
