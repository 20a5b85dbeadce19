"""Studies: a dataset each, by one function of a part of the configuration."""

# For each dataset: the function that makes it of a part of the configuration, in which module of
# granular_fronts.studies, and whose kernels it needs.
STUDIES = {
    "continuum/log_burgers_fronts": ("log_burgers_fronts", "evaluate_fronts", []),
    "fronts/survey": ("front_survey", "survey_plane", ["fronts"]),
    "fronts/critical_damping": ("damping_map", "map_plane", ["fronts"]),
    "fronts/trends": ("front_trends", "follow_trends", ["fronts"]),
    "fronts/multipliers": ("multipliers", "compute_multipliers", ["fronts"]),
    "laws/materials": ("materials", "evaluate_materials", []),
    "laws/damping_regimes": ("damping_regimes", "evaluate_regimes", []),
    "laws/numerical_damping": ("numerical_damping", "measure_numerical_damping", ["chain"]),
    "laws/choice_of_variables": ("choice_of_variables", "compare_variables", ["chain"]),
    "laws/limiting_cases": ("limiting_cases", "measure_limiting_cases", ["chain", "continuum"]),
    "laws/jump_conditions": ("jump_conditions_measured", "measure_jumps", ["chain", "fronts"]),
}


rule study:
    """What needs many chains or fronts, or none: laws, materials, limits, fronts over a plane."""
    input:
        lambda wildcards: kernels(*STUDIES[wildcards.dataset][2]),
    output:
        dataset="<results>/data/{dataset}.nc",
    params:
        code=lambda wildcards: digest_of(*made_by(wildcards.dataset)),
        module=lambda wildcards: STUDIES[wildcards.dataset][0],
        function=lambda wildcards: STUDIES[wildcards.dataset][1],
        section=lambda wildcards: parameters(wildcards.dataset),
    log:
        "<logs>/study/{dataset}.log",
    benchmark:
        "<benchmarks>/study/{dataset}.tsv"
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        dataset="|".join(STUDIES),
    priority: 1
    script:
        "../scripts/study.py"


DATASETS = [*(name for family in FOLDERS for name in datasets_of(family)), *STUDIES]
"""What a plain call computes."""
