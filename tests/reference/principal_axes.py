"""Writes principal_axes.csv: exact f64 matrices and their eigenvalues to 34 digits.

    pip install mpmath && python3 principal_axes.py

One row a matrix: kind, the six entries xx yy zz xy xz yz as hexadecimal floats, the three eigenvalues ascending.
The matrices are rounded first and diagonalised afterwards, with 80 digits, so the table is about the very numbers
that a program reads.
"""

import random
from mpmath import mp, mpf, matrix, eigsy, nstr

mp.dps = 80
random.seed(2)


def rotation():
    w, x, y, z = (random.gauss(0, 1) for _ in range(4))
    n = mp.sqrt(mpf(w) ** 2 + mpf(x) ** 2 + mpf(y) ** 2 + mpf(z) ** 2)
    w, x, y, z = (mpf(c) / n for c in (w, x, y, z))
    return matrix(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def row(kind, moments, scale=mpf(1), turn=True):
    q = rotation() if turn else mp.eye(3)
    d = matrix([[moments[0], 0, 0], [0, moments[1], 0], [0, 0, moments[2]]])
    a = q * d * q.T * scale
    e = [float(a[i, j]) for i, j in ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))]
    b = matrix([[e[0], e[3], e[4]], [e[3], e[1], e[5]], [e[4], e[5], e[2]]])
    # Scaled to entries near 1, since the eigenvalue routine has absolute thresholds.
    size = max(abs(mpf(x)) for x in e)
    values = sorted(v * size for v in eigsy(b / size, eigvals_only=True))
    return ",".join([kind] + [x.hex() for x in e] + [nstr(v, 34) for v in values])


rows = []
for _ in range(40):
    s = [mpf(random.random()) for _ in range(3)]
    rows.append(row("generic", [s[1] + s[2], s[2] + s[0], s[0] + s[1]]))
for k in range(4, 17):
    for _ in range(4):
        gap = mpf(10) ** -k
        rows.append(row("pair", [mpf(1), 1 + gap, mpf(1) + mpf(random.random())]))
        rows.append(row("pair-high", [mpf(random.random()), mpf(1), 1 + gap]))
        rows.append(row("all-near", [mpf(1), 1 + gap / 3, 1 + gap]))
for k in (1, 3, 6, 9, 12, 15, 20):
    for _ in range(4):
        rows.append(row("needle", [mpf(10) ** -k, mpf(1), mpf(1)]))
        rows.append(row("lamina", [mpf(10) ** -k, 1 - mpf(10) ** -k, mpf(1)]))
for exponent in (-200, -150, -100, 100, 150, 200):
    for _ in range(4):
        rows.append(row("scaled", [mpf(1), mpf(1) + mpf(random.random()), mpf(2)], mpf(10) ** exponent))
for _ in range(10):
    # An even spectrum: half-determinant zero, where the sign that picks the root is a matter of rounding.
    rows.append(row("even", [mpf(1), mpf(3) / 2, mpf(2)]))
    rows.append(row("indefinite", [mpf(-1), mpf(10) ** -9, mpf(1)]))

# Graded: D A D with a diagonal D from 1e-75 to 1e75 and A, of ones on the diagonal, of condition 100 at most; every order of the axes.
# By two routes, the second being the roots of the characteristic polynomial.
mp.dps = 700


def graded(sizes, condition):
    q = rotation()
    a = q * mp.diag([1, mpf(condition) ** mpf(-random.random()), 1 / mpf(condition)]) * q.T
    unit = [mp.sqrt(a[i, i]) for i in range(3)]
    for order in ((0, 1, 2), (0, 2, 1), (1, 0, 2), (1, 2, 0), (2, 0, 1), (2, 1, 0)):
        places = ((0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2))
        e = [float(a[order[i], order[j]] / unit[order[i]] / unit[order[j]] * sizes[order[i]] * sizes[order[j]]) for i, j in places]
        xx, yy, zz, xy, xz, yz = map(mpf, e)
        b = matrix([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])
        size = max(abs(x) for x in (xx, yy, zz))
        values = sorted(v * size for v in eigsy(b / size, eigvals_only=True))
        squares = xx * yy + yy * zz + zz * xx - xy ** 2 - xz ** 2 - yz ** 2
        scaled = [1, -(xx + yy + zz) / size, squares / size ** 2, -mp.det(b / size)]
        roots = sorted(mp.re(v) * size for v in mp.polyroots(scaled, maxsteps=3000, extraprec=2000))
        assert all(abs(v - w) < mpf(10) ** -40 * v for v, w in zip(values, roots)), e
        rows.append(",".join(["graded"] + [x.hex() for x in e] + [nstr(v, 34) for v in values]))


for spread in (1, 2, 4, 8, 16, 20, 40, 75):
    for _ in range(2):
        middle = random.choice([-spread, 0, spread, random.uniform(-spread, spread)])
        graded([mpf(10) ** -spread, mpf(10) ** middle, mpf(10) ** spread], 10 ** random.uniform(0, 2))
graded([mpf(1), mpf(10) ** 10, mpf(10) ** 20], 1.1)

with open("principal_axes.csv", "w") as out:
    out.write("\n".join(rows) + "\n")
