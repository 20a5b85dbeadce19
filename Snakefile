"""Figures, tables and report of the paper from nothing: `snakemake -c2`, or name one target."""

from snakemake.utils import min_version

# The version that the tests run.
min_version("9.27")


include: "workflow/rules/common.smk"


from granular_fronts.scenes.configuration import folder_errors, validate_configuration
from granular_fronts.errors import InputError, exit_on_error
from granular_fronts.scenes.yaml_files import load_configuration, merge

# Of a YAML error Snakemake itself says neither line nor column.
with exit_on_error("The configuration cannot be computed."):
    DEFAULTS = load_configuration(project("config", "default.yaml"))


configfile: project("config", "default.yaml")


# For a module Snakemake reads no file: what the other workflow gives is laid over the same values.
if workflow.modifier.is_module:
    config = merge(DEFAULTS, config)

with exit_on_error("The configuration cannot be computed."):
    # Whether results can be written counts where a run starts, see onstart.
    validate_configuration(
        config, workflow.configfiles, workflow.config_settings.config, writes=False
    )


pathvars:
    results=config["results"],
    logs="<results>/logs",
    benchmarks="<results>/benchmarks",


# Not for a dry run, which writes nothing.
onstart:
    hold_results_folder()


include: "workflow/rules/parameters.smk"
include: "workflow/rules/products.smk"
include: "workflow/rules/figures.smk"
include: "workflow/rules/kernels.smk"
include: "workflow/rules/scenes.smk"
include: "workflow/rules/studies.smk"
include: "workflow/rules/animation.smk"
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
include: "workflow/rules/help.smk"


rule all:
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


# Every script runs in the same environment; rules of another workflow around this one in its own.
for one in workflow.rules:
    if one.script and is_ours(one):
        one.conda_env = environment
        # Which script a parameter names Snakemake finds out for a job, but not for its archive.
        one.script = one.script.format(params=one.params)
