"""Common options of commands that run a TARGET, and the model they name."""

from __future__ import annotations

import shlex
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, fields
from functools import reduce
from pathlib import Path
from typing import TYPE_CHECKING, Any, TypeVar

import click
from click.core import ParameterSource

from hertzwerk.derive.common.faults import Fault, InputError

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.binding import Value
    from hertzwerk.runtime.engine.model.model import EngineModel
    from hertzwerk.runtime.engine.run.run_request import Settings
    from hertzwerk.runtime.simulation import Solution

AnyModel = TypeVar("AnyModel", bound="EngineModel")
SET = click.option(
    "--set",
    "settings",
    metavar="NAME=VALUE",
    multiple=True,
    help='Set a parameter or an initial state, with its unit: --set clearance="0.2 mm" (default: the scene\'s values).',
)
INPUT = click.option(
    "--input",
    "inputs",
    metavar="NAME=VALUE",
    multiple=True,
    help='Set an input of the scene to a value, --input "torque=0.5 N m", or to a column of a file, --input torque=bench.csv:load. '
    "Samples are joined by straight lines; bench.csv:load:held keeps each until the next, bench.csv:load:cubic takes a spline; "
    "a file is read with arguments by 'bench.csv?skip=3&decimal=,&units.load=N m:load'.",
)
WITHOUT = click.option(
    "--without", metavar="EFFECT", multiple=True, help="Leave out an effect; the equations are derived anew."
)
LAW = click.option(
    "--law",
    "laws",
    metavar="EFFECT=LAW",
    multiple=True,
    help='Replace the law of a contact or friction: --law "slider_pin=power(K=1e9 N/m^1.3, n=1.3)", with values where it needs new ones. '
    "FILE.toml:NAME is a law of a file. The equations are derived anew.",
)
COORDINATES = click.option(
    "--coordinates",
    metavar="NAME",
    help="Coordinates of the equations: tree (of the joints), absolute (of every body) or auto (the one with fewer operations); "
    "the equations are derived anew (default: the scene's).",
)


def together(*options: Callable[[Any], Any]) -> Callable[[Any], Any]:
    """Decorate a command with options, in their order."""
    return lambda command: reduce(lambda decorated, option: option(decorated), reversed(options), command)


VARIATION = together(SET, INPUT, WITHOUT, LAW, COORDINATES)
ACCURACY = click.option(
    "--accuracy",
    metavar="NUMBER",
    help="Largest error of the whole run, in the scene's scales, 1e-12 to 1e-1; '1e-6 at the end' limits the error at the end alone "
    "(default: the scenario's).",
)
TOLERANCE = click.option(
    "--tolerance",
    metavar="NUMBER",
    help="Local tolerance of a single run, in place of --accuracy; its error is not estimated.",
)
MAX_STEPS = click.option(
    "--max-steps", metavar="NUMBER", help="Stop each run after this number of accepted steps (default: none)."
)
WALL_TIME = click.option(
    "--wall-time",
    metavar="TIME",
    help='Stop after this time by the clock, compilation included, such as "10 min" (default: none).',
)
GRID = click.option(
    "--grid",
    metavar="POINTS|TIME",
    help='Keep this number of equally spaced states, such as 10000, or one per time, such as "0.1 ms" (default: every accepted step).',
)
DURATION = click.option(
    "--duration", metavar="TIME", help='Time to simulate, such as "24 ms" (default: the scenario\'s).'
)


class _Methods(click.Option):
    """Option whose help lists the methods, imported only when help is shown: their tables need NumPy."""

    def get_help_record(self, ctx: click.Context) -> tuple[str, str] | None:
        """Return option and help."""
        from hertzwerk.runtime.engine.integration.tableaux.methods import METHODS

        *others, last = METHODS
        self.help = f"Integration method: {', '.join(others)} or {last} (default: the scenario's)."
        return super().get_help_record(ctx)


