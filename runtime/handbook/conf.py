"""Settings of Sphinx for the handbook; `hertzwerk handbook --build DIR` builds it."""

from pathlib import Path

from hertzwerk.version import __version__

project = "hertzwerk"
version = release = __version__
author = "the authors of hertzwerk"
autodoc_typehints = "none"
autodoc_member_order = "bysource"
add_module_names = False
extensions = ["myst_parser", "sphinx_design", "sphinx.ext.autodoc", "hertzwerk.runtime.handbook.sphinx_extension"]
myst_enable_extensions = ["dollarmath", "colon_fence", "deflist"]
myst_heading_anchors = 3
source_suffix = {".md": "markdown"}
linkcheck_timeout = 30  # s
linkcheck_retries = 3
linkcheck_ignore = [r"https://doi\.org/"]  # leads to publishers, who refuse programs (403)
html_theme = "pydata_sphinx_theme"
html_static_path = ["_static"]
html_css_files = ["handbook.css"]
html_search_scorer = str(Path(__file__).parent / "_static" / "search_scorer.js")
html_math_renderer = "mathml"
html_title = "hertzwerk"
html_copy_source = False
html_show_sourcelink = False
html_show_copyright = False
html_theme_options = {
    "navigation_with_keys": False,
    "navbar_end": ["theme-switcher"],
    "footer_start": [],
    "footer_end": [],
    "secondary_sidebar_items": ["page-toc"],
    "show_prev_next": True,
    "search_as_you_type": True,
}
