"""Writes elliptic_range.csv: elliptic integrals to 34 digits over the whole range of doubles, in the form of elliptic_integrals.csv.

    pip install mpmath gmpy2 && python3 elliptic_range.py

Carlson's forms with arguments from the least subnormal to the greatest double; F, E, D, B and Pi for m < 0 and m > 1; Pi with
characteristics to the ends of the range. Two independent routes must agree to 30 digits in every row or nothing is
written: Carlson's duplication (`mpmath.elliprf` and sisters), and the trapezoidal rule on the defining integral with t = e^v, which
converges exponentially; for a principal value its points lie symmetrically about the pole. For m > 1 next to the end of the real range, and where
a principal value is a millionth of its parts, the second route works with as many digits more.
"""

import math
import random
import sys
from mpmath import mp, mpf, cot, elliprc, elliprd, elliprf, elliprg, nstr, pi, sqrt

from closed_forms import carlsons_integrand, legendres_integrand, rj, trapezoid

# Another seed and another file may be named, for a trial beyond the committed table.
SEED = int(sys.argv[1]) if len(sys.argv) > 1 else 22
random.seed(SEED)
OUTPUT = sys.argv[2] if len(sys.argv) > 2 else "elliptic_range.csv"
DIGITS = 700
# Digits, margin and steps of the trapezoidal rule.
FINE = 50, 160, 40
LEAST, GREATEST = 5e-324, sys.float_info.max
rows, disagreements = [], []


def has_room(value):
    """Whether a double holds it with all its digits."""
    return mpf(2) ** -1022 < abs(value) < mpf(GREATEST)


def agree(one, two, what):
    if not abs(one - two) <= mpf(10) ** -30 * abs(one):
        disagreements.append(what)
        print(what, nstr(one, 40), nstr(two, 40), flush=True)


def carlson(which, *arguments):
    mp.dps = 1400
    a = [mpf(v) for v in arguments]
    if which == "RC" and a[1] < 0:
        one = sqrt(a[0] / (a[0] - a[1])) * elliprc(a[0] - a[1], -a[1])
    else:
        one = {"RF": elliprf, "RC": elliprc, "RD": elliprd, "RJ": rj, "RG": elliprg}[which](*a)
    if not has_room(one):
        return one
    mp.dps = 50
    pole = -a[-1] if a[-1] < 0 else None
    integrand = carlsons_integrand(which, a)
    agree(one, trapezoid(integrand, a, one, pole, *FINE), (which, arguments))
    return one


def pair(text):
    name, value = text
    return (1 - mpf(value), mpf(value)) if name.endswith("c") else (mpf(value), 1 - mpf(value))


def legendre(which, c0, parameter, characteristic=None):
    """The integral from cot² = c0 to infinity, by both routes."""
    mp.dps = DIGITS
    m, mc = pair(parameter)
    c0 = c0()
    s2, c2 = 1 / (1 + c0), c0 / (1 + c0)
    s, d2 = sqrt(s2), c2 + mc * s2
    f = s * elliprf(c2, d2, 1)
    d = s ** 3 / 3 * elliprd(c2, d2, 1)
    a, b, e = c0, c0 + mc, c0 + 1
    r = None
    if which == "P":
        n, nc = pair(characteristic)
        r = c0 + nc
        one = f + n * s ** 3 / 3 * rj(c2, d2, mpf(1), c2 + nc * s2)
    else:
        one = {"F": f, "D": d, "E": f - m * d, "B": f - d}[which]
    # Exact, however long: the points must lie about the pole itself.
    pole = -r if r and r < 0 else None
    mp.dps = 50
    integrand = legendres_integrand(which, a, b, e, r)
    places = [a, b, e] + ([r] if r else [])
    two = trapezoid(integrand, places, one, pole, *FINE) / 2
    agree(one, two, (which, nstr(c0, 20), parameter, characteristic))
    mp.dps = DIGITS
    return +one


memory = {}


def complete(which, parameter, characteristic=None):
    key = which, parameter, characteristic
    if key not in memory:
        memory[key] = legendre(which, lambda: mpf(0), parameter, characteristic)
    return memory[key]


def incomplete(which, phi, parameter, characteristic=None):
    mp.dps = DIGITS
    halves = mp.nint(mpf(phi) / pi)
    rest = mpf(phi) - halves * pi
    value = mpf(0)
    if rest:
        value = mp.sign(rest) * legendre(which, lambda: cot(rest) ** 2, parameter, characteristic)
    if halves:
        value += 2 * halves * complete(which, parameter, characteristic)
    return value


def put(kind, function, arguments, value):
    if not has_room(value):
        return
    text = [a.hex() if isinstance(a, float) else f"{a[0]}:{a[1].hex()}" for a in arguments]
    rows.append(",".join([kind, function, " ".join(text), nstr(value, 34, min_fixed=0, max_fixed=0)]))


def any_size(least=LEAST, greatest=GREATEST):
    """A positive double, its exponent uniform."""
    low, high = math.log2(least), math.log2(greatest)
    exponent = random.uniform(low, high)
    whole = math.floor(exponent)
    return max(least, min(greatest, math.ldexp(2.0 ** (exponent - whole), whole)))


def forms(kind, x, y, z, p):
    for which, arguments in (("RF", (x, y, z)), ("RG", (x, y, z)), ("RC", (x, y)), ("RC", (x, -y)), ("RD", (x, y, z)),
                             ("RJ", (x, y, z, p)), ("RJ", (x, y, z, -p))):
        if which != "RC" or x or arguments[1] > 0:
            put(kind, which, arguments, carlson(which, *arguments))


