"""Speed against error; a target of its own, since a timing must run alone."""

from speed_and_error_settings import SpeedAndError

SPEED, SPEED_OWN = project_settings("speed_and_error", SpeedAndError)


rule measure_speed:
    """Errors and times of all methods on all problems, in a job that takes all cores."""
    input:
        kernels=kernels("fronts", "reference_methods"),
        chain_states="tests/references/chain_reference.nc",
        fronts="tests/references/fronts_reference.nc",
        scilab="projects/speed_and_error/peers/scilab.sce",
    output:
        dataset="<results>/data/speed_and_error/speed_error.nc",
    params:
        code=code("measure_speed"),
        settings=SPEED,
        ring=config["scenes"]["periodic"]["weak"],
    log:
        "<logs>/measure_speed.log",
    benchmark:
        "<benchmarks>/measure_speed.tsv"
    threads: workflow.cores
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "measure_speed.py"


rule tabulate_speed_error:
    """Times to reach an error, and all runs."""
    input:
        dataset="<results>/data/speed_and_error/speed_error.nc",
    output:
        **table("speed_error"),
        runs_csv="<results>/tables/speed_runs.csv",
        runs_markdown="<results>/tables/speed_runs.md",
    params:
        code=code("tabulate_speed_error", "measure_speed"),
        shown={"speed_error": [SPEED, SPEED_OWN]},
    log:
        "<logs>/tabulate_speed_error.log",
    benchmark:
        "<benchmarks>/tabulate_speed_error.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "tabulate_speed_error.py"


rule draw_speed_error:
    """Time against error of all methods."""
    input:
        data="<results>/data/speed_and_error/speed_error.nc",
        texts="projects/speed_and_error/captions/speed_error.rst",
    output:
        **figure("speed_error", "projects/speed_and_error/captions"),
    params:
        code=code("speed_error", "measure_speed"),
        shown={"speed_error": [SPEED, SPEED_OWN]},
    log:
        "<logs>/draw_speed_error.log",
    benchmark:
        "<benchmarks>/draw_speed_error.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    localrule: True
    script:
        "speed_error.py"


rule speed_and_error:
    """Time against error of our solvers and others; 7 minutes on a quiet machine."""
    input:
        rules.tabulate_speed_error.output,
        rules.draw_speed_error.output,
