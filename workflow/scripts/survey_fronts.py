"""Exact fronts over exponents and dampings, each beside the continuum fronts.

A few seconds: python workflow/scripts/survey_fronts.py
    --survey config/default.yaml:exact_fronts.survey --dataset survey.nc
"""

from pathlib import Path

import numpy as np

from granular_fronts.output.datasets import write_dataset
from granular_fronts.studies.front_survey import survey_fronts as solve_survey
from step import run_step


def survey_fronts(survey: dict, dataset: Path) -> None:
    """Solve the fronts and write what is known of them.

    Parameters
    ----------
    survey : dict
        As under ``exact_fronts.survey`` of the configuration.
    dataset : Path
        The netCDF file to write, on (alpha, gamma).
    """
    fronts = solve_survey(survey["alpha"], np.geomspace(**survey["gamma"]))
    write_dataset(fronts, dataset, scene_id="survey", config=survey)


if __name__ == "__main__":
    run_step(survey_fronts, globals().get("snakemake"))
