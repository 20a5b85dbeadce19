"""Fronts with linear dashpots: what is proved, that wrong claims are not, and the bounds anew."""

import copy

import numpy as np
import pytest
from certificates import (
    Mesh,
    floats,
    inverse_defect,
    middles,
    on_cells,
    quadrature,
)
from flint import arb_poly
from scipy import optimize

import granular_fronts as gf
from granular_fronts.errors import InputError
from granular_fronts.proofs import balls
from granular_fronts.proofs.__main__ import main
from granular_fronts.proofs.arrays import load
from granular_fronts.proofs.dashpots.checker import DashpotFront

ALPHA, GAMMA = 1.5, 0.3
ENDS = "behind", "ahead"


@pytest.fixture(scope="module")
def path(tmp_path_factory):
    return tmp_path_factory.mktemp("dashpots") / "front.npz"


@pytest.fixture(scope="module")
def record(path):
    return gf.prove_front("3/2", "3/10", path, cells=16, beta=1)


@pytest.fixture(scope="module")
def front(record, path):
    with balls.in_balls():
        front = DashpotFront(load(path))
        front.statements = list(front.prove())
    return front


@pytest.fixture(scope="module")
def computed():
    return gf.solve_front(ALPHA, GAMMA, beta=1.0)


# Left sides of inequalities, found once.
KNOWN = {
    "little force ahead": 0.464354,
    "decrease ahead": 0.000586628,
    "u' < 0 in the window": -0.00543432,
}


def test_front_is_proved(record, front, path, capsys):
    assert record["proved"], record["reason"]
    assert record["statements"] == front.statements
    assert "dashpots" in record["statements"][0]
    assert record["error"] < 2e-9
    assert all(one["left"] < one["right"] for one in record["inequalities"])
    left = {one["name"]: one["left"] for one in record["inequalities"]}
    assert {name: left[name] for name in KNOWN} == pytest.approx(KNOWN, rel=1e-4)
    assert record["numbers"]["radius"] == pytest.approx(4.64e-11, rel=0.1)
    assert main([str(path)]) == 0
    assert "the front overshoots" in capsys.readouterr().out


def test_computed_front_lies_in_the_enclosure(record, front, computed):
    """And so do its maximum, where it falls, and its tail ahead."""
    xi, numbers = middles(front), record["numbers"]
    assert abs(gf.evaluate_front(computed, xi) - floats(front.u_mid)).max() < record["error"]
    top = 1 + computed.attrs["overshoot"]
    assert top - 2e-5 < numbers["overshoot"] < top

    t = np.linspace(0, 5, 51)
    u = gf.evaluate_front(computed, numbers["tail_start"] + t)
    _, slow, fast = front.data["weights"]
    assert (numbers["tail_low"] * np.exp(-fast * t) < u).all()
    assert (u < numbers["tail_high"] * np.exp(-slow * t)).all()
    mu = optimize.brentq(lambda rate: 2 * GAMMA * (np.cosh(rate) - 1) - rate, 1, 5)
    assert slow < mu < fast
    assert u[-11] / u[-1] == pytest.approx(np.exp(mu), rel=1e-3)
    falls = float(eval(record["statements"][3].split("ξ ≥ ")[1].split(",")[0]))
    u = gf.evaluate_front(computed, np.linspace(falls - 0.5, 8, 300))
    assert (np.diff(u)[20:] < 0).all()
    assert np.diff(u).max() > 0


def strain(front, xi):
    """ū anywhere, in doubles."""
    return on_cells(front.data["strain"], front.sizes["behind"], front.n, xi)


def test_residual_is_bounded(front):
    """F(ū) by quadrature of the profile equation of the project, below Y₀ and near it."""
    found = []
    for x in middles(front)[::3]:
        for xi in (x, x + 0.47 / front.n, x - 0.47 / front.n):

            def flux(eta, xi=xi):
                u, s = strain(front, eta), xi - eta
                return (1 - abs(s)) * np.maximum(u, 0) ** ALPHA + GAMMA * np.sign(s) * u

            found.append(abs(strain(front, xi) - quadrature(flux, xi, front.n)))
    bound = {one["name"]: one["left"] for one in front.inequalities}["Y0 < (1 − Z1 − Z2(r)) r"]
    assert 0.1 * bound < max(found) < bound + 1e-14


