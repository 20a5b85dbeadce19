"""Speed against error; a target of its own, since a timing must run alone.

A family of problems is measured by one job, which takes all cores so that nothing else runs.
"""


rule measure_precision:
    input:
        kernels=rules.compile_front_kernels.output.stamp,
        # The logarithmic Burgers equation solves its own.
        reference=lambda wildcards: (
            []
            if wildcards.family == "log_burgers"
            else f"tests/references/{wildcards.family}_reference.nc"
        ),
        scilab="workflow/scripts/precision/peers/scilab.sce",
    output:
        dataset="<results>/data/precision/{family}.nc",
    params:
        code=code("measure_precision", "problems.{wildcards.family}"),
        family="{family}",
        problems=lambda wildcards: precision_problems(config)[wildcards.family],
    log:
        "<logs>/measure_precision/{family}.log",
    benchmark:
        "<benchmarks>/measure_precision/{family}.tsv"
    threads: ALL_CORES
    message:
        "Measuring speed against error: {wildcards.family}."
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        family="|".join(config["precision"]),
    script:
        "../scripts/precision/measure_precision.py"


rule merge_precision:
    input:
        datasets=expand("<results>/data/precision/{family}.nc", family=config["precision"]),
    output:
        dataset="<results>/data/precision/speed_error.nc",
    params:
        code=code("merge_precision"),
    log:
        "<logs>/merge_precision.log",
    benchmark:
        "<benchmarks>/merge_precision.tsv"
    message:
        "Joining the measurements of all families of problems."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/precision/merge_precision.py"


rule tabulate_speed_error:
    input:
        dataset=rules.merge_precision.output.dataset,
    output:
        csv="<results>/tables/speed_error.csv",
        markdown="<results>/tables/speed_error.md",
        verdicts_csv="<results>/tables/speed_verdicts.csv",
        verdicts_markdown="<results>/tables/speed_verdicts.md",
        runs_csv="<results>/tables/speed_runs.csv",
        runs_markdown="<results>/tables/speed_runs.md",
    params:
        code=code("tabulate_speed_error"),
        parameters=parameters("precision/speed_error"),
    log:
        "<logs>/tabulate_speed_error.log",
    benchmark:
        "<benchmarks>/tabulate_speed_error.tsv"
    message:
        "Comparing the methods at equal error."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/precision/tabulate_speed_error.py"


rule precision:
    """Time against error of all solvers, with figure 14; minutes on a quiet machine."""
    input:
        rules.tabulate_speed_error.output,
        rules.fig14.input,
    message:
        "Speed against error is measured; the next report shows it: {input}."
