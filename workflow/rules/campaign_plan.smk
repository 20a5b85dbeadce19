"""The plan of a campaign, made when a campaign is asked for and not before."""

CAMPAIGNS = os.path.join(workflow.basedir, "config", "campaigns")


@cache
def campaign_of(name):
    """Read a campaign and check it; nothing of this is loaded before a campaign is asked for."""
    from granular_fronts.campaign.definition import load_campaign

    try:
        return load_campaign(CAMPAIGNS, name)
    except ConfigurationError as error:
        sys.exit(f"The campaign cannot be computed.\n{error}")


@cache
def campaign_chunks(name):
    """Plan a campaign; return the files of its chunks."""
    from granular_fronts.campaign.planning import plan_campaign

    folder = os.path.join(config["results"], "data", "campaigns", name)
    try:
        chunks = plan_campaign(campaign_of(name), Path(folder), config["chunk_seconds"])
    except ConfigurationError as error:
        sys.exit(f"The campaign cannot be computed.\n{error}")
    return [os.path.join(folder, f"{chunk}.nc") for chunk in chunks]


def campaign_sources(wildcards):
    """Return the files that the numbers of a campaign stand on."""
    return source_files("solve_chunk", campaign_of(wildcards.campaign).kind.module)


def campaign_kernels(name):
    """Return the stamp of the chain's kernels where a campaign moves chains.

    Measuring what a point costs has compiled the other kernels.
    """
    return rules.compile_kernels.output.stamp if campaign_of(name).kind_name == "chain" else []


def named_campaign(wildcards):
    """Return the table of the campaign that the command names."""
    if "campaign" not in config:
        sys.exit("Name the campaign, for example: snakemake -c2 campaign --config campaign=smoke.")
    campaign_of(config["campaign"])
    return f"{config['results']}/tables/campaign_{config['campaign']}.md"
