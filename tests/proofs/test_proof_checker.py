"""What the checker of proofs proves, and that it proves nothing from what is wrong."""

import os
import subprocess
import sys
from copy import copy
from fractions import Fraction
from pathlib import Path

import flint
import numpy as np
import pytest
from certificates import DATA, PROVED, at, changed, load, proved, setting
from projects import ROOT

from granular_fronts.proofs import arrays
from granular_fronts.proofs.__main__ import main
from granular_fronts.proofs.balls import NotProvedError, in_balls
from granular_fronts.proofs.checker import Front, check_certificate, read
from granular_fronts.proofs.consequences import shape
from granular_fronts.proofs.stability import stable
from granular_fronts.proofs.uniqueness import unique


def check(data, folder):
    np.savez(folder / "certificate.npz", **data)
    return check_certificate(folder / "certificate.npz")


@pytest.mark.parametrize("name", PROVED)
def test_certificates_prove_what_they_proved(name):
    record = proved(name)
    assert record["proved"], record["reason"]
    assert record["statements"] == PROVED[name]["statements"]
    found, known = record["inequalities"], PROVED[name]["inequalities"]
    assert [one["name"] for one in found] == [one[0] for one in known]
    for one, (_, left, right) in zip(found, known, strict=True):
        assert one["left"] == pytest.approx(left, rel=1e-9, abs=1e-13)
        assert one["right"] == pytest.approx(right, rel=1e-9, abs=1e-13)
        assert one["left"] < one["right"]
        assert one["margin"] == one["right"] - one["left"] > 0


def test_parameters_are_exact():
    """What holds for all γ of an interval need not hold beside it."""
    record = proved("overshoot")
    assert record["gamma"] == (Fraction(3, 10), Fraction(300000001, 10**9))
    assert record["alpha"] == (2, 2)
    assert record["statements"][0].startswith("For α = 2 and each γ in [0.3, 0.300000001] there is")


@pytest.mark.parametrize("number", ["1/3", "2", "263245873786073432/1000000000000000000", "7/2048"])
def test_parameters_are_written_to_the_last_digit(number):
    assert Fraction(arrays.written(Fraction(number))) == Fraction(number)
    assert ("/" in arrays.written(Fraction(number))) == (number == "1/3")
    smallest = Fraction(1, 2**62)
    assert Fraction(arrays.written(smallest)) == smallest


def test_front_at_three_tenths_is_monotone_and_steeper_ones_overshoot():
    for name in ("monotone", "overshoot", "steep"):
        text = " ".join(proved(name)["statements"])
        assert ("monotone" in text) != ("overshoots" in text) == (name != "monotone")


def front(change):
    """A change of the approximate front, which does not depend on γ here."""
    return changed("profile", lambda rows: change(rows[0])[None])


def shifted_half(profile):
    return np.concatenate([profile[20:320], np.repeat(profile[320:321], 20, 0), profile[320:]])


