"""The parameters of each dataset, and those that the paper has for it."""

from dataset_parameters import (
    FAMILIES,
    default_parameters,
    parameters_of_papers,
    parameters_on_demand,
    precision_problems,
)
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
