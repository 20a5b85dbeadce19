"""Subroutines of kernels, called from tests."""

import numba


def from_python(subroutine):
    """A function that Python can call in place of a subroutine, which kernels alone can."""

    @numba.njit
    def call(*arguments):
        return subroutine(*arguments)

    return call
