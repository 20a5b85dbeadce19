"""The parameters of each dataset, and those that the paper has for it."""

from altered_files import make_altered_files_again
from dataset_parameters import (
    FAMILIES,
    default_parameters,
    parameters_of_papers,
    parameters_on_demand,
    precision_problems,
)
from granular_fronts.output.files import read_json
from granular_fronts.output.provenance import code_version, disagreements
from granular_fronts.scenes.yaml_files import read_yaml
from papers import listed_in_papers, papers, scenes_of_papers

# A mistake in a paper's folder is one sentence.
with exit_on_error("A paper of others cannot be computed."):
    papers()

PARAMETERS = default_parameters(config) | parameters_on_demand(config) | parameters_of_papers()
DATASETS = expand("<results>/data/{dataset}.nc", dataset=default_parameters(config))


def parameters_of(dataset):
    """Return the part of the configuration that a dataset is computed with."""
    folder, _, name = dataset.partition("/")
    return campaign_of(name).given if folder == "campaigns" else PARAMETERS[dataset]


def is_complete(provenance):
    """Whether a JSON file is the provenance of files that all are there."""
    described = read_json(provenance)
    files = described.get("files", {}) if isinstance(described, dict) else {}
    return bool(files) and all(provenance.with_name(name).exists() for name in files)


def check_history():
    """Refuse results of other parameters or code of which Snakemake has no history.

    What Snakemake knows of a file lies in .snakemake. Where that is lost, or the results come from
    elsewhere, any figure would count as one of the present configuration and code.
    """
    if glob(".snakemake/metadata/*"):
        return
    places = "figures/*", "tables/*"
    for file in sorted(
        file for place in places for file in glob(f"{config['results']}/{place}.json")
    ):
        if not is_complete(Path(file)):
            continue  # Snakemake makes again what is missing.
        found = list(disagreements(Path(file), PARAMETERS))
        if read_json(file).get("code_version") != code_version():
            found.append(f"{file} was made by another version of the code")
        if found:
            sys.exit(
                f"{found[0]}, but Snakemake (.snakemake) no longer knows how it was made: "
                f"remove {config['results']}, or name another folder (--config results=...)."
            )


def parameters(*datasets):
    """Return a function for `params`: the parameters of the data of a figure or a table.

    Whatever is made from data depends on them even while the data are missing, as they are after a
    job failed.
    """
    return lambda wildcards: {dataset: parameters_of(dataset) for dataset in datasets}


@cache
def paper_parameters():
    """Return the parameters that the paper has, by the name of the scene."""
    every = default_parameters(DEFAULTS) | parameters_on_demand(DEFAULTS) | parameters_of_papers()
    return {dataset.rpartition("/")[2]: part for dataset, part in every.items()}


def reference(*datasets):
    """Return a function for `params`: the parameters that the paper has for these datasets.

    They go by scene. A campaign is ours, and its own reference.
    """
    return lambda wildcards: {
        scene: parameters_of(dataset) if folder == "campaigns" else paper_parameters()[scene]
        for dataset in datasets
        for folder, _, scene in [dataset.partition("/")]
        if folder == "campaigns" or scene in paper_parameters()
    }


check_history()
make_altered_files_again()
