"""Two pulses behind an impact: sentences of Rosas et al. (2007, 2008), and what is added."""

from rosas_2007_settings import Impacts

ROSAS, ROSAS_OWN = project_settings("rosas_2007", Impacts)
JUDGED["rosas_2007"] = {name: [ROSAS[name], ROSAS_OWN[name]] for name in ROSAS}
MADE_BY["rosas_2007/fronts"] = "impact_fronts.follow_fronts", ROSAS["fronts"]
MADE_BY |= {
    f"rosas_2007/{name}": ("impact_fronts.follow_impact", ROSAS[name])
    for name in ("weak", "medium", "strong")
}


rule rosas_2007_pulses:
    """Velocities behind an impact, and fronts of chains on exact fronts."""
    input:
        weak="<results>/data/rosas_2007/weak.nc",
        medium="<results>/data/rosas_2007/medium.nc",
        strong="<results>/data/rosas_2007/strong.nc",
        fronts="<results>/data/rosas_2007/fronts.nc",
        texts="projects/rosas_2007/captions/rosas_2007_pulses.rst",
    output:
        **figure("rosas_2007_pulses", "projects/rosas_2007/captions"),
    params:
        code=code("rosas_2007_pulses", "impact_fronts"),
        shown=JUDGED["rosas_2007"],
    log:
        "<logs>/rosas_2007/pulses.log",
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "rosas_2007_pulses.py"


rule rosas_2007:
    """Two pulses behind an impact, with a figure and verdicts; a minute."""
    input:
        rules.rosas_2007_pulses.output,
        "<results>/rosas_2007.txt",
