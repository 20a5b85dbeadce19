"""What the checker of proofs proves, and that it proves nothing from what is wrong."""

import os
import re
import subprocess
import sys
from fractions import Fraction
from pathlib import Path

import flint
import numpy as np
import pytest
from certificates import KEPT, PROVED, at, changed, enclosed, floats, load, proved, setting

from granular_fronts.proofs import arrays
from granular_fronts.proofs.__main__ import main
from granular_fronts.proofs.balls import NotProvedError, in_a_sentence, in_balls
from granular_fronts.proofs.checker import check_certificate
from granular_fronts.proofs.dashpots import ahead
from projects import ROOT


@pytest.mark.parametrize("name", PROVED)
def test_certificates_prove_what_they_proved(name):
    record, known = proved(name), PROVED[name]
    assert record["numbers"] == pytest.approx(known["numbers"], rel=1e-9, abs=0)
    assert record["error"] == pytest.approx(known["error"], rel=1e-9, abs=0)
    assert [one["name"] for one in record["inequalities"]] == list(known["inequalities"])
    for one in record["inequalities"]:
        sides = one["left"], one["right"]
        assert sides == pytest.approx(known["inequalities"][one["name"]], rel=1e-9, abs=1e-18)
        assert one["margin"] == one["right"] - one["left"] > 0
    front = enclosed(name)
    norms = front.rho.sum(), front.kappa.sum(), front.rho_behind, *front.outer_kappa
    assert floats(norms) == pytest.approx(known["norms"], rel=1e-9)


# How a statement prints each number, whether above (1) or below it (−1), and what it adds.
PRINTED = {
    "error": (r"u\* − ū\| < (\S+) on", 1, 0),
    "unique_within": (r"v − ū\| < (\S+) on", -1, 0),
    "shift": (r"\|ξ₀\| < (\S+)\.$", 1, 0),
    "overshoot": (r"max u\* > (\S+):", -1, 0),
    "amplitude_low": (r", (\S+) − 1e-6 < A", -1, 1e-6),
    "amplitude_high": (r"< A < (\S+) \+ 1e-6", 1, 1e-6),
    "tail_low": (r" (\S+) exp\(\S+ t\) < u\*", -1, 0),
    "tail_high": (r"u\* < (\S+) exp\(\S+ t\)", 1, 0),
}


@pytest.mark.parametrize("name", PROVED)
def test_statements_say_what_is_proved_and_round_it_outwards(name):
    record, text = proved(name), "\n".join(proved(name)["statements"])
    numbers = record["numbers"] | {"error": record["error"]}
    for number, (pattern, side, added) in PRINTED.items():
        for printed in re.findall(pattern, text, re.MULTILINE):
            beyond = side * (float(printed) - numbers[number]) + added
            assert 0 <= beyond < 0.002 * numbers[number] + 2 * added, number
    for words, shown in (
        ("u*' < 0 on the whole line", {"monotone", "critical"}),
        ("max u* >", {"overshoot"}),
        ("spectrally stable", {"stable"}),
        ("− A exp(λ ξ)", {"monotone"}),
    ):
        assert (words in text) == bool(shown & numbers.keys())
    assert ("dashpots" in text) == (name == "dashpots")
    # The ball of the only solution is one in which the map contracts, and hardly a larger one is.
    # Its radius is a quarter power of 2, rounded downwards.
    alone, front = flint.arb(re.search(r"‖y‖ < (\S+)\.", text)[1]), enclosed(name)
    assert -0.012 < 4 * np.log2(float(alone)) - round(4 * np.log2(float(alone))) < 0
    least = PROVED[name]["inequalities"]["Y0 < (1 − Z1 − Z2(r)) r"][0]
    with in_balls():
        assert (1 - front.Z1 - front.Z2(alone)) * alone > least
        assert not (1 - front.Z1 - front.Z2(1.25 * alone)) * 1.25 * alone > least


def test_parameters_are_exact():
    """What holds for all γ of an interval need not hold beside it."""
    record = proved("overshoot")
    assert record["gamma"] == (Fraction(3, 10), Fraction(300000001, 10**9))
    assert record["alpha"] == (2, 2)
    assert record["statements"][0].startswith("For α = 2 and each γ in [0.3, 0.300000001] there is")
    for number in ("1/3", "2", "263245873786073432/1000000000000000000", "7/2048", f"1/{2**62}"):
        assert Fraction(arrays.written(Fraction(number))) == Fraction(number)
        assert ("/" in arrays.written(Fraction(number))) == (number == "1/3")


def powers_of_gamma(name, count):
    """Zeros as coefficients of further powers of γ."""
    return changed(name, lambda f: np.concatenate([f, np.zeros_like(f[[0] * count])]))


def reflected(cells):
    return (cells * (-1.0) ** np.arange(cells.shape[-1]))[..., ::-1, :].copy()


def short_window(data):
    """p₊ longer than the window, with arrays of the lengths that follow."""
    data["sizes"][8] = reach = 2 * len(data["correction"]) // data["sizes"][2]
    cells = (reach + data["sizes"][9]) * data["sizes"][2] * data["sizes"][3]
    data["inverse_ahead"] = np.zeros((1, cells), dtype=np.int32)


