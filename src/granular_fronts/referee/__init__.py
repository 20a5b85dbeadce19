"""A referee of discrete-element codes: problems with known answers, and the errors of a code.

`problems` describes a small set of motions of Hertz chains, and `answers` solves them to many
digits.  `tolerances` measures how far the schemes of codes are off.  `files` writes all as
a folder for each problem, with `decks` for codes (`lammps_deck` for LAMMPS) and words for others.
`results_files` reads the results of a code.  `assessment` gives their error, order and apparent
damping, and says what would help.  `command` makes a test of it, with an exit status.
"""
