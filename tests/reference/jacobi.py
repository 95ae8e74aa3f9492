"""Writes jacobi.csv: the Jacobi functions and the amplitude to 34 digits, at exact f64 arguments.

    pip install mpmath && python3 jacobi.py

One row an argument: kind, which of m and mc is given, its value, u (both as hexadecimal floats, taken as exact), and
sn, cn, dn, am. Two independent routes must agree to 40 digits in every row or nothing is written: theta functions
(`mpmath.ellipfun`), and the amplitude by the descending arithmetic-geometric mean. The amplitude decides am, and with
it the number of turns. The working precision grows with u and with 1/mc.
"""

import math
import random
import sys
from mpmath import mp, mpf, agm, asin, cos, ellipfun, isinf, log10, nstr, pi, sech, sin, sqrt, tanh, asinh, atan, sinh

# Another seed and another file may be named, for a trial beyond the committed table.
random.seed(int(sys.argv[1]) if len(sys.argv) > 1 else 20)
OUTPUT = sys.argv[2] if len(sys.argv) > 2 else "jacobi.csv"


def quarter_period(m, mc):
    return mp.inf if mc == 0 else pi / (2 * agm(1, sqrt(mc)))


def by_mean(u, m, mc):
    """Amplitude by the arithmetic-geometric mean (Digital Library of Mathematical Functions 22.20)."""
    if mc == 0:
        am = atan(sinh(u))
        return tanh(u), sech(u), sech(u), am
    a, b, c = [mpf(1)], sqrt(mc), [sqrt(m)]
    while abs(c[-1]) > mpf(10) ** (-mp.dps // 2 - 10):
        previous = a[-1]
        a.append((previous + b) / 2)
        # c = (a - b)/2, without the subtraction: c_{n+1} = c_n^2 / (4 a_{n+1}).
        c.append(c[-1] ** 2 / (4 * a[-1]))
        b = sqrt(previous * b)
    phi = 2 ** (len(a) - 1) * a[-1] * u
    for n in range(len(a) - 1, 0, -1):
        phi = (phi + asin(c[n] / a[n] * sin(phi))) / 2
    sn, cn = sin(phi), cos(phi)
    return sn, cn, sqrt(mc + m * cn * cn), phi


def by_theta(u, m, mc):
    if mc == 0 or m == 0:
        return (tanh(u), sech(u), sech(u)) if mc == 0 else (sin(u), cos(u), mpf(1))
    k = quarter_period(m, mc)
    u -= 4 * k * mp.nint(u / (4 * k))
    return tuple(ellipfun(name, u, m=m) for name in ("sn", "cn", "dn"))


def row(kind, which, value, u):
    u = float(u)
    lesser = -math.log10(value) if value else 0
    mp.dps = int(110 + 1.1 * lesser + (math.log10(abs(u)) if abs(u) > 1 else 0) * 1.5)
    if u and abs(u) < 1:
        mp.dps += int(-3 * math.log10(abs(u)))
    m, mc = (mpf(value), 1 - mpf(value)) if which == "m" else (1 - mpf(value), mpf(value))
    x = mpf(u)
    values = by_mean(x, m, mc)
    for a, b in zip(values, by_theta(x, m, mc)):
        assert abs(a - b) <= mpf(10) ** -40 * abs(a), (kind, which, value, u, nstr(a, 50), nstr(b, 50))
    return ",".join([kind, which, value.hex(), u.hex()] + [nstr(v, 34, min_fixed=0, max_fixed=0) for v in values])


def K(which, value):
    mp.dps = 400
    m, mc = (mpf(value), 1 - mpf(value)) if which == "m" else (1 - mpf(value), mpf(value))
    return quarter_period(m, mc)


def log_uniform(least, greatest):
    return 10.0 ** random.uniform(math.log10(least), math.log10(greatest))


def lesser():
    """A parameter uniform in 0..1, named by its lesser half."""
    return random.choice(["m", "mc"]), random.uniform(0, 0.5)


def sign():
    return random.choice([-1.0, 1.0])


rows = []
for _ in range(150):
    rows.append(row("random", *lesser(), random.uniform(-10, 10)))
for _ in range(150):
    p = lesser()
    n = math.floor(log_uniform(1, 1e6))
    d = sign() * log_uniform(1e-17, 1e-1)
    rows.append(row("multiple", *p, sign() * float(n * K(*p) * (1 + mpf(d)))))
for _ in range(140):
    rows.append(row("long", *lesser(), sign() * log_uniform(1, 1e15)))
for _ in range(90):
    rows.append(row("long-small-m", "m", log_uniform(1e-300, 1e-1), sign() * log_uniform(1, 1e15)))
for _ in range(90):
    rows.append(row("long-small-mc", "mc", log_uniform(1e-300, 1e-1), sign() * log_uniform(1, 1e15)))
for _ in range(220):
    p = "mc", log_uniform(1e-300, 1)
    rows.append(row("separatrix", *p, float(K(*p) * mpf(random.uniform(-4, 4)))))
for _ in range(90):
    p = "mc", log_uniform(1e-300, 1)
    n = math.floor(log_uniform(1, 1e9))
    d = sign() * log_uniform(1e-17, 1e-1)
    rows.append(row("separatrix-multiple", *p, sign() * float(n * K(*p) * (1 + mpf(d)))))
for _ in range(70):
    rows.append(row("small-m", "m", log_uniform(1e-300, 1e-1), random.uniform(-10, 10)))
for _ in range(25):
    rows.append(row("circle", "m", 0.0, random.uniform(-10, 10)))
    rows.append(row("hyperbola", "mc", 0.0, sign() * log_uniform(1e-3, 740)))
for _ in range(15):
    rows.append(row("circle", "m", 0.0, sign() * log_uniform(10, 1e15)))
for value in (1e-300, 1e-20, 0.3, 0.5):
    for which in ("m", "mc"):
        for _ in range(5):
            rows.append(row("tiny-u", which, value, sign() * log_uniform(1e-300, 1e-3)))
for value in (1e-300, 1e-100, 1e-16, 1e-3, 0.1, 0.3, 0.5):
    for which in ("m", "mc"):
        for n in (1, 2, 3, 4, 10, 1001):
            u = float(n * K(which, value))
            rows.append(row("neighbour", which, value, math.nextafter(u, random.choice([0.0, math.inf]))))
            rows.append(row("neighbour", which, value, u))
for _ in range(15):
    for p in (("m", 0.5), ("m", math.nextafter(0.5, 0)), ("mc", math.nextafter(0.5, 0))):
        rows.append(row("switch", *p, random.uniform(-4, 4)))


def unlucky(which, value, exponent):
    """The double p 2^exponent closest to a multiple of K, relative to its size: a convergent of K/2^exponent."""
    x = K(which, value) / mpf(2) ** exponent
    numerators, denominators, rest = [0, 1], [1, 0], x
    while True:
        part = int(mp.floor(rest))
        numerators.append(part * numerators[-1] + numerators[-2])
        denominators.append(part * denominators[-1] + denominators[-2])
        if numerators[-1] >= 2**53:
            return float(mpf(numerators[-2]) * mpf(2) ** exponent)
        rest = 1 / (rest - part)


for which, value in (("m", 1e-300), ("m", 0.01), ("m", 0.3), ("mc", 0.5), ("mc", 0.02), ("mc", 1e-16), ("mc", 1e-300)):
    for exponent in (-52, -35, -20, -10, -4):
        u = unlucky(which, value, exponent)
        rows.append(row("unlucky", which, value, u))
        rows.append(row("unlucky", which, value, -u))

with open(OUTPUT, "w") as out:
    out.write("\n".join(rows) + "\n")
