"""Put what certificates prove into a dataset: intervals of γ, bounds, statements and margins."""

from pathlib import Path

import numpy as np
import xarray as xr

from granular_fronts.proofs.arrays import written

BEHIND = "rate_low", "rate_high", "amplitude_low", "amplitude_high"  # of the leading term
NUMBERS = (
    "radius",
    "unique_within",
    *BEHIND,
    "monotone",
    "oscillates",
    "critical",
)  # that are variables
JOINED = "the front before is a translate"  # the last inequality of a junction


def records_dataset(records):
    """Return what is proved: a row for each record, NaN for numbers that are not proved.

    A record is as from `check_certificate` or `families.record`, with `path`, `name`, `beta` (by
    default α) and `seconds`, the processor time.  `ends` are those of the intervals of α and γ,
    exact decimals or fractions; pictures take `alpha`, `gamma_low` and `gamma_high` in doubles.
    `overshoot_bound` is below max u − 1, and `joined` is 1 where the fronts continue the row
    before.  The sides `left` < `right` are on (certificate, inequality).
    """
    names = list(dict.fromkeys(one["name"] for row in records for one in row["inequalities"]))
    sides = np.full((2, len(records), len(names)), np.nan)
    for place, row in enumerate(records):
        for one in row["inequalities"]:
            sides[:, place, names.index(one["name"])] = one["left"], one["right"]
    columns = {
        "alpha": [float(sum(row["alpha"]) / 2) for row in records],
        "beta": [float(row.get("beta", sum(row["alpha"]) / 2)) for row in records],
        "gamma_low": [float(row["gamma"][0]) for row in records],
        "gamma_high": [float(row["gamma"][1]) for row in records],
        "error_bound": [row["error"] for row in records],
        "processor_seconds": [row["seconds"] for row in records],
        "bytes": [Path(row["path"]).stat().st_size for row in records],
        "file": [str(row["path"]) for row in records],
        "statements": ["\n".join(row["statements"]) for row in records],
    }
    for name in NUMBERS:
        columns[name] = [row["numbers"].get(name, np.nan) for row in records]
    tops = np.array([row["numbers"].get("overshoot", np.nan) for row in records])
    columns["overshoot_bound"] = tops - 1
    data = xr.Dataset(
        {name: ("certificate", values) for name, values in columns.items()},
        {"certificate": [row["name"] for row in records], "inequality": names},
    )
    ends = [[list(map(written, row[name])) for name in ("alpha", "gamma")] for row in records]
    data["ends"] = ("certificate", "parameter", "end"), ends
    data = data.assign_coords(parameter=["alpha", "gamma"], end=["low", "high"])
    data["left"], data["right"] = ((("certificate", "inequality"), side) for side in sides)
    known = data["left"].sel(inequality=JOINED) if JOINED in names else data["radius"] * np.nan
    data["joined"] = "certificate", np.isfinite(known.values).astype(int)
    data["processor_seconds"].attrs["units"] = "s"
    data["bytes"].attrs["units"] = "byte"
    for name in ("error_bound", "radius", "unique_within", "overshoot_bound", *BEHIND):
        data[name].attrs["error_method"] = "a bound that is proved, rounded outwards"
    return data
