"""Reference values of Maclaurin's spheroid: writes maclaurin.csv beside this file. Needs mpmath.

e is given as the shortest decimal of a double and read back exactly; 60 digits carried, 32 printed.
Columns: e, Omega^2/(pi G rho), T/|W|.
"""

from pathlib import Path
from mpmath import asin, mp, mpf, nstr, sqrt

mp.dps = 90
rows = ["e,rotation,energy_ratio"]
for e in ["1e-08", "1e-06", "0.0001", "0.003", "0.02", "0.05", "0.1", "0.25", "0.5", "0.6", "0.75",
          "0.8125", "0.875", "0.9375", "0.953125", "0.99", "0.999", "0.99999", "0.9999999", "0.999999999"]:
    x = mpf(float(e))
    q = sqrt(1 - x * x)
    rotation = 2 * q * (3 - 2 * x**2) * asin(x) / x**3 - 6 * q**2 / x**2
    ratio = 3 / (2 * x**2) * (1 - x * q / asin(x)) - 1
    rows.append(f"{e},{nstr(rotation, 32)},{nstr(ratio, 32)}")
Path(__file__).with_suffix(".csv").write_text("\n".join(rows) + "\n")