# By certificate and by the sentence or the inequality that the lies break, others being as before.
LIES = {
    "monotone": {
        "the fields are": {
            "one missing": lambda data: data.pop("correction"),
            "one of the expansion missing": lambda data: data.pop("roots"),
            "a third weight": changed("weights", lambda f: np.append(f, 3.0)),
        },
        "profile is": {
            "infinite": changed("profile", at((0, 100, 0), np.inf)),
            "in single precision": changed("profile", lambda f: f.astype(np.float32)),
            "of no power of s": changed("profile", lambda f: f[:0]),
        },
        "gamma is": {
            "one fraction": setting(gamma=[3, 10]),
            "over −10": setting(gamma=[-3, -10, -3, -10]),
        },
        "gamma falls": {"by little": setting(gamma=[3 * 10**15 + 1, 10**16, 3, 10])},
        "gamma > 0": {"in part": setting(gamma=[0, 1, 3, 10])},
        "alpha > 1": {"in part": setting(alpha=[1, 1, 3, 2])},
        "sizes are": {
            "huge": changed("sizes", at(0, 2**62)),
            "zero": changed("sizes", at(5, 0)),
        },
        "there are too many powers": {
            "of the front": powers_of_gamma("profile", 8),
            "of the inverse": powers_of_gamma("inverse", 8),
        },
        "the arrays have the lengths": {
            "a cell lost": changed("profile", lambda f: f[:, 1:]),
            "a row lost": changed("correction", lambda f: f[:-1]),
            "a place lost": changed("inverse", lambda f: f[:, :-1]),
        },
        "|a(ū)/α − 1| behind −c": {"a reflected front": changed("profile", reflected)},
        "‖e‖": {
            "no inverse": changed("inverse", np.zeros_like),
            "inverse that varies with γ": changed("inverse", lambda f: np.append(f, f, 0)),
        },
        "Z1 < 1": {
            "half of γ wrong": setting(gamma=[3, 10, 5, 10]),
            "a front that varies with γ": changed("profile", lambda f: np.append(f, 0.1 * f, 0)),
            "no matrix": changed("correction", np.zeros_like),
        },
        "Z1 + Z2(r) < 1": {"α up to 1.503": setting(alpha=[3, 2, 1503, 1000])},
    },
    "dashpots": {
        "the fields are": {
            "of the other law": lambda data: data.update(profile=data.pop("strain")[None])
        },
        "sizes are": {"nine": changed("sizes", lambda f: f[:9])},
        "the arrays have the lengths": {
            "a cell lost": changed("strain", lambda rows: rows[1:]),
            "a row lost": changed("correction", lambda f: f[:-1]),
            "inverse ahead twice": changed("inverse_ahead", lambda f: np.append(f, f, axis=0)),
            "two weights": changed("weights", lambda f: f[:2]),
        },
        "‖e‖ behind": {"reversed": changed("inverse_behind", lambda f: f[:, ::-1].copy())},
        "‖e‖ ahead": {"reversed": changed("inverse_ahead", lambda f: f[:, ::-1].copy())},
        "p₊ < M + b + 1": {"a window shorter than its inverse": short_window},
        "Z1 < 1": {
            "γ up to 0.31": setting(gamma=[3, 10, 31, 100]),
            "no inverse ahead": changed("inverse_ahead", np.zeros_like),
        },
    },
}


def each(lies):
    return [
        (name, broken, lie)
        for name, ways in lies.items()
        for broken, group in ways.items()
        for lie in group
    ]


@pytest.mark.parametrize(("name", "broken", "lie"), each(LIES))
def test_nothing_is_proved_from_what_is_wrong(name, broken, lie, tmp_path):
    data = load(name)
    LIES[name][broken][lie](data)
    np.savez(tmp_path / "certificate.npz", **data)
    record = check_certificate(tmp_path / "certificate.npz")
    assert record["proved"] is False
    assert record["reason"].startswith(broken)
    assert record["statements"] == record["inequalities"] == []


