"""Inequalities between balls, noted with their margins."""

from granular_fronts.proofs.balls import NotProvedError, above


class Inequalities:
    """What is shown of something, in the order in which it is."""

    def __init__(self):
        self.inequalities = []

    def require(self, name, left, right):
        """Note left < right, or stop."""
        if not left < right:
            raise NotProvedError(f"{name}: {left} is not certainly below {right}")
        left, right = above(left), -above(-right)
        self.inequalities.append(
            {"name": name, "left": left, "right": right, "margin": right - left}
        )
