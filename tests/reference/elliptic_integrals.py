"""Writes elliptic_integrals.csv: elliptic integrals to 34 digits, at exact f64 arguments.

    pip install mpmath && python3 elliptic_integrals.py

One row a value: kind, function, its arguments as hexadecimal floats taken as exact, the value. A parameter is written
m:… or mc:…, a characteristic n:… or nc:…, whichever of the two is the exact one. Two independent routes must agree to
30 digits in every row or nothing is written: Carlson's duplication (`mpmath.elliprf` and sisters, hundreds of digits),
and the trapezoidal rule on the defining integral after t = cot² theta, t = e^v, which converges exponentially; for a
principal value its points lie symmetrically about the pole.
"""

import math
import random
import sys
from mpmath import mp, mpf, cot, elliprc, elliprf, elliprg, elliprd, nstr, pi, sqrt

from closed_forms import carlsons_integrand, legendres_integrand, rj, trapezoid

# Another seed and another file may be named, for a trial beyond the committed table.
random.seed(int(sys.argv[1]) if len(sys.argv) > 1 else 21)
OUTPUT = sys.argv[2] if len(sys.argv) > 2 else "elliptic_integrals.csv"
HIGH = 750
# Digits, margin and steps of the trapezoidal rule.
FINE = 55, 260, 45


disagreements = []


def agree(one, two, what):
    if not abs(one - two) <= mpf(10) ** -30 * abs(one):
        disagreements.append((what, nstr(one, 40), nstr(two, 40)))
        print(*disagreements[-1], flush=True)


class Pair:
    """A number and its complement, one of them exact."""

    def __init__(self, name, value):
        self.name, self.value = name, float(value)

    def both(self):
        x = mpf(self.value)
        return (1 - x, x) if self.name.endswith("c") else (x, 1 - x)

    def __str__(self):
        return f"{self.name}:{self.value.hex()}"


def complete_c0():
    return mpf(0)


def legendre(which, c0, parameter, characteristic=None):
    """The integral from cot² = c0 to infinity, by both routes; c0 = 0 is the complete one."""
    mp.dps = HIGH
    m, mc = parameter.both()
    c0 = c0()
    s2, c2 = 1 / (1 + c0), c0 / (1 + c0)
    s, d2 = sqrt(s2), c2 + mc * s2
    if which == "F":
        one = s * elliprf(c2, d2, 1)
    elif which == "D":
        one = s ** 3 / 3 * elliprd(c2, d2, 1)
    elif which == "E":
        one = s * elliprf(c2, d2, 1) - m * s ** 3 / 3 * elliprd(c2, d2, 1)
    elif which == "B":
        one = s * elliprf(c2, d2, 1) - s ** 3 / 3 * elliprd(c2, d2, 1)
    else:
        n, nc = characteristic.both()
        one = s * elliprf(c2, d2, 1) + n * s ** 3 / 3 * rj(c2, d2, mpf(1), c2 + nc * s2)
        r = c0 + nc
    a, b, e = c0, c0 + mc, c0 + 1
    pole = -r if which == "P" and r < 0 else None
    mp.dps = 55
    integrand = legendres_integrand(which, a, b, e, r if which == "P" else None)
    places = [a, b, e] + ([r] if which == "P" else [])
    agree(one, trapezoid(integrand, places, one, pole, *FINE) / 2, (which, nstr(c0), str(parameter), str(characteristic)))
    mp.dps = HIGH
    return +one


memory = {}


def complete(which, parameter, characteristic=None):
    key = which, str(parameter), str(characteristic)
    if key not in memory:
        memory[key] = legendre(which, complete_c0, parameter, characteristic)
    return memory[key]


def incomplete(which, phi, parameter, characteristic=None):
    mp.dps = HIGH
    x = mpf(phi)
    halves = mp.nint(x / pi)
    rest = x - halves * pi
    value = mpf(0)
    if rest:
        value = legendre(which, lambda: cot(abs(mpf(phi) - halves * pi)) ** 2, parameter, characteristic)
        value *= mp.sign(rest)
    if halves:
        value += 2 * halves * complete(which, parameter, characteristic)
    return value


def carlson(which, *arguments):
    mp.dps = 200
    a = [mpf(v) for v in arguments]
    one = {"RF": elliprf, "RC": elliprc, "RD": elliprd, "RJ": rj, "RG": elliprg}[which](*a)
    if which == "RC" and a[1] < 0:
        one = sqrt(a[0] / (a[0] - a[1])) * elliprc(a[0] - a[1], -a[1])
    mp.dps = 55
    pole = -a[-1] if a[-1] < 0 else None
    integrand = carlsons_integrand(which, a)
    agree(one, trapezoid(integrand, a, one, pole, *FINE), (which, arguments))
    return one


rows = []


