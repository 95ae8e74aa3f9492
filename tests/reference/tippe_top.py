"""Bodies sliding or rolling on a table: states to 25 digits.

The equations are those of a rigid body with Newton's law written in body axes (velocity of C with all three components, vertical as a
vector of its own beside the quaternion), integrated by Gragg, Bulirsch and Stoer's extrapolation to order 32 in 34 digits, twice with
step sizes a factor 1.6 apart. Printed is what the two agree on; the script stops where they differ by more than 1e-26, or where
|n| = 1, the tie of the contact or the energy balance fail by more than that.

Usage: python3 tippe_top.py > tippe_top.csv
"""

import sys
from multiprocessing import Pool

import gmpy2
from gmpy2 import mpfr as mpf
from gmpy2 import sqrt

gmpy2.get_context().precision = 115
COLUMNS = 16


def vec(*values):
    return [mpf(v) for v in values]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def times(m, a):
    return [dot(row, a) for row in m]


def inverse(m):
    a, b, c = m
    columns = [cross(b, c), cross(c, a), cross(a, b)]
    det = dot(a, columns[0])
    return [[columns[j][i] / det for j in range(3)] for i in range(3)]


class Body:
    def __init__(self, mass, inertia, shape, offset):
        self.mass = mpf(mass)
        self.inertia = [vec(*row) for row in inertia]
        self.inverse = inverse(self.inertia)
        self.shape = [vec(*row) for row in shape]  # D, squares of the semi-axes
        self.offset = vec(*offset)  # from C to the centre of the surface


def geometry(body, n, omega):
    """rho, rho' in body axes."""
    turn = cross(n, omega)
    dn, dturn = times(body.shape, n), times(body.shape, turn)
    s = sqrt(dot(n, dn))
    along = dot(n, dturn) / s**3
    rho = [k - d / s for k, d in zip(body.offset, dn)]
    rate = [-d / s + e * along for d, e in zip(dturn, dn)]
    return turn, rho, rate


def sliding(body, gravity, law, parameters):
    mass, inertia, inverse_inertia = body.mass, body.inertia, body.inverse

    def rate(y):
        n, omega, v, q = y[0:3], y[3:6], y[6:9], y[9:13]
        turn, rho, rho_rate = geometry(body, n, omega)
        slip = [a + b for a, b in zip(v, cross(omega, rho))]
        if law == "viscous":
            f = [-parameters[0] * s for s in slip]
        elif law == "coulomb":
            size = sqrt(dot(slip, slip) + parameters[1] ** 2)
            f = [-parameters[0] * s / size for s in slip]
        else:
            f = [mpf(0)] * 3
        arm = cross(rho, n)
        gyro = cross(omega, times(inertia, omega))
        whirl = cross(omega, [a + b for a, b in zip(rho_rate, cross(omega, rho))])
        push = times(inverse_inertia, cross(rho, [a + b for a, b in zip(n, f)]))
        free = times(inverse_inertia, gyro)
        reaction = (gravity + dot(arm, free) - dot(n, whirl)) / (1 / mass + dot(arm, push))
        omega_rate = [reaction * a - b for a, b in zip(push, free)]
        swing = cross(omega, v)
        v_rate = [
            -gravity * n[i] + reaction * (n[i] + f[i]) / mass - swing[i] for i in range(3)
        ]
        return turn + omega_rate + v_rate + attitude_rate(q, omega) + [-reaction * dot(f, slip)]

    return rate


def rolling(body, gravity):
    mass, inertia = body.mass, body.inertia

    def rate(y):
        n, omega, q = y[0:3], y[3:6], y[9:13]
        turn, rho, rho_rate = geometry(body, n, omega)
        square = dot(rho, rho)
        total = [
            [inertia[i][j] + mass * ((square if i == j else 0) - rho[i] * rho[j]) for j in range(3)]
            for i in range(3)
        ]
        whirl = cross(omega, [a + b for a, b in zip(rho_rate, cross(omega, rho))])
        gyro = cross(omega, times(inertia, omega))
        pull = cross(rho, [gravity * a - b for a, b in zip(n, whirl)])
        omega_rate = times(inverse(total), [mass * a - b for a, b in zip(pull, gyro)])
        v_rate = [-a - b for a, b in zip(cross(omega_rate, rho), cross(omega, rho_rate))]
        return turn + omega_rate + v_rate + attitude_rate(q, omega) + [mpf(0)]

    return rate


