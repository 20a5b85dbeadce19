"""A referee of discrete-element codes: problems with known answers, and how far a run is from them.

`problems` states a small set of motions of Hertz chains, `answers` solves them to many digits,
`lammps_deck` writes them as input of LAMMPS and `words` for any other code.  `results_files` reads
what a code made of them and `assessment` says how far that is off, at which order, what damping it
looks like, and what would help.
"""
