"""Writes hard_cases.csv: by this `lab::hard_cases` judges textbook formulas and ours.

    pip install mpmath gmpy2 && python3 hard_cases.py

One row a case: family, nearness (how close to where digits go, 0 being there), the inputs and the results, each separated by spaces.
Inputs are exact doubles, written as hexadecimal floats; results have 36 digits. The formulas are those of the textbook: they are right, and
with DIGITS digits nothing that cancels is missed. Each family is computed once more by a second route, named beside it,
and nothing is written if the two differ by more than 1e-30 of the result. As last run: 1.3e-55 at most.
"""

from fractions import Fraction
from pathlib import Path

from mpmath import acos, atan, cos, elliprf, ellipfun, ellipk, fabs, findroot, matrix, mp, mpf, nstr, sin, sqrt

import free_top

DIGITS = 420
AGREEMENT = mpf(10) ** -30
mp.dps = DIGITS
HERE = Path(__file__).parent


def short(x, bits=12):
    """The nearest double of few bits: a number one can write down."""
    m, e = mp.frexp(mpf(x))
    return float(mp.ldexp(mp.nint(m * 2**bits), e - bits))


def steps(first, last, by):
    """Powers of two, and not quite: a power itself makes too many operations exact."""
    for k in range(first, last, by):
        yield 1.375 * (1 + 0.1 * k % 1) * 2.0**-k


# ------------------------------------------------------------------ 6.6, the free top


def seed_solution(moments, momentum, t):
    """Omega at t as 6.6 has it, started where Omega_2 = 0 and the other two are positive, for L^2 > 2E I_2."""
    a, b, c = map(mpf, moments)
    l1, _, l3 = map(mpf, momentum)
    square, twice = l1**2 + l3**2, l1**2 / a + l3**2 / c
    first = sqrt((twice * c - square) / (a * (c - a)))
    second = sqrt((twice * c - square) / (b * (c - b)))
    third = sqrt((square - twice * a) / (c * (c - a)))
    rate = sqrt((c - b) * (square - twice * a) / (a * b * c))
    m = (b - a) * (twice * c - square) / ((c - b) * (square - twice * a))
    sn, cn, dn = (ellipfun(name, rate * t, m=m) for name in ("sn", "cn", "dn"))
    return [first * cn, second * sn, third * dn], rate, m


def free(moments, momentum, t):
    return seed_solution(moments, momentum, mpf(t))[0]


def free_again(moments, momentum, t):
    """By the closed form of free_top.py: Jacobi's functions by the arithmetic-geometric mean, complements carried."""
    state = free_top.Body(list(moments), list(momentum)).at(mpf(t))
    return [l / mpf(i) for l, i in zip(state[0], moments)]


def quarter(moments, momentum):
    _, rate, m = seed_solution(moments, momentum, mpf(0))
    return ellipk(m) / rate


def free_row(d, moments, momentum, t, chosen=(0, 1, 2)):
    pick = lambda omega: [omega[k] for k in chosen]
    inputs = [*moments, *momentum, t]
    return d, inputs, pick(free(moments, momentum, t)), pick(free_again(moments, momentum, t))


def near_separatrix():
    for d in steps(1, 53, 3):
        moments, momentum = (1.5, 3.0, 4.0), (1.0, 0.0, 2.0 * (1.0 + d))
        yield free_row(d, moments, momentum, short(1.1 * quarter(moments, momentum)))


def near_axis():
    for d in steps(2, 60, 4):
        yield free_row(d, (1.0, 2.0, 3.0), (d, 0.0, 1.0), 5.0, (0, 1))


def nearly_sphere():
    for d in steps(2, 51, 3):
        yield free_row(d, (1.0 - d, 1.0, 1.0 + d), (0.5, 0.0, 0.875), 2.0 / d)


def long_time():
    for n in range(0, 16):
        yield free_row(10.0**-n, (1.0, 2.0, 3.0), (0.5, 0.0, 1.0), 10.0**n)


# ------------------------------------------------------------------ Jacobi's functions


def quarter_period():
    for mc in steps(2, 160, 9):
        u = short(ellipk(1 - mpf(mc)) * mpf(15) / 16)
        sn = ellipfun("sn", mpf(u), m=1 - mpf(mc))
        # The second route: u back from sn by Carlson's integral, then dn from cn.
        again = sqrt(mc + (1 - mpf(mc)) * (1 - sn * sn))
        assert fabs(sn * elliprf(1 - sn * sn, again * again, 1) - u) < AGREEMENT * u
        yield mc, [u, mc], [sqrt(1 - (1 - mpf(mc)) * sn * sn)], [again]


