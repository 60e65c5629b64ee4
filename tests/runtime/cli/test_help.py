"""What `--help` shows: one summary sentence that is not cut off, every option described, its default, and an example that can be typed."""

import re
import shlex

import click
import pytest
from click.testing import CliRunner
from each import each

from hertzwerk.derive.scenes import NAMES
from hertzwerk.runtime.cli import FILES, FIRST, main

UNSTATED = {  # options of one value without a default: nothing is done without them
    "audit": "--expr", "effects": "--within", "export": "--c --fmu --tolerance", "handbook": "--build --notebooks",
    "laws": "--form --picture", "minimise": "--objective --tolerance", "modes": "--out",
    "propagate": "--fitted --table --tolerance", "report": "--scene", "rigid": "--out", "run": "--continue --table",
    "statics": "--out", "study": "--measured --resume",
    "sweep": "--cluster --continue --grid --resume --sample --section --table --tolerance",
}  # fmt: skip


def command_of(name):
    return main.get_command(click.Context(main), name)


def test_no_summary_is_cut_off_and_the_commands_to_begin_with_can_be_typed():
    lines = CliRunner().invoke(main, [], terminal_width=80).output.splitlines()
    assert max(map(len, lines)) <= 80
    described = dict(match.groups() for line in lines if (match := re.fullmatch(r"  (\w+) +([A-Z].*\.)", line)))
    assert described == {name: command_of(name).get_short_help_str(200) for name in FILES}
    assert not any(text.endswith("...") for text in described.values())
    for command, meaning in FIRST.items():
        assert any(re.fullmatch(f"  {re.escape(command)} +{re.escape(meaning)}", line) for line in lines)
        name, *words = command.split()[1:]
        if name != "COMMAND":
            command_of(name).make_context(name, words)


@each("name", sorted(FILES))
def test_a_command_has_an_example_that_can_be_typed(name):
    command = command_of(name)
    intro, *words = shlex.split(command.epilog)
    assert (intro, words[:2]) == ("Example:", ["hertzwerk", name])
    context = command.make_context(name, words[2:])
    target = context.params.get("target") or (context.params.get("targets") or [None])[0]
    assert target is None or target in NAMES or target.endswith(".py") or target.startswith("runs/")


@pytest.mark.parametrize("words", [["run", "--colour", "red"], ["fit", "pendulum"], ["statics"]])
def test_an_example_that_cannot_be_typed_is_refused(words):
    with pytest.raises(click.UsageError):
        command_of(words[0]).make_context(words[0], words[1:])


@each("name", sorted(FILES))
def test_arguments_and_options_are_described_with_their_defaults(name):
    command = command_of(name)
    context = click.Context(command, info_name=name)
    unstated = []
    for given in command.params:
        if not isinstance(given, click.Option):
            assert set(given.make_metavar(context).strip("[].").split("|")) <= set(re.findall(r"[A-Z]+", command.help))
            continue
        text = given.get_help_record(context)[1]
        assert re.fullmatch(r"[A-Z].*\.(  \[(default: \w+|required)\])?", text), (given, text)
        if not (given.is_flag or given.multiple or given.required or "default:" in text):
            unstated.append(given.opts[0])
    assert sorted(unstated) == UNSTATED.get(name, "").split()
