"""Writes mixed_reference.hpp: the motion of P4 at t = 0.5, 1, ..., 50, from U(0) = 1 (Debian: python3-mpmath).

omega = (sin 3t + 0.3 cos 17t, e^(-t/50) cos(t^2/40), log(1+t)/2) by Taylor series of U' = omega U/2, in 40 digits; each
term of omega has its series by a recurrence. The table is written only where |U| = 1 and a run with other steps (whose
truncation is a thousand times smaller) give the same to 1e-25, far below the long doubles that are written. 0.3 is the
double."""
from mpmath import cos, exp, log, mp, mpf, sin

mp.dps = 40
ORDER = 45
ZERO = mpf(0)


def omega(t):
    """The Taylor coefficients of the three components about t."""
    fast, slow = [], []
    factorial = mpf(1)
    for k in range(ORDER):
        factorial *= max(k, 1)
        quarter = k * mp.pi / 2
        fast.append((mpf(3)**k * sin(3 * t + quarter) + mpf(0.3) * mpf(17)**k * cos(17 * t + quarter)) / factorial)
        slow.append((mpf(-1) / 50)**k * exp(-t / 50) / factorial)
    # cosine and sine of p = (t + s)^2/40, where p' = (t + s)/20
    c, s = [cos(t * t / 40)], [sin(t * t / 40)]
    for k in range(ORDER - 1):
        c.append(-(t * s[k] + (s[k - 1] if k else ZERO)) / 20 / (k + 1))
        s.append((t * c[k] + (c[k - 1] if k else ZERO)) / 20 / (k + 1))
    chirp = [sum(slow[i] * c[k - i] for i in range(k + 1)) for k in range(ORDER)]
    growth = [log(1 + t) / 2] + [(-1)**(k + 1) / (2 * k * (1 + t)**k) for k in range(1, ORDER)]
    return list(zip(fast, chirp, growth))


def product(w, q):
    """(0, w) q, scalar first."""
    return (-w[0] * q[1] - w[1] * q[2] - w[2] * q[3], w[0] * q[0] + w[1] * q[3] - w[2] * q[2],
            w[1] * q[0] + w[2] * q[1] - w[0] * q[3], w[2] * q[0] + w[0] * q[2] - w[1] * q[1])


def step(t, h, q):
    w = omega(t)
    series = [q]
    for k in range(ORDER - 1):
        terms = [product(w[i], series[k - i]) for i in range(k + 1)]
        series.append(tuple(sum(x) / (2 * (k + 1)) for x in zip(*terms)))
    return tuple(sum(x[i] * h**k for k, x in enumerate(series)) for i in range(4))


def motion(steps_of_sample):
    q = (mpf(1), ZERO, ZERO, ZERO)
    h = mpf(1) / 2 / steps_of_sample
    samples = []
    for i in range(100 * steps_of_sample):
        q = step(i * h, h, q)
        if (i + 1) % steps_of_sample == 0:
            samples.append(q)
    return samples


table, check = motion(6), motion(7)
for q, p in zip(table, check):
    assert abs(sum(x * x for x in q) - 1) < 1e-25 and max(abs(x - y) for x, y in zip(q, p)) < 1e-25
with open("mixed_reference.hpp", "w", encoding="ascii") as out:
    out.write("// The motion of P4 at t = 0.5, 1, ..., 50: (w, x, y, z). Written by mixed_reference.py.\n#pragma once\n\n"
              "namespace rotor::bench {\n\n// clang-format off\n"
              "inline constexpr long double kMixedReference[100][4] = {\n")
    for q in table:
        out.write("  {" + ", ".join(mp.nstr(x, 22) + "L" for x in q) + "},\n")
    out.write("};\n// clang-format on\n\n}  // namespace rotor::bench\n")
