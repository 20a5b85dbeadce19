import itertools
import json
import math
import subprocess
import sys

import numpy as np
import pytest
from altered_files import is_without_requests
from campaigns import CHAINS, ORBITS, ROOT, all_chunks, campaign, pretend_solved, refusal, solve
from projects import load_step

from granular_fronts.campaign import chunks, cost, definition, plan, planning
from granular_fronts.campaign.axes import expand_axis
from granular_fronts.errors import InputError
from granular_fronts.output.datasets import read_dataset
from granular_fronts.output.files import HOST

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
    ({"axes": {}}, ["axes is empty"]),
    ({"axes": {"gamma": []}}, ["axes.gamma is empty", "at least one"]),
    ({"axes": {"gamma": 0.5}}, ["axes.gamma is 0.5", "a list or a mapping"]),
    ({"axes": {"gamma": {"linspac": [0, 1, 3]}}}, ["did you mean linspace?"]),
    ({"axes": {"gamma": [0.1, 0.3, 0.2]}}, ["axes.gamma has 0.2 after 0.3", "sort them"]),
    ({"axes": {"gamma": [0.1, 0.1]}}, ["axes.gamma has 0.1 after 0.1", "name each once"]),
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
    ({"tolerance": 0}, ["tolerance is 0", "limit 1e-15", "or more"]),
    ({"colour": 1}, ["colour is no key"]),
    ({"tolerance": 1e3}, ["tolerance is 1000.0", "limit 0.1", "or less"]),
    ({"record": {"scalars": ["overshoot"] * 2}}, ["record.scalars (entry 2)", "list it once"]),
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
    with pytest.raises(InputError) as caught:
        definition.check_points(campaign(axes=axes), seconds_per_point=0.0036)
    assert "1,001,000 points" in str(caught.value)
    assert "1.0 hours" in str(caught.value)
    assert "allow_large: true" in str(caught.value)
    definition.check_points(campaign(axes=axes, allow_large=True), seconds_per_point=0.0036)


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


def test_checking_and_reading_a_plan_wait_for_no_heavy_import():
    code = (
        "import granular_fronts.campaign.definition, granular_fronts.campaign.plan, sys; "
        "print({'numpy'} & {*sys.modules})"
    )
    command = [sys.executable, "-c", code]
    environment = {"PYTHONPATH": str(ROOT / "src")}
    run = subprocess.run(command, env=environment, capture_output=True, text=True, check=True)
    assert run.stdout == "set()\n"


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
    pretend_solved(asked, tmp_path, 2)
    solved, missing = chunks.find_missing(asked, tmp_path)
    lost = solved[0]
    (tmp_path / f"{lost}.nc").unlink()
    left, missing = chunks.find_missing(asked, tmp_path)
    assert set(left) == set(solved) - {lost}
    [again] = chunks.cut(asked, missing, 2)
    assert again.name == lost


def test_few_new_values_are_gathered_in_few_chunks(tmp_path):
    """Every second line is missing: the gaps do not make a chunk each."""
    values = [round(0.1 * n, 1) for n in range(1, 41)]
    pretend_solved(grown(delta=values[::2]), tmp_path, 30)
    asked = grown(delta=values)
    _, missing = chunks.find_missing(asked, tmp_path)
    assert [chunk.size for chunk in chunks.cut(asked, missing, 30)] == [30, 30]


@pytest.mark.parametrize("content", [None, '{"kind": "chain", "sett'])
def test_lost_request_of_a_solved_chunk_is_written_again(tmp_path, content):
    """The chunk itself holds it, so that nothing is solved twice."""
    [chunk] = all_chunks(campaign(ORBITS, axes={"mu": [1.0]}), 1)
    request = tmp_path / f"{chunk.name}.json"
    chunks.write_request(chunk, tmp_path)
    solve(chunk, tmp_path)
    plan.write_plan(plan.Plan(1, [chunk.name], {}), tmp_path / "plan.json")
    assert not is_without_requests(str(tmp_path / "plan.json"))
    request.unlink() if content is None else request.write_text(content)
    assert is_without_requests(str(tmp_path / "plan.json"))
    solved, missing = chunks.find_missing(campaign(ORBITS, axes={"mu": [1.0]}), tmp_path)
    assert (solved, missing.any()) == ([chunk.name], False)
    assert chunks.read_request(request) == chunk


def test_request_that_is_there_keeps_its_date(tmp_path):
    [chunk] = all_chunks(campaign(), 10)
    chunks.write_request(chunk, tmp_path)
    [file] = tmp_path.iterdir()
    before = file.stat().st_mtime_ns
    chunks.write_request(chunk, tmp_path)
    assert file.stat().st_mtime_ns == before


def test_folder_of_another_campaign_is_refused(tmp_path):
    chunks.claim_folder(campaign(), tmp_path)
    chunks.claim_folder(campaign(), tmp_path)
    with pytest.raises(InputError, match="holds the results of campaign mine of kind chain"):
        chunks.claim_folder(campaign(ORBITS), tmp_path)


# Planning.


def plan_names(asked, folder):
    return planning.plan_campaign(asked, folder, chunk_seconds=20.0).chunks


