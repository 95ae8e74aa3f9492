"""Writes accuracy.csv: the motions by which `lab::accuracy` judges.

    pip install mpmath gmpy2 && python3 accuracy.py

One row a sample. Columns: problem (name/turns), t as a hexadecimal float, the attitude qw qx qy qz (body axes into space axes; a
quaternion and its negative are one attitude) and the angular velocity omega1 omega2 omega3 along the body's axes (rad/s), 36 digits.
The problems below are given in exact doubles, and so are the times: sixteenths of N turns, a turn being 2 pi/|Omega(0)| rounded to a few
bits, three times a short fraction: halves, quarters … and thirds of a run are doubles, too.

Routes, none of which shares a line with the library:
  closed form  of free_top.py (Jacobi's functions, Carlson's integrals, 110 digits) for the free bodies and of lagrange_top.py for the
               symmetric tops, 10^6 turns included;
  taylor       L' = L x Omega + z x c, z' = z x Omega, q' = q Omega/2 as power series in time, step after step, up to 1000 turns. For
               the tippe top Newton's law in body axes with the velocity of C in all three components.
Up to 1000 turns free and symmetric bodies are computed both ways. The others are computed by power series of two orders and precisions,
must keep energy, L along the vertical (Kovalevskaya's integral, too) and agree with equations written elsewhere: the tippe top's rates with
those of tippe_top.py, its first sixteenth of a turn with Gragg, Bulirsch and Stoer's extrapolation there. Nothing is written if any two
differ by more than 1e-30. As last run: 3e-47 to 2e-40 apart for those with a closed form, 1e-36 Kovalevskaya's top, 8e-39 the heavy body,
3e-41 the tippe top from the extrapolation. Neighbouring starts of the heavy body part in proportion to the time (30-fold in 300 turns).
"""

import sys
from multiprocessing import Pool
from operator import mul
from pathlib import Path

import gmpy2
from gmpy2 import mpfr
from mpmath import mp, mpf

import free_top
import lagrange_top
import tippe_top

HERE = Path(__file__).parent
AGREEMENT = 1e-30
SAMPLES = 16
HALF = (0.5, 0.5, 0.5, 0.5)
LEVEL = (1.0, 0.0, 0.0, 0.0)

# moments, lever MgC, L along the body's axes, attitude, length of a turn, lengths of the runs in turns
PROBLEMS = {
    "free-top": ((0.6, 0.8, 1.0), (0.0, 0.0, 0.0), (1.8, 0.4, -0.9), LEVEL, 1.96875, (1, 10, 1000, 10**6)),
    "near-separatrix": ((1.5, 3.0, 4.0), (0.0, 0.0, 0.0), (1.0 + 2.0**-24, 1.0, 2.0), LEVEL, 6.984375, (1, 10, 1000, 10**6)),
    "cusped-top": ((1.0, 1.0, 0.5), (0.0, 0.0, 1.0), (0.0, 0.0, 3.0), HALF, 1.048828125, (1, 10, 1000, 10**6)),
    "near-sleeping": ((1.0, 1.0, 0.5), (0.0, 0.0, 1.0), (2.0**-10, 0.0, 1.75), LEVEL, 1.79296875, (1, 10, 1000, 10**6)),
    "kovalevskaya": ((2.0, 2.0, 1.0), (1.0, 0.0, 0.0), (1.5, 1.0, 1.25), LEVEL, 4.078125, (1, 10, 1000)),
    "kovalevskaya-level": ((2.0, 2.0, 1.0), (1.0, 0.0, 0.0), (1.5, 1.0, 1.25), HALF, 4.078125, (1, 10, 1000)),
    "heavy-body": ((1.0, 1.5, 2.0), (0.25, 0.125, 0.5), (0.5, 0.375, 6.0), HALF, 2.0625, (1, 10, 1000)),
    "tippe-top": (None, None, None, LEVEL, 0.04046630859375, (1, 10, 100)),
}
# mass, moments across and along the axis, radius, height of the centre over C, gravity, friction, angular velocity
TIPPE = (0.02, 3e-6, 3.2e-6, 0.02, 0.006, 9.81, 0.3, (8.0, 0.0, 155.0))


def times_of(name):
    turn, lengths = PROBLEMS[name][4], PROBLEMS[name][5]
    return {n: [turn * n * k / SAMPLES for k in range(1, SAMPLES + 1)] for n in lengths}


# ---------------------------------------------------------------- power series


