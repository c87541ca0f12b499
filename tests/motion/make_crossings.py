#!/usr/bin/env python3
"""Writes crossing_runs.csv, crossings.csv and crossing_states.csv with mpmath (python3-mpmath).

omega(t) = sum_k c_k s^k, s = t - origin, with c_k that are doubles. The motion is the Taylor series
of q' = omega q/2 about the places where M is zero (or least), where q is given: there nothing
cancels, and M keeps its digits however near to zero it is. Axis and angle follow the branches of
Lemma 5.3, with i + 2 in n'; it is asserted that both and their rates are continuous then, and that
the limits are those of the motion. Starts are what that motion is at t0. Numbers are C hex floats:
60 digits, rounded to doubles.
"""
import pathlib

from mpmath import acos, atan2, binomial, cos, fac, matrix, mp, mpf, norm, pi, sin, sqrt

mp.dps = 60
DEGREE = 5                                                   # of omega, at most
A, B, C = (0.5, -1, 0.75), (1, 0.5, -0.25), (-0.5, 0.25, 1)  # not in a plane
AWAY = (0.5, 0.1, 1e-2, 1e-3, 1e-5, 1e-9)
ABOUT = [-x for x in AWAY] + [0] + list(reversed(AWAY))
MINUS, PLUS = (-1, matrix(3, 1)), (1, matrix(3, 1))          # q where M is zero


def vector(v):
    return matrix([mpf(x) for x in v])


def scaled(v, x):
    return tuple(y * x for y in v)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return matrix([a[i] * b[j] - a[j] * b[i] for i, j in ((1, 2), (2, 0), (0, 1))])


def sign(n):
    return -1 if n % 2 else 1


def near(a, b, error):
    assert norm(matrix([a - b]) if isinstance(a, mpf) else a - b) < error, (a, b)


class Place:
    """The motion about a time s at which q is known."""

    def __init__(self, c, s, q, terms):
        self.s, self.q = mpf(s), [(mpf(q[0]), q[1])]
        self.zero = norm(q[1]) == 0
        self.c = [sum((vector(c[k]) * (binomial(k, j) * self.s ** (k - j))
                       for k in range(j, len(c))), matrix(3, 1)) for j in range(len(c))]
        self.order = next(k for k, v in enumerate(self.c) if norm(v) > 0)
        for k in range(terms):  # 2 (k + 1) q_(k+1) = sum_j c_j q_(k-j)
            w, m = mpf(0), matrix(3, 1)
            for v, (w1, m1) in zip(self.c, reversed(self.q)):
                w, m = w - dot(v, m1), m + v * w1 + cross(v, m1)
            self.q.append((w / (2 * k + 2), m / (2 * k + 2)))

    def at(self, s):
        """M0, M, M0', M'."""
        d = s - self.s
        w, m, w1, m1 = mpf(0), matrix(3, 1), mpf(0), matrix(3, 1)
        for a, v in reversed(self.q):
            w, m, w1, m1 = w * d + a, m * d + v, w1 * d + w, m1 * d + m
        return w, m, w1, m1

    def moving(self, s, turn):
        """theta, n, n', E' where M is not zero, from M and M' alone."""
        w, m, w1, m1 = self.at(s)
        sine = sign(turn) * norm(m)
        n = m / sine
        angle = 2 * pi * turn + 2 * atan2(norm(m), sign(turn) * w)
        rate = (m1 - n * dot(n, m1)) / sine
        return angle, n, rate, n * (2 * (w * dot(n, m1) - sine * w1)) + rate * angle

    def limits(self, turn, side):
        """The same where M is zero, in the interval of `turn` on that side of it [Lemma 5.3]."""
        i, w = self.order, self.q[0][0]
        a, b = ((self.c + [matrix(3, 1)])[k] * fac(k) for k in (i, i + 1))
        way = sign(turn) * w * side ** (i + 1)
        n = a / norm(a) * way
        rate = (b * norm(a) ** 2 - a * dot(a, b)) / ((i + 2) * norm(a) ** 3) * way
        angle = 2 * pi * (turn + (sign(turn) * w < 0))
        return angle, n, rate, n * dot(n, self.c[0]) + rate * angle


