"""The bounds of the checker, computed again by other means: quadrature, dense matrices, doubles."""

# ruff: noqa: N802

from itertools import pairwise

import numpy as np
import pytest
from scipy import integrate, optimize

flint = pytest.importorskip("flint")

from test_proof_checker import DATA, PROVED, load  # noqa: E402

import granular_fronts as gf  # noqa: E402
from granular_fronts.proofs import balls, consequences, rear_expansion, tail_roots  # noqa: E402
from granular_fronts.proofs.checker import Front, read  # noqa: E402

NODES, WEIGHTS = np.polynomial.legendre.leggauss(12)
SLOW = {"monotone": (), "overshoot": (), "steep": pytest.mark.slow, "critical": pytest.mark.slow}


class Certificate:
    """A certificate in doubles, with functions of ξ instead of polynomials on cells."""

    def __init__(self, name):
        data = load(name)
        self.alpha = data["alpha"][2] / data["alpha"][3]
        low, high = (data["gamma"][k] / data["gamma"][k + 1] for k in (0, 2))
        self.gamma = (low + high) / 2
        self.behind, self.ahead, self.n, self.p, self.q, self.c, self.fine = data["sizes"].tolist()
        (self.profile,) = data["profile"]
        self.g = np.cumsum(np.cumsum(data["inverse"][0])) / 2**20
        size = len(data["correction"])
        correction = data["correction"].astype(int)
        self.H = np.eye(size) + np.cumsum(np.cumsum(correction, axis=1), axis=0) / 2**16
        self.b, self.M = self.c + self.q + 2, self.ahead + 1

    def P(self, xi):
        xi = np.asarray(xi, dtype=float)
        cell = np.floor((xi + self.behind) * self.n).astype(int)
        inside = (cell >= 0) & (cell < len(self.profile))
        t = 2 * ((xi + self.behind) * self.n - cell) - 1
        rows = self.profile[np.where(inside, cell, 0)]
        values = sum(rows[..., k] * t**k for k in range(rows.shape[-1]))
        return np.where(inside, values, np.where(cell < 0, 1.0, 0.0))

    def u(self, xi):
        """K*P̄ by Gauss quadrature between ends of cells."""
        xi = np.atleast_1d(xi)
        return np.array([self.integral(x) for x in xi])

    def integral(self, x):
        ends = np.arange(np.ceil((x - 1) * self.n), np.floor((x + 1) * self.n) + 1) / self.n
        ends = np.unique(np.concatenate([[x - 1, x, x + 1], ends]))
        middle, half = (ends[1:] + ends[:-1]) / 2, np.diff(ends) / 2
        eta = middle[:, None] + half[:, None] * NODES
        values = self.K(x - eta) * self.P(eta)
        return float((values @ WEIGHTS) @ half)

    def K(self, s):
        return np.where(abs(s) < 1, 1 - abs(s) + self.gamma * np.sign(s), 0.0)

    def a(self, u):
        return self.alpha * np.maximum(u, 0) ** (self.alpha - 1)


class Mesh:
    """Cells narrower than those of a certificate, and convolutions as matrices there."""

    def __init__(self, n, parts, left, right):
        self.per_bead, self.h = n * parts, 1 / (n * parts)
        self.x = (np.arange((left + right) * self.per_bead) + 0.5) * self.h - left
        self.offsets = np.round(np.subtract.outer(self.x, self.x) / self.h).astype(int)

    def toeplitz(self, values, first):
        index = self.offsets - first
        inside = (index >= 0) & (index < len(values))
        return np.where(inside, values[np.clip(index, 0, len(values) - 1)], 0.0)

    def kernel(self, f):
        """Convolution with a function on (−1, 1), by the midpoint rule on halves of cells."""
        return self.toeplitz(integrals(f, self.per_bead), -self.per_bead)

    def inverse(self, g, p, ng):
        """That with δ + g, where g is constant on cells of width 1/ng from −p on."""
        primitive = np.concatenate([[0], np.cumsum(g)]) / ng
        grid = np.arange(len(primitive)) / ng - p
        first, last = -p * self.per_bead - 1, round(grid[-1] * self.per_bead) + 2
        edges = (np.arange(first, last + 1) - 0.5) * self.h
        return np.eye(len(self.x)) + self.toeplitz(
            np.diff(np.interp(edges, grid, primitive)), first
        )


