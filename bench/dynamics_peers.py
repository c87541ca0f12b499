#!/usr/bin/env python3
"""The peers of the motion as a dynamical system, NumPy and SciPy: dynamics_peers.py POINTS SIGNAL DISTANCE.

POINTS and SIGNAL are files of doubles, of points of three each and of samples. Prints, each once a line: CPU seconds of
Lyapunov exponents to t = 400 with their largest sum of logarithms, of the pairs of POINTS within DISTANCE with their
number, and of the power spectral density of SIGNAL with its sum.
"""
import sys
import time

import numpy as np
from scipy.integrate import solve_ivp
from scipy.signal import periodogram
from scipy.spatial import cKDTree

ALPHA = 2 * np.pi / 40
EVERY, END = 100.0, 400.0


def rate(t, y):
    """[P7] and its linearisation, of 3 + 9 components."""
    omega = np.array([np.cos(ALPHA * t), np.sin(ALPHA * t), 0.0])
    e, d = y[:3], y[3:].reshape(3, 3)
    theta2 = e @ e
    theta = np.sqrt(theta2)
    g = theta / 2 / np.tan(theta / 2)
    c = (1 - g) / theta2
    curvature = (0.25 - (g + 2) * c) / theta2
    braces = omega * theta2 - e * (omega @ e)
    cross = np.array([[0, -omega[2], omega[1]], [omega[2], 0, -omega[0]], [-omega[1], omega[0], 0]])
    a = (-c * (2 * np.outer(omega, e) - (omega @ e) * np.eye(3) - np.outer(e, omega))
         - curvature * np.outer(braces, e) + cross / 2)
    return np.concatenate([omega - c * braces + cross @ e / 2, (a @ d).ravel()])


def lyapunov():
    """The sums of log R_ii."""
    e, axes, sums = np.ones(3) / np.sqrt(3), np.eye(3), np.zeros(3)
    for k in range(round(END / EVERY)):
        end = solve_ivp(rate, (k * EVERY, (k + 1) * EVERY), np.concatenate([e, axes.ravel()]), method="DOP853",
                        rtol=1e-11, atol=1e-12).y[:, -1]
        e = end[:3]
        axes, r = np.linalg.qr(end[3:].reshape(3, 3))
        sums += np.log(np.abs(np.diag(r)))
    return sums.max()


def timed(work):
    begin = time.process_time()
    value = work()
    print(time.process_time() - begin, repr(float(value)))


points = np.fromfile(sys.argv[1]).reshape(-1, 3)
signal = np.fromfile(sys.argv[2])
timed(lyapunov)
timed(lambda: len(cKDTree(points).query_pairs(float(sys.argv[3]), output_type="ndarray")))
timed(lambda: periodogram(signal, window="hann", detrend="constant")[1].sum())
