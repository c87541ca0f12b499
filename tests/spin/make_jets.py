#!/usr/bin/env python3
"""Writes jets.csv with mpmath (python3-mpmath): Taylor coefficients of functions to 40 digits.

A row: the function's name in jet_test.cpp, t, and for k = 0 to 8 the coefficient and its scale. The
coefficients come from numerical derivatives in 100 digits, not from the recurrences of the program.

The scale of coefficient k is Cauchy's bound M/r^k, the least over circles |z - t| = r: of the
greatest modulus of the function, and of all that it is made of, on the circle.
"""
import pathlib

from mpmath import acos, asin, atan, cos, e, exp, floor, j, log, mp, mpf, pi, sin, sqrt, tan, taylor

mp.dps = 100
ORDER = 8

# Name: f(z), what it is made of, the points t, and how far the nearest singularity is.
FAR = lambda t: mpf(16)
FUNCTIONS = {
    "waves": (
        lambda z: sin(3 * z) + mpf(0.3) * cos(17 * z),
        [lambda z: z, lambda z: sin(3 * z), lambda z: 17 * z, lambda z: cos(17 * z)],
        [0, 0.25, -1.5, 40, 1e6], FAR),
    "chirp": (
        lambda z: exp(-z / 50) * cos(z * z / 40),
        [lambda z: z, lambda z: exp(-z / 50), lambda z: z * z / 40, lambda z: cos(z * z / 40)],
        [0, 1, 7.5, -30, 49], FAR),
    "log1p": (lambda z: log(1 + z) / 2, [lambda z: 1 + z], [0, 0.5, -0.75, 1e3],
              lambda t: 1 + t),
    "log10": (lambda z: log(z) / log(10), [lambda z: z, log], [1, 0.01, 300], lambda t: t),
    "log_to_t": (lambda z: log(3) / log(z), [lambda z: z, lambda z: 1 / log(z), log],
                 [2, 0.25, 30], lambda t: min(t, abs(t - 1))),
    "root": (lambda z: sqrt(1 + z * z), [lambda z: z, lambda z: 1 + z * z], [0, 0.5, -2, 1e4],
             lambda t: abs(t + j)),
    "tan": (tan, [lambda z: z, lambda z: 1 + tan(z) ** 2], [0, 0.5, 1.5, -3, 100],
            lambda t: min(abs(t - (n + mpf(1) / 2) * pi) for n in range(-40, 40))),
    "asin": (asin, [lambda z: 1 / sqrt(1 - z * z), lambda z: sqrt(1 - z * z)],
             [0, 0.5, -0.75, 0.999], lambda t: 1 - abs(t)),
    "acos": (acos, [lambda z: 1 / sqrt(1 - z * z), lambda z: sqrt(1 - z * z)],
             [0, 0.5, -0.75, 0.999], lambda t: 1 - abs(t)),
    "atan": (atan, [lambda z: z, lambda z: 1 / (1 + z * z), lambda z: 1 + z * z],
             [0, 0.5, -2, 100], lambda t: abs(t + j)),
    # The angle of (cos z, sin z/2), its derivative (1/2)/(cos^2 z + sin^2 z/4): singular where
    # tan z = +-2i, at distance atanh(1/2) above pi/2.
    "atan2": (lambda z: atan(tan(z) / 2) + pi * floor(mp.re(z) / pi + mpf(0.5)),
              [lambda z: 1 / (cos(z) ** 2 + sin(z) ** 2 / 4), lambda z: mpf(4)],
              [0, 0.5, 2.5], lambda t: mpf(1) / 2),
    "power": (lambda z: z ** mpf(2.5), [lambda z: z], [1, 0.01, 300], lambda t: t),
    "inverse_cube": (lambda z: z ** -3, [lambda z: z, lambda z: 1 / z], [1, -0.5, 30],
                     lambda t: abs(t)),
    "exponential": (lambda z: mpf(2) ** z, [lambda z: z, lambda z: z * log(2)], [0, 1, -20, 50],
                    FAR),
    "tower": (lambda z: z ** z, [lambda z: z, log, lambda z: z * log(z)], [1, 0.5, 5],
              lambda t: t),
    "witch": (lambda z: 1 / (1 + z * z), [lambda z: z, lambda z: 1 + z * z], [0, 1, -3, 1e5],
              lambda t: abs(t + j)),
}  # fmt: skip


def scales(pieces, t, distance):
    best = [mpf("inf")] * (ORDER + 1)
    for halvings in range(1, 12):
        r = distance / 2**halvings
        circle = [t + r * e ** (2j * pi * n / 64) for n in range(64)]
        m = max(abs(piece(z)) for piece in pieces for z in circle)
        best = [min(b, m / r**k) for k, b in enumerate(best)]
    return best


def main():
    rows = ["function,t" + "".join(f",c{k},scale{k}" for k in range(ORDER + 1))]
    for name, (f, pieces, points, distance) in FUNCTIONS.items():
        for t in map(mpf, points):
            c = taylor(f, t, ORDER)
            mp.dps = 30
            s = scales([*pieces, f], t, distance(t))
            mp.dps = 100
            pairs = ((mp.nstr(mp.re(a), 40), mp.nstr(b, 3)) for a, b in zip(c, s))
            rows.append(f"{name},{float(t).hex()}" + "".join(f",{a},{b}" for a, b in pairs))
    path = pathlib.Path(__file__).with_name("jets.csv")
    path.write_text("\n".join(rows) + "\n")


if __name__ == "__main__":
    main()
