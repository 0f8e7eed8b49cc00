"""Settings of Sphinx."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).resolve().parent))

import front_page
import poppet
from poppet import __version__

ASSISTANT_TEXTS = Path(poppet.__file__).parent / "assist"
"""Folder of the texts for assistants, which belong to the root of the site."""

project = "poppet"
author = "The poppet developers"
project_copyright = "The poppet developers"
version = release = __version__

extensions = ["myst_nb", "sphinx_design", "sphinx_copybutton", "sphinx.ext.autodoc", "sphinx.ext.napoleon"]
root_doc = "index"
exclude_patterns = ["**/.ipynb_checkpoints"]

myst_enable_extensions = ["colon_fence", "deflist", "dollarmath", "attrs_inline", "attrs_block"]
myst_heading_anchors = 4
myst_dmath_double_inline = True
suppress_warnings = ["myst.header"]

# Notebooks run during the build, each in an empty folder; `make_site.py` sets their cache.
nb_execution_mode = "cache"
nb_execution_in_temp = True
nb_execution_timeout = 240
nb_execution_raise_on_error = True
nb_merge_streams = True

# Relative to the sources; copied by `make_site.py`.
mathjax_path = "mathjax.js"
autodoc_member_order = "bysource"
autodoc_typehints = "none"
napoleon_google_docstring = False

templates_path = ["templates"]
html_theme = "pydata_sphinx_theme"
html_title = "poppet"
html_show_sourcelink = False
# Pages without neighbours use the full width.
html_sidebars: dict[str, list[str]] = {page: [] for page in ("compare", "validation", "gallery/index")}
html_show_sphinx = False
html_theme_options: dict[str, Any] = {
    "logo": {"text": "poppet"},
    "header_links_before_dropdown": 5,
    "navbar_end": ["theme-switcher"],
    "show_prev_next": True,
    "secondary_sidebar_items": ["page-toc"],
    "footer_start": ["copyright"],
    "footer_end": [],
    "navigation_with_keys": True,
    "pygments_light_style": "a11y-high-contrast-light",
    "pygments_dark_style": "a11y-high-contrast-dark",
}


def setup(app: Any) -> None:
    """Use the static files next to the sources, not next to this file."""
    app.config.html_extra_path = [str(ASSISTANT_TEXTS / name) for name in ("llms.txt", "llms-full.txt")]
    app.config.html_extra_path += [str(Path(app.srcdir).parent / "extra")]
    app.config.html_static_path = [str(Path(app.srcdir) / "static")]
    app.add_css_file("site.css")
    app.add_js_file("site.js")
    app.connect("html-page-context", use_front_page)


def use_front_page(app: Any, page: str, template: str, context: dict[str, Any], doctree: Any) -> str | None:
    """Return the template of the front page, which needs no files of the theme."""
    if page != root_doc:
        return None
    context["front"] = front_page.parts()
    return "front.html"
