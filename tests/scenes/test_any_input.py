"""Properties of any input: refused in a sentence before any work, or computed and true."""

import functools
import json
import math
import operator
import re
from collections.abc import Mapping

import numpy as np
import pytest
from configurations import DEFAULT as DEFAULT_FILE
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.integrate import simpson

import granular_fronts as gf
from granular_fronts.campaign.definition import check_campaign
from granular_fronts.errors import InputError
from granular_fronts.scenes.chain import Chain
from granular_fronts.scenes.configuration import check_configuration
from granular_fronts.scenes.orbit import Orbits
from granular_fronts.scenes.yaml_files import load_configuration

DEFAULT = load_configuration(DEFAULT_FILE)
CAMPAIGN = {
    "kind": "chain",
    "axes": {"delta": {"logspace": [0.01, 1, 21]}, "gamma": [0.1, 0.3]},
    "fixed": {"alpha": 1.5, "beads": 60},
    "tolerance": 1.0e-8,
    "record": {"scalars": ["overshoot"], "profile": {"start": 1, "stop": 20, "count": 5}},
    "chunk_points": 5,
    "allow_large": False,
}

# A sentence: a key or a name, its value and limit, a colon and the way out.
SENTENCE = re.compile(r"[^\n]{5,}: [^\n]{5,}[.?]")

exactly_repeated = functools.partial(settings, deadline=None, derandomize=True, database=None)

edge_numbers = st.sampled_from(
    [
        *(math.nan, math.inf, -math.inf, 0, -0.0, 1, -1, 0.5, 2, 1 - 1e-16, 1 + 1e-15),
        *(5e-324, 1e-300, -1e-300, 1e-17, 1e-9, 1e9, 1e154, 1.7e308, -1.7e308),
        *(10**9, 2**63, 10**30, 10**400),
    ]
)
edge_values = edge_numbers | st.sampled_from(
    [None, True, "", "text", "1e-9", [], {}, [[]], [1, 1], {"start": 2, "stop": 1}, {1: 2}]
)


def leaves(value, path=()):
    """Paths of all values that are no mapping, and of all mappings."""
    yield path
    items = value.items() if isinstance(value, Mapping) else ()
    items = enumerate(value) if isinstance(value, list) else items
    for key, item in items:
        yield from leaves(item, (*path, key))


def replaced(value, path, new):
    changed = json.loads(json.dumps(value))
    *parents, last = path
    functools.reduce(operator.getitem, parents, changed)[last] = new
    return changed


def sentences(check, *arguments):
    """The sentences of a refusal, none if the input is accepted."""
    try:
        check(*arguments)
    except InputError as error:
        return str(error).splitlines()
    return []


def assert_sentences(found):
    for sentence in found:
        assert SENTENCE.fullmatch(sentence), sentence


@exactly_repeated(max_examples=100)
@given(st.sampled_from([*leaves(DEFAULT)][1:]), edge_values)
def test_any_change_of_the_configuration_is_accepted_or_refused_in_sentences(path, value):
    assert_sentences(sentences(check_configuration, replaced(DEFAULT, path, value)))


@exactly_repeated(max_examples=100)
@given(st.sampled_from([*leaves(CAMPAIGN)][1:]), edge_values)
def test_any_change_of_a_campaign_is_accepted_or_refused_in_sentences(path, value):
    assert_sentences(sentences(check_campaign, replaced(CAMPAIGN, path, value), "mine"))


NUMBER = re.compile(r"(?<=[ \[])-?\d[-+.e\d]*(?=[,\]}])")
"""A number in the JSON text of a configuration."""


@pytest.mark.parametrize("number", [math.nan, math.inf])
def test_number_that_is_not_finite_is_refused_everywhere(number):
    changed, count = NUMBER.subn(json.dumps(number), json.dumps(DEFAULT))
    found = sentences(check_configuration, json.loads(changed))
    assert len([one for one in found if "must be finite" in one]) == count > 300


