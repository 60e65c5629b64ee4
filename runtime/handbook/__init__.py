"""The handbook: pages in Markdown, their code, and the web pages that Sphinx builds from them."""
