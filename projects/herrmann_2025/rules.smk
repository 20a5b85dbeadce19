"""Overdamped fronts: sentences of Herrmann, James and Matthies (2025)."""


rule overdamped_fronts:
    """Overdamped fronts with linear dashpots, their tails, limit and proofs."""
    input:
        kernels("fronts"),
        certificate="docs/certificates/dashpots.npz",
    output:
        dataset="<results>/data/herrmann_2025/fronts.nc",
    params:
        code=code("overdamped_fronts"),
    log:
        "<logs>/herrmann_2025/fronts.log",
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "overdamped_fronts.py"


rule herrmann_2025_rates:
    """Rates of both tails, and what is proved."""
    input:
        fronts=rules.overdamped_fronts.output.dataset,
        texts="projects/herrmann_2025/captions/herrmann_2025_rates.rst",
    output:
        **figure("herrmann_2025_rates", "projects/herrmann_2025/captions"),
    params:
        code=code("herrmann_2025_rates", "overdamped_fronts"),
        shown={},
    log:
        "<logs>/herrmann_2025/rates.log",
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "herrmann_2025_rates.py"


rule herrmann_2025_statements:
    """Sentences on overdamped fronts, with verdicts."""
    input:
        statements="projects/herrmann_2025/statements.yaml",
        datasets=data("herrmann_2025/fronts"),
    output:
        **table("herrmann_2025_statements"),
    params:
        code=code("tabulate_statements", *measured_by("projects/herrmann_2025/statements.yaml")),
        shown=dict(fronts=[{}, {}]),
    log:
        "<logs>/herrmann_2025/statements.log",
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "../../workflow/scripts/tabulate_statements.py"


rule herrmann_2025:
    """Overdamped fronts with linear dashpots, with a figure and verdicts; seconds."""
    input:
        figures=rules.herrmann_2025_rates.output,
        tables=[rules.herrmann_2025_statements.output.csv],
    output:
        verdict="<results>/herrmann_2025.txt",
    params:
        code=code("check_verdicts"),
    log:
        "<logs>/herrmann_2025/verdicts.log",
    conda:
        "../../workflow/envs/main.yaml"
    localrule: True
    script:
        "../../workflow/scripts/check_verdicts.py"
