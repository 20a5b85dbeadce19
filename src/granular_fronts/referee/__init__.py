"""A referee of discrete-element codes: problems with known answers, and the errors of a code.

`problems` describes a small set of motions of Hertz chains, and `answers` solves them to many
digits.  `files` writes both, as input of LAMMPS (`lammps_deck`) and in words for any other code.
`results_files` reads the results of a code.  `assessment` gives their error, order and apparent
damping, and says what would help.
"""
