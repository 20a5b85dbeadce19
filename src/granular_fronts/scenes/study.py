"""Studies whose values the schema limits one by one: many exact fronts, accuracy, speed."""

from granular_fronts.scenes.sections import Section

STUDIES = {
    "front_exponents": Section(dataset=("log_burgers_fronts", "the fluxes and fronts of figure 4")),
    "exact_fronts.survey": Section(dataset=("survey", "the survey of exact fronts")),
    "exact_fronts.critical_damping": Section(
        dataset=("critical_damping", "the map of critical damping")
    ),
    "exact_fronts.multipliers": Section(dataset=("multipliers", "the multipliers of exact fronts")),
    "exact_fronts.trends": Section(dataset=("trends", "the families of exact fronts")),
    "explorer": Section(dataset=("collection", "the collection of exact fronts of the explorer")),
    "honesty.*": Section(),
    "precision.log_burgers.*": Section(),
    "precision.chain.*": Section(),
    "precision.ring.*": Section(),
    "precision.heteroclinic.*": Section(),
    "precision.fronts.*": Section(),
}
