"""Theorems A and B and the normalisation: said where they hold, and refused where they do not."""

import re
import shutil
from fractions import Fraction

import numpy as np
import pytest
from certificates import KEPT, enclosed, load
from flint import arb

from granular_fronts.proofs import arrays, balls, checker, dashpots
from granular_fronts.proofs.__main__ import main
from granular_fronts.proofs.arrays import ends
from granular_fronts.proofs.balls import NotProvedError, in_balls
from granular_fronts.proofs.checker import Front, check_certificate, read
from granular_fronts.proofs.consequences import normalise, shape
from granular_fronts.proofs.dashpots import ahead
from granular_fronts.proofs.dashpots.checker import DashpotFront
from granular_fronts.proofs.families import certificates_below, conclude
from granular_fronts.proofs.uniqueness import FINENESS, _Neighbourhood, unique
from projects import ROOT

SHIPPED = ROOT / "docs/certificates"
FAMILY = SHIPPED / "critical_damping"


# Theorem B.


@pytest.mark.parametrize("name", ["monotone", "dashpots"])
def test_no_other_solution_is_as_near_as_stated(name):
    """With a W that is one step larger, or with W = 1, nothing is concluded."""
    front = enclosed(name)
    with in_balls():
        [statement] = unique(front)
        near = _Neighbourhood(front)
        W = front.numbers["unique_within"]
        assert near.bound(arb(W)) < 1
        assert not near.bound(arb(W * 2 ** (1 / FINENESS))) < 1
        assert not near.bound(arb(1)) < 1  # u = 0 and u = 1 are solutions, too.
        near.H = near.shift(arb(W)).lower()  # Shifts are bounded by it.
        assert not near.bound(arb(W)) < 1
    assert f"{0.999 * W:.3e}" in statement


def test_uniqueness_is_not_said_of_a_bad_inverse():
    front = enclosed("monotone", Z1=arb(1))
    with in_balls():
        assert list(unique(front)) == []
        assert "unique_within" not in front.numbers
        front.kappa = 0 * front.kappa + 0.5 / front.r
        with pytest.raises(NotProvedError, match=r"falls over \(−1, 1\)"):
            list(unique(front))


def test_distance_counts_the_line_outside_and_single_cells():
    """Where κ is large behind, ahead, or in one cell, the bounds grow with it by hand formulas."""
    W = arb("0.001")
    with in_balls():
        for u, place in ((1, 0), (0, 1)):
            fronts = [
                enclosed("monotone", outer_kappa=[arb(size if place == k else 0) for k in (0, 1)])
                for size in (100, 200)
            ]
            bounds = [_Neighbourhood(front).bound(W) for front in fronts]
            grown, rise = bounds[1] - bounds[0], fronts[0].rise(arb(u), arb(u), W)
            assert float(grown.mid()) == pytest.approx(100 * float(rise.mid()), rel=1e-4)
        front = enclosed("monotone")
        front.kappa = front.kappa.copy()
        j = front.left * front.n + 3
        before = _Neighbourhood(front)
        front.kappa[j] = arb("0.01") / front.r
        after = _Neighbourhood(front)
        top = front.u_high[j] + arb("0.01")
        gap = front.a(top) * arb("0.011") - front.a(front.u_high[j] + W) * W
        grown = after.shift(W) * after.fall - before.shift(W) * before.fall
        assert float(grown.mid()) == pytest.approx(float(gap.mid()) / front.n, rel=1e-4)


# Normalisation.


@pytest.mark.parametrize("name", ["monotone", "dashpots"])
def test_a_front_that_may_rise_or_lies_elsewhere_is_not_normalised(name):
    front = enclosed(name)
    with in_balls():
        steepest = balls.largest(front.slopes[front.left * front.n - 1 :][:2])
        with pytest.raises(NotProvedError, match="< 0 about 0"):
            normalise(front, 0, steepest)
        with pytest.raises(NotProvedError, match="falls about 0"):
            normalise(front, front.left * front.n - 1, -steepest)
        shifted = enclosed(name, u=[*front.u[2:], *front.u[-2:]])
        with pytest.raises(NotProvedError, match="within a cell of 0"):
            normalise(shifted, 0, -steepest)


@pytest.mark.parametrize(("name", "shape"), [("monotone", shape), ("dashpots", ahead.shape)])
def test_nothing_is_said_of_the_shape_of_a_front_that_is_hardly_enclosed(name, shape):
    """What errs by a tenth in the window, or by 1 behind or ahead of it, may be negative."""
    front = enclosed(name)
    with in_balls():
        large, (behind, beyond) = 1 / front.r, front.outer_kappa
        for change in (
            {"u_error": 0 * front.u_error + arb("0.1"), "rho": front.rho * 0 + large / 10},
            {"outer_kappa": (large, beyond), "rho_behind": large},
            {"outer_kappa": (behind, large), "rho_ahead": large},
        ):
            with pytest.raises(NotProvedError):
                list(shape(enclosed(name, **change)))


