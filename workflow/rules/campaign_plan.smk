"""Campaigns are planned by a job; a dry run measures nothing and writes nothing."""

CAMPAIGNS = project("config", "campaigns")
CAMPAIGN_NAME = "[a-z][a-z0-9_]*"
KERNELS_OF_KIND = {
    "chain": rules.compile_kernels.output.stamp,
    "front": rules.compile_front_kernels.output.stamp,
    "heteroclinic": rules.compile_continuum_kernels.output.stamp,
    "ring": [
        rules.compile_kernels.output.stamp,
        rules.compile_continuum_kernels.output.stamp,
    ],
}


@cache
def campaign_of(name):
    """Read a campaign and check it; nothing of this is loaded before a campaign is asked for."""
    from granular_fronts.campaign.definition import load_campaign

    try:
        return load_campaign(CAMPAIGNS, name)
    except InputError as error:
        sys.exit(f"The campaign cannot be computed.\n{error}")


def campaign_kernels(wildcards):
    """Return the stamps of the kernels that solve a campaign."""
    return KERNELS_OF_KIND[campaign_of(wildcards.campaign).kind_name]


def campaign_code(script):
    """Return a function for `params`: a digest of the code of a script and of a campaign's kind."""
    return lambda wildcards: digest_of(script, campaign_of(wildcards.campaign).kind.module)


def campaign_chunks(name):
    """Return the files of the chunks of a campaign, once it is planned."""
    from granular_fronts.campaign.plan import read_plan

    file = checkpoints.plan_campaign.get(campaign=name).output.plan
    chunks = [os.path.join(os.path.dirname(file), chunk) for chunk in read_plan(file).chunks]
    return [f"{chunk}.nc" for chunk in chunks]


def named_campaign():
    """Return the name that the command gives, of a campaign that can be computed."""
    if "campaign" not in config:
        sys.exit("Name the campaign, for example: snakemake -c2 campaign --config campaign=smoke.")
    return campaign_of(config["campaign"]).name
