"""Manual of granular-fronts; `make docs` builds it of these pages, docstrings and results."""

import sys
from importlib import import_module
from pathlib import Path

HERE = Path(__file__).parent
sys.path[:0] = [str(HERE), str(HERE.parent / "src")]

project = "granular-fronts"
author = "The granular-fronts maintainers"
version = release = import_module("granular_fronts").__version__

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
nb_execution_timeout = 120
nb_execution_raise_on_error = True
# Progress bars leave widgets behind, whose scripts a page would fetch from the network.
nb_ipywidgets_js = {}

autodoc_member_order = "bysource"
numpydoc_show_class_members = False

html_theme = "pydata_sphinx_theme"
html_title = "granular-fronts"
html_theme_options = {"show_prev_next": True, "navigation_with_keys": False}


RESULTS = HERE.parent / "results"


def setup(app):
    """Write the pages that follow from code and results, and fill in the measured numbers."""
    import_module("generate").write_pages(HERE / "generated", RESULTS)
    measured = import_module("measured")
    numbers = measured.load_numbers(RESULTS)

    def fill_page(_app, _name, source):
        source[0] = measured.fill(source[0], numbers)

    app.connect("source-read", fill_page)
