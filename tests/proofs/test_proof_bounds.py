"""The bounds of the checker, computed again by other means: quadrature, dense matrices, doubles."""

# ruff: noqa: N802

import re
from itertools import pairwise

import flint
import numpy as np
import pytest
from certificates import (
    DATA,
    PROVED,
    Mesh,
    floats,
    integrals,
    inverse_defect,
    load,
    middles,
    on_cells,
    quadrature,
)
from scipy import integrate, optimize

import granular_fronts as gf
from granular_fronts.proofs import balls, consequences, rear_expansion
from granular_fronts.proofs.checker import Front, read


class Certificate:
    """A certificate in doubles, with functions of ξ instead of polynomials on cells."""

    def __init__(self, name):
        data = load(name)
        self.alpha = data["alpha"][2] / data["alpha"][3]
        self.gamma = sum(data["gamma"][k] / data["gamma"][k + 1] for k in (0, 2)) / 2
        self.behind, self.ahead, self.n, self.p, self.q, self.c, self.fine = data["sizes"].tolist()
        (self.profile,) = data["profile"]
        self.g = np.cumsum(np.cumsum(data["inverse"][0])) / 2**20
        correction = data["correction"].astype(int)
        self.H = np.eye(len(correction)) + np.cumsum(np.cumsum(correction, axis=1), axis=0) / 2**16
        self.b, self.M = self.c + self.q + 2, self.ahead + 1

    def P(self, xi):
        return on_cells(self.profile, self.behind, self.n, np.asarray(xi, dtype=float))

    def u(self, xi):
        """K*P̄ by quadrature."""
        return np.array([self.integral(x) for x in np.atleast_1d(xi)])

    def integral(self, x):
        return quadrature(lambda eta: self.K(x - eta) * self.P(eta), x, self.n)

    def K(self, s):
        return np.where(abs(s) < 1, 1 - abs(s) + self.gamma * np.sign(s), 0.0)

    def a(self, u):
        return self.alpha * np.maximum(u, 0) ** (self.alpha - 1)


SLOW = pytest.mark.slow
FAST_AND_SLOW = [
    "monotone",
    "overshoot",
    *(pytest.param(n, marks=SLOW) for n in ("steep", "critical")),
]


@pytest.fixture(scope="module", params=FAST_AND_SLOW)
def pair(request):
    """A certificate as the checker sees it, in balls, and as this module does."""
    with balls.in_balls():
        front = Front(read(DATA / f"{request.param}.npz"))
        front.statements = [*front.exists(), *consequences.shape(front)]
        yield front, Certificate(request.param)


def test_strain_is_the_convolution_and_in_its_ranges(pair):
    front, known = pair
    some = np.arange(3, len(front.u), 7)
    assert floats(front.u_mid)[some] == pytest.approx(known.u(middles(front)[some]), abs=2e-13)
    edges = [float(front.u[k](flint.arb(1)).mid()) for k in some]
    assert edges == pytest.approx(known.u((some + 1) / front.n - front.left), abs=1e-13)
    for j in some:
        u = known.u((j + np.linspace(0.01, 0.99, 5)) / front.n - front.left)
        assert float(front.u_low[j]) - 1e-13 <= u.min()
        assert u.max() <= float(front.u_high[j]) + 1e-13


def test_residual_is_bounded_and_not_much_too_large(pair):
    front, known = pair
    t = np.linspace(-0.999, 0.999, 9)
    bound, found = [], []
    for j in range(0, len(front.u), 5):
        xi = (j + 0.5 + t / 2) / front.n - front.left
        found.append(abs(known.P(xi) - np.maximum(known.u(xi), 0) ** known.alpha).max())
        bound.append(float(front.residual(j).upper()))
    assert (np.array(found) <= np.array(bound) + 1e-14).all()
    assert max(np.array(found) / bound) > 0.9


