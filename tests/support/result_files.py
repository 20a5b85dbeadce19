"""Answers to the problems of the referee, and files that a code would write for it."""

import functools

from granular_fronts.referee.answers import solve
from granular_fronts.referee.problems import load_problems

PROBLEMS = load_problems()


@functools.cache
def answer_of(name):
    return solve(PROBLEMS[name])


def write_table(path, result, shift=0.0):
    """A result as a user's table, with positions if `shift` is 1."""
    lines = ["# by the half-step scheme", "t, bead, x, v"]
    for t, state in states(result, shift):
        lines += [f"{t!r}, {bead}, {x!r}, {v!r}" for bead, x, v in state]
    path.write_text("\n".join([*lines, ""]))
    return str(path)


def write_dump(path, result):
    """A result as LAMMPS writes it."""
    lines = []
    for t, state in states(result, shift=1.0):
        lines += ["ITEM: TIME", repr(t), "ITEM: ATOMS id x vx"]
        lines += [f"{bead} {x!r} {v!r}" for bead, x, v in state]
    path.write_text("\n".join([*lines, ""]))


def states(result, shift):
    """Times, and rows of bead, place and velocity."""
    for t, x, v in zip(*(values.tolist() for values in result[2:5]), strict=True):
        yield t, [(n + 1, x[n] + shift * n, v[n]) for n in range(len(x))]
