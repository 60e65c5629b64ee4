"""The source distribution holds every test and what they read, not the few that setuptools finds by name (`cmdclass` in pyproject.toml)."""

from setuptools.command.sdist import sdist


class WithTests(sdist):
    """`sdist` with the folders beside the packages, and the texts in them."""

    def make_distribution(self) -> None:
        """Add folders and texts, less what tools leave in them, and make the archive."""
        for folder in ("tests", ".ci", ".github", ".readme"):
            self.filelist.graft(folder)
        for text in (
            "derive/README.md", "derive/*/README.md", "runtime/README.md", "C*.md", "CITATION.cff", ".gitignore",
            ".pre-commit-*.yaml",
        ):  # fmt: skip
            self.filelist.include(text)
        self.filelist.global_exclude("__pycache__/*")
        self.filelist.global_exclude("*.py[co]")
        super().make_distribution()
