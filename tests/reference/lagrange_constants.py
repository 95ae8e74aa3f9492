"""Writes lagrange_constants.csv: turning points, period of nutation and azimuth per nutation of the tops of lagrange_top.csv.

    pip install mpmath gmpy2 && python3 lagrange_constants.py

One row a top that nutates or precesses purely (Mgl > 0, no separatrix). Columns: group, I1, I3, Mgl, w1 w2 w3 and p0 p1 p2 p3
as in lagrange_top.csv; then 1 - h1, 1 - h2, 1 + h1, 1 + h2, h3 - 1, the period, and the azimuth in a nutation; nan where the axis
passes through a pole, and has no azimuth there. Decimal, 32 digits.

Two routes: the complete integrals of lagrange_top.py, whose roots come from the cosine of a third of an angle, and the equal
ordinates of a periodic function, dt = du sqrt(I1/(2 Mgl (h3 - h))) with h = middle + half cos u, for every top whose band keeps a
thousandth away from h3 and from both poles. As last run: 100 of 200 rows both ways, 4.7e-49 apart at most.
"""

from pathlib import Path

from lagrange_top import Top, cases, cos, exact, mp, mpf, nstr, pi, sqrt

ORDINATES = 1500


def sums(top, h1, h2, h3):
    """Period and azimuth by equal ordinates, in the top's units."""
    g, l3, lv = exact(top.g), exact(top.l3), exact(top.lv)
    time, azimuth = mpf(0), mpf(0)
    for k in range(ORDINATES):
        h = (h1 + h2) / 2 + (h2 - h1) / 2 * cos(pi * (2 * k + 1) / (2 * ORDINATES))
        step = 1 / sqrt(2 * g * (h3 - h))
        time += step
        azimuth += step * (lv - l3 * h) / (1 - h * h)
    return [2 * pi / ORDINATES * x for x in (time, azimuth)]


def constants(top):
    mp.dps = top.dps
    l3, lv = exact(top.l3), exact(top.lv)
    if top.kind == "pure":
        h1 = h2 = exact(top.double)
        h3 = exact(top.simple)
        azimuth = (lv - l3 * h1) / (1 - h1 * h1) * pi / top.rate
    else:
        h1, h2, h3 = top.h1, top.h2, top.h3
        azimuth = mpf("nan")
        if not (top.bottom or top.top):
            terms = [l * third[3] / (third[0] * top.rate) for l, third in ((lv + l3, top.thirds[0]), (lv - l3, top.thirds[1]))]
            azimuth = sum(terms)
    period = top.period()
    apart = None
    if h3 - h2 > mpf("1e-3") and h2 < mpf("0.999") and h1 > mpf("-0.999") and h3 < 1e20:
        mp.dps = 50
        by_sums = sums(top, h1, h2, h3)
        apart = max(abs(by_sums[0] * exact(top.unit) / period - 1), abs(by_sums[1] - azimuth) / max(1, abs(azimuth)))
        mp.dps = top.dps
    return [1 - h1, 1 - h2, 1 + h1, 1 + h2, h3 - 1, period, azimuth], apart


if __name__ == "__main__":
    rows, worst, both, seen = [], mpf(0), 0, set()
    for group, body, omega, q, _ in cases:
        key = tuple(body + omega + q)
        if key in seen or body[2] <= 0:
            continue
        seen.add(key)
        top = Top(*body, omega, q)
        if top.kind not in ("pure", "nutation"):
            continue
        values, apart = constants(top)
        if apart is not None:
            both += 1
            worst = max(worst, apart)
            if apart > mpf(10) ** -30:
                print("DISAGREE", nstr(apart, 3), group, body, omega, q)
        rows.append(",".join([group] + [x.hex() for x in body + omega + q] + [nstr(x, 32) for x in values]))
    print(len(rows), "rows,", both, "by both routes, which differ by at most", nstr(worst, 3))
    header = "group,I1,I3,Mgl,w1,w2,w3,p0,p1,p2,p3,less1,less2,more1,more2,beyond3,period,azimuth"
    if worst < mpf(10) ** -30:
        Path(__file__).with_suffix(".csv").write_text("\n".join([header] + rows) + "\n")
