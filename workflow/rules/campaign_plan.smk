"""The plan of a campaign, made when a campaign is asked for and not before."""

from functools import cache

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


@cache
def campaign_modules(name):
    """Return the modules that the numbers of a campaign stand on."""
    wings = campaign_of(name).kind.wings
    folders = ("campaign", "elementary", *wings)
    return modules("datasets.py", *(f"{folder}/*.py" for folder in folders))


def campaign_kernels(name):
    """Return the stamp of the chain's kernels where a campaign moves chains.

    Measuring what a point costs has compiled the other kernels.
    """
    return rules.compile_kernels.output.stamp if "chain" in campaign_of(name).kind.wings else []


def named_campaign(wildcards):
    """Return the table of the campaign that the command names."""
    if "campaign" not in config:
        sys.exit("Name the campaign, for example: snakemake -c2 campaign --config campaign=smoke.")
    return f"{config['results']}/tables/campaign_{config['campaign']}.md"
