"""What a campaign file may ask for, and how it is cut into chunks."""

import json
import math
import subprocess
import sys

import numpy as np
import pytest
from campaigns import CHAINS, ORBITS, ROOT, all_chunks, campaign, pretend_solved, refusal, solve

from granular_fronts.campaign import chunks, definition
from granular_fronts.campaign.definition import expand_axis
from granular_fronts.errors import InputError

# Axes.


def test_refined_axis_meets_the_coarser_one_to_the_last_bit():
    for spacing, start, stop in [("linspace", 0.0, 1.0), ("logspace", 0.013, 1.7)]:
        coarse, fine = (expand_axis({spacing: [start, stop, count]}) for count in (11, 21))
        assert fine[::2] == coarse


def test_spacings_are_those_of_numpy():
    np.testing.assert_allclose(
        expand_axis({"linspace": [0.2, 3.0, 7]}), np.linspace(0.2, 3.0, 7), rtol=1e-11
    )
    np.testing.assert_allclose(
        expand_axis({"logspace": [0.02, 3.0, 7]}), np.geomspace(0.02, 3.0, 7), rtol=1e-11
    )
    assert expand_axis({"linspace": [0.5, 3.0, 1]}) == [0.5]
    assert expand_axis([0.1234567890123456]) == [0.1234567890123456]


REFUSED = [
    ({"axes": {"gamma": []}}, ["axes.gamma is empty", "at least one"]),
    ({"axes": {"gamma": 0.5}}, ["axes.gamma is 0.5", "a list or a mapping"]),
    ({"axes": {"gamma": [0.1, 0.3, 0.2]}}, ["axes.gamma has 0.2 after 0.3", "sort them"]),
    ({"axes": {"gamma": {"linspace": [1.0, 0.1, 5]}}}, ["must increase"]),
    ({"axes": {"gamma": {"linspace": [0.1, 1.0, 2.5]}}}, ["asks for 2.5 values", "whole number"]),
    ({"axes": {"gamma": {"logspace": [0.0, 1.0, 5]}}}, ["above 0", "linspace"]),
    ({"axes": {"gamma": [0.1, math.inf]}}, ["axes.gamma (entry 2) is inf", "finite"]),
    ({"axes": {"mu": [1.0]}}, ["axes.mu is given", "kind chain has no parameter mu"]),
    ({"axes": {"gama": [1.0]}}, ["did you mean gamma"]),
    ({"axes": {"gamma": [-0.1, 1.0]}}, ["reaches down to -0.1", "must be 0 or more"]),
    ({"axes": {"gamma": [1.0], "alpha": [1.0, 1.5]}}, ["stands under axes and under fixed"]),
    ({"fixed": {"alpha": 1.0, "beads": 30}}, ["fixed.alpha reaches down to 1", "above 1"]),
    ({"fixed": {"alpha": 1.5, "beads": 30.5}}, ["fixed.beads holds 30.5", "whole numbers"]),
    ({"fixed": {"alpha": 1.5}}, ["beads is missing", "number of beads N"]),
    ({"record": {"scalars": ["speed"]}}, ["record.scalars names speed", "front_speed"]),
    ({"record": {"profile": {"start": 3, "stop": 1, "count": 2}}}, ["profile.start is 3"]),
    (
        {"record": {"profile": {"start": 1, "stop": 20, "count": 40}}},
        ["profile.count is 40, but from 1 to 20 there are 20 beads"],
    ),
    ({"kind": "frnt"}, ["kind is", "choose chain or front or heteroclinic"]),
    (
        {"axes": {"gamma": [0.1, 1.0e12]}},
        ["units of δ and 1/c", "law.gamma = 1000000000000.0", "on one core", "or law.gamma"],
    ),
    ({"colour": 1}, ["colour is no key"]),
    (
        {"axes": {"gamma": {"linspace": [0.1, 1.0, 10**10]}}},
        ["axes.gamma = {'linspace': [0.1, 1.0, 10000000000]}", "GiB", "lower axes"],
    ),
    ({"fixed": {"alpha": 1.5, "beads": 10**9}}, ["fixed.beads = 1000000000", "477 GiB", "lower"]),
    (
        {"record": {"profile": {"start": 1, "stop": 1e9, "count": 10**9}}},
        ["record.profile.count is 1000000000", "give 100000 or less"],
    ),
]


@pytest.mark.parametrize(("changes", "words"), REFUSED, ids=[str(c)[:40] for c, _ in REFUSED])
def test_impossible_campaign_is_refused_in_a_sentence(changes, words):
    if changes.get("axes"):
        changes = {"axes": {"delta": [1.0], **changes["axes"]}}
    sentence = refusal(**changes)
    assert sentence.startswith("Campaign mine: ")
    assert sentence.endswith((".", "?"))
    for word in words:
        assert word in sentence


