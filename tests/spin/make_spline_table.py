#!/usr/bin/env python3
"""Writes cubic_splines.csv: not-a-knot cubic splines through awkward samples, by mpmath.

The spline is found here as the solution of its defining equations, four unknown coefficients an
interval, in 50 digits (python3-mpmath), and held against SciPy's CubicSpline (python3-scipy).
Columns: the number of the spline, then either "knot", t, value or "value", t, value; doubles as C
hex floats, values rounded once.
"""
import pathlib
import random

from mpmath import lu_solve, matrix, mp, mpf
from scipy.interpolate import CubicSpline

mp.dps = 50
RANDOM = random.Random(4)


def random_knots(count, ratio):
    """Intervals over `ratio` decades."""
    t = [RANDOM.uniform(-5, 5)]
    for _ in range(count - 1):
        t.append(t[-1] + 10 ** RANDOM.uniform(-ratio, 0))
    return t, [RANDOM.uniform(-3, 3) for _ in t]


SPLINES = [
    ([0.0, 2.0], [1.0, -1.0]),
    ([0.0, 1.0, 3.0], [0.5, -1.0, 2.0]),
    ([0.0, 1.0, 1.5, 4.0], [0.0, 1.0, -1.0, 0.25]),
    random_knots(5, 0),
    random_knots(12, 1),
    random_knots(25, 2),
]


def coefficients(t, v):
    """a, b, c, d of each interval, a + b s + c s^2 + d s^3 with s = t - t_i."""
    n = len(t) - 1
    h = [mpf(t[i + 1]) - mpf(t[i]) for i in range(n)]
    rows, right = [], []

    def add(entries, value):
        row = [mpf(0)] * (4 * n)
        for place, entry in entries.items():
            row[place] += entry
        rows.append(row)
        right.append(value)

    for i in range(n):
        add({4 * i: 1}, mpf(v[i]))
        add({4 * i: 1, 4 * i + 1: h[i], 4 * i + 2: h[i]**2, 4 * i + 3: h[i]**3}, mpf(v[i + 1]))
    for i in range(n - 1):
        add({4 * i + 1: 1, 4 * i + 2: 2 * h[i], 4 * i + 3: 3 * h[i]**2, 4 * i + 5: -1}, 0)
        add({4 * i + 2: 1, 4 * i + 3: 3 * h[i], 4 * i + 6: -1}, 0)
    if n == 1:  # a line
        add({2: 1}, 0)
        add({3: 1}, 0)
    elif n == 2:  # one parabola
        add({3: 1}, 0)
        add({7: 1}, 0)
    else:
        add({3: 1, 7: -1}, 0)
        add({4 * n - 5: 1, 4 * n - 1: -1}, 0)
    return lu_solve(matrix(rows), matrix(right))


with open(pathlib.Path(__file__).parent / "cubic_splines.csv", "w", encoding="ascii") as out:
    for number, (times, values) in enumerate(SPLINES):
        c = coefficients(times, values)
        other = CubicSpline(times, values)  # bc_type "not-a-knot"
        for t, v in zip(times, values):
            out.write(f"{number},knot,{t.hex()},{v.hex()}\n")
        for i in range(len(times) - 1):
            for part in (0.25, 0.5, 0.875):
                t = times[i] + part * (times[i + 1] - times[i])
                s = mpf(t) - mpf(times[i])
                true = c[4 * i] + s * (c[4 * i + 1] + s * (c[4 * i + 2] + s * c[4 * i + 3]))
                assert abs(true - mpf(float(other(t)))) < 1e-9 * (1 + abs(true)), (number, t)
                out.write(f"{number},value,{t.hex()},{float(true).hex()}\n")
