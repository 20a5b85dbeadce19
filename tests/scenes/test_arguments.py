"""Every argument of every public function: what is impossible is refused in one sentence."""

import ast
import inspect
import math
import tempfile
from fractions import Fraction
from importlib.resources import files
from pathlib import Path

import numpy as np
import pytest
import xarray as xr
from chains import driven_scene
from potentials import hertz
from rings import scene_with

import granular_fronts as gf
from granular_fronts import arguments
from granular_fronts.errors import InputError
from granular_fronts.output.datasets import long_names
from projects import ROOT

HUGE = 10**400


def a_front(**attributes):
    """A dataset that looks like a front, without solving for one."""
    xi = np.linspace(-9.0, 9.0, 19)
    u = 1.0 / (1.0 + np.exp(4.0 * xi))
    law = {"alpha": 1.5, "beta": 1.5, "gamma": 0.3, "right_state": 0.0, "speed": 1.0}
    law |= {"spacing": 1.0, "state_behind": -1.0, "state_ahead": 0.0}
    return xr.Dataset(
        {"relative_displacement": ("xi", u), "velocity": ("xi", u)},
        {"xi": xi},
        law | {"converged": 1, "reason": ""} | attributes,
    )


LAW = {"alpha": 1.5, "gamma": 0.3, "beta": 1.5}


def a_series(**attributes):
    """A pulse that arrives at two contacts."""
    t = np.linspace(0.0, 20.0, 201)
    values = np.exp(-((t[:, None] - [6.0, 13.0]) ** 2))
    coordinates = {"t": t, "contact": [1, 2]}
    return xr.DataArray(values, coordinates, ("t", "contact"), attrs=attributes)


# A possible value of every parameter of every public function; its type says what is impossible.
POSSIBLE = {
    "Potential": {
        "value": lambda r: 1.0 - np.cos(r),
        "first": np.sin,
        "second": np.cos,
        "third": lambda r: -np.sin(r),
        "interval": np.array([-1.0, 1.0]),
        "kinks": np.array([0.0]),
        "name": "cosine",
    },
    "Scaling": {"mass": 0.1, "stiffness": 1.0e9, "damping": 1.0e-5, "velocity": 0.5}
    | {"alpha": 1.5, "beta": 1.5},
    "check_certificate": {"path": ROOT / "tests/proofs/test_proof_data/overshoot.npz"},
    "contact_stiffness": {"first": "steel 5 mm", "second": "glass"},
    "critical_damping": {"alpha": 1.5, "beta": 1.5, "definition": "tail", "cut": 1e-3},
    "damping_for_restitution": {"e": 0.9, "alpha": 1.5, "beta": 1.5},
    "damping_from_restitution": {"e": 0.9, "impact_velocity": 0.5, "mass": 0.1, "stiffness": 1e9}
    | {"alpha": 1.5, "beta": 1.5},
    "evaluate_front": {"front": a_front(), "xi": np.array([0.5]), "name": "velocity"},
    "evolve_log_burgers": {"scene": scene_with(end_time=5.0), "name": "given"},
    "evolve_log_kdv_burgers": {"scene": scene_with(end_time=5.0), "name": "given"},
    "front_multipliers": {"front": a_front(), "beads_behind": 20, "beads_ahead": 5},
    "heteroclinic": {"mu": 1.0, "s": np.array([0.0, 1.0])},
    "jump_conditions": {
        "law": hertz(1.5),
        "R_minus": -1.0,
        "R_plus": 0.0,
        "mass": 1.0,
        "dissipation": hertz(1.5),
    },
    "log_burgers_front": {"xi": np.array([0.5]), "alpha": 1.5},
    "prove_front": {
        "alpha": Fraction(2),
        "gamma": Fraction(3, 10),
        "path": Path(tempfile.mkdtemp()) / "front.npz",
        "cells": 20,
        "fine": 40,
        "drift": 6e-4,
        "beta": None,
    },
    "pulses": {"series": a_series(error_estimate=1e-9), "prominence": 0.1},
    "restitution": {"gamma": 0.1, "alpha": 1.5, "beta": 1.5},
    "simulate_chain": {"scene": driven_scene(0.1, 4, 1.0), "name": "given"},
    "solve_front": LAW | {"method": "profile", "right_state": 0.0, "law": None, "states": None},
    "sphere_stiffness": {"radius": 0.01, "youngs_modulus": 2e11, "poisson_ratio": 0.3},
    "sweep_fronts": LAW
    | {"gammas": np.array([0.3, 0.2]), "law": None, "states": None, "factors": None},
    "tail_roots": LAW | {"count": 6},
}
del POSSIBLE["sweep_fronts"]["gamma"]

