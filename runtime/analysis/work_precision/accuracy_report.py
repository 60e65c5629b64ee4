"""Report of a work-precision study: sentences from its data, a table, numbers for JSON and CSV."""

from __future__ import annotations

import csv
import io
import math
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.common.grouping import grouped
from hertzwerk.runtime.analysis.work_precision.reference_run import Reference
from hertzwerk.runtime.analysis.work_precision.timed_runs import LATE
from hertzwerk.runtime.analysis.work_precision.work_precision_study import NOT_TRIED, Row, Study
from hertzwerk.runtime.engine.accuracy.error_estimate import VALID

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.sensitivity.lyapunov import Lyapunov

NUMBERS = ("method", "requested", "error", "estimate", "steps", "evaluations")
COLUMNS = (*NUMBERS, "time as C", "time in VM", "valid for", "outcome")
FAR = 10
FIELDS = ("method", "compiled", "accuracy", "error", "estimate", "steps", "rhs_evaluations", "time", "horizon")


def conclusions(study: Study) -> list[str]:
    """Return sentences on the cost of ten times more accuracy, the method, the time gained, and chaos."""
    return [_cost(study), _growth(study), *_lyapunov(study)]


def warnings(study: Study) -> list[str]:
    """Return reservations about the numbers."""
    held = study.reference
    reservations = []
    if study.shortened:
        known = "" if math.isinf(held.horizon) else f"; even to 1 % only until {seconds(held.horizon)}"
        reservations.append(
            f"after {seconds(float(held.t[-1]))} of {seconds(study.requested)} no two methods agree on the trajectory well enough to measure "
            f"errors by{known}: errors are those at that time. Statistics of longer runs remain valid, trajectories do not: run.averages()"
        )
    if not study.compiled:
        reservations.append("there is no working C compiler: every time is that of CasADi's virtual machine")
    reservations += [f"{method}: {message}" for method, message in _failures(study.rows).items()]
    return [*reservations, *held.run.warnings]


def rows(study: Study) -> list[tuple[str, ...]]:
    """Return the table; times of both paths in one row, as their results are the same."""
    table: list[tuple[str, ...]] = []
    for method in study.methods:
        machine = study.of(method, compiled=False)
        native: list[Row | None] = [*study.of(method, compiled=True)] or [None] * len(machine)
        for a, c in zip(machine, native, strict=True):
            row = c if c is not None and (c.error is not None or a.error is None) else a
            times = "" if c is None else _time(c), _time(a)
            table.append((*_numbers(study.least, row), *times, valid_for(study, row), _ended(row)))
    return table


def first_rows(held: Reference, runs: Sequence[Row]) -> list[tuple[str, ...]]:
    """Return the table of the runs of one method, each timed once."""
    return [(*_numbers(held.least, row), _time(row), _ended(row)) for row in runs]


def _numbers(least: float, row: Row) -> tuple[str, ...]:
    """Format a row but for its times and horizon; an error below the least measurable one as that bound."""
    error = "" if row.error is None else f"< {least:.1e}" if row.error < least else f"{row.error:.1e}"
    counts = _count(row.steps), _count(row.rhs_evaluations)
    return row.method, f"{row.accuracy:.0e}", error, _number(row.estimate), *counts


def _ended(row: Row) -> str:
    ended = "" if row.outcome == "finished" else row.outcome.replace("_", " ")
    return ended if row.floor is None else f"{ended}, floor {row.floor:.1e}".removeprefix(", ")


def valid_for(study: Study, row: Row) -> str:
    """Format the time a row's trajectory is valid; a growth is extrapolated at most by the factor FAR."""
    if row.horizon is None:
        return "" if row.error is None else f"> {seconds(float(study.reference.t[-1]))}"
    far = FAR * float(study.reference.t[-1])
    return (
        "unbounded" if math.isinf(row.horizon) else f"> {seconds(far)}" if row.horizon > far else seconds(row.horizon)
    )


def seconds(value: float) -> str:
    """Format a time in a suitable unit, three digits."""
    for unit, factor in (("s", 1.0), ("ms", 1e-3)):
        if value >= factor or (unit == "ms" and value >= 1e-4):
            return f"{value / factor:.3g} {unit}"
    return f"{value * 1e6:.3g} µs"


def record(study: Study) -> dict[str, Any]:
    """Return plain numbers in SI, null where undefined.

    A horizon that is null is unbounded where the row says so, else unknown.
    """
    held, grows = study.reference, study.growth
    return {
        "scene": study.problem.model.name,
        "duration": float(held.t[-1]),
        "asked_duration": study.requested,
        "rows": [
            {
                **{name: getattr(row, name) for name in FIELDS},
                "unbounded": row.horizon is not None and math.isinf(row.horizon),
                "outcome": row.outcome,
                "floor": row.floor,
                "message": row.message,
            }
            for row in study.rows
        ],
        "reference": {
            "methods": [held.run.settings.method, held.partner.settings.method],
            "tolerance": held.run.settings.tolerance,
            "uncertainty": held.uncertainty,
            "horizon": held.horizon,
            "levels": [{"tolerance": tolerance, "difference": difference} for tolerance, difference in held.levels],
        },
        "decade_cost": study.decade_cost,
        "recommended": study.recommended,
        "growth": {
            "kind": grows.kind,
            "rate": grows.rate,
            "deviation": grows.deviation,
            "exponent": grows.exponent,
            "intermittent": grows.intermittent,
            "limit": VALID,
            "edges": grows.edges,
            "factors": grows.factors,
            "gained": grows.gained,
        },
        "lyapunov": _exponent(study.lyapunov),
        "methods": {
            method: {
                "decade_cost": study.decade_costs[method],
                "order": study.orders[method],
                "relative_time": study.relative_times[method],
            }
            for method in study.methods
        },
        "auto": [{"accuracy": accuracy, "share_of_time": dict(share)} for accuracy, share in study.taken.items()],
        "gain_of_compilation": study.gain_of_compilation,
        "conclusions": conclusions(study),
        "warnings": warnings(study),
    }