class Run:
    """`places`: (s, q), in the order of the motion. `turn`: the interval of theta at the start, or
    just after a start on M = 0, which has any axis. `miss`: 2 pi less the greatest theta."""

    def __init__(self, name, c, places, turn, t0=0, t1=2, origin=1, miss=0, axis=None, also=(),
                 terms=120):
        self.name, self.c, self.origin, self.t0, self.t1 = name, c, origin, t0, t1
        self.miss, self.way = miss, 1 if t1 > t0 else -1
        self.places = [Place(c, s, q, terms) for s, q in places]
        for p, q in zip(self.places, self.places[1:]):
            w, m, _, _ = p.at(q.s)
            near(w, q.q[0][0], mpf(10) ** -45)
            near(m, q.q[0][1], mpf(10) ** -45)
        first = self.places[0]
        self.on_zero = first.zero and first.s == t0 - origin
        self.turns, self.crossings = [turn], []
        for place in self.places[self.on_zero:]:
            if place.zero:
                self.cross(place)
        self.angle, self.axis, _, _ = self.state(t0)
        given = axis is not None
        if given:
            self.axis = vector(axis)
        times = {float(p.s + origin + x) for p in self.places for x in (*ABOUT, miss, -miss)}
        low, high = min(t0, t1), max(t0, t1)
        self.states = [(t, self.state(t)) for t in sorted(times | set(also))
                       if low <= t <= high and not (given and t == t0)]

    def cross(self, place):
        turn, through = self.turns[-1], place.order % 2 == 0
        upper = sign(turn) * place.q[0][0] < 0
        after = turn + (0 if not through else 1 if upper else -1)
        self.turns.append(after)
        limits = place.limits(turn, -self.way)
        h = self.way * mpf(10) ** -15
        before, behind = place.moving(place.s - h, turn), place.moving(place.s + h, after)
        for a, b, limit in zip(before, behind, limits):
            near((a + b) / 2, limit, mpf(10) ** -20)  # the even terms are 1e-30
            near(a, b, mpf(10) ** -12)
        bend = norm(behind[2] - before[2]) / abs(2 * h)
        self.crossings.append([place.s + self.origin, place.order, "through" if through else "back",
                               turn, after, *limits[1], *limits[2], bend,
                               norm(place.c[place.order]) * fac(place.order)])

    def state(self, t):
        s = mpf(t) - self.origin
        place = min(self.places, key=lambda p: abs(p.s - s))
        passed = [p for p in self.places[self.on_zero:] if p.zero and (s - p.s) * self.way > 0]
        turn = self.turns[len(passed)]
        if not place.zero or s != place.s:
            return place.moving(s, turn)
        return place.limits(turn, self.way if self.on_zero else -self.way)


def q_at_end(turn, upper):
    return PLUS if (turn + upper) % 2 == 0 else MINUS


def crossings():
    for i in range(4):
        c = [(0, 0, 0)] * i + [A, B, C]
        for turn in (-1, 0, 1):
            for upper in (False, True):
                place = [(0, q_at_end(turn, upper))]
                name = f"order {i} interval {turn} {'upper' if upper else 'lower'} end"
                yield Run(name, c, place, turn)
                if turn == 0:
                    yield Run(name + " backward", c, place, turn, 2, 0)
    for i in range(5):
        c = [(0, 0, 0)] * i + [A]
        for upper in (False, True):
            run = Run(f"fixed axis rate s^{i} {'upper' if upper else 'lower'} end", c,
                      [(0, q_at_end(0, upper))], 0)
            for t, (angle, n, _, _) in run.states:  # theta' = omega . n
                near(angle, 2 * pi * upper + dot(n, vector(A)) * (mpf(t) - 1) ** (i + 1) / (i + 1),
                     mpf(10) ** -45)
                near(n, run.axis, mpf(10) ** -45)
            yield run
    run = Run("Figure 6", [(-1, 0, 0), (0, 1, 0)], [(0, MINUS)], 0, 0, 10, also=(2.0, 5.0, 10.0),
              terms=400)
    near(run.angle, 2 * pi - mpf("1.11739399539503"), mpf(10) ** -14)  # theory 5
    for (_, state), angle in zip(run.states[-3:], ("7.400579", "9.735346", "10.378385")):
        near(state[0], mpf(angle), 5.1e-7)
    yield run


