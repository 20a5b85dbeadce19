"""Compare the numbers of two results folders, in units of the errors that they state.

python tools/compare_results.py saved results changes.csv

A change of a variable is measured by the largest |after − before| over the sum of both stated
errors.  The errors are its companion NAME_error, element by element, or else `error_estimate`.  At
most 1 means that both numbers may be right.
"""

import sys
from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr

from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.files import complete_file


def compare_results(before: Path, after: Path, report: Path) -> None:
    """Compare all datasets that two results folders share, and print the largest change.

    Parameters
    ----------
    before, after : Path
        Results folders.
    report : Path
        Table to write: a row for each variable, the largest change first.

    Raises
    ------
    ValueError
        If a variable has changed by more than its stated errors, or nothing can be compared.
    """
    names = sorted(path.relative_to(before) for path in Path(before, "data").rglob("*.nc"))
    shared = [name for name in names if Path(after, name).exists()]
    rows = [
        {"dataset": str(name.with_suffix("").relative_to("data")), **row}
        for name in shared
        for row in changes(read_dataset(Path(before, name)), read_dataset(Path(after, name)))
    ]
    if not rows:
        raise ValueError(f"{before} and {after} share no dataset: give two results folders.")
    table = pd.DataFrame(rows).sort_values("over_stated_error", ascending=False)
    with complete_file(report) as unfinished:
        table.to_csv(unfinished, index=False)
    worst = table.iloc[0]
    summary = (
        f"{len(table)} variables of {len(shared)} datasets; the largest change is "
        f"{worst['over_stated_error']:.2g} times the stated errors, in {worst['variable']} of "
        f"{worst['dataset']} ({worst['change']:.1e}, stated errors {worst['error']:.1e})."
    )
    if worst["over_stated_error"] > 1.0:
        raise ValueError(summary)
    print(summary)


def changes(before: xr.Dataset, after: xr.Dataset) -> list[dict]:
    """Return the change of each variable that states its error and has the same points in both.

    Each row has `variable`, `change`, `error` and `over_stated_error`, for the element that has
    changed most in units of its error.
    """
    return [
        {"variable": name, **_change_of(before, after, str(name))}
        for name, variable in before.data_vars.items()
        if name in after
        and variable.dtype.kind == "f"
        and variable.size
        and variable.attrs.get("error_estimate", 0.0) > 0.0
        and variable.shape == after[name].shape
    ]


def _change_of(before: xr.Dataset, after: xr.Dataset, name: str) -> dict[str, float]:
    """Return the largest change of one variable over its stated errors."""
    # A number that is missing on only one side has changed without bound.
    old, new = before[name].values, after[name].values
    errors = _stated_error(before, name) + _stated_error(after, name)
    with np.errstate(invalid="ignore"):
        change = np.where(np.isnan(old) & np.isnan(new), 0.0, np.abs(new - old))
    change = np.where(np.isnan(change), np.inf, change)
    ratio = np.divide(change, errors, out=np.zeros_like(change), where=change > 0.0)
    worst = np.unravel_index(np.argmax(ratio), ratio.shape)
    return {
        "change": float(change[worst]),
        "error": float(errors[worst]),
        "over_stated_error": float(ratio[worst]),
    }


def _stated_error(dataset: xr.Dataset, name: str) -> np.ndarray:
    """Return the stated error of each element of a variable, in its shape."""
    variable = dataset[name]
    companion = dataset.get(f"{name}_error")
    if companion is not None and companion.shape == variable.shape:
        return np.nan_to_num(companion.values)
    return np.full(variable.shape, variable.attrs["error_estimate"])


if __name__ == "__main__":
    try:
        compare_results(*map(Path, sys.argv[1:]))
    except ValueError as error:
        sys.exit(str(error))
