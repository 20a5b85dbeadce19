"""The bounds of the checker, computed again by other means: quadrature, dense matrices, doubles."""

# ruff: noqa: N802

import numpy as np
import pytest
from certificates import (
    PROVED,
    Mesh,
    enclosed,
    floats,
    inverse_defect,
    load,
    middles,
    on_cells,
    quadrature,
)
from flint import arb, arb_poly
from scipy import integrate, optimize

import granular_fronts as gf
from granular_fronts.proofs import balls
from granular_fronts.proofs.checker import Front
from granular_fronts.proofs.dashpots.checker import DashpotFront
from granular_fronts.proofs.dashpots.row_norms import bound_inverse


class Doubles:
    """A certificate in doubles, with functions of ξ instead of polynomials on cells."""

    def __init__(self, name, **changes):
        self.data = data = load(name) | changes
        self.alpha = data["alpha"][2] / data["alpha"][3]
        self.gamma = sum(data["gamma"][k] / data["gamma"][k + 1] for k in (0, 2)) / 2
        self.sizes = dict(zip(self.SIZES, data["sizes"].tolist(), strict=True))
        self.n, self.ng = self.sizes["n"], self.sizes["n"] * self.sizes["fine"]
        correction = data["correction"].astype(int)
        self.H = np.eye(len(correction)) + np.cumsum(np.cumsum(correction, axis=1), axis=0) / 2**16
        self.Y0 = PROVED[name]["inequalities"]["Y0 < (1 − Z1 − Z2(r)) r"][0]

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
    beta, tightness, least_defect = None, 0.9, 0.15

    def __init__(self, name, **changes):
        super().__init__(name, **changes)
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
        found, bounds, t = [], [], np.linspace(-0.999, 0.999, 9)
        for j in range(0, len(front.u), 5):
            xi = (j + 0.5 + t / 2) / front.n - front.left
            found.append(abs(self.P(xi) - np.maximum(self.u(xi), 0) ** self.alpha).max())
            bounds.append(float(front.residual(j).upper()))
        return np.array(found), np.array(bounds)

    def norms(self, front):
        """Z₁, ρ and κ as in `right_inverse`: those of the checker, these, and how near they are."""
        n, h, alpha, gamma, M, b = front.n, 1 / front.n, self.alpha, self.gamma, self.M, self.b
        points = 0, gamma - 1, 1 - gamma
        nK, _ = integrate.quad(lambda s: abs(float(self.K(s))), -1, 1, points=points)
        low, mid, high = (self.a(floats(u)) for u in (front.u_low, front.u_mid, front.u_high))
        far = (front.left - self.sizes["c"]) * n
        drift = max(abs(a[:far] / alpha - 1).max() for a in (low, high))
        W = (b + M) * n
        low, mid, high = low[-W:], mid[-W:], high[-W:]

        # ∫ K and ∫ |K| over a cell seen from the middle of another, from 32 points.
        m = np.arange(-n, n + 1)
        K = self.K(m[:, None] * h + np.linspace(-1, 1, 65)[1::2] * h / 2)
        whole, absolute = K.mean(axis=1) * h, abs(K).mean(axis=1) * h
        x = (np.arange(W) + 0.5) * h - b
        apart = np.subtract.outer(np.arange(W), np.arange(W))
        T, T_abs = (
            np.where(abs(apart) <= n, f[np.clip(apart + n, 0, 2 * n)], 0) for f in (whole, absolute)
        )
        rest = abs(np.eye(W) - self.H + mid[:, None] * (T @ self.H)) @ mid * nK
        weighted = self.H * mid
        edges = np.arange(W + 1) * h - b
        v = h * abs(weighted @ self.K(np.subtract.outer(x, edges))).sum(axis=1)
        v += h / 2 * abs(weighted).sum(axis=1)
        w = 1 + v

        def swing(f):
            """What f, a bead longer at both ends, gives by steps of K in a cell."""
            weights = h * h / 2 + h * gamma * (m == 0) + h * gamma / 2 * (abs(m) == n)
            return np.convolve(f, weights, "valid")

        inner = high * swing(np.pad(w, n)) + (high - low) * (T_abs @ w)
        forward = integrate.quad(lambda s: abs(1 - s - gamma), 0, 1, points=(abs(1 - gamma),))[0]
        entering = alpha * max(forward, (gamma**2 + (1 - gamma) ** 2) / 2) * w[:n].max()
        gain = 1 + max(entering, rest[:n].max())
        kernel, jumps = (lambda s: alpha * self.K(s)), 4 * alpha * gamma
        e, norm = inverse_defect(self.g, self.sizes["p"], self.ng, kernel, 2 * alpha, jumps)
        outer = gain * (e + drift * (norm + e)) + nK * high[-n:].max()
        Z1 = outer + max(inner[:n].max(), (inner + rest)[n:].max(), entering * drift)
        yield front.Z1, Z1, 1e-4

        norms = np.append(np.cumsum(abs(self.g)[::-1])[::-1] / self.ng, 0)
        position = np.round((x - h / 2 + b - 1 + self.sizes["p"]) * self.ng).astype(int)
        spill = norms[np.clip(position, 0, len(norms) - 1)]
        rho, behind = w + rest + gain * spill, gain * (1 + norm)
        yield front.rho[-W:], rho, 1e-8
        yield front.rho[:-W], behind, 1e-8
        around = np.concatenate([np.full(n, behind), rho, np.ones(n)])
        direct = swing(around) + np.convolve(around, absolute, "valid")
        with np.errstate(divide="ignore"):
            through = (v + gain * spill + rest + inner + outer) / low
        yield front.kappa[-W:], np.minimum(direct, through), 2e-3
        yield (
            front.outer_kappa[0],
            (gain * norm + entering * (1 + drift) + outer) / (alpha * (1 - drift)),
            1e-4,
        )
        yield front.outer_kappa[1], nK * max(1, rho[-n:].max()), 1e-4

    def operators(self, mesh, a, _):
        """ā K*; as at the middles of the cells; what the window sends behind; K*."""
        K = mesh.kernel(self.K)
        return a[:, None] * K, a[:, None] * K, self.alpha * K, K

    def ahead(self, _, sources):
        return sources * np.eye(len(sources))


