#!/usr/bin/env python3
"""Writes turning.csv with mpmath (python3-mpmath): U(t) of an omega constant in a turning frame.

omega(t) is v turned about k by the angle a t, k = about/|about|. Inputs are doubles, exact, as C hex
floats: v, about, a, t0, t. The output is the quaternion that takes the attitude from t0 to t,
rounded to doubles: R(t) exp((v - a k)(t - t0)/2) R(t0)*, R(t) = exp(k a t/2), with 50 digits or
more after the point. For moderate cases the product is checked against a Taylor integration of
the equation of motion itself, so that the table does not rest on the closed form alone.
"""
import math
import pathlib

from mpmath import cos, matrix, mp, mpf, norm, sin

I, J, K = (1, 0, 0), (0, 1, 0), (0, 0, 1)
D = (0.6, 0.0, 0.8)      # unit only to double
E = (0.5, -0.5, 0.70710678118654757)
TIMES = [(0, 0), (0, 1), (1, 0), (0, 1e-300), (1e-300, 0), (0, -3.5), (-2, 40), (0, 1e5), (1e5, 0),
         (1e5, 1e5 + 1), (0, 1e9), (1e9, 0), (1e9, 1e9 + 1.5), (1e9, -1e9), (-1e9, 1)]
SPINS = [  # v, about, rate
    (I, K, 2 * math.pi / 40), (I, K, 2 * math.pi / math.pi), (I, K, 100), (I, K, -0.75),
    (I, K, 0), (I, K, 1e-300), (I, K, 1e-9), (I, K, 1e9), (I, K, -1e12),
    (K, K, 2), (K, K, 1), ((0, 0, -1), K, 1),          # v parallel to k; omega = rate k
    ((0, 0, 0.5), K, 0.5), (D, D, 1), (J, D, 0.3), ((0.1, 0.2, -0.3), E, 1.7),
    ((1e-8, 0, 1e-8), J, 1e-3), ((1e-300, 0, 0), K, 1e-300), ((1e6, 0, 2e6), K, 3e5),
    ((5e-324, 0, 0), I, 5e-324), ((0, 0, 0), E, 1.7),
    # k in no double: at t = 1e9 its rounding to one would be 1e-7 rad.
    (I, (1, 1, 1), 1.7), (J, (3, -2, 7), 0.3), ((0.1, 0.2, -0.3), (1e-310, 2e-310, -1e-310), 1),
    (K, (1e300, 1e300, 0), 2),
]


def times(p, q):
    a, b, c, d = p
    e, f, g, h = q
    return (a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g,
            a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e)


def turn(v, t):  # exp(v t / 2)
    size = norm(matrix(v))
    if size == 0:
        return (mpf(1), mpf(0), mpf(0), mpf(0))
    s = sin(size * t / 2) / size
    return (cos(size * t / 2), v[0] * s, v[1] * s, v[2] * s)


def exact(v, about, a, t0, t):
    v = [mpf(x) for x in v]
    size = norm(matrix([mpf(x) for x in about]))
    k = [mpf(x) / size for x in about]
    p = [x - mpf(a) * y for x, y in zip(v, k)]
    frame = [mpf(a) * y for y in k]
    back = turn(frame, -mpf(t0))
    return times(turn(frame, mpf(t)), times(turn(p, mpf(t) - mpf(t0)), back))


def integrated(v, about, a, t0, t, steps=16, order=40):
    """U' = omega U / 2 by Taylor series: omega' = a k x omega gives its coefficients."""
    size = norm(matrix([mpf(x) for x in about]))
    k = [mpf(a) * mpf(x) / size for x in about]
    u, h = (mpf(1), mpf(0), mpf(0), mpf(0)), (mpf(t) - mpf(t0)) / steps
    for i in range(steps):
        r = turn(k, mpf(t0) + i * h)
        w = [times(times(r, (0, *map(mpf, v))), (r[0], -r[1], -r[2], -r[3]))]
        c = [u]
        for n in range(order):
            x = w[n][1:]
            w.append((0, *((k[(j + 1) % 3] * x[(j + 2) % 3] - k[(j + 2) % 3] * x[(j + 1) % 3])
                           / (n + 1) for j in range(3))))
            terms = [times(w[m], c[n - m]) for m in range(n + 1)]
            c.append(tuple(sum(term[j] for term in terms) / (2 * (n + 1)) for j in range(4)))
        u = tuple(sum(c[n][j] * h ** n for n in range(order + 1)) for j in range(4))
    return u


def main():
    mp.dps = 60
    for spin in [SPINS[0], SPINS[1], SPINS[14], SPINS[15]]:
        for t0, t in [(0, 1), (1, 0), (-2, 1)]:
            a, b = exact(*spin, t0, t), integrated(*spin, t0, t)
            assert max(abs(x - y) for x, y in zip(a, b)) < mpf(10) ** -40, (spin, t0, t)
    mp.dps = 90  # angles have up to 22 digits before the point
    path = pathlib.Path(__file__).with_name("turning.csv")
    with open(path, "w", newline="\n") as out:
        out.write("v_x,v_y,v_z,about_x,about_y,about_z,rate,t0,t,w,x,y,z\n")
        for v, about, a in SPINS:
            for t0, t in TIMES:
                row = [*v, *about, a, t0, t, *exact(v, about, a, t0, t)]
                out.write(",".join(float(x).hex() for x in row) + "\n")


main()
