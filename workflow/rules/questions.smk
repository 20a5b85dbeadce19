"""What each dataset answers, and what the paper asks of the same dataset."""

from altered_files import make_altered_files_again
from granular_fronts.output.provenance import code_version, question_digest, read_record
from granular_fronts.scenes.yaml_files import read_yaml
from questions import FAMILIES, precision_problems, questions, questions_on_demand

ASKED = questions(config) | questions_on_demand(config)
DATASETS = expand("<results>/data/{dataset}.nc", dataset=questions(config))


def load_yaml(*path):
    """Read a YAML file of the project."""
    return read_yaml(project(*path))


def question(dataset):
    """Return the part of the configuration that a dataset answers."""
    folder, _, name = dataset.partition("/")
    return campaign_of(name).given if folder == "campaigns" else ASKED[dataset]


def check_history():
    """Refuse results of another configuration or code of which Snakemake has no record.

    What Snakemake knows of a file lies in .snakemake. Where that is lost, or the results come from
    elsewhere, it would take any figure for one of the present configuration and code.
    """
    if glob(".snakemake/metadata/*"):
        return
    expected = {name.rpartition("/")[2]: question_digest(part) for name, part in ASKED.items()}
    places = f"{config['results']}/explore.json", f"{config['results']}/*/*.json"
    for file in sorted(file for place in places for file in glob(place)):
        record = read_record(Path(file))
        differs = [
            f"answers another configuration of scene {made_from['scene']}"
            for made_from in record.get("made_from", [])
            if expected.get(made_from["scene"], made_from["question"]) != made_from["question"]
        ]
        if record.get("code_version", code_version()) != code_version():
            differs.append("was made by another version of the code")
        if differs:
            sys.exit(
                f"{file} {differs[0]}, and the record of how it was made (.snakemake) is gone: "
                f"remove {config['results']}, or name another folder (--config results=...)."
            )


def asked(*datasets):
    """Return a function for `params`: the questions behind the data of a figure or a table.

    Whatever is made from data depends on them even while the data are missing, as they are after a
    job failed.
    """
    return lambda wildcards: {dataset: question(dataset) for dataset in datasets}


@cache
def paper_questions():
    """Return what the paper asks, by the name of the scene."""
    every = questions(DEFAULTS) | questions_on_demand(DEFAULTS)
    return {dataset.rpartition("/")[2]: part for dataset, part in every.items()}


def reference(*datasets):
    """Return a function for `params`: what the paper asks of these datasets, by scene.

    A campaign is ours, and its own reference.
    """
    scenes = {dataset.rpartition("/")[2]: dataset for dataset in datasets}
    return lambda wildcards: {
        scene: question(dataset) if dataset.startswith("campaigns/") else paper_questions()[scene]
        for scene, dataset in scenes.items()
        if dataset.startswith("campaigns/") or scene in paper_questions()
    }


check_history()
make_altered_files_again()
