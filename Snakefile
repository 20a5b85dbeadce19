"""Figures, tables and report of the paper from nothing: `snakemake -c2`, or name one target."""

from snakemake.utils import min_version

# The version that the tests run.
min_version("9.27")


include: "workflow/rules/common.smk"


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


include: "workflow/rules/datasets.smk"
include: "workflow/rules/kernels.smk"
include: "workflow/rules/scenes.smk"
include: "workflow/rules/studies.smk"
include: "workflow/rules/figures.smk"
include: "workflow/rules/tables.smk"
include: "workflow/rules/campaign_chunks.smk"
include: "workflow/rules/campaign.smk"
include: "workflow/rules/report.smk"


PROJECTS = {Path(file).parent.name: file for file in sorted(glob("projects/*/rules.smk"))}
for name in sorted(set(config.get("projects", {})) - set(PROJECTS)):
    sys.exit(f"projects.{name} names no project: choose one of {', '.join(PROJECTS)}.")

for name in PROJECTS:
    sys.path.append(f"projects/{name}")

    include: PROJECTS[name]


include: "workflow/rules/projects.smk"


rule all:
    """Figures, tables, the tests of all finished files, and the report: what takes seconds."""
    default_target: True
    input:
        rules.report.output,
        # Nothing is up to date while something that it was made from is missing.
        rules.figures.input,
        rules.tables.input,
        data(*DATASETS),
