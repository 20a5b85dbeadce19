"""Figures, tables and data belong together, and to the configuration that is asked now."""

from granular_fronts.output.datasets import read_origins
from granular_fronts.output.provenance import disagreements
from questions import questions


def test_all_belongs_together_and_answers_the_configuration(results, configuration, made):
    asked = questions(configuration)
    origins = read_origins(results / "data", asked)
    records = [results / f"{stem}.json" for stem in (*made.figures, *made.tables)]
    assert not list(disagreements(records, origins, asked))