def test_powers_of_strains_are_bounded_on_every_cell(front):
    """|ū₊^α − P̄| is below its bound; where P̄ is 0 that is far below the bounds of other cells."""
    with balls.in_balls():
        cells = [*zip(front.u, front.P, map(balls.above, front.remainders), strict=True)]
        for u, P, bound in cells:
            for place in (-1, -0.4, 0, 1):
                exact = max(float(u(place)), 0.0) ** ALPHA
                assert abs(exact - float(P(place))) <= bound + 1e-15 * exact
    ahead = [bound for _, P, bound in cells if not P.coeffs()]
    assert 0.0 < max(ahead) < 1e-4 * max(bound for *_, bound in cells)


def test_strain_that_falls_to_almost_nothing_in_a_cell_is_taken_for_nothing(front):
    """Its Taylor polynomial would be worse than 0."""
    steep = copy.copy(front)
    with balls.in_balls():
        steep.u = [arb_poly([5.25e-11, -4.75e-11])]
        steep.u_low, steep.u_high = map(balls.array, zip(*map(balls.bounds, steep.u), strict=True))
        P, bound = steep.force(0)
    assert not P.coeffs()
    assert float(bound) == pytest.approx(1e-10**ALPHA)


def kernels(front):
    """Both g and H in doubles."""
    behind, ahead = (np.cumsum(np.cumsum(front.data[f"inverse_{end}"][0])) / 2**20 for end in ENDS)
    correction = front.data["correction"].astype(int)
    H = np.cumsum(np.cumsum(correction, axis=1), axis=0) / 2**16
    return behind, ahead, np.eye(len(H)) + H


def test_norms_are_those_of_dense_matrices(front):
    """Z₁ and ρ by the formulas of `right_inverse`, with matrices instead of polynomials."""
    sizes, n, h = front.sizes, front.n, 1 / front.n
    p, p_ahead, M, b = sizes["p"], sizes["p_ahead"], sizes["M"], front.b
    g, g_ahead, H = kernels(front)
    low, mid, high = (
        ALPHA * np.maximum(floats(u), 0) ** (ALPHA - 1)
        for u in (front.u_low, front.u_mid, front.u_high)
    )
    xi, W = middles(front), len(H)
    drift = max(abs(a[xi < -sizes["c"]] / ALPHA - 1).max() for a in (low, high))
    force_ahead = high[xi > M - p_ahead].max()
    window = (xi > -b) & (xi < M)
    a, low, high = mid[window], low[window], high[window]

    x = xi[window]
    apart = np.round(np.subtract.outer(x, x) * n)
    whole = (abs(apart) < n) + (abs(apart) == n) / 2
    jump = np.sign(apart) * whole * h
    tent = np.maximum(1 - abs(apart) * h, 0) * h
    tent += np.select([apart == 0, abs(apart) == n], [-h * h / 4, h * h / 8])
    T = GAMMA * jump + tent * a
    rest = abs(np.eye(W) - H + T @ H) @ (2 * GAMMA + tent @ a)
    edges = np.append(x - h / 2, M)
    s = np.subtract.outer(x, edges)
    jumps, tents = H @ (np.sign(s) * (abs(s) < 1)) * GAMMA, H @ np.maximum(1 - abs(s), 0)
    v = h / 2 * sum(abs(jumps[:, k : k + W] + a * tents[:, k : k + W]).sum(axis=1) for k in (0, 1))
    v += h * h / 8 * abs(H) @ (2 * whole @ a)
    w = 1 + v
    inner = GAMMA * h / 2 * ((2 * (apart == 0) + (abs(apart) == n)) @ w)
    inner += h * h / 2 * (abs(apart) <= n) @ (w * high)
    inner += tent @ (w * np.maximum(high - a, a - low))

    ng = n * sizes["fine"]
    jumps = 4 * GAMMA
    e, norm = inverse_defect(
        g, p, ng, lambda s: ALPHA * (1 - abs(s)) + GAMMA * np.sign(s), 2 * ALPHA, jumps
    )
    e_ahead, norm_ahead = inverse_defect(
        g_ahead, p_ahead, ng, lambda s: GAMMA * np.sign(s), 0, jumps
    )
    gain = max(1 + (GAMMA + high[:n].max() / 2) * w[:n].max(), rest[:n].max())
    gain_ahead = 1 + (GAMMA + high[-n:].max() / 2) * w[-n:].max()
    Z1 = max(inner[:n].max(), (inner + rest)[n:].max())
    Z1 += gain * (e + ALPHA * drift * (1 + norm))
    Z1 += gain_ahead * (e_ahead + (1 + norm_ahead) * force_ahead)
    assert float(front.Z1.mid()) == pytest.approx(Z1, rel=1e-6)

    from_left, from_right = x - h / 2 + b - 1, x + h / 2 - M
    places = (np.arange(len(g)) + 0.5) / ng - p
    behind = np.array([abs(g[places > at]).sum() / ng for at in from_left])
    places = (np.arange(len(g_ahead)) + 0.5) / ng - p_ahead
    ahead = np.array([abs(g_ahead[places < at]).sum() / ng for at in from_right])
    rho = w + gain * behind + gain_ahead * ahead
    rho[:n] += rest[:n]
    assert floats(front.rho)[window] == pytest.approx(rho, rel=1e-8)
    for bound, value in (
        (front.rho_behind, gain * (1 + norm)),
        (front.rho_ahead, gain_ahead * (1 + norm_ahead)),
    ):
        assert float(bound.mid()) == pytest.approx(value, rel=1e-8)
    assert floats(front.rho)[xi < -b] == pytest.approx(gain * (1 + norm), rel=1e-8)
    assert floats(front.rho)[xi > M] == pytest.approx(gain_ahead * (1 + norm_ahead), rel=1e-8)


