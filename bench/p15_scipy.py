"""SciPy's DOP853 on the problem of bench/p15.lua, with rtol = atol = the accuracy asked for (Debian: python3-scipy)."""
import time

import numpy as np
from scipy.integrate import solve_ivp

A = 2 * np.pi / 40
HALF = 0.5
Q0 = np.concatenate([[np.cos(HALF)], np.sin(HALF) * np.ones(3) / np.sqrt(3)])


def product(p, q):
    return np.concatenate([[p[0] * q[0] - p[1:] @ q[1:]],
                           p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:])])


def about(axis, angle):
    axis = np.asarray(axis, dtype=float)
    return np.concatenate([[np.cos(angle / 2)], np.sin(angle / 2) * axis / np.linalg.norm(axis)])


def exact(t):
    return product(product(about([0, 0, 1], A * t), about([1, 0, -A], np.sqrt(1 + A * A) * t)), Q0)


def rate(t, q):
    x, y = np.cos(A * t), np.sin(A * t)
    return 0.5 * np.array([-x * q[1] - y * q[2], x * q[0] + y * q[3], y * q[0] - x * q[3], x * q[2] - y * q[1]])


print("asked     rotation error   omega calls   seconds")
for accuracy in (1e-6, 1e-9, 1e-12):
    begin = time.perf_counter()
    solution = solve_ivp(rate, (0, 4200), Q0, method="DOP853", rtol=max(accuracy, 3e-14), atol=accuracy)
    seconds = time.perf_counter() - begin
    worst = 0
    for t, q in zip(solution.t, solution.y.T):
        q = q / np.linalg.norm(q)
        e = exact(t)
        worst = max(worst, 2 * min(np.linalg.norm(q - e), np.linalg.norm(q + e)))
    print(f"{accuracy:.0e}     {worst:.2e}         {solution.nfev:8d}      {seconds:.3f}")