BY_METHOD = click.option("--method", metavar="NAME", cls=_Methods)
TABLE = click.option(
    "--table",
    "file",
    metavar="FILE",
    type=click.Path(path_type=Path),
    help="Write a table with units to a new file: .csv, .parquet or .nc (netCDF); the last two need hertzwerk[data].",
)
READING = together(
    click.option(
        "--units",
        metavar="COLUMN=UNIT",
        multiple=True,
        help="Unit of a column of --measured, in place of the file's: --units t=ms.",
    ),
    click.option(
        "--columns",
        "headings",
        metavar="NAME=HEADING",
        multiple=True,
        help='Column of --measured by its heading or its number from 1 on: --columns "force=CH 2", --columns t=1 (default: equal names).',
    ),
    click.option(
        "--skip-lines", type=int, default=0, help="Lines at the beginning of --measured to leave out (default: 0)."
    ),
    click.option(
        "--decimal",
        type=click.Choice([".", ","]),
        help="Decimal mark of --measured (default: the one that its cells prove).",
    ),
    click.option(
        "--missing",
        metavar="TEXT",
        multiple=True,
        help="Cell of --measured without a sample, beside empty ones, nan, N/A and marks of overflow: --missing=-999.",
    ),
)
JSON = click.option(
    "--json", "as_json", is_flag=True, help="Print one JSON object; a folder is written only if it is named."
)


@dataclass(frozen=True)
class Variation:
    """A target and the options of `VARIATION` that vary it, as they were typed."""

    target: str
    settings: Sequence[str] = ()
    inputs: Sequence[str] = ()
    without: Sequence[str] = ()
    laws: Sequence[str] = ()
    coordinates: str | None = None

    @classmethod
    def taken(cls, target: str, options: dict[str, Any]) -> Variation:
        """Return the variation, its options taken out of those of a command."""
        names = [each.name for each in fields(cls) if each.name in options]
        return cls(target, **{name: options.pop(name) for name in names})

    def model(self, faults: list[Fault], others: Callable[[], list[Fault]] = list) -> EngineModel:
        """Return the model of the varied scene.

        Raises InputError with the faults found before and, as names of parameters and states cannot be checked then,
        only those of `others`.
        """
        from hertzwerk.runtime.loading import engine_model

        laws = assignments("--law", self.laws, faults)
        try:
            return engine_model(self.target, without=self.without, laws=laws, coordinates=self.coordinates)
        except InputError as error:
            raise InputError(error.subject, [*faults, *error.faults, *others()]) from error

    def values(self, faults: list[Fault]) -> dict[str, str]:
        """Return the values of --set; malformed ones are appended to `faults`."""
        return assignments("--set", self.settings, faults)

    def bound(
        self, duration: str | float | None, faults: list[Fault], others: Callable[[], list[Fault]] = list
    ) -> tuple[EngineModel, Mapping[str, Value], Mapping[str, Value]]:
        """Return the model with its inputs for a duration, parameters, initial states; raises InputError."""
        from hertzwerk.runtime.engine.start.start_values import split_values

        values = self.values(faults)
        model = self.model(faults, others)
        parameters, initial = split_values(model, values)
        return with_inputs(model, self.inputs, duration, parameters, faults), parameters, initial

    def solved(
        self,
        settings: Settings,
        faults: list[Fault],
        progress: Callable[[float], object],
        *,
        histories: Sequence[str] = (),
        at_rest: bool = False,
    ) -> Solution:
        """Run the varied scene with its values, from its start or its equilibrium.

        Every name of `histories` must be one of its histories. Raises InputError with the faults found before and
        those of every option.
        """
        from hertzwerk.runtime.engine.run.run_request import check
        from hertzwerk.runtime.engine.solution.history import unknown_histories
        from hertzwerk.runtime.simulation import solve

        model, parameters, initial = self.bound(settings.duration, faults, settings.faults)
        faults += unknown_histories(model, histories)
        begin = _at_rest(model, parameters, initial, faults) if at_rest else initial
        check(model, settings, parameters, begin, faults)
        return solve(model, settings, parameters, begin, progress=progress)


def reading_of(options: dict[str, Any], faults: list[Fault]) -> dict[str, Any]:
    """Return the values of `READING`, taken out of those of a command; faults are appended."""
    columns = assignments("--columns", options.pop("headings"), faults)
    numbered = {name: int(text) if text.isdecimal() else text for name, text in columns.items()}
    units, skip = assignments("--units", options.pop("units"), faults), options.pop("skip_lines")
    return {"columns": numbered or None, "units": units, "skip": skip} | {
        name: options.pop(name) for name in ("decimal", "missing")
    }


