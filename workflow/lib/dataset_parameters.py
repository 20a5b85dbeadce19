"""The parameters of each dataset: the part of the configuration that its rule is given.

A figure or a table depends on its data and on their parameters.  When a job fails, Snakemake has
already removed the dataset. Then no trace is left that an earlier figure belongs to other
parameters.
"""

from collections.abc import Mapping
from typing import Any

from papers import listed_in_papers, scenes_of_papers

FAMILIES = {
    "chain": "chain",
    "periodic": "periodic",
    "continuum": "heteroclinic",
    "fronts": "front",
}
"""Folder of the data of each family of scenes, and the key of the family under ``scenes``."""


def default_parameters(configuration: Mapping[str, Any]) -> dict[str, Any]:
    """Return the parameters of each dataset of the default targets, from a merged configuration."""
    groups = [(folder, configuration["scenes"][family]) for folder, family in FAMILIES.items()]
    groups += [("fronts", configuration["exact_fronts"]), ("laws", configuration["laws"])]
    parameters = {
        f"{folder}/{name}": one for folder, group in groups for name, one in group.items()
    }
    exponents = configuration["front_exponents"]
    return parameters | {"continuum/log_burgers_fronts": {"exponents": exponents}}


def parameters_on_demand(configuration: Mapping[str, Any]) -> dict[str, Any]:
    """Return the parameters of the datasets that only targets named in the command need."""
    return {
        "precision/speed_error": {
            f"precision_{family}": problems
            for family, problems in precision_problems(configuration).items()
        },
        "precision/hard_cases": {"cases": configuration["hard_cases"]},
        **{f"precision/honesty_{kind}": one for kind, one in configuration["honesty"].items()},
        "proofs/fronts": configuration["proofs"]["fronts"],
        "proofs/intervals": configuration["proofs"]["intervals"],
        "proofs/shown_front": shown_front(configuration),
    }


def parameters_of_papers() -> dict[str, Any]:
    """Return the parameters of the datasets of papers of others, which no configuration changes."""
    return {
        f"{folder}/{name}": scene
        for folder, family in FAMILIES.items()
        for name, scene in scenes_of_papers(family).items()
    } | {
        f"{study['folder']}/{name}": study["parameters"]
        for name, study in listed_in_papers("studies").items()
    }


def precision_problems(configuration: Mapping[str, Any]) -> dict[str, Any]:
    """Return the problems of each family, rings with their scenes."""
    scenes, families = configuration["scenes"]["periodic"], dict(configuration["precision"])
    families["log_burgers"] = {
        f"log_burgers_{name}": {**problem, "scene": scenes[name]}
        for name, problem in families["log_burgers"].items()
    }
    return families


def shown_front(configuration: Mapping[str, Any]) -> dict[str, Any]:
    """Return the proved front that a figure shows, by its name and parameters."""
    proofs = configuration["proofs"]
    return {"name": proofs["shown"], **proofs["fronts"][proofs["shown"]]}