class Dashpots(Doubles):
    """β = 1."""

    SIZES = ("behind", "ahead", "n", "fine", "p", "q", "c", "M", "p_ahead", "q_ahead")
    beta, tightness, least_defect = 1.0, 0.1, 0.1

    def __init__(self, name, **changes):
        super().__init__(name, **changes)
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
        found = np.array([defect(x + shift) for x in middles(front)[::3] for shift in shifts])
        return found, np.full(found.size, self.Y0)

    def norms(self, front):
        """Z₁ and ρ as in `right_inverse`: those of the checker, these, and how near they are."""
        sizes, n, h, gamma, H = self.sizes, self.n, 1 / self.n, self.gamma, self.H
        p, p_ahead, M, b = sizes["p"], sizes["p_ahead"], self.M, self.b
        low, mid, high = (self.a(floats(u)) for u in (front.u_low, front.u_mid, front.u_high))
        xi, W = middles(front), len(H)
        drift = max(abs(a[xi < -sizes["c"]] / self.alpha - 1).max() for a in (low, high))
        force_ahead = high[xi > M - p_ahead].max()
        window = (xi > -b) & (xi < M)
        a, low, high = mid[window], low[window], high[window]

        x = xi[window]
        apart = np.round(np.subtract.outer(x, x) * n)
        whole = (abs(apart) < n) + (abs(apart) == n) / 2
        jump = np.sign(apart) * whole * h
        tent = np.maximum(1 - abs(apart) * h, 0) * h
        tent += np.select([apart == 0, abs(apart) == n], [-h * h / 4, h * h / 8])
        T = gamma * jump + tent * a
        rest = abs(np.eye(W) - H + T @ H) @ (2 * gamma + tent @ a)
        s = np.subtract.outer(x, np.append(x - h / 2, M))
        jumps, tents = H @ (np.sign(s) * (abs(s) < 1)) * gamma, H @ np.maximum(1 - abs(s), 0)
        edges = (abs(jumps[:, k : k + W] + a * tents[:, k : k + W]).sum(axis=1) for k in (0, 1))
        v = h / 2 * sum(edges) + h * h / 8 * abs(H) @ (2 * whole @ a)
        w = 1 + v
        inner = gamma * h / 2 * ((2 * (apart == 0) + (abs(apart) == n)) @ w)
        inner += h * h / 2 * (abs(apart) <= n) @ (w * high)
        inner += tent @ (w * np.maximum(high - a, a - low))

        def sign(s):
            return gamma * np.sign(s)

        def both(s):
            return self.alpha * (1 - abs(s)) + sign(s)

        e, norm = inverse_defect(self.g, p, self.ng, both, 2 * self.alpha, 4 * gamma)
        e_ahead, norm_ahead = inverse_defect(self.g_ahead, p_ahead, self.ng, sign, 0, 4 * gamma)
        gain = max(1 + (gamma + high[:n].max() / 2) * w[:n].max(), rest[:n].max())
        gain_ahead = 1 + (gamma + high[-n:].max() / 2) * w[-n:].max()
        Z1 = max(inner[:n].max(), (inner + rest)[n:].max())
        Z1 += gain * (e + self.alpha * drift * (1 + norm))
        Z1 += gain_ahead * (e_ahead + (1 + norm_ahead) * force_ahead)
        yield front.Z1, Z1, 1e-6

        from_left, from_right = x - h / 2 + b - 1, x + h / 2 - M
        places = (np.arange(len(self.g)) + 0.5) / self.ng - p
        behind = np.array([abs(self.g[places > at]).sum() / self.ng for at in from_left])
        places = (np.arange(len(self.g_ahead)) + 0.5) / self.ng - p_ahead
        ahead = np.array([abs(self.g_ahead[places < at]).sum() / self.ng for at in from_right])
        rho = w + gain * behind + gain_ahead * ahead
        rho[:n] += rest[:n]
        yield front.rho[window], rho, 1e-8
        for bound, cells, value in (
            (front.rho_behind, front.rho[xi < -b], gain * (1 + norm)),
            (front.rho_ahead, front.rho[xi > M], gain_ahead * (1 + norm_ahead)),
        ):
            yield np.append(cells, bound), value, 1e-8

    def operators(self, mesh, a, a_of_cells):
        jump, tent = mesh.kernel(np.sign), mesh.kernel(lambda s: 1 - abs(s))
        T, T_h = (self.gamma * jump + tent * f for f in (a, a_of_cells))
        return T, T_h, T, np.eye(len(a))

    def ahead(self, mesh, sources):
        return mesh.inverse(self.g_ahead, self.sizes["p_ahead"], self.ng) @ sources