def attitude_rate(q, omega):
    w, x, y, z = q
    a, b, c = omega
    return [
        (-x * a - y * b - z * c) / 2,
        (w * a + y * c - z * b) / 2,
        (w * b + z * a - x * c) / 2,
        (w * c + x * b - y * a) / 2,
    ]


def extrapolated(rate, y, step):
    """One step of Gragg, Bulirsch and Stoer with COLUMNS columns."""
    table, start = [], rate(y)
    for column in range(COLUMNS):
        count = 2 * (column + 1)
        h = step / count
        before, now = y, [a + h * b for a, b in zip(y, start)]
        for _ in range(count - 1):
            slope = rate(now)
            before, now = now, [a + 2 * h * b for a, b in zip(before, slope)]
        slope = rate(now)
        row = [[(a + b + h * c) / 2 for a, b, c in zip(before, now, slope)]]
        for k in range(1, column + 1):
            ratio = (mpf(count) / (2 * (column + 1 - k))) ** 2 - 1
            row.append([a + (a - b) / ratio for a, b in zip(row[k - 1], table[k - 1])])
        table = row
    return table[-1]


def energy(body, gravity, y):
    n, omega, v = y[0:3], y[3:6], y[6:9]
    _, rho, _ = geometry(body, n, omega)
    return (
        dot(omega, times(body.inertia, omega)) / 2
        + body.mass * dot(v, v) / 2
        - body.mass * gravity * dot(n, rho)
    )


def run(case):
    name, body, gravity, law, parameters, q, omega, end, step = case
    norm = sqrt(sum(a * a for a in q))
    w, x, y, z = unit = [a / norm for a in q]
    n = [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z]
    _, rho, _ = geometry(body, n, omega)
    swing = cross(omega, rho)
    if law == "rolling":
        v = [-a for a in swing]
        rate = rolling(body, gravity)
    else:
        v = [-a * dot(n, swing) for a in n]  # C moves up or down only, as the tie of the contact asks
        rate = sliding(body, gravity, law, parameters)
    gmpy2.get_context().precision = 115
    results, bounds = [], []
    for refinement in (mpf(1), mpf(16) / 10):
        state = n + omega + v + unit + [mpf(0)]
        first = energy(body, gravity, state)
        states = []
        count = int(end / step * refinement) + 1
        for part in range(3):
            for _ in range(count):
                state = extrapolated(rate, state, end / 3 / count)
            states.append(state)
        slip = [a + b for a, b in zip(state[6:9], cross(state[3:6], geometry(body, state[0:3], state[3:6])[1]))]
        balance = (energy(body, gravity, state) + state[13]) / first - 1
        bounds.append(max(abs(dot(state[0:3], slip)), abs(balance), abs(dot(state[0:3], state[0:3]) - 1)))
        results.append(states)
    scale = max(abs(a) for a in results[0][0])
    apart = max(abs(a - b) / scale for p, q in zip(*results) for a, b in zip(p, q))
    print(f"{name}: two step sizes differ by {float(apart):.1e}, ties by {float(bounds[1]):.1e}", file=sys.stderr)
    assert apart < mpf("1e-26") and bounds[1] < mpf("1e-26"), name
    rows = []
    for part, state in enumerate(results[1], 1):
        numbers = state[9:13] + state[3:6] + [state[13]]
        rows.append(",".join([name, f"{float(end * part / 3)!r}"] + [f"{a:.24e}" for a in numbers]))
    return rows


def diagonal(a, b, c):
    return [[a, 0, 0], [0, b, 0], [0, 0, c]]


def spun(tilt_over, spin):
    """Quaternion of a turn about the second axis whose half angle has the tangent `tilt_over`, and a vertical spin."""
    q = vec(1, 0, tilt_over, 0)
    w, x, y, z = [a / sqrt(1 + mpf(tilt_over) ** 2) for a in q]
    n = [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z]
    return q, [mpf(spin) * a for a in n]


