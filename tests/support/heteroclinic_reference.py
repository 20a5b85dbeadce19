"""The heteroclinic orbit to more than 20 digits, in mpmath; shares no code with the package.

The stable manifold of the origin attracts backwards in s, by a factor of about e^(2p): a start on
v² + μv = p + ½ at a large p, exact for μ = 0, has lost its error 50 units of p further on, sooner
for strong damping.  Steps limited by nothing but what the solution is known to do sum Taylor series
of order 30 in 35 digits.
"""

from bisect import bisect_left

import mpmath as mp

DIGITS, ORDER, MARGIN = 35, 30, 50
LONGEST = 0.2  # product of a step and what limits it


def slope(series):
    """Coefficients of a derivative, constant first."""
    return [k * c for k, c in enumerate(series)][1:]


def value(series, x):
    return mp.polyval(series[::-1], x)


def root(series, near):
    """The zero of a polynomial next to a place."""
    return mp.findroot(lambda x: value(series, x), near)


class Reference:
    """Orbit for one μ, between the s where −ln y = `p_start` and s_stop."""

    def __init__(self, mu, s_stop, p_start=40):
        self.mu, self.steps, self.half = mp.mpf(mu), [], None
        p = mp.mpf(p_start + MARGIN / (1 + mu**2 / 100))
        with mp.workdps(DIGITS):
            v, s = mp.sqrt(p + 0.5 + self.mu**2 / 4) - self.mu / 2, mp.mpf(0)
            while self.half is None or s > self.half + s_stop:
                series, h = self.series(p, v), -LONGEST / self.rate(p, v)
                self.steps.append((s, series))
                p, v, before = value(series, h), value(slope(series), h), s
                s += h
                if self.half is None and p < mp.log(2):
                    self.half = before + root([series[0] - mp.log(2), *series[1:]], h / 2)
        self.ends = [-start for start, _ in self.steps]

    def rate(self, p, v):
        """What limits a step: attraction, and the zeros of y at ±iπ/(2√p) from its minima."""
        poles = mp.sqrt(max(p, 0)) if self.half is not None else 0
        return max(1, abs(2 * v + self.mu) / 20, poles)

    def series(self, p, v):
        """Coefficients of p in powers of s."""
        ps, vs = [p], [v]
        for k in range(ORDER):
            square = mp.fdot(vs, vs[::-1])
            vs.append((square + self.mu * vs[k] - ps[k]) / (k + 1))
            ps.append(vs[k] / (k + 1))
        return ps

    def at(self, s):
        """p and v at one s."""
        with mp.workdps(DIGITS):
            s = mp.mpf(s) + self.half
            start, series = self.steps[bisect_left(self.ends, -s) - 1]
            return value(series, s - start), value(slope(series), s - start)

    def turning_points(self):
        """s and p of the extrema in the order they are met."""
        with mp.workdps(DIGITS):
            for (start, series), (end, later) in zip(self.steps, self.steps[1:], strict=False):
                if series[1] * later[1] < 0:
                    x = root(slope(series), (end - start) / 2)
                    yield start + x - self.half, value(series, x)