# ------------------------------------------------------------------ 7.2 to 7.5, Lagrange's top


def cubic(i1, i3, mgl, omega, quaternion):
    """The three roots h of 7.2, ascending, from a start with this direction of a quaternion."""
    w, x, y, z = map(mpf, quaternion)
    n = w * w + x * x + y * y + z * z
    up = [2 * (x * z - w * y) / n, 2 * (y * z + w * x) / n, (w * w - x * x - y * y + z * z) / n]
    l = [i1 * mpf(omega[0]), i1 * mpf(omega[1]), i3 * mpf(omega[2])]
    vertical = sum(a * b for a, b in zip(l, up))
    energy = sum(a * mpf(b) for a, b in zip(l, omega)) / 2 + mgl * up[2]
    rest = energy - l[2] ** 2 / (2 * mpf(i3))
    # (I1 h')^2 = 2 I1 (E' - Mgl h)(1 - h^2) - (L_vert - L3 h)^2
    coefficients = [2 * i1 * mgl, -2 * i1 * rest - l[2] ** 2, -2 * i1 * mgl + 2 * vertical * l[2], 2 * i1 * rest - vertical**2]
    return sorted(mp.re(root) for root in mp.polyroots([mpf(c) for c in coefficients], maxsteps=800, extraprec=4 * DIGITS)), coefficients


def sleeping_top():
    for d in steps(2, 60, 4):
        i1, i3, mgl, omega = 1.0, 0.5, 1.0, (d, 0.0, 6.0)
        (h1, h2, h3), (a, b, c, _) = cubic(i1, i3, mgl, omega, (1.0, d, 0.0, 0.0))
        # The second route: with y = 1 - h the same cubic has small coefficients that are formed without h.
        w2 = 1 + mpf(d) ** 2
        y0 = 2 * mpf(d) ** 2 / w2
        up = [mpf(0), 2 * mpf(d) / w2, 1 - y0]
        l3 = mpf(3)
        deficit = -l3 * y0  # L_vert - L3, Omega_1 being along the node
        e = mpf(d) ** 2 / 2 - y0
        # 2(E'' + y) y (2 - y) = (deficit + L3 y)^2, E'' = E' - Mgl
        p = [mpf(-2), 4 - 2 * e - l3**2, 4 * e - 2 * deficit * l3, -deficit**2]
        roots = sorted(mp.re(r) for r in mp.polyroots(p, maxsteps=800, extraprec=4 * DIGITS))
        again = [roots[1], roots[0]] if roots[0] >= 0 else [roots[2], roots[1]]
        yield d, [i1, i3, mgl, *omega, d], [1 - h1, 1 - h2], again


def fast_top():
    for d in steps(1, 50, 3):
        l3 = 4 / d
        tilt = mpf(1)
        h0 = cos(tilt)
        # Let go at rest: (1 - h^2) 2 Mgl I1 (h0 - h) = L3^2 (h0 - h)^2, so 2 (1 - h^2) = L3^2 (h0 - h).
        square = mpf(l3) ** 2
        low = (square - sqrt(square * square - 16 * (h0 * square / 2 - 1))) / 4
        again = findroot(lambda h: 2 * (1 - h * h) - square * (h0 - h), low)
        yield d, [1.0, 1.0, l3, 1.0], [acos(low) - tilt], [acos(again) - tilt]


def slow_precession():
    for d in steps(1, 60, 4):
        l3 = 4 / d
        a, b, c = mpf(0.5), mpf(l3), mpf(1)
        root = sqrt(b * b - 4 * a * c)
        yield d, [1.0, 1.0, l3, 0.5], [(b - root) / (2 * a)], [2 * c / (b + root)]


# ------------------------------------------------------------------ 2, inertia

CORNERS = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.25, 1.0, 0.0], [0.25, 0.5, 1.0]]