@st.composite
def chains(draw):
    """Small chains pressed by a δ of any size, in time and damping that suit it."""
    alpha = draw(st.sampled_from([1, 1.001, 1.1, 1.5, 2, 3, 5]))
    beta = draw(st.sampled_from([1, alpha, 1 + alpha]))
    delta = draw(st.sampled_from([1e-12, 1e-8, 1e-3, 0.1, 7.0, 1e3, 1e8]))
    damping = draw(st.sampled_from([0.0, 1e-9, 1e-2, 0.3, 3.0]))
    beads = draw(st.integers(2, 6))
    crossings = draw(st.floats(0.5, 2.0))
    relative = draw(st.sampled_from([1e-12, 1e-10, 1e-8, 1e-6]))
    return alpha, beta, delta, damping, beads, crossings, relative


def pressed_chain(alpha, beta, delta, damping, beads, crossings, relative):
    """A scene that differs by the scales of length and time only, whatever δ is."""
    end = crossings * beads / delta ** (0.5 * (alpha - 1.0))
    return {
        "law": {
            "alpha": alpha,
            "beta": beta,
            "gamma": damping * delta ** (0.5 * (alpha + 1.0) - beta),
        },
        "beads": beads,
        "boundary": {"kind": "pressure", "left": delta, "right": 0},
        "start": {"kind": "rest"},
        "end_time": end,
        "tolerance": {"relative": relative, "absolute": 1e-2 * relative * delta},
        "record": {"snapshots": [end], "balances": True},
    }


@exactly_repeated(max_examples=40)
@given(chains())
def test_accepted_chain_is_computed_and_obeys_scaling_and_balances(parameters):
    """u/δ over ct is the same for every δ; momentum and energy are balanced."""
    alpha, beta, delta, *others = parameters
    motion = gf.simulate_chain(pressed_chain(*parameters))
    unit = gf.simulate_chain(pressed_chain(alpha, beta, 1.0, *others))
    u, reference = (data["relative_displacement"] for data in (motion, unit))
    stated = u.attrs["error_estimate"] / delta + reference.attrs["error_estimate"]
    rounding = 1e-12 * (1.0 + np.abs(reference.values).max())
    np.testing.assert_allclose(
        u.values / delta, reference.values, rtol=0, atol=10.0 * stated + rounding
    )
    assert motion.attrs["momentum_drift"] < 1e-11
    assert motion.attrs["energy_drift"] < 1e3 * others[-1]


EDGES = [("law", "alpha"), ("law", "beta"), ("law", "gamma"), ("beads",), ("boundary", "left")]
EDGES += [("end_time",), ("tolerance", "absolute")]


@exactly_repeated(max_examples=40)
@given(chains(), st.sampled_from(EDGES), edge_numbers)
def test_chain_at_the_edges_of_the_schema_is_accepted_or_refused(parameters, path, value):
    scene = replaced(pressed_chain(*parameters), path, value)
    assert_sentences(sentences(Chain.read, scene, "mine"))


dampings = st.sampled_from([0, 5e-324, 1e-290, 1e-12, 0.3, 2 - 1e-9, 2.0, 2 + 1e-9, 15.0])
ends = st.sampled_from([-56.7, -4.0, 0.0, 6.0, 52.4, 500.0, 1e300]) | st.floats(-30.0, 30.0)


@exactly_repeated(max_examples=60)
@given(dampings | st.floats(0.0, 50.0), ends, ends)
def test_orbit_is_refused_or_computed_and_its_energy_grows_as_it_should(mu, start, stop):
    """The energy z²/2 + W grows by μ ∫ z² ds, equation (56)."""
    profile = {"start": start, "stop": stop, "step": (stop - start) / 2000 or 1.0}
    refused = sentences(Orbits.read, {"mu": [mu], "profile": profile}, "mine")
    if refused:
        return assert_sentences(refused)
    s = np.linspace(start, stop, 2001)
    front = gf.heteroclinic(mu, s)
    assert front.attrs["converged"] == 1
    y, z = front["rescaled_force"].values, front["slope"].values
    energy = 0.5 * z**2 + 0.5 * y**2 * (np.log(y) - 0.5)
    growth = mu * simpson(z**2, x=s)
    stated = sum(front[name].attrs["error_estimate"] for name in ("rescaled_force", "slope"))
    tolerance = 1e-6 * (1.0 + mu) + 10.0 * stated
    assert energy[-1] - energy[0] == pytest.approx(growth, abs=tolerance)