def conv(a, b):
    """The last coefficient of a product of two series."""
    return sum(map(mul, a, reversed(b)))


def cross(a, b):
    return [conv(a[1], b[2]) - conv(a[2], b[1]), conv(a[2], b[0]) - conv(a[0], b[2]), conv(a[0], b[1]) - conv(a[1], b[0])]


def turned(q, w):
    """2q' = q Omega."""
    (q0, q1, q2, q3), (w1, w2, w3) = q, w
    return [
        -conv(q1, w1) - conv(q2, w2) - conv(q3, w3),
        conv(q0, w1) + conv(q2, w3) - conv(q3, w2),
        conv(q0, w2) + conv(q3, w1) - conv(q1, w3),
        conv(q0, w3) + conv(q1, w2) - conv(q2, w1),
    ]


def vertical(q):
    w, x, y, z = q
    return [2 * (x * z - w * y), 2 * (y * z + w * x), w * w + z * z - x * x - y * y]


class Top:
    """A body with a fixed point: numbers L, z, q."""

    def __init__(self, name):
        moments, lever, l, q = PROBLEMS[name][:4]
        self.moments = [mpfr(x) for x in moments]
        self.inverse = [1 / x for x in self.moments]
        self.lever = [mpfr(x) for x in lever]
        q = [mpfr(x) for x in q]
        self.start = [mpfr(x) for x in l] + vertical(q) + q

    def series(self, y, order):
        s = [[x] for x in y]
        w = [[x * i] for x, i in zip(y, self.inverse)]
        l, z, q = s[:3], s[3:6], s[6:]
        c = self.lever
        for n in range(order):
            gyro, dz, dq = cross(l, w), cross(z, w), turned(q, w)
            for a in range(3):
                b, d = (a + 1) % 3, (a + 2) % 3
                l[a].append((gyro[a] + z[b][n] * c[d] - z[d][n] * c[b]) / (n + 1))
            for a in range(3):
                z[a].append(dz[a] / (n + 1))
                w[a].append(l[a][-1] * self.inverse[a])
            for a in range(4):
                q[a].append(dq[a] / (2 * (n + 1)))
        return s

    def checks(self, y):
        """What must stay."""
        l, z = y[:3], y[3:6]
        w = [a * b for a, b in zip(l, self.inverse)]
        up = vertical(y[6:])
        energy = sum(a * b for a, b in zip(l, w)) / 2 + sum(a * b for a, b in zip(z, self.lever))
        kept = [energy, sum(a * b for a, b in zip(l, z)), sum(a * a for a in y[6:])]
        if self.moments == [2, 2, 1]:
            c = self.lever[0] / self.moments[2]
            kept.append((w[0] ** 2 - w[1] ** 2 - c * z[0]) ** 2 + (2 * w[0] * w[1] - c * z[1]) ** 2)
        return kept, [a - b for a, b in zip(up, z)]

    def answer(self, y):
        return [a * b for a, b in zip(y[:3], self.inverse)], y[6:]