def integrals(f, n):
    """Those of a function on (−1, 1) over cells about m/n, by the midpoint rule on halves."""
    halves = np.concatenate([[0], f((np.arange(-2 * n, 2 * n) + 0.5) / (2 * n)) / (2 * n), [0]])
    return halves[::2] + halves[1::2]


@pytest.fixture(
    scope="module",
    params=[pytest.param(name, marks=SLOW[name]) for name in PROVED],
)
def pair(request):
    """A certificate as the checker sees it, in balls, and as this module does."""
    with balls.in_balls():
        front = Front(read(DATA / f"{request.param}.npz"))
        front.statements = [*front.exists(), *consequences.shape(front)]
        yield front, Certificate(request.param)


def floats(values):
    return np.array([float(value.mid()) for value in values])


def test_strain_is_the_convolution(pair):
    front, known = pair
    middles = (np.arange(len(front.u)) + 0.5) / front.n - front.left
    some = np.arange(3, len(middles), 7)
    assert floats(front.u_mid)[some] == pytest.approx(known.u(middles[some]), abs=2e-13)
    edges = [float(front.u[k](flint.arb(1)).mid()) for k in some]
    assert edges == pytest.approx(known.u((some + 1) / front.n - front.left), abs=1e-13)


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


def test_ranges_contain_the_strain(pair):
    front, known = pair
    for j in range(0, len(front.u), 11):
        u = known.u((j + np.linspace(0.01, 0.99, 5)) / front.n - front.left)
        assert (floats([front.u_low[j]]) - 1e-13 <= u).all()
        assert (u <= floats([front.u_high[j]]) + 1e-13).all()


