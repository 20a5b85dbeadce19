"""Datasets: their files, their part of the configuration, and what their rules are given."""

# Folder of the data of each family of scenes, and of each section that holds studies.
FOLDERS = {"chain": "chain", "periodic": "periodic", "heteroclinic": "continuum", "front": "fronts"}
SECTIONS = {"fronts": "exact_fronts", "laws": "laws"}


def datasets_of(family):
    """Return the datasets of the scenes of a family."""
    return [f"{FOLDERS[family]}/{scene}" for scene in config["scenes"][family]]


def data(*datasets):
    """Return the files of some datasets."""
    return [f"<results>/data/{dataset}.nc" for dataset in datasets]


def parameters(dataset, configuration=None):
    """Return the part of a configuration that a dataset is computed with; None if it has none."""
    configuration = configuration or config
    if dataset == "continuum/log_burgers_fronts":
        return {"exponents": configuration["front_exponents"]}
    folder, _, name = dataset.partition("/")
    if dataset in STUDIES:
        return configuration[SECTIONS[folder]][name]
    [family] = [family for family in FOLDERS if FOLDERS[family] == folder]
    return configuration["scenes"][family].get(name)


def shown(*datasets):
    """Return a function for `params`: by scene the parameters that are shown, and the paper's.

    A job that fails has no dataset left. Then nothing else says that an older picture belongs to
    other parameters.
    """
    return lambda wildcards: {
        dataset.partition("/")[2]: [parameters(dataset), parameters(dataset, DEFAULTS)]
        for dataset in datasets
    }


def kernels(*packages):
    """Return the stamps of the compiled kernels of some packages."""
    return [f"<results>/kernels/{package}.json" for package in packages]


def scene(family):
    """Return a function for `params`: the scene of a family that the wildcard names."""
    return lambda wildcards: config["scenes"][family][wildcards.scene]


def made_by(dataset):
    """Return the modules that make the dataset of a study: its script and its function's."""
    return "study", f"granular_fronts.studies.{STUDIES[dataset][0]}"