# Of fields that are read only when a front is enclosed.
LATE_LIES = {
    "monotone": {
        "theta > 0": {"negative": changed("weights", at(0, -0.5))},
        "no root up to theta": {
            "next to 0": changed("weights", at(0, 5e-324)),
            "beyond the slowest": changed("weights", at(0, 1.5)),
        },
        "eta < 2 theta": {"beyond": changed("weights", at(1, 2.9))},
        "all roots up to eta": {"the pair alone": changed("roots", lambda f: f[1:])},
        "more than one real root": {
            "the slowest twice": changed("roots", lambda f: f[[0, 0]]),
            "a pair for the real root": changed("roots", at((0, 1), 1e-12)),
        },
        "no single root is found": {
            "where none is": changed("roots", at((0, 0), 3.0)),
            "in a square turned inside out": changed("roots", lambda f: f * [1, 1, 0]),
        },
        "its numbers lead to no bound": {"a wide square": changed("roots", at((0, 2), 3.0))},
        "lambda2 is not real": {"below the axis": changed("roots", lambda f: f * [1, -1, 1])},
        "0 is no number of parts": {"none": changed("starts", at(3, 0))},
        "1099511627776 is no number": {"without end": changed("starts", at(3, 2**40))},
        "x0 = ": {
            "beyond the cells": changed("starts", at(0, 40)),
            "far behind": changed("starts", at(0, -60)),
            "of three starts": changed("starts", lambda f: f[:3]),
        },
        "nearly linear behind x0": {"x0 in the front": changed("starts", at(0, 0))},
        "‖e‖ of the slow_inverse": {"misplaced": changed("starts", at(1, -800))},
        "‖e‖ of the fast_inverse": {"zero": changed("fast_inverse", np.zeros_like)},
        "an inverse does not cover": {"far away": changed("starts", at(2, -(2**40)))},
    },
    "dashpots": {
        "theta > 0": {"negative": changed("weights", at(0, -0.5))},
        # Beyond the slowest root of γ/α, not of γ.
        "no root up to theta": {"beyond the slowest": changed("weights", at(0, 1.45))},
        "sigma(nu1) > 0": {"beyond mu": changed("weights", at(1, 2.3))},
        "sigma(nu2) < 0": {"below mu": changed("weights", at(2, 2.2))},
        "nu2 < alpha nu1": {"beyond": changed("weights", at(2, 2.9))},
        "nu2 > 0": {"negative": changed("weights", at(2, -5.0))},
    },
}


def said_of_tails(name, data):
    front = enclosed(name, data=data)
    with in_balls(), in_a_sentence():
        return list(ahead.shape(front) if name == "dashpots" else front.rear())


@pytest.mark.parametrize(("name", "broken", "lie"), each(LATE_LIES))
def test_nothing_is_proved_of_tails_from_what_is_wrong(name, broken, lie):
    data = load(name)
    LATE_LIES[name][broken][lie](data)
    with pytest.raises(NotProvedError, match=f"^{re.escape(broken)}"):
        said_of_tails(name, data)


@pytest.mark.parametrize("name", LATE_LIES)
def test_tails_are_proved_from_what_is_right(name):
    assert set(said_of_tails(name, load(name))) < set(proved(name)["statements"])


def test_precision_of_others_is_left_alone():
    """The context of flint is the same afterwards, and of no influence before."""
    flint.ctx.prec, flint.ctx.cap = 30, 3
    try:
        record = check_certificate(KEPT["overshoot"])
        check_certificate("nowhere")
        assert (flint.ctx.prec, flint.ctx.cap) == (30, 3)
    finally:
        flint.ctx.prec, flint.ctx.cap = 53, 10
    assert record == proved("overshoot")


def run(script, *options, **environment):
    return subprocess.run(
        [sys.executable, *options, "-c", script],
        capture_output=True,
        encoding="cp1252",
        check=False,
        env=os.environ | environment,
    )


def test_command_needs_flint_and_numpy_only():
    """And runs on a console without Greek letters; nothing else that is installed is loaded."""
    script = (
        f"import runpy, sys; sys.path[:0] = {sys.path!r}; "
        f"sys.argv[1:] = {str(KEPT['overshoot'])!r}, 'nowhere'\n"
        "try: runpy.run_module('granular_fronts.proofs', run_name='__main__')\n"
        "finally:\n"
        " known = {*sys.stdlib_module_names, 'flint', 'numpy', 'granular_fronts'}\n"
        " known |= {'cython_runtime'}\n"
        " print({name.split('.')[0] for name in sys.modules if name[0] != '_'} - known)"
    )
    done = run(script, "-S", PYTHONIOENCODING="cp1252")
    assert done.returncode == 1
    assert done.stderr == ""
    assert "max u* > 1.00107" in done.stdout
    *_, missing, loaded = done.stdout.splitlines()
    assert missing == "nowhere: not proved: there is no file nowhere"
    assert loaded == "set()"


def test_without_flint_a_sentence_says_how_to_install_it():
    script = (
        "import sys; from importlib.machinery import PathFinder; find = PathFinder.find_spec; "
        "PathFinder.find_spec = classmethod(lambda cls, name, *more: "
        "None if name == 'flint' else find(name, *more)); "
        "import granular_fronts as gf; gf.prove_front"
    )
    done = run(script, PYTHONPATH=str(ROOT / "src"))
    assert done.returncode == 1
    assert "pip install 'granular-fronts[proofs]'" in done.stderr.splitlines()[-1]


MISSING, BROKEN = "there is no file {}", "{} is no file of arrays as prove_front"
IRREGULAR = "{} is no regular file"
NO_CERTIFICATES = {
    "nothing": (lambda file: None, MISSING),
    "a folder": (Path.mkdir, IRREGULAR),
    "a pipe": (os.mkfifo, IRREGULAR),
    "an empty file": (Path.touch, BROKEN),
    "half a certificate": (
        lambda file: file.write_bytes(KEPT["monotone"].read_bytes()[:-1000]),
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
