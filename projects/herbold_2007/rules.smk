"""Fronts with linear dashpots: sentences of Herbold and Nesterenko (2007)."""


rule steady_shocks:
    """Widths of fronts with linear dashpots, and one that forms."""
    input:
        kernels("chain", "fronts"),
    output:
        dataset="<results>/data/herbold_2007/shocks.nc",
    params:
        code=code("steady_shocks"),
    log:
        "<logs>/herbold_2007/shocks.log",
    benchmark:
        "<benchmarks>/herbold_2007/shocks.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "steady_shocks.py"


rule herbold_2007_statements:
    """Sentences on fronts with linear dashpots, with verdicts."""
    input:
        statements="projects/herbold_2007/statements.yaml",
        datasets=data("herbold_2007/shocks"),
    output:
        **table("herbold_2007_statements"),
    params:
        code=code("tabulate_statements", *measured_by("projects/herbold_2007/statements.yaml")),
        shown=dict(shocks=[{}, {}]),
    log:
        "<logs>/herbold_2007/statements.log",
    benchmark:
        "<benchmarks>/herbold_2007/statements.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "../../workflow/scripts/tabulate_statements.py"


rule herbold_2007:
    """Fronts with linear dashpots, with verdicts; seconds."""
    input:
        tables=[rules.herbold_2007_statements.output.csv],
    output:
        verdict="<results>/herbold_2007.txt",
    params:
        code=code("check_verdicts"),
    log:
        "<logs>/herbold_2007/verdicts.log",
    benchmark:
        "<benchmarks>/herbold_2007/verdicts.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    localrule: True
    script:
        "../../workflow/scripts/check_verdicts.py"
