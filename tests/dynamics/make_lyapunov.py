#!/usr/bin/env python3
"""Writes lyapunov.csv with mpmath (python3-mpmath): finite-time exponents of [P15] in the charts.

omega = (cos a t, sin a t, 0), a = 2 pi/T as a double, from E0 = (1, 1, 1)/sqrt 3. The tangent map of
a chart is taken by central differences of the map from the chart's coordinates at 0 to those at t,
which knows nothing of Jacobians: with steps of 1e-16 and 60 digits it is good to some 30. Written
are log(s)/t of its three singular values, largest first, rounded to doubles.
"""
import math
import pathlib

from mpmath import atan2, cos, log, matrix, mp, mpf, sin, sqrt, svd_r, tan

mp.dps = 60
STEP = mpf(10) ** -16


def product(p, q):
    return (p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3],
            p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
            p[0] * q[2] + p[2] * q[0] + p[3] * q[1] - p[1] * q[3],
            p[0] * q[3] + p[3] * q[0] + p[1] * q[2] - p[2] * q[1])


def length(v):
    return sqrt(sum(x * x for x in v))


def turn(v):
    """The quaternion of a rotation vector."""
    angle = length(v)
    return (cos(angle / 2), *(x / angle * sin(angle / 2) for x in v))


def scaled(v, size):
    return [x * size / length(v) for x in v]


# To the chart from a quaternion whose angle is in (0, 2 pi), and back.
CHARTS = {
    "euler_vector": (lambda q: scaled(q[1:], 2 * atan2(length(q[1:]), q[0])), turn),
    "modified_gibbs": (lambda q: list(q[1:]), lambda m: (sqrt(1 - length(m) ** 2), *m)),
    "gibbs": (lambda q: [x / q[0] for x in q[1:]],
              lambda g: [x / sqrt(1 + length(g) ** 2) for x in (1, *g)]),
    "mrp": (lambda q: [x / (1 + q[0]) for x in q[1:]],
            lambda p: [x / (1 + length(p) ** 2) for x in (1 - length(p) ** 2, *(2 * y for y in p))]),
}


def exponents(chart, rate, t):
    to_chart, from_chart = CHARTS[chart]
    flow = product(turn((0, 0, rate * t)), turn((t, 0, -rate * t)))  # of theory 4.4
    start = to_chart(turn([1 / sqrt(mpf(3))] * 3))
    d = matrix(3, 3)
    for j in range(3):
        ends = []
        for sign in (1, -1):
            x = list(start)
            x[j] += sign * STEP
            ends.append(to_chart(product(flow, from_chart(x))))
        for i in range(3):
            d[i, j] = (ends[0][i] - ends[1][i]) / (2 * STEP)
    return [log(s) / t for s in svd_r(d, compute_uv=False)]


def main():
    lines = ["chart,period,t,first,second,third"]
    for chart in CHARTS:
        for period, t in [(40.0, 1e3), (40.0, 2e3), (40.0, 1e4), (40.0, 1e5), (math.pi, 400.0)]:
            values = exponents(chart, mpf(2 * math.pi / period), mpf(t))
            lines.append(",".join([chart, period.hex(), t.hex()] + [float(x).hex() for x in values]))
    path = pathlib.Path(__file__).with_name("lyapunov.csv")
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