def test_norms_are_those_of_dense_matrices(pair):
    """Z₁, ρ and κ by the formulas of `right_inverse` with matrices instead of polynomials."""
    front, known = pair
    n, h, alpha, gamma = front.n, 1 / front.n, known.alpha, known.gamma
    W = (known.b + known.M) * n
    points = 0, gamma - 1, 1 - gamma
    nK, _ = integrate.quad(lambda s: abs(float(known.K(s))), -1, 1, points=points)
    low, mid, high = (known.a(floats(u)) for u in (front.u_low, front.u_mid, front.u_high))
    far = (front.left - known.c) * n
    drift = max(abs(low[:far] / alpha - 1).max(), abs(high[:far] / alpha - 1).max())
    low, mid, high = low[-W:], mid[-W:], high[-W:]

    def cells(function, values):
        """∫ function(K) over a cell seen from the middle of another, from 16 points a half."""
        s = values[:, None] + np.linspace(-1, 1, 65)[1::2] * h / 2
        return function(known.K(s)).mean(axis=-1) * h

    x = (np.arange(W) + 0.5) * h - known.b
    offsets = np.subtract.outer(x, x)
    flat = np.round(offsets * n).astype(int)
    whole = cells(lambda k: k, np.arange(-n, n + 1) * h)
    absolute = cells(abs, np.arange(-n, n + 1) * h)
    near = abs(flat) <= n
    T = np.where(near, whole[np.clip(flat + n, 0, 2 * n)], 0)
    T_abs = np.where(near, absolute[np.clip(flat + n, 0, 2 * n)], 0)
    rest = abs(np.eye(W) - known.H + mid[:, None] * (T @ known.H)) @ mid * nK
    edges = np.arange(W + 1) * h - known.b
    weighted = known.H * mid
    v = h * abs(weighted @ known.K(np.subtract.outer(x, edges))).sum(axis=1)
    v += h / 2 * abs(weighted).sum(axis=1)
    w = 1 + v

    def swing(f):
        total = np.zeros(W)
        for m in range(-n, n + 1):
            weight = h * h / 2 + h * gamma * (m == 0) + h * gamma / 2 * (abs(m) == n)
            total += weight * np.interp(np.arange(W) + m, np.arange(-n, W + n), f)
        return total

    change = swing(np.pad(w, n))
    inner = high * change + (high - low) * (T_abs @ w)
    forward = integrate.quad(lambda s: abs(1 - s - gamma), 0, 1, points=(abs(1 - gamma),))[0]
    forward = max(forward, (gamma**2 + (1 - gamma) ** 2) / 2)
    entering = alpha * forward * w[:n].max()
    gain = 1 + max(entering, rest[:n].max())

    ng = n * known.fine
    norms = np.append(np.cumsum(abs(known.g)[::-1])[::-1] / ng, 0)
    middles = (np.arange(-ng, ng) + 0.5) / ng
    e = -alpha * np.convolve(integrals(known.K, ng), known.g)
    e[ng:-ng] += known.g
    e[known.p * ng : (known.p + 2) * ng] -= alpha * known.K(middles)
    e = abs(e).sum() / ng + alpha * (2 + (2 + 4 * gamma) * norms[0]) / (2 * ng)
    outer = gain * (e + drift * (norms[0] + e)) + nK * high[-n:].max()
    Z1 = outer + max(inner[:n].max(), (inner + rest)[n:].max(), entering * drift)
    assert float(front.Z1.mid()) == pytest.approx(Z1, rel=1e-4)

    position = np.round((x - h / 2 + known.b - 1 + known.p) * ng).astype(int)
    spill = norms[np.clip(position, 0, len(norms) - 1)]
    rho = w + rest + gain * spill
    assert floats(front.rho)[-W:] == pytest.approx(rho, rel=1e-8)
    assert floats(front.rho)[:-W] == pytest.approx(gain * (1 + norms[0]), rel=1e-8)
    padded = np.concatenate([np.full(n, gain * (1 + norms[0])), rho, np.ones(n)])
    direct = swing(padded) + sum(
        absolute[n + m] * padded[n - m : n - m + W] for m in range(-n, n + 1)
    )
    with np.errstate(divide="ignore"):
        through = (v + gain * spill + rest + inner + outer) / low
    assert floats(front.kappa)[-W:] == pytest.approx(np.minimum(direct, through), rel=2e-3)
    behind = (gain * norms[0] + entering * (1 + drift) + outer) / (alpha * (1 - drift))
    assert floats(front.outer_kappa) == pytest.approx(
        [behind, nK * max(1, rho[-n:].max())], rel=1e-4
    )