@pytest.mark.parametrize("name", ["monotone", "dashpots"])
def test_contraction_counts_the_line_outside_the_cells(name):
    """Where κ is large behind or ahead, Z₂(r) is κ |a(u + κr) − a(u)| with u = 1 or 0 there."""
    front = enclosed(name)
    with in_balls():
        r, (behind, beyond), large = arb("1e-6"), front.outer_kappa, arb(10) ** 5
        for u, kappa, norms in ((1, (large, beyond), "behind"), (0, (behind, large), "ahead")):
            change = {"outer_kappa": kappa, f"rho_{norms}": large}
            expected = large * front.rise(arb(u), arb(u), large * r)
            assert front.Z2(r) < expected
            assert enclosed(name, **change).Z2(r).overlaps(expected)


def test_amplitude_contains_that_of_every_possible_shift():
    """A e^(λξ₀) for |ξ₀| up to a bound that is made large: A widens by that factor, hardly more."""
    amplitudes = []
    for shift in ("0", "0.001"):
        front = enclosed("monotone", shift=arb(shift))
        with in_balls():
            list(front.rear())
        amplitudes.append([front.numbers[f"amplitude_{end}"] for end in ("low", "high")])
    (low, high), (lower, higher) = amplitudes
    factor = np.exp(1.47265948276491 * 0.001)
    assert 0.999 * low / factor < lower < low / factor
    assert high * factor < higher * (1 + 1e-12) < 1.001 * high * factor


# Theorem A.


def rows(*kinds, alpha=(Fraction(3, 2),) * 2, start="0.26"):
    """Records of neighbouring certificates, of which the named is proved."""
    gammas = [Fraction(start) + Fraction(k, 200) for k in range(len(kinds) + 1)]
    return [
        {"alpha": alpha, "gamma": pair, "numbers": {kind: 1.0} if kind else {}}
        for kind, *pair in zip(kinds, gammas[:-1], gammas[1:], strict=True)
    ]


def test_threshold_is_said_of_what_is_proved_around_it():
    """γ_x = 0.26324… is in the second of the intervals from 0.255, each 0.005 wide."""
    kinds = "oscillates", "critical", "monotone"
    first, below, above, threshold = conclude(rows(*kinds, start="0.255"))
    assert first.startswith("For α = 1.5 and each γ in [0.255, 0.27] the fronts u*")
    assert below == "For each γ in [0.255, 0.26] the front overshoots, max u* > 1."
    assert above.startswith("For each γ in [0.265, 0.27] u*' < 0 on the whole line")
    assert threshold.startswith("For each γ in [0.255, 0.27]: u*' < 0 on the whole line if and on")
    assert "γ_x = [0.2632458737860734325" in threshold
    alone = list(conclude(rows(None, "critical", "overshoot", start="0.255")))
    assert alone[-1].startswith("For each γ in [0.26, 0.265]: u*' < 0")


@pytest.mark.parametrize(
    "kinds", [("monotone", "oscillates"), ("overshoot", None, "monotone"), ("monotone",) * 2]
)
def test_no_threshold_is_said_without_a_critical_certificate(kinds):
    assert "if and only if" not in " ".join(conclude(rows(*kinds)))


def test_stability_is_said_of_the_certificates_that_show_it():
    _, *found = conclude(rows("stable", "stable", None, "stable"))
    assert found == [
        f"For each γ in [{low}, {high}] the front is spectrally stable."
        for low, high in (("0.26", "0.27"), ("0.275", "0.28"))
    ]


@pytest.mark.parametrize(("start", "side"), [("0.27", "above"), ("0.25", "below")])
def test_a_critical_certificate_elsewhere_is_refused(start, side):
    """A forged one, since γ_x is not in its interval."""
    with pytest.raises(NotProvedError, match=f"γ_x is not {side}"):
        list(conclude(rows("critical", start=start)))


@pytest.mark.slow  # Three full checks, with a hundred parts of γ behind.
def test_family_that_is_shipped_says_its_theorem(capsys):
    assert main(["--family", str(FAMILY)]) == 0
    *files, _, below, above, stable, threshold = capsys.readouterr().out.splitlines()
    assert [line.split(": ")[1] for line in files] == [
        "proved",
        *2 * ["proved, joined to the one before"],
    ]
    assert "[0.26, 0.262] the front overshoots" in below
    assert "[0.2634, 0.2645] u*' < 0" in above
    assert "[0.26, 0.2645] the front is spectrally stable" in stable
    assert "[0.26, 0.2645]: u*' < 0 on the whole line if and only if γ ≥ γ_x" in threshold


