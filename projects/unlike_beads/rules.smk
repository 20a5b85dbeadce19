"""What passes chains of unlike beads, and how much a driven chain overshoots."""

UNLIKE_BEADS = "dimer_ratio", "taper", "disorder", "driven_chain"


rule real_chains:
    """What passes dimers, tapered and disordered chains, and overshoots of a driven chain."""
    input:
        dimers="<results>/data/campaigns/dimer_ratio.nc",
        tapers="<results>/data/campaigns/taper.nc",
        draws="<results>/data/campaigns/disorder.nc",
        driven="<results>/data/campaigns/driven_chain.nc",
        texts="projects/unlike_beads/captions/real_chains.rst",
    output:
        **figure("real_chains", "projects/unlike_beads/captions"),
    params:
        code=code("real_chains", "solve_chunk"),
        campaigns=lambda wildcards: [campaign_of(name).given for name in UNLIKE_BEADS],
    log:
        "<logs>/real_chains.log",
    benchmark:
        "<benchmarks>/real_chains.tsv"
    conda:
        "../../workflow/envs/main.yaml"
    script:
        "real_chains.py"


rule unlike_beads:
    """What passes chains of unlike beads, a figure of four campaigns; three minutes."""
    input:
        rules.real_chains.output,
