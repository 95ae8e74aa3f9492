"""Coefficients of the modified moments of inertia for the discrete Moser-Veselov algorithm, orders 4 to 10.

Hairer and Vilmart (2006) give s3 and d3; here all are found by matching power series, in exact rationals. With a_j = 1/I_j, e1, e2, e3 their
elementary symmetric functions, H the energy and C = |L|^2/2, the algorithm with

    1/I~_j = (1 + h^2 s3 + h^4 s5 + h^6 s7 + h^8 s9) a_j + (h^2 d3 + h^4 d5 + h^6 d7 + h^8 d9)

has order 10. At one point (a, L) the coefficient of h^(2k+1) in one step of the algorithm, less that of the exact motion, gives the numbers s and d:
s multiplies L x aL in the momentum, s aL + d L in the attitude. Polynomials in e1, e2, e3, H, C of the right degree are then fitted through
as many random points as they have coefficients, and checked at eight more. All three components of both vectors must agree at every point, so a
mistake cannot hide.

    python3 moser_veselov.py > moser_veselov.csv        (half a minute)
"""

import random
import sys
from fractions import Fraction as F

N = 10  # powers of h kept: h^0 ... h^9


def mul(p, q):
    r = [F(0)] * N
    for i, x in enumerate(p):
        if x:
            for j in range(N - i):
                if q[j]:
                    r[i + j] += x * q[j]
    return r


def add(p, q):
    return [x + y for x, y in zip(p, q)]


def sub(p, q):
    return [x - y for x, y in zip(p, q)]


def const(x):
    return [F(x)] + [F(0)] * (N - 1)


def inverse(p):
    r = [1 / p[0]]
    for n in range(1, N):
        r.append(-sum(p[k] * r[n - k] for k in range(1, n + 1)) / p[0])
    return r


def root(p):
    """Square root of a series that begins with 1."""
    r = [F(1)]
    for n in range(1, N):
        r.append((p[n] - sum(r[k] * r[n - k] for k in range(1, n))) / 2)
    return r


def cross(u, v):
    return [sub(mul(u[(i + 1) % 3], v[(i + 2) % 3]), mul(u[(i + 2) % 3], v[(i + 1) % 3])) for i in range(3)]


def exact(a, y):
    """L and the attitude quaternion as series in h."""
    L = [[F(c)] for c in y]
    q = [[F(1)], [F(0)], [F(0)], [F(0)]]
    for n in range(N - 1):
        for i in range(3):
            pass
        dot = []
        for i in range(3):
            j, k = (i + 1) % 3, (i + 2) % 3
            dot.append(sum(L[j][m] * L[k][n - m] for m in range(n + 1)) * (a[k] - a[j]) / (n + 1))
        o = [[a[i] * L[i][m] for m in range(n + 1)] for i in range(3)]
        w, x, y_, z = q
        pr = lambda p, r: sum(p[m] * r[n - m] for m in range(n + 1))
        dq = [
            -pr(x, o[0]) - pr(y_, o[1]) - pr(z, o[2]),
            pr(w, o[0]) + pr(y_, o[2]) - pr(z, o[1]),
            pr(w, o[1]) + pr(z, o[0]) - pr(x, o[2]),
            pr(w, o[2]) + pr(x, o[1]) - pr(y_, o[0]),
        ]
        for i in range(3):
            L[i].append(dot[i])
        for i in range(4):
            q[i].append(dq[i] / 2 / (n + 1))
    return L, q


def moser_veselov(a, y):
    """The same by one step; `a` are series. h L/2 = r0 I r + r x I r, with (r0, r) the turn."""
    I = [inverse(c) for c in a]
    g = [[F(0), F(c) / 2] + [F(0)] * (N - 2) for c in y]
    r = [mul(a[i], g[i]) for i in range(3)]
    for _ in range(N):
        r0 = root(sub(const(1), add(add(mul(r[0], r[0]), mul(r[1], r[1])), mul(r[2], r[2]))))
        c = cross(r, [mul(I[i], r[i]) for i in range(3)])
        inv = inverse(r0)
        r = [mul(a[i], mul(sub(g[i], c[i]), inv)) for i in range(3)]
    r0 = root(sub(const(1), add(add(mul(r[0], r[0]), mul(r[1], r[1])), mul(r[2], r[2]))))
    c = cross(r, [mul(I[i], r[i]) for i in range(3)])
    # L(h) = L - (4/h) r x I r; the power that division by h loses is not needed.
    L = [[F(y[i]) * (m == 0) - (4 * c[i][m + 1] if m + 1 < N else 0) for m in range(N)] for i in range(3)]
    return L, [r0] + r


