"""Datasets whose numbers are written by hand, and measures on them."""

import json
import math

import numpy as np
import pytest
import xarray as xr

ANY = math.inf
"""For an error that a change of grid makes, which is tested by itself."""


def dataset(config=None, attrs=None, error=1e-3, **variables):
    """Variables from their dimensions, with coordinates where these are given, and values."""
    described, coordinates = {}, {}
    for name, (axes, values) in variables.items():
        coordinates |= {axis: places for axis, places in axes.items() if places is not None}
        described[name] = (list(axes), np.array(values, dtype=float), {"error_estimate": error})
    attributes = {"config": json.dumps(config)} if config else {}
    return xr.Dataset(described, coordinates, attributes | (attrs or {}))


def estimates(attrs=None, **variables):
    """The same, where each variable has another one with its errors, 1e-3."""
    errors = {
        f"{name}_error": (axes, np.full(np.shape(values), 1e-3))
        for name, (axes, values) in variables.items()
    }
    return dataset(attrs=attrs, **variables, **errors)


def assert_measures(measure, data, arguments, value, error):
    """Value and error of a measure on one dataset or several."""
    found = measure(*(data if isinstance(data, tuple) else [data]), **arguments)
    least = 0.0 if value else 1e-15
    assert found.value == pytest.approx(value, rel=1e-12, abs=least, nan_ok=True)
    if error != ANY:
        assert found.error == pytest.approx(error, rel=1e-9, nan_ok=True)
