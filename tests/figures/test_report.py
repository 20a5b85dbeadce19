"""The report shows pictures, tables and verdicts, and nothing else."""

import re
from html import unescape
from itertools import product

import pandas as pd
import pytest
from browser import CHROMIUM, browser
from PIL import Image
from write_report import write_report

from granular_fronts.output.tables import write_table
from projects import ROOT

VERDICTS = ["holds"] * 8 + ["reproduced", "not judged", "does not hold", "reproduced"]
STATEMENTS = pd.DataFrame(
    {
        "quantity": [f"number {k}" for k in range(len(VERDICTS))],
        "paper_place": "section 1",
        "printed": "0.5",
        "computed": [0.25 + k for k in range(len(VERDICTS))],
        "computed_error": 1.234567e-12,
        "verdict": VERDICTS,
        "criterion": "0.5 within 0.1",
        "remark": "",
        "expected": "holds",
    }
)
TABLES = {
    "paper_numbers": STATEMENTS,
    "widths": pd.DataFrame({"problem": ["one"], "error_estimate": [1.234567e-12]}),
}
FIGURES = ("fig01_front", "own_front")
FILES = {"pdf": b"%PDF", "png": b"\x89PNG\r\n\x1a\n", "rst": b"**Figure.** A *caption*."}


@pytest.fixture
def results(tmp_path):
    """A results folder with two figures and two tables, as far as the report reads them."""
    for folder in ("tables", "figures", "texts"):
        (tmp_path / folder).mkdir()
    for figure, (ending, content) in product(FIGURES, FILES.items()):
        (tmp_path / f"figures/{figure}.{ending}").write_bytes(content)
    for name, table in TABLES.items():
        write_table(table, table, *(tmp_path / f"tables/{name}.{end}" for end in ("csv", "md")))
    for name, seconds in (("job", 1.0), ("other", 2.5)):
        (tmp_path / f"{name}.tsv").write_text(f"s\tmax_rss\n{seconds}\t10\n")
    (tmp_path / "verdict.txt").write_text("All is well.")
    return tmp_path


def write(results, title="Title"):
    """Write the report and return its text."""
    texts = [results / f"texts/{name}.rst" for name in (*FIGURES, *map("table_{}".format, TABLES))]
    for file in texts:
        text = f"{title}\n=====\n\n.. Seen in {file.stem}.\n\nWhat it holds."
        file.write_text(text, encoding="utf-8")
    write_report(
        template=ROOT / "workflow/page.html.j2",
        texts=texts,
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
    assert page.index("#fig01_front") < page.index("#beyond") < page.index("#own_front")
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
    shown = [signs[one] for one in ("holds", "not judged", "does not hold")]
    assert [len(set(column)) for column in zip(*shown, strict=True)] == [3, 3]
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
        Image.new("RGB", (1380, 1100), "grey").save(results / f"figures/{stem}.png")
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