def test_norms_are_those_of_dense_matrices(pair):
    """Z₁, ρ and κ by the formulas of `right_inverse` with matrices instead of polynomials."""
    front, known = pair
    n, h, alpha, gamma = front.n, 1 / front.n, known.alpha, known.gamma
    points = 0, gamma - 1, 1 - gamma
    nK, _ = integrate.quad(lambda s: abs(float(known.K(s))), -1, 1, points=points)
    low, mid, high = (known.a(floats(u)) for u in (front.u_low, front.u_mid, front.u_high))
    far = (front.left - known.c) * n
    drift = max(abs(a[:far] / alpha - 1).max() for a in (low, high))
    W = (known.b + known.M) * n
    low, mid, high = low[-W:], mid[-W:], high[-W:]

    # ∫ K and ∫ |K| over a cell seen from the middle of another, from 32 points.
    m = np.arange(-n, n + 1)
    K = known.K(m[:, None] * h + np.linspace(-1, 1, 65)[1::2] * h / 2)
    whole, absolute = K.mean(axis=1) * h, abs(K).mean(axis=1) * h
    x = (np.arange(W) + 0.5) * h - known.b
    apart = np.subtract.outer(np.arange(W), np.arange(W))
    T, T_abs = (
        np.where(abs(apart) <= n, f[np.clip(apart + n, 0, 2 * n)], 0) for f in (whole, absolute)
    )
    rest = abs(np.eye(W) - known.H + mid[:, None] * (T @ known.H)) @ mid * nK
    weighted = known.H * mid
    edges = np.arange(W + 1) * h - known.b
    v = h * abs(weighted @ known.K(np.subtract.outer(x, edges))).sum(axis=1)
    v += h / 2 * abs(weighted).sum(axis=1)
    w = 1 + v

    def swing(f):
        """What f, from a bead before the window to one after it, gives by steps of K in a cell."""
        weights = h * h / 2 + h * gamma * (m == 0) + h * gamma / 2 * (abs(m) == n)
        return np.convolve(f, weights, "valid")

    inner = high * swing(np.pad(w, n)) + (high - low) * (T_abs @ w)
    forward = integrate.quad(lambda s: abs(1 - s - gamma), 0, 1, points=(abs(1 - gamma),))[0]
    entering = alpha * max(forward, (gamma**2 + (1 - gamma) ** 2) / 2) * w[:n].max()
    gain = 1 + max(entering, rest[:n].max())
    ng = n * known.fine
    e, norm = inverse_defect(
        known.g, known.p, ng, lambda s: alpha * known.K(s), 2 * alpha, 4 * alpha * gamma
    )
    outer = gain * (e + drift * (norm + e)) + nK * high[-n:].max()
    Z1 = outer + max(inner[:n].max(), (inner + rest)[n:].max(), entering * drift)
    assert float(front.Z1.mid()) == pytest.approx(Z1, rel=1e-4)

    norms = np.append(np.cumsum(abs(known.g)[::-1])[::-1] / ng, 0)
    position = np.round((x - h / 2 + known.b - 1 + known.p) * ng).astype(int)
    spill = norms[np.clip(position, 0, len(norms) - 1)]
    rho, behind = w + rest + gain * spill, gain * (1 + norm)
    assert floats(front.rho)[-W:] == pytest.approx(rho, rel=1e-8)
    assert floats(front.rho)[:-W] == pytest.approx(behind, rel=1e-8)
    around = np.concatenate([np.full(n, behind), rho, np.ones(n)])
    direct = swing(around) + np.convolve(around, absolute, "valid")
    with np.errstate(divide="ignore"):
        through = (v + gain * spill + rest + inner + outer) / low
    assert floats(front.kappa)[-W:] == pytest.approx(np.minimum(direct, through), rel=2e-3)
    behind = (gain * norm + entering * (1 + drift) + outer) / (alpha * (1 - drift))
    ahead = nK * max(1, rho[-n:].max())
    assert floats(front.outer_kappa) == pytest.approx([behind, ahead], rel=1e-4)