def far_mesh():
    """Moment about the third axis through the centre, of a tetrahedron of density 1 at a distance."""
    for k in range(0, 28, 2):
        away = 2.0**k
        corners = [[Fraction(x) + Fraction(away) for x in corner] for corner in CORNERS]
        edges = [[a - b for a, b in zip(corner, corners[0])] for corner in corners[1:]]
        (a, b, c), (d, e, f), (g, h, i) = edges
        volume = (a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)) / 6
        # The integral of x^2 over a tetrahedron: V/20 (sum of squares + square of the sum).
        about_origin = sum(volume / 20 * (sum(p[k] ** 2 for p in corners) + sum(p[k] for p in corners) ** 2) for k in (0, 1))
        center = [sum(p[k] for p in corners) / 4 for k in range(3)]
        moment = about_origin - volume * (center[0] ** 2 + center[1] ** 2)
        # About the first corner, which needs no place.
        near = [[Fraction(x) for x in corner] for corner in CORNERS]
        middle = [sum(p[k] for p in near) / 4 for k in range(3)]
        again = sum(volume / 20 * sum((p[k] - middle[k]) ** 2 for p in near) for k in (0, 1))
        value = lambda q: mpf(q.numerator) / q.denominator
        yield 1 / away, [away], [value(moment)], [value(again)]


def needle():
    """The least principal moment of a matrix whose first row and column are small."""
    for d in steps(1, 80, 5):
        x, y, z, xy, xz = mpf(d * d), mpf(1), mpf(1), mpf(d) / 2, mpf(d) / 4
        values = mp.eigsy(matrix([[x, xy, xz], [xy, y, 0], [xz, 0, z]]), eigvals_only=True)
        # (x - v)(1 - v)^2 = (xy^2 + xz^2)(1 - v): the least root of a quadratic.
        half, product = (x + 1) / 2, x - xy**2 - xz**2
        again = product / (half + sqrt(half**2 - product))
        yield d, [float(x), float(y), float(z), float(xy), float(xz), 0.0], [min(values)], [again]


# ------------------------------------------------------------------ attitudes and bounces


def small_turn():
    for d in steps(1, 60, 4):
        yield d, [1.0, d, 0.0, 0.0], [2 * atan(mpf(d))], [acos((1 - mpf(d) ** 2) / (1 + mpf(d) ** 2))]


def many_bounces():
    """Velocity and rim speed after n bounces of a homogeneous ball, kappa = 2/5, thrown without spin (4.6)."""
    for n in range(0, 16):
        bounces = 10**n
        kappa = mpf(2) / 5
        angle = 2 * atan(sqrt(kappa)) * bounces
        sense = -1 if bounces % 2 == 0 else 1
        result = [cos(angle), sense * sin(angle) / sqrt(kappa)]
        # The matrices of the bounces, squared and multiplied.
        floor = [[(1 - kappa) / (1 + kappa), 2 * kappa / (1 + kappa)], [2 / (1 + kappa), -(1 - kappa) / (1 + kappa)]]
        product, power, left = mp.eye(2), matrix(floor), bounces
        both = matrix(floor) * 1
        other = matrix([[floor[0][0], -floor[0][1]], [-floor[1][0], floor[1][1]]])
        pair, left = other * both, bounces // 2
        while left:
            if left & 1:
                product = pair * product
            pair, left = pair * pair, left >> 1
        again = (both if bounces % 2 else mp.eye(2)) * product * matrix([1, 0])
        yield 1 / bounces, [float(bounces)], result, [again[0], again[1]]


FAMILIES = [near_separatrix, near_axis, nearly_sphere, long_time, quarter_period, sleeping_top, fast_top, slow_precession, far_mesh, needle, small_turn, many_bounces]


def main():
    table, apart = ["family,nearness,inputs,results"], mpf(0)
    for family in FAMILIES:
        name, worst = family.__name__, mpf(0)
        for nearness, inputs, results, again in family():
            size = sqrt(sum(x * x for x in results))
            worst = max(worst, sqrt(sum((x - y) ** 2 for x, y in zip(results, again))) / size)
            inputs = [float(x) for x in inputs]
            cells = [" ".join(x.hex() for x in inputs), " ".join(nstr(x, 36) for x in results)]
            table.append(f"{name.replace('_', '-')},{float(nearness).hex()},{cells[0]},{cells[1]}")
        print(name, nstr(worst, 2), flush=True)
        assert worst < AGREEMENT, name
        apart = max(apart, worst)
    (HERE / "hard_cases.csv").write_text("\n".join(table) + "\n")
    print(len(table) - 1, "rows, routes apart by", nstr(apart, 2))


if __name__ == "__main__":
    main()
