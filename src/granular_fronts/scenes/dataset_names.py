"""Names of data files: no two rules write the same one, and no two results share a name.

Scenes of all families and the results that the workflow names itself are found by one name, for
example in the list of printed numbers, so a name belongs to one of them.
"""

from collections.abc import Iterator, Mapping

RESULTS = {
    "log_burgers_fronts": "the fluxes and fronts of figure 4",
    "survey": "the survey of exact fronts",
    "critical_damping": "the map of critical damping",
    "multipliers": "the multipliers of exact fronts",
    "collection": "the collection of exact fronts of the explorer",
    "trends": "the families of exact fronts",
    "materials": "the materials of remark 6",
    "damping_regimes": "the damping regimes",
    "numerical_damping": "the numerical damping",
    "half_step_damping": "the damping by the half-step scheme",
    "jump_conditions": "the fronts measured against the jump conditions",
    "choice_of_variables": "the comparison of variables",
    "limiting_cases": "the limiting cases",
    "piston": "the fronts driven by pistons",
}
"""Results that the workflow names itself, and what they are."""


def name_errors(configuration: Mapping) -> Iterator[str]:
    """Find scenes that share a name, and entries that name no scene.

    Parameters
    ----------
    configuration : Mapping
        One that obeys the schema.

    Yields
    ------
    str
        A sentence for each.
    """
    owners = dict(RESULTS)
    for family, scenes in configuration["scenes"].items():
        for name in scenes:
            if name in owners:
                yield (
                    f"scenes.{family}.{name} has the name of {owners[name]}, but a name belongs to "
                    "one result only: rename a scene."
                )
            owners.setdefault(name, f"scenes.{family}.{name}")
    rings = configuration["scenes"]["periodic"]
    for name in configuration["precision"]["log_burgers"]:
        if name not in rings:
            yield (
                f"precision.log_burgers.{name} names no periodic scene: choose one of "
                f"{', '.join(rings)}."
            )
