"""Chunks of intervals, their junctions, the tables, the archive, and what a user may ask for."""

import json
import re
import shutil
import subprocess
from itertools import pairwise
from pathlib import Path

import pytest

pytest.importorskip("flint", reason="proofs need it")

from certificates import KEPT, PROVED, proved

from archive_certificates import archive_certificates
from granular_fronts.errors import InputError
from granular_fronts.output.datasets import read_dataset, write_dataset
from granular_fronts.proofs.records import records_dataset
from granular_fronts.scenes.sentences import read_part
from granular_fronts.scenes.yaml_files import merge, read_yaml
from join_intervals import join_intervals
from proof_chunks import chunk_name, proof_chunks
from proofs_settings import Proofs
from prove_chunk import prove_chunk
from tabulate_proofs import describe, families, margins, stretches

OWN = read_yaml(Path(__file__).with_name("config.yaml"))


def test_chunks_meet_at_decimals_and_cover_the_interval():
    parts = [{"to": 0.1, "chunks": 3, "cells": 36}, {"to": 0.5, "chunks": 7, "drift": 3e-4}]
    chunks = list(proof_chunks({"alpha": 1.5, "from": 0.05, "parts": parts}))
    assert len(chunks) == 10
    assert chunks[0]["low"] == "0.050000"
    assert chunks[-1]["high"] == "0.500000"
    for before, after in pairwise(chunks):
        assert before["high"] == after["low"]
        assert before["low"] < before["high"]
    assert chunks[2] == {"alpha": 1.5, "low": "0.083333", "high": "0.100000", "cells": 36}
    assert chunks[3]["drift"] == 3e-4
    assert "cells" not in chunks[3]
    assert chunk_name(chunks[2]) == "0.083333-0.100000"


@pytest.fixture(scope="module")
def kept():
    """Records of the certificates that are kept, and the same as data."""
    rows = [proved(name) | {"name": name, "path": KEPT[name], "seconds": 1.0} for name in PROVED]
    return rows, records_dataset(rows)


def test_tables_round_bounds_outwards_and_hold_every_margin(kept):
    _, data = kept
    for name in PROVED:
        one = data.sel(certificate=[name])
        row = describe(name, one)
        assert row["certificates"] == 1
        assert float(row["error of ū below"]) >= float(one["error_bound"][0])
        assert ("max u" in row["shape"]) == bool(one["overshoot_bound"].notnull())
        if "max u" in row["shape"]:
            bound = float(row["shape"].split("max u − 1 > ")[1].split(";")[0])
            assert 0.99 * one["overshoot_bound"] <= bound <= one["overshoot_bound"]
        if "A = " in row["shape"]:
            middle, radius = map(float, row["shape"].split("A = ")[1].split(" ± "))
            assert middle - radius <= float(one["amplitude_low"][0])
            assert middle + radius >= float(one["amplitude_high"][0])
        found = list(margins(name, one))
        assert {one["inequality"] for one in found} == PROVED[name]["inequalities"].keys()
        assert all(one["margin"] == one["right"] - one["left"] > 0 for one in found)


def test_what_is_joined_is_one_family_and_stretches_are_joined_where_they_touch(kept):
    data = kept[1].isel(certificate=slice(4))
    third, near = "0.3333333333333333333", "1/3"
    gammas = [["0.1", third], [third, near], ["0.5", "0.6"], ["0.7", "0.7"]]
    ends = [[["1.5", "1.5"], gamma] for gamma in gammas]
    rows = data.assign(ends=data["ends"].copy(data=ends), joined=("certificate", [0, 1, 0, 1]))
    names, groups = zip(*families(rows), strict=True)
    assert names == ("family, alpha = 1.5",) * 2
    assert [group.sizes["certificate"] for group in groups] == [2, 2]
    assert stretches(rows) == "0.1 to 1/3 and 0.5 to 0.6 and 0.7"
    rows["ends"][1, 1, 0] = near
    assert stretches(rows).startswith(f"0.1 to {third} and 1/3 and 0.5")


