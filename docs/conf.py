"""Manual of granular-fronts; `make docs` builds it of these pages, docstrings and results."""

import re
import shutil
import sys
from importlib import import_module
from pathlib import Path

HERE = Path(__file__).parent
sys.path[:0] = [str(HERE), str(HERE.parent / "src")]
generate = import_module("generate")

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
html_theme_options = {"navbar_center": [], "navigation_with_keys": False}
html_context = {"default_mode": "auto"}
html_static_path = ["_static"]
html_css_files = ["manual.css"]
html_sidebars = {"**": ["globaltoc"]}
html_show_sourcelink = False
html_copy_source = False
# A browser refuses to fetch summaries where the manual is read from files.
html_show_search_summary = False

CONTENTS = {
    "Begin": "what_is_a_front start gallery",
    "Tutorials": """tutorials/front_initiation tutorials/exact_fronts tutorials/beads
        tutorials/laboratory tutorials/any_law""",
    "Use": "commands practitioners limits",
    "Science": "findings theory/fronts theory/amplitude_equations proofs generated/tables",
    "Look up": """generated/public_names generated/readme_config generated/configuration
        generated/campaigns generated/variables equations glossary""",
    "Projects": " ".join(f"generated/readme_{page.parent.name}" for page in generate.PROJECTS),
    "Take part": "your_project develop generated/CONTRIBUTING generated/CHANGELOG",
}
"""All pages, by their part of the manual."""


def prepare_page(_app, name, source):
    """Change what a code host shows well into what Sphinx needs: contents, notebooks, links."""
    up = "../" * name.count("/")
    text = re.sub(
        r"\]\((?:\.\./)+(?:config|projects/(\w+))/README\.md",
        lambda found: f"]({up}generated/readme_{found[1] or 'config'}.md",
        source[0],
    )
    # Sphinx would offer what is no page of its own for a download.
    text = re.sub(r"\[([^]]+)\]\(live/index\.html\)", r'<a href="live/index.html">\1</a>', text)
    text = re.sub(r"\]\(\.\./(CONTRIBUTING|CHANGELOG)\.md", r"](generated/\1.md", text)
    if name == "index":
        for title, pages in CONTENTS.items():
            listed = "\n".join(pages.split())
            text += f"\n```{{toctree}}\n:hidden:\n:caption: {title}\n\n{listed}\n```\n"
    if name.startswith("tutorials/"):
        header = "---\nfile_format: mystnb\nkernelspec:\n  name: python3\n---\n\n"
        text = header + text.replace("```python\n", "```{code-cell}\n")
    source[0] = text


def name_as_used(_app, _what, _name, _value, _options, lines):
    """Write gf for the package, as users do."""
    lines[:] = [re.sub(r"`granular_fronts\.(\w+(?:\.\w+)?)`", r"`gf.\1`", one) for one in lines]


def copy_live_page(app, error):
    """Copy the page that computes a chain, unless the build has failed."""
    if not error:
        shutil.copytree(HERE / "live", Path(app.outdir, "live"), dirs_exist_ok=True)


def setup(app):
    """Write the pages that follow from code and results, and prepare the others."""
    generate.write_pages(HERE / "generated", HERE.parent / "results")
    app.connect("source-read", prepare_page)
    app.connect("autodoc-process-docstring", name_as_used)
    app.connect("build-finished", copy_live_page)
