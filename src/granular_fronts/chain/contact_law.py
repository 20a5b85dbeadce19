"""From a law to what the kernels know of it."""

import functools

import numpy as np

from granular_fronts.chain.stage_passes import stage_pass
from granular_fronts.chain.state import LAW, MOST_KINKS, MOST_PARAMETERS
from granular_fronts.errors import InputError
from granular_fronts.model.passes import row_map, row_parameters

SMALL_EXTENSION = 1.0e-3


def compile_law(law):
    """What the kernels know of a law.

    Parameters
    ----------
    law : model.laws.Law

    Returns
    -------
    record
        Of type `state.LAW`.

    Raises
    ------
    InputError
        If the law has more kinks or parameters than the record has room for, or if a user's
        function cannot be compiled or has changed since.
    """
    record = np.zeros(1, LAW)[0]
    ratio, kinks = law.proportional, -np.array(law.kinks[::-1])
    record.single = ratio is not None
    record.gamma = ratio if record.single else 1.0
    record.elastic = row_map(law.elastic, 1)
    record.stage_pass = stage_pass(law.elastic) if record.single else 0
    _fill_parameters(record.elastic_parameters, law.elastic)
    if not record.single:
        record.viscous = row_map(law.viscous, 1)
        _fill_parameters(record.viscous_parameters, law.viscous)
    if kinks.size > MOST_KINKS:
        raise InputError(
            f"The law of {law.elastic.name} and {law.viscous.name} has {kinks.size} kinks, but a "
            f"chain has room for {MOST_KINKS}: declare those alone that its contacts pass."
        )
    record.kink_count = kinks.size
    record.kinks[: kinks.size] = kinks
    record.has_stiff_kinks = any(np.isinf(law.elastic.second(kink)) for kink in law.kinks)
    record.attraction = _acts_in_extension(law)
    return record


def _fill_parameters(room, potential):
    """Write the parameters of the force of a potential."""
    parameters = row_parameters(potential, 1)
    if parameters.size > MOST_PARAMETERS:
        raise InputError(
            f"{potential.name} has {parameters.size} parameters with its factor, but a chain has "
            f"room for {MOST_PARAMETERS}: make some of them constants of its kind."
        )
    room[: parameters.size] = parameters


def _acts_in_extension(law):
    """Whether an extended contact exerts a force."""
    extension = min(SMALL_EXTENSION, 0.5 * law.domain[1])
    return extension > 0.0 and law.elastic.first(extension) != 0.0


@functools.lru_cache(maxsize=256)
def is_at_rest_without_stiffness(law, u):
    """Whether small disturbances of the compression u exert no force to first order."""
    return law.elastic.second(-u) == 0.0 and law.viscous.second(-u) == 0.0