# A name is what messages call something, whatever it is.
SOLVERS = {"simulate_chain", "evolve_log_burgers", "evolve_log_kdv_burgers"}
FREE = {(function, "name") for function in ("Potential", *SOLVERS)}
SOLVERS |= {"solve_front", "sweep_fronts", "heteroclinic"}

NEVER_A_NUMBER = ["1.5", b"1.5", 1.5j, True, {}, {"a": 1.0}, math.nan, math.inf, -math.inf, HUGE]
SEVERAL = [[1.5], np.array([1.5, 2.0]), np.array([]), (1.5, "x")]
IMPOSSIBLE = {
    float: [*NEVER_A_NUMBER, *SEVERAL],
    int: [*NEVER_A_NUMBER, *SEVERAL, 1.5, 0, -5, 20.5],
    np.ndarray: [*NEVER_A_NUMBER, [0.5, math.nan], [0.5, None], [[1.0], [1.0, 2.0]], ["0.5"]],
    str: ["nothing of the kind", b"tail", 1.5, ["tail"], np.array([1.0, 2.0])],
    Fraction: [
        *["text", "1.5 m", "1/0", "", "1e999999999", b"1.5", *NEVER_A_NUMBER[2:], *SEVERAL],
        *[0, -1.5, "-3/2", "1" * 19, [0.3, math.nan], [0.2, 0.3, 0.4], [0.3, 0.2]],
    ],
    type(Path()): [b"file", "", "a\0b", *NEVER_A_NUMBER[2:], 1.5, *SEVERAL],
    dict: ["text", 1.5, 1.5j, [1.5], np.array([1.0, 2.0])],
}
NO_OBJECTS = ["text", 1.5, 1.5j, math.nan, {}, [1.5], np.array([1.0, 2.0])]

OUT_OF_RANGE = {
    "Scaling": {
        "mass": [0.0],
        "stiffness": [0.0],
        "velocity": [0.0],
        "damping": [-1.0],
        "alpha": [0.0],
        "beta": [0.5],
    },
    "critical_damping": {"alpha": [1.0], "cut": [1e-9, 0.2]},
    "evaluate_front": {"front": [a_front(converged=0, reason="a test")]},
    "front_multipliers": {
        "front": [
            a_front(converged=0, reason="a test"),
            a_front().drop_vars("velocity"),
            a_front(gamma=100.0),
        ],
        "beads_behind": [10**6],
    },
    "heteroclinic": {"s": [[]]},
    "jump_conditions": {"mass": [0.0]},
    "log_burgers_front": {"alpha": [1.0]},
    "prove_front": {
        "alpha": [1, 1.0, "1", "1/2", [2.0, 1.5], [1.5]],
        "gamma": [30],
        "path": [ROOT, str(ROOT), ROOT / "nowhere" / "front.npz"],
        "cells": [7, 201],
        "fine": [1001],
        "drift": [0.0, 1.0],
        "beta": [2.0, 1.5],
    },
    "pulses": {
        "prominence": [0.0, 1.5],
        "series": [
            *[a_series(error_estimate=error) for error in (-1.0, math.nan, "x")],
            *[a_series(error_estimate=0.0)[::-1], a_series(), a_series(error_estimate=0.0) / 0.0],
        ],
    },
    "restitution": {"alpha": [0.0], "beta": [0.5], "gamma": [-0.1]},
    "solve_front": {"right_state": [-0.1]},
    "sweep_fronts": {"alpha": [1.0], "gammas": [[[0.1]]]},
    "tail_roots": {"gamma": [0.0]},
}
"""What `test_refusals` has no row for."""


