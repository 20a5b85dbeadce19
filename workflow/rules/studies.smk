"""Studies: many solutions each, from a section of the configuration."""

# Module and function that compute the data of each study, and whose kernels they need.
STUDIES = {
    "continuum/log_burgers_fronts": ("studies.log_burgers_fronts", "evaluate_fronts", []),
    "fronts/survey": ("studies.front_survey", "survey_plane", ["fronts"]),
    "fronts/critical_damping": ("studies.damping_map", "map_plane", ["fronts"]),
    "fronts/multipliers": ("studies.multipliers", "compute_multipliers", ["fronts"]),
    "fronts/trends": ("studies.front_trends", "follow_trends", ["fronts"]),
    "laws/materials": ("studies.materials", "evaluate_materials", []),
    "laws/damping_regimes": ("studies.damping_regimes", "evaluate_regimes", []),
    "laws/numerical_damping": ("studies.numerical_damping", "measure_numerical_damping", ["chain"]),
    "laws/half_step_damping": ("studies.half_step_damping", "measure_half_step_damping", ["chain"]),
    "laws/choice_of_variables": ("studies.choice_of_variables", "compare_variables", ["chain"]),
    "laws/limiting_cases": (
        "studies.limiting_cases",
        "measure_limiting_cases",
        ["chain", "continuum"],
    ),
    "laws/jump_conditions": ("studies.jump_conditions_measured", "measure_jumps", ["fronts"]),
}
STUDY_BENCHMARKS = expand("<benchmarks>/study/{study}.tsv", study=STUDIES)

# Those of papers are not made by a plain call.
STUDIES |= {
    f"{one['folder']}/{name}": (*one["function"].rsplit(".", 1), one["kernels"])
    for name, one in listed_in_papers("studies").items()
}


rule study:
    """A study: many solutions and their measures."""
    input:
        kernels=lambda wildcards: stamps(STUDIES[wildcards.study][2]),
    output:
        dataset="<results>/data/{study}.nc",
    params:
        code=lambda wildcards: digest_of("study", f"granular_fronts.{STUDIES[wildcards.study][0]}"),
        module=lambda wildcards: STUDIES[wildcards.study][0],
        function=lambda wildcards: STUDIES[wildcards.study][1],
        section=lambda wildcards: parameters_of(wildcards.study),
    log:
        "<logs>/study/{study}.log",
    benchmark:
        "<benchmarks>/study/{study}.tsv"
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        study="|".join(STUDIES),
    # Some take long, and had better start early.
    priority: 1
    script:
        "../scripts/study.py"
