"""Pulses in tapered chains: a sentence of Harbola et al. (2009), and what is added."""

from harbola_2009_settings import TaperedChains

HARBOLA, HARBOLA_OWN = project_settings("harbola_2009", TaperedChains)
JUDGED["harbola_2009"] = {"pulses": [HARBOLA, HARBOLA_OWN]}


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
        shown=JUDGED["harbola_2009"],
    log:
        "<logs>/harbola_2009/figure_pulses.log",
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "harbola_2009_pulses.py"


rule harbola_2009:
    """Pulses in tapered chains, with a figure and verdicts; half a minute."""
    input:
        rules.harbola_2009_pulses.output,
        "<results>/harbola_2009.txt",
