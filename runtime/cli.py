"""The command line: `hertzwerk list | derive | audit | run | validate`.

A terminal gets tables, colours and a progress bar; a pipe gets plain text. Exit codes: 0 good, 1 another outcome, 2 bad input.
What a command does not need it does not import.
"""

from __future__ import annotations

import importlib
import sys
import time
from collections.abc import Callable, Sequence
from pathlib import Path
from types import TracebackType
from typing import TYPE_CHECKING, Any, Self

import click

from hertzwerk.derive.faults import Fault, InputError

if TYPE_CHECKING:
    from hertzwerk.runtime.regenerate import Derived
    from hertzwerk.runtime.solution import Solution

GOOD, OTHER_OUTCOME, BAD_INPUT = 0, 1, 2
COLOURS = {
    "finished": "green",
    "consistent": "green",
    "passed": "green",
    "failed": "red",
    "inconsistent": "red",
    "different": "yellow",
    "warning": "yellow",
    "remedy": "yellow",
    "written": "cyan",
}
BAR_AFTER = 0.5  # s; what is done sooner needs no bar


def print_version(context: click.Context, _: click.Parameter, wanted: bool) -> None:
    """Callback of --version."""
    if wanted:
        from hertzwerk.runtime.record import versions

        click.echo(", ".join(f"{name} {version}" for name, version in versions().items()))
        context.exit()


@click.group(context_settings={"help_option_names": ["-h", "--help"], "max_content_width": 110})
@click.option(
    "--version",
    is_flag=True,
    is_eager=True,
    expose_value=False,
    callback=print_version,
    help="Show the version and exit.",
)
def main() -> None:
    """Derive, unit-check, generate, run and validate contact and impact in mechanisms.

    TARGET is the name of a built-in scene (see `hertzwerk list`) or a Python file that defines `scene`; a named file is executed.
    """


def reports_bad_input(command: Callable[..., int]) -> Callable[..., None]:
    """A command whose InputError becomes one message and exit code 2, and so does a file that cannot be read or written."""

    def guarded(*args: Any, **options: Any) -> None:
        try:
            code = command(*args, **options)
        except InputError as error:
            click.echo(f"{click.style('error', fg='red')}  {error}", err=True)
            code = BAD_INPUT
        except OSError as error:
            if isinstance(error, BrokenPipeError):
                raise
            click.echo(f"{click.style('error', fg='red')}  {error}", err=True)
            code = BAD_INPUT
        click.get_current_context().exit(code)

    guarded.__doc__ = command.__doc__
    guarded.__name__ = command.__name__
    return guarded


@main.command("list")
@reports_bad_input
def list_scenes() -> int:
    """The built-in scenes, with their effects."""
    from hertzwerk.runtime.regenerate import generated_names

    rows = []
    for name in generated_names():
        module = importlib.import_module(f"hertzwerk.generated.{name}")
        rows.append((name, module.SUMMARY, ", ".join(effect for effect, _, _ in module.EFFECTS)))
    _table(("scene", "summary", "effects"), rows)
    return GOOD


@main.command()
@click.argument("targets", metavar="TARGET...", nargs=-1)
@click.option(
    "--check", is_flag=True, help="Write nothing; compare with the modules in place (default: all built-in scenes)."
)
@click.option(
    "--out", type=click.Path(path_type=Path), help="Folder to write to (default: generated/ of this repository)."
)
@reports_bad_input
def derive(targets: tuple[str, ...], check: bool, out: Path | None) -> int:
    """Derive the equations of TARGET, check every unit, and write the generated module."""
    from hertzwerk.runtime import regenerate
    from hertzwerk.runtime.build import built_in_scenes

    if check:
        return _compare(regenerate.derived(targets or built_in_scenes()), out, everything=not targets)
    if not targets:
        example = " ".join(built_in_scenes()[:2])
        raise InputError("derive", [Fault("TARGET", "none", f"scenes or files, such as {example}")])
    folder = out if out is not None else regenerate.repository_folder(targets)
    for path in regenerate.write(regenerate.derived(targets), folder):
        _line("written", str(path))
    return GOOD


@main.command()
@click.argument("target")
@reports_bad_input
def audit(target: str) -> int:
    """Check the unit of every expression of TARGET: exit code 0 consistent, 1 not, 2 bad input."""
    from hertzwerk.runtime.build import audit_target

    findings = audit_target(target)
    rows = [
        (
            f.verdict,
            f"{f.effect}, {f.what}",
            f.law,
            f.found if f.found == f.expected else f"{f.found}, not {f.expected}",
        )
        for f in findings
    ]
    _table(("verdict", "checked", "law", "unit"), rows)
    faulty = [finding for finding in findings if finding.verdict != "consistent"]
    for finding in faulty:
        click.echo(f"\n{finding}")
    if faulty:
        click.echo()
        _line("inconsistent", f"{len(faulty)} of {len(findings)} expressions")
        return OTHER_OUTCOME
    _line("consistent", f"{len(findings)} law expressions, and every assignment and output of the program")
    return GOOD


