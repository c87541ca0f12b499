#!/usr/bin/env python3
"""Writes turns.csv with mpmath (python3-mpmath): the quaternion of a turn about a constant omega.

Inputs are doubles, exact, as C hex floats: omega, t0, t. An output is the nearest double to the
component of exp(omega (t - t0) / 2), worked out to 90 digits or more after the point.
"""
import math
import pathlib

from mpmath import cos, mp, mpf, sin, sqrt

TURNS = [  # omega, t0, t
    ((0, 0, 1), 0, 1), ((0, 0, 1), 0, -1), ((0, 0, 1), 0, math.pi), ((0, 0, -1), 0, 2 * math.pi),
    ((0, 0, 1), 0, 1e9), ((0, 0, 1), 0, -1e9), ((0, 0, 1), 1e9, -1e9),
    ((0, 0, 0), 0, 1e9), ((0, 0, 0), -3, 5),
    ((1, 2, 3), 0, 0.1), ((1, 2, 3), 0, 7.25), ((1, -2, 0.3), 1.5, -40), ((1, -2, 0.3), 1e9, 1e9 + 1),
    ((0.1, 0.7, -0.3), 0, 1e9), ((0.1, 0.7, -0.3), 1e9, 0), ((1e3, 1e-3, 1), 0, 1e6),
    ((5e-324, 0, 0), 0, 1), ((5e-324, 0, 0), 0, 1e9), ((5e-324, 5e-324, 0), 0, 1e300),
    ((5e-324, 0, -5e-324), 0, 1.7e308), ((1e-300, 2e-300, 3e-300), 0, 1e300),
    ((1e-300, 2e-300, 3e-300), 0, -1e9), ((1e-8, 1e-8, 0), 0, 1e9), ((1e8, 0, 1), 0, 1e-7),
    ((1e300, 0, 0), 0, 1e-300), ((1e300, 2e300, -3e300), 0, 1e-300), ((1e300, 2e300, -3e300), 0, 3e-299),
    ((1e300, 0, 0), 0, 1), ((0, 1.7e308, 0), 0, 5e-324), ((1e154, 1e154, 1e154), 0, 1e-154),
    ((1.7e308, 1.7e308, 1.7e308), 0, 1e-308), ((1.7e308, -1.7e308, 1e300), 1e-308, -2e-308),
    ((1, 1e-200, 0), 0, 2), ((1, 1e-9, -1e-9), 0, 100),
]


def quaternion(omega, t0, t):
    rate = sqrt(sum(mpf(w) ** 2 for w in omega))
    half = rate * (mpf(t) - mpf(t0)) / 2
    if rate == 0:
        return (mpf(1), mpf(0), mpf(0), mpf(0))
    return (cos(half),) + tuple(mpf(w) / rate * sin(half) for w in omega)


with open(pathlib.Path(__file__).with_name("turns.csv"), "w", newline="\n") as out:
    out.write("omega_x,omega_y,omega_z,t0,t,w,x,y,z\n")
    for omega, t0, t in TURNS:
        mp.dps = 400  # angles have up to 310 digits before the point
        row = [*omega, t0, t, *quaternion(omega, t0, t)]
        out.write(",".join(float(x).hex() for x in row) + "\n")
