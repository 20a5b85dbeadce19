"""Problems at the edge of what the solvers can do, each with an answer known some other way."""
