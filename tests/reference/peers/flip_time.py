"""Writes flip_time.csv: where well-known libraries give up on a racket that starts nearly on its middle axis.

See README.md beside this file. I = (1, 2, 3), Omega(0) = (eps, 1, eps); a flip takes half a period of Omega.
"""

import subprocess
import sys
import tempfile
import warnings
from math import atan2, cos, floor, hypot, inf, nan, sin, sqrt
from pathlib import Path

import numpy
import scipy
from mpmath import mp, mpf, nstr
from scipy.integrate import solve_ivp
from scipy.special import ellipj, ellipk, ellipkm1, elliprf, elliprj

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE.parent))
sys.dont_write_bytecode = True
import free_top  # noqa: E402

MOMENTS = [1.0, 2.0, 3.0]
I1, I2, I3 = MOMENTS
EPSILONS = [float(f"{m}e-{k}") for k in range(1, 21) for m in ("1", "3.1622776601683794")] + [1e-30, 1e-100, 1e-150, 1e-160, 1e-300]
EPSILONS = sorted((x for x in EPSILONS if x <= 0.1), reverse=True)
numpy.seterr(all="ignore")
warnings.simplefilter("ignore")


def exact(eps):
    """Flip time, the moment half a flip after the start and the moment ten periods after it, and the states there."""
    body = free_top.Body(MOMENTS, [m * w for m, w in zip(MOMENTS, (eps, 1.0, eps))])
    mp.dps = body.dps
    flip = body.period() / 2
    t1, t2 = float(flip / 2), float(20 * flip)
    return flip, t1, t2, body.at(t1), body.at(t2)


def quaternion_about(axis, angle):
    q = [cos(angle / 2), 0.0, 0.0, 0.0]
    q[axis] = sin(angle / 2)
    return q


class TextbookTop:
    """Tutorial 6.6 in doubles with SciPy's functions; `complement` says whether K is asked by 1 - m."""

    def __init__(self, w, complement):
        twice_energy = I1 * w[0] ** 2 + I2 * w[1] ** 2 + I3 * w[2] ** 2
        square = (I1 * w[0]) ** 2 + (I2 * w[1]) ** 2 + (I3 * w[2]) ** 2
        root = numpy.sqrt
        self.w, self.l = w, sqrt(square)
        self.rate = sqrt((I3 - I2) * (square - twice_energy * I1) / (I1 * I2 * I3))
        self.m = (I2 - I1) * (twice_energy * I3 - square) / ((I3 - I2) * (square - twice_energy * I1))
        mc = (I3 - I1) * (square - twice_energy * I2) / ((I3 - I2) * (square - twice_energy * I1))
        self.k = float(ellipkm1(mc) if complement else ellipk(self.m))
        self.a1 = root((twice_energy * I3 - square) / (I1 * (I3 - I1)))
        self.a2 = root((twice_energy * I3 - square) / (I2 * (I3 - I2)))
        self.a3 = root((square - twice_energy * I1) / (I3 * (I3 - I1)))
        self.n = -I3 * (I2 - I1) / (I1 * (I3 - I2))
        self.pi_k = self.third(1.0, 0.0)
        angle = atan2(w[1] / self.a2, w[0] / self.a1)
        s, c = sin(angle), cos(angle)
        self.phase = s * elliprf(c * c, 1 - self.m * s * s, 1)
        self.third0 = self.third(s, c)

    def third(self, s, c):
        y = 1 - self.m * s * s
        return s * elliprf(c * c, y, 1) + self.n / 3 * s**3 * elliprj(c * c, y, 1, 1 - self.n * s * s)

    def flip_time(self):
        return 2 * self.k / self.rate

    def omega(self, t):
        sn, cn, dn, _ = ellipj(self.rate * t + self.phase, self.m)
        return [self.a1 * cn, self.a2 * sn, self.a3 * dn]

    def tilted(self, w, sense):
        x, y, z = I1 * w[0], I2 * w[1], I3 * w[2]
        tilt, heading = atan2(hypot(x, y), z), atan2(y, x)
        parts = [quaternion_about(3, heading), quaternion_about(2, tilt)] if sense > 0 else [quaternion_about(2, -tilt), quaternion_about(3, -heading)]
        return free_top.product(*parts)

    def attitude(self, t):
        u = self.rate * t + self.phase
        if not self.k < inf:
            return [nan] * 4
        halves = floor(u / (2 * self.k) + 0.5)
        sn, cn, _, _ = ellipj(u - 2 * halves * self.k, self.m)
        turned = self.third(sn, cn) + 2 * halves * self.pi_k - self.third0
        azimuth = self.l * t / I3 + self.l * (I3 - I1) / (I1 * I3 * self.rate) * turned
        return free_top.product(free_top.product(self.tilted(self.w, 1), quaternion_about(3, azimuth)), self.tilted(self.omega(t), -1))