def test_plan_is_the_same_list_until_chunks_are_solved(tmp_path):
    asked = campaign(ORBITS, chunk_points=2)
    names = plan_names(asked, tmp_path)
    assert len(names) == 3
    assert plan_names(asked, tmp_path) == names
    for name in names:
        solve(chunks.read_request(tmp_path / f"{name}.json"), tmp_path)
    again = planning.plan_campaign(asked, tmp_path, chunk_seconds=20.0)
    assert sorted(again.solved) == sorted(names)
    assert again.missing == {}


def test_cost_is_not_measured_where_the_size_of_chunks_is_given(tmp_path):
    plan_names(campaign(ORBITS, chunk_points=2), tmp_path / "given")
    plan_names(campaign(ORBITS), tmp_path / "chosen")
    assert not (tmp_path / "given" / "cost.json").exists()
    assert (tmp_path / "chosen" / "cost.json").exists()


def test_plan_is_read_as_it_was_written(tmp_path):
    made = plan.Plan(7, ["a"], {"b": 2, "c": 1})
    plan.write_plan(made, tmp_path / "plan.json")
    assert plan.read_plan(tmp_path / "plan.json") == made
    assert made.chunks == ["a", "b", "c"]


def test_planning_anew_keeps_the_dates_of_requests_and_removes_leftovers(tmp_path):
    asked = campaign(ORBITS, chunk_points=2)
    names = plan_names(asked, tmp_path)
    dates = [(tmp_path / f"{name}.json").stat().st_mtime_ns for name in names]
    solve(chunks.read_request(tmp_path / f"{names[1]}.json"), tmp_path)
    (tmp_path / f"unfinished-{HOST}-99999999-0123456789abcdef.nc").touch()
    assert sorted(plan_names(asked, tmp_path)) == sorted(names)
    assert [(tmp_path / f"{name}.json").stat().st_mtime_ns for name in names] == dates
    assert not list(tmp_path.glob("unfinished*"))


@pytest.mark.parametrize(
    ("done", "seconds_per_point", "line"),
    [
        ([], 0.0, "4 of 7 points, 1 of 3 chunks, 0 min 00 s of processor time left."),
        (["b"], 40.0, "6 of 7 points, 2 of 3 chunks, 0 min 40 s of processor time left."),
        (["b", "c", "z"], 1e9, "7 of 7 points, 3 of 3 chunks, 0 min 00 s of processor time left."),
        ([], 3600.0, "4 of 7 points, 1 of 3 chunks, 3 h 00 min of processor time left."),
    ],
)
def test_progress_counts_what_lies_beside_the_plan(tmp_path, done, seconds_per_point, line):
    file = tmp_path / "plan.json"
    plan.write_plan(plan.Plan(7, ["a"], {"b": 2, "c": 1}), file)
    for name in done:
        (tmp_path / f"{name}.nc").touch()
    described = plan.describe_progress(file, seconds_per_point)
    assert described == f"Campaign {tmp_path.name}: {line}"


@pytest.mark.parametrize(
    "content", [None, "", "{", "[]", '{"points": 0, "solved": [], "missing": {}}', '{"points": 3}']
)
def test_no_plan_however_broken_loses_a_solved_chunk(tmp_path, content):
    """The chunk of this request may belong to a plan that another run has replaced."""
    solve_chunk = load_step(ROOT / "workflow/scripts/solve_chunk.py")
    [chunk] = all_chunks(campaign(ORBITS, axes={"mu": [1.0]}), 1)
    chunks.write_request(chunk, tmp_path)
    if content is not None:
        (tmp_path / "plan.json").write_text(content)
    data = tmp_path / f"{chunk.name}.nc"
    solve_chunk(tmp_path / f"{chunk.name}.json", data)
    assert read_dataset(data, scene_id=chunk.name).attrs["points"] == 1


def test_chunks_fill_the_wanted_time(tmp_path, monkeypatch):
    monkeypatch.setattr(cost, "measure", lambda campaign: 0.5)
    axes = {"mu": {"linspace": [0.5, 3.0, 90]}}
    made = planning.plan_campaign(campaign(ORBITS, axes=axes), tmp_path, chunk_seconds=15.0)
    assert list(made.missing.values()) == [30, 30, 30]
    for name, size in made.missing.items():
        assert chunks.read_request(tmp_path / f"{name}.json").size == size


def test_cost_is_measured_once_for_a_campaign_as_it_stands(tmp_path, monkeypatch):
    answers = itertools.count(1)
    monkeypatch.setattr(cost, "measure", lambda campaign: float(next(answers)))
    asked = campaign(ORBITS)
    assert [cost.seconds_per_point(asked, tmp_path) for _ in range(3)] == [1.0] * 3
    assert cost.seconds_per_point(campaign(ORBITS, tolerance=1e-6), tmp_path) == 2.0


def test_sample_for_the_cost_lies_on_the_grid():
    for asked in (campaign(), campaign(ORBITS)):
        for length in (1, 2, 100):
            for piece in cost.sample_of(asked, length):
                assert (chunks.locate(piece, asked) >= 0).all()
                assert piece.size <= length
        assert cost.measure(asked) > 0.0
