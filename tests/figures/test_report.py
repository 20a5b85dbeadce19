"""The report shows pictures, tables and verdicts, and nothing else."""

import re
from html import unescape
from pathlib import Path

import pandas as pd
import pytest
from browser import CHROMIUM, browser
from PIL import Image
from write_report import write_report

from granular_fronts.output.tables import write_table
from projects import ROOT

PNG = b"\x89PNG\r\n\x1a\n"
VERDICTS = ["holds"] * 8 + ["reproduced", "not judged", "does not hold", "reproduced"]
FIGURES = ("figures/fig01_front", "figures/own_front")
TABLES = ("tables/paper_numbers", "tables/widths")


def make_figure(results, stem):
    """A figure, as far as the report reads it."""
    (results / "figures").mkdir(exist_ok=True)
    for ending, content in {"pdf": b"%PDF", "png": PNG, "rst": b"**Figure.** A *caption*."}.items():
        (results / f"{stem}.{ending}").write_bytes(content)


def make_table(results, stem):
    """A table; that of the paper holds statements."""
    table = pd.DataFrame({"problem": ["one"], "error_estimate": [1.234567e-12]})
    if stem == "tables/paper_numbers":
        rows = len(VERDICTS)
        table = pd.DataFrame(
            {
                "quantity": [f"number {k}" for k in range(rows)],
                "paper_place": "section 1",
                "printed": "0.5",
                "computed": [0.25 + k for k in range(rows)],
                "computed_error": 1.234567e-12,
                "verdict": VERDICTS,
                "criterion": "0.5 within 0.1",
                "remark": "",
                "expected": "holds",
            }
        )
    write_table(table, table, results / f"{stem}.csv", results / f"{stem}.md")


@pytest.fixture
def results(tmp_path):
    """A results folder with two figures and two tables."""
    (tmp_path / "tables").mkdir()
    for figure, table in zip(FIGURES, TABLES, strict=True):
        make_figure(tmp_path, figure)
        make_table(tmp_path, table)
    for name, seconds in (("job", 1.0), ("other", 2.5)):
        (tmp_path / f"{name}.tsv").write_text(f"s\tmax_rss\n{seconds}\t10\n")
    (tmp_path / "verdict.txt").write_text("All is well.")
    return tmp_path


def write(results, figures=FIGURES, title="Title"):
    """Write the report and return its text."""
    texts = {Path(stem).name: f"Seen in {Path(stem).name}." for stem in figures}
    texts |= {f"table_{Path(stem).name}": "It means much." for stem in TABLES}
    (results / "texts").mkdir(exist_ok=True)
    for name, comment in texts.items():
        text = f"{title}\n=====\n\n.. {comment}\n\nWhat it holds."
        (results / f"texts/{name}.rst").write_text(text, encoding="utf-8")
    write_report(
        template=ROOT / "workflow/page.html.j2",
        texts=[f"{results}/texts/{name}.rst" for name in texts],
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
    assert 'alt="Seen in fig01_front."' in page
    assert "A <em>caption</em>." in page
    for file in ("figures/fig01_front.pdf", "tables/paper_numbers.csv"):
        assert f'href="{file}"' in page
        assert (results / file).exists()
    assert "What it holds." in page
    assert '<td class="number">1.2e-12</td>' in page
    assert '<td class="number">0.25 <wbr>± 1.2e-12</td>' in page
    assert '<th scope="col">expected' not in page
    assert '<td>all jobs</td><td class="number">3.5</td>' in page


def test_what_files_hold_is_shown_and_never_run(results):
    """A title, and a caption whose directives would insert a script or another file."""
    (results / "secret.txt").write_text("what nobody should read")
    caption = f".. raw:: html\n\n   <em>run</em>\n\n.. include:: {results}/secret.txt\n"
    (results / "figures/fig01_front.rst").write_text(caption)
    page = write(results, title="</script><script>run()</script>")
    assert "<script>run()" not in page
    assert "<em>run</em>" not in page
    assert "nobody should read" not in page


def test_score_counts_the_verdicts_of_its_table_and_shows_what_does_not_hold(results):
    page = write(results)
    card = page[page.index('class="score') : page.index("<nav")]
    counts = re.findall(r'<span class="(\w+)">(.) ([a-z ]+): (\d+)</span>', card)
    verdicts = pd.Series(VERDICTS).value_counts()
    assert {verdict: int(count) for _, _, verdict, count in counts} == verdicts.to_dict()
    signs = {verdict: (name, sign) for name, sign, verdict, _ in counts}
    assert len({signs[one] for one in ("holds", "not judged", "does not hold")}) == 3
    cells = re.findall(r"<td[^>]*>(.*?)</td>", page[page.index('id="paper_numbers"') :])
    for verdict, count in verdicts.items():
        assert cells.count(f"{signs[verdict][1]} {verdict}") == count
    failed = re.findall(r"<li>(.*?)</li>", card, re.DOTALL)
    assert len(failed) == 1
    assert "number 10" in failed[0]
    assert "“0.5”" in unescape(failed[0])


@pytest.mark.slow
@pytest.mark.skipif(CHROMIUM is None, reason="there is no Chromium to show the report")
def test_rows_unfold_and_nothing_is_wider_than_the_window(results, tmp_path):
    for stem in FIGURES:
        Image.new("RGB", (1380, 1100), "grey").save(results / f"{stem}.png")
    write(results)
    report = (results / "report.html").as_uri()
    with browser(tmp_path / "profile") as page:
        page.open(report, 400, 900)
        page.wait_for("document.readyState === 'complete'")
        height = "document.querySelector('#paper_numbers table').offsetHeight"
        folded = page.evaluate(height)
        page.evaluate("document.querySelector('#paper_numbers summary').click()")
        page.wait_for(f"{height} > {folded}")
        for width in (400, 1280, 1920):
            page.resize(width, 900)
            page.wait_for("document.documentElement.scrollWidth <= innerWidth")
        # In print, tables are as wide as the page at most.
        page.call("Emulation.setEmulatedMedia", media="print")
        page.resize(703, 1000)
        page.wait_for("document.documentElement.scrollWidth <= innerWidth")
        assert page.complaints() == []
        assert page.requests() == [report]
