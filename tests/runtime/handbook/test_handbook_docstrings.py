"""Docstrings for Sphinx: entries, code and what stands as it is."""

import pytest

from hertzwerk.runtime.handbook.sphinx_extension import restructured


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("Force F*d.", ["Force F\\*d."]), ("Call `f(*x)`s.", ["Call \\ ``f(*x)``\\ s."]),
        ("target    a scene\n          or a Model\n\nRaises X.", ["", "target", "    a scene", "    or a Model", "", "Raises X."]),
        ("a  one\nb  two\nthen", ["", "a", "    one", "b", "    two", "", "then"]), ("Sum:\n\n    x = |y|", ["Sum:", "", "::", "", "    x = |y|"]),
    ],
)  # fmt: skip
def test_docstrings_become_restructured_text(text, expected):
    assert restructured(text.split("\n")) == expected