@pytest.mark.parametrize(
    "pair",
    ["overshoot", *(pytest.param(n, marks=SLOW) for n in PROVED if n != "overshoot")],
    indirect=True,
)
def test_inverse_is_one(pair):
    """Row norms on a finer mesh: near the bounds of A and K*A, a part of that of 1 − L A.

    From below: the supremum over y that are constant on small cells, at middles of cells.  A is
    exact there but for the middle rule in the convolution with g of what is not constant on cells.
    """
    front, known = pair
    n, k = front.n, 3
    mesh = Mesh(n, k, known.b + known.p + 2, known.M + 1)
    x, K, G = mesh.x, mesh.kernel(known.K), mesh.inverse(known.g, known.p, n * known.fine)

    window = (x > -known.b) & (x < known.M)
    centres = window & (np.arange(len(x)) % k == k // 2)
    u = np.where(x < -front.left, 1.0, 0.0)
    inside = (x > -front.left) & (x < known.M)
    u[inside] = known.u(x[inside])
    stiffness = known.a(u)
    sources = np.diag(window.astype(float))
    R = stiffness[centres][:, None] * (K @ sources)[centres]
    spread = np.kron(np.eye(window.sum() // k), np.ones((k, 1)))
    f = sources.copy()
    f[window] += spread @ (known.H @ R)
    left_of = x < -known.b
    s = np.where((left_of & (x > -known.b - 1))[:, None], known.alpha * (K @ f), 0.0)
    offsets = np.subtract.outer(np.arange(len(known.H)), np.arange(len(known.H)))
    whole = integrals(known.K, n)[np.clip(offsets + n, 0, 2 * n)]
    T = np.where(abs(offsets) <= n, whole, 0.0)
    a_mid = stiffness[centres]
    remaining = (np.eye(len(T)) - known.H + a_mid[:, None] * (T @ known.H)) @ R
    remaining[n:] = 0.0
    d = np.zeros_like(f)
    d[window] = spread @ remaining
    A = G @ (np.diag(left_of.astype(float)) + s + d) + f + np.diag((x > known.M).astype(float))
    KA = K @ A
    safe = (x > -known.b - 3) & (x < known.M + 0.9)  # Away from the ends of this mesh.
    defect = abs(np.eye(len(x)) - A + stiffness[:, None] * KA)[safe].sum(axis=1).max()
    assert 0.15 * float(front.Z1.mid()) < defect < float(front.Z1.mid())
    rho, kappa = (np.repeat(floats(f)[-(window.sum() // k) :], k) for f in (front.rho, front.kappa))
    shares = [abs(f)[window].sum(axis=1) / bound for f, bound in ((A, rho), (KA, kappa))]
    assert 0.9999 < shares[0].max() < 1 + 1e-12
    assert 0.9 < shares[1].max() < 1
    assert np.median(shares[0]) > 0.9


def test_computed_fronts_lie_in_the_enclosures(pair):
    front, known = pair
    computed = gf.solve_front(known.alpha, known.gamma)
    xi = np.linspace(-front.left, known.M, 200)
    assert abs(gf.evaluate_front(computed, xi) - known.u(xi)).max() < front.error
    assert computed.attrs["error_estimate"] < front.error
    if "overshoot" in front.numbers:
        assert 1 + computed.attrs["overshoot"] > front.numbers["overshoot"]


def test_slowest_mode_by_other_means():
    """λ₁, C₁ and A against roots and quadrature in doubles, and against the computed front."""
    with balls.in_balls():
        front, known = Front(read(DATA / "monotone.npz")), Certificate("monotone")
        list(front.exists())
        x0 = int(front.data["starts"][0])
        roots = [rear_expansion.find_root(front, *row) for row in front.data["roots"].tolist()]
        source, errors = rear_expansion.boundary_source(front, (front.left + x0) * front.n)
    alpha, gamma = known.alpha, known.gamma

    def D(x):
        return 1 - alpha * (1 - gamma * x) * (2 * np.cosh(x) - 2) / x**2

    rate = optimize.brentq(D, 1.3, 1.6)
    assert float(roots[0].real.mid()) == pytest.approx(rate, rel=1e-13)
    pair = complex(float(roots[1].real.mid()), float(roots[1].imag.mid()))
    assert abs(D(pair)) < 1e-12

    def Q(t):
        return float(known.P(x0 + t)) - 1

    def z(t):
        return known.integral(x0 + t) - 1

    def quad(f, low, high):
        edges = np.arange(np.floor(low * front.n), np.ceil(high * front.n) + 1) / front.n
        edges = np.unique(np.clip(edges, low, high))
        parts = (integrate.fixed_quad(np.vectorize(f), *ends, n=4)[0] for ends in pairwise(edges))
        return sum(parts)

    for k in (1, 7, 18):
        t = (k + 0.5) / front.n
        early = -gamma * Q(t) - (t - gamma) * Q(1e-12) + quad(Q, 0, t)
        late = -alpha * ((1 - t + gamma) * z(0) - gamma * z(t - 1) - quad(z, t - 1, 0))
        assert float(source[k][0].mid()) == pytest.approx(early, rel=1e-6, abs=1e-13)
        assert float(source[front.n + k][0].mid()) == pytest.approx(late, rel=1e-6, abs=1e-13)
    assert float(errors[0].upper()) > 0
    statement = next(s for s in PROVED["monotone"]["statements"] if "A exp" in s)
    low, high = re.search(r"(\S+) − 1e-6 < A < (\S+) \+", statement).groups()
    u = gf.evaluate_front(gf.solve_front(alpha, gamma), [-12.0])
    assert float(low) < float((1 - u[0]) * np.exp(rate * 12)) < float(high)


@pytest.mark.parametrize(("gamma", "w", "n"), [(0.3, 0.0, 20), (0.3, 1.3, 20), (1.4, 0.7, 15)])
def test_kernels_and_their_norms_by_quadrature(gamma, w, n):
    with balls.in_balls():
        centres, whole, absolute = balls.kernel(flint.arb(gamma), flint.arb(w), n)

    def K(s):
        sign = 1 if s > 0 else -1
        return (1 - abs(s) + gamma * sign) * np.exp(-w * s) * (abs(s) < 1)

    assert floats(centres) == pytest.approx([K((m + 0.5) / n) for m in range(-n, n)], rel=1e-12)
    for m in range(-n, n + 1):
        halves = [((m - 0.5) / n, m / n), (m / n, (m + 0.5) / n)]
        found = sum(integrate.quad(K, *ends)[0] for ends in halves)
        size = sum(integrate.quad(lambda s: abs(K(s)), *ends, limit=200)[0] for ends in halves)
        assert whole[n + m].overlaps(flint.arb(found, 1e-8))
        assert size - 1e-9 <= float(absolute[n + m].upper()) <= size + 2 / n**2
        assert float(whole[n + m].rad()) < 1e-5


@pytest.mark.parametrize("w", [0.0, 0.7, 1.3])
def test_defect_without_an_inverse_is_that_of_the_kernel(w):
    """g = 0: e = −α K_w, and its variation by quadrature; with dashpots −γ k, whose norm is 2γ."""
    alpha, gamma, n = 1.5, 0.3, 20
    zeros = np.zeros((1, 4 * n), dtype=np.int32)
    with balls.in_balls():
        law = flint.arb(alpha), [flint.arb(gamma)]
        _, bound = balls.inverse_defect(*law, flint.arb(w), n, zeros, -2 * n)
        sign = [flint.arb(gamma) * f for f in balls.slope_kernel(flint.arb(0), n)]
        _, jump = balls.defect([sign], (flint.arb(0), flint.arb(4 * gamma)), n, zeros, -2 * n)

    def K(s):
        return (1 - abs(s) + gamma * np.sign(s)) * np.exp(-w * s)

    centres = abs(K((np.arange(-n, n) + 0.5) / n)).sum() / n
    norm = integrate.quad(lambda s: abs(K(s)), -1, 1, points=(gamma - 1, 0))[0]
    slopes = integrate.quad(lambda s: np.exp(-w * s), -1, 1)[0] + w * norm
    assert float(bound.mid()) == pytest.approx(alpha * (centres + slopes / (2 * n)), rel=2e-3)
    assert float(jump.mid()) == pytest.approx(2 * gamma, rel=1e-14)


@pytest.mark.parametrize("gamma", [(3, 10), (1, 1), (6, 5)])
def test_norm_of_the_kernel(gamma):
    front = Front(load("overshoot") | {"gamma": np.array([*gamma, *gamma])})
    g = gamma[0] / gamma[1]
    size = integrate.quad(lambda s: abs(1 - abs(s) + g * np.sign(s)), -1, 1, points=(0, g - 1))[0]
    assert float(front.nK.mid()) == pytest.approx(size, rel=1e-12)


def test_certificates_are_made_as_those_kept(tmp_path):
    record = gf.prove_front(2, ("3/10", "300000001/1000000000"), tmp_path / "made.npz")
    assert record["proved"], record["reason"]
    known = {name: left for name, left, _ in PROVED["overshoot"]["inequalities"]}
    made = {one["name"]: one["left"] for one in record["inequalities"]}
    assert made["Z1 < 1"] == pytest.approx(known["Z1 < 1"], rel=0.05)
