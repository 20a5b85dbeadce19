"""Other people's solvers on our problems.

One module per package. Each has `METHODS`, from a method's name to a function that solves a problem
once and returns a `runs.Run`. A peer times only its solve, without start-up, compilation or files.
One that is not installed returns a run that says so.
"""
