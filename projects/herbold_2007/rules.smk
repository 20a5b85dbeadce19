"""Fronts with linear dashpots: sentences of Herbold and Nesterenko (2007)."""

JUDGED["herbold_2007"] = {"shocks": [{}, {}]}
MADE_BY["herbold_2007/shocks"] = "steady_shocks.shocks", {}


rule herbold_2007:
    """Fronts with linear dashpots, with verdicts; seconds."""
    input:
        "<results>/herbold_2007.txt",
