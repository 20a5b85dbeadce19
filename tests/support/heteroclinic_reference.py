"""The heteroclinic orbit to more than 30 digits, in mpmath; shares no code with the package.

The stable manifold of the origin attracts backwards in s, by a factor of about e^(2p): a start on
v² + μv = p + ½ at a large p, exact for μ = 0, has lost its error 50 units of p further on, sooner
for strong damping.  Steps limited by nothing but what the solution is known to do sum Taylor series
of order 44 in 50 digits.
"""

from bisect import bisect_left

import mpmath as mp

DIGITS = 50
MARGIN = 50


def horner(series, x):
    """Value of a polynomial, constant coefficient first."""
    value = mp.mpf(0)
    for coefficient in reversed(series):
        value = value * x + coefficient
    return value


class Reference:
    """Orbit for one μ, between the s where −ln y = `p_start` and s_stop.

    Parameters
    ----------
    mu : float
    s_stop : float
    p_start : int, optional
    order : int, optional
    longest : float, optional
        Longest product of a step and `rate`.
    """

    def __init__(self, mu, s_stop, p_start=40, order=44, longest=0.2):
        self.mu, self.order, self.steps = mp.mpf(mu), order, []
        p = mp.mpf(p_start + MARGIN / (1 + mu**2 / 100))
        with mp.workdps(DIGITS):
            v = mp.sqrt(p + 0.5 + self.mu**2 / 4) - self.mu / 2
            s, self.half = mp.mpf(0), None
            while self.half is None or s > self.half + s_stop:
                series = self.series(p, v)
                h = -longest / self.rate(p, v)
                self.steps.append((s, series))
                new = horner(series, h)
                if self.half is None and new < mp.log(2):
                    self.half = s + self.solve(series, mp.log(2), h)
                v = horner(self.slope(series), h)
                p, s = new, s + h
        self.ends = [-start for start, _ in self.steps]

    def rate(self, p, v):
        """What limits a step: attraction, and the zeros of y at ±iπ/(2√p) from its minima."""
        poles = mp.sqrt(max(p, 0)) if self.half is not None else 0
        return max(1, abs(2 * v + self.mu) / 20, poles)

    def series(self, p, v):
        """Coefficients of p in powers of s."""
        ps, vs = [p], [v]
        for k in range(self.order):
            square = mp.fdot(vs, vs[::-1])
            vs.append((square + self.mu * vs[k] - ps[k]) / (k + 1))
            ps.append(vs[k] / (k + 1))
        return ps

    @staticmethod
    def slope(series):
        return [k * c for k, c in enumerate(series)][1:]

    def solve(self, series, level, h):
        x = h / 2
        for _ in range(100):
            slope = horner(self.slope(series), x)
            change = (horner(series, x) - level) / slope
            x -= change
            if abs(change) < mp.mpf(10) ** (5 - DIGITS):
                return x
        raise ArithmeticError("Newton's method did not converge.")

    def at(self, s):
        """p and v at one s, to more than 30 digits."""
        with mp.workdps(DIGITS):
            s = mp.mpf(s) + self.half
            start, series = self.steps[bisect_left(self.ends, -s) - 1]
            x = s - start
            return horner(series, x), horner(self.slope(series), x)

    def turning_points(self):
        """s and p of the extrema in the order they are met."""
        found = []
        with mp.workdps(DIGITS):
            for (start, series), (following, later) in zip(
                self.steps[:-1], self.steps[1:], strict=True
            ):
                if series[1] * later[1] < 0:
                    x = self.solve(self.slope(series), 0, following - start)
                    found.append((start + x - self.half, horner(series, x)))
        return found
