"""Report of a run: outcome, accuracy, pictures, impacts, parameters, equations."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace
from functools import partial
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.common.markup import Markup, joined, tag
from hertzwerk.runtime.engine.accuracy.error_estimate import VALID, brief
from hertzwerk.runtime.engine.model.free_quantities import quantities
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.si_values import ratio
from hertzwerk.runtime.engine.run.continuation import parameters_of
from hertzwerk.runtime.output.plots.unit_prefixes import scale_of
from hertzwerk.runtime.output.reports import scene_sections
from hertzwerk.runtime.output.reports.html_page import (
    Cell,
    Origin,
    Section,
    bullets,
    facts,
    guarded,
    number_text,
    page,
    paragraphs,
    table,
    unit_markup,
    verdict,
)
from hertzwerk.runtime.system.versions import versions

if TYPE_CHECKING:
    from matplotlib.figure import Figure

    from hertzwerk.runtime.engine.solution.solution import EngineSolution

MOST = 200  # rows of a table of impacts
OF_IMPACT = {"t": "s", "speed": "m/s", "peak_force": "N", "peak_penetration": "m"}


def run_page(
    run: EngineSolution,
    *,
    model: EngineModel | None = None,
    origin: Origin | None = None,
    whole: str = "run.impacts",
    sensitivities: Mapping[str, Any] | None = None,
) -> str:
    """Return the page of a run.

    model    with the declaration, for a saved run that has none: its equations, its picture at the start
    origin   what made it, by default the call that repeats it
    whole    where all impacts are, beyond those that are listed
    sensitivities    as `run.json` has them, of a saved run for which they were requested
    """
    derived = getattr(run, "derivatives", None)
    if derived is not None:
        sensitivities = derived.record(run.engine.states, run.engine.t_end)
    declared = model if model is not None else run.engine.model
    if run.engine.history.integrator is None:
        run = replace(run, engine=run.engine.with_model(declared))
    readable, why = scene_sections.readable_of(declared)
    sections = [
        _heed(run),
        Section("Pictures", joined(_pictures(run, declared))),
        _accuracy(run),
        _impacts(run, whole),
        _checked(run),
        Section("Averages", guarded("Averages", partial(_averages, run))),
        scene_sections.parameters(run.engine.model, run.settings.parameters, readable),
        scene_sections.effects(run.engine.model, readable),
        _states(run),
        _sensitivities(run, sensitivities, whole) if sensitivities else None,
        scene_sections.equations(readable, why),
    ]
    live = run.engine.history.integrator is not None
    made = origin or Origin(call_of(run), versions() if live else None)
    top = joined([_outcome(run), _facts(run)])
    name, summary = run.engine.model.name, run.engine.model.module.SUMMARY
    return page("run", name, summary, top, [section for section in sections if section is not None], made)


def call_of(run: EngineSolution) -> str:
    """Return the call in Python that repeats a run."""
    model, options = run.engine.model, {}
    target, variation = repr(model.name), model.declaration
    if variation is not None:
        target = repr(variation.target) if isinstance(variation.target, str) else f"scene, which is {model.name}"
        options = {
            "without": list(variation.without),
            "laws": dict(variation.laws),
            "coordinates": variation.coordinates,
        }
    load = ", ".join([target, *(f"{name}={value!r}" for name, value in options.items() if value)])
    arguments: dict[str, Any] = {"duration": run.settings.duration}
    arguments |= (
        {"tolerance": run.settings.tolerance} if run.settings.accuracy is None else {"accuracy": run.settings.accuracy}
    )
    arguments |= {} if run.settings.method == "auto" else {"method": run.settings.method}
    parameters = {
        name: value if unit == "1" else f"{value!r} {unit}" for name, (value, unit) in parameters_of(run, model).items()
    }
    initial = {} if run.engine.checkpoint is None else dict(run.engine.checkpoint.initial)
    arguments |= {name: values for name, values in (("parameters", parameters), ("initial", initial)) if values}
    return f"simulate(load({load}), {', '.join(f'{name}={value!r}' for name, value in arguments.items())})"


def _outcome(run: EngineSolution) -> Markup:
    outcome = run.outcome
    return verdict(outcome.name.replace("_", " "), outcome.finished, outcome.message, outcome.remedy)


def _facts(run: EngineSolution) -> Markup:
    statistics, error = run.statistics, run.error
    rows = {
        "time simulated": _quantity(run.engine.t_end - run.engine.t_start, "s"),
        "impacts": number_text(len(run.impacts)),
        "steps": number_text(statistics.steps),
        "method, local tolerance": f"{run.settings.method}, {brief(run.settings.tolerance, 2)}",
        "error of the run": "not estimated" if error is None else str(error),
        "trajectory valid": "not known" if error is None else _horizon(run),
        "energy closed to": "no ledger" if run.energy_residual is None else brief(run.energy_residual, 2),
        "computed in": _quantity(statistics.wall_s, "s"),
    }
    return facts(rows)


def _horizon(run: EngineSolution) -> str:
    until = None if run.error is None else run.error.horizon
    return "the whole run" if until is None else f"until {_quantity(until, 's')}"


def _heed(run: EngineSolution) -> Section | None:
    texts = [*run.warnings, *run.engine.advice]
    return Section("Warnings", bullets(texts)) if texts else None


def _checked(run: EngineSolution) -> Section | None:
    texts = [*map(str, run.engine.validity)]
    return Section("Checks of Hertz's theory", bullets(texts)) if texts else None


def _pictures(run: EngineSolution, declared: EngineModel) -> list[Markup]:
    from hertzwerk.runtime.output.drawings import picture as drawing
    from hertzwerk.runtime.output.plots import plot_run

    def mechanism() -> Figure:
        if run.engine.history.integrator is not None:
            return drawing.of_run(run)
        initial = {} if run.engine.checkpoint is None else run.engine.checkpoint.initial
        return drawing.of_start(declared, parameters_of(run, run.engine.model), initial)

    name = run.engine.model.name
    return [
        scene_sections.drawn(mechanism, "mechanism", f"The mechanism {name}, its clearances enlarged"),
        scene_sections.drawn(lambda: plot_run.plot(run), "overview", f"Motion, forces and energy of {name}"),
        *(
            scene_sections.drawn(partial(plot_run.plot, run, pair), pair, f"Contact {pair}")
            for pair in run.engine.model.pairs
        ),
    ]


def _accuracy(run: EngineSolution) -> Section:
    error, sentences = run.error, []
    if error is None or run.settings.accuracy is None:
        sentences.append(
            f"One run at the local tolerance {brief(run.settings.tolerance, 2)}; its error was not estimated."
        )
    else:
        sentences.append(
            f"Requested: an error of at most {brief(run.settings.accuracy, 3)}{' at the end' if error.at_end else ''}, in the scene's scales; it is "
            f"{error}, known from {error.runs} runs, which took {_quantity(error.pilot_s, 's')} more."
        )
        if error.horizon is None:
            sentences.append(f"The trajectory is valid throughout: its error stays below {VALID:.0%} of the scales.")
        else:
            sentences.append(
                f"The trajectory is valid, with an error below {VALID:.0%} of the scales, until {_quantity(error.horizon, 's')}; "
                "beyond that only averages are."
            )
        if error.growth is not None and error.growth > 0:
            sentences.append(f"Errors grow at {number_text(error.growth, 3)}/s.")
        if error.decade_cost is not None:
            sentences.append(f"Ten times more accuracy would cost about {error.decade_cost:.1f} times the evaluations.")
        if error.floor is not None:
            sentences.append(f"No tolerance gives an error below {brief(error.floor, 2)}.")
    if run.energy_residual is not None:
        sentences.append(
            f"The balance of energy closes to {brief(run.energy_residual, 2)} of the energy that the run moves."
        )
    s = run.statistics
    counts = table(
        ("accepted steps", "rejected", "retaken for events", "evaluations", "contacts begun"),
        [[s.steps, s.rejected, s.retaken, s.rhs_evaluations, s.events]],
    )
    choices = table(
        (("from", "s"), "steps", "because"), [[c.t, c.method, c.reason] for c in run.engine.choices]
    ) if len(run.engine.choices) > 1 else None  # fmt: skip
    return Section("Accuracy and cost", joined([paragraphs(sentences), counts, choices]))


def _impacts(run: EngineSolution, whole: str) -> Section:
    impacts = run.impacts
    if not impacts:
        return Section("Impacts", paragraphs(["There are none."]))
    shown = impacts[:MOST]
    columns = [
        ("onset", "s", [i.t for i in shown]),
        ("approach speed", "m/s", [i.speed for i in shown]),
        ("peak force", "N", [i.peak_force for i in shown]),
        ("penetration", "m", [i.peak_penetration for i in shown]),
        ("duration", "s", [math.nan if i.duration is None else i.duration for i in shown]),
    ]
    scales = [scale_of(unit, values) for _, unit, values in columns]
    rows: list[list[Cell]] = [
        [n + 1, i.contact, *(float(scale(values[n])) for scale, (_, _, values) in zip(scales, columns, strict=True))]
        for n, i in enumerate(shown)
    ]
    sentence = f"{len(impacts):,} in all; an empty duration is that of a contact which had not ended."
    if len(shown) < len(impacts):
        sentence = f"The first {len(shown)} of {len(impacts):,}; all of them are in {whole}."
    heads: list[str | tuple[str, str]] = [
        "no.",
        "contact",
        *((name, s.unit) for (name, _, _), s in zip(columns, scales, strict=True)),
    ]
    return Section("Impacts", joined([paragraphs([sentence]), table(heads, rows)]))


def _averages(run: EngineSolution) -> Markup:
    rows: list[list[Cell]] = [
        [a.name, a.mean, a.half_width, unit_markup(a.unit), a.blocks or None, a.reason] for a in run.averages()
    ]
    heads = ["quantity", "mean", "± 95 %", "unit", "blocks", "why something is missing"]
    sentence = "A tenth of the run is left out as transient; intervals come from the means of blocks of whole periods."
    reasons = {row[-1] for row in rows}
    if len(reasons) == 1:  # stated once
        rows, heads = [row[:-1] for row in rows], heads[:-1]
        if (reason := str(*reasons)) and not any(row[4] for row in rows):
            return paragraphs([f"There are no averages after the transient: {reason}."])
    return joined([paragraphs([sentence]), table(heads, rows)])


def _states(run: EngineSolution) -> Section:
    units: Mapping[str, str] = run.engine.model.units
    rows: list[list[Cell]] = [
        [name, value, run.engine.final[name], unit_markup(units[name])] for name, value in run.engine.initial.items()
    ]
    stated = (
        []
        if run.engine.checkpoint is None
        else [f"{name} = {value}" for name, value in run.engine.checkpoint.initial.items()]
    )
    sentences = [f"Stated in place of the model's start: {', '.join(stated)}."] if stated else []
    heads = ("state", "at the start", "at the end", "unit")
    return Section("States", joined([paragraphs(sentences), table(heads, rows, digits=8)]))


def _sensitivities(run: EngineSolution, by_name: Mapping[str, Any], whole: str) -> Section:
    """Return the derivatives of final states and impacts by each name."""
    units, known, parts = run.engine.model.units, quantities(run.engine.model), list[Markup]()
    for name, derivatives in by_name.items():
        until = (
            f"Up to {_quantity(derivatives['until'], 's')}: {derivatives['reason']}." if derivatives["reason"] else ""
        )
        end: list[list[Cell]] = [
            [state, value, unit_markup(ratio(units[state], known[name]))]
            for state, value in derivatives["final"].items()
        ]
        parts += [
            tag("h3", f"By {name}"),
            paragraphs([until] if until else []),
            table(("state at the end", "derivative", "unit"), end),
        ]
        if run.impacts:
            impacts = {f"d({quantity.replace('_', ' ')})": derivatives["impacts"][quantity] for quantity in OF_IMPACT}
            heads = [
                (quantity, ratio(unit, known[name])) for quantity, unit in zip(impacts, OF_IMPACT.values(), strict=True)
            ]
            rows: list[list[Cell]] = [
                [n + 1, i.contact, *(values[n] for values in impacts.values())]
                for n, i in enumerate(run.impacts[:MOST])
            ]
            parts.append(table(["impact", "contact", *heads], rows))
    lead = "Exact derivatives, by the variational equations through every impact; in SI."
    if len(run.impacts) > MOST:
        lead += f" Of impacts the first {MOST}; all are in {whole}."
    return Section("Sensitivities", joined([paragraphs([lead]), *parts]))


def _quantity(value: float, unit: str) -> str:
    scale = scale_of(unit, value)
    return f"{number_text(float(scale(value)), 5)} {scale.unit}"
