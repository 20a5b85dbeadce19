"""Thousands of parameter points from one file: what is asked, how it is cut and put together.

A campaign is a grid, the product of its axes, over the parameters of one kind of problem.  The last
axis listed is the fast one; a *line* is all of the fast axis at one point of the others.

    campaign file → `definition` (checked, axes expanded) → `chunks` (what is missing, cut) → a
        kind's `solve_chunk` for each → `merging` (one file)

The file is checked before any job, and the workflow cuts the campaign when it starts.

Identity.  A chunk is named after its content: kind, tolerance, what is recorded, and its points,
nothing else.  The chunks already solved are laid over the grid; only points under none of them
are cut into new chunks.  So an interrupted campaign goes on where it stood, a new
value on any axis costs only the points it adds, another tolerance or another record starts afresh,
and returning to an old value finds the old chunks.  Values of an axis are rounded to twelve digits,
so that a refined axis meets the values of the coarser one to the last bit.

This package imports numpy only where it cuts, solves or merges: a campaign is checked without it.
"""
