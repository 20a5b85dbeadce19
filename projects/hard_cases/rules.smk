"""Problems at the edge of what the solvers can do, each against an answer known another way."""


rule solve_hard_cases:
    """The distance of each hard case from its known answer."""
    input:
        kernels=kernels("fronts", "reference_methods"),
    output:
        **table("hard_cases"),
        dataset="<results>/data/hard_cases/hard_cases.nc",
    params:
        code=code("solve_hard_cases"),
    log:
        "<logs>/solve_hard_cases.log",
    benchmark:
        "<benchmarks>/solve_hard_cases.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "solve_hard_cases.py"


rule draw_hard_cases:
    """Errors of the hard cases beside their limits."""
    input:
        data="<results>/data/hard_cases/hard_cases.nc",
        texts="projects/hard_cases/captions/hard_cases.rst",
    output:
        **figure("hard_cases", "projects/hard_cases/captions"),
    params:
        code=code("hard_cases", "solve_hard_cases"),
        shown={},
    log:
        "<logs>/draw_hard_cases.log",
    benchmark:
        "<benchmarks>/draw_hard_cases.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    localrule: True
    script:
        "hard_cases.py"


rule hard_cases:
    """Problems at the edge of what the solvers can do, a figure and a table; about a minute."""
    input:
        rules.solve_hard_cases.output,
        rules.draw_hard_cases.output,