class TippeTop:
    """A ball with C off its centre: numbers n, Omega, v (body axes), q, of which n leads the equations."""

    def __init__(self, _):
        mass, across, along, radius, offset, gravity, friction, omega = TIPPE
        self.mass, self.radius, self.offset, self.gravity, self.friction = map(mpfr, (mass, radius, offset, gravity, friction))
        self.moments = [mpfr(across), mpfr(across), mpfr(along)]
        self.inverse = [1 / x for x in self.moments]
        omega = [mpfr(x) for x in omega]
        # C rises or sinks as the contact asks: not at all, at the upright start.
        self.start = [mpfr(0), mpfr(0), mpfr(1)] + omega + [mpfr(0)] * 3 + [mpfr(x) for x in LEVEL]

    def series(self, y, order):
        s = [[x] for x in y]
        n, w, v, q = s[:3], s[3:6], s[6:9], s[9:]
        g, m, k, r = self.gravity, self.mass, self.offset, self.radius
        rho = [[] for _ in range(3)]
        force = [[] for _ in range(3)]
        spin = [[] for _ in range(3)]
        arm = [[] for _ in range(3)]
        push = [[] for _ in range(3)]
        free = [[] for _ in range(3)]
        above, below, reaction, along, square = [], [], [], [], []
        for i in range(order):
            for a in range(3):
                rho[a].append(-r * n[a][i] + (k if a == 2 and i == 0 else 0))
                spin[a].append(w[a][i] * self.moments[a])
            slip = cross(w, rho)
            for a in range(3):
                # The level force over the normal one, and with the normal one itself.
                force[a].append(n[a][i] - self.friction * (v[a][i] + slip[a]))
            # rho x n = K x n: the radius points along n.
            arm[0].append(-k * n[1][i])
            arm[1].append(k * n[0][i])
            arm[2].append(mpfr(0))
            for a, x in enumerate(cross(rho, force)):
                push[a].append(x * self.inverse[a])
            for a, x in enumerate(cross(w, spin)):
                free[a].append(x * self.inverse[a])
            # n . (Omega x (Omega x K)): the contact's own motion over the ball drops out.
            along.append(sum(conv(w[a], n[a]) for a in range(3)))
            square.append(sum(conv(w[a], w[a]) for a in range(3)))
            whirl = k * (conv(w[2], along) - conv(n[2], square))
            above.append((g if i == 0 else 0) + sum(conv(arm[a], free[a]) for a in range(3)) - whirl)
            below.append((1 / m if i == 0 else 0) + sum(conv(arm[a], push[a]) for a in range(3)))
            known = sum(map(mul, reaction, reversed(below[1:]))) if i else mpfr(0)
            reaction.append((above[i] - known) / below[0])
            dn, dq, swing = cross(n, w), turned(q, w), cross(w, v)
            dw = [conv(reaction, push[a]) - free[a][i] for a in range(3)]
            dv = [-g * n[a][i] + conv(reaction, force[a]) / m - swing[a] for a in range(3)]
            for a in range(3):
                n[a].append(dn[a] / (i + 1))
                w[a].append(dw[a] / (i + 1))
                v[a].append(dv[a] / (i + 1))
            for a in range(4):
                q[a].append(dq[a] / (2 * (i + 1)))
        return s

    def checks(self, y):
        n, w, v = y[:3], y[3:6], y[6:9]
        rho = [-self.radius * a for a in n]
        rho[2] += self.offset
        slip = v[0] * n[0] + v[1] * n[1] + v[2] * n[2]
        slip += sum(n[a] * (w[(a + 1) % 3] * rho[(a + 2) % 3] - w[(a + 2) % 3] * rho[(a + 1) % 3]) for a in range(3))
        jellett = -sum(w[a] * self.moments[a] * rho[a] for a in range(3)) / (self.moments[2] * self.radius * 155)
        up = vertical(y[9:])
        return [jellett, sum(a * a for a in y[9:])], [a - b for a, b in zip(up, n)] + [slip]

    def answer(self, y):
        return y[3:6], y[9:]


def taylor(name, times, digits, truncation):
    """Angular velocity and attitude at ascending times."""
    gmpy2.get_context().precision = int(digits * 3.33)
    order = int(1.15 * truncation)
    body = (TippeTop if name == "tippe-top" else Top)(name)
    y, now, out = body.start, mpfr(0), []
    kept, _ = body.checks(y)
    for t in times:
        end = mpfr(t)
        while now < end:
            s = body.series(y, order)
            h = end - now
            for x in y_scales(s):
                # Both of the last terms are below the truncation, each against the size of its own kind.
                h = min(h, x(order, truncation))
            y = [horner(c, h) for c in s]
            now = end if h == end - now else now + h
        held, ties = body.checks(y)
        loss = max([abs(a - b) / (1 + abs(b)) for a, b in zip(held, kept)] + [abs(x) for x in ties])
        assert loss < mpfr(10) ** -33, (name, t, float(loss))
        out.append(body.answer(y))
    return [([mpf(str(x)) for x in w], [mpf(str(x)) for x in q]) for w, q in out]


def y_scales(series):
    """One function a group of components: the longest step."""
    groups = [series[:3], series[3:6]] + ([series[6:9], series[9:]] if len(series) == 13 else [series[6:]])

    def longest(group):
        def step(order, truncation):
            size = max(max(abs(s[0]) for s in group), max(abs(s[1]) for s in group) * mpfr(10) ** -6)
            tails = [max(abs(s[n]) for s in group) for n in (order - 1, order)]
            if not size:
                return mpfr(10) ** 6
            hs = [(size * mpfr(10) ** -truncation / x) ** (mpfr(1) / n) for x, n in zip(tails, (order - 1, order)) if x]
            return min(hs, default=mpfr(10) ** 6)

        return step

    return [longest(g) for g in groups]


