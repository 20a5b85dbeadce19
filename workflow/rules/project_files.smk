"""The files of the project that the record of a run holds."""

# What others need to make the same results again. How the project is developed is no part of it.
PROJECT_FILES = [
    "CITATION.cff",
    "Containerfile",
    "LICENSE",
    "Makefile",
    "README.md",
    "Snakefile",
    "codecheck.yml",
    "config/**/*",
    "environment.txt",
    "profiles/default/config.yaml",
    "pyproject.toml",
    "src/**/*",
    "tests/*.py",
    "tests/artefacts/*.py",
    "workflow/**/*",
]


def project_files(wildcards):
    """Return the files of the project that the record holds."""
    found = [file for name in PROJECT_FILES for file in Path(PROJECT).glob(name)]
    return [
        project(file)
        for file in sorted(found)
        if file.is_file() and not {"__pycache__", ".ipynb_checkpoints"} & set(file.parts)
    ]
