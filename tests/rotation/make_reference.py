#!/usr/bin/env python3
"""Writes the reference tables of this folder with mpmath (python3-mpmath), 80 digits throughout.

    faces.csv         the faces of a rotation, over awkward axes and angles
    compositions.csv  the quaternion of a product
    small_angle.csv   the quotients of the kinematic equations that are 0/0 at angle 0

Inputs are doubles, exact, as C hex floats. An output is two columns, hi and lo: hi the nearest
double, lo the remainder to 13 bits. hi + lo is within 2^-65 of the true value, relatively.
"""
import itertools
import math
import pathlib
import random

from mpmath import cos, frexp, mp, mpf, sin, sqrt, tan

mp.dps = 80  # and more where a quotient cancels
HERE = pathlib.Path(__file__).parent
TINY = 5e-324
PI = math.pi

ANGLES = [
    0.0, -0.0, TINY, 1e-300, 1e-17, 1e-8, 1e-4,
    0.5, 1.0, -1.0, PI / 2, -2.0, 2.5, 3.0, -4.0, 5.5, 7.0, 100.0,
    PI - 1e-9, math.nextafter(PI, 0), PI, math.nextafter(PI, 4), -PI,
    2 * PI - 1e-12, 2 * PI, 2 * PI + 1e-8, 4 * PI, 1e6, -1e15, 1e22,
]


def random_axes(count):
    generator = random.Random(20)
    return [tuple(generator.uniform(-1, 1) for _ in range(3)) for _ in range(count)]


AXES = [
    (1, 0, 0), (0, 1, 0), (0, 0, 1), (-1, 0, 0), (0, -1, 0), (0, 0, -1),
    (1, 1e-200, 0), (-1e-200, 1, 1e-200), (0, 1e-200, -1),
    (1, 1e-9, -1e-9), (1e-9, -1, 0), (1e-9, 1e-9, 1),
    (1e200, -2e200, 3e200), (0, 1e200, 1e200),
    (1.7e308, 1.7e308, 1.7e308), (-1.7e308, 0, 1e300),
    (1e-200, -3e-200, 2e-200), (TINY, 0, 0), (TINY, -TINY, 2 * TINY), (1.7e308, TINY, 1),
    *random_axes(6),
]  # fmt: skip


def composition_pairs():
    """Pairs (first, second) of (axis, angle)."""
    skew = (0.3, -0.5, 0.8)
    base = [
        ((1, 0, 0), PI), ((0, 1, 0), PI), ((0, 0, 1), PI / 2), ((0, 0, -1), 2 * PI),
        ((1, 1, 1), 2 * PI / 3), (skew, 1.0), (skew, -4.0), (skew, PI), (skew, 2 * PI),
        (skew, 1e22), ((1e-9, -1, 0), 4 * PI), ((1, 1e-200, 0), 1e-8), ((1, 2, 3), -1e15),
        ((-2, 1, 7), 0.0), ((-2, 1, 7), TINY), ((-2, 1, 7), 1e-300), ((5, -1, 2), PI - 1e-9),
        ((1.7e308, -1.7e308, 1e308), 2.5),
    ]  # fmt: skip
    yield from itertools.product(base, base)
    for axis, angle in base + list(itertools.product(random_axes(6), [0.5, 3.0, -7.0, PI])):
        opposite = tuple(-a for a in axis)
        scaled = tuple(a / 1024 for a in axis)  # exact, so the same direction
        yield (axis, angle), (axis, -angle)
        yield (axis, angle), (opposite, angle)
        yield (scaled, angle), (axis, -angle)
        # Nearly inverse: the angle off by an ulp, the axis by 1e-9 and by about an ulp.
        yield (axis, angle), (axis, -math.nextafter(angle, math.inf))
        for off in (1e-9, 2e-16):
            yield (axis, angle), ((axis[0] * (1 + off), axis[1], axis[2]), -angle)
    for axis in random_axes(4):
        tripled = tuple(3 * math.ldexp(round(math.ldexp(a, 40)), -40) for a in axis)
        third = tuple(a / 3 for a in tripled)  # exact again: 3a was
        yield (third, 2.0), (tripled, -2.0)
        yield (third, PI), (tripled, -PI)


def unit(axis):
    v = [mpf(a) for a in axis]
    length = sqrt(sum(a * a for a in v))
    return [a / length for a in v]


def quaternion(axis, angle):
    half = mpf(angle) / 2
    return [cos(half), *(a * sin(half) for a in unit(axis))]