def horner(terms, h):
    total = mpfr(0)
    for c in reversed(terms):
        total = total * h + c
    return total


# ---------------------------------------------------------------- closed forms


def closed_form(name, times):
    moments, lever, l, q = PROBLEMS[name][:4]
    if name in ("free-top", "near-separatrix"):
        assert q == LEVEL
        body = free_top.Body(list(moments), list(l))
        out = []
        for t in times:
            mp.dps = body.dps
            now, attitude = body.at(t)
            out.append(([x / i for x, i in zip(now, map(mpf, moments))], attitude))
        return out
    omega = [a / b for a, b in zip(l, moments)]
    assert all(a == b * c for a, b, c in zip(l, omega, moments))
    top = lagrange_top.Top(moments[0], moments[2], lever[2], omega, q)
    out = []
    for t in times:
        mp.dps = top.dps
        now, attitude = top.at(t)
        # The unit of time is a power of two.
        out.append(([x / lagrange_top.exact(top.unit) for x in now], attitude))
    return out


def apart(one, two):
    """Of the angular velocities, relative, and of the attitudes in radians; the larger."""
    (w, q), (v, p) = one, two
    dw = mp.sqrt(sum((a - b) ** 2 for a, b in zip(w, v)) / sum(a * a for a in w))
    d = free_top.product([q[0]] + [-x for x in q[1:]], p)
    return max(dw, 2 * mp.sqrt(sum(x * x for x in d[1:])))


# ---------------------------------------------------------------- the other equations of the tippe top


def same_equations():
    """Rates by tippe_top.py where this file's motion is, and its extrapolation over a sixteenth of a turn."""
    mass, across, along, radius, offset, gravity, friction, omega = TIPPE
    gmpy2.get_context().precision = 150
    square = mpfr(radius) ** 2
    body = tippe_top.Body(mass, tippe_top.diagonal(across, across, along), tippe_top.diagonal(square, square, square), [0, 0, offset])
    rate = tippe_top.sliding(body, mpfr(gravity), "viscous", [mpfr(friction)])
    ours = TippeTop("tippe-top")
    state = ours.start + [mpfr(0)]
    step = mpfr(PROBLEMS["tippe-top"][4]) / SAMPLES
    for _ in range(8):
        state = tippe_top.extrapolated(rate, state, step / 8)
    gap = max(abs(a - b[1]) / (1 + abs(a)) for a, b in zip(rate(state), ours.series(state[:13], 2)))
    assert gap < 1e-29, float(gap)
    return [mpf(str(x)) for x in state[3:6]], [mpf(str(x)) for x in state[9:13]]


# ---------------------------------------------------------------- the table


def run(name):
    lengths = times_of(name)
    exact = name in ("free-top", "near-separatrix", "cusped-top", "near-sleeping")
    short = sorted({t for n, ts in lengths.items() if n <= 1000 for t in ts})
    stepped = dict(zip(short, taylor(name, short, 62, 46)))
    if exact:
        every = sorted({t for ts in lengths.values() for t in ts})
        found = dict(zip(every, closed_form(name, every)))
        other = stepped
    else:
        found, other = stepped, dict(zip(short, taylor(name, short, 54, 40)))
    mp.dps = 60
    worst = max(apart(found[t], other[t]) for t in short)
    if name == "tippe-top":
        worst = max(worst, apart(found[lengths[1][0]], same_equations()))
    print(f"{name}: two routes {float(worst):.1e} apart", file=sys.stderr, flush=True)
    assert worst < AGREEMENT, name
    return [(name, n, t, *found[t]) for n, ts in lengths.items() for t in ts]


def main():
    names = sys.argv[1:] or list(PROBLEMS)
    with Pool(2) as pool:
        runs = pool.map(run, names, chunksize=1)
    mp.dps = 60
    table = ["problem,t,qw,qx,qy,qz,omega1,omega2,omega3"]
    for rows in runs:
        for n in sorted({row[1] for row in rows}):
            chosen = [row for row in rows if row[1] == n]
            label = f"{chosen[0][0]}/{n}"
            for _, _, t, w, q in chosen:
                numbers = [mp.nstr(x, 36, min_fixed=0, max_fixed=0) for x in [*q, *w]]
                table.append(",".join([label, t.hex(), *numbers]))
    if sys.argv[1:]:
        print("\n".join(table))
        return
    (HERE / "accuracy.csv").write_text("\n".join(table) + "\n")


if __name__ == "__main__":
    main()