@pytest.mark.parametrize(
    "pair",
    ["overshoot", *(pytest.param(n, marks=pytest.mark.slow) for n in PROVED if n != "overshoot")],
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
    middles = window & (np.arange(len(x)) % k == k // 2)
    u = np.where(x < -front.left, 1.0, 0.0)
    inside = (x > -front.left) & (x < known.M)
    u[inside] = known.u(x[inside])
    stiffness = known.a(u)
    sources = np.diag(window.astype(float))
    R = stiffness[middles][:, None] * (K @ sources)[middles]
    spread = np.kron(np.eye(window.sum() // k), np.ones((k, 1)))
    f = sources.copy()
    f[window] += spread @ (known.H @ R)
    left_of = x < -known.b
    s = np.where((left_of & (x > -known.b - 1))[:, None], known.alpha * (K @ f), 0.0)
    offsets = np.subtract.outer(np.arange(len(known.H)), np.arange(len(known.H)))
    whole = integrals(known.K, n)[np.clip(offsets + n, 0, 2 * n)]
    T = np.where(abs(offsets) <= n, whole, 0.0)
    a_mid = stiffness[middles]
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
    difference = abs(gf.evaluate_front(computed, xi) - known.u(xi)).max()
    assert difference < front.error
    assert computed.attrs["error_estimate"] < front.error
    if known.alpha == 2:
        statement = next(line for line in front.statements if "overshoots" in line)
        assert 1 + computed.attrs["overshoot"] > float(statement.split()[3].rstrip(":"))


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
    computed = gf.solve_front(alpha, gamma)
    statement = next(s for s in PROVED["monotone"]["statements"] if "A exp" in s)
    bounds = statement.split("15}, ")[-1].split(", ")[-1].split(" − 1e-6 < A < ")
    low, high = float(bounds[0]), float(bounds[1].split(" +")[0])
    u = gf.evaluate_front(computed, [-12.0])
    assert low < float((1 - u[0]) * np.exp(rate * 12)) < high
    assert float(errors[0].upper()) > 0


@pytest.mark.parametrize(("gamma", "w", "n"), [(0.3, 0.0, 20), (0.3, 1.3, 20), (1.4, 0.7, 15)])
def test_kernels_and_their_norms_by_quadrature(gamma, w, n):
    with balls.in_balls():
        middles, whole, absolute = balls.kernel(flint.arb(gamma), flint.arb(w), n)

    def K(s):
        sign = 1 if s > 0 else -1
        return (1 - abs(s) + gamma * sign) * np.exp(-w * s) * (abs(s) < 1)

    assert floats(middles) == pytest.approx([K((m + 0.5) / n) for m in range(-n, n)], rel=1e-12)
    for m in range(-n, n + 1):
        halves = [((m - 0.5) / n, m / n), (m / n, (m + 0.5) / n)]
        found = sum(integrate.quad(K, *ends)[0] for ends in halves)
        size = sum(integrate.quad(lambda s: abs(K(s)), *ends, limit=200)[0] for ends in halves)
        assert whole[n + m].overlaps(flint.arb(found, 1e-8))
        assert size - 1e-9 <= float(absolute[n + m].upper()) <= size + 2 / n**2
        assert float(whole[n + m].rad()) < 1e-5


@pytest.mark.parametrize("w", [0.0, 0.7, 1.3])
def test_defect_without_an_inverse_is_that_of_the_kernel(w):
    """g = 0: e = −α K_w, and its variation by quadrature."""
    alpha, gamma, n = 1.5, 0.3, 20
    zeros = np.zeros((1, 4 * n), dtype=np.int32)
    with balls.in_balls():
        law = flint.arb(alpha), [flint.arb(gamma)]
        _, bound = balls.inverse_defect(*law, flint.arb(w), n, zeros, -2 * n)

    def K(s):
        return (1 - abs(s) + gamma * np.sign(s)) * np.exp(-w * s)

    middles = abs(K((np.arange(-n, n) + 0.5) / n)).sum() / n
    norm = integrate.quad(lambda s: abs(K(s)), -1, 1, points=(gamma - 1, 0))[0]
    slopes = integrate.quad(lambda s: np.exp(-w * s), -1, 1)[0] + w * norm
    assert float(bound.mid()) == pytest.approx(alpha * (middles + slopes / (2 * n)), rel=2e-3)


@pytest.mark.parametrize(("w", "zeros"), [(1.0, 0), (1.6, 1), (2.5, 3)])
def test_zeros_are_counted(w, zeros):
    with balls.in_balls():
        law = tail_roots.Law(flint.arb(3) / 2, flint.arb(3) / 10)
        tail_roots.require_zeros(law, "zeros", flint.arb(w), zeros)
        for count in {*range(5)} - {zeros}:
            with pytest.raises(balls.NotProvedError):
                tail_roots.require_zeros(law, "zeros", flint.arb(w), count)


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
