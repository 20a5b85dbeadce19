"""Reference fronts of the logarithmic KdV–Burgers equation, James (2021), section 5.2.

y_h(s) and its slope for a few dampings μ on equally spaced s, with y_h(0) = 1/2, in arithmetic of
50 digits: Taylor series along the stable manifold of the origin, which share no code with the
package (tests/support/heteroclinic_reference.py).

Each front is computed a second time by series of another order over steps of another length; the
largest difference is the error stated for it.

Run ``python make_heteroclinic_reference.py --help`` for the command line.
"""

import argparse
import sys
from pathlib import Path

import mpmath as mp
import numpy as np
import xarray as xr

TESTS = Path(__file__).parents[2] / "tests"
REFERENCES = TESTS / "references"
sys.path.insert(0, str(TESTS / "support"))

from heteroclinic_reference import DIGITS, Reference  # noqa: E402

DAMPINGS = (0.3, 2.0, 20.0)
START, STOP, STEP = -30.0, 9.0, 0.25
AGAIN = {"order": 52, "longest": 0.18}
FIELDS = {"rescaled_force": "y_h(s)", "slope": "y_h'(s)"}


def profile(mu, s, **choices):
    """Return (y, y') at each s as lists of mpmath numbers."""
    front = Reference(mu, s[0] - 1.0, p_start=40 if mu < 10 else 5, **choices)
    y, slope = [], []
    with mp.workdps(DIGITS):
        for point in s:
            p, v = front.at(point)
            y.append(mp.exp(-p))
            slope.append(-v * y[-1])
    return y, slope


def in_two_doubles(values):
    """Return the nearest doubles and what they leave."""
    with mp.workdps(DIGITS):
        high = [float(value) for value in values]
        return high, [float(value - mp.mpf(kept)) for value, kept in zip(values, high, strict=True)]


def main():
    """Compute all fronts and write them."""
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--output", type=Path, default=REFERENCES / "heteroclinic_reference.nc")
    output = parser.parse_args().output
    s = np.arange(START, STOP + STEP / 2, STEP)
    data = xr.Dataset(
        coords={"mu": ("state", list(DAMPINGS)), "s": s},
        attrs={
            "title": "Reference fronts of the logarithmic KdV-Burgers equation, James (2021)",
            "source": "tools/references/make_heteroclinic_reference.py",
            "problem": "y'' - mu y' + y ln y = 0, y(-inf) = 1, y(inf) = 0, y(0) = 1/2; the "
            "dampings are the double values",
            "versions": f"mpmath {mp.__version__}, numpy {np.__version__}",
            "error_method": "largest difference from Taylor series of order 52 with other steps",
        },
    )
    kept = [profile(mu, s) for mu in DAMPINGS]
    again = [profile(mu, s, **AGAIN) for mu in DAMPINGS]
    for index, (name, meaning) in enumerate(FIELDS.items()):
        parts = np.array([in_two_doubles(front[index]) for front in kept])
        errors = [
            float(max(abs(a - b) for a, b in zip(front[index], other[index], strict=True)))
            for front, other in zip(kept, again, strict=True)
        ]
        attrs = {"long_name": meaning, "units": "1"}
        data[name] = (("state", "s"), parts[:, 0], attrs)
        data[f"{name}_low"] = (
            ("state", "s"),
            parts[:, 1],
            {"long_name": "what double leaves of it"},
        )
        # The two parts hold 32 digits.
        data[f"{name}_error"] = ("state", np.maximum(errors, 1e-32))
    data.to_netcdf(output)
    print(data["rescaled_force_error"].values, data["slope_error"].values)


if __name__ == "__main__":
    main()
