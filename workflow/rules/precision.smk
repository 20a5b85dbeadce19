"""Speed against error; a target of its own, since a timing must run alone."""


rule measure_precision:
    input:
        kernels="<results>/kernels.json",
        reference="tests/references/chain_reference.nc",
        modules=CHAIN_MODULES,
        peers=glob("workflow/scripts/peers/*"),
    output:
        dataset="<results>/data/precision/chain.nc",
    params:
        problems=config["precision"]["chain"],
    log:
        "<logs>/measure_precision.log",
    benchmark:
        "<benchmarks>/measure_precision.tsv"
    threads: workflow.cores
    message:
        "Measuring speed against error of the chain's integrators."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/measure_precision.py"


rule tabulate_precision:
    input:
        dataset="<results>/data/precision/chain.nc",
    output:
        csv="<results>/tables/chain_speed.csv",
        markdown="<results>/tables/chain_speed.md",
    log:
        "<logs>/tabulate_precision.log",
    benchmark:
        "<benchmarks>/tabulate_precision.tsv"
    threads: 1
    message:
        "Comparing the methods at equal error."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/tabulate_precision.py"


rule measure_log_burgers:
    input:
        kernels="<results>/continuum_kernels.json",
        modules=CONTINUUM_MODULES,
    output:
        dataset="<results>/data/precision/log_burgers.nc",
    params:
        problems=config["precision"]["log_burgers"],
        scenes=config["scenes"]["periodic"],
    log:
        "<logs>/measure_log_burgers.log",
    benchmark:
        "<benchmarks>/measure_log_burgers.tsv"
    threads: workflow.cores
    message:
        "Measuring speed against error of the solvers of the logarithmic Burgers equation."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/measure_log_burgers.py"


rule tabulate_log_burgers:
    input:
        dataset="<results>/data/precision/log_burgers.nc",
    output:
        csv="<results>/tables/log_burgers_solvers.csv",
        markdown="<results>/tables/log_burgers_solvers.md",
    log:
        "<logs>/tabulate_log_burgers.log",
    benchmark:
        "<benchmarks>/tabulate_log_burgers.tsv"
    threads: 1
    message:
        "Comparing the solvers of the logarithmic Burgers equation."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/tabulate_log_burgers.py"


rule precision:
    input:
        rules.tabulate_precision.output,
        rules.tabulate_log_burgers.output,
    message:
        "Speed against error is tabulated: {input}."
