"""Writes quaternion_functions.csv beside this file: exp, log and a power of quaternions. Run it
after a change: python3 make_quaternion_reference.py (needs python3-mpmath).

Columns as in make_reference.py. The power is e^(x log q), the definition for every x.
"""
import math
import random

from make_reference import TINY, names, row, write
from mpmath import atan2, cos, exp, log, mp, mpf, pi, sin, sqrt

mp.dps = 400  # cos of 1e300
EPS = 2.0**-52

UNITS = [
    (0, 1, 0, 0), (0, 0, -1, 0), (0.5, 0.5, -0.5, 0.5), (0.6, 0, 0.8, 0), (-0.8, 0, 0, 0.6),
    (1, 1e-8, 0, 0), (-1, 0, 1e-8, 0), (1, 0, 0, 1e-160), (-1, 3e-17, -1e-17, 0),
    (1 + EPS, 0, 0, 0), (1 - EPS / 2, 0, EPS, 0), (-1 - EPS, 0, 0, EPS), (math.cos(1), math.sin(1), 0, 0),
    (EPS, -1, 0, 0), (math.sqrt(0.5), 0, 0, -math.sqrt(0.5)),
]  # fmt: skip
ANY = [
    (1, 2, 3, 4), (-3, 0.25, 0, 1e-5), (2, 0, 0, 0), (-2, 0, 0, 0), (1e-3, 1e-3, 0, 0), (-1e-9, 0, 2e-9, 0),
    (700, 1, -2, 3), (-700, 3, 0, 0), (0.1, 30, 40, 0), (0, 1e15, 0, 0), (0.25, TINY, 0, 0), (1, TINY, 0, -TINY),
]  # fmt: skip
EXPONENTS = [0, 1, -1, 2, 3, -5, 17, 100, 0.5, -0.5, 1 / 3, 2.5, 1e-3, -7.25, 1e-200]


def random_quaternions(count):
    generator = random.Random(22)
    for _ in range(count):
        size = 10 ** generator.uniform(-2, 1.5)
        yield tuple(size * generator.uniform(-1, 1) for _ in range(4))


def imaginary(q):
    v = [mpf(c) for c in q[1:]]
    return v, sqrt(sum(c * c for c in v))


def exp_of(q):
    v, length = imaginary(q)
    size = exp(mpf(q[0]))
    return [size * cos(length), *(size * (sin(length) / length if length else 1) * c for c in v)]


def log_of(q):
    v, length = imaginary(q)
    if not length:
        return [log(abs(mpf(q[0]))), pi if q[0] < 0 else mpf(0), mpf(0), mpf(0)]
    half = atan2(length, mpf(q[0]))
    return [log(sqrt(mpf(q[0]) ** 2 + length**2)), *(half * c / length for c in v)]


def power(q, x):
    return exp_of([mpf(x) * c for c in log_of(q)])


def cases():
    for q in [*UNITS, *ANY[:6], *random_quaternions(20)]:
        for x in EXPONENTS:
            yield q, x
    for q in ANY[6:]:
        yield q, 0.75
    for size in (1e-300, 1e-160, 1e150, 1e300):
        for x in (1, 0.5, -0.5, -1, 1.01 if size > 1e200 else 0.99):
            yield (0.3 * size, -0.4 * size, 1.2 * size, 0), x


def rows():
    for q, x in cases():
        # e^(large) is the power's business only: there the argument is one of a logarithm.
        exponential = exp_of(q) if abs(q[0]) < 708 and max(map(abs, q[1:])) <= 1e15 else [mpf(0)] * 4
        yield row((*q, x), exponential + log_of(q) + power(q, x))


header = ["w", "x", "y", "z", "exponent"]
for name in ("exp", "log", "power"):
    header += names(name, "wxyz")
write("quaternion_functions.csv", header, rows())
