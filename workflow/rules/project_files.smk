"""The files of the project that the crate of a run holds."""

# What others need to make the same results again, and to read about them.
PROJECT_FILES = [
    "*environment.txt",
    "CHANGELOG.md",
    "CITATION.cff",
    "CONTRIBUTING.md",
    "Containerfile",
    "LICENSE",
    "Makefile",
    "README.md",
    "Snakefile",
    "codecheck.yml",
    "config/**/*",
    "docs/**/*",
    "papers/**/*",
    "profiles/default/config.yaml",
    "pyproject.toml",
    "src/**/*",
    "tests/**/*.py",
    "tests/proofs/test_proof_data/*",
    "tools/**/*.py",
    "workflow/**/*",
]


# Written by the build of the manual, by Python and by editors.
MADE_FOLDERS = {
    "__pycache__",
    ".ipynb_checkpoints",
    "_build",
    "generated",
    "jupyter_execute",
}


def project_files(wildcards):
    """Return the files of the project that the crate holds."""
    found = [file for name in PROJECT_FILES for file in Path(PROJECT).glob(name)]
    return [
        project(file)
        for file in sorted(found)
        if file.is_file() and not MADE_FOLDERS & set(file.relative_to(PROJECT).parts)
    ]