def two_crossings():
    """omega is odd about the origin, so that q is even: q(-s) = q(s)."""
    for upper in (False, True):
        places = [(s, q_at_end(0, upper)) for s in (-0.5, 0.5)]
        end = f"{'upper' if upper else 'lower'} end"
        zero = (0, 0, 0)
        yield Run(f"twice fixed axis {end}", [zero, A, zero, scaled(A, -0.25)], places, 0)
        yield Run(f"twice order 0 {end}", [zero, A, zero, B], places, 0)
        # s (s^2 - 1/4) (A + B s^2)
        middle = tuple(x - y / 4 for x, y in zip(A, B))
        yield Run(f"twice order 1 {end}", [zero, scaled(A, -0.25), zero, middle, zero, B], places, 0,
                  terms=200)


def near_misses():
    """theta is greatest where omega . n = 0."""
    for miss in (1e-3, 1e-8, 1e-12):
        n = vector((3, 4, 0)) / 5
        q = (-cos(mpf(miss) / 2), n * sin(mpf(miss) / 2))
        run = Run(f"miss {miss} constant", [(0, 0, 1)], [(0, q)], 0, miss=miss)
        # Theorem 4.1, about the start; acos loses half the digits of the miss.
        c = run.axis[2]
        sine, cosine = sin(run.angle / 2), cos(run.angle / 2)
        a, b = sqrt(1 - (1 - c * c) * sine ** 2), atan2(c * sine, cosine)
        near(2 * acos(a * cos(mpf(1) / 2 + b)), 2 * pi - mpf(miss), mpf(10) ** -35)
        yield run
        n = cross(vector(A), vector(B))
        q = (-cos(mpf(miss) / 2), n * (sin(mpf(miss) / 2) / norm(n)))
        yield Run(f"miss {miss}", [A, B, C], [(0, q)], 0, miss=miss)


def starts():
    for i in (1, 2, 3):
        c = [(0, 0, 0)] * i + [A, B, C]
        for t1 in (1, -1):
            way = f"order {i} {'forward' if t1 > 0 else 'backward'}"
            yield Run(f"start at E = 0 {way}", c, [(0, PLUS)], 0, 0, t1, 0)
            # On along the axis of the start: upward, into the interval 1, or downward.
            n = Place(c, 0, MINUS, 1).limits(1, t1)[1]
            for axis in ((0.6, 0, 0.8), (-0.6, 0, -0.8)):
                turn = 1 if dot(n, vector(axis)) > 0 else 0
                yield Run(f"start at -1 {way} into {turn}", c, [(0, MINUS)], turn, 0, t1, 0,
                          axis=axis)


def text(x):
    return x if isinstance(x, str) else float(x).hex()


def write(name, header, rows):
    with open(pathlib.Path(__file__).with_name(name), "w", newline="\n") as out:
        out.write(header + "\n")
        for row in rows:
            out.write(",".join(text(x) for x in row) + "\n")


def xyz(*names):
    return ",".join(f"{name}_{i}" for name in names for i in "xyz")


def main():
    runs = [*crossings(), *two_crossings(), *near_misses(), *starts()]
    assert len({run.name for run in runs}) == len(runs)
    coefficients = xyz(*(f"c{k}" for k in range(DEGREE + 1)))
    write("crossing_runs.csv", f"run,t0,t1,angle,{xyz('axis')},miss,origin,{coefficients}",
          ([r.name, r.t0, r.t1, r.angle, *r.axis, r.miss, r.origin,
            *(x for v in r.c for x in v), *[0] * 3 * (DEGREE + 1 - len(r.c))] for r in runs))
    write("crossings.csv", "run,t,order,kind,turn_before,turn_after," + xyz("axis", "axis_rate")
          + ",bend,derivative", ([r.name, *crossing] for r in runs for crossing in r.crossings))
    write("crossing_states.csv", "run,t,angle," + xyz("axis", "axis_rate", "euler_rate"),
          ([r.name, t, angle, *n, *rate, *euler] for r in runs
           for t, (angle, n, rate, euler) in r.states))


main()
