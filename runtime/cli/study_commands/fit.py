"""`hertzwerk fit`: parameters from measurements."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from hertzwerk.derive.common.faults import Fault
from hertzwerk.runtime.cli.target_options import (
    BY_METHOD,
    DURATION,
    JSON,
    READING,
    VARIATION,
    Variation,
    assignments,
    number,
    reading_of,
    stated_options,
    unwritable_faults,
)
from hertzwerk.runtime.cli.terminal import OTHER_OUTCOME, Progress, conclude, line, reports_bad_input
from hertzwerk.runtime.system.digests import record_text

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import EngineModel
    from hertzwerk.runtime.studies.fitting.fit_result import Estimates, Fit
    from hertzwerk.runtime.studies.fitting.law_ranking import Ranking
    from hertzwerk.runtime.studies.fitting.moments.moment_fit import MomentFit


OF_SERIES = "bandwidth", "order", "zero_phase", "skip", "independent"  # options of statistics


@click.command(epilog="Example: hertzwerk fit bouncing_ball --measured drop.csv --free restitution=0.3..1")
@click.argument("target")
@click.option(
    "--measured",
    metavar="FILE",
    multiple=True,
    help="Table with headings `name [unit]`: histories with a column `t [s]`, or impacts with a column `impact [1]`. "
    "Several files are fitted at once.",
)
@click.option(
    "--map",
    "columns",
    metavar="COLUMN=HISTORY",
    multiple=True,
    help="Column and the history it is compared with: height=vertical.travel; of impacts t=impacts.t, v=floor.impacts.speed, "
    "rise=impacts.rebound.vertical.travel (default: the one of equal name).",
)
@click.option(
    "--free",
    metavar="NAME=RANGE",
    multiple=True,
    required=True,
    help='Parameter or initial state to fit, and its range: restitution=0.3..1, stiffness="1e6..1e9 N/m log", clearance=log; NAME alone takes the '
    "range of its law.",
)
@click.option(
    "--noise",
    metavar="COLUMN=SIZE",
    multiple=True,
    help='Standard deviation of the noise of a column: height="0.1 mm" (default: estimated from the residuals, and the fit is not judged).',
)
@click.option(
    "--at",
    "made_at",
    metavar="FILE:NAME=VALUE",
    multiple=True,
    help='Value at which one measured run was made: --at second.csv:drop_height="0.5 m".',
)
@click.option(
    "--offset",
    metavar="RANGE",
    default="0 s",
    help='Run time less measured time: a range to fit for each run, "-2..2 ms", or a value (default: 0 s).',
)
@click.option(
    "--gain",
    metavar="COLUMN=RANGE",
    multiple=True,
    help="Gain of the sensor of a column, to be fitted: height=0.95..1.05 (default: 1).",
)
@click.option(
    "--laws",
    "among",
    metavar="EFFECT=LAW,LAW",
    multiple=True,
    help="Fit with each of several laws, and rank them: floor=flores,hunt_crossley.",
)
@click.option(
    "--moment",
    "moments",
    metavar="NAME[=VALUE +- SIZE]",
    multiple=True,
    help="Statistic of a run beyond its horizon, with its standard deviation: "
    'slider_pin.impact_rate="412 +- 5 1/s", named as in `hertzwerk sweep --output`. Without a value it is computed from '
    "a column of --measured: acceleration.rms; also .mean, .norm8, .norm32, .largest, .excursions, and of impacts .rate.",
)
@click.option(
    "--independent", is_flag=True, help="Values of --moment were measured one by one (default: in one record)."
)
@click.option(
    "--bandwidth",
    metavar="FREQUENCY",
    help='Cut-off frequency of the instrument of --moment: "5 kHz" (default: none).',
)
@click.option("--order", type=int, help="Order of its Butterworth low-pass (default: 4).")
@click.option(
    "--zero-phase",
    is_flag=True,
    help="Filter forwards and backwards, 6 dB down at the cut-off (default: causal, 3 dB down).",
)
@click.option(
    "--skip", metavar="TIME", help="Transient that --moment leaves out of data and runs (default: a tenth of each)."
)
@READING
@VARIATION
@DURATION
@click.option("--tolerance", metavar="NUMBER", help="Local tolerance of the runs (default: 1e-9).")
@BY_METHOD
@click.option(
    "--starts", type=int, help="Number of starts, points of a Latin hypercube, beside the model's values (default: 16)."
)
@click.option("--seed", type=int, help="Seed of the hypercube (default: 0).")
@click.option(
    "--profile",
    type=click.Choice(["auto", "all", "none"]),
    default="auto",
    show_default=True,
    help="Quantities whose intervals come from the profile likelihood; auto: those that the data determine badly.",
)
@click.option(
    "--out", type=click.Path(path_type=Path), help="New folder to write to (default: the next runs/SCENE-fit-NNN)."
)
@click.option("--no-plots", is_flag=True, help="Write the data without pictures.")
@JSON
@reports_bad_input
def fit(target: str, out: Path | None, no_plots: bool, as_json: bool, **options: Any) -> int:
    """Fit parameters of TARGET to measured data.

    The search takes exact derivatives, through impacts too. It reports values with intervals and how each was
    obtained, combinations that the data do not determine, and the goodness of fit. With --laws every law is fitted,
    and they are ranked by AICc and by measured runs held out. Exit code 1: the model is rejected at 5 %, a
    combination is not determined, or the data do not discriminate between the laws.
    """
    wanted = out is not None or not as_json
    faults = unwritable_faults(out, wanted=wanted)
    moments, varied = options.pop("moments"), Variation.taken(target, options)
    options["reading"] = reading_of(options, faults)
    estimates: Estimates
    ranking: Ranking | None
    result: Estimates | Ranking
    with Progress(f"fit of {target}", shown=not as_json) as progress:
        if moments or not options["measured"]:
            estimates, ranking = _of_moments(varied, moments, faults, progress, **options), None
        else:
            faults += [Fault(option, "without --moment", "one beside it") for option in stated_options(*OF_SERIES)]
            others = {name: value for name, value in options.items() if name not in OF_SERIES}
            estimates, ranking = _fitted(varied, faults, progress, **others)
    result = estimates if ranking is None else ranking
    code = conclude(
        lambda missing: _write(estimates, ranking, out, missing, plots=not no_plots),
        result.record,
        lambda: _report(result),
        wanted=wanted,
        as_json=as_json,
    )
    in_doubt = estimates.unidentified or estimates.explained is False or (ranking is not None and ranking.alike)
    return OTHER_OUTCOME if in_doubt else code


def _fitted(
    varied: Variation,
    faults: list[Fault],
    progress: Progress,
    *,
    among: Sequence[str],
    **options: Any,
) -> tuple[Fit, Ranking | None]:
    """Return the fit of a command line, and of several laws their ranking; raises InputError."""
    from hertzwerk.runtime.studies.fitting.fitting import fitted, read_fit
    from hertzwerk.runtime.studies.fitting.law_ranking import law_variants, ranked, read_laws, split_laws

    values, inputs = varied.values(faults), assignments("--input", varied.inputs, faults)
    progress.stage("building")
    model = varied.model(faults)
    arguments = _arguments(model, values, inputs, faults, **options)
    if among:
        several = {effect: split_laws(text) for effect, text in assignments("--laws", among, faults).items()}
        variants, wrong = law_variants(model, several)
        requests = read_laws(variants, arguments.pop("data"), arguments.pop("free"), arguments, [*faults, *wrong])
        progress.stage("fitting")
        ranking = ranked(requests, progress)
        return ranking.best.fitted, ranking
    one = read_fit(model, **arguments, before=faults)
    progress.stage("fitting")
    return fitted(one, progress), None


def _of_moments(
    varied: Variation,
    moments: Sequence[str],
    faults: list[Fault],
    progress: Progress,
    *,
    free: Sequence[str],
    duration: str | None,
    tolerance: str | None,
    method: str | None,
    seed: int | None,
    measured: Sequence[str],
    columns: Sequence[str],
    noise: Sequence[str],
    made_at: Sequence[str],
    bandwidth: str | None,
    order: int | None,
    zero_phase: bool,
    skip: str | None,
    independent: bool,
    reading: Mapping[str, Any],
    **_: Any,
) -> MomentFit:
    """Return the fit of statistics; raises InputError with every fault."""
    from hertzwerk.runtime.engine.inputs.measurement_csv import Reading
    from hertzwerk.runtime.studies.fitting.moments.measured_moments import MeasuredSeries
    from hertzwerk.runtime.studies.fitting.moments.moment_fit import fitted_moments, read_moment_fit

    if not moments:
        faults.append(
            Fault("--measured", "none, and no --moment", "measured data: --measured FILE, or --moment NAME=VALUE")
        )
    computed = [text for text in moments if "=" not in text]
    of_data = ("measured", "columns", "noise", "made_at", *OF_SERIES[:-1])
    beside = stated_options("gain", "among", "offset", "starts", "profile", *(() if computed else of_data))
    faults += [Fault(option, "beside --moment", "one of the two") for option in beside if moments]
    twice = sorted({name for name in computed if computed.count(name) > 1})
    faults += [Fault("--moment", f"{name} twice", "each once") for name in twice]
    values, inputs, stated, mapped, noisy = (
        assignments(option, texts, faults)
        for option, texts in (
            ("--set", varied.settings),
            ("--input", varied.inputs),
            ("--moment", [text for text in moments if "=" in text]),
            ("--map", columns),
            ("--noise", noise),
        )
    )
    series = [
        MeasuredSeries(
            Reading(file, **reading),
            mapped or None,
            noisy,
            bandwidth,
            4 if order is None else order,
            zero_phase,
            skip=skip,
            parameters=own,
        )
        for file, own in _made_at(measured, made_at, faults).items()
        if computed
    ]
    progress.stage("building")
    model = varied.model(faults)
    chosen = {
        "parameters": values,
        "inputs": inputs or None,
        "duration": duration,
        "tolerance": tolerance and number(tolerance),
        "method": method,
    }
    chosen = {name: value for name, value in chosen.items() if value}
    wanted = {**stated, **dict.fromkeys(computed)}
    ranges = _ranges(free, faults)
    request = read_moment_fit(model, wanted, ranges, chosen, seed or 0, faults, series, independent=independent)
    progress.stage("fitting")
    return fitted_moments(request, progress)


def _made_at(measured: Sequence[str], made_at: Sequence[str], faults: list[Fault]) -> dict[str, dict[str, str]]:
    """Return the values of --at by measured file; malformed ones are appended to `faults`."""
    own: dict[str, list[str]] = {file: [] for file in measured}
    for text in made_at:
        file, _, assigned = text.partition(":")
        if file in own:
            own[file].append(assigned)
        else:
            faults.append(Fault("--at", repr(text), f"FILE:NAME=VALUE, FILE one of {', '.join(measured)}"))
    twice = sorted({file for file in measured if list(measured).count(file) > 1})
    faults += [Fault("--measured", f"{file} twice", "each measured run once") for file in twice]
    return {file: assignments("--at", texts, faults) for file, texts in own.items()}


def _ranges(free: Sequence[str], faults: list[Fault]) -> dict[str, str | None]:
    """Return the ranges by name of --free; None for a name alone."""
    ranged = assignments("--free", [text for text in free if "=" in text], faults)
    names = [text.partition("=")[0].strip() for text in free]
    return {name: ranged.get(name) for name in names}


def _arguments(
    model: EngineModel,
    values: dict[str, str],
    inputs: dict[str, str],
    faults: list[Fault],
    *,
    measured: Sequence[str],
    columns: Sequence[str],
    free: Sequence[str],
    noise: Sequence[str],
    made_at: Sequence[str],
    offset: str,
    gain: Sequence[str],
    duration: str | None,
    tolerance: str | None,
    method: str | None,
    starts: int | None,
    seed: int | None,
    profile: str,
    reading: Mapping[str, Any],
) -> dict[str, Any]:
    """Return the arguments of a fit; malformed options are appended to `faults`."""
    from hertzwerk.runtime.engine.inputs.measurement_csv import Reading
    from hertzwerk.runtime.engine.run.run_request import METHOD
    from hertzwerk.runtime.engine.start.start_values import split_values
    from hertzwerk.runtime.studies.fitting.experiment import Experiment
    from hertzwerk.runtime.studies.fitting.parameter_fit import STARTS, TOLERANCE

    parameters, initial = split_values(model, values)
    return {
        "data": [
            Experiment(Reading(file, **reading), own) for file, own in _made_at(measured, made_at, faults).items()
        ],
        "free": _ranges(free, faults),
        "map": assignments("--map", columns, faults) or None,
        "noise": assignments("--noise", noise, faults),
        "parameters": parameters,
        "initial": initial,
        "inputs": inputs or None,
        "duration": duration,
        "offset": offset,
        "gain": assignments("--gain", gain, faults),
        "tolerance": TOLERANCE if tolerance is None else number(tolerance),
        "method": method or METHOD,
        "compiled": "auto",
        "starts": STARTS if starts is None else starts,
        "seed": seed or 0,
        "profile": {"auto": "auto", "all": True, "none": False}[profile],
    }


def _write(
    estimates: Estimates, ranking: Ranking | None, out: Path | None, missing: list[str], *, plots: bool
) -> tuple[Path, list[str]]:
    from hertzwerk.runtime.cli.run_folder import write_study
    from hertzwerk.runtime.cli.target_options import command_line
    from hertzwerk.runtime.studies.fitting.fit_result import Fit
    from hertzwerk.runtime.system.versions import versions

    about = {"command": command_line(), "versions": versions()}
    texts = {"fit.json": record_text({**estimates.record(), **about})}
    if isinstance(estimates, Fit):
        texts["fit.csv"] = estimates.csv()
    if ranking is not None:
        texts["laws.json"] = record_text({**ranking.record(), **about})
    return write_study(f"{estimates.scene}-fit", out, texts, estimates.plot if plots else None, missing)


def _report(result: Estimates | Ranking) -> None:
    for label, text in result.lines():
        line(label, text)
