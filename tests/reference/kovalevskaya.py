#!/usr/bin/env python3
"""Kovalevskaya's top to 30 digits: writes kovalevskaya.csv beside this script.

The Euler-Poisson equations and the attitude by their power series, once with 44 terms at 45 digits and once with 34 terms at
60 digits and shorter steps; the two must agree to 30 digits. Nothing of Kovalevskaya's own road is used.
"""

import os
import random
from multiprocessing import Pool
from operator import mul

import gmpy2
from gmpy2 import mpfr, sqrt

TIMES = [1.0, 10.0, 100.0]
# Every sixth of the first 36 starts goes on to here, a minute each.
FAR = 1000.0


def start(case):
    axial, lever, omega, up = case
    i3 = mpfr(axial)
    z = [mpfr(x) for x in up]
    length = sqrt(sum(x * x for x in z))
    z = [x / length for x in z]
    # The shortest turn of z onto the vertical; z3 >= 0 in all cases.
    w = 1 + z[2]
    q = [w, z[1], -z[0], mpfr(0)]
    size = sqrt(sum(x * x for x in q))
    y = [mpfr(x) for x in omega] + z + [x / size for x in q]
    return [2 * i3, 2 * i3, i3], [mpfr(x) for x in lever], y


def series(moments, lever, y, order):
    i1, i2, i3 = moments
    c1, c2, c3 = lever
    s = [[x] for x in y]
    for n in range(order):
        def of(a, b):
            return sum(map(mul, s[a], reversed(s[b])))
        z1, z2, z3 = s[3][n], s[4][n], s[5][n]
        new = [
            ((i2 - i3) * of(1, 2) + z2 * c3 - z3 * c2) / i1,
            ((i3 - i1) * of(2, 0) + z3 * c1 - z1 * c3) / i2,
            ((i1 - i2) * of(0, 1) + z1 * c2 - z2 * c1) / i3,
            of(4, 2) - of(5, 1),
            of(5, 0) - of(3, 2),
            of(3, 1) - of(4, 0),
            -(of(7, 0) + of(8, 1) + of(9, 2)) / 2,
            (of(6, 0) + of(8, 2) - of(9, 1)) / 2,
            (of(6, 1) + of(9, 0) - of(7, 2)) / 2,
            (of(6, 2) + of(7, 1) - of(8, 0)) / 2,
        ]
        for x, terms in zip(new, s):
            terms.append(x / (n + 1))
    return s


def horner(terms, h):
    value = mpfr(0)
    for x in reversed(terms):
        value = value * h + x
    return value


def integrate(case, times, digits, order, rounding):
    gmpy2.get_context().precision = int(digits * 3.33)
    moments, lever, y = start(case)
    t, out = mpfr(0), []
    for stop in times:
        while t < stop:
            s = series(moments, lever, y, order)
            last = max(abs(terms[order]) for terms in s)
            before = max(abs(terms[order - 1]) for terms in s)
            tiny = mpfr(10) ** -rounding
            h = min((tiny / (last + tiny**3)) ** (mpfr(1) / order), (tiny / (before + tiny**3)) ** (mpfr(1) / (order - 1)))
            h = min(h, stop - t)
            y = [horner(terms, h) for terms in s]
            t += h
        out.append(y)
    return out


def run(job):
    number, (name, case) = job
    times = TIMES + [FAR] if number % 6 == 0 and number < 36 else TIMES
    first = integrate(case, times, 45, 44, 38)
    second = integrate(case, times, 60, 34, 40)
    for a, b in zip(first, second):
        worst = max(abs(x - y) for x, y in zip(a, b))
        assert worst < mpfr(10) ** -29, (name, worst)
    return name, case, list(zip(times, second))


def cases():
    yield "article", (1.0, (1.0, 0.0, 0.0), (1.0, 0.5, 0.3), (0.6, 0.0, 0.8))
    yield "article", (1.0, (1.0, 0.0, 0.0), (1.0, 0.5, 0.3), (2.0, -1.0, 2.0))
    yield "q = 0", (1.0, (1.0, 0.0, 0.0), (1.0, 0.0, 0.3), (0.6, 0.48, 0.64))
    yield "q = 0", (1.0, (1.0, 0.0, 0.0), (1.0, 0.0, 0.3), (0.6, 0.0, 0.8))
    yield "q near 0", (1.0, (1.0, 0.0, 0.0), (-0.7, 1e-9, 0.9), (0.3, 1e-8, 0.9))
    yield "released from rest", (1.0, (1.0, 0.0, 0.0), (0.0, 0.0, 0.0), (0.6, 0.48, 0.64))
    yield "l = 0", (1.0, (1.0, 0.0, 0.0), (1.0, 0.5, 0.0), (0.5, -1.0, 0.7))
    yield "K = 0", (1.0, (1.0, 0.0, 0.0), (1.0, 0.0, 0.7), (1.0, 0.0, 0.0))
    yield "K = 0", (1.0, (1.0, 0.0, 0.0), (0.75, 0.25, 0.5), (0.5, 0.375, 0.78))
    yield "pendulum", (1.0, (1.0, 0.0, 0.0), (0.0, 0.7, 0.0), (0.6, 0.0, 0.8))
    yield "pendulum", (1.0, (1.0, 0.0, 0.0), (0.0, 0.0, 0.7), (0.6, 0.8, 0.0))
    yield "weak gravity", (1.0, (0.01, 0.0, 0.0), (1.0, 0.5, 0.3), (2.0, -1.0, 2.0))
    yield "weak gravity", (1.0, (1e-6, 0.0, 0.0), (1.0, 0.5, 0.3), (2.0, -1.0, 2.0))
    yield "C anywhere", (0.5, (0.3, -0.4, 0.0), (1.0, 0.5, 0.3), (2.0, -1.0, 2.0))
    yield "C anywhere", (1.25, (-2.0, 0.0, 0.0), (0.2, 1.5, -0.3), (0.25, -0.5, 0.125))
    draw = random.Random(1889)
    for _ in range(33):
        omega = tuple(draw.uniform(-1.5, 1.5) for _ in range(3))
        up = [draw.gauss(0, 1) for _ in range(3)]
        up[2] = abs(up[2])
        yield "random", (1.0, (1.0, 0.0, 0.0), omega, tuple(up))


def write(name, made):
    """The table of what `run` returned, beside this script."""
    lines = ["group,I3,C1,C2,omega1,omega2,omega3,up1,up2,up3,t,omega1_t,omega2_t,omega3_t,z1,z2,z3,qw,qx,qy,qz"]
    for group, (axial, lever, omega, up), states in made:
        given = [axial, lever[0], lever[1], *omega, *up]
        for t, y in states:
            row = [group, *(float(x).hex() for x in given), float(t).hex(), *(f"{x:.29e}" for x in y)]
            lines.append(",".join(row))
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), name)
    with open(path, "w") as table:
        table.write("\n".join(lines) + "\n")


if __name__ == "__main__":
    with Pool(2) as pool:
        write("kovalevskaya.csv", pool.imap(run, enumerate(cases())))
