"""The bounds of the checker, computed again by other means: quadrature, dense matrices, doubles."""

# ruff: noqa: N802

from fractions import Fraction

import numpy as np
import pytest
from certificates import (
    PROVED,
    Mesh,
    enclosed,
    floats,
    load,
    middles,
    on_cells,
    quadrature,
)
from flint import arb, arb_poly
from scipy import integrate, optimize

import granular_fronts as gf
from granular_fronts.proofs import balls
from granular_fronts.proofs.certificate import describe
from granular_fronts.proofs.checker import Front
from granular_fronts.proofs.dashpots.certificate import describe as describe_dashpots
from granular_fronts.proofs.dashpots.checker import DashpotFront
from granular_fronts.proofs.dashpots.row_norms import bound_inverse


class Doubles:
    """A certificate in doubles, with functions of ξ instead of polynomials on cells."""

    def __init__(self, data):
        self.data = data
        self.alpha = data["alpha"][2] / data["alpha"][3]
        self.gamma = sum(data["gamma"][k] / data["gamma"][k + 1] for k in (0, 2)) / 2
        self.sizes = dict(zip(self.SIZES, data["sizes"].tolist(), strict=True))
        self.n, self.ng = self.sizes["n"], self.sizes["n"] * self.sizes["fine"]
        correction = data["correction"].astype(int)
        self.H = np.eye(len(correction)) + np.cumsum(np.cumsum(correction, axis=1), axis=0) / 2**16

    def inverse(self, name):
        return np.cumsum(np.cumsum(self.data[name][0])) / 2**20

    def a(self, u):
        return self.alpha * np.maximum(u, 0) ** (self.alpha - 1)

    def on_cells(self, name, xi):
        rows = self.data[name]
        xi = np.asarray(xi, dtype=float)
        return on_cells(rows.reshape(-1, rows.shape[-1]), self.sizes["behind"], self.n, xi)

    def on_a_finer_mesh(self, front):
        """Places away from the ends, 1 − L A, and two matrices whose rows ρ and κ bound."""
        n, parts, b, M, p = front.n, 3, self.b, self.M, self.sizes["p"]
        mesh = Mesh(n, parts, b + p + 2, M + 2 + self.sizes.get("q_ahead", 0))
        x, behind, ahead = mesh.x, mesh.x < -b, mesh.x > M
        window, a = ~(behind | ahead), self.a(self.u(mesh.x))
        centres = window & (np.arange(len(x)) % parts == parts // 2)
        spread, a_of_cells = np.kron(np.eye(centres.sum()), np.ones((parts, 1))), np.zeros(len(x))
        a_of_cells[window] = spread @ a[centres]
        T, T_h, sent_behind, weigh = self.operators(mesh, a, a_of_cells)
        R, f = T_h[centres] * window, np.diag(window.astype(float))
        v = spread @ (self.H @ R)
        f[window] += v
        d = R - self.H @ R + T_h[centres][:, window] @ v
        d[n:] = 0.0
        sources = np.diag(behind.astype(float)) + behind[:, None] * (sent_behind @ f)
        sources[window] += spread @ d
        A = mesh.inverse(self.g, p, self.ng) @ sources + f
        A += self.ahead(mesh, np.diag(ahead.astype(float)) + ahead[:, None] * (T @ f))
        safe = (x > -b - 3) & (x < M + 1)
        return x[safe], (np.eye(len(x)) - A + T @ A)[safe], A[safe], (weigh @ A)[safe]


class Proportional(Doubles):
    """β = α."""

    SIZES = ("behind", "ahead", "n", "p", "q", "c", "fine")
    describe, beta, tightness = staticmethod(describe), None, 0.9

    def __init__(self, data):
        super().__init__(data)
        self.b, self.M = self.sizes["c"] + self.sizes["q"] + 2, self.sizes["ahead"] + 1
        self.g = self.inverse("inverse")

    def P(self, xi):
        return self.on_cells("profile", xi)

    def K(self, s):
        return np.where(abs(s) < 1, 1 - abs(s) + self.gamma * np.sign(s), 0.0)

    def u(self, xi):
        """K*P̄ by quadrature."""
        return np.array([self.integral(x) for x in np.atleast_1d(xi)])

    def integral(self, x):
        return quadrature(lambda eta: self.K(x - eta) * self.P(eta), x, self.n)

    def residuals(self, front):
        """|P̄ − ū₊^α| on some cells, and its bounds there."""
        found, bounds, t = [], [], np.linspace(-0.999, 0.999, 5)
        for j in range(0, len(front.u), 9):
            xi = (j + 0.5 + t / 2) / front.n - front.left
            found.append(abs(self.P(xi) - np.maximum(self.u(xi), 0) ** self.alpha).max())
            bounds.append(float(front.residual(j).upper()))
        return np.array(found), np.array(bounds)

    def operators(self, mesh, a, _):
        """ā K*; as at the middles of the cells; what the window sends behind; K*."""
        K = mesh.kernel(self.K)
        return a[:, None] * K, a[:, None] * K, self.alpha * K, K

    def sources(self, _, a):
        """The bounds of the sources of the matrix."""
        return (1 + self.gamma**2) * a

    def ahead(self, _, sources):
        return sources * np.eye(len(sources))


class Dashpots(Doubles):
    """β = 1."""

    SIZES = ("behind", "ahead", "n", "fine", "p", "q", "c", "M", "p_ahead", "q_ahead")
    describe, beta, tightness = staticmethod(describe_dashpots), 1.0, 0.1

    def __init__(self, data):
        super().__init__(data)
        self.b, self.M = self.sizes["c"] + self.sizes["q"] + 1, self.sizes["M"]
        self.g, self.g_ahead = self.inverse("inverse_behind"), self.inverse("inverse_ahead")

    def u(self, xi):
        return self.on_cells("strain", xi)

    def residuals(self, front):
        """F(ū) by quadrature of the profile equation at some places, and its bound."""

        def defect(xi):
            def flux(eta):
                u, s = self.u(eta), xi - eta
                return (1 - abs(s)) * np.maximum(u, 0) ** self.alpha + self.gamma * np.sign(s) * u

            return abs(self.u(xi) - quadrature(flux, xi, self.n))

        shifts = (0, 0.47 / self.n, -0.47 / self.n)
        found = np.array([defect(x + shift) for x in middles(front)[::5] for shift in shifts])
        return found, np.full(found.size, self.Y0)

    def operators(self, mesh, a, a_of_cells):
        jump, tent = mesh.kernel(np.sign), mesh.kernel(lambda s: 1 - abs(s))
        T, T_h = (self.gamma * jump + tent * f for f in (a, a_of_cells))
        return T, T_h, T, np.eye(len(a))

    def sources(self, mesh, a):
        return 2 * self.gamma + mesh.kernel(lambda s: 1 - abs(s)) @ a

    def ahead(self, mesh, sources):
        return mesh.inverse(self.g_ahead, self.sizes["p_ahead"], self.ng) @ sources


by_certificate = pytest.mark.parametrize("pair", PROVED, indirect=True)


@pytest.fixture
def pair(request):
    """A front as the checker encloses it, in balls, and as this module sees its certificate."""
    with balls.in_balls():
        law = Dashpots if request.param == "dashpots" else Proportional
        known = law(load(request.param))
        known.Y0 = PROVED[request.param]["inequalities"]["Y0 < (1 − Z1 − Z2(r)) r"][0]
        yield enclosed(request.param), known


@by_certificate
def test_strain_is_that_of_the_certificate_and_in_its_ranges(pair):
    front, known = pair
    some = np.arange(3, len(front.u), 7)
    assert floats(front.u_mid)[some] == pytest.approx(known.u(middles(front)[some]), abs=2e-13)
    edges = [float(front.u[k](arb("0.999")).mid()) for k in some]
    at = (some + 0.9995) / front.n - front.left
    assert edges == pytest.approx(known.u(at), abs=1e-13)
    for j in some:
        u = known.u((j + np.linspace(0.01, 0.99, 5)) / front.n - front.left)
        assert float(front.u_low[j]) - 1e-13 <= u.min()
        assert u.max() <= float(front.u_high[j]) + 1e-13


@by_certificate
def test_residual_is_bounded_and_not_much_too_large(pair):
    front, known = pair
    found, bounds = known.residuals(front)
    assert (found <= bounds + 1e-14).all()
    assert max(found / bounds) > known.tightness
    assert bounds.max() <= known.Y0 * (1 + 1e-12)


@pytest.mark.parametrize("name", ["monotone", "dashpots"])
def test_force_of_strains_of_which_no_polynomial_is_made_is_not_forgotten(name):
    with balls.in_balls():
        front = enclosed(name, P=[arb_poly([0])] * len(enclosed(name).u))
        small = [j for j, low in enumerate(front.u_low) if not low > 1e-11]
        assert len(small) > 5
        for j in small:
            bound = front.force(j)[1] if name == "dashpots" else front.residual(j)
            for place in (-1, 0.3, 1):
                assert max(float(front.u[j](place)), 0.0) ** 1.5 <= balls.above(bound)


@pytest.fixture(scope="module", params=[Proportional, Dashpots])
def coarse(request):
    """The certificate of wide cells, from which nothing is proved, and its law."""
    law = request.param
    alpha, gamma = Fraction(3 if law is Dashpots else 4, 2), Fraction(3, 10)
    front = gf.solve_front(float(alpha), float(gamma), law.beta)
    return law.describe(front, (alpha, alpha), (gamma, gamma), 10, 40, 1e-3), law


def bounded(data):
    """A front with the bounds of its inverse."""
    with balls.in_balls():
        if "strain" not in data:
            front = Front(data)
            front.bound_inverse()
        else:
            front = DashpotFront(data)
            front.Z1, front.rho, *front.outer_kappa = bound_inverse(front)
            front.kappa, front.rho_behind = front.rho, front.outer_kappa[0]
    return front


def test_inverse_is_one(coarse):
    """On a mesh three times as fine: near the bounds of A and K*A, a part of that of 1 − L A.

    From below: the supremum over y that are constant on small cells, at middles of cells.  A is
    exact there but for the middle rule in the convolution with g of what is not constant on cells.
    """
    data, law = coarse
    front, known = bounded(data), law(data)
    x, defect, *inverses = known.on_a_finer_mesh(front)
    Z1, window = float(front.Z1.mid()), (x > -known.b) & (x < known.M)
    assert 0.18 * Z1 < abs(defect).sum(axis=1).max() < Z1
    first = (front.left - known.b) * front.n
    bounds = (front.rho, 0.9999, 0.89), (front.kappa, 0.86, 0.59)
    for rows, (bound, near, typical) in zip(inverses, bounds, strict=True):
        norms, own = abs(rows).sum(axis=1), floats(bound)[first : first + window.sum() // 3]
        shares = norms[window] / np.repeat(own, 3)
        assert near < shares.max() < 1 + 1e-12
        assert np.median(shares) > typical
    for side, bound in zip((x < -known.b, x > known.M), front.outer_kappa, strict=True):
        assert norms[side].max() <= bound


@pytest.mark.parametrize(("name", "law"), [("monotone", Proportional), ("dashpots", Dashpots)])
def test_gain_counts_what_a_wrong_matrix_leaves_undone_on_the_first_bead(name, law):
    """More than the window sends behind: A is bounded there by that, from dense matrices."""
    data = load(name)
    wrong, n = data["correction"].copy(), data["sizes"][2]
    alternating = 20_000 * (-1) ** np.arange(4 * n + 1)
    alternating[[0, -1]] = 10_000
    wrong[0, : 4 * n + 1] += alternating
    wrong[n, : 4 * n + 1] -= alternating
    data = data | {"correction": wrong}
    front, known = bounded(data), law(data)
    mesh = Mesh(n, 1, known.b, known.M)
    a = known.a(known.u(mesh.x))
    _, T_h, *_ = known.operators(mesh, a, a)
    undone = abs(np.eye(len(a)) - known.H + T_h @ known.H) @ known.sources(mesh, a)
    gain = undone[:n].max() + (law is Proportional)
    norm = abs(known.g).sum() / known.ng
    assert float(front.rho_behind) == pytest.approx(gain * (1 + norm), rel=1e-6)


@by_certificate
def test_computed_front_lies_in_the_enclosure(pair):
    """And overshoots as stated, is 1/2 next to 0, and falls from where it is said to."""
    front, known = pair
    computed = gf.solve_front(known.alpha, known.gamma, known.beta)
    xi = middles(front)
    assert abs(gf.evaluate_front(computed, xi) - floats(front.u_mid)).max() < front.error
    assert computed.attrs["error_estimate"] < front.error
    assert 0 < float(front.shift) < 1.3 * front.error
    assert abs(gf.evaluate_front(computed, 0.0) - 0.5) < 1e-12
    falls = float(arb(front.fall))
    assert (np.diff(gf.evaluate_front(computed, np.linspace(falls, 2, 300))) < 0).all()
    top = 1 + computed.attrs["overshoot"]
    highest = max((u[0] - error).lower() for u, error in zip(front.u, front.u_error, strict=True))
    assert top - 2e-5 < float(highest) < top


def test_tail_ahead_of_dashpots_is_between_two_exponentials():
    front, numbers = enclosed("dashpots"), PROVED["dashpots"]["numbers"]
    computed, gamma = gf.solve_front(1.5, 0.3, beta=1.0), 0.3
    t = np.linspace(0, 5, 51)
    u = gf.evaluate_front(computed, numbers["tail_start"] + t)
    _, slow, fast = front.data["weights"]
    assert (numbers["tail_low"] * np.exp(-fast * t) < u).all()
    assert (u < numbers["tail_high"] * np.exp(-slow * t)).all()
    mu = optimize.brentq(lambda rate: 2 * gamma * (np.cosh(rate) - 1) - rate, 1, 5)
    assert slow < mu < fast
    assert u[-11] / u[-1] == pytest.approx(np.exp(mu), rel=1e-3)


def test_slowest_mode_is_that_of_the_computed_front():
    numbers, computed = PROVED["monotone"]["numbers"], gf.solve_front(1.5, 0.3)
    rate = optimize.brentq(
        lambda x: 1 - 1.5 * (1 - 0.3 * x) * (2 * np.cosh(x) - 2) / x**2, 1.3, 1.6, xtol=1e-15
    )
    assert numbers["rate_low"] - 1e-14 < rate < numbers["rate_high"] + 1e-14
    amplitude = (1 - gf.evaluate_front(computed, -12.0)) * np.exp(rate * 12)
    low, high = (numbers[f"amplitude_{end}"] for end in ("low", "high"))
    assert low < amplitude < high < 1.4 * low
    assert amplitude == pytest.approx((low + high) / 2, rel=1e-3)


@pytest.mark.parametrize(("gamma", "w", "n"), [(0.3, 1.3, 20), (1.4, 0.0, 15)])
def test_kernels_and_their_norms_by_quadrature(gamma, w, n):
    with balls.in_balls():
        centres, whole, absolute = balls.kernel(arb(gamma), arb(w), n)

    def K(s):
        sign = 1 if s > 0 else -1
        return (1 - abs(s) + gamma * sign) * np.exp(-w * s) * (abs(s) < 1)

    assert floats(centres) == pytest.approx([K((m + 0.5) / n) for m in range(-n, n)], rel=1e-12)
    for m in range(-n, n + 1):
        halves = [((m - 0.5) / n, m / n), (m / n, (m + 0.5) / n)]
        found = sum(integrate.quad(K, *ends)[0] for ends in halves)
        size = sum(integrate.quad(lambda s: abs(K(s)), *ends, limit=200)[0] for ends in halves)
        assert whole[n + m].overlaps(arb(found, 1e-8))
        assert size - 1e-9 <= float(absolute[n + m].upper()) <= size + 2 / n**2
        assert float(whole[n + m].rad()) < 1e-5


def test_defect_without_an_inverse_is_that_of_the_kernel():
    """g = 0: e = −α K_w, and its variation by quadrature; with dashpots −γ k, whose norm is 2γ."""
    alpha, gamma, w, n = 1.5, 0.3, 0.7, 20
    zeros = np.zeros((1, 4 * n), dtype=np.int32)
    with balls.in_balls():
        _, bound = balls.inverse_defect(arb(alpha), [arb(gamma)], arb(w), n, zeros, -2 * n)
        sign = [arb(gamma) * f for f in balls.slope_kernel(arb(0), n)]
        _, jump = balls.defect([sign], (arb(0), arb(4 * gamma)), n, zeros, -2 * n)

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


def test_matrix_of_the_window_is_exact_or_refused():
    differences = np.zeros((3, 3), dtype=np.int16)
    differences[0, 0], differences[1, 2] = 32767, -32768
    H, correction = balls.unit_plus(differences)
    units = np.cumsum(np.cumsum(differences.astype(object), axis=0), axis=1)
    np.testing.assert_array_equal(correction.astype(object) * 2**16, units)
    np.testing.assert_array_equal(H - np.eye(3), correction)
    for units in (2**53, -(2**53)):
        with pytest.raises(balls.NotProvedError, match="doubles do not hold"):
            balls.unit_plus(np.full((1, 1), units, dtype=np.int64))


def test_bounds_contain_all_values_and_are_doubles_rounded_outwards():
    half = arb("1.5")
    assert balls.power(arb(-1), half) == 0
    straddling = balls.power(arb(0, 0.25), half)
    assert straddling.contains(arb(0))
    assert straddling.contains(arb("0.125"))
    low, high = balls.bounds(arb_poly([1, 2, -3]))
    values = [1 + 2 * t - 3 * t * t for t in np.linspace(-1, 1, 101)]
    assert low <= min(values)
    assert max(values) <= high
    for exact in (0, 1, -3, 0.1):
        assert balls.above(arb(exact)) == exact
    with balls.in_balls():
        for sign in (1, -1):
            assert arb(balls.above(sign * arb(1) / 3)) > sign * arb(1) / 3
            assert balls.above(sign * arb(1) / 3) - sign / 3 < 1e-15


def test_an_inequality_is_noted_with_its_sides_outwards_and_only_if_it_is_certain():
    noted = balls.Inequalities()
    with balls.in_balls():
        third = arb(1) / 3
        noted.require("thirds", third, 2 * third)
        assert arb(noted.inequalities[0]["left"]) > third
        assert arb(noted.inequalities[0]["right"]) < 2 * third
    for left, right in ((arb(1), arb(1)), (arb(0, 1), arb(0.5)), (arb("nan"), arb(1))):
        with pytest.raises(balls.NotProvedError, match="not certainly below"):
            noted.require("none", left, right)
    assert len(noted.inequalities) == 1
    for value in (arb("nan"), arb("inf"), -arb("inf")):
        for values in ([value], [value, arb(1)], [arb(1), value]):
            with pytest.raises(balls.NotProvedError, match="not finite"):
                balls.largest(values)
    assert balls.largest([arb(2), arb(3), arb(1)]) == 3


@pytest.mark.parametrize(("name", "beta"), [("monotone", None), ("dashpots", 1)])
def test_certificates_are_made_as_those_kept(name, beta, tmp_path):
    record = gf.prove_front("3/2", "3/10", tmp_path / "made.npz", cells=16, fine=16, beta=beta)
    assert record["proved"], record["reason"]
    made, known = {one["name"]: one["left"] for one in record["inequalities"]}, PROVED[name]
    assert made.keys() == known["inequalities"].keys()
    assert made["Z1 < 1"] == pytest.approx(known["inequalities"]["Z1 < 1"][0], rel=1e-3)
    assert record["numbers"].keys() == known["numbers"].keys()
    assert record["error"] == pytest.approx(known["error"], rel=0.5)
