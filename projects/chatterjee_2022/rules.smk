"""A ball on a plate, with and without load: curves of Chatterjee et al. (2022)."""

from chatterjee_2022_settings import Falls

CHATTERJEE, CHATTERJEE_OWN = project_settings("chatterjee_2022", Falls)


rule balls_on_a_plate:
    """Restitution of a ball on a plate, and published points."""
    input:
        kernels("chain"),
        statements="projects/chatterjee_2022/statements.yaml",
    output:
        dataset="<results>/data/chatterjee_2022/falls.nc",
    params:
        code=code("ball_on_plate"),
        settings=CHATTERJEE,
    log:
        "<logs>/chatterjee_2022/falls.log",
    benchmark:
        "<benchmarks>/chatterjee_2022/falls.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "ball_on_plate.py"


rule chatterjee_2022_restitution:
    """Restitution of a ball on a plate with published points."""
    input:
        falls="<results>/data/chatterjee_2022/falls.nc",
        texts="projects/chatterjee_2022/captions/chatterjee_2022_restitution.rst",
    output:
        **figure("chatterjee_2022_restitution", "projects/chatterjee_2022/captions"),
    params:
        code=code("chatterjee_2022_restitution", "ball_on_plate"),
        shown=dict(falls=[CHATTERJEE, CHATTERJEE_OWN]),
    log:
        "<logs>/chatterjee_2022/restitution.log",
    benchmark:
        "<benchmarks>/chatterjee_2022/restitution.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "chatterjee_2022_restitution.py"


rule chatterjee_2022_statements:
    """Points of ten published curves and findings, with verdicts."""
    input:
        statements="projects/chatterjee_2022/statements.yaml",
        datasets=data("chatterjee_2022/falls"),
    output:
        **table("chatterjee_2022_statements"),
    params:
        code=code("tabulate_statements", *measured_by("projects/chatterjee_2022/statements.yaml")),
        shown=dict(falls=[CHATTERJEE, CHATTERJEE_OWN]),
    log:
        "<logs>/chatterjee_2022/statements.log",
    benchmark:
        "<benchmarks>/chatterjee_2022/statements.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "../../workflow/scripts/tabulate_statements.py"


rule chatterjee_2022:
    """A ball on a plate, with figure and verdicts; seconds."""
    input:
        figures=rules.chatterjee_2022_restitution.output,
        tables=[rules.chatterjee_2022_statements.output.csv],
    output:
        verdict="<results>/chatterjee_2022.txt",
    params:
        code=code("check_verdicts"),
    log:
        "<logs>/chatterjee_2022/verdicts.log",
    benchmark:
        "<benchmarks>/chatterjee_2022/verdicts.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    localrule: True
    script:
        "../../workflow/scripts/check_verdicts.py"
