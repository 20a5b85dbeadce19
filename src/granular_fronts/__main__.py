"""Simulate a chain: ``python -m granular_fronts simulate scene.yaml out.nc``."""

import argparse
import sys

from granular_fronts.chain.simulate import simulate_chain
from granular_fronts.errors import InputError, NoSpaceError, SolveError
from granular_fronts.output.datasets import write_dataset
from granular_fronts.scenes.yaml_files import read_yaml

if __name__ == "__main__":
    parser = argparse.ArgumentParser(prog="python -m granular_fronts", description=__doc__)
    parser.add_argument("command", choices=["simulate"])
    parser.add_argument("scene", help="a YAML file with the keys of one scene")
    parser.add_argument("dataset", help="the netCDF file to write")
    given = parser.parse_args()
    try:
        scene = read_yaml(given.scene)
        motion = simulate_chain(scene)
        write_dataset(motion, given.dataset, scene_id="scene", config=scene)
    except (InputError, SolveError, NoSpaceError, OSError) as error:
        sys.exit(str(error))
