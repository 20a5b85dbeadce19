"""Campaigns: how each is read, checked, and cut into chunks when it is asked for.

Nothing is written by that.
"""

CAMPAIGN_NAME = "[a-z][a-z0-9_]*(?<!_summary)"
KERNELS_OF_KIND = {
    "chain": kernels("chain"),
    "motion": kernels("chain"),
    "front": kernels("fronts"),
    "ring": kernels("chain", "continuum", "reference_methods"),
}


@cache
def campaign_of(name):
    """Read a campaign and check it; nothing of this is loaded before a campaign is asked for."""
    from granular_fronts.campaign.definition import load_campaign

    folders = [
        folder for folder in glob("projects/*/campaigns") if f"{name}.yaml" in os.listdir(folder)
    ]
    try:
        return load_campaign([*folders, "config/campaigns"][0], name)
    except InputError as error:
        sys.exit(f"The campaign cannot be computed.\n{error}")


def campaign_code(script):
    """Return a function for `params`: a digest of the code of a script and of a campaign's kind."""
    return lambda wildcards: digest_of(script, campaign_of(wildcards.campaign).kind.module)


def chunk_folder(name):
    """Return the folder of the chunks of a campaign."""
    return os.path.join(config["results"], "data", "campaigns", name)


@cache
def requests_of(name):
    """Return the chunks that a campaign consists of by name, those already solved among them."""
    from granular_fronts.campaign.chunks import chunks_of

    campaign = campaign_of(name)
    most = campaign.points_per_chunk(config["chunk_seconds"])
    return chunks_of(campaign, Path(chunk_folder(name)), most)


def campaign_chunks(name):
    """Return the files of the chunks of a campaign."""
    return [os.path.join(chunk_folder(name), f"{chunk}.nc") for chunk in requests_of(name)]


def named_campaign():
    """Return the name that the command gives, of a campaign that can be computed."""
    if "campaign" not in config:
        sys.exit("Name the campaign, for example: snakemake -c2 campaign --config campaign=smoke.")
    return campaign_of(config["campaign"]).name
