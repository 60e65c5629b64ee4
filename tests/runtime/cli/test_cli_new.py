"""`hertzwerk new`: every template runs by the command that is printed, as the built-in scene does; nothing is replaced."""

import json
import re
import shlex
from pathlib import Path

import pytest

from hertzwerk import load
from hertzwerk.runtime.cli.scene_commands.new import TEMPLATES


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("template", TEMPLATES)
def test_a_template_runs_by_the_command_that_is_printed(hertzwerk, template):
    done = hertzwerk("new", "my_mechanism.py", "--template", template)
    text = Path("my_mechanism.py").read_text()
    command = re.search(r"^run it by +hertzwerk (.+)$", done.output, re.MULTILINE)[1]
    assert f"Run it by `hertzwerk {command}`." in text
    assert len(re.findall(r"^ *# ", text, re.MULTILINE)) >= 4
    assert "fmt:" not in text
    run = json.loads(hertzwerk(*shlex.split(command), "--accuracy", "1e-3", "--json").output)
    assert run["outcome"] == "finished"
    model, built_in = load("my_mechanism.py"), load(TEMPLATES[template])
    assert model.name == "my_mechanism"
    assert (model.parameters, list(model.histories)) == (built_in.parameters, list(built_in.histories))


@pytest.mark.parametrize(
    ("file", "found"),
    [
        ("mine.py", "mine.py, which exists; expected a new file"), ("two words.py", "the name 'two words'; expected an identifier"),
        ("class.py", "the name 'class'"), ("mine.toml", "mine.toml; expected a name that ends in .py"),
        ("mine.py/other.py", "mine.py, which is a file; expected a file in a folder that can be written to"),
    ],
)  # fmt: skip
def test_a_file_that_cannot_be_a_new_scene_is_refused(hertzwerk, file, found):
    Path("mine.py").write_text("mine = 1\n")
    assert found in hertzwerk("new", file, code=2).output
    assert [path.name for path in Path.cwd().iterdir()] == ["mine.py"]
    assert Path("mine.py").read_text() == "mine = 1\n"
