"""What is proved as data: chunks of intervals, records, families, and the enclosure of a front."""

import json
import shutil
import subprocess
import tarfile
from fractions import Fraction
from itertools import pairwise

import archive_certificates
import join_intervals
import numpy as np
import prove_chunk
import pytest
import tabulate_proofs
from certificates import DATA, KEPT, PROVED, proved
from proof_chunks import chunk_name, proof_chunks

import granular_fronts as gf
from granular_fronts.output.datasets import read_dataset, write_dataset
from granular_fronts.proofs.enclosure import enclosure_dataset
from granular_fronts.proofs.records import records_dataset


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
    """Records of the certificates that are kept, as data."""
    rows = [proved(name) | {"name": name, "path": KEPT[name], "seconds": 1.0} for name in PROVED]
    return rows, records_dataset(rows)


def test_data_hold_what_the_checker_says(kept):
    rows, data = kept
    assert list(data["certificate"].values) == list(PROVED)
    for row in rows:
        one = data.sel(certificate=row["name"])
        assert float(one["error_bound"]) == row["error"]
        assert float(one["radius"]) == row["numbers"]["radius"]
        for parameter in ("alpha", "gamma"):
            ends = one["ends"].sel(parameter=parameter).values
            assert tuple(map(Fraction, ends)) == row[parameter]
        assert str(one["statements"].values).splitlines() == row["statements"]
        found = one[["left", "right"]].dropna("inequality")
        sides = {known["name"]: (known["left"], known["right"]) for known in row["inequalities"]}
        assert sides == {
            str(name): (float(left), float(right))
            for name, left, right in zip(
                found["inequality"].values, found["left"].values, found["right"].values, strict=True
            )
        }


def test_only_what_is_proved_is_in_the_data(kept):
    """λ₁ of the monotone front from the computed roots, which are good to fifteen digits."""
    _, data = kept
    assert not data["joined"].any()
    for name in PROVED:
        one, numbers = data.sel(certificate=name), proved(name)["numbers"]
        assert bool(one["monotone"] == 1.0) == ("monotone" in numbers)
        assert bool(one["overshoot_bound"].notnull()) == ("overshoot" in numbers)
        if "overshoot" in numbers:
            assert 1 + one["overshoot_bound"] == numbers["overshoot"]
    one = data.sel(certificate="monotone")
    rate = gf.tail_roots(1.5, 0.3, count=1)[0].real
    low, high = (float(one[f"rate_{end}"]) for end in ("low", "high"))
    assert low < high < low + 1e-13
    assert abs(rate - low) < 1e-14


def test_tables_round_bounds_outwards_and_hold_every_margin(kept):
    _, data = kept
    for name in PROVED:
        one = data.sel(certificate=[name])
        row = tabulate_proofs.describe(name, one)
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
        margins = list(tabulate_proofs.margins(name, one))
        assert {one["inequality"] for one in margins} == PROVED[name]["inequalities"].keys()
        assert all(one["margin"] == one["right"] - one["left"] > 0 for one in margins)


def test_what_is_joined_is_one_family_and_stretches_are_joined_where_they_touch(kept):
    data = kept[1].isel(certificate=slice(4))
    third, near = "0.3333333333333333333", "1/3"
    gammas = [["0.1", third], [third, near], ["0.5", "0.6"], ["0.7", "0.7"]]
    ends = [[["1.5", "1.5"], gamma] for gamma in gammas]
    rows = data.assign(ends=data["ends"].copy(data=ends), joined=("certificate", [0, 1, 0, 1]))
    names, groups = zip(*tabulate_proofs.families(rows), strict=True)
    assert names == ("family, alpha = 1.5",) * 2
    assert [group.sizes["certificate"] for group in groups] == [2, 2]
    assert tabulate_proofs.stretches(rows) == "0.1 to 1/3 and 0.5 to 0.6 and 0.7"
    rows["ends"][1, 1, 0] = near
    assert tabulate_proofs.stretches(rows).startswith(f"0.1 to {third} and 1/3 and 0.5")


def test_computed_front_lies_in_the_enclosure_and_in_the_bounds_of_its_tail():
    data = enclosure_dataset(DATA / "monotone.npz")
    computed = gf.solve_front(1.5, 0.3)
    u = gf.evaluate_front(computed, data["xi"].values)
    assert np.all(abs(u - data["approximation"]) < data["error"])
    assert np.all(data["error"] <= data.attrs["error_bound"])
    ahead = data["xi_ahead"].values
    assert np.all(data["decay_low"] <= data["decay_high"])
    assert np.all(np.isfinite(data["decay_high"]))
    u = gf.evaluate_front(computed, ahead)
    known = u > 1e-12  # Below, the computed front is rounding.
    decay = -np.log(u[known])
    assert np.all(data["decay_low"].values[known] <= decay)
    assert np.all(decay <= data["decay_high"].values[known])
    # Ahead of all cells the bounds still grow as they must, by about 3/2 for each bead.
    growth = data["decay_low"].values[-1] / data["decay_low"].values[-21]
    assert growth == pytest.approx(1.5, rel=0.02)


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
        archive_certificates.archive_certificates(*inputs, *files)
        made.append([file.read_bytes() for file in files])
    assert made[0] == made[1]
    with tarfile.open(tmp_path / "1.tar") as tar:
        tar.extractall(tmp_path / "unpacked", filter="data")
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
        prove_chunk.prove_chunk(chunk, folder, paths[-1])
        found = {file.name for file in folder.iterdir()}
        assert found == {f"{float(low):.6f}.npz", "notes.txt"}
    join_intervals.join_intervals(paths, {"square": {"alpha": 2.0}}, tmp_path / "all.nc")
    data = read_dataset(tmp_path / "all.nc", "intervals")
    assert list(data["joined"].values) == [0, 1]
    assert list(data["gamma_high"].values) == [0.302, 0.304]
    assert json.loads(data.attrs["config"]) == {"square": {"alpha": 2.0}}
    assert (data["overshoot_bound"] > 0.0).all()