@main.command()
@click.argument("target")
@click.option(
    "--set",
    "settings",
    metavar="NAME=VALUE",
    multiple=True,
    help='Parameter or initial state, with its unit: --set clearance="0.2 mm".',
)
@click.option("--without", metavar="EFFECT", multiple=True, help="Leave an effect out (derives the variation).")
@click.option(
    "--law",
    "laws",
    metavar="EFFECT=NAME",
    multiple=True,
    help="Another law for a contact or friction (derives the variation).",
)
@click.option("--duration", metavar="TIME", help='Such as "24 ms" (default: the scenario\'s).')
@click.option(
    "--accuracy", metavar="NUMBER", help="Local tolerance in the scene's scales, 1e-12..1e-1 (default: the scenario's)."
)
@click.option("--method", metavar="NAME", help="dop853 or dopri5 (default: the scenario's).")
@click.option(
    "--out", type=click.Path(path_type=Path), help="New folder to write to (default: the next runs/SCENE-NNN)."
)
@click.option("--no-plots", is_flag=True, help="Write the data only.")
@click.option(
    "--json", "as_json", is_flag=True, help="Print one JSON object, and write a folder only if --out is given."
)
@reports_bad_input
def run(target: str, out: Path | None, no_plots: bool, as_json: bool, **options: Any) -> int:
    """Simulate TARGET and write data and plots into one new folder."""
    from hertzwerk.runtime import record

    solution = _simulate(target, out, quiet=as_json, **options)
    folder: tuple[Path, list[str]] | None = None
    if out is not None or not as_json:
        folder = record.write(solution, out, plots=not no_plots)
    if as_json:
        click.echo(record.json_text(record.summary(solution)))
    else:
        _report(solution)
    if folder is not None and not as_json:
        _line("written", f"{folder[0]}/ ({', '.join(folder[1])})")
    return GOOD if solution.outcome.finished else OTHER_OUTCOME


@main.command()
@click.argument("targets", metavar="[SCENARIO]...", nargs=-1)
@reports_bad_input
def validate(targets: tuple[str, ...]) -> int:
    """Run scenarios (built-in names or TOML files; default: all built-in) and check what must come out."""
    from hertzwerk.runtime import scenarios
    from hertzwerk.runtime.scenario import load_scenario
    from hertzwerk.runtime.validate import run_scenario
    from hertzwerk.runtime.validate import validate as verdicts_of

    good = True
    for scenario in [load_scenario(target) for target in targets or scenarios.names()]:
        solution = run_scenario(scenario)
        _line(scenario.scene, str(solution))
        verdicts = verdicts_of(scenario, solution)
        for verdict in verdicts:
            _line("passed" if verdict.passed else "failed", str(verdict))
        good = good and solution.outcome.finished and all(verdict.passed for verdict in verdicts)
    return GOOD if good else OTHER_OUTCOME


def _compare(modules: Sequence[Derived], folder: Path | None, *, everything: bool) -> int:
    """Report on each module whether the one in place is what its scene derives to."""
    from hertzwerk.runtime import regenerate

    good = True
    for module in modules:
        found = regenerate.difference(module, folder)
        if found is None:
            _line("consistent", f"{module.name}: the module in place is what the scene derives to")
            continue
        good = False
        click.echo(found.diff, nl=False)
        _line("different", f"{found.name}: accept with `{found.accept}`")
    orphans = set(regenerate.generated_names()) - {module.name for module in modules} if everything else set()
    for name in sorted(orphans):
        _line("different", f"{name}: a generated module without a scene; remove generated/{name}.py")
    return GOOD if good and not orphans else OTHER_OUTCOME


# ---- run -------------------------------------------------------------------------------------------------------------


