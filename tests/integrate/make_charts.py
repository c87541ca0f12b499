#!/usr/bin/env python3
"""Writes charts.csv with mpmath (python3-mpmath): the rates of the charts, to 60 digits.

Inputs are doubles, exact, as C hex floats: y (its first three or four numbers) and omega. An output
is the nearest double to a component of y'. Each is worked out from what the chart means, not from
its formula in the paper: omega gives the rate of the unit quaternion, q' = omega q / 2, and that
the rates of theta = 2 atan2(|M|, M0) and n = M/|M|, whence E = n theta, G = M/M0, F = n f(theta).
"""
import math
import pathlib
import random

from mpmath import asin, atan, cos, mp, mpf, sin, sqrt

mp.dps = 700  # 1e-300 squared beside 1, and 60 digits more

random.seed(4)
OMEGAS = [(0.3, -1.1, 0.7), (1e-3, 2.0, 0.0)]
PI = math.pi
ANGLES = [1e-300, 1e-150, 1e-20, 1e-8, 1e-4, 0.02, 0.7, 1.9, 3, PI - 1e-4, PI - 1e-9, PI, PI + 1e-6, 4.5,
          2 * PI - 1e-2, 2 * PI - 1e-6, 2 * PI - 1e-12]
BEYOND = [2 * PI + 1e-12, 2 * PI + 1e-5, 7, 9.4, 15, 200]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def axis_angle_rates(n, theta, omega):
    m0, s = cos(theta / 2), sin(theta / 2)
    m = [s * x for x in n]
    dm0 = -dot(omega, m) / 2
    dm = [(m0 * w + c) / 2 for w, c in zip(omega, cross(omega, m))]
    dtheta = 2 * (dot(n, dm) * m0 - s * dm0)
    along = dot(n, dm)
    dn = [(d - along * x) / s for d, x in zip(dm, n)]
    return dn, dtheta


def unit(y):
    size = sqrt(dot(y, y))
    return [x / size for x in y], size


def euler(y, omega):
    n, theta = unit(y)
    dn, dtheta = axis_angle_rates(n, theta, omega)
    return [dtheta * x + theta * d for x, d in zip(n, dn)]


def gibbs(y, omega):
    n, size = unit(y)
    dn, dtheta = axis_angle_rates(n, 2 * atan(size), omega)
    return [dtheta * (1 + size**2) / 2 * x + size * d for x, d in zip(n, dn)]


def axis_angle(y, omega):
    n, size = unit(y[:3])
    dn, dtheta = axis_angle_rates(n, y[3], omega)
    return [size * d for d in dn] + [dtheta]


def generalized(inverse, slope):
    def rate(y, omega):
        n, f = unit(y)
        theta = inverse(f)
        dn, dtheta = axis_angle_rates(n, theta, omega)
        return [slope(theta) * dtheta * x + f * d for x, d in zip(n, dn)]

    return rate


def inverse_of_cubic(f):
    # theta + theta^3/10 = f
    start = f if f < 1 else (10 * f) ** (mpf(1) / 3)
    theta = start
    for _ in range(80):
        theta = theta - (theta + theta**3 / 10 - f) / (1 + 3 * theta**2 / 10)
    return theta


cubic = generalized(inverse_of_cubic, lambda theta: 1 + 3 * theta**2 / 10)
half_sine = generalized(lambda f: 2 * asin(f / 2), lambda theta: cos(theta / 2))
half_tangent = generalized(lambda f: 2 * atan(f), lambda theta: 1 / cos(theta / 2) ** 2 / 2)


def random_axis():
    v = [random.gauss(0, 1) for _ in range(3)]
    size = math.sqrt(dot(v, v))
    return [x / size for x in v]


def rows():
    for theta in ANGLES + BEYOND:
        for omega in OMEGAS:
            n = random_axis()
            f = theta + theta**3 / 10
            yield "euler", euler, [x * theta for x in n], omega
            yield "axis_angle", axis_angle, n + [theta], omega
            yield "axis_angle", axis_angle, n + [-theta], omega
            yield "cubic", cubic, [x * f for x in n], omega
            if theta < PI:
                g = math.tan(theta / 2)
                yield "gibbs", gibbs, [x * g for x in n], omega
                yield "half_tangent", half_tangent, [x * g for x in n], omega
                if theta < 3.1:
                    yield "half_sine", half_sine, [x * 2 * math.sin(theta / 2) for x in n], omega


with open(pathlib.Path(__file__).with_name("charts.csv"), "w", newline="\n") as out:
    out.write("equation,y_1,y_2,y_3,y_4,omega_x,omega_y,omega_z,dy_1,dy_2,dy_3,dy_4\n")
    for name, rate, y, omega in rows():
        dy = rate([mpf(x) for x in y], [mpf(w) for w in omega])
        pad = [0.0] * (4 - len(y))
        numbers = [*y, *pad, *omega, *[float(x) for x in dy], *pad]
        out.write(",".join([name] + [float(x).hex() for x in numbers]) + "\n")
