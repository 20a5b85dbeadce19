"""Problems for the study of speed against error.

One module per family of the paper's problems. Each has `make_problem`, which takes an entry of the
configuration and the stored references.
"""
