#!/usr/bin/env python3
"""Kovalevskaya's top on a double root and beside it, to 30 digits: writes kovalevskaya_double_root.csv beside this script.

z along axis 3 at the start, exactly or nearly; motions where a variable passes between two roots of the cubic that nearly meet; pendulums that keep to their plane; and starts on the other double roots of
Appelrot's second, third and fourth class, some exactly by algebra and some to the last digit of a double. The motion may amplify what is rounded more than a billion billion times until t = 60, so the power
series of kovalevskaya.py are carried to 66 digits with 64 terms and to 72 digits with 52 terms; the two must agree to 30 digits.
"""

import math
import random
from multiprocessing import Pool

import gmpy2
from gmpy2 import mpfr, sqrt

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


def missing(omega, up):
    """What is missing to a double root: 3l1 - k - 2l^2, zero where e5 is a root of the cubic, and the discriminant of the cubic."""
    (p, q, r), z = ([mpfr(x) for x in v] for v in (omega, up))
    length = sqrt(sum(x * x for x in z))
    z1, z2, z3 = (x / length for x in z)
    l1 = (2 * (p * p + q * q) + r * r + 2 * z1) / 6
    l = (2 * (p * z1 + q * z2) + r * z3) / 2
    square = (p * p - q * q - z1) ** 2 + (2 * p * q - z2) ** 2
    d = 1 - square
    g2, g3 = 3 * l1 * l1 - d, l * l - l1 * (d + l1 * l1)
    return 3 * l1 - 2 * l * l - sqrt(square), g2**3 - 27 * g3**2


def settled(draw, which):
    """A random start with such an omega3, by halving, that one of the two is missing by no more than a double can tell."""
    gmpy2.get_context().precision = 200
    while True:
        p, q, *up = (draw.uniform(-1.0, 1.0) for _ in range(5))
        at = lambda r: missing((p, q, r), up)[which]
        low, high = mpfr(draw.uniform(-2.0, 0.0)), mpfr(draw.uniform(0.0, 2.0))
        if at(low) * at(high) >= 0:
            continue
        for _ in range(80):
            middle = (low + high) / 2
            low, high = (low, middle) if at(low) * at(middle) <= 0 else (middle, high)
        return (p, q, float(low)), tuple(up)


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
    # With L along z and q = 0 s1 rests, on the root that e4 shares if p^2 > z1, else on that of e5; and the same motions some time later, rounded.
    for shared, p, r in [("e4", 1.0, 1.5), ("e4", -0.375, 1.0), ("e5", 0.75, -1.25), ("e5", 0.25, 2.0), ("e4", -0.75, -1.25), ("e4", 1.25, 0.5)]:
        exact = (1.0, plain, (p, 0.0, r), (2 * p, 0.0, r))
        yield f"{shared} shared", exact
        [later] = kovalevskaya.integrate(exact, [draw.uniform(1.0, 5.0)], 66, 64, 58)
        yield f"{shared} shared", (1.0, plain, tuple(map(float, later[:3])), tuple(map(float, later[3:6])))
    for omega, up in [((0.75, 0.25, 0.5), (1.0, 0.0, 0.0)), ((-0.25, -0.25, -1.5), (0.0, -1.0, 0.0)), ((-0.75, 0.0, -2.0), (3.0, 0.0, 4.0)), ((1.125, 1.125, 1.75), (0.0, 1.0, 0.0))]:
        yield "e5 shared", (1.0, plain, omega, up)
        yield "e5 shared", (1.0, plain, *settled(draw, 0))
    for p, up in [(-0.5, (-3.0, 4.0, 0.0)), (1.375, (4.0, -3.0, 0.0)), (0.625, (3.0, 4.0, 0.0)), (-1.0, (0.0, 1.0, 0.0))]:
        yield "cubic double", (1.0, plain, (p, 0.0, 0.0), up)
        yield "cubic double", (1.0, plain, *settled(draw, 1))


upward, kovalevskaya.start = kovalevskaya.start, start

if __name__ == "__main__":
    with Pool(2) as pool:
        kovalevskaya.write("kovalevskaya_double_root.csv", pool.imap(run, cases()))
