r"""Points of any motion of a chain: a scene of which a campaign varies the numbers.

The file gives a `scene` as the configuration has it.  An axis names one of its numbers, for example
``start.velocity``, or ``beads.mass.cell.2`` for the second entry of a list.  The grid calls this
one by a name that data can have, ``beads_mass_cell_2``.

The scene has one sensor with contacts.  At the last of them a point records the largest force, and
what momentum and energy have passed when the sensor stops.  The time of flight is that from its
first contact to its last.  Every point is solved twice, which gives the errors.
"""

import functools

from granular_fronts.accuracy import Estimate, recorded
from granular_fronts.campaign.kinds import KINDS
from granular_fronts.campaign.numbers import with_numbers
from granular_fronts.campaign.points import single_points, solve_groups
from granular_fronts.chain.experiment import pulses, time_of_flight
from granular_fronts.chain.simulate import ERROR_METHOD, simulate_chain


def solve_chunk(points, settings, activity):
    """Solve motions one after the other, each with its errors; a profile is in beads."""
    beads = KINDS["motion"].profile_points(settings["profile"])
    sizes = dict.fromkeys(settings["scalars"], ()) | (
        {} if beads is None else {"velocity": (beads.size,)}
    )
    groups = (
        (index, functools.partial(_measure, with_numbers(settings["scene"], point), beads))
        for index, point in single_points(points)
    )
    shape = next(iter(points.values())).shape
    return solve_groups(shape, sizes, groups, ERROR_METHOD, activity)


def _measure(scene, beads):
    """Return the values and errors of one motion."""
    scene["record"]["snapshots"] = [scene["end_time"]]
    motion = simulate_chain(scene, "of the point")
    [(sensor, where)] = scene["record"]["sensors"].items()
    first, last = min(where["contacts"]), max(where["contacts"])
    force, velocity = motion[f"contact_force_{sensor}"], motion["velocity"].isel(t=0)
    at_last = {f"contact_{sensor}": last}
    peaks = pulses(force.sel(at_last))[["peak", "peak_error"]].squeeze("place")
    strongest = peaks.isel(pulse=int(peaks["peak"].fillna(0.0).argmax("pulse")))
    measured = {
        "largest_force": Estimate(float(strongest["peak"]), float(strongest["peak_error"])),
        "time_of_flight": time_of_flight(force, first, last),
        "last_velocity": recorded(velocity[-1]),
    }
    for name in ("transmitted_momentum", "transmitted_energy"):
        measured[name] = recorded(motion[f"{name}_{sensor}"].sel(at_last)[-1])
    if beads is not None:
        measured["velocity"] = velocity.reindex(bead=beads).values, velocity.attrs["error_estimate"]
    return measured