def test_archive_holds_the_certificates_and_their_sums(tmp_path, kept):
    """The sums are those of another program's algorithm, and the bytes are always the same."""
    rows, _ = kept
    folder = tmp_path / "proofs"
    for name, part in (("fronts", rows[:1]), ("intervals", rows[1:])):
        (folder / name).mkdir(parents=True)
        copies = [
            row | {"path": shutil.copy(row["path"], folder / name / f"{row['name']}.npz")}
            for row in part
        ]
        write_dataset(records_dataset(copies), tmp_path / f"{name}.nc", scene_id=name, config={})
    made = []
    for k in (1, 2):
        files = tmp_path / f"{k}.tar", tmp_path / f"{k}.sha256"
        inputs = tmp_path / "fronts.nc", tmp_path / "intervals.nc", folder
        archive_certificates(*inputs, *files)
        made.append([file.read_bytes() for file in files])
    assert made[0] == made[1]
    (tmp_path / "unpacked").mkdir()
    # Python 3.11.2 has no filter, without which later ones warn.
    subprocess.run(["tar", "-xf", tmp_path / "1.tar", "-C", tmp_path / "unpacked"], check=True)
    done = subprocess.run(
        ["sha256sum", "--strict", "-c", "SHA256SUMS"],
        cwd=tmp_path / "unpacked",
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    assert done.stdout.count(": OK") == len(rows)
    assert (tmp_path / "1.sha256").read_bytes() == made[0][1]
    found = {path.name: path.parent.name for path in (tmp_path / "unpacked").rglob("*.npz")}
    first, *rest = (f"{row['name']}.npz" for row in rows)
    assert found == {first: "fronts"} | dict.fromkeys(rest, "intervals")


@pytest.mark.slow
def test_chunks_are_joined_from_their_files(tmp_path):
    """Two chunks, each proved by a job, are one family; what else lies there is left alone."""
    ends, paths = ("0.3", "0.302", "0.304"), []
    for low, high in pairwise(ends):
        folder = tmp_path / low
        folder.mkdir()
        (folder / "notes.txt").touch()
        paths.append(tmp_path / f"{low}.nc")
        chunk = {"alpha": 2.0, "low": low, "high": high, "fine": 20}
        prove_chunk(chunk, folder, paths[-1])
        found = {file.name for file in folder.iterdir()}
        assert found == {f"{float(low):.6f}.npz", "notes.txt"}
    join_intervals(paths, {"square": {"alpha": 2.0}}, tmp_path / "all.nc")
    data = read_dataset(tmp_path / "all.nc", "intervals")
    assert list(data["joined"].values) == [0, 1]
    assert list(data["gamma_high"].values) == [0.302, 0.304]
    assert json.loads(data.attrs["config"]) == {"square": {"alpha": 2.0}}
    assert (data["overshoot_bound"] > 0.0).all()


@pytest.mark.parametrize(
    ("change", "sentence"),
    [
        ({"fronts": {"hertz_1": {"gamma": [0.31, 0.3]}}}, "hertz_1.gamma goes from 0.31 to 0.3"),
        ({"fronts": {"hertz_1": {"gamma": [0.3, 0.3]}}}, "hertz_1.gamma goes from 0.3 to 0.3"),
        ({"shown": "dashpots_0_3"}, "shown is dashpots_0_3, with β = 1"),
        ({"shown": "nosuch"}, "shown is nosuch, which is not proved: choose one of hertz_0_3"),
        ({"intervals": {"hertz": {"parts": [{"to": 1, "chunks": 10**9}]}}}, "chunks is 1000000000"),
        ({"intervals": {"hertz": {"from": 0.05}}}, "intervals.hertz goes from 0.05 to 0.05"),
    ],
)
def test_impossible_settings_are_named(change, sentence):
    with pytest.raises(InputError, match=re.escape(sentence)):
        read_part(Proofs, merge(OWN, change))
