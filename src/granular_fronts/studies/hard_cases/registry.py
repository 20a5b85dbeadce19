"""All hard cases by name, and how one is run."""

import time

from granular_fronts.studies.hard_cases import (
    chain_cases,
    contact_cases,
    continuum_cases,
    front_cases,
)

CASES = chain_cases.CASES | contact_cases.CASES | continuum_cases.CASES | front_cases.CASES
"""Name of each case and the function that solves it and returns a `HardCase`."""


def run_case(name):
    """Return a solved case (None if refused), its process time, and the solver's sentence."""
    if name not in CASES:
        raise ValueError(f"{name} is no hard case: choose one of {', '.join(CASES)}.")
    started = time.process_time()
    try:
        case, refusal = CASES[name](), ""
    except ValueError as error:
        case, refusal = None, str(error)
    return case, time.process_time() - started, refusal
