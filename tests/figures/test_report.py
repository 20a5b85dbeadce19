"""The report shows what belongs together, and nothing else."""

import json
import re

import pandas as pd
import pytest
import xarray as xr
import yaml
from projects import ROOT
from write_report import write_report

from granular_fronts.output.datasets import read_dataset, write_dataset
from granular_fronts.output.provenance import source_of, write_provenance
from granular_fronts.output.tables import write_table

PNG = b"\x89PNG\r\n\x1a\n"
PARAMETERS = {
    "chain/scene": {"law": {"gamma": 0.06}},
    "precision/speed_error": {"repeats": 3},
}


def make_figure(results, stem, data):
    """A figure of a dataset, as far as the report reads it."""
    (results / "figures").mkdir(exist_ok=True)
    files = [results / f"figures/{stem}.{ending}" for ending in ("pdf", "png", "rst")]
    for file, content in zip(files, (b"%PDF", PNG, b"**Figure.** A *caption*."), strict=True):
        file.write_bytes(content)
    record = files[0].with_suffix(".json")
    texts = {"title": f"Title of {stem}", "alt": f"Seen in {stem}"}
    write_provenance(record, files, [data], **texts)
    return record


def make_table(results, name, data):
    """A table of a dataset, with its record."""
    table = pd.DataFrame({"problem": ["one"], "error_estimate": [1.234567e-12]})
    csv = results / f"tables/{name}.csv"
    write_table(table, table, csv, csv.with_suffix(".md"), [data])
    return csv.with_suffix(".json")


@pytest.fixture
def results(tmp_path):
    """A results folder with a figure and a table for each of two datasets."""
    for name, parameters in PARAMETERS.items():
        file = tmp_path / f"data/{name}.nc"
        dataset = xr.Dataset({"velocity": ((), 1.0, {"error_estimate": 0.0})})
        write_dataset(dataset, file, scene_id=file.stem, config=parameters)
        data = read_dataset(file)
        figure, table = ("fig01_front", "paper_numbers")
        if name.startswith("precision"):
            figure, table = ("fig14_speed_error", "speed_verdicts")
        make_figure(tmp_path, figure, data)
        make_table(tmp_path, table, data)
    for name, seconds in (("job", 1.0), ("other", 2.5)):
        (tmp_path / f"{name}.tsv").write_text(f"s\tmax_rss\n{seconds}\t10\n")
    (tmp_path / "verdict.txt").write_text("All is well.")
    return tmp_path


def write(results, on_demand=True, pages=(), **parameters):
    """Write the report and return its text."""
    names = ["figures/fig14_speed_error.json", "tables/speed_verdicts.json"] if on_demand else []
    names += pages
    write_report(
        template=ROOT / "workflow/report/page.html.j2",
        texts=ROOT / "workflow/tables.yaml",
        figures=[results / "figures/fig01_front.json"],
        tables=[results / "tables/paper_numbers.json"],
        on_demand=[results / name for name in names],
        parameters=PARAMETERS | parameters,
        results=results,
        benchmarks=[results / "job.tsv", results / "other.tsv"],
        verdict=results / "verdict.txt",
        configuration={"scenes": {"beads": 4}},
        page=results / "report.html",
    )
    return (results / "report.html").read_text(encoding="utf-8")


def test_page_holds_pictures_captions_tables_and_links(results):
    page = write(results)
    assert page.count("data:image/png;base64,") == 2
    assert 'alt="Seen in fig01_front"' in page
    assert "A <em>caption</em>." in page
    for file in ("figures/fig01_front.pdf", "tables/paper_numbers.csv"):
        assert f'href="{file}"' in page
        assert (results / file).exists()
    titles = yaml.safe_load((ROOT / "workflow/tables.yaml").read_text(encoding="utf-8"))
    assert titles["speed_verdicts"]["title"] in page
    assert "<td>1.2e-12" in page
    assert re.search(r"all jobs\s*</td>\s*<td[^>]*>\s*3\.5\s*</td>", page)
    made_from = json.loads(re.search(r'id="made-from">(.*?)</script>', page, re.DOTALL)[1])
    data = read_dataset(results / "data/chain/scene.nc")
    assert made_from["fig01_front"]["made_from"] == [source_of(data)]


def test_what_files_hold_is_shown_and_never_run(results):
    """A title, and a caption whose directives would insert a script or another file."""
    record = results / "figures/fig01_front.json"
    (results / "secret.txt").write_text("what nobody should read")
    caption = f".. raw:: html\n\n   <em>run</em>\n\n.. include:: {results}/secret.txt\n"
    record.with_suffix(".rst").write_text(caption)
    data = read_dataset(results / "data/chain/scene.nc")
    files = [record.with_suffix(f".{ending}") for ending in ("pdf", "png", "rst")]
    title = "</script><script>run()</script>"
    write_provenance(record, files, [data], title=title, alt="")
    page = write(results)
    assert "<script>run()" not in page
    assert "<em>run</em>" not in page
    assert "nobody should read" not in page
    made_from = re.search(r'id="made-from">(.*?)</script>', page)[1]
    assert json.loads(made_from)["fig01_front"]["title"] == title


def test_page_leaves_out_and_names_what_answers_another_configuration(results):
    page = write(results, **{"precision/speed_error": {"repeats": 5}})
    assert "Seen in fig14_speed_error" not in page
    assert re.search(r"that are there now:\s+fig14_speed_error, speed_verdicts", page)


def test_page_of_parts_that_disagree_is_refused(results):
    with pytest.raises(ValueError, match="answers another configuration of scene scene"):
        write(results, **{"chain/scene": {"law": {"gamma": 0.21}}})
    assert not (results / "report.html").exists()


def test_report_links_to_the_page_to_explore_where_it_is_of_the_data_that_are_there(results):
    assert "explore.html" not in write(results)
    page, record = results / "explore.html", results / "explore.json"
    page.write_text("A page.")
    data = read_dataset(results / "data/chain/scene.nc")
    write_provenance(record, [page], [data])
    assert '<a href="explore.html">' in write(results, pages=["explore.json"])
    write_provenance(record, [page], [data.assign_attrs(data_digest="0")])
    text = write(results, pages=["explore.json"])
    assert '<a href="explore.html">' not in text
    assert re.search(r"Left out[^<]*explore", text)
