#!/usr/bin/env python3
"""Writes tables of how rotations move with mpmath (python3-mpmath), as make_reference.py does.

    rates.csv       the angular velocity of an axis and an angle at given rates
    jacobians.csv   the left Jacobian of the exponential map and its inverse
    splines.csv     two C2 splines through four rotations: quaternion, omega, acceleration

Each comes from other formulas than those of the program: omega and acceleration from the
derivatives of the quaternion, Jacobians from the power series of exp and a general inverse, the
splines from a general solver of nonlinear equations.
"""
import math
import random

from make_reference import AXES, PI, TINY, names, product, quaternion, row, unit, write
from mpmath import cos, diff, eye, findroot, inverse, matrix, mp, mpf, sin, sqrt



def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def moving(axis, angle, angle_rate, axis_rate):
    """2 q' q*, of q = (cos theta/2, u sin theta/2)."""
    u, half = unit(axis), mpf(angle) / 2
    rate = [mpf(x) for x in axis_rate]
    along = dot(u, rate)
    rate = [x - along * a for x, a in zip(rate, u)]
    q_rate = [-sin(half) * mpf(angle_rate) / 2]
    q_rate += [x * sin(half) + a * cos(half) * mpf(angle_rate) / 2 for x, a in zip(rate, u)]
    return [2 * x for x in product(q_rate, conjugate(quaternion(axis, angle)))[1:]]


def perpendicular(axis, v):
    """A vector of doubles perpendicular to the axis, as far as doubles can be."""
    u, v = unit(axis), [mpf(x) for x in v]
    along = dot(u, v)
    return [float(x - along * a) for x, a in zip(v, u)]


def movements():
    generator = random.Random(23)
    angles = [0.0, TINY, 1e-300, 1e-8, 0.5, PI / 2, 3.0, PI, -4.0, 2 * PI, 7.0, 1e6, -1e15, 1e22]
    for axis in [*AXES[:6], (1e-9, -1, 0), (1, 2, 3), (1e200, -2e200, 3e200), (-2, 1, 7)]:
        for angle in angles:
            v = [generator.uniform(-1, 1) for _ in range(3)]
            yield axis, angle, generator.uniform(-2, 2), perpendicular(axis, v)
    yield (1, 2, 3), 1.0, 0.0, [0.0, 0.0, 0.0]
    yield (1, 2, 3), 1.0, 1e300, perpendicular((1, 2, 3), (1e300, 0, 0))
    yield (0, 0, 1), 1.0, 1e-320, [1e-320, -TINY, 0.0]


def skew(v):
    x, y, z = (mpf(a) for a in v)
    return matrix([[0, -z, y], [z, 0, -x], [-y, x, 0]])


def left_jacobian(v):
    theta, k = sqrt(dot([mpf(a) for a in v], [mpf(a) for a in v])), skew(v)
    if theta > 40:
        return eye(3) + (1 - cos(theta)) / theta**2 * k + (theta - sin(theta)) / theta**3 * k * k
    term, total, n = eye(3), eye(3), 1
    while n < 4 * theta + 60:
        n += 1
        term = term * k / n
        total += term
    return total


def euler_vectors():
    generator = random.Random(24)
    lengths = [TINY, 1e-300, 1e-20, 1e-8, 1e-4, 0.1, 1.5, 2.9999, 3.0001, PI, 4.5, 6.28, 6.2831853]
    lengths += [6.29, 9.0, 12.5, 30.0, 100.0, 1e4, 1e9, 1e15]
    for length in lengths:
        for axis in [(1, 0, 0), (0, -1, 0), (1, 1e-9, -1e-9)]:
            yield [length * a for a in axis]
        for _ in range(3):
            v = [generator.uniform(-1, 1) for _ in range(3)]
            yield [length * a / math.hypot(*v) for a in v]
    yield [0.0, 0.0, 0.0]


# Unit axes that are exact in doubles; the test has the same.
TIMES = [0.0, 1.0, 1.5, 4.0]
ROTATIONS = [((1, 0, 0), 0.3), ((0, 1, 0), 1.1), ((0, 0, 1), -0.9), ((1, 0, 0), -2.0)]
END_RATES = [(0.5, -1.0, 0.25), (-0.75, 0.0, 1.5)]