def integrated(method, eps, t1, t2, flip):
    """Euler's equations and the quaternion by an integrator; the flip is the time between two zeros of Omega_2."""

    def motion(_, y):
        a, b, c, q0, q1, q2, q3 = y
        return [
            (I2 - I3) / I1 * b * c,
            (I3 - I1) / I2 * c * a,
            (I1 - I2) / I3 * a * b,
            -(q1 * a + q2 * b + q3 * c) / 2,
            (q0 * a + q2 * c - q3 * b) / 2,
            (q0 * b + q3 * a - q1 * c) / 2,
            (q0 * c + q1 * b - q2 * a) / 2,
        ]

    def edge(_, y):
        return y[1]

    start = [eps, 1.0, eps, 1.0, 0.0, 0.0, 0.0]
    run = solve_ivp(motion, (0, t2), start, method=method, rtol=1e-12, atol=1e-12, t_eval=[t1, t2], events=edge)
    zeros = run.t_events[0]
    return (zeros[1] - zeros[0] if len(zeros) > 1 else inf), run.y[:3, 0], run.y[:3, 1], run.y[3:, 1]


def errors(flip_exact, state1, state2, flip, one, two, q):
    """Relative error of the flip time, of Omega at both moments, and the angle between the attitudes; nan where nothing came."""

    def number(f):
        try:
            value = f()
        except (ValueError, OverflowError):
            return "nan"
        return "nan" if mp.isnan(value) else "inf" if mp.isinf(value) else nstr(value, 3, min_fixed=0, max_fixed=0)

    def omega(found, state):
        w = [l / m for l, m in zip(state[0], MOMENTS)]
        d = mp.sqrt(sum((mpf(float(a)) - b) ** 2 for a, b in zip(found, w)))
        return d / mp.sqrt(sum(x * x for x in w))

    def attitude():
        p = [mpf(float(x)) for x in q]
        size = mp.sqrt(sum(x * x for x in p))
        a = state2[1]
        d = free_top.product([a[0]] + [-x for x in a[1:]], [x / size for x in p])
        return 2 * mp.atan2(mp.sqrt(sum(x * x for x in d[1:])), abs(d[0]))

    return [number(lambda: abs(mpf(float(flip)) / flip_exact - 1)), number(lambda: omega(one, state1)), number(lambda: omega(two, state2)), number(attitude)]


def main():
    truth = {eps: exact(eps) for eps in EPSILONS}
    rows = []

    def record(library, version, eps, flip, one, two, q):
        flip_exact, _, _, state1, state2 = truth[eps]
        shown = "nan" if flip != flip else repr(float(flip))
        rows.append([library, version, repr(eps), shown] + errors(flip_exact, state1, state2, flip, one, two, q))

    for eps in EPSILONS:
        rows.append(["exact", "", repr(eps), nstr(truth[eps][0], 20), "0", "0", "0", "0"])
    for name, complement in ("SciPy ellipk", False), ("SciPy ellipkm1", True):
        for eps in EPSILONS:
            _, t1, t2, _, _ = truth[eps]
            top = TextbookTop([eps, 1.0, eps], complement)
            record(name, scipy.__version__, eps, top.flip_time(), top.omega(t1), top.omega(t2), top.attitude(t2))
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "flip_time"
        subprocess.run(["g++", "-std=c++17", "-O2", "-o", program, HERE / "flip_time.cpp", "-lgsl", "-lgslcblas"], check=True)
        lines = "".join(f"{eps.hex()} {truth[eps][1].hex()} {truth[eps][2].hex()}\n" for eps in EPSILONS)
        output = subprocess.run([program], input=lines, capture_output=True, text=True, check=True).stdout
    found = [line.split() for line in output.splitlines()]
    number = lambda text: nan if "nan" in text else inf if text == "inf" else -inf if text == "-inf" else float.fromhex(text)
    for library in "GSL", "Boost.Math", "libstdc++":
        for fields in found:
            if fields[0] == library:
                v = [number(x) for x in fields[2:]]
                record(library, fields[1], v[0], v[1], v[2:5], v[5:8], v[8:12])
    for method in "DOP853", "LSODA":
        for eps in EPSILONS:
            flip, t1, t2, _, _ = truth[eps]
            record(f"SciPy solve_ivp {method}", scipy.__version__, eps, *integrated(method, eps, t1, t2, flip))
            print(rows[-1], flush=True)
    header = "library,version,epsilon,flip_time,flip_time_error,omega_half_flip_error,omega_ten_periods_error,attitude_ten_periods_error"
    (HERE / "flip_time.csv").write_text("\n".join([header] + [",".join(row) for row in rows]) + "\n")
    for library in dict.fromkeys(row[0] for row in rows):
        mine = [row for row in rows if row[0] == library]
        for column, what in (4, "flip time"), (5, "Omega at half a flip"), (6, "Omega after ten periods"), (7, "attitude after ten periods"):
            lost = [float(row[2]) for row in mine if not float(row[column]) <= 1e-3]
            print(f"{library:>24}: {what} lost at eps = {max(lost):.0e}" if lost else f"{library:>24}: {what} never lost")


main()