def step(profile):
    profile = np.zeros_like(profile)
    profile[: len(profile) * 4 // 5, 0] = 1
    return profile


# Each changes one certificate so that its claim is false, or that nothing can be proved from it.
LIES = {
    "negative gamma": setting(gamma=[-3, 10, -3, 10]),
    "no gamma": setting(gamma=[0, 1, 0, 1]),
    "gamma 0.29": setting(gamma=[29, 100, 29, 100]),
    "gamma 0.31": setting(gamma=[31, 100, 31, 100]),
    "a wide interval": setting(gamma=[29, 100, 31, 100]),
    "half of gamma wrong": setting(gamma=[3, 10, 5, 10]),
    "gamma falls": setting(gamma=[3 * 10**15 + 1, 10**16, 3, 10]),
    "gamma over −10": setting(gamma=[-3, -10, -3, -10]),
    "gamma over 0": setting(gamma=[3, 0, 3, 0]),
    "one fraction for gamma": setting(gamma=[3, 10]),
    "gamma in doubles": setting(gamma=[3.0, 10.0, 3.0, 10.0]),
    "alpha 1": setting(alpha=[1, 1, 1, 1]),
    "alpha negative": setting(alpha=[-3, 2, -3, 2]),
    "infinity": front(at((100, 0), np.inf)),
    "alpha 1.51": setting(alpha=[151, 100, 151, 100]),
    "alpha up to 1.51": setting(alpha=[3, 2, 151, 100]),
    "alpha falls": setting(alpha=[3, 2, 15 * 10**14 - 1, 10**15]),
    "a reflected front": front(lambda f: f[::-1] * (-1.0) ** np.arange(f.shape[1])),
    "a step": front(step),
    "no front": front(np.zeros_like),
    "half of the front shifted": front(shifted_half),
    "cells exchanged": front(lambda f: at([200, 220], f[[220, 200]])(f)),
    "coefficients reversed": front(lambda f: f[:, ::-1].copy()),
    "no powers of s": changed("profile", lambda f: f[:0]),
    "a front that varies with gamma": changed("profile", lambda f: np.append(f, 0.1 * f, 0)),
    "a front without powers of s": changed("profile", lambda f: f[0]),
    "a cell lost": front(lambda f: f[1:]),
    "not a number": front(at((100, 3), np.nan)),
    "single precision": front(lambda f: f.astype(np.float32)),
    "no matrix": changed("correction", np.zeros_like),
    "matrix shifted": changed("correction", lambda f: np.roll(f, 20, axis=0)),
    "matrix transposed": changed("correction", lambda f: f.T.copy()),
    "matrix negative": changed("correction", lambda f: -f),
    "matrix cut": changed("correction", lambda f: f[:-1]),
    "one entry wrong": changed("correction", at((150, 150), 32767)),
    "no inverse": changed("inverse", np.zeros_like),
    "inverse reversed": changed("inverse", lambda f: f[:, ::-1].copy()),
    "inverse cut": changed("inverse", lambda f: f[:, :-1]),
    "inverse zero beyond one bead": changed("inverse", at((0, slice(6400, None)), 0)),
    "inverse that varies with gamma": changed("inverse", lambda f: np.append(f, f, 0)),
    "nine powers of s": changed("profile", lambda f: np.append(f, np.zeros_like(f[[0] * 8]), 0)),
    "negative sizes": changed("sizes", lambda f: -f),
    "huge sizes": changed("sizes", at(0, 2**62)),
    "zero sizes": changed("sizes", at(5, 0)),
    "a longer rear": changed("sizes", at(0, 18)),
    "a shorter window": changed("sizes", at(5, 3)),
    "other cells": changed("sizes", at(2, 21)),
    "p and q exchanged": changed("sizes", lambda f: f[[0, 1, 2, 4, 3, 5, 6]]),
    "field missing": lambda data: data.pop("correction"),
    "field of the expansion missing": lambda data: data.pop("roots"),
    "field too many": setting(proved=[1]),
}

LIES_BEHIND = {
    "three weights": changed("weights", lambda f: np.append(f, 3.0)),
    "a weight that is not a number": changed("weights", at(0, np.nan)),
    "theta next to 0": changed("weights", at(0, 5e-324)),
    "negative theta": changed("weights", at(0, -0.5)),
    "theta beyond the slowest root": changed("weights", at(0, 1.5)),
    "eta beyond 2 theta": changed("weights", at(1, 2.9)),
    "eta below the pair": changed("weights", at(1, 1.9)),
    "eta below the slowest root": changed("weights", at(1, 1.45)),
    "a root that is none": changed("roots", at((0, 0), 3.0)),
    "the slowest root twice": changed("roots", lambda f: f[[0, 0]]),
    "the pair alone": changed("roots", lambda f: f[1:]),
    "a pair for the real root": changed("roots", at((0, 1), 1e-12)),
    "a real root for the pair": changed("roots", at((1, 1), 0.0)),
    "the pair below the axis": changed("roots", lambda f: f * [1, -1, 1]),
    "no parts": changed("starts", at(3, 0)),
    "parts without end": changed("starts", at(3, 2**40)),
    "three starts": changed("starts", lambda f: f[:3]),
    "a wide square": changed("roots", at((0, 2), 3.0)),
    "a negative radius": changed("roots", lambda f: f * [1, 1, 0]),
    "x0 beyond the cells": changed("starts", at(0, 40)),
    "x0 far behind": changed("starts", at(0, -60)),
    "x0 in the front": changed("starts", at(0, 0)),
    "inverse misplaced": changed("starts", at(1, -800)),
    "inverse far away": changed("starts", at(2, -(2**40))),
    "no slow inverse": changed("slow_inverse", np.zeros_like),
    "no fast inverse": changed("fast_inverse", np.zeros_like),
}
LIES |= LIES_BEHIND


# These take longest, since all bounds are computed first.  Others of their kind are always tried.
LATE = {
    "alpha 1.51",
    "alpha up to 1.51",
    "gamma 0.29",
    "gamma 0.31",
    "a wide interval",
    "half of the front shifted",
    "cells exchanged",
    "matrix negative",
    "matrix shifted",
    "a front that varies with gamma",
    *LIES_BEHIND,
}
LATE_BEHIND = {"a wide square", "the pair below the axis", "x0 in the front", "inverse far away"}


@pytest.mark.parametrize(
    "lie", [pytest.param(lie, marks=pytest.mark.slow if lie in LATE else ()) for lie in LIES]
)
def test_nothing_is_proved_from_what_is_wrong(lie, tmp_path):
    data = load("monotone")
    LIES[lie](data)
    record = check(data, tmp_path)
    assert record["proved"] is False
    assert record["reason"]
    assert record["statements"] == record["inequalities"] == []


@pytest.fixture(scope="module")
def enclosed():
    """A front of which all is proved but how it comes from 1 behind."""
    with in_balls():
        front = Front(read(DATA / "monotone.npz"))
        assert len([*front.exists(), *unique(front), *shape(front), *stable(front)]) == 6
    return front


def rear_of(front, data, folder):
    """What is proved behind a front that is enclosed, from fields that are read only then."""
    np.savez(folder / "certificate.npz", **data)
    other = copy(front)
    other.data, other.inequalities, other.numbers = read(folder / "certificate.npz"), [], {}
    with in_balls():
        return list(other.rear())


def test_the_rear_is_proved_from_what_is_right(enclosed, tmp_path):
    assert rear_of(enclosed, load("monotone"), tmp_path) == PROVED["monotone"]["statements"][6:]


@pytest.mark.parametrize("lie", [lie for lie in LIES_BEHIND if lie not in LATE_BEHIND])
def test_nothing_is_proved_of_the_rear_from_what_is_wrong(lie, enclosed, tmp_path):
    data = load("monotone")
    LIES_BEHIND[lie](data)
    with pytest.raises((NotProvedError, ValueError, IndexError, ZeroDivisionError)):
        rear_of(enclosed, data, tmp_path)


@pytest.mark.slow
def test_half_an_overshoot_is_no_overshoot(tmp_path):
    """A certificate of a front that overshoots, claimed for a γ where it does not exist."""
    data = load("steep") | {"gamma": np.array([7, 10, 7, 10])}
    assert not check(data, tmp_path)["proved"]


def test_precision_of_others_is_left_alone():
    """The context of flint is the same afterwards, and of no influence before."""
    flint.ctx.prec, flint.ctx.cap = 30, 3
    try:
        record = check_certificate(DATA / "overshoot.npz")
        check_certificate("nowhere")
        assert (flint.ctx.prec, flint.ctx.cap) == (30, 3)
    finally:
        flint.ctx.prec, flint.ctx.cap = 53, 10
    assert record == proved("overshoot")


def run(*options, script, **environment):
    return subprocess.run(
        [sys.executable, *options, "-c", script],
        capture_output=True,
        text=True,
        check=False,
        env=environment or None,
    )


def test_command_needs_flint_and_numpy_only():
    """The command runs, and loads nothing of what is installed but flint and NumPy."""
    script = (
        f"import sys; sys.path[:0] = {sys.path!r}; "
        "from granular_fronts.proofs.__main__ import main; "
        f"code = main([{str(DATA / 'overshoot.npz')!r}]); "
        "known = set(sys.stdlib_module_names) | {'flint', 'numpy', 'granular_fronts', '__main__', "
        "'cython_runtime'}; "
        "print({name.split('.')[0] for name in sys.modules if not name.startswith('_')} - known); "
        "sys.exit(code)"
    )
    done = run("-S", script=script)
    assert done.returncode == 0, done.stderr
    assert "overshoots" in done.stdout
    assert done.stdout.strip().splitlines()[-1] == "set()"


def test_without_flint_a_sentence_says_how_to_install_it():
    script = (
        "import sys; from importlib.machinery import PathFinder; find = PathFinder.find_spec; "
        "PathFinder.find_spec = classmethod(lambda cls, name, *more: "
        "None if name == 'flint' else find(name, *more)); "
        "import granular_fronts as gf; gf.prove_front"
    )
    done = run(script=script, PYTHONPATH=str(ROOT / "src"))
    assert done.returncode == 1
    assert "pip install 'granular-fronts[proofs]'" in done.stderr.splitlines()[-1]


MISSING, BROKEN = "there is no file {}", "{} is no file of arrays as prove_front"
IRREGULAR = "{} is no regular file"
NO_CERTIFICATES = {
    "nothing": (lambda file: None, MISSING),
    "a folder": (Path.mkdir, IRREGULAR),
    "a pipe": (os.mkfifo, IRREGULAR),
    "an empty file": (Path.touch, BROKEN),
    "text": (lambda file: file.write_text("no arrays"), BROKEN),
    "half a certificate": (
        lambda file: file.write_bytes((DATA / "monotone.npz").read_bytes()[:-1000]),
        BROKEN,
    ),
    "objects": (lambda file: np.savez(file, weights=np.array([{}], dtype=object)), BROKEN),
    "too much": (lambda file: np.savez_compressed(file, a=np.zeros(9999)), "{} holds more than 0"),
}


@pytest.mark.parametrize("name", NO_CERTIFICATES)
def test_what_is_no_certificate_is_said_so(name, tmp_path, monkeypatch, capsys):
    write, reason = NO_CERTIFICATES[name]
    file = tmp_path / "notes.npz"
    write(file)
    monkeypatch.setattr(arrays, "LARGEST", 70_000)
    assert check_certificate(file)["proved"] is False
    assert main([str(file)]) == 1
    assert f"not proved: {reason.format(file)}" in capsys.readouterr().out
