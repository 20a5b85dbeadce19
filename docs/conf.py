"""Manual of granular-fronts; `make docs` builds it of these pages, docstrings and results."""

import re
import shutil
import sys
from importlib import import_module
from pathlib import Path

from docutils import nodes
from sphinx import addnodes
from sphinx.transforms import SphinxTransform

HERE = Path(__file__).parent
sys.path[:0] = [str(HERE), str(HERE.parent / "src")]
generate, links, measured = map(import_module, ("generate", "links", "measured"))

project = "granular-fronts"
author = "The granular-fronts maintainers"
package = import_module("granular_fronts")
version = release = package.__version__
# Names are shown as a user writes them: gf.solve_front.
sys.modules |= {"gf": package, "gf.plot": package.plot}

# Formulas are set by a copy of MathJax in the manual, so that it is read without a network.
extensions = [
    "myst_nb",
    "numpydoc",
    "sphinx.ext.autodoc",
    "sphinx.ext.mathjax",
    "sphinx-mathjax-offline",
]
myst_enable_extensions = ["deflist", "dollarmath"]
myst_heading_anchors = 3
exclude_patterns = ["_build"]

# Every build runs the tutorials, since the package may have changed; one that fails stops it.
nb_execution_mode = "force"
nb_output_stderr = "remove"
nb_merge_streams = True
nb_execution_timeout = 120
nb_execution_raise_on_error = True
# Progress bars leave widgets behind, whose scripts a page would fetch from the network.
nb_ipywidgets_js = {}

autodoc_member_order = "bysource"
autodoc_typehints = "none"
default_role = "py:obj"
numpydoc_show_class_members = False

html_theme = "pydata_sphinx_theme"
html_title = "granular-fronts"
html_theme_options = {"show_prev_next": True, "navigation_with_keys": False}
html_context = {"default_mode": "auto"}
html_static_path = ["_static"]
html_css_files = ["manual.css"]
# Pages at the top without pages below them have no other place to lead to.
html_sidebars = {page: [] for page in ("gallery", "how_to", "practitioners")}
html_show_sourcelink = False
html_copy_source = False
# A browser refuses to fetch summaries where the manual is read from files.
html_show_search_summary = False


RESULTS, LIVE = HERE.parent / "results", HERE / "live"
SHOWN = set(links.TEXTS)
"""Files that a page links to: they are shown as pages of their own."""

UNLINKED = (nodes.FixedTextElement, nodes.literal, nodes.math, nodes.reference, nodes.title)
UNLINKED += (nodes.raw, addnodes.pending_xref, addnodes.desc_signature)


class Links(SphinxTransform):
    """Link what the text of a page names, and show the files that it links to."""

    default_priority = 750

    def apply(self):
        """Change one page."""
        page, folder = self.env.docname, Path(self.env.srcdir, self.env.docname).parent
        up = "../" * page.count("/")
        for node in list(self.document.findall(addnodes.download_reference)):
            file = (folder / node["reftarget"]).resolve()
            if file.parent == LIVE:
                uri = f"{up}{file.relative_to(HERE)}"
            else:
                SHOWN.add(file)
                uri = f"{up}sources/{file.relative_to(links.ROOT)}.html"
            node.replace_self(nodes.reference("", "", *node.children, refuri=uri))
        for node in list(self.document.findall(nodes.Text)):
            parent, text, new, end = node.parent, node.astext(), [], 0
            while parent and not isinstance(parent, UNLINKED):
                parent = parent.parent
            for start, stop, place in [] if parent else links.links_in(text):
                if not place.startswith(f"{page}.html"):
                    link = nodes.reference("", text[start:stop], refuri=f"{up}{place}")
                    new, end = [*new, nodes.Text(text[end:start]), link], stop
            if new:
                node.parent.replace(node, [*new, nodes.Text(text[end:])])


def show_files(app):
    """Write a page for each file that is linked to, with an anchor for each line."""
    for file in sorted(SHOWN):
        text, name = file.read_text("utf-8"), str(file.relative_to(links.ROOT))
        language = {".py": "python", ".yaml": "yaml"}.get(file.suffix, "text")
        body = app.builder.highlighter.highlight_block(
            text, language, linenos="inline", lineanchors="L"
        )
        yield f"sources/{name}", {"title": name, "body": f"<h1>{name}</h1>{body}"}, "page.html"


def setup(app):
    """Write the pages that follow from code and results, and fill in numbers and pictures."""
    generate.write_pages(HERE / "generated", RESULTS)
    numbers = measured.load_numbers(RESULTS)

    def fill_page(_app, name, source):
        source[0] = generate.fill_pictures(measured.fill(source[0], numbers), name, RESULTS)

    def name_as_used(_app, _what, _name, _value, _options, lines):
        lines[:] = [
            re.sub(r"`granular_fronts\.(\w+(?:\.\w+)?)`", r"`gf.\1`", line) for line in lines
        ]

    def copy_live_page(app, error):
        if not error:
            shutil.copytree(LIVE, Path(app.outdir, LIVE.name), dirs_exist_ok=True)

    app.connect("source-read", fill_page)
    app.connect("autodoc-process-docstring", name_as_used)
    app.connect("html-collect-pages", show_files)
    app.connect("build-finished", copy_live_page)
    app.add_transform(Links)
