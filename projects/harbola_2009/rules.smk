"""Pulses in tapered chains: a sentence of Harbola et al. (2009), and what is added."""

from harbola_2009_settings import TaperedChains

HARBOLA, HARBOLA_OWN = project_settings("harbola_2009", TaperedChains)
HARBOLA_SHOWN = {name: [HARBOLA[name], HARBOLA_OWN[name]] for name in HARBOLA}


rule follow_tapered_pulses:
    """Pulses along chains of several tapers, with binary collisions."""
    input:
        kernels("chain"),
    output:
        dataset="<results>/data/harbola_2009/pulses.nc",
    params:
        code=code("tapered_chains"),
        settings=HARBOLA["pulses"],
    log:
        "<logs>/harbola_2009/pulses.log",
    benchmark:
        "<benchmarks>/harbola_2009/pulses.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "tapered_chains.py"


rule measure_tapered_losses:
    """What a pulse loses at smaller and smaller taper."""
    input:
        kernels("chain"),
    output:
        dataset="<results>/data/harbola_2009/losses.nc",
    params:
        code=code("tapered_losses"),
        settings=HARBOLA["losses"],
    log:
        "<logs>/harbola_2009/losses.log",
    benchmark:
        "<benchmarks>/harbola_2009/losses.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "tapered_losses.py"


rule harbola_2009_pulses:
    """Speed, compression and loss of pulses in tapered chains."""
    input:
        pulses="<results>/data/harbola_2009/pulses.nc",
        losses="<results>/data/harbola_2009/losses.nc",
        texts="projects/harbola_2009/captions/harbola_2009_pulses.rst",
    output:
        **figure("harbola_2009_pulses", "projects/harbola_2009/captions"),
    params:
        code=code("harbola_2009_pulses", "tapered_losses"),
        shown=HARBOLA_SHOWN,
    log:
        "<logs>/harbola_2009/figure_pulses.log",
    benchmark:
        "<benchmarks>/harbola_2009/figure_pulses.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "harbola_2009_pulses.py"


rule harbola_2009_statements:
    """A sentence of the abstract, and findings, with verdicts."""
    input:
        statements="projects/harbola_2009/statements.yaml",
        datasets=data("harbola_2009/pulses", "harbola_2009/losses"),
    output:
        **table("harbola_2009_statements"),
    params:
        code=code("tabulate_statements", *measured_by("projects/harbola_2009/statements.yaml")),
        shown=HARBOLA_SHOWN,
    log:
        "<logs>/harbola_2009/statements.log",
    benchmark:
        "<benchmarks>/harbola_2009/statements.tsv"
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
    benchmark:
        "<benchmarks>/harbola_2009/verdicts.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    localrule: True
    script:
        "../../workflow/scripts/check_verdicts.py"
