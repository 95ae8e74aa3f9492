"""What several scripts of this folder compute in the same way: quaternions, Jacobi's functions, the integrands of Carlson's and Legendre's integrals."""

from multiprocessing import Pool

from mpmath import asin, cos, elliprc, elliprf, elliprj, exp, log, mp, mpf, nstr, sin, sqrt


def product(p, q):
    a, b, c, d = p
    w, x, y, z = q
    return [a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y, a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w]


def ladder(mc):
    """Arithmetic-geometric mean of 1 and sqrt(mc): the mean, and the ratios c_n/a_n that lead back from the last."""
    a, b, ratios = mpf(1), sqrt(mc), []
    while abs(a - b) > a * mpf(10) ** (-mp.dps + 3):
        a, b, c = (a + b) / 2, sqrt(a * b), (a - b) / 2
        ratios.append(c / a)
    return a, ratios


def jacobi(u, mc, mean, ratios):
    """sn, cn, dn for |u| <= K."""
    angle = mean * u * 2 ** len(ratios)
    for ratio in reversed(ratios):
        angle = (angle + asin(ratio * sin(angle))) / 2
    sn, cn = sin(angle), cos(angle)
    return sn, cn, sqrt(mc + (1 - mc) * cn * cn)


def first_kind(sn, cn, dn):
    return sn * elliprf(cn * cn, dn * dn, 1)


def rj(x, y, z, p):
    """R_J with the principal value for p < 0 (Digital Library of Mathematical Functions 19.20.14)."""
    if p > 0:
        return elliprj(x, y, z, p)
    x, y, z = sorted((x, y, z))
    q = -p
    p = (z * (x + y + q) - x * y) / (z + q)
    return ((p - z) * elliprj(x, y, z, p) - 3 * elliprf(x, y, z)
            + 3 * sqrt(x * y * z / (x * y + p * q)) * elliprc(x * y + p * q, p * q)) / (z + q)


def carlsons_integrand(which, a):
    return {
        "RF": lambda t: 1 / sqrt((t + a[0]) * (t + a[1]) * (t + a[2])) / 2,
        "RC": lambda t: 1 / sqrt(t + a[0]) / (t + a[1]) / 2,
        "RD": lambda t: 3 / sqrt((t + a[0]) * (t + a[1]) * (t + a[2])) / (t + a[2]) / 2,
        "RJ": lambda t: 3 / sqrt((t + a[0]) * (t + a[1]) * (t + a[2])) / (t + a[3]) / 2,
        "RG": lambda t: t / sqrt((t + a[0]) * (t + a[1]) * (t + a[2])) * sum(v / (t + v) for v in a if v) / 4,
    }[which]


def legendres_integrand(which, a, b, e, r):
    """By t = cot² of the angle from its end, c0: a = c0, b = c0 + mc, e = c0 + 1, r = c0 + nc."""
    return {
        "F": lambda t: 1 / sqrt((t + a) * (t + b) * (t + e)),
        "E": lambda t: sqrt((t + b) / (t + a) / (t + e)) / (t + e),
        "D": lambda t: 1 / (sqrt((t + a) * (t + b) * (t + e)) * (t + e)),
        "B": lambda t: sqrt((t + a) / (t + b) / (t + e)) / (t + e),
        "P": lambda t: sqrt((t + e) / (t + a) / (t + b)) / (t + r),
    }[which]


def trapezoid(integrand, places, expected, pole, digits, margin, steps):
    """Integral of integrand(t) over 0…∞, whose features lie at t = places, by equal steps of v where t = e^v."""
    loss = 0
    if pole:
        # Next to the pole the terms exceed the result, which they cancel to.
        loss = max(0, int(mp.log10(abs(integrand(pole * mpf(1.1)) * pole / expected))) + 1)
    mp.dps = digits + loss
    places = [log(abs(p)) for p in places if p != 0]
    margin += 5 * loss
    low, high = min(places) - margin, max(places) + margin
    step = mpf(8) / (steps + loss)
    start = log(pole) + step / 2 if pole else low
    start -= step * int((start - low) / step)
    total, t, ratio = mpf(0), exp(start), exp(step)
    while start < high:
        total += integrand(t) * t
        t *= ratio
        start += step
    return total * step


def rows_by_two_routes(compute, cases, only, most):
    """The rows of the cases whose group has `only` in its name, and how far two routes differ; tells those that differ by more than `most`."""
    numbers = [k for k, c in enumerate(cases) if only in c[0]]
    rows, worst, both = [], mpf(0), 0
    with Pool(2) as pool:
        for (row, agreement, turns), k in zip(pool.imap(compute, numbers, 4), numbers):
            rows.append(row)
            if agreement:
                both += 1
                worst = max(worst, agreement[0])
                if agreement[0] > most:
                    print("DISAGREE", nstr(agreement[0], 3), "steps", agreement[1], cases[k], "turns", nstr(turns, 3), flush=True)
    print(len(rows), "rows,", both, "by both routes, which differ by at most", nstr(worst, 3))
    return rows, worst