def run_settings(
    target: str,
    *,
    duration: str | None,
    accuracy: str | None = None,
    tolerance: str | None = None,
    method: str | None = None,
    **_: object,
) -> dict[str, Any]:
    """Return duration, accuracy, tolerance and method as options state them, else as the scenario does."""
    from hertzwerk.runtime.analysis.validation import scenarios
    from hertzwerk.runtime.engine.run.run_request import METHOD

    numbers = scenarios.read(target)
    default = numbers.get("accuracy") if tolerance is None else None
    return {
        "duration": duration or numbers.get("duration"),
        "accuracy": default if accuracy is None else number(accuracy),
        "tolerance": None if tolerance is None else number(tolerance),
        "method": method or numbers.get("method", METHOD),
    }


def with_inputs(
    model: AnyModel,
    texts: Sequence[str],
    duration: str | float | None,
    parameters: Mapping[str, Value],
    faults: list[Fault],
) -> AnyModel:
    """Return a model with the values of --input for runs of a duration; faults are appended."""
    values = assignments("--input", texts, faults)
    if not values:
        return model
    from hertzwerk.runtime.engine.inputs.input_values import with_input_values

    model, wrong = with_input_values(model, values, duration, parameters)
    faults += wrong
    return model


def _at_rest(
    model: EngineModel, parameters: Mapping[str, Value], initial: Mapping[str, Value], faults: list[Fault]
) -> Mapping[str, Value]:
    """Return the initial states of an equilibrium; raises InputError where there is none."""
    from hertzwerk.runtime.analysis.statics.equilibrium import equilibrium

    rest = equilibrium(model, parameters=parameters, initial=initial)
    if not rest.converged:
        fault = Fault("--start", f"no equilibrium: {rest.outcome.message}", "a position of rest", rest.outcome.remedy)
        raise InputError(model.name, [*faults, fault])
    return dict(rest)


def unwritable_faults(out: Path | None, *, wanted: bool = True) -> list[Fault]:
    """Return the fault of a folder --out, or of runs/ where a folder is wanted, that cannot be written."""
    from hertzwerk.runtime.system.result_folder import destination_fault

    fault = destination_fault(out) if wanted or out is not None else None
    return [] if fault is None else [fault]


def table_faults(file: Path | None) -> list[Fault]:
    """Return the faults of a file --table, before anything is computed for it."""
    if file is None:
        return []
    from hertzwerk.runtime.output.tables.table_file import table_file_faults

    return table_file_faults(file)


def assignments(option: str, texts: Sequence[str], faults: list[Fault]) -> dict[str, str]:
    """Parse NAME=VALUE texts; malformed and repeated ones are appended to `faults`."""
    values: dict[str, str] = {}
    for text in texts:
        name, equals, value = (part.strip() for part in text.partition("="))
        if not (name and equals and value):
            faults.append(Fault(option, repr(text), "NAME=VALUE"))
        elif name in values:
            faults.append(Fault(option, f"{name} twice", "one value per name"))
        else:
            values[name] = value
    return values


def number(text: str) -> Any:
    """Return the number a text stands for, or the text, for its reader to refuse."""
    try:
        return float(text)
    except ValueError:
        return text


def stated_options(*names: str, but: Sequence[str] = ()) -> list[str]:
    """Return the options that the command line states, of these names or of all but some."""
    context = click.get_current_context()
    return [
        option.opts[0] if isinstance(option, click.Option) else str(option.metavar or option.name).strip("[]").upper()
        for option in context.command.params
        if (option.name in names if names else option.name not in but)
        and context.get_parameter_source(str(option.name)) is ParameterSource.COMMANDLINE
    ]


def beside(where: str, expected: str, *allowed: str) -> list[Fault]:
    """Return the fault of options stated beside what is whole, except those that may be."""
    stated = stated_options(but=allowed)
    return [Fault(where, f"{', '.join(stated)} beside it", expected)] if stated else []


def command_line(*without: str) -> str:
    """Return the command that runs, as it can be typed again, but for some options."""
    context = click.get_current_context()
    words = ["hertzwerk", str(context.info_name)]
    for option in context.command.params:
        name = str(option.name)
        if name in without or context.get_parameter_source(name) is not ParameterSource.COMMANDLINE:
            continue
        value = context.params[name]
        values = list(value) if isinstance(value, tuple) else [value]
        if isinstance(option, click.Option):
            values = (
                [option.opts[0]] if option.is_flag else [word for value in values for word in (option.opts[0], value)]
            )
        words += map(str, values)
    return shlex.join(words)
