"""Verdicts on statements of the paper and on findings of this project, and the lists of them."""

import json
import math
from itertools import chain
from pathlib import Path

import pytest
import xarray as xr
from chains import driven_scene
from tabulate_statements import find_measure

from granular_fronts.accuracy import Estimate
from granular_fronts.errors import InputError
from granular_fronts.output.statements import (
    ANSWERS,
    COMPATIBLE,
    DOES_NOT_HOLD,
    HOLDS,
    NOT_COMPATIBLE,
    NOT_JUDGED,
    NOT_REPRODUCED,
    OTHER_PARAMETERS,
    OUT_OF_REACH,
    REPRODUCED,
    UNDECIDED,
    Range,
    criterion_of,
    evaluate,
    range_of_criterion,
    scenes_of,
    verdict_on,
)
from granular_fronts.scenes.yaml_files import read_yaml

CONFIG = Path(__file__).parents[2] / "config"
LISTS = {name: read_yaml(CONFIG / f"{name}.yaml") for name in ("paper_numbers", "findings")}
STATEMENTS = list(chain(*LISTS.values()))
DEFAULTS = read_yaml(CONFIG / "default.yaml")


@pytest.mark.parametrize(
    ("criterion", "allowed"),
    [
        ("1 within 0.01", Range(0.99, 1.01)),
        ("-0.2 within 1e-12", Range(-0.2 - 1e-12, -0.2 + 1e-12)),
        ("0.4 to 0.6, a tenth of δ", Range(0.4, 0.6)),
        ("at least 0", Range(0.0, math.inf)),
        (">= 0", Range(0.0, math.inf)),
        ("above 0, in beads", Range(0.0, math.inf, strict=True)),
        ("> 0", Range(0.0, math.inf, strict=True)),
        ("at most -1.5e-3", Range(-math.inf, -1.5e-3)),
        ("below 1", Range(-math.inf, 1.0, strict=True)),
        ("< 1", Range(-math.inf, 1.0, strict=True)),
    ],
)
def test_criteria_are_read(criterion, allowed):
    assert range_of_criterion(criterion) == allowed


NUMBER, POSITIVE = {"kind": "number", "printed": "0.56"}, {"kind": "inequality", "printed": "> 0"}
TENS = {"kind": "number", "printed": "750", "within": 5}
SMALL = {"kind": "words", "printed": "very small", "criterion": "at most 0.01"}


NO_CRITERIA = ["", "small", "1", "about 1", "1 within", "above one", "0.6 to 0.4", "1 within -0.01"]


@pytest.mark.parametrize(
    ("statement", "words"),
    [
        *((SMALL | {"criterion": one}, f"criterion '{one}'") for one in NO_CRITERIA),
        *(
            (NUMBER | {"printed": printed}, f"{printed}.*(last digit|quotation marks)")
            for printed in ("nan", "inf", "-Infinity", "abc", 0.10)
        ),
        (NUMBER | {"kind": "numbers"}, r"width.*numbers.*number, inequality, words, finding"),
        (NUMBER | {"read": "title"}, r"read of .*width.*title.*abstract, opening"),
    ],
)
def test_what_cannot_be_judged_is_refused(statement, words):
    with pytest.raises((InputError, ValueError), match=words):
        range_of_criterion(criterion_of(statement | {"quantity": "width"}))


