"""Problems with accurate answers for discrete-element codes, and what the step of such codes does."""

from granular_fronts.referee.settings import read_settings
from referee_settings import HalfStepDamping

REFEREE, REFEREE_OWN = project_settings("referee", HalfStepDamping)


rule write_referee:
    """A folder for each problem: words, decks of codes, the accurate answer, and tolerances."""
    input:
        kernels("chain"),
        kernels("reference_methods"),
        "src/granular_fronts/referee/problems.yaml",
    output:
        table="<results>/referee/answers.csv",
        folders=directory(
            expand("<results>/referee/{problem}", problem=read_settings().combinations())
        ),
    params:
        code=code("write_referee"),
    log:
        "<logs>/write_referee.log",
    benchmark:
        "<benchmarks>/write_referee.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "write_referee.py"


rule measure_half_step_damping:
    """The scheme of discrete-element codes against accurate chains."""
    input:
        kernels("chain"),
    output:
        dataset="<results>/data/referee/half_step_damping.nc",
    params:
        code=code("measure_half_step_damping"),
        settings=REFEREE,
    log:
        "<logs>/measure_half_step_damping.log",
    benchmark:
        "<benchmarks>/measure_half_step_damping.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "measure_half_step_damping.py"


rule half_step_damping:
    """The damping that the step seems to add, and the checks that hardly notice it."""
    input:
        data=rules.measure_half_step_damping.output.dataset,
        texts="projects/referee/captions/half_step_damping.rst",
    output:
        **figure("half_step_damping", "projects/referee/captions"),
    params:
        code=code("half_step_damping", "measure_half_step_damping"),
        shown={"half_step_damping": [REFEREE, REFEREE_OWN]},
    log:
        "<logs>/half_step_damping.log",
    benchmark:
        "<benchmarks>/half_step_damping.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    localrule: True
    script:
        "half_step_damping.py"


rule tabulate_half_step_damping:
    """What was found of the scheme, with errors and verdicts."""
    input:
        statements="projects/referee/findings.yaml",
        datasets=[rules.measure_half_step_damping.output.dataset],
    output:
        **table("half_step_damping"),
    params:
        code=code(
            "tabulate_statements",
            "measure_half_step_damping",
            *measured_by("projects/referee/findings.yaml"),
        ),
        shown={"half_step_damping": [REFEREE, REFEREE_OWN]},
    log:
        "<logs>/tabulate_half_step_damping.log",
    benchmark:
        "<benchmarks>/tabulate_half_step_damping.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "../../workflow/scripts/tabulate_statements.py"


rule check_half_step_damping:
    """The verdicts on the scheme are those that are expected."""
    input:
        tables=[rules.tabulate_half_step_damping.output.csv],
    output:
        verdict="<results>/referee.txt",
    params:
        code=code("check_verdicts"),
    log:
        "<logs>/check_half_step_damping.log",
    benchmark:
        "<benchmarks>/check_half_step_damping.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "../../workflow/scripts/check_verdicts.py"


rule referee:
    """Problems with accurate answers for discrete-element codes, and a study; a minute."""
    input:
        rules.write_referee.output,
        rules.half_step_damping.output,
        rules.check_half_step_damping.output,
