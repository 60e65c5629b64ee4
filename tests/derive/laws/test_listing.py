"""The catalogue written out, as a table and as a stub, and what `help` and `inspect` see of a law."""

import inspect
import pydoc
from pathlib import Path

import pytest
from click.testing import CliRunner
from each import each

from hertzwerk.derive.laws import LAWS, flores, palmgren_si
from hertzwerk.runtime.cli import main

FOLDER = Path(__file__).parents[3] / "derive" / "laws"


@pytest.mark.parametrize(("option", "file"), [("--markdown", "README.md"), ("--stub", "__init__.pyi")])
def test_committed_listings_are_those_the_command_writes(option, file):
    printed = CliRunner().invoke(main, ["laws", option])
    assert printed.exit_code == 0
    assert (FOLDER / file).read_text(encoding="utf-8") == printed.stdout, (
        f"hertzwerk laws {option} > derive/laws/{file}"
    )


@pytest.mark.parametrize("arguments", [["--markdown", "flores"], ["--stub", "--markdown"], ["--stub", "--json"]])
def test_a_listing_is_refused_beside_names_and_other_forms(arguments):
    assert CliRunner().invoke(main, ["laws", *arguments]).exit_code == 2


@each("name", LAWS)
def test_a_law_has_a_signature_and_a_documentation_of_its_own(name):
    law = LAWS[name]
    assert list(inspect.signature(law).parameters) == [symbol.name for symbol in law.parameters]
    assert all(f"{symbol.name} [{symbol.unit}]" in law.__doc__ for symbol in law.parameters)
    assert law.source in law.__doc__
    assert law.__doc__.splitlines()[0] in pydoc.plain(pydoc.render_doc(law))


def test_defaults_and_classes_of_laws_keep_their_signature():
    defaults = [parameter.default.name for parameter in inspect.signature(palmgren_si).parameters.values()]
    assert defaults == ["reference_length", "reference_force"]
    assert list(inspect.signature(type(flores)).parameters)[:2] == ["name", "title"]
    assert type(flores).__doc__ != flores.__doc__
