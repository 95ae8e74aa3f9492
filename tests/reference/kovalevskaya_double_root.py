#!/usr/bin/env python3
"""Kovalevskaya's top on a double root and beside it, to 30 digits: writes kovalevskaya_double_root.csv beside this script.

z along axis 3 at the start, exactly or nearly; motions where a variable passes between two roots of the cubic that nearly meet; and pendulums that keep to their plane. The motion may amplify what is rounded more than a billion billion times until t = 60, so the power
series of kovalevskaya.py are carried to 66 digits with 64 terms and to 72 digits with 52 terms; the two must agree to 30 digits.
"""

import math
import random
from multiprocessing import Pool

from gmpy2 import mpfr

import kovalevskaya

TIMES = [3.0, 20.0, 60.0]


def start(case):
    """As kovalevskaya.start, but z may point down: then the body is turned over about axis 1 first."""
    axial, lever, omega, up = case
    if up[2] >= 0:
        return upward(case)
    moments, lever, y = upward((axial, lever, omega, (up[0], -up[1], -up[2])))
    w, i, j, k = y[6:]
    return moments, lever, y[:4] + [-y[4], -y[5]] + [-i, w, k, -j]


def run(job):
    name, case = job
    first = kovalevskaya.integrate(case, TIMES, 66, 64, 58)
    second = kovalevskaya.integrate(case, TIMES, 72, 52, 60)
    for a, b in zip(first, second):
        worst = max(abs(x - y) for x, y in zip(a, b))
        assert worst < mpfr(10) ** -29, (name, worst)
    return name, case, list(zip(TIMES, second))


def cases():
    plain, poles = (1.0, 0.0, 0.0), [1.0, -1.0]
    for omega in [(0.1, 0.2, 0.0), (0.5, 0.0, 1.5), (0.0, 0.75, 2.0), (1.0, 0.5, 0.3), (0.25, -0.5, 0.125), (1e-3, 2e-3, 0.5)]:
        yield "on it", (1.0, plain, omega, (0.0, 0.0, 1.0))
    draw = random.Random(1893)
    for number in range(33):
        size = [0.4, 1.0, 1.0, 2.5][number % 4]
        omega = tuple(size * draw.uniform(-1.5, 1.5) for _ in range(3))
        lever, axial = (plain, 1.0) if number % 3 else ((0.75, -0.5, 0.0), 0.5)
        yield "on it", (axial, lever, omega, (0.0, 0.0, poles[number % 2]))
    for number in range(24):
        nudge = 10.0 ** -(1.0 + number / 1.5)
        omega = tuple(draw.uniform(-1.5, 1.5) for _ in range(3))
        yield "beside it", (1.0, plain, omega, (nudge * draw.uniform(-1, 1), nudge * draw.uniform(-1, 1), poles[number % 2]))
    for number in range(24):
        nudge = 10.0 ** -(1.0 + number / 3.4)
        p, q, r = (nudge * draw.uniform(-1, 1) for _ in range(3))
        angle = math.pi * draw.uniform(-1, 1)
        fast = draw.uniform(0.1, 1.5)
        yield "passing", [
            # Pendulums about axes 3 and 2, and axis 1 upright with the body spinning about it, all but for a nudge.
            (1.0, plain, (p, q, fast), (math.cos(angle), math.sin(angle), r)),
            (1.0, plain, (p, fast, q), (math.cos(angle), r, math.sin(angle))),
            (1.0, plain, (fast, p, q), (poles[number % 2], r, nudge)),
        ][number % 3]
    across, slow = (0.0, -0.75, 0.0), draw.uniform(0.1, 0.9)
    # Swinging and going round, by hardly anything too; beside the upright position, on the way to it for ever and back from it; and axis 1 upright.
    for lever, omega, up in [
        (plain, (0.0, 0.7, 0.0), (0.6, 0.0, 0.8)),
        (plain, (0.0, -3.1, 0.0), (0.6, 0.0, -0.8)),
        (plain, (0.0, 0.0, 0.7), (-0.6, 0.8, 0.0)),
        (plain, (0.0, 0.0, 4.5), (0.3, -0.4, 0.0)),
        (across, (slow, 0.0, 0.0), (0.0, slow, draw.uniform(0.1, 0.9))),
        (across, (0.0, 0.0, -slow), (slow, -slow, 0.0)),
        (plain, (0.0, 1e-9, 0.0), (-1.0, 0.0, 1e-8)),
        (plain, (0.0, 0.0, 0.0), (1.0, 1e-9, 0.0)),
        (plain, (0.0, 2.0 ** 0.5, 0.0), (-1.0, 0.0, 0.0)),
        (plain, (0.0, 0.0, 2.0), (-1.0, 0.0, 0.0)),
        (plain, (0.0, 0.0, -2.0 - 1e-12), (-1.0, 0.0, 0.0)),
        (plain, (1.25, 0.0, 0.0), (1.0, 0.0, 0.0)),
        (plain, (-0.4, 0.0, 0.0), (-1.0, 0.0, 0.0)),
    ]:
        yield "in its plane", (1.0 if lever == plain else 0.5, lever, omega, up)


upward, kovalevskaya.start = kovalevskaya.start, start

if __name__ == "__main__":
    with Pool(2) as pool:
        kovalevskaya.write("kovalevskaya_double_root.csv", pool.imap(run, cases()))
