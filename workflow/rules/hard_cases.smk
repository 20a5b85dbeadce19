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
    threads: 1
    message:
        "Solving the hard cases."
    conda:
        environment
    script:
        "../scripts/measure_hard_cases.py"


rule tabulate_hard_cases:
    input:
        dataset=rules.measure_hard_cases.output.dataset,
    output:
        csv="<results>/tables/hard_cases.csv",
        markdown="<results>/tables/hard_cases.md",
        record="<results>/tables/hard_cases.json",
    params:
        code=code("tabulate_hard_cases"),
        asked=asked("precision/hard_cases"),
    log:
        "<logs>/tabulate_hard_cases.log",
    benchmark:
        "<benchmarks>/tabulate_hard_cases.tsv"
    threads: 1
    message:
        "Tabulating the hard cases."
    conda:
        environment
    script:
        "../scripts/tabulate_hard_cases.py"


rule measure_stiff_damping:
    input:
        kernels=rules.compile_kernels.output.stamp,
    output:
        dataset="<results>/data/precision/stiff_damping.nc",
    params:
        code=code("measure_stiff_damping"),
        problem=config["stiff_damping"],
    log:
        "<logs>/measure_stiff_damping.log",
    benchmark:
        "<benchmarks>/measure_stiff_damping.tsv"
    threads: ALL_CORES
    message:
        "Measuring explicit and implicit steps over the damping."
    conda:
        environment
    script:
        "../scripts/measure_stiff_damping.py"


rule tabulate_stiff_damping:
    input:
        dataset=rules.measure_stiff_damping.output.dataset,
    output:
        csv="<results>/tables/stiff_damping.csv",
        markdown="<results>/tables/stiff_damping.md",
        record="<results>/tables/stiff_damping.json",
    params:
        code=code("tabulate_stiff_damping"),
        asked=asked("precision/stiff_damping"),
    log:
        "<logs>/tabulate_stiff_damping.log",
    benchmark:
        "<benchmarks>/tabulate_stiff_damping.tsv"
    threads: 1
    message:
        "Comparing explicit and implicit steps at equal error."
    conda:
        environment
    script:
        "../scripts/tabulate_stiff_damping.py"


rule stiff_damping:
    input:
        rules.tabulate_stiff_damping.output,
    message:
        "Explicit and implicit steps are compared: {input}."


rule hard_cases:
    input:
        rules.tabulate_hard_cases.output,
        rules.fig15.input,
    message:
        "The hard cases are tabulated and drawn: {input}."
