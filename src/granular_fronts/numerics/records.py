"""Records that kernels change: fields by name, in Python as in compiled code.

A record is passed to a kernel by its address, so that the kernel changes it in place.  Unlike a
tuple of arrays it costs nothing to pass.
"""

import numpy as np


def record_type(*fields):
    """Return a type of records from pairs of name and type, or of name, type and shape."""
    return np.dtype((np.record, np.dtype(list(fields), align=True)))


def make_record(kind, **values):
    """Return a record of a type, its fields zero where no value is given."""
    record = np.zeros(1, kind)[0]
    for name, value in values.items():
        record[name] = value
    return record