@pytest.mark.parametrize(
    ("statement", "value", "error", "verdict"),
    [
        # Half a unit of the last digit decides, unless another half-width is given.
        (NUMBER, 0.5649, 1e-9, REPRODUCED),
        (NUMBER, 0.5651, 1e-9, NOT_REPRODUCED),
        (NUMBER | {"printed": "-9.83"}, -9.8325, 1e-9, REPRODUCED),
        (NUMBER | {"printed": "2326"}, 2326.6, 1e-9, NOT_REPRODUCED),
        (NUMBER | {"printed": "5.5e-3"}, 5.549e-3, 1e-9, REPRODUCED),
        (NUMBER | {"printed": "5.5e-3"}, 5.551e-3, 1e-9, NOT_REPRODUCED),
        (TENS, 746.0, 0.1, REPRODUCED),
        (TENS, 744.0, 0.1, NOT_REPRODUCED),
        # Words are judged by their criterion alone.
        (SMALL, 0.001, 0.0, HOLDS),
        (SMALL, 0.1, 0.0, DOES_NOT_HOLD),
        (NUMBER | {"not_judged": "circular"}, 0.56, 0.0, NOT_JUDGED),
        # What is around words was not read; a number stands for itself.
        (SMALL | {"read": "abstract"}, 0.001, 0.0, COMPATIBLE),
        (SMALL | {"read": "opening"}, 0.1, 0.0, NOT_COMPATIBLE),
        (SMALL | {"read": "abstract", "not_judged": "no value"}, 0.1, 0.0, OUT_OF_REACH),
        (SMALL | {"read": "all"}, 0.1, 0.0, DOES_NOT_HOLD),
        (NUMBER | {"read": "abstract"}, 0.5651, 1e-9, NOT_REPRODUCED),
        # An error never counts in favour, neither just outside nor just inside.
        (NUMBER, 0.567, 0.003, UNDECIDED),
        (NUMBER, 0.563, 0.003, UNDECIDED),
        (POSITIVE | {"printed": "> 1"}, 0.9, 0.2, UNDECIDED),
        # One above half a unit decides nothing.
        *((NUMBER, value, 0.006, UNDECIDED) for value in (0.56, 100.0)),
        # Nor does what is negative or not a number.
        *(
            (statement, *measured, UNDECIDED)
            for statement in (NUMBER, POSITIVE, SMALL)
            for measured in ((0.56, -1e-9), (0.56, math.nan), (math.nan, 0.0))
        ),
        # A strict inequality leaves out its limit.
        (POSITIVE, 0.0, 0.0, NOT_REPRODUCED),
        (POSITIVE | {"printed": ">= 0"}, 0.0, 0.0, REPRODUCED),
        (POSITIVE | {"printed": "< 0"}, 0.0, 0.0, NOT_REPRODUCED),
        (POSITIVE | {"printed": "<= 0"}, 0.0, 0.0, REPRODUCED),
        (POSITIVE, 1e-300, 0.0, REPRODUCED),
        (POSITIVE | {"printed": "< 0"}, 1.0, 0.0, NOT_REPRODUCED),
        *(
            (POSITIVE | {"printed": printed}, value, 2e-3, UNDECIDED)
            for printed in ("> 0", ">= 0", "< 0", "<= 0")
            for value in (-1e-3, 0.0, 1e-3)
        ),
    ],
)
def test_verdict_on_a_number_and_its_error(statement, value, error, verdict):
    assert verdict_on(statement, Estimate(value, error)) == verdict


REFERENCE = driven_scene(beads=420, delta=0.1)
SPEED = {
    "quantity": "front speed",
    "kind": "number",
    "printed": "0.56",
    "scene": "chain",
    "measure": "chain.measures.predicted_speed",
    "expected": REPRODUCED,
    "remark": "a remark",
}


def by_scene(configuration):
    """The parameters of every scene and study by its name."""
    groups = [*configuration["scenes"].values(), configuration["exact_fronts"]]
    groups += [configuration["laws"], {"log_burgers_fronts": configuration["front_exponents"]}]
    return {name: part for group in groups for name, part in group.items()}


def row_of(statement, **changes):
    dataset = xr.Dataset(attrs={"config": json.dumps(REFERENCE | changes)})
    measure = find_measure(statement["measure"], CONFIG)
    return evaluate(statement, measure, {"chain": dataset}, {"chain": REFERENCE})