def scaled(m, factor):
    return [[mpf(factor) * mpf(a) for a in row] for row in m]


def turned(m, delta_tangent_half):
    """m turned about the third axis, the tangent of half the angle given."""
    t = mpf(delta_tangent_half)
    c, s = (1 - t * t) / (1 + t * t), 2 * t / (1 + t * t)
    r = [[c, -s, mpf(0)], [s, c, mpf(0)], [mpf(0), mpf(0), mpf(1)]]
    m = [vec(*row) for row in m]
    half = [[sum(r[i][k] * m[k][j] for k in range(3)) for j in range(3)] for i in range(3)]
    return [[sum(half[i][k] * r[j][k] for k in range(3)) for j in range(3)] for i in range(3)]


def cases():
    # Every decimal below means the decimal itself; the test forms the nearest double.
    g, r = mpf("9.81"), mpf("0.02")
    mr2 = mpf("0.02") * r**2
    ball = diagonal(r**2, r**2, r**2)
    q, omega = spun("0.05", 0)
    tippe = Body("0.02", diagonal(mr2 * 131 / 350, mr2 * 131 / 350, mr2 * 2 / 5), ball, ["0", "0", "0.006"])
    yield "tippe top viscous", tippe, g, "viscous", vec("0.3"), q, vec(0, 0, 155), mpf("0.9"), mpf("0.003")
    hoop = Body("0.02", scaled(diagonal(1, 1, 1), mr2 * 2 / 5), ball, ["0", "0", "0.002"])
    q, omega = spun("0.1", 314)
    yield "hoop with clay coulomb", hoop, g, "coulomb", [mpf(1) / 3, mpf("0.001")], q, omega, mpf("0.15"), mpf("0.0004")
    a2, b2 = mpf("0.0009"), mpf("0.0004")
    egg = Body("0.06", diagonal(mpf("0.012") * (a2 + b2), mpf("0.012") * (a2 + b2), mpf("0.024") * b2), diagonal(b2, b2, a2), [0, 0, 0])
    q, omega = spun("0.9", 94)
    yield "egg coulomb", egg, g, "coulomb", vec("0.1", "0.002"), q, omega, mpf("0.3"), mpf("0.001")
    skew = [["0.480", "0.017", "-0.008"], ["0.017", "0.420", "0.008"], ["-0.008", "0.008", "0.530"]]
    chiral = Body("0.02", scaled(skew, mr2), ball, ["0", "0", "0.0038"])
    for name, spin in (("chiral top +", "132.9"), ("chiral top -", "-132.9")):
        q, omega = spun("0.025", spin)
        yield name, chiral, g, "coulomb", vec("0.3", "0.001"), q, omega, mpf("0.21"), mpf("0.0004")
    celt = scaled(diagonal(mpf("0.351"), mpf("0.550"), mpf("0.505")), mr2)
    oval = turned(diagonal((r * mpf("1.144")) ** 2, (r * mpf("0.856")) ** 2, r**2), "0.4")
    c1 = Body("0.02", celt, oval, ["0", "0", "0.00576"])
    q, omega = spun("0.025", "102.4")
    yield "celt-ended top", c1, g, "coulomb", vec("0.5", "0.001"), q, omega, mpf("0.15"), mpf("0.0002")
    q, omega = spun("0.25", "20")
    yield "frictionless ellipsoid", c1, g, "none", [], q, omega, mpf("1.2"), mpf("0.01")
    stone = Body(1, [["2e-4", "-2e-5", 0], ["-2e-5", "16e-4", 0], [0, 0, "17e-4"]], diagonal(mpf("0.04"), mpf("0.0009"), mpf("0.0004")), ["0", "0", "0.01"])
    q, omega = vec(1, "0.004", "0.004", 0), vec(0, 0, -5)
    yield "rattleback rolling", stone, g, "rolling", [], q, omega, mpf("0.9"), mpf("0.003")


if __name__ == "__main__":
    print("case,t,qw,qx,qy,qz,omega1,omega2,omega3,work")
    with Pool(2) as pool:
        for rows in pool.imap(run, list(cases())):
            print("\n".join(rows), flush=True)