@pytest.mark.parametrize("start", [1, 1.5, 2.25])
@pytest.mark.parametrize("stop", [7, 7.5, 9.75])
def test_profile_of_a_chain_keeps_no_bead_twice(start, stop):
    most = math.floor(stop) - math.ceil(start) + 1
    profile = {"start": start, "stop": stop, "count": most}
    beads = campaign(record={"profile": profile}).kind.profile_points(profile)
    assert np.all(np.diff(beads) >= 1)
    assert f"there are {most} beads" in refusal(record={"profile": profile | {"count": most + 1}})


def test_large_campaign_says_how_large_and_how_long():
    axes = {"delta": {"linspace": [0.1, 1, 1001]}, "gamma": {"linspace": [0.1, 1, 1000]}}
    sentence = refusal(axes=axes)
    for word in ("1,001,000 points", "13.9 hours", "50 ms", "allow_large: true"):
        assert word in sentence
    assert campaign(axes=axes, allow_large=True).size == 1_001_000


@pytest.mark.parametrize("name", ["smok", "Smoke", "", "../default", 5])
def test_unknown_campaign_names_those_there_are(name):
    with pytest.raises(InputError, match=rf"There is no campaign {name} .*one of .*smoke"):
        definition.load_campaign(ROOT / "config/campaigns", name)


@pytest.mark.parametrize(
    ("name", "text", "words"),
    [
        ("mine", "kind: chain\naxes: {gamma: [1", ["line 3, column 1", "no YAML"]),
        ("mine", "kind: chain\nkind: front", ["line 2, column 1", "key kind stands twice"]),
        ("mine", "", ["Campaign mine: the file is null", "give a mapping"]),
        ("Mine", "kind: chain", ["Campaign Mine: a name has lower-case", "rename"]),
    ],
)
def test_unreadable_campaign_file_is_refused_in_a_sentence(tmp_path, name, text, words):
    (tmp_path / f"{name}.yaml").write_text(f"{text}\n", encoding="utf-8")
    with pytest.raises(InputError) as caught:
        definition.load_campaign(tmp_path, name)
    [sentence] = str(caught.value).splitlines()
    for word in words:
        assert word in sentence


@pytest.mark.parametrize("file", sorted((ROOT / "config/campaigns").glob("*.yaml")), ids=str)
def test_shipped_campaigns_are_accepted(file):
    definition.load_campaign(file.parent, file.stem)


def test_checking_waits_for_no_heavy_import():
    code = "import granular_fronts.campaign.definition, sys; print({'numpy'} & {*sys.modules})"
    command = [sys.executable, "-c", code]
    environment = {"PYTHONPATH": str(ROOT / "src")}
    run = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert run.stdout == "set()\n"


def test_a_job_takes_the_points_that_its_kind_solves_in_the_time_asked_for():
    assert campaign(CHAINS).points_per_chunk(30.0) == 600
    assert campaign(ORBITS).points_per_chunk(1e-9) == 1
    assert campaign(CHAINS, chunk_points=7).points_per_chunk(30.0) == 7


# Chunks.


@pytest.mark.parametrize("chunk_points", [1, 2, 3, 4, 6, 100])
def test_chunks_cover_every_point_once_and_none_is_too_large(chunk_points):
    asked = campaign()
    parts = all_chunks(asked, chunk_points)
    assert max(chunk.size for chunk in parts) <= chunk_points
    found = np.concatenate([chunks.locate(chunk, asked).ravel() for chunk in parts])
    assert sorted(found) == list(range(asked.size))


def test_points_of_a_chunk_stand_where_it_is_located():
    asked = campaign()
    grid = dict(zip(asked.grid, np.meshgrid(*asked.grid.values(), indexing="ij"), strict=True))
    for chunk in all_chunks(asked, 2):
        where = chunks.locate(chunk, asked)
        for name in ("delta", "gamma", "alpha", "beads"):
            np.testing.assert_array_equal(chunk.points()[name], grid[name].ravel()[where])


def test_beta_is_alpha_unless_given():
    [chunk] = all_chunks(
        campaign(
            axes={"alpha": [1.2, 1.5], "gamma": [0.1, 0.2]}, fixed={"delta": 1.0, "beads": 30}
        ),
        10,
    )
    np.testing.assert_array_equal(chunk.points()["beta"], [[1.2, 1.2], [1.5, 1.5]])