for _ in range(9):
    forms("range", *(any_size() for _ in range(4)))
for _ in range(3):
    # One size for all, anywhere, so that R_D and R_J have room.
    unit = math.ldexp(1.0, random.randint(-640, 640))
    forms("unit", *(unit * random.uniform(0.1, 10) for _ in range(4)))
    x = unit * random.uniform(1, 2)
    forms("equal", x, x, x, random.choice([x, math.nextafter(x, 0.0), 2 * x]))
    forms("pair", any_size(1e-150, 1e150), x, x, any_size(1e-150, 1e150))
for _ in range(4):
    # A zero; and a last argument that is far beyond the others, or far below.
    x, y = any_size(1e-160, 1e160), any_size(1e-160, 1e160)
    forms("zero", 0.0, x, y, any_size(1e-160, 1e160))
    z = any_size(1e-60, 1e60)
    forms("last", z * random.uniform(0.1, 1), z, z * random.uniform(1, 10), any_size(1e-200, 1e200))
ends = [LEAST, 2.0 ** -1022, 1e-300, 1.0, 1e300, GREATEST]
for _ in range(8):
    forms("ends", *(random.choice(ends) for _ in range(4)))
forms("ends", 0.0, 1e-300, 1.0, 1.0)
forms("ends", 1.0, 1e-300, 1.0, 1.0)
forms("ends", 0.0, LEAST, GREATEST, 1.0)
forms("ends", LEAST, LEAST, LEAST, LEAST)
forms("ends", GREATEST, GREATEST, GREATEST, GREATEST)

# Each part has a seed of its own, so that one can be drawn without the others.
random.seed(SEED + 1)
HALF = math.pi / 2
negative = ([("m", -random.uniform(0, 3)) for _ in range(2)] + [("m", -any_size(1e-300, 1.0))]
            + [("mc", 1 + any_size(1e-15, 1e2)), ("m", -any_size(1.0, 1e20)), ("m", -any_size(1e20, 1e300)), ("m", -GREATEST)])
for p in negative:
    for which, name in (("F", "K"), ("E", "E"), ("D", "D"), ("B", "B")):
        put("negative-m", name, [p], complete(which, p))
    angles = [random.uniform(-1.6, 1.6), random.uniform(-30, 30), any_size(1e-300, 1e-3), math.nextafter(3 * HALF, 0.0),
              random.choice([-1, 1]) * any_size(1e2, 1e6)]
    for phi in angles:
        for which in "FE":
            put("negative-m", which + "i", [phi, p], incomplete(which, phi, p))
    m = p[1] if p[0] == "m" else 1 - p[1]
    for c in (("n", -random.uniform(0, 3)), ("n", -any_size()), ("n", random.uniform(0, 1)), ("nc", -any_size(1e-300, 1.0)),
              ("n", m), ("n", max(m * (1 + 1e-12), -GREATEST)), ("n", any_size(1.0, GREATEST))):
        put("negative-m", "P", [c, p], complete("P", p, c))
        for phi in random.sample(angles, 1):
            put("negative-m", "Pi", [phi, c, p], incomplete("P", phi, p, c))

random.seed(SEED + 2)
beyond = ([("m", 1 + random.uniform(0, 3)) for _ in range(2)] + [("mc", -any_size(1e-300, 1.0)) for _ in range(2)]
          + [("m", any_size(1.0, 1e20)), ("m", any_size(1e20, 1e300)), ("m", GREATEST)])
for p in beyond:
    mp.dps = 60
    m, mc = pair(p)
    last = mp.asin(1 / sqrt(m))
    # A double below the end of the real range, the last but a few, and anywhere before.
    end = float(last)
    while mpf(end) >= last:
        end = math.nextafter(end, 0.0)
    for phi in (end, end * (1 - 1e-9), end * random.uniform(0, 1), -end * random.uniform(0, 1), end * any_size(1e-12, 1.0)):
        for which in "FE":
            put("beyond-one", which + "i", [phi, p], incomplete(which, phi, p))
        for c in (("n", -any_size()), ("n", random.uniform(-1, 1)), ("n", float(m) / 2), ("n", random.uniform(1, 9) * min(float(m), 1e300)),
                  ("n", float(m)), ("n", any_size(1.0, GREATEST))):
            if random.random() < 0.3:
                put("beyond-one", "Pi", [phi, c, p], incomplete("P", phi, p, c))

for p, angles in ((("m", 0.3), (1e-155, 1e-200, 0.7, -2.0)), (("mc", 1e-300), (0.7,))):
    for c in (("n", -GREATEST), ("n", GREATEST), ("nc", GREATEST), ("nc", -GREATEST), ("n", -LEAST), ("nc", LEAST), ("nc", -1e-310)):
        put("far-n", "P", [c, p], complete("P", p, c))
        for phi in angles:
            put("far-n", "Pi", [phi, c, p], incomplete("P", phi, p, c))
# 6134899525417045 is a multiple of π but for 7·10⁻¹⁷, which decides where it lies from the pole of a principal value.
for n in (1e30, 1e31, 3e33):
    put("multiple", "Pi", [6134899525417045.0, ("n", n), ("m", 0.3)], incomplete("P", 6134899525417045.0, ("m", 0.3), ("n", n)))

assert not disagreements
with open(OUTPUT, "w") as out:
    out.write("\n".join(rows) + "\n")
print(len(rows))
