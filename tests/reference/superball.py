"""Reference values of superballs after many bounces and at distant times: writes superball.csv beside this file. Needs mpmath.

Inputs are doubles, given as their shortest decimals and read back exactly; 90 digits carried, 34 printed.
A row without a time is UnderTable's: after `bounces` bounces off floor, ceiling, floor, ..., V and R Omega.
A row with a time is the ball of a flight: bounces so far, V, R Omega, x, height, climb; `room` and `gravity` are empty where there is none.
V_n = Re (V - i sqrt(kappa) R Omega) z^n with z = exp(i delta), tan(delta/2) = sqrt(kappa); where there are few bounces, they are made one by one as well.
"""

from pathlib import Path
from mpmath import atan, expj, floor, im, mp, mpf, nstr, re, sqrt

mp.dps = 90
HEAD = "kappa,gravity,room,height,climb,velocity,rim_speed,time,bounces,velocity_after,rim_speed_after,x,height_after,climb_after"


def one(v, w, floor_next, kappa):
    u = v - w if floor_next else v + w
    t = 2 * u / (1 + kappa)
    return v - kappa * t, w + t if floor_next else w - t


def after(kappa, v, w, n):
    """After n bounces, floor first."""
    z = expj(2 * atan(sqrt(kappa)) * n)
    a = (v - mp.j * sqrt(kappa) * w) * z
    # Odd n: a reflection, the companion of V with its sign turned.
    rim = -im(a) / sqrt(kappa)
    result = re(a), -rim if n % 2 else rim
    if n <= 2000:
        m = v, w
        for k in range(n):
            m = one(*m, k % 2 == 0, kappa)
        assert max(abs(m[i] - result[i]) for i in (0, 1)) < mpf(10) ** -70 * (1 + abs(result[1])), (m, result)
    return result


def place(kappa, v, w, n):
    """V_1 + ... + V_n."""
    z = expj(2 * atan(sqrt(kappa)))
    total = re((v - mp.j * sqrt(kappa) * w) * z * (z ** n - 1) / (z - 1))
    if n <= 200:
        assert abs(total - sum(after(kappa, v, w, k)[0] for k in range(1, n + 1))) < mpf(10) ** -60
    return total


def flight(kappa, g, room, h, climb, v, w, t):
    floor_speed = sqrt(climb ** 2 + 2 * g * h)
    ceiling_square = None if room is None else climb ** 2 - 2 * g * (room - h)
    ceiling = sqrt(ceiling_square) if room is not None and ceiling_square > 0 else None
    if climb > 0 and ceiling is not None:
        first, ceiling_first = 2 * (room - h) / (climb + ceiling), True
    else:
        first, ceiling_first = (climb + floor_speed) / g if g else h / -climb, False
    if t < first:
        n, later, x = 0, t, mpf(0)
        base, up, motion = h, climb, (v, w)
    else:
        wait = 2 * room / (floor_speed + ceiling) if ceiling is not None else 2 * floor_speed / g
        whole = int(floor((t - first) / wait))
        n, later = whole + 1, t - first - whole * wait
        if ceiling is None:
            odd = one(v, w, True, kappa)
            motion = odd if n % 2 else (v, w)
            x = first * v + wait * (odd[0] * ((whole + 1) // 2) + v * (whole // 2))
            base, up = mpf(0), floor_speed
        else:
            sign = -1 if ceiling_first else 1
            motion = after(kappa, v, sign * w, n)
            motion = motion[0], sign * motion[1]
            x = first * v + wait * place(kappa, v, sign * w, whole)
            at_ceiling = ceiling_first == (whole % 2 == 0)
            base, up = (room, -ceiling) if at_ceiling else (mpf(0), floor_speed)
    return n, *motion, x + later * motion[0], base + later * (up - g * later / 2), up - g * later


rows = [HEAD]
for kappa in ["0.4", "0.6666666666666666", "0.5", "0.3333333333333333", "1.0", "0.25", "0.1715728752538097", "0.1", "0.9", "0.001", "1e-06", "0.7"]:
    for v, w in [("1.0", "0.0"), ("0.6", "-1.7"), ("0.1", "3.3")]:
        for n in [1, 2, 3, 10, 999, 1000, 200_000, 1_999_999, 2_000_000]:
            found = after(mpf(float(kappa)), mpf(float(v)), mpf(float(w)), n)
            cells = [kappa, "", "", "", "", v, w, "", str(n), *(nstr(x, 34) for x in found), "", "", ""]
            rows.append(",".join(cells))
for kappa, g, room, h, climb, v, w in [
    ("0.4", "9.81", "0.6", "0.3", "-5.0", "2.0", "0.7"),
    ("0.4", "9.81", "0.6", "0.3", "5.0", "2.0", "0.7"),
    ("0.4", "9.81", "", "0.3", "1.5", "2.0", "0.7"),
    ("0.6666666666666666", "9.81", "1.0", "0.25", "0.0", "-1.0", "3.0"),
    ("0.5", "", "0.7", "0.1", "3.0", "1.0", "-0.3"),
    ("0.25", "1.6", "2.0", "0.0", "2.6", "0.5", "0.0"),
]:
    for t in ["0.05", "1.0", "1000.3", "1234567.8", "1e9", "3e12", "1e14"]:
        of = lambda text: None if text == "" else mpf(float(text))
        n, *found = flight(of(kappa), of(g) or mpf(0), of(room), *map(of, (h, climb, v, w, t)))
        rows.append(",".join([kappa, g, room, h, climb, v, w, t, str(n), *(nstr(x, 34) for x in found)]))
Path(__file__).with_suffix(".csv").write_text("\n".join(rows) + "\n")