def test_name_of_a_chunk_is_its_content():
    [chunk] = all_chunks(campaign(), 10)
    [same] = all_chunks(campaign(chunk_points=10), 10)
    [other] = all_chunks(campaign(tolerance=1e-6), 10)
    assert chunk.name == same.name != other.name
    assert chunks.Chunk(**json.loads(chunk.as_json())).name == chunk.name


def grown(**axes):
    return campaign(axes={**CHAINS["axes"], **axes})


@pytest.mark.parametrize(
    ("changed", "new_points"),
    [
        (grown(), 0),
        (grown(delta=[0.05, 0.1, 1.0]), 3),
        (grown(gamma=[0.1, 0.2, 0.3, 0.8]), 2),
        (grown(delta=[0.1, 0.5, 1.0], gamma=[0.1, 0.3, 0.8, 0.9]), 6),
        (grown(delta=[1.0], gamma=[0.3, 0.8]), 0),
        (
            campaign(axes={"beads": [30, 40], **CHAINS["axes"]}, fixed={"alpha": 1.5}),
            6,
        ),
        (campaign(axes=dict(reversed(CHAINS["axes"].items()))), 0),
        (campaign(tolerance=1e-6), 6),
        (campaign(record={"scalars": ["overshoot"]}), 6),
    ],
    ids=["same", "slow", "fast", "both", "fewer", "fixed", "turned", "tolerance", "record"],
)
@pytest.mark.parametrize("chunk_points", [1, 2, 100])
def test_changed_axis_leaves_only_its_new_points(tmp_path, changed, new_points, chunk_points):
    pretend_solved(campaign(), tmp_path, chunk_points)
    _, missing = chunks.find_missing(changed, tmp_path)
    assert missing.sum() == new_points


def test_interrupted_campaign_keeps_what_is_finished(tmp_path):
    asked = campaign()
    every = chunks.chunks_of(asked, tmp_path, 2)
    pretend_solved(asked, tmp_path, 2)
    lost, *_ = every
    (tmp_path / f"{lost}.nc").unlink()
    solved, missing = chunks.find_missing(asked, tmp_path)
    assert {chunk.name for chunk in solved} == set(every) - {lost}
    [again] = chunks.cut(asked, missing, 2)
    assert again.name == lost


@pytest.mark.parametrize("chunk_points", [2, 7, 30])
def test_chunks_stay_the_same_while_some_of_them_are_solved(tmp_path, chunk_points):
    """A job on a cluster cuts a campaign anew, whatever others have solved, and finds its own."""
    values = [round(0.1 * n, 1) for n in range(1, 16)]
    pretend_solved(grown(delta=values[::2], gamma=[0.1, 0.3]), tmp_path, chunk_points)
    asked = grown(delta=values)
    every = chunks.chunks_of(asked, tmp_path, chunk_points)
    _, missing = chunks.find_missing(asked, tmp_path)
    for chunk in chunks.cut(asked, missing, chunk_points):
        chunks.write_request(chunk, tmp_path)
        (tmp_path / f"{chunk.name}.nc").touch()
        assert chunks.chunks_of(asked, tmp_path, chunk_points) == every
    assert not chunks.find_missing(asked, tmp_path)[1].any()


def test_few_new_values_are_gathered_in_few_chunks(tmp_path):
    """Every second line is missing: the gaps do not make a chunk each."""
    values = [round(0.1 * n, 1) for n in range(1, 41)]
    pretend_solved(grown(delta=values[::2]), tmp_path, 30)
    asked = grown(delta=values)
    _, missing = chunks.find_missing(asked, tmp_path)
    assert [chunk.size for chunk in chunks.cut(asked, missing, 30)] == [15, 15, 15, 15]


@pytest.mark.parametrize("content", [None, '{"kind": "chain", "sett'])
def test_solved_chunk_is_known_without_its_request(tmp_path, content):
    """The chunk itself holds it, so that nothing is solved twice."""
    asked = campaign(ORBITS, axes={"mu": [1.0]})
    [chunk] = all_chunks(asked, 1)
    request = solve(chunk, tmp_path).with_suffix(".json")
    request.unlink() if content is None else request.write_text(content)
    solved, missing = chunks.find_missing(asked, tmp_path)
    assert (solved, missing.any()) == ([chunk], False)


def test_damaged_chunk_without_its_request_is_solved_again(tmp_path):
    asked = campaign(ORBITS, axes={"mu": [1.0]})
    [chunk] = all_chunks(asked, 1)
    (tmp_path / f"{chunk.name}.nc").write_text("cut")
    assert list(chunks.chunks_of(asked, tmp_path, 1)) == [chunk.name]