by_certificate = pytest.mark.parametrize("pair", PROVED, indirect=True)


@pytest.fixture
def pair(request):
    """A front as the checker encloses it, in balls, and as this module sees its certificate."""
    with balls.in_balls():
        law = Dashpots if request.param == "dashpots" else Proportional
        yield enclosed(request.param), law(request.param)


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
        assert len(small) > 10
        for j in small:
            bound = front.force(j)[1] if name == "dashpots" else front.residual(j)
            for place in (-1, 0.3, 1):
                assert max(float(front.u[j](place)), 0.0) ** 1.5 <= balls.above(bound)


@pytest.mark.parametrize("law", [Proportional, Dashpots])
def test_norms_are_those_of_dense_matrices(law):
    """For a wrong matrix, which leaves more undone on the first bead than is sent behind."""
    name = "dashpots" if law is Dashpots else "overshoot"
    data = load(name)
    n, wrong = law(name).n, data["correction"].copy()
    alternating = 20_000 * (-1) ** np.arange(n + 1)
    alternating[[0, n]] = 10_000
    wrong[0, : n + 1] += alternating
    wrong[n, : n + 1] -= alternating
    known = law(name, correction=wrong)
    with balls.in_balls():
        if law is Dashpots:
            front = DashpotFront(data | {"correction": wrong})
            front.Z1, front.rho, front.rho_behind, front.rho_ahead = bound_inverse(front)
        else:
            front = Front(data | {"correction": wrong})
            front.bound_inverse()
        for found, value, near in known.norms(front):
            assert floats(np.atleast_1d(found)) == pytest.approx(value, rel=near)


@pytest.mark.parametrize("pair", ["overshoot", "dashpots"], indirect=True)
def test_inverse_is_one(pair):
    """On a mesh three times as fine: near the bounds of A and K*A, a part of that of 1 − L A.

    From below: the supremum over y that are constant on small cells, at middles of cells.  A is
    exact there but for the middle rule in the convolution with g of what is not constant on cells.
    """
    front, known = pair
    x, defect, *inverses = known.on_a_finer_mesh(front)
    Z1, window = float(front.Z1.mid()), (x > -known.b) & (x < known.M)
    assert known.least_defect * Z1 < abs(defect).sum(axis=1).max() < Z1
    first = (front.left - known.b) * front.n
    bounds = (front.rho, 0.9999, 0.9), (front.kappa, 0.9, 0.7)
    for rows, (bound, near, typical) in zip(inverses, bounds, strict=True):
        norms, own = abs(rows).sum(axis=1), floats(bound)[first : first + window.sum() // 3]
        shares = norms[window] / np.repeat(own, 3)
        assert near < shares.max() < 1 + 1e-12
        assert np.median(shares) > typical
    for side, bound in zip((x < -known.b, x > known.M), front.outer_kappa, strict=True):
        assert norms[side].max() <= bound


@by_certificate
def test_computed_front_lies_in_the_enclosure(pair):
    """And overshoots as stated, is 1/2 next to 0, and falls from where it is said to."""
    front, known = pair
    computed = gf.solve_front(known.alpha, known.gamma, known.beta)
    xi = middles(front)
    assert abs(gf.evaluate_front(computed, xi) - floats(front.u_mid)).max() < front.error
    assert computed.attrs["error_estimate"] < front.error
    assert 0 < float(front.shift) < 1.5e-9
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
    assert low < amplitude < high < 1.05 * low


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


@pytest.mark.parametrize(
    ("name", "law"),
    [
        ("overshoot", {"alpha": 2, "gamma": ("3/10", "300000001/1000000000")}),
        ("dashpots", {"alpha": "3/2", "gamma": "3/10", "beta": 1}),
    ],
)
def test_certificates_are_made_as_those_kept(name, law, tmp_path):
    record = gf.prove_front(**law, path=tmp_path / "made.npz")
    assert record["proved"], record["reason"]
    made = {one["name"]: one["left"] for one in record["inequalities"]}
    assert made.keys() == PROVED[name]["inequalities"].keys()
    assert made["Z1 < 1"] == pytest.approx(PROVED[name]["inequalities"]["Z1 < 1"][0], rel=0.05)
    assert record["error"] == pytest.approx(PROVED[name]["error"], rel=0.5)