def parameters_of(name):
    return inspect.signature(getattr(gf, name)).parameters


def impossible_values(name, parameter):
    values = IMPOSSIBLE.get(type(POSSIBLE[name][parameter]), NO_OBJECTS)
    needed = parameters_of(name)[parameter].default is not None
    return [*values, *[None] * needed, *OUT_OF_RANGE.get(name, {}).get(parameter, [])]


CASES = [
    (name, parameter)
    for name in sorted(POSSIBLE)
    for parameter in POSSIBLE[name]
    if (name, parameter) not in FREE
]


def test_no_public_function_and_no_parameter_is_forgotten():
    """`test_laws` has `make_law`, `test_plot` pictures, `test_refusals` scenes."""
    assert {name: set(POSSIBLE[name]) for name in POSSIBLE} == {
        name: set(parameters_of(name))
        for name in gf.__all__
        if name not in ("make_law", "plot", "Chain", "Ring", "Front")
    }


def test_the_stub_gives_each_public_name_from_its_module():
    """What a type checker reads."""
    package = files("granular_fronts")
    assert package.joinpath("py.typed").is_file()
    stub = ast.parse(package.joinpath("__init__.pyi").read_text(encoding="utf-8"))
    homes = {
        name.asname: f"{statement.module}.{name.name}"
        for statement in stub.body
        if isinstance(statement, ast.ImportFrom)
        for name in statement.names
    }
    public = {name: getattr(gf, name) for name in gf.__all__}
    assert homes == {
        name: found.__name__
        if inspect.ismodule(found)
        else f"{found.__module__}.{found.__qualname__}"
        for name, found in public.items()
    }


@pytest.mark.parametrize(("name", "parameter"), CASES)
def test_impossible_arguments_are_refused_in_a_sentence(name, parameter):
    for value in impossible_values(name, parameter):
        with pytest.raises(InputError) as caught:
            getattr(gf, name)(**POSSIBLE[name] | {parameter: value})
        sentence = str(caught.value)
        assert parameter in sentence.replace("Scene", "scene"), value
        assert sentence.endswith("."), value
        assert "\n" not in sentence, value


# `sel` reads the latter as its options, or `dataset.name` is another thing.
TAKEN = {*dir(xr.Dataset()), *inspect.signature(xr.Dataset.sel).parameters}


# tests/proofs proves fronts, and the examples of the manual do so at night.
@pytest.mark.parametrize("name", sorted(POSSIBLE.keys() - {"prove_front", "check_certificate"}))
def test_possible_arguments_give_something_that_prints_well(name):
    """Variables of a solver have names and units, and attributes of a few lines at most."""
    found = getattr(gf, name)(**POSSIBLE[name])
    assert found is not None
    if name in SOLVERS:
        for variable in found.variables.values():
            assert variable.attrs["long_name"]
            assert variable.attrs["units"] == "1"
        for described in (found, *found.variables.values()):
            assert all(len(str(value)) < 250 for value in described.attrs.values())
        assert "config" not in found.attrs
        assert TAKEN.isdisjoint(found.dims)


def test_no_variable_has_a_name_that_xarray_has_taken():
    assert {"method", "tolerance", "variables"} < TAKEN
    assert TAKEN.isdisjoint(long_names())


def test_every_kind_of_real_number_is_a_number():
    two = [2, 2.0, np.float32(2.0), np.int64(2), np.array(2.0), xr.DataArray(2.0), Fraction(2)]
    for value in two:
        found = arguments.scalar("x", value, above=1.0, most=2.0)
        assert (found, type(found)) == (2.0, float)
        found = arguments.count("n", value, least=2, most=2)
        assert (found, type(found)) == (2, int)


def test_arrays_keep_their_shape_and_lists_have_one_dimension():
    assert arguments.array("x", np.float32(1.0)).shape == ()
    assert arguments.array("x", [[1, 2]]).dtype == float
    np.testing.assert_array_equal(arguments.sequence("s", 3), [3.0])
