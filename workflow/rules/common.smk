"""Where things are, and the functions that several rules share."""

import os
import sys
from functools import cache
from glob import glob
from pathlib import Path

# Jobs start in this folder and find the package without an installation.
SOURCE, LIBRARY = "src", "workflow/lib"
sys.path[:0] = [os.path.join(workflow.basedir, folder) for folder in (SOURCE, LIBRARY)]
os.environ.update(
    PYTHONPATH=os.pathsep.join(filter(None, [SOURCE, LIBRARY, os.environ.get("PYTHONPATH")])),
    NUMBA_CACHE_DIR=os.path.join(workflow.basedir, ".numba_cache"),
    # A notebook hands its child processes a backend that the pinned packages lack.
    MPLBACKEND="agg",
    # Pydantic would look for plugins in every installed package, at each start of a job.
    PYDANTIC_DISABLE_PLUGINS="__all__",
)

# Snakemake starts its jobs by this name, without quotation marks.
if " " in sys.executable:
    sys.exit(
        f"Snakemake starts no job by {sys.executable}, since there is a blank in this path: move "
        "the folder, or make the environment elsewhere."
    )

# Of an option that is given twice Snakemake drops the first, without a word.
for names, form in (
    (("--configfile", "--configfiles"), "--configfile a.yaml b.yaml"),
    (("--config", "-C"), "--config results=results/mine campaign=smoke"),
):
    if sum(word.partition("=")[0] in names for word in sys.argv) > 1:
        sys.exit(f"{names[0]} is given twice, but Snakemake reads only the last: write {form}.")

from captions import contents, files_of, read_texts
from granular_fronts.errors import InputError, exit_on_error
from granular_fronts.scenes.configuration import folder_errors, validate_configuration
from granular_fronts.scenes.sentences import read_part
from granular_fronts.scenes.yaml_files import load_configuration, merge, read_yaml
from granular_fronts.numerics.imports import import_closure, module_files
from granular_fronts.numerics.source_code import code_digest

MODULES = module_files(
    *(
        Path(workflow.basedir, folder)
        for folder in (SOURCE, LIBRARY, "workflow/scripts", "workflow/scripts/figures")
    ),
    *map(Path, sorted(glob(os.path.join(workflow.basedir, "projects", "*", "")))),
)
# It has no part in what a script makes.
del MODULES["job"]


@cache
def digest_of(*names):
    """Return a digest of the code of some modules and of all that these import."""
    files = [MODULES[name] for name in import_closure(names, MODULES)]
    return code_digest(files, Path(workflow.basedir))


def code(*names):
    """Return a function for `params`: a digest of what a script and all that it imports do.

    A job is repeated when this code changes, and not for a docstring or a comment. What a script
    imports by a string is named after it, with wildcards. Nothing is read before a job is planned.
    """
    return lambda wildcards: digest_of(*(name.format(wildcards=wildcards) for name in names))


def measured_by(statements):
    """Return the modules whose functions the statements of a file name as their measures."""
    measures = {statement["measure"].rpartition(".")[0] for statement in read_yaml(statements)}
    return sorted(f"granular_fronts.{one}" if one not in MODULES else one for one in measures)


def figure(stem, texts="workflow/captions"):
    """Return the files of a figure, for the output of its rule; its texts are in a folder."""
    return {
        "pdf": f"<results>/figures/{stem}.pdf",
        "png": report(
            f"<results>/figures/{stem}.png",
            caption=os.path.abspath(f"{config['results']}/figures/{stem}.rst"),
            category="Figures",
            labels={"figure": stem, "title": read_texts(f"{texts}/{stem}.rst").title},
        ),
        "caption": f"<results>/figures/{stem}.rst",
    }


def table(stem):
    """Return the files of a table, for the output of its rule: all digits, and for reading."""
    return {"csv": f"<results>/tables/{stem}.csv", "markdown": f"<results>/tables/{stem}.md"}


JUDGED = {}
"""For each project with statements its scenes, as they are computed and as its config.yaml says."""

MADE_BY = {}
"""For datasets of projects the function that makes each, `module.function`, and its settings."""


def one_of(names):
    """Return a constraint of a wildcard to some names; without any it matches nothing."""
    return "|".join(names) or "(?!)"


def project_settings(name, part):
    """Return the settings of a project as they are computed, and those of its own config.yaml.

    `part` is the class that describes them; a configuration changes them below projects.NAME.
    """
    with exit_on_error(f"The project {name} cannot be computed."):
        own = load_configuration(f"projects/{name}/config.yaml")
        given = merge(own, config.get("projects", {}).get(name, {}))
        return [read_part(part, settings, f"{name}: ").plain() for settings in (given, own)]
