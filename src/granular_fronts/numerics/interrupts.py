"""Ctrl-C inside compiled loops.

While compiled code runs, Python only notes that an interrupt has come.  A long loop asks
`interrupted` in each turn and leaves when it is true, with an unfinished result.  The interrupt is
handed back to Python, which raises KeyboardInterrupt, or does what the user has chosen, before the
result is used.
"""

from numba import types

from granular_fronts.numerics.compiled import subroutine

# Both belong to the stable interface of Python; asking clears the note, so it is set again.
_interrupt_has_come = types.ExternalFunction("PyOS_InterruptOccurred", types.intc())
_set_interrupt = types.ExternalFunction("PyErr_SetInterrupt", types.void())


@subroutine
def interrupted():
    """Return whether Ctrl-C waits to be answered."""
    if _interrupt_has_come() == 0:
        return False
    _set_interrupt()
    return True
