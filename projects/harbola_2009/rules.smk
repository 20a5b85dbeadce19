"""Pulses in tapered chains: a sentence of Harbola et al. (2009), and what is added."""

from harbola_2009_settings import TaperedChains

HARBOLA, HARBOLA_OWN = project_settings("harbola_2009", TaperedChains)


rule follow_tapered_pulses:
    """Pulses along tapered chains with binary collisions, and their losses at smaller taper."""
    input:
        kernels("chain"),
    output:
        dataset="<results>/data/harbola_2009/pulses.nc",
    params:
        code=code("tapered_chains"),
        settings=HARBOLA,
    log:
        "<logs>/harbola_2009/pulses.log",
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "tapered_chains.py"


rule harbola_2009_pulses:
    """Speed, compression and loss of pulses in tapered chains."""
    input:
        pulses="<results>/data/harbola_2009/pulses.nc",
        texts="projects/harbola_2009/captions/harbola_2009_pulses.rst",
    output:
        **figure("harbola_2009_pulses", "projects/harbola_2009/captions"),
    params:
        code=code("harbola_2009_pulses", "tapered_chains"),
        shown=dict(pulses=[HARBOLA, HARBOLA_OWN]),
    log:
        "<logs>/harbola_2009/figure_pulses.log",
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "harbola_2009_pulses.py"


rule harbola_2009_statements:
    """A sentence of the abstract, and findings, with verdicts."""
    input:
        statements="projects/harbola_2009/statements.yaml",
        datasets=data("harbola_2009/pulses"),
    output:
        **table("harbola_2009_statements"),
    params:
        code=code("tabulate_statements", *measured_by("projects/harbola_2009/statements.yaml")),
        shown=dict(pulses=[HARBOLA, HARBOLA_OWN]),
    log:
        "<logs>/harbola_2009/statements.log",
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "../../workflow/scripts/tabulate_statements.py"


rule harbola_2009:
    """Pulses in tapered chains, with a figure and verdicts; half a minute."""
    input:
        figures=rules.harbola_2009_pulses.output,
        tables=[rules.harbola_2009_statements.output.csv],
    output:
        verdict="<results>/harbola_2009.txt",
    params:
        code=code("check_verdicts"),
    log:
        "<logs>/harbola_2009/verdicts.log",
    conda:
        "../../workflow/envs/main.yaml"
    localrule: True
    script:
        "../../workflow/scripts/check_verdicts.py"
