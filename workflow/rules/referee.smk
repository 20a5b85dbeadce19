"""Problems with accurate answers for discrete-element codes, see docs/practitioners.md."""

from granular_fronts.referee.problems import load_problems
from granular_fronts.referee.settings import read_settings

with exit_on_error("The problems of the referee cannot be stated."):
    REFEREE = read_settings("config/referee.yaml")
    PROBLEMS = list(load_problems(REFEREE))


rule write_referee:
    input:
        kernels=rules.compile_kernels.output.stamp,
    output:
        table="<results>/referee/answers.csv",
        files=expand(
            "<results>/referee/{problem}.{ending}",
            problem=PROBLEMS,
            ending=["lmp", "txt", "nc", "csv"],
        ),
    params:
        code=code("write_referee"),
        settings=REFEREE.plain(),
    log:
        "<logs>/write_referee.log",
    benchmark:
        "<benchmarks>/write_referee.tsv"
    message:
        "Solving the problems for discrete-element codes."
    conda:
        "../envs/main.yaml"
    script:
        "../scripts/referee/write_referee.py"


rule referee:
    """Problems with accurate answers for discrete-element codes."""
    input:
        rules.write_referee.output,
    message:
        "Compute them with your code, then: python -m granular_fronts.referee FILE ..."
