#!/usr/bin/env python3
"""Writes coning_gyro.csv, what a gyroscope on a coning body tells.

The body is tilted by THETA about an axis that itself goes round in the x-y plane at ALPHA, once a
second: Q(t) = exp(k ALPHA t) exp(i THETA) exp(-k ALPHA t). Its angular velocity in the body frame is
ALPHA (-sin THETA sin ALPHA t, sin THETA cos ALPHA t, cos THETA - 1). After each whole second the body
is back, though the mean of its rates is not zero. The samples are taken about 100 times a second,
unevenly, and have a constant bias.
"""
import math
import pathlib

ALPHA = 2 * math.pi
THETA = 0.2
BIAS = (0.5, -0.25, 0.125)  # deg/s
RATE, SECONDS = 100, 3

with open(pathlib.Path(__file__).parent / "coning_gyro.csv", "w", encoding="ascii") as out:
    out.write("Time (s),Gyroscope X (deg/s),Gyroscope Y (deg/s),Gyroscope Z (deg/s)\n")
    for i in range(RATE * SECONDS + 1):
        inside = 0 < i < RATE * SECONDS
        t = round((i + inside * 0.2 * math.sin(7 * i)) / RATE, 5)
        sine, cosine = math.sin(THETA), math.cos(THETA)
        omega = (-sine * math.sin(ALPHA * t), sine * math.cos(ALPHA * t), cosine - 1)
        cells = [math.degrees(ALPHA * w) + b for w, b in zip(omega, BIAS)]
        out.write(",".join([f"{t:.5f}"] + [f"{c:.9f}" for c in cells]) + "\n")
