"""Problems at the edge of what the solvers can do: errors, limits, outcome."""


rule measure_hard_cases:
    input:
        kernels=rules.compile_front_kernels.output.stamp,
    output:
        dataset="<results>/data/precision/hard_cases.nc",
    params:
        code=code("measure_hard_cases"),
        cases=config["hard_cases"],
    log:
        "<logs>/measure_hard_cases.log",
    benchmark:
        "<benchmarks>/measure_hard_cases.tsv"
    message:
        "Solving the hard cases."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/precision/measure_hard_cases.py"


rule hard_cases:
    """Problems at the edge, with figure 15."""
    input:
        rules.tabulate_hard_cases.output,
        rules.fig15.input,
    message:
        "The hard cases are tabulated and drawn: {input}."
