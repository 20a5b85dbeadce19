"""Figures, tables and report of the paper from nothing: `snakemake -c2`, or name one target."""

from snakemake.utils import min_version

# The version that the tests run.
min_version("9.27")


include: "workflow/rules/common.smk"


from granular_fronts.scenes.configuration import folder_errors, validate_configuration
from granular_fronts.errors import InputError, exit_on_error
from granular_fronts.scenes.yaml_files import load_configuration, merge

# Snakemake itself merges files key by key, without a word on a key that is left over from another
# kind, and says of a YAML error neither line nor column.
with exit_on_error("The configuration cannot be computed."):
    GIVEN = workflow.config_settings
    DEFAULTS = load_configuration("config/default.yaml")
    config = merge(load_configuration("config/default.yaml", *GIVEN.configfiles), GIVEN.config)
    # Whether results can be written counts where a run starts, see onstart.
    validate_configuration(config, GIVEN.config, writes=False)


pathvars:
    results=config["results"],
    logs="<results>/logs",
    benchmarks="<results>/benchmarks",


# Not for a dry run, which writes nothing.
onstart:
    for error in folder_errors(config["results"]):
        sys.exit(error)


# Otherwise any result would count as one of the present configuration and code.
if glob(f"{config['results']}/data/*/*.nc") and not glob(".snakemake/metadata/*"):
    sys.exit(
        f"Snakemake (.snakemake) does not know how the results in {config['results']} were made: "
        "remove this folder, or name another (--config results=...)."
    )


include: "workflow/rules/parameters.smk"
include: "workflow/rules/products.smk"
include: "workflow/rules/figures.smk"
include: "workflow/rules/kernels.smk"
include: "workflow/rules/scenes.smk"
include: "workflow/rules/studies.smk"
include: "workflow/rules/tables.smk"
include: "workflow/rules/precision.smk"
include: "workflow/rules/hard_cases.smk"
include: "workflow/rules/honesty.smk"
include: "workflow/rules/proofs.smk"
include: "workflow/rules/referee.smk"
include: "workflow/rules/campaign_chunks.smk"
include: "workflow/rules/campaign.smk"
include: "workflow/rules/checks.smk"
include: "workflow/rules/report.smk"
include: "workflow/rules/papers.smk"


rule all:
    """The report and the tests of all finished files; made when no target is named."""
    default_target: True
    input:
        report="<results>/report.html",
        verdict="<results>/checks.txt",
        # Nothing is up to date while something that it was made from is missing.
        figures=FIGURE_FILES,
        tables=TABLE_FILES,
        datasets=DATASETS,
    message:
        "Done: open {input.report}."
