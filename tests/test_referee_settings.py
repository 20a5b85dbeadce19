"""What config/referee.yaml may ask for, and the sentence for what it may not."""

import re

import pytest
from projects import ROOT

from granular_fronts.errors import InputError
from granular_fronts.referee.problems import load_problems
from granular_fronts.referee.settings import read_settings

SETTINGS = read_settings(ROOT / "config" / "referee.yaml")
FRONT = SETTINGS["motions"]["front"]


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"motions": {"wave": FRONT}}, "motions.wave is no key of the schema: the keys"),
        ({"motions": {}}, "motions is empty: give at least one entry."),
        (
            {"motions": {"front": FRONT | {"dampings": ["stee"]}}},
            "motions.front.dampings names 'stee', which is unknown: choose from glass, steel",
        ),
        (
            {"motions": {"front": FRONT | {"beads": 1}}},
            "motions.front.beads is 1, below its limit 2",
        ),
        (
            {"motions": {"front": FRONT | {"end_time": 100.2}}},
            "motions.front.end_time is 100.2, no multiple of interval 0.5",
        ),
        (
            {"motions": {"collision": FRONT | {"beads": 3}}},
            "motions.collision.beads is 3, but two beads collide: write 2.",
        ),
        (
            {"motions": {"front": FRONT | {"beads": 10**9}}},
            "motions.front: beads = 1000000000, end_time = 100, interval = 0.5 take at least 5,960",
        ),
        ({"factors": [0.9, 1, 1, 1.1]}, "factors (entry 3) is 1, not above 1 before it"),
        ({"factors": [0.9, 1.1, 1.2]}, "factors does not hold 1"),
        ({"displacement": 0}, "displacement is 0, but must be above 0"),
        ({"displacement": 1e300}, "displacement is 1e+300, above its limit 100000000.0"),
        ({"tolerance": {"relative": 2, "absolute": 1e-12}}, "tolerance.relative is 2, but must be"),
        ({"laws": {"Kuwabara": 1.5}}, '"Kuwabara" in laws is no usable name'),
        ({"laws": {"other": 1.1}}, "problem front_glass_other: LAMMPS has no law with alpha = 1.5"),
        ({"dampings": {"glass": "1e-2"}}, 'dampings.glass is "1e-2", which YAML reads as text'),
        ({"tolerance": {"relative": 1e-12}}, "tolerance.absolute is missing: add it"),
    ],
)
def test_impossible_settings_are_named(change, sentence):
    with pytest.raises(InputError, match=re.escape(f"config/referee.yaml: {sentence}")):
        load_problems(SETTINGS | change)


def test_two_problems_of_one_name_are_named():
    dampings = {"a": 0.1, "a_b": 0.2}
    motions = {"front": FRONT | {"dampings": ["a", "a_b"]}}
    laws = {"b_c": 1.5, "c": 1.5}
    with pytest.raises(InputError, match="two problems are called front_a_b_c: rename"):
        load_problems(SETTINGS | {"dampings": dampings, "motions": motions, "laws": laws})


@pytest.mark.parametrize(
    ("text", "sentence"),
    [
        ("", "the file is null: give a mapping"),
        ("problems: {}", "problems is no key of the schema"),
        ("referee: [", "this is no YAML"),
        ("referee: {factors: [1], factors: [1]}", "the key factors stands twice"),
    ],
)
def test_a_broken_file_of_settings_is_named(text, sentence, tmp_path):
    (tmp_path / "referee.yaml").write_text(text)
    with pytest.raises(InputError, match=re.escape(sentence)):
        read_settings(tmp_path / "referee.yaml")