def test_a_statement_becomes_a_row():
    row = row_of(SPEED, tolerance={"relative": 1e-9, "absolute": 1e-11})
    assert row["computed"] == 0.1**0.25
    assert row["numerical_error"] == math.ulp(0.1**0.25)
    assert (row["verdict"], row["criterion"]) == (REPRODUCED, "0.56 within 0.005")
    assert row["remark"] == "a remark"
    unjudged = row_of(SPEED | {"not_judged": "circular"})
    assert (unjudged["criterion"], unjudged["remark"]) == ("", "circular")


def test_other_parameters_are_named_and_not_judged():
    row = row_of(SPEED, boundary={"kind": "pressure", "left": 0.2, "right": 0.0}, gravity=0.0)
    assert row["verdict"] == OTHER_PARAMETERS
    assert row["remark"] == "boundary.left is 0.2 instead of 0.1; gravity is 0.0, by default absent"
    assert row["computed"] == pytest.approx(0.2**0.25)


@pytest.mark.parametrize("failure", [KeyError, ValueError, ZeroDivisionError])
def test_other_parameters_may_leave_nothing_to_measure(failure):
    """As a bead that is not there, or the plateau of a start that has none."""

    def fails(*_):
        raise failure

    dataset = xr.Dataset(attrs={"config": json.dumps(REFERENCE)})
    row = evaluate(SPEED, fails, {"chain": dataset}, {"chain": REFERENCE | {"beads": 40}})
    assert row["verdict"] == OTHER_PARAMETERS
    assert math.isnan(row["computed"])
    with pytest.raises(failure):
        evaluate(SPEED, fails, {"chain": dataset}, {"chain": REFERENCE})


def test_several_scenes_are_measured_together():
    """In the order of the statement, with its arguments."""
    scenes = {"weak": {"law": {"alpha": 1.1}}, "hertz": {"law": {"alpha": 1.5}}}
    data = {name: xr.Dataset(attrs={"config": json.dumps(scenes[name])}) for name in scenes}
    statement = SMALL | {"quantity": "ratio", "scene": ["weak", "hertz"], "arguments": {"power": 2}}

    def ratio(one, other, power):
        alphas = [json.loads(each.attrs["config"])["law"]["alpha"] for each in (one, other)]
        return Estimate(1e-3 * (alphas[0] / alphas[1]) ** power, 0.0)

    row = evaluate(statement, ratio, data, scenes)
    assert (row["scene"], row["verdict"]) == ("weak, hertz", HOLDS)
    assert row["computed"] == pytest.approx(1e-3 * (1.1 / 1.5) ** 2)
    other = evaluate(statement, ratio, data, scenes | {"hertz": scenes["weak"]})
    assert (other["verdict"], other["remark"]) == (
        OTHER_PARAMETERS,
        "law.alpha is 1.5 instead of 1.1",
    )


def test_every_statement_can_be_measured_and_judged():
    for statement in STATEMENTS:
        assert callable(find_measure(statement["measure"], CONFIG))
        assert set(scenes_of(statement)) <= set(by_scene(DEFAULTS))
        assert statement["paper_place"]
        assert "|" not in "".join(map(str, statement.values()))
        if statement["expected"] == NOT_JUDGED:
            assert statement["not_judged"]
            continue
        assert statement["expected"] in (*ANSWERS[statement["kind"]], UNDECIDED)
        assert statement["remark"]
        low, high, _ = range_of_criterion(criterion_of(statement))
        assert low < high
        # What has no lower limit is not negative, which the tests of the tables see to.
        assert high < math.inf or statement["kind"] == "inequality"


def test_findings_print_nothing_the_paper_finds_nothing_and_all_stand_once():
    """What the paper does not print must not stand beside it, and the other way round."""
    assert all("printed" not in entry for entry in LISTS["findings"])
    assert {entry["kind"] for entry in LISTS["findings"]} == {"finding"}
    assert all(entry["printed"] for entry in LISTS["paper_numbers"])
    assert {entry["kind"] for entry in LISTS["paper_numbers"]} == {"number", "inequality", "words"}
    stated = [(entry["quantity"], entry.get("printed")) for entry in STATEMENTS]
    assert len(set(stated)) == len(stated)
