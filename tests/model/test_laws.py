"""Laws: both forms of the configuration, what they know of themselves, and wrong ones."""

import numpy as np
import pytest
from potentials import cosh

import granular_fronts as gf
from granular_fronts.errors import InputError
from granular_fronts.model.laws import make_law

TODA = {"kind": "toda", "rate": 2.0}
HERTZ = {"kind": "hertz", "alpha": 1.5}
COSH = cosh()
MAPPINGS = [
    {"alpha": 1.5, "gamma": 0.1},
    {"alpha": 1.5, "beta": 1.0, "gamma": 0.1},
    {"alpha": 1.1},
    {"elastic": TODA},
    {"elastic": TODA, "viscous": {"kind": "linear", "gamma": 0.3}},
    {"elastic": TODA, "viscous": {"kind": "proportional", "gamma": 0.3}},
    {"elastic": {"kind": "lennard_jones", "distance": 2.0}, "viscous": {"kind": "none"}},
    {"elastic": HERTZ | {"stiffness": 2.0}, "viscous": {"kind": "kuwabara_kono", "gamma": 0.3}},
    {"elastic": HERTZ | {"stiffness": 2.0}, "viscous": {"kind": "power", "beta": 1.5, "gamma": 1}},
    {"elastic": HERTZ, "viscous": {"kind": "simon_hunt_crossley", "gamma": 0.3}},
    {"elastic": {"kind": "fpu", "cubic": -1.0}, "viscous": {"kind": "toda", "strength": 0.2}},
]


def test_law_is_described_as_it_is_made():
    for mapping in MAPPINGS:
        law = gf.make_law(**mapping)
        assert make_law(mapping) == law == make_law(law.describe())
        assert hash(make_law(law.describe())) == hash(law)
        assert eval(repr(law)) == law
        assert make_law(law) is law
        assert make_law(elastic=law.elastic, viscous=law.viscous) == law


def test_both_forms_of_the_law_28_are_one():
    short = make_law(alpha=1.5, beta=2.5, gamma=0.3)
    long = make_law(elastic=HERTZ, viscous={"kind": "simon_hunt_crossley", "gamma": 0.3})
    assert short == long
    assert (short.alpha, short.beta, short.gamma) == (1.5, 2.5, 0.3)
    assert make_law(alpha=1.2).beta == 1.2
    bare = make_law(elastic=HERTZ)
    assert (bare.alpha, bare.beta, bare.gamma) == (1.5, 1.5, 0.0)


@pytest.mark.parametrize(
    ("mapping", "expected"),
    [
        ({"alpha": 1.5, "gamma": 0.1}, 0.1),
        ({"alpha": 1.5, "beta": 1.0, "gamma": 0.1}, None),
        ({"alpha": 1.5, "beta": 1.0}, 0.0),
        ({"elastic": TODA}, 0.0),
        ({"elastic": TODA, "viscous": {"kind": "proportional", "gamma": 0.3}}, 0.3),
        ({"elastic": TODA, "viscous": TODA | {"strength": 0.3}}, 0.3),
        ({"elastic": TODA, "viscous": {"kind": "linear", "gamma": 0.3}}, None),
        ({"elastic": COSH, "viscous": {"kind": "proportional", "gamma": 0.3}}, 0.3),
    ],
)
def test_proportional_damping_is_recognised(mapping, expected):
    law = make_law(mapping)
    assert law.proportional == expected
    r = np.linspace(-0.5, 0.5, 7)
    if expected is not None:
        np.testing.assert_allclose(law.viscous.first(r), expected * law.elastic.first(r))


def test_damping_is_changed_by_a_factor():
    law = make_law(elastic=TODA, viscous={"kind": "linear", "gamma": 0.3})
    r = np.linspace(-0.5, 0.5, 7)
    half = law.with_damping(0.5)
    np.testing.assert_array_equal(half.viscous.first(r), 0.5 * law.viscous.first(r))
    assert half.elastic == law.elastic
    assert law.with_damping(0.0).proportional == 0.0


def test_law_joins_domains_and_kinks():
    power = {"kind": "power", "beta": 1.0, "gamma": 0.1}
    for viscous, domain, kinks in ((power, (-1.0, np.inf), (0.0,)), (COSH, (-1.0, 3.0), ())):
        law = make_law(elastic={"kind": "lennard_jones"}, viscous=viscous)
        assert (law.domain, law.kinks) == (domain, kinks)


def test_a_users_law_says_that_a_file_cannot_hold_it():
    described = make_law(elastic=COSH, viscous={"kind": "proportional", "gamma": 0.2}).describe()
    assert described["elastic"]["name"] == "cosh"
    assert "cannot make again" in described["elastic"]["note"]
    assert described["viscous"] == {"kind": "proportional", "gamma": 0.2}


def test_a_law_that_is_no_power_has_no_exponents():
    law = make_law(elastic=TODA)
    assert not law.is_power
    assert not make_law(elastic=HERTZ | {"stiffness": 2.0}).is_power
    with pytest.raises(InputError, match=r"Toda potential .* has no alpha, beta and gamma"):
        _ = law.alpha