def coefficients(a, y):
    """[(s3, d3), ..., (s9, d9)] at this point."""
    exact_L, exact_q = exact(a, y)
    series = [const(c) for c in a]
    found = []
    for power in (2, 4, 6, 8):
        L, q = moser_veselov(series, y)
        for m in range(power + 1):
            assert all(L[i][m] == exact_L[i][m] for i in range(3)), "momentum"
            assert all(q[i][m] == exact_q[i][m] for i in range(4)), "attitude"
        # q gains h/2 (s aL + d L) h^power.
        miss = [2 * (exact_q[i + 1][power + 1] - q[i + 1][power + 1]) for i in range(3)]
        s = (miss[0] / y[0] - miss[1] / y[1]) / (a[0] - a[1])
        d = miss[0] / y[0] - s * a[0]
        assert miss[2] == s * a[2] * y[2] + d * y[2], "not of the form s aL + d L"
        found.append((s, d))
        for j in range(3):
            series[j][power] += s * a[j] + d
    return found


def monomials(degree_y, degree_a):
    """Exponents (p, q, m1, m2, m3): H^p C^q e1^m1 e2^m2 e3^m3 with that many factors L^2 and a."""
    out = []
    for q in range(degree_y + 1):
        p = degree_y - q
        rest = degree_a - p
        for m3 in range(rest // 3 + 1):
            for m2 in range((rest - 3 * m3) // 2 + 1):
                out.append((p, q, rest - 3 * m3 - 2 * m2, m2, m3))
    return out


def value(mono, a, y):
    H = sum(a[i] * y[i] ** 2 for i in range(3)) / 2
    C = sum(c * c for c in y) / F(2)
    e1, e2, e3 = sum(a), a[0] * a[1] + a[1] * a[2] + a[2] * a[0], a[0] * a[1] * a[2]
    p, q, m1, m2, m3 = mono
    return H**p * C**q * e1**m1 * e2**m2 * e3**m3


def solve(matrix, right):
    n = len(matrix[0])
    rows = [row[:] + [b] for row, b in zip(matrix, right)]
    for c in range(n):
        pivot = next(r for r in range(c, len(rows)) if rows[r][c])
        rows[c], rows[pivot] = rows[pivot], rows[c]
        scale = rows[c][c]
        rows[c] = [x / scale for x in rows[c]]
        for r in range(len(rows)):
            if r != c and rows[r][c]:
                f = rows[r][c]
                rows[r] = [x - f * z for x, z in zip(rows[r], rows[c])]
    assert all(not row[n] for row in rows[n:]), "the ansatz does not fit"
    return [rows[c][n] for c in range(n)]


def main():
    random.seed(1)
    points = []
    while len(points) < 60:
        a = [F(random.randint(1, 9)) for _ in range(3)]
        y = [F(random.choice([-5, -4, -3, -2, -1, 1, 2, 3, 4, 5])) for _ in range(3)]
        if len(set(a)) == 3:
            points.append((a, y, coefficients(a, y)))
    print("name,H,C,e1,e2,e3,numerator,denominator")
    for k, number in enumerate((3, 5, 7, 9)):
        for which, name, extra in ((0, "s", 0), (1, "d", 1)):
            monos = monomials(k + 1, 2 * (k + 1) + extra)
            used = points[: len(monos) + 8]
            c = solve([[value(m, a, y) for m in monos] for a, y, _ in used], [f[k][which] for _, _, f in used])
            for m, x in zip(monos, c):
                if x:
                    print(f"{name}{number}," + ",".join(map(str, m)) + f",{x.numerator},{x.denominator}")
            sys.stdout.flush()


main()
