"""Mass ratios of dimers: sentences of two papers, and the ratios with their errors."""

from jayaprakash_2011_settings import Dimers

DIMERS, DIMERS_OWN = project_settings("jayaprakash_2011", Dimers)
JUDGED["jayaprakash_2011"] = {"ratios": [DIMERS, DIMERS_OWN]}
MADE_BY["jayaprakash_2011/ratios"] = "dimer_ratios.find_ratios", DIMERS


rule jayaprakash_2011_ladder:
    """Attenuation over the mass ratio, and waves that leave nothing behind."""
    input:
        found="<results>/data/jayaprakash_2011/ratios.nc",
        texts="projects/jayaprakash_2011/captions/jayaprakash_2011_ladder.rst",
    output:
        **figure("jayaprakash_2011_ladder", "projects/jayaprakash_2011/captions"),
    params:
        code=code("jayaprakash_2011_ladder", "dimer_ratios"),
        shown=JUDGED["jayaprakash_2011"],
    log:
        "<logs>/jayaprakash_2011/ladder.log",
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "jayaprakash_2011_ladder.py"


rule jayaprakash_2011:
    """Mass ratios of dimers, with a figure and verdicts; a minute."""
    input:
        rules.jayaprakash_2011_ladder.output,
        "<results>/jayaprakash_2011.txt",
