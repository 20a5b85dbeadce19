"""What kernels alone can call, called from tests."""

import time

import numba
import numpy as np

from granular_fronts.model import passes


@numba.njit
def call_map(address, u, result, first, last, parameters, times):
    """Call a row map from compiled code."""
    for _ in range(times):
        passes.call_row_map(address, u, result, first, last, parameters)


def mapped(potential, order, u):
    """A derivative of V(−u) on a row of compressions."""
    result = np.full(u.size, np.nan)
    parameters = passes.row_parameters(potential, order)
    call_map(passes.row_map(potential, order), u, result, 0, u.size - 1, parameters, 1)
    return result


def from_python(subroutine):
    """A function that Python can call in place of a subroutine, which kernels alone can."""

    @numba.njit
    def call(*arguments):
        return subroutine(*arguments)

    return call


def fastest(run, repeats=40):
    """Least processor time of several runs; the first, which may compile, is the longest."""
    times = []
    for _ in range(repeats):
        start = time.process_time()
        run()
        times.append(time.process_time() - start)
    return min(times)
