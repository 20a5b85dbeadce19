"""Validate configuration files: ``python -m granular_fronts.scenes config/default.yaml mine.yaml``.

Each file is laid over those before it, and the whole is checked.  Snakemake says of a file with a
YAML error only that it has one; this says where it is.

With ``--schema`` it prints the JSON schema by which editors complete and check keys, for example

    python -m granular_fronts.scenes --schema > config/schema.json
"""

import argparse
import json
import sys

from granular_fronts.errors import InputError, end_with_reader
from granular_fronts.scenes.configuration import Configuration, validate_configuration
from granular_fronts.scenes.yaml_files import load_configuration

if __name__ == "__main__":
    end_with_reader()
    parser = argparse.ArgumentParser(
        prog="python -m granular_fronts.scenes",
        description=__doc__,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument("files", nargs="*", metavar="FILE")
    parser.add_argument("--schema", action="store_true", help="print the JSON schema")
    asked = parser.parse_args()
    if asked.schema:
        print(json.dumps(Configuration.model_json_schema(), ensure_ascii=False, indent=1))
        sys.exit()
    files = asked.files or parser.error("name one FILE or more")
    try:
        validate_configuration(load_configuration(*files))
    except InputError as error:
        sys.exit(str(error))
    print("The configuration can be computed.")