def _simulate(
    target: str,
    out: Path | None,
    *,
    quiet: bool,
    settings: Sequence[str],
    without: Sequence[str],
    laws: Sequence[str],
    duration: str | None,
    accuracy: str | None,
    method: str | None,
) -> Solution:
    """The solution a command line asks for; raises InputError with the faults of all its parts."""
    from hertzwerk.runtime import scenarios
    from hertzwerk.runtime.model import load
    from hertzwerk.runtime.record import destination_fault
    from hertzwerk.runtime.simulate import simulate

    faults: list[Fault] = []
    if out is not None and (fault := destination_fault(out)) is not None:
        faults.append(fault)
    values = _assignments("--set", settings, faults)
    model = load(target, without=without, laws=_assignments("--law", laws, faults))
    numbers = scenarios.read(target) if target in scenarios.names() else {}
    states = {*model.coordinates, *model.speeds}
    limits: dict[str, Any] = {"max_steps": 1} if faults else {}  # reads the rest of the input completely, and no more
    with _Progress(model.name, shown=not quiet and sys.stderr.isatty()) as progress:
        try:
            solution = simulate(
                model,
                duration=duration or numbers.get("duration"),
                accuracy=_number(accuracy) if accuracy is not None else numbers.get("accuracy", 1e-6),
                method=method or numbers.get("method", "dop853"),
                parameters={name: value for name, value in values.items() if name not in states},
                initial={name: value for name, value in values.items() if name in states},
                progress=progress,
                **limits,
            )
        except InputError as error:
            raise InputError(error.subject, [*faults, *error.faults]) from error
    if faults:
        raise InputError(model.name, faults)
    return solution


def _assignments(option: str, texts: Sequence[str], faults: list[Fault]) -> dict[str, str]:
    """NAME=VALUE texts as a dictionary; what is no assignment, or a second one of a name, becomes a fault."""
    found: dict[str, str] = {}
    for text in texts:
        name, equals, value = (part.strip() for part in text.partition("="))
        if not (name and equals and value):
            faults.append(Fault(option, repr(text), "NAME=VALUE"))
        elif name in found:
            faults.append(Fault(option, f"{name} twice", "one value per name"))
        else:
            found[name] = value
    return found


def _number(text: str) -> Any:
    """The number a text is, or the text, for `simulate` to refuse."""
    try:
        return float(text)
    except ValueError:
        return text


def _report(solution: Solution) -> None:
    """What a person wants to know of a run, in a few lines."""
    statistics, outcome = solution.statistics, solution.outcome
    _line(solution.model.name, f"{_time(solution.duration)}, {solution.method}, accuracy {solution.accuracy:g}")
    count = len(solution.impacts)
    closed = "" if solution.energy_residual is None else f", energy closed to {solution.energy_residual:.1g}"
    _line(
        outcome.name,
        f"{statistics.steps:,} steps, {count:,} impact{'s' if count != 1 else ''}{closed}, computed in {_time(statistics.wall_s)}",
    )
    if not outcome.finished:
        _line("", outcome.message)
        _line("remedy", outcome.remedy)
    for warning in solution.warnings:
        _line("warning", warning)


def _time(seconds: float) -> str:
    return f"{seconds * 1e3:.4g} ms" if seconds < 1 else f"{seconds:.4g} s"


# ---- terminal --------------------------------------------------------------------------------------------------------


def _line(label: str, text: str) -> None:
    """One line of a report, or several under one label."""
    first, *rest = text.split("\n")
    click.echo(f"{click.style(f'{label:<12}', fg=COLOURS.get(label))}  {first}")
    for line in rest:
        click.echo(f"{'':14}{line}")


def _table(columns: Sequence[str], rows: Sequence[Sequence[str]]) -> None:
    """A table on a terminal, aligned plain text in a pipe."""
    if sys.stdout.isatty():
        from rich.box import SIMPLE_HEAD
        from rich.console import Console
        from rich.table import Table
        from rich.text import Text

        table = Table(box=SIMPLE_HEAD)
        for column in columns:
            table.add_column(column, no_wrap=column == columns[0], overflow="fold")
        for row in rows:
            table.add_row(*(Text(cell, style=COLOURS.get(cell, "")) for cell in row))
        Console().print(table)
        return
    widths = [max(len(cell) for cell in column) for column in zip(columns, *rows, strict=True)]
    for row in (columns, *rows):
        click.echo("  ".join(cell.ljust(width) for cell, width in zip(row, widths, strict=True)).rstrip())


class _Progress:
    """Called with the fraction done; shows a bar on a terminal once the work proves long."""

    def __init__(self, title: str, *, shown: bool) -> None:
        self._title = title
        self._shown = shown
        self._start = time.perf_counter()
        self._bar: Any = None

    def __enter__(self) -> Self:
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        if self._bar is not None:
            self._bar.stop()

    def __call__(self, fraction: float) -> None:
        if not self._shown or (self._bar is None and time.perf_counter() - self._start < BAR_AFTER):
            return
        if self._bar is None:
            from rich.console import Console
            from rich.progress import Progress

            self._bar = Progress(console=Console(stderr=True), transient=True)
            self._task = self._bar.add_task(self._title, total=1.0)
            self._bar.start()
        self._bar.update(self._task, completed=fraction)
