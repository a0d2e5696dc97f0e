"""Sphinx's settings; `make docs` builds the site without a network."""

import sys
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

import carom

project = "Carom"
author = "The Carom authors"
project_copyright = author
version = release = carom.__version__

extensions = [
    "myst_parser",
    "sphinx_copybutton",
    "sphinx_design",
    "sphinx.ext.autodoc",
    "numpydoc",
    "carom_docs.site",
]
exclude_patterns = ["carom_docs"]
myst_enable_extensions = ["colon_fence", "dollarmath"]
myst_heading_anchors = 3

# A single backtick in a docstring names something of the package where there is such a thing, else it is code.
default_role = "py:obj"
nitpick_ignore_regex = [
    # Code in single backticks is no link unless there is such a name; types from elsewhere are not documented here.
    ("py:obj", r".*"),
    ("py:class", r".*"),
    ("py:exc", r".*"),
]
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_type_aliases = {"ArrayLike": "ArrayLike"}
autodoc_member_order = "bysource"
python_use_unqualified_type_names = True
maximum_signature_line_length = 100
python_trailing_comma_in_multi_line_signatures = False
smartquotes_action = "q"
numpydoc_show_class_members = False

html_theme = "furo"
html_title = "Carom"
html_static_path = ["_static"]
html_css_files = ["carom.css"]
html_copy_source = False
html_show_sourcelink = False
html_show_sphinx = False
html_math_renderer = "mathml"
pygments_style = "friendly"
pygments_dark_style = "github-dark"
html_theme_options = {
    "light_css_variables": {
        "color-brand-primary": "#1f6f54",
        "color-brand-content": "#1f6f54",
        "color-brand-visited": "#1f6f54",
    },
    "dark_css_variables": {
        "color-brand-primary": "#6fc9a6",
        "color-brand-content": "#6fc9a6",
        "color-brand-visited": "#6fc9a6",
    },
}
copybutton_exclude = ".linenos, .gp, .go"
