"""Figures, tables and report of the paper from nothing: `snakemake -c2`, or name one target."""


configfile: "config/default.yaml"


include: "workflow/rules/common.smk"


from granular_fronts.scenes.configuration import validate_configuration
from granular_fronts.scenes.errors import ConfigurationError

try:
    validate_configuration(config, workflow.configfiles, workflow.config_settings.config)
except ConfigurationError as error:
    sys.exit(f"The configuration cannot be computed.\n{error}")


pathvars:
    results=config["results"],
    logs="<results>/logs",
    benchmarks="<results>/benchmarks",


rule all:
    input:
        "<results>/report.html",
        "<results>/checks.txt",
    message:
        "Done: open {input[0]}."


include: "workflow/rules/chain.smk"
include: "workflow/rules/continuum.smk"
include: "workflow/rules/fronts.smk"
include: "workflow/rules/laws.smk"
include: "workflow/rules/figures.smk"
include: "workflow/rules/figure_targets.smk"
include: "workflow/rules/tables.smk"
include: "workflow/rules/checks.smk"
include: "workflow/rules/report.smk"
include: "workflow/rules/precision.smk"
include: "workflow/rules/hard_cases.smk"
include: "workflow/rules/campaign.smk"