def faces(axis, angle):
    n, theta = unit(axis), mpf(angle)
    c, s = cos(theta), sin(theta)
    versine = 2 * sin(theta / 2) ** 2
    cross = [[0, -n[2], n[1]], [n[2], 0, -n[0]], [-n[1], n[0], 0]]
    matrix = [
        (c if i == j else 0) + versine * n[i] * n[j] + s * cross[i][j]
        for i in range(3)
        for j in range(3)
    ]
    sizes = [theta, sin(theta / 2), tan(theta / 2), tan(theta / 4)]
    return [*n, *quaternion(axis, angle), *matrix, *(size * a for size in sizes for a in n)]


def product(q, p):
    w, x, y, z = q
    a, b, c, d = p
    return [
        w * a - x * b - y * c - z * d,
        w * b + x * a + y * d - z * c,
        w * c - x * d + y * a + z * b,
        w * d + x * c - y * b + z * a,
    ]


def quotient_angles():
    """All sizes, and around 1.5, 3 and 8.987, where a formula changes and where 1 - g = 0."""
    yield from ANGLES
    yield from (1e-323, 3e-323, 1e-310, 1e-307, 1e-154, 1e154, 1e200, 1e300)
    yield from (1.5, 1.5000000001, 3.0000000001, 8.9868189158)
    generator = random.Random(21)
    for _ in range(200):
        yield generator.uniform(-3.2, 3.2)
        yield generator.uniform(-20, 20)
        yield math.ldexp(generator.uniform(0.5, 1), generator.randrange(-1070, 1))


def quotients(angle):
    """sin/theta, (1 - cos)/theta^2, (theta - sin)/theta^3, g = (theta/2) cot(theta/2) and
    (1 - g)/theta^2."""
    if angle == 0:
        return [mpf(1), mpf(1) / 2, mpf(1) / 6, mpf(1), mpf(1) / 12]
    with mp.workdps(1500):  # 1 - g = theta^2/12 for theta down to 5e-324, and tan of 1e300
        theta = mpf(angle)
        g = theta / 2 / tan(theta / 2)
        return [
            sin(theta) / theta,
            (1 - cos(theta)) / theta**2,
            (theta - sin(theta)) / theta**3,
            g,
            (1 - g) / theta**2,
        ]


def hexed(x):
    mantissa, exponent = float(x).hex().split("p")
    if x == 0:
        return "-0" if math.copysign(1, x) < 0 else "0"
    return mantissa.rstrip("0").rstrip(".") + "p" + exponent


def hi_lo(x):
    hi = float(x)
    mantissa, exponent = frexp(x - mpf(hi))
    bits = int(mantissa * 2**13)
    sign = "-" if bits < 0 else ""
    return [hexed(hi), f"{sign}0x{abs(bits):x}p{exponent - 13:+d}" if bits else "0"]


def row(inputs, outputs):
    fields = [hexed(float(x)) for x in inputs]
    return ",".join(fields + [part for x in outputs for part in hi_lo(x)])


def names(name, parts):
    return [f"{name}_{part}_{half}" for part in parts for half in ("hi", "lo")]


def write(name, header, rows):
    (HERE / name).write_text("\n".join([",".join(header), *rows]) + "\n")


def main():
    entries = ["".join(ij) for ij in itertools.product("123", "123")]
    header = ["x", "y", "z", "angle", *names("axis", "xyz"), *names("q", "wxyz")]
    header += names("m", entries)
    for face in ("euler", "modified_gibbs", "gibbs", "mrp"):
        header += names(face, "xyz")
    write("faces.csv", header, [
        row((*axis, angle), faces(axis, angle)) for axis in AXES for angle in ANGLES
    ])  # fmt: skip

    header = [c + i for i in "12" for c in ("x", "y", "z", "angle")] + names("q", "wxyz")
    write("compositions.csv", header, [
        row((*first[0], first[1], *second[0], second[1]),
            product(quaternion(*second), quaternion(*first)))
        for first, second in composition_pairs()
    ])  # fmt: skip

    quotient_names = ["sinc", "one_minus_cos", "angle_minus_sin", "g", "second"]
    write("small_angle.csv", ["angle", *(n + h for n in quotient_names for h in ("_hi", "_lo"))], [
        row((angle,), quotients(angle)) for angle in quotient_angles()
    ])  # fmt: skip


if __name__ == "__main__":
    main()