def put(kind, function, arguments, value):
    if not 1e-300 < abs(value) < 1e300:
        # Outside the range of a double, or so near its end that digits are lost.
        return
    text = [a.hex() if isinstance(a, float) else str(a) for a in arguments]
    rows.append(",".join([kind, function, " ".join(text), nstr(value, 34, min_fixed=0, max_fixed=0)]))


def log_uniform(least, greatest):
    return 10.0 ** random.uniform(math.log10(least), math.log10(greatest))


def sign():
    return random.choice([-1.0, 1.0])


def lesser():
    return Pair(random.choice(["m", "mc"]), random.uniform(0, 0.5))


def near_separatrix():
    return Pair("mc", log_uniform(1e-300, 0.5))


def near_circle():
    return Pair("m", log_uniform(1e-300, 0.5))


parameters = ([("random", lesser()) for _ in range(12)] + [("separatrix", near_separatrix()) for _ in range(14)]
              + [("small-m", near_circle()) for _ in range(10)]
              + [("separatrix", Pair("mc", 1e-300)), ("separatrix", Pair("mc", 5e-324)), ("small-m", Pair("m", 1e-300)),
                 ("circle", Pair("m", 0.0)), ("random", Pair("m", 0.5)), ("random", Pair("mc", math.nextafter(0.5, 0)))])
for kind, p in parameters:
    for which, name in (("F", "K"), ("E", "E"), ("D", "D"), ("B", "B")):
        put(kind, name, [p], complete(which, p))

def excess(p):
    """K − π/2, by both routes."""
    mp.dps = HIGH
    m, mc = p.both()
    one = elliprf(0, mc, 1) - pi / 2
    mp.dps = 55

    def integrand(t):
        more, less = sqrt(t + 1), sqrt(t + mc)
        return m / (sqrt(t) * more ** 2 * less * (more + less))

    if one != 0:
        agree(one, trapezoid(integrand, [mc, mpf(1)], one) / 2, ("excess", p))
    return one


HALF = math.pi / 2


def angles():
    """Ordinary, tiny, next to quarter turns by successive floats, and long."""
    n = random.randint(1, 9)
    quarter = n * HALF
    return [("ordinary", random.uniform(-1.6, 1.6)), ("ordinary", random.uniform(-30, 30)),
            ("tiny", sign() * log_uniform(1e-300, 1e-3)),
            ("quarter", quarter), ("quarter", math.nextafter(quarter, 0)), ("quarter", math.nextafter(quarter, 99)),
            ("quarter", quarter * (1 + sign() * log_uniform(1e-15, 1e-2))),
            ("long", sign() * log_uniform(1e2, 1e6))]


for _ in range(3):
    for draw in (lesser, near_separatrix, near_circle):
        p = draw()
        for kind, phi in angles():
            for which in "FE":
                put(kind, which + "i", [phi, p], incomplete(which, phi, p))
for phi in (1e-300, HALF, math.nextafter(HALF, 0), 1e6):
    for which in "FE":
        p = Pair("mc", 1e-300)
        put("separatrix", which + "i", [phi, p], incomplete(which, phi, p))


def characteristics(p):
    c = random.choice
    n = p.value if p.name == "m" else 1 - p.value
    return [("ordinary", Pair("n", random.uniform(-1, 1))), ("negative", Pair("n", -log_uniform(1, 1e300))),
            ("negative", Pair("n", -1e300)), ("small", Pair("n", sign() * log_uniform(1e-300, 1e-2))),
            ("near-one", Pair("nc", log_uniform(1e-300, 1e-2))), ("near-one", Pair("nc", 1e-300)),
            ("equal-m", Pair("n" if p.name == "m" else "nc", p.value)),
            ("equal-m", Pair("n" if p.name == "m" else "nc", math.nextafter(p.value, c([0, 1])))),
            ("equal-m", Pair("n" if p.name == "m" else "nc", p.value * (1 + sign() * log_uniform(1e-14, 1e-3)))),
            ("principal", Pair("n", 1 + log_uniform(1e-3, 1e3))), ("principal", Pair("nc", -log_uniform(1e-300, 1e-3))),
            ("principal", Pair("n", log_uniform(1e3, 1e300)))]


for _ in range(3):
    for draw in (lesser, near_separatrix, near_circle):
        p = draw()
        for kind, c in characteristics(p):
            put(kind, "P", [c, p], complete("P", p, c))
            for angle, phi in random.sample(angles(), 3):
                put(kind, "Pi", [phi, c, p], incomplete("P", phi, p, c))

for kind, size in (("ordinary", (1e-2, 1e2)), ("wide", (1e-30, 1e30)), ("far", (1e-140, 1e140))):
    for _ in range(10):
        x, y, z, p = (log_uniform(*size) for _ in range(4))
        least = 0.0 if random.random() < 0.3 else x
        put(kind, "RF", [least, y, z], carlson("RF", least, y, z))
        put(kind, "RG", [least, y, z], carlson("RG", least, y, z))
        put(kind, "RC", [least, y], carlson("RC", least, y))
        put(kind, "RC", [x, -y], carlson("RC", x, -y))
        if kind != "far":
            put(kind, "RD", [least, y, z], carlson("RD", least, y, z))
            put(kind, "RJ", [least, y, z, p], carlson("RJ", least, y, z, p))
            put(kind + "-principal", "RJ", [least, y, z, -p], carlson("RJ", least, y, z, -p))
