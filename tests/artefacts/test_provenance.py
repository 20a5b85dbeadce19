"""Figures, tables and data belong together, and to the present configuration."""

from dataset_parameters import default_parameters
from granular_fronts.output.datasets import read_sources
from granular_fronts.output.provenance import disagreements


def test_all_belongs_together_and_answers_the_configuration(results, configuration, made):
    parameters = default_parameters(configuration)
    sources = read_sources(results / "data", parameters)
    assert len(sources) == len(parameters)
    for stem in (*made.figures, *made.tables):
        assert not list(disagreements(results / f"{stem}.json", parameters, sources))