def exponential(phi):
    theta = sqrt(dot(phi, phi))
    s = mpf(1) / 2 if theta == 0 else sin(theta / 2) / theta
    return [cos(theta / 2), *(s * x for x in phi)]


def logarithm(q):
    if q[0] < 0:
        q = [-x for x in q]
    size = sqrt(dot(q[1:], q[1:]))
    return [2 * mp.atan2(size, q[0]) * x / size for x in q[1:]]


class Spline:
    """Segments R_i exp(phi_i): phi_i is the cubic from 0 to turn_i with rates a_i and b_i at its
    ends, the unknowns of the equations."""

    def __init__(self, end_rates):
        self.nodes = [quaternion(*r) for r in ROTATIONS]
        self.turns = [
            logarithm(product(conjugate(p), q)) for p, q in zip(self.nodes, self.nodes[1:])
        ]
        self.spans = [mpf(b) - mpf(a) for a, b in zip(TIMES, TIMES[1:])]
        start = []
        for turn, h in zip(self.turns, self.spans):
            start += [x / h for x in turn] * 2
        self.end_rates = end_rates
        self.x = findroot(lambda *x: self.defects(x), start, tol=1e-60)

    def phi(self, x, i, t):
        a, b = x[6 * i : 6 * i + 3], x[6 * i + 3 : 6 * i + 6]
        h = self.spans[i]
        s = t / h
        return [
            h * p * s * (1 - s) ** 2 + f * s * s * (3 - 2 * s) - h * q * s * s * (1 - s)
            for p, f, q in zip(a, self.turns[i], b)
        ]

    def moves(self, x, i, t):
        """q and, in the space frame, omega = 2 q' q* and the vector part of 2 q'' q*."""

        def attitude(s):
            return product(self.nodes[i], exponential(self.phi(x, i, s)))

        q = attitude(t)
        rates = []
        for order in (1, 2):
            d = [diff(lambda s, k=k: attitude(s)[k], t, order) for k in range(4)]
            rates.append([2 * c for c in product(d, conjugate(q))[1:]])
        return q, rates[0], rates[1]

    def defects(self, x):
        ends = [(self.moves(x, i, 0), self.moves(x, i, h)) for i, h in enumerate(self.spans)]
        out = []
        for (_, before), (after, _) in zip(ends, ends[1:]):
            for k in (1, 2):
                out += [p - q for p, q in zip(before[k], after[k])]
        first, last = ends[0][0], ends[-1][1]
        if self.end_rates:
            for given, found in zip(self.end_rates, (first[1], last[1])):
                out += [f - g for f, g in zip(found, given)]
        else:
            out += [*first[2], *last[2]]
        return out

    def at(self, t):
        i = max(k for k in range(len(self.spans)) if TIMES[k] <= t)
        q, omega, acceleration = self.moves(self.x, i, mpf(t) - TIMES[i])
        return [*q, *omega, *acceleration]


def main():
    write("rates.csv", [
        "x", "y", "z", "angle", "angle_rate", "axis_rate_x", "axis_rate_y", "axis_rate_z",
        *names("omega", "xyz"),
    ], [
        row((*axis, angle, angle_rate, *axis_rate), moving(axis, angle, angle_rate, axis_rate))
        for axis, angle, angle_rate, axis_rate in movements()
    ])  # fmt: skip

    entries = [i + j for i in "123" for j in "123"]
    jacobians = []
    for v in euler_vectors():
        with mp.workdps(150):
            j = left_jacobian(v)
            jacobians.append(row(v, [*j, *inverse(j)]))
    write("jacobians.csv", ["x", "y", "z", *names("left", entries), *names("inverse", entries)],
          jacobians)  # fmt: skip

    rows = []
    with mp.workdps(100):  # a second difference keeps half of the digits
        for natural in (1, 0):
            spline = Spline(None if natural else END_RATES)
            for t in [0.0, 0.25, 1.0, 1.25, 1.5, 2.0, 3.5, 4.0]:
                rows.append(row((natural, t), spline.at(t)))
    header = ["natural", "t", *names("q", "wxyz"), *names("omega", "xyz")]
    write("splines.csv", header + names("acceleration", "xyz"), rows)


if __name__ == "__main__":
    main()
