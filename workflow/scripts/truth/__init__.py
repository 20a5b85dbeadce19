"""What is true, by programs that share no line with the package that they judge.

They stand here and not in the package, whose numbers they judge, so that a rule and the tests run
the same cases.
"""
