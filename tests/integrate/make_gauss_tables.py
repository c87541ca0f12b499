#!/usr/bin/env python3
"""Writes src/integrate/gauss_tables.hpp with mpmath (python3-mpmath): constants of the fast integrator.

Nodes and weights of Gauss and Legendre come from the zeros of P_N to 40 digits, rounded once: the nodes to extended
precision, for P_N' is large. The polynomials are Chebyshev interpolants of entire functions of x = theta^2 on
[0, range], in powers of 2 x / range - 1: for every degree on the longest range (to three binary digits) on which the
error, found on a fine grid, stays below 2^-55.
"""
import pathlib

from mpmath import chebyt, cos, mp, mpf, nstr, pi, polyval, sin, sqrt, taylor

mp.dps = 40
HEADER = pathlib.Path(__file__).parents[2] / "src" / "integrate" / "gauss_tables.hpp"
BOUND = mpf(2) ** -55


def legendre_with_slope(n, x):
    before, value = mpf(1), x
    for k in range(1, n):
        before, value = value, ((2 * k + 1) * x * value - k * before) / (k + 1)
    return value, n * (before - x * value) / (1 - x * x)


def gauss(n):
    """The positive nodes, rising, and their weights."""
    pairs = []
    for k in range(n // 2, 0, -1):
        x = cos(pi * (k - mpf(1) / 4) / (n + mpf(1) / 2))
        for _ in range(8):
            value, slope = legendre_with_slope(n, x)
            x -= value / slope
        pairs.append((x, 2 / ((1 - x * x) * legendre_with_slope(n, x)[1] ** 2)))
    assert abs(sum(w for _, w in pairs) - 1) < mpf(10) ** -30
    return pairs


def half_cosine(x):
    return cos(sqrt(x) / 2)


def half_sine(x):
    return sin(sqrt(x) / 2) / sqrt(x) if x else mpf(1) / 2


def fer_1(x):
    t = sqrt(x)
    return (1 - cos(t)) / x - sin(t) / t if x > mpf(10) ** -10 else -mpf(1) / 2 + x / 8


def fer_2(x):
    t = sqrt(x)
    return (1 - cos(t)) / x - (t - sin(t)) / (t * x) if x > mpf(10) ** -10 else mpf(1) / 3 - x / 30


def fit(f, degree, range_):
    """Powers of u = 2 x / range - 1 of the interpolant at Chebyshev's nodes, and its error."""
    n = degree + 1
    nodes = [cos(pi * (2 * j + 1) / (2 * n)) for j in range(n)]
    values = [f(range_ * (u + 1) / 2) for u in nodes]
    powers = [mpf(0)] * n
    for k in range(n):
        c = sum(v * cos(k * pi * (2 * j + 1) / (2 * n)) for j, v in enumerate(values)) * (2 if k else 1) / n
        for i, a in enumerate(taylor(lambda z: chebyt(k, z), 0, k)):
            powers[i] += c * a
    grid = [mpf(j) / 50 - 1 for j in range(101)]
    error = max(abs(polyval(powers[::-1], u) - f(range_ * (u + 1) / 2)) for u in grid)
    return powers, error


def longest(functions, degree):
    """The longest range, to three binary digits, on which each is within the bound."""
    range_ = mpf(2) ** -30
    while all(fit(f, degree, range_ * 2)[1] < BOUND for f in functions):
        range_ *= 2
    for part in (1.75, 1.5, 1.25):
        if all(fit(f, degree, range_ * part)[1] < BOUND for f in functions):
            return range_ * part
    return range_


def number(x):
    return repr(float(x))


def block(values, indent="    "):
    text, line = [], indent
    for i, value in enumerate(values):
        item = number(value) + ("," if i + 1 < len(values) else "")
        if len(line) + len(item) + 1 > 100:
            text.append(line.rstrip())
            line = indent
        line += item + " "
    return "\n".join(text + [line.rstrip()])


def print_array(out, name, values):
    out.write(f"inline constexpr std::array<double, {len(values)}> {name} = {{\n{block(values)}}};\n")


def print_fits(out, name, functions, degrees, comment):
    top = max(degrees)
    out.write(f"\n{comment}\n")
    out.write(f"inline constexpr std::array<FitPair<{top}>, {len(degrees)}> {name} = {{{{\n")
    for degree in degrees:
        range_ = longest(functions, degree)
        rows = [fit(f, degree, range_)[0] for f in functions]
        out.write(f"    {{{number(range_)}, {degree},\n")
        for i, row in enumerate(rows):
            out.write("     {\n" + block(row, "         ") + ("},\n" if i == 0 else "}},\n"))
    out.write("}};\n")


with open(HEADER, "w", newline="\n") as out:
    out.write("""\
// Constants of the fast integrator, written by tests/integrate/make_gauss_tables.py.
#pragma once

#include <array>
#include <cstddef>

#include "rotation/rotation.hpp"

// clang-format off
namespace rotor {

/// Two functions of x on [0, range] as sums of powers of u = 2 x / range - 1, to 2^-55.
template <std::size_t Degree>
struct FitPair {
  double range;
  std::size_t degree;  // of both; the powers above have the coefficient 0
  std::array<double, Degree + 1> first;
  std::array<double, Degree + 1> second;
};

/// The positive nodes of Gauss and Legendre on [-1, 1] with their weights: N = 12, 16 and 64.
""")
    for n in (12, 16, 64):
        pairs = gauss(n)
        out.write(f"inline constexpr std::array<Extended, {n // 2}> kGauss{n}Nodes = {{\n")
        out.write(",\n".join(f"    {nstr(x, 25)}L" for x, _ in pairs) + "};\n")
        print_array(out, f"kGauss{n}Weights", [w for _, w in pairs])
    print_fits(out, "kFerFits", (fer_1, fer_2), (3, 5, 7, 9, 11, 13, 15),
               "/// (1 - cos th)/th^2 - sin th/th and (1 - cos th)/th^2 - (th - sin th)/th^3 of x = th^2.")
    print_fits(out, "kExpFits", (half_cosine, half_sine), (3, 5, 7, 9, 11),
               "/// cos(th/2) and sin(th/2)/th of x = th^2.")
    out.write("\n}  // namespace rotor\n")
