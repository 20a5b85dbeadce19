"""Grids of parameter points: snakemake -c2 campaign --config campaign=smoke."""


rule solve_chunk:
    """Some points of a grid."""
    input:
        # Kernels that are compiled again solve no chunk again.
        kernels=ancient(
            lambda wildcards: KERNELS_OF_KIND[campaign_of(wildcards.campaign).file.kind]
        ),
    output:
        dataset="<results>/data/campaigns/{campaign}/{chunk}.nc",
    params:
        code=campaign_code("solve_chunk"),
        request=lambda wildcards: requests_of(wildcards.campaign)[wildcards.chunk].as_json(),
    log:
        "<logs>/solve_chunk/{campaign}/{chunk}.log",
    benchmark:
        "<benchmarks>/solve_chunk/{campaign}/{chunk}.tsv"
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        campaign=CAMPAIGN_NAME,
        chunk="[0-9a-f]{16}",
    script:
        "../scripts/solve_chunk.py"


rule merge_campaign:
    """The points of a grid in one dataset."""
    input:
        chunks=lambda wildcards: campaign_chunks(wildcards.campaign),
    output:
        dataset="<results>/data/campaigns/{campaign}.nc",
    params:
        code=code("merge_campaign"),
        campaign=lambda wildcards: campaign_of(wildcards.campaign).given,
    log:
        "<logs>/merge_campaign/{campaign}.log",
    benchmark:
        "<benchmarks>/merge_campaign/{campaign}.tsv"
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        campaign=CAMPAIGN_NAME,
    localrule: True
    script:
        "../scripts/merge_campaign.py"


rule summarise_campaign:
    """Points of a grid as a table, and its failures, ranges and work."""
    input:
        dataset="<results>/data/campaigns/{campaign}.nc",
    output:
        points="<results>/tables/campaign_{campaign}.csv",
        csv="<results>/tables/campaign_{campaign}_summary.csv",
        markdown="<results>/tables/campaign_{campaign}_summary.md",
    params:
        code=code("summarise_campaign"),
    log:
        "<logs>/summarise_campaign/{campaign}.log",
    benchmark:
        "<benchmarks>/summarise_campaign/{campaign}.tsv"
    conda:
        "../envs/main.yaml"
    wildcard_constraints:
        campaign=CAMPAIGN_NAME,
    localrule: True
    script:
        "../scripts/summarise_campaign.py"


# The chunks are kept with what is made of them.  So one that a failed or killed job has lost is
# missed, even where an older merged file is there.
rule campaign:
    """A grid of parameter points; add --config campaign=NAME, a file of config/campaigns."""
    input:
        table=lambda wildcards: f"{config['results']}/tables/campaign_{named_campaign()}_summary.md",
        points=lambda wildcards: f"{config['results']}/tables/campaign_{named_campaign()}.csv",
        dataset=lambda wildcards: f"{config['results']}/data/campaigns/{named_campaign()}.nc",
        chunks=lambda wildcards: campaign_chunks(named_campaign()),
