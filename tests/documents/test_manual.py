"""What the manual makes of the code: public names and keys of the configuration."""

import doctest
import re
from importlib import import_module

import matplotlib
import pytest
from pages import load_script

import granular_fronts as gf
from granular_fronts.campaign.kinds import KINDS

PAGES, KEYS = map(load_script, ("generate", "configuration"))


# Public names.


def test_every_public_name_is_in_one_group_with_an_example():
    names = " ".join(PAGES.NAMES.values()).split()
    assert sorted(names) == gf.__all__
    assert list(PAGES.NAMES) == [group.page for group in PAGES.GROUPS]
    assert [value for value in FOUND if ">>> " not in value.__doc__] == []


FOUND = [getattr(gf, name) for name in gf.__all__ if name != "plot"]
FOUND += [getattr(gf.plot, name) for name in gf.plot.__all__]


@pytest.mark.parametrize("module", sorted({"granular_fronts", *(v.__module__ for v in FOUND)}))
def test_examples_give_what_they_show(module):
    if "proofs" in module:
        pytest.importorskip("flint")
    matplotlib.use("agg")
    found = doctest.testmod(import_module(module), extraglobs={"gf": gf})
    assert found.failed == 0 < found.attempted


# The configuration.


def rows_of(page, heading):
    """The cells of each row of the tables under a heading, by the first cell."""
    [section] = [part for part in page.split("\n## ") if part.startswith(f"{heading}\n")]
    rows = [re.split(r"(?<!\\)\|", line)[1:-1] for line in section.splitlines() if line[:1] == "|"]
    return {row[0].strip(" `"): [cell.strip() for cell in row[1:]] for row in rows}


def test_a_key_has_type_default_unit_and_meaning():
    page = KEYS.configuration_page()
    top, chain = rows_of(page, "At the top"), rows_of(page, "scenes.chain.⟨name⟩")
    assert top["chunk_seconds"][:3] == ["number, > 0", "`30`", "s"]
    assert chain["beads"][:3] == ["whole number or mapping, ≥ 1", "required", "1"]
    assert chain["boundary.ramp"][1] == "`0.0`"
    assert chain["boundary.ramp"][3].startswith("For kind `piston`: ")
    assert chain["record.probes"][:2] == ["mapping", "none"]
    assert set(chain) >= {"law.alpha", "law.elastic", "record.probes.⟨name⟩.beads"}


def test_every_axis_and_scalar_of_a_campaign_is_listed():
    page = KEYS.campaign_page()
    for name, kind in KINDS.items():
        rows = rows_of(page, f"Kind {name}")
        assert rows.keys() >= kind.point.model_fields.keys() | kind.scalars.keys()