for _ in range(8):
    x = log_uniform(1e-2, 1e2)
    y = math.nextafter(x, random.choice([0, 1e9]))
    z = x * (1 + log_uniform(1e-15, 1e-6))
    put("equal", "RF", [x, y, z], carlson("RF", x, y, z))
    put("equal", "RG", [x, y, z], carlson("RG", x, y, z))
    put("equal", "RC", [x, y], carlson("RC", x, y))
    put("equal", "RD", [x, y, z], carlson("RD", x, y, z))
    put("equal", "RJ", [x, y, z, math.nextafter(x, 1e9)], carlson("RJ", x, y, z, math.nextafter(x, 1e9)))


def inverse(kind, function, x, p):
    m, mc = p.both()
    if function == "ASN":
        u = legendre("F", lambda: (1 - mpf(x) ** 2) / mpf(x) ** 2, p) * (1 if x > 0 else -1)
    elif function == "ACN":
        u = legendre("F", lambda: mpf(x) ** 2 / (1 - mpf(x) ** 2), p)
        u = u if x >= 0 else 2 * complete("F", p) - u
    else:
        u = legendre("F", lambda: (mpf(x) ** 2 - p.both()[1]) / (1 - mpf(x) ** 2), p)
    put(kind, function, [x, p], u)


for _ in range(4):
    for draw in (lesser, near_separatrix, near_circle):
        p = draw()
        mp.dps = 50
        least = float(sqrt(p.both()[1]))
        for kind, x in (("ordinary", random.uniform(0, 1)), ("near-one", 1 - log_uniform(1e-15, 1e-3)),
                        ("near-one", math.nextafter(1.0, 0)), ("tiny", log_uniform(1e-300, 1e-3))):
            inverse(kind, "ASN", sign() * x, p)
            inverse(kind, "ACN", sign() * x, p)
        if least < 0.99:
            inverse("ordinary", "ADN", random.uniform(least, 1), p)
            inverse("near-one", "ADN", 1 - (1 - least) * log_uniform(1e-12, 1e-3), p)
            inverse("near-least", "ADN", least * (1 + log_uniform(1e-12, 1e-3)), p)


def incompletes(kind, phi, p, characteristics):
    for which in "FE":
        put(kind, which + "i", [phi, p], incomplete(which, phi, p))
    for c in characteristics:
        put(kind, "Pi", [phi, c, p], incomplete("P", phi, p, c))


# The ends m = 1 and m = 0, and the corners where several limits meet.
for phi in (0.7, -1.3, 1e-200, math.nextafter(HALF, 0), HALF):
    incompletes("hyperbola", phi, Pair("mc", 0.0), [Pair("n", 0.3), Pair("n", -1e20), Pair("nc", 1e-300), Pair("n", 7.0)])
for phi in (0.7, -4.4, 1e-200, math.nextafter(HALF, 9), 1e5):
    incompletes("circle", phi, Pair("m", 0.0), [Pair("n", 0.3), Pair("n", -1e20), Pair("nc", 1e-300)])
for mc in (1e-300, 5e-324):
    p = Pair("mc", mc)
    for c in (Pair("nc", 1e-300), Pair("nc", mc), Pair("nc", -1e-300), Pair("n", -1e300), Pair("n", -1.0), Pair("nc", 9e39),
              Pair("nc", 1.1e40), Pair("n", 1e-300)):
        put("corner", "P", [c, p], complete("P", p, c))
        for phi in (math.nextafter(HALF, 0), math.nextafter(HALF, 9), 1e-150):
            put("corner", "Pi", [phi, c, p], incomplete("P", phi, p, c))
for nc in (9e39, 1.1e40):
    for phi in (1e-25, 1e-20, 0.3, 1.5, 2.0):
        c, p = Pair("nc", nc), Pair("m", 0.3)
        put("far-negative", "Pi", [phi, c, p], incomplete("P", phi, p, c))
# Next to the pole of a principal value, n sin^2 phi = 1, on both sides.
for phi in (0.3, 1.0, 1.5):
    for draw in (lesser, near_separatrix):
        p = draw()
        n = 1 / math.sin(phi) ** 2
        for n in (n, n * (1 + 1e-15), n * (1 - 1e-15), n * (1 + 1e-9)):
            c = Pair("n", n)
            put("pole", "Pi", [phi, c, p], incomplete("P", phi, p, c))

for kind, p in parameters:
    put(kind, "X", [p], excess(p))

assert not disagreements
with open(OUTPUT, "w") as out:
    out.write("\n".join(rows) + "\n")
