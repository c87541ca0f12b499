#!/usr/bin/env python3
"""Writes chains.csv with mpmath (python3-mpmath), 80 digits: sequences of rotations and their motion.

A row is n, frame (0 body, 1 space), n times the axis, the angle and the rate; then, as hi and lo, the
matrix of the product, omega, the axes v_k in the space frame and the matrices dQ/dtheta_k. Omega is
the axial vector of (dQ/dt) Q^T and dQ/dtheta_k a derivative too: central differences of the product
of matrices N5 with steps of 1e-26, which are good to 1e-50. An axis v_k is that of the motion in
which its angle alone turns, at rate 1.
"""
import itertools
import pathlib
import random

from mpmath import cos, eye, matrix, mp, mpf, sin, sqrt

from make_reference import hexed, hi_lo

mp.dps = 80
STEP = mpf(10) ** -26
PI = 3.141592653589793
LETTERS = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]


def factor(axis, angle):
    v = matrix([mpf(a) for a in axis])
    n = v / sqrt(sum(a * a for a in v))
    cross = matrix([[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]])
    return cos(angle) * eye(3) + (1 - cos(angle)) * n * n.T + sin(angle) * cross


def product(axes, angles, space):
    q = eye(3)
    for axis, angle in zip(axes, angles):
        q = factor(axis, angle) * q if space else q * factor(axis, angle)
    return q


def derivative(axes, angles, rates, space):
    def moved(step):
        later = [mpf(a) + step * mpf(r) for a, r in zip(angles, rates)]
        return product(axes, later, space)

    return (moved(STEP) - moved(-STEP)) / (2 * STEP)


def axial(m):
    return [(m[2, 1] - m[1, 2]) / 2, (m[0, 2] - m[2, 0]) / 2, (m[1, 0] - m[0, 1]) / 2]


def row(axes, angles, rates, space):
    exact = [mpf(a) for a in angles]
    q = product(axes, exact, space)
    outputs = list(q) + axial(derivative(axes, angles, rates, space) * q.T)
    singles = [derivative(axes, angles, [i == k for i in range(len(axes))], space)
               for k in range(len(axes))]  # fmt: skip
    outputs += [x for d in singles for x in axial(d * q.T)] + [x for d in singles for x in d]
    inputs = [len(axes), space]
    for axis, angle, rate in zip(axes, angles, rates):
        inputs += [*axis, angle, rate]
    fields = [hexed(float(x)) for x in inputs]
    return ",".join(fields + [part for x in outputs for part in hi_lo(x)])


def cases():
    generator = random.Random(7)
    for letters in itertools.product(range(3), repeat=3):
        if letters[0] == letters[1] or letters[1] == letters[2]:
            continue
        axes = [LETTERS[i] for i in letters]
        for angles in ((0.5, -1.25, 2.75), (-3, PI / 2, 1), (1e-9, 3, -1e-12), (PI, 0.0, 100.0)):
            yield axes, angles, [generator.uniform(-2, 2) for _ in range(3)]
    for n in range(1, 7):
        for _ in range(4):
            yield (
                [tuple(generator.uniform(-1, 1) for _ in range(3)) for _ in range(n)],
                [generator.uniform(-7, 7) for _ in range(n)],
                [generator.uniform(-2, 2) for _ in range(n)],
            )
    yield [(1e-300, 2e-300, 5e-324), (1.7e308, -1.7e308, 1e308)], (1e15, -1e22), (0.25, 2)


def main():
    rows = [row(*case, space) for case in cases() for space in (0, 1)]
    header = "n,frame,then as make_sequences.py says"
    path = pathlib.Path(__file__).parent / "chains.csv"
    path.write_text("\n".join([header, *rows]) + "\n")


main()
