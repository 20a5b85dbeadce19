"""The ring of James (2021), section 4.3, α = 3/2, up to a stored long-double state.

The start is stored with that state, so that every method has the same one to the last digit.
"""

from peers.chain_system import ChainSystem
from problems import chain
from problems.problem import Problem, read_reference, stored_state


def make_problem(problem, states):
    """Return the ring of one entry of ``precision.ring``, up to its stored state."""
    end = problem["end_time"]
    state = stored_state(states, "ring", t=end)
    contacts, velocities = (states[f"{name}_start"].values for name in chain.FIELDS)
    system = ChainSystem(float(states["gamma"]), end, contacts, velocities, ring=True)
    scene = chain.scene_of_system(
        system,
        boundary={"kind": "ring"},
        start={"kind": "given", "relative_displacement": contacts, "velocity": velocities},
    )
    reference = read_reference(state, chain.FIELDS)
    return Problem(chain.OURS, reference, chain.methods_for(scene, system))
