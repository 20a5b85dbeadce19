"""Campaigns of thousands of parameter points: one file, cut into jobs and merged.

A campaign is a grid, the product of its axes, over the parameters of one kind of problem.  The last
axis listed is the fast one; a *line* is all of the fast axis at one point of the others.

    campaign file → `definition` (checked, axes expanded) → `chunks` (what is missing, cut) → a
        kind's `solve_chunk` for each → `merging` (one file)

The file is checked before any job, and the workflow cuts the campaign when it starts.

Identity.  A chunk is named after its content: kind, tolerance, what is recorded, and its points.
Points of chunks that are already solved are not solved again; the others are cut into new chunks.
So an interrupted campaign goes on, and a new value on an axis costs only the points that it adds.
Another tolerance or record starts afresh, and an old value finds its old chunks.  Values of an axis
are rounded to twelve digits.  So a refined axis meets the values of the coarser one to the last
bit.
"""
