"""Pulses in tapered chains: a sentence of Harbola et al. (2009), and what is added."""

from harbola_2009_settings import TaperedChains

HARBOLA, HARBOLA_OWN = project_settings("harbola_2009", TaperedChains)
JUDGED["harbola_2009"] = {"pulses": [HARBOLA, HARBOLA_OWN]}
MADE_BY["harbola_2009/pulses"] = "tapered_chains.follow_pulses", HARBOLA


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
