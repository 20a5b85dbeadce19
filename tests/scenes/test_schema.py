"""Every key says what it is, and a part is what it says of itself."""

import json
import pickle
from typing import get_args

import numpy as np
import pytest
from chains import ring_scene
from configurations import DEFAULT, SCENE
from jsonschema import Draft202012Validator
from pydantic import ValidationError

from granular_fronts.errors import InputError
from granular_fronts.scenes.beads import Contacts, Factors, Masses
from granular_fronts.scenes.chain import Chain
from granular_fronts.scenes.configuration import SCENES, Configuration
from granular_fronts.scenes.parts import Part
from granular_fronts.scenes.yaml_files import load_configuration

PARTS = (Masses(), Factors(), Contacts())


def parts_below(part):
    """A part and all parts that its keys hold."""
    yield part
    for below in part.__subclasses__():
        yield from parts_below(below)


def test_every_key_of_a_scene_says_what_it_is():
    for part in parts_below(Part):
        for name, field in part.model_fields.items():
            inside = [one for one in get_args(field.annotation) or [field.annotation] if one]
            is_part = any(isinstance(one, type) and issubclass(one, Part) for one in inside)
            assert name in ("kind", "impurity") or field.description or is_part, (
                f"{part.__name__}.{name}"
            )
            assert part.__doc__


def test_what_is_left_out_of_a_scene_changes_nothing():
    """It is absent, false, an empty mapping, added as 0 or, of a taper, multiplied by 1."""
    found = {
        f"{part.__name__}.{name}": field.get_default(call_default_factory=True)
        for part in parts_below(Part)
        for name, field in part.model_fields.items()
        if part.__module__.startswith("granular_fronts.scenes") and not field.is_required()
    }
    assert found["Chain.gravity"] == 0.0
    filled = {name: value for name, value in found.items() if value and value not in PARTS}
    assert filled == {"Taper.ratio": 1.0}


def test_the_schema_for_editors_takes_the_default_and_no_unknown_key():
    validator = Draft202012Validator(Configuration.model_json_schema())
    default = load_configuration(DEFAULT)
    assert [*validator.iter_errors(default)] == []
    scene = default["scenes"]["chain"][SCENE]
    scene["bedas"] = 3
    scene["record"]["probes"]["Near"] = {}
    assert len([*validator.iter_errors(default)]) == 2


@pytest.mark.parametrize("family", SCENES)
def test_a_scene_is_what_it_says_of_itself(family):
    """Its plain form, as a file holds it, makes it again; so do its keys as arguments."""
    for name, given in load_configuration(DEFAULT)["scenes"][family].items():
        scene = SCENES[family].read(given, name)
        assert SCENES[family].read(json.loads(json.dumps(scene.plain())), name) == scene
        assert SCENES[family](**given) == scene
        assert pickle.loads(pickle.dumps(scene)) == scene
        changed = next(iter(scene.model_fields_set))
        with pytest.raises(ValidationError):
            setattr(scene, changed, None)


def test_a_scene_may_hold_numpy_values_and_is_refused_under_its_own_name():
    given = ring_scene([1.0] * 3, [0.0] * 3)
    start = {"kind": "given", "relative_displacement": np.ones(3), "velocity": np.zeros(3)}
    arguments = given | {"beads": np.int64(3), "start": start}
    arguments |= {"record": {"snapshots": np.array([10.0])}}
    scene = Chain.read(arguments, "mine")
    assert scene == Chain(**arguments) == Chain(**given)
    assert type(scene.beads.count) is int
    with pytest.raises(InputError, match=r"^Scene mine: law\.gamma is -1"):
        Chain.read(given | {"law": {"alpha": 1.5, "gamma": np.float64(-1.0)}}, "mine")