@pytest.mark.slow
def test_row_norms_on_a_finer_mesh(front):
    """From below: the bounds ρ of A are attained, and 1 − L A stays below Z₁.

    A, in matrices, acts on functions that are constant on cells a third as wide.
    """
    sizes, n, k = front.sizes, front.n, 3
    g, g_ahead, H = kernels(front)
    b, M, ng = front.b, sizes["M"], n * sizes["fine"]
    mesh = Mesh(n, k, b + sizes["p"] + 2, M + sizes["q_ahead"] + 2)
    x, jump, tent = mesh.x, mesh.kernel(np.sign), mesh.kernel(lambda s: 1 - abs(s))
    a = ALPHA * np.maximum(strain(front, x), 0) ** (ALPHA - 1)
    T = GAMMA * jump + tent * a
    window, behind, ahead = (x > -b) & (x < M), x < -b, x > M
    centres = window & (np.arange(len(x)) % k == k // 2)
    spread = np.kron(np.eye(centres.sum()), np.ones((k, 1)))
    in_cells = np.zeros(len(x))
    in_cells[window] = spread @ a[centres]
    T_h = GAMMA * jump[centres] + tent[centres] * in_cells
    R = T_h * window
    f = np.diag(window.astype(float))
    f[window] += spread @ (H @ R)
    remaining = R - H @ R + T_h[:, window] @ (spread @ (H @ R))
    remaining[n:] = 0.0
    sources = np.diag(behind.astype(float)) + behind[:, None] * (T @ f)
    sources[window] += spread @ remaining
    A = mesh.inverse(g, sizes["p"], ng) @ sources + f
    sources = np.diag(ahead.astype(float)) + ahead[:, None] * (T @ f)
    A += mesh.inverse(g_ahead, sizes["p_ahead"], ng) @ sources
    safe = (x > -b - 3) & (x < M + 2)  # Away from the ends of this mesh.
    defect = abs(np.eye(len(x)) - A + T @ A)[safe].sum(axis=1).max()
    assert 0.1 * float(front.Z1.mid()) < defect < float(front.Z1.mid())
    first = (front.left - b) * n
    rho = np.repeat(floats(front.rho)[first : first + len(R)], k)
    share = abs(A)[window].sum(axis=1) / rho
    assert 0.9999 < share.max() < 1 + 1e-12
    assert np.median(share) > 0.9
    for beyond, bound in ((behind, front.rho_behind), (ahead, front.rho_ahead)):
        assert abs(A)[beyond & safe].sum(axis=1).max() < float(bound.mid())


CASES = {
    ("3/2", "1/10"): ({"cells": 40, "fine": 60, "drift": 3e-4}, 1.2439),
    ("3/2", "1"): ({"cells": 30, "drift": 3e-4}, None),
    ("6/5", "3/10"): ({}, None),
    (2, "3/10"): ({}, 1.0768),
    (2, "1/2"): ({}, 1.00045),
    (3, "1/2"): ({"cells": 30, "fine": 60, "drift": 3e-4}, 1.0446),
}


@pytest.mark.slow
@pytest.mark.parametrize("case", CASES)
def test_other_fronts(case, tmp_path):
    options, top = CASES[case]
    record = gf.prove_front(*case, tmp_path / "front.npz", beta=1, **options)
    assert record["proved"], record["reason"]
    assert record["error"] < 1e-8
    overshoot = record["numbers"].get("overshoot")
    assert overshoot is None if top is None else overshoot > top


@pytest.mark.parametrize("beta", [2, "one"])
def test_other_exponents_of_the_damping(beta, tmp_path):
    with pytest.raises(InputError, match="beta is"):
        gf.prove_front("3/2", "3/10", tmp_path / "front.npz", beta=beta)
