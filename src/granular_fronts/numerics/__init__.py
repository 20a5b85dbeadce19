"""Numerical methods that know no chain: compilation, vector functions, quadrature, bands."""
