"""Validate configuration files: ``python -m granular_fronts.scenes config/default.yaml mine.yaml``.

Snakemake says of a file with a YAML error only that it has one; this says where it is.
"""

import sys

from granular_fronts.errors import InputError, end_with_reader
from granular_fronts.scenes.configuration import validate_configuration
from granular_fronts.scenes.yaml_files import load_configuration

if __name__ == "__main__":
    end_with_reader()
    try:
        validate_configuration(load_configuration(*sys.argv[1:]), sys.argv[1:])
    except InputError as error:
        sys.exit(str(error))
    print("The configuration can be computed.")
