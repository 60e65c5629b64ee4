"""Pages of reference that are generated: Python names, commands, laws, scenes, formats of files."""

from __future__ import annotations

import ast
import inspect
import json
import pkgutil
import re
from collections.abc import Callable, Iterator
from importlib import resources
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from hertzwerk.runtime.analysis.validation.scenario import Scenario
from hertzwerk.runtime.engine.model import build
from hertzwerk.runtime.studies.minimisation.minimisation import minimise
from hertzwerk.runtime.studies.sweeps.definition_file import form_of
from hertzwerk.runtime.studies.sweeps.parameter_sweep import sweep
from hertzwerk.runtime.studies.uncertainty.propagation import propagate

HEADINGS = {  # of public names, by the module that defines them; the first that fits
    "derive": {
        "declare.mechanism.joints": "Joints",
        "equations.contact": "Pairs",
        "declare.mechanism": "Bodies, curves, mechanism",
        "declare.effects": "Effects and expressions",
        "declare.scene": "Scenes",
        "laws": "Laws and materials",
        "expressions": "Parameters and functions",
        "": "Audit, derivation, other formats",
    },
    "runtime": {
        "loading": "Load and run",
        "simulation": "Load and run",
        "engine.solution": "Results",
        "engine.inputs": "Inputs and measured data",
        "studies.sweeps": "Sweeps",
        "studies.fitting": "Fits",
        "studies.comparison": "Comparison with data",
        "studies.uncertainty": "Uncertainty",
        "studies": "Best parameters",
        "analysis": "Statics, vibrations, effects",
    },
}
TITLES = {"derive": "Python: declare and derive", "runtime": "Python: run and analyse"}
LINES = 12  # of a scene's source in the gallery


def public_names(side: str) -> Iterator[tuple[str, str]]:
    """Yield the public names of `derive` or `runtime`, and the modules that define them, not imported."""
    source = resources.files(f"hertzwerk.{side}").joinpath("__init__.py").read_text(encoding="utf-8")
    block = next(node for node in ast.parse(source).body if isinstance(node, ast.If))
    for node in block.body:
        if isinstance(node, ast.ImportFrom):
            home = str(node.module).removeprefix("hertzwerk.")
            if home.startswith(side):  # the others are on the page of their own side
                yield from ((alias.name, home.removeprefix(side).lstrip(".")) for alias in node.names)


def python_page(side: str) -> str:
    """Return the page of one side's public names, for autodoc."""
    groups: dict[str, list[str]] = {heading: [] for heading in HEADINGS[side].values()}
    for name, home in public_names(side):
        prefix = next(prefix for prefix in HEADINGS[side] if home.startswith(prefix))
        groups[HEADINGS[side][prefix]].append(name)
    parts = [f"# {TITLES[side]}\n\nEverything here comes from `hertzwerk.{side}`.\n"]
    for heading, names in groups.items():
        parts.append(f"## {heading}\n\n```{{eval-rst}}")
        parts += [_directive(f"hertzwerk.{side}", name) for name in sorted(names)]
        parts.append("```\n")
    return "\n".join(parts)


def _directive(front: str, name: str) -> str:
    member = pkgutil.resolve_name(f"{front}:{name}")
    if inspect.isclass(member):
        members = "\n   :members:\n   :inherited-members: tuple, Exception" if front.endswith("runtime") else ""
        return f".. autoclass:: {front}.{name}{members}\n"
    if inspect.isroutine(member):
        return f".. autofunction:: {front}.{name}\n"
    text = "Module of the built-in laws." if inspect.ismodule(member) else f"A ``{type(member).__name__}``."
    return f".. py:data:: {front}.{name}\n\n   {text}\n"


def commands_page(command: Any) -> str:
    """Return the page of all commands, from their help."""
    parts = ["# Commands\n\n`hertzwerk COMMAND --help` prints the same.\n"]
    for name in command.list_commands(None):
        one = command.get_command(SimpleNamespace(), name)
        context = one.make_context(f"hertzwerk {name}", [], resilient_parsing=True, max_content_width=80)
        parts.append(f"## {name}\n\n```text\n{one.get_help(context)}\n```\n")
    return "\n".join(parts)


def laws_page() -> str:
    """Return the catalogue of contact laws."""
    text = re.sub(r"^`hertzwerk laws --markdown` .*? date\.\s", "", build.law_listing(stub=False), flags=re.M | re.S)
    text = re.sub(
        r"^\| law \| .*\n\|[-|]+$", "| law | title, contact, grade | source |\n|---|---|---|", text, flags=re.M
    )
    return re.sub(r"^(\| `.*) \| (.*) \| ([ABCR]) \| (.*) \|$", r"\1; \2; grade \3 | \4 |", text, flags=re.M)


def scenes_page() -> str:
    """Return the gallery of built-in scenes: picture, command and source of each."""
    parts = ["---\nlong: true\n---\n\n# Built-in scenes\n", "```python\nfrom hertzwerk import load\n```\n"]
    for name in build.built_in_scenes():
        source = build.scene_text(name)
        summary, *_ = str(ast.get_docstring(ast.parse(source))).split("\n")
        lines = source.rstrip().splitlines()
        shown = "\n".join(lines[next(i for i, line in enumerate(lines) if line.startswith("scene = ")) :][:LINES])
        parts.append(
            f"## {name}\n\n{summary}\n\n```console\n$ hertzwerk run {name}\n```\n\n"
            f'```python\nload("{name}").draw().savefig("{name}.png")\n```\n\n![Mechanism of {name}]({name}.png)\n\n'
            f":::{{dropdown}} Source: derive/scenes/{name}.py, from `scene` on\n```text\n{shown}\n```\n:::\n"
        )
    return "\n".join(parts)


def schemas_page() -> str:
    """Return the JSON schemas of the files that users write."""
    functions: dict[str, Callable[..., Any]] = {"Sweep": sweep, "Propagation": propagate, "Minimisation": minimise}
    kinds = {"Scenario": Scenario.model_json_schema()}
    kinds |= {kind: form_of(function).model_json_schema() for kind, function in functions.items()}
    kinds |= {f"Law: {kind}": schema for kind, schema in build.law_file_schemas().items()}
    parts = ["# JSON schemas\n\nThese schemas describe the TOML files that hertzwerk reads.\n"]
    for kind, schema in kinds.items():
        parts.append(f"## {kind}\n\n```json\n{json.dumps(schema, indent=1, ensure_ascii=False)}\n```\n")
    return "\n".join(parts)


GENERATED: dict[str, Callable[[Any], str]] = {  # pages by their names, from the command line
    "python-runtime": lambda _: python_page("runtime"),
    "python-derive": lambda _: python_page("derive"),
    "commands": commands_page,
    "laws": lambda _: laws_page(),
    "scenes": lambda _: scenes_page(),
    "file-schemas": lambda _: schemas_page(),
}


def write_reference(folder: Path, command: Any) -> None:
    """Write the generated pages into a folder."""
    for name, page in GENERATED.items():
        (folder / f"{name}.md").write_text(page(command), encoding="utf-8")