@pytest.mark.slow  # Three full checks.
def test_page_states_the_distances_of_shipped_certificates():
    page = (ROOT / "docs/proofs.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| `(\w+)` \| .* \| (0\.\d+) \|$", page, re.MULTILINE)
    assert len(rows) == 3
    for name, printed in rows:
        W = check_certificate(SHIPPED / f"{name}.npz")["numbers"]["unique_within"]
        assert 0.98 * W < float(printed) < W


@pytest.mark.slow  # A full check with 39 parts of γ behind.
def test_shipped_certificate_of_the_square_law_is_critical():
    quadratic = check_certificate(SHIPPED / "quadratic.npz")
    low, high = quadratic["gamma"]
    assert low < Fraction("0.397888496") < Fraction("0.397888497") < high
    assert quadratic["numbers"]["critical"] == 1


# Broken families and files: one sentence each, on any console.


def damaged(folder):
    file = folder / "0.262000.npz"
    file.write_bytes(file.read_bytes()[:-2000])


def empty(folder):
    for file in folder.iterdir():
        file.unlink()


BROKEN = {
    "damaged": (damaged, "is no file of arrays"),
    "dashpots": (lambda folder: shutil.copy(KEPT["dashpots"], folder), "the fields are"),
    "empty": (empty, "there is no certificate in"),
}


@pytest.mark.parametrize(("broken", "reason"), BROKEN.values(), ids=BROKEN)
def test_a_broken_family_is_one_sentence(broken, reason, tmp_path, capsys):
    folder = tmp_path / "family"
    shutil.copytree(FAMILY, folder)
    broken(folder)
    assert main(["--family", str(folder)]) == 1
    last = capsys.readouterr().out.splitlines()[-1]
    assert last.startswith(f"{folder}: not proved: ")
    assert reason in last
    assert len(last) < 600


def test_certificates_are_taken_in_the_order_of_gamma(tmp_path):
    for name, file in zip("cab", sorted(FAMILY.iterdir()), strict=True):
        (tmp_path / name).mkdir()
        shutil.copy(file, tmp_path / name / "front.npz")
    found = certificates_below(tmp_path)
    assert [file.parent.name for file in found] == ["c", "a", "b"]
    gammas = [ends(read(file), "gamma") for file in found]
    assert gammas[0][1] == gammas[1][0] < gammas[1][1] == gammas[2][0]


def test_critical_damping_is_printed_without_scipy(capsys):
    assert main(["--critical", "3/2", "5"]) == 0
    lines = capsys.readouterr().out.splitlines()
    assert lines[0].startswith("alpha = 3/2: gamma_x = [0.2632458737860734325032993281")
    assert lines[1].startswith("alpha = 5: gamma_x = [1.3643853233753060339887298")
    assert main(["--critical", "11/10", "one", "3/0", "nan", "-2"]) == 1
    assert all(line.startswith("not proved: ") for line in capsys.readouterr().out.splitlines())
    assert main([]) == main(["--critical"]) == main(["--family"]) == 2
    assert main(["-h"]) == main(["--help"]) == 0


# Checks that end.


@pytest.mark.parametrize(
    ("name", "module", "pieces"),
    [("critical", checker, 1 + 2 / 50), ("dashpots", dashpots.checker, 2)],
)
def test_the_time_of_a_check_is_estimated_from_all_that_a_certificate_holds(
    name, module, pieces, monkeypatch
):
    """Rows of the matrix, cells of inverses and of a bead of them, and polynomials on cells."""
    data, asked = load(name), []
    monkeypatch.setattr(module, "require_short", lambda *sizes: asked.extend(sizes))
    (DashpotFront if name == "dashpots" else Front)(data)
    entries = sum(values.size for field, values in data.items() if "inverse" in field)
    behind, ahead, n = data["sizes"][:3]
    fine = n * data["sizes"][3 if name == "dashpots" else 6]
    expected = len(data["correction"]), entries, fine, pieces * (behind + ahead) * n
    assert asked == pytest.approx(expected)


@pytest.mark.parametrize("large", [0, 1, 2, 3])
def test_each_size_of_a_certificate_is_limited(large):
    """Figure 1 is checked, the largest of the configuration; one size times ten thousand is not."""
    sizes = [2112, 652_800, 4800, 6432]
    arrays.require_short(*sizes)
    sizes[large] *= 10_000
    with pytest.raises(NotProvedError, match="above 60 s none is begun"):
        arrays.require_short(*sizes)