def csv_text(study: Study) -> str:
    """Return the rows as CSV, SI."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\n")
    units = {"time": "s", "horizon": "s"}
    writer.writerow([f"{name} [{units[name]}]" if name in units else name for name in (*FIELDS, "outcome")])
    for row in study.rows:
        writer.writerow(["" if (x := getattr(row, name)) is None else x for name in (*FIELDS, "outcome")])
    return text.getvalue()


def length(study: Study) -> str:
    """Describe the limit that defines a valid trajectory."""
    return "1 % of the clearance" if study.problem.model.journals else "1 % of the scene's length"


def _cost(study: Study) -> str:
    best = study.recommended
    if best is None:
        return "No run reached an error that the reference can measure: no method can be recommended."
    cost = study.decade_cost
    said = (
        "The cost of ten times more accuracy is unknown"
        if cost is None
        else f"Ten times more accuracy costs {plain(cost)} x the time here"
    )
    others = grouped((method, level) for level, method in study.cheapest.items() if method != best)
    count = len(study.cheapest)
    places = [f"{m} at {_listed(f'{x:.0e}' for x in at)}" for m, at in others.items()]
    exceptions = f" (but {_listed(places)})" if places else ""
    where = "at every accuracy" if not others else "on the whole"
    said += f"; take {best}, the cheapest {where}{exceptions}" if count > 1 else f"; take {best}"
    times = {m: t for m, t in study.relative_times.items() if m != best and t is not None}
    if times:
        said += ". For the same error " + _listed(
            f"{m} takes {plain(t)} x its time" for m, t in sorted(times.items(), key=lambda x: x[1])
        )
    gain = study.gain_of_compilation
    return said + ("" if gain is None else f"; compiled, it is {plain(gain)} x as fast as in the virtual machine") + "."


def _growth(study: Study) -> str:
    grows, within = study.growth, length(study)
    span = seconds(float(study.reference.t[-1]))
    if grows.kind == "unknown":
        return f"The growth of errors is unknown: too few of them exceed the floor for long enough in these {span}."
    known = [f for f in grows.factors if math.isfinite(f)]
    step = seconds(grows.edges[1] - grows.edges[0])
    pace = f"by factors of {plain(min(known))} to {plain(max(known))} from one {step} to the next"
    if grows.kind == "none":
        return (
            f"Errors do not grow over these {span} ({pace}): ten times more accuracy means ten times less error, not more time; how long a "
            f"trajectory that is within {within} stays there is unbounded."
        )
    how = "intermittently, " if grows.intermittent else ""
    if grows.kind == "exponential":
        return (
            f"Errors grow at {plain(grows.rate)}/s ({how}{pace}): ten times more accuracy keeps the trajectory within {within} for "
            f"{seconds(grows.gained)} more."
        )
    return (
        f"Errors grow like t^{plain(grows.exponent)} ({how}{pace}): ten times more accuracy keeps the trajectory within {within} for "
        f"{plain(10 ** (1 / grows.exponent))} x the time."
    )


def _lyapunov(study: Study) -> list[str]:
    """Return what the largest exponent is, and how far its values in parts of the run spread."""
    lyapunov = study.lyapunov
    if lyapunov is None:
        return []
    low, high = lyapunov.spread
    meaning = (
        "chaos, or an unstable motion" if lyapunov.chaotic else "neighbouring motions do not separate exponentially"
    )
    return [
        f"The largest Lyapunov exponent of the motion, from its variational equations, is "
        f"{plain(lyapunov.law.rate)} +- {plain(lyapunov.law.deviation)} /s "
        f"over this time, from {plain(low)} to {plain(high)} /s in twelfths of it: {meaning}."
    ]


def _exponent(lyapunov: Lyapunov | None) -> dict[str, Any] | None:
    if lyapunov is None:
        return None
    largest, law = lyapunov.exponents[0], lyapunov.law
    return {
        "rate": law.rate,
        "deviation": law.deviation,
        "kind": law.kind,
        "factors": law.factors,
        "mean": largest.mean,
        "half_width": largest.half_width,
        "reason": largest.reason,
    }


def _failures(runs: Iterable[Row]) -> dict[str, str]:
    """Return the failures of runs, one message for each method."""
    failed: dict[str, str] = {}
    for row in runs:
        if row.error is None and row.outcome not in (NOT_TRIED, *LATE):
            failed.setdefault(row.method, f"requested {row.accuracy:.0e}, {row.message}")
    return failed


def plain(value: float) -> str:
    """Format a number with two digits, without an exponent where that is short."""
    return f"{float(f'{value:.2g}'):g}"


def _time(row: Row) -> str:
    if row.time is None:
        return ""
    return f"more than {seconds(row.time)}" if row.outcome in LATE else seconds(row.time)


def _number(value: float | None) -> str:
    return "" if value is None else f"{value:.1e}"


def _count(value: int | None) -> str:
    return "" if value is None else f"{value:,}"


def _listed(parts: Iterable[str]) -> str:
    """Join words: a; a and b; a, b and c."""
    words: Sequence[str] = list(parts)
    return words[0] if len(words) == 1 else f"{', '.join(words[:-1])} and {words[-1]}"
