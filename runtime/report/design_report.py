"""Reports of propagated uncertainty and of a minimum, from their records."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from hertzwerk.derive.html.markup import Markup, embedded, joined, tag
from hertzwerk.runtime.report.html_page import Origin, Section, bullets, facts, page, paragraphs, verdict
from hertzwerk.runtime.report.html_table import Cell, number_text, table, unit_markup

Record = Mapping[str, Any]

MOST = 500  # rows of a table of runs
SPREADS = {
    **{"nominal": "at the means", "linear": "std by derivatives", "std": "std of samples", "std_error": "± of std"},
    **{"mean": "mean of samples", "mean_error": "± of mean", "low": "2.5 % quantile", "high": "97.5 % quantile"},
}


def propagation_page(record: Record, picture: bytes | None, origin: Origin) -> str:
    """Return the page of propagated uncertainty from its record (`propagation.json`) and its picture.

    Raises KeyError, TypeError or ValueError for what is no such record.
    """
    outputs, names, warnings = record["outputs"], [str(n) for n in record["uncertain"]], list(record["warnings"])
    word = "derivatives and samples agree" if not warnings else "to be heeded"
    told = "" if not warnings else "Derivatives and samples differ, or something is missing: see the warnings."
    counted = {"runs": number_text(int(record["runs"])), "outputs": number_text(len(outputs))}
    rows: list[list[Cell]] = [
        [name, unit_markup(one["unit"]), *(one[key] for key in SPREADS)] for name, one in outputs.items()
    ]
    reasons = [f"{name}: no derivatives, as {one['reason']}" for name, one in outputs.items() if one["reason"]]
    owed = [_owed(name, one) for name, one in outputs.items()]
    sections = [
        *([Section("Warnings", bullets(list(map(str, warnings))))] if warnings else []),
        *_pictures(picture, "Samples of each output, the spread of its derivatives, and its indices"),
        Section("Spread", joined([
            table([(head, "") for head in ("output", "unit", *SPREADS.values())], rows), bullets(reasons) if reasons else None,
        ])),
        Section("What it is owed to", joined([paragraphs([
            "Standard deviation that each alone causes, by the derivatives; parts of the variance by Sobol's indices, with 95 % intervals.",
        ], "note"), *owed])),
    ]  # fmt: skip
    top = joined([verdict(word, not warnings, told), facts(counted)])
    return page("propagation", str(record["scene"]), f"uncertain: {', '.join(names)}", top, sections, origin)


def _owed(name: str, one: Record) -> Markup:
    unit = str(one["unit"])
    there = list(dict.fromkeys([*one["derivatives"], *one["first"]]))
    rows: list[list[Cell]] = [
        [
            each,
            one["derivatives"].get(each),
            one["parts"].get(each),
            *(_index(one[kind].get(each)) for kind in ("first", "total")),
        ]
        for each in there
    ]
    heads = [
        ("by", ""),
        ("derivative, SI", ""),
        ("its std", unit or "1"),
        ("part alone", ""),
        ("with interactions", ""),
    ]
    return joined([tag("h3", name), table(heads, rows, digits=4)])


def _index(index: Record | None) -> str | None:
    if index is None:
        return None
    value, low, high = (number_text(float(index[key]), 3) for key in ("value", "low", "high"))
    return f"{value} ({low} to {high})"


def minimum_page(record: Record, picture: bytes | None, origin: Origin) -> str:
    """Return the page of a minimisation from its record (`minimum.json`) and its picture.

    Raises KeyError, TypeError or ValueError for what is no such record.
    """
    objective, finished = record["objective"], record["outcome"] == "finished"
    unit = f" {objective['unit']}" if objective["unit"] else ""
    counted = {
        "least": f"{number_text(objective['value'], 6)}{unit}",
        "at the start": f"{number_text(objective['begun'], 6)}{unit}",
        "runs": number_text(len(record["trials"])),
        "derivatives": "exact" if record["exact"] else "by differences of runs",
    }
    if record["checked"] is not None:
        counted["checked by a difference to"] = number_text(float(record["checked"]), 2)
    values: list[list[Cell]] = [
        [
            name,
            one["value"],
            unit_markup(one["unit"]),
            record["gradient"].get(name),
            "at the end of its range" if name in record["at_end"] else "",
        ]
        for name, one in record["values"].items()
    ]
    held: list[list[Cell]] = [
        [one["text"], one["value"], unit_markup(one["unit"]), one["state"]] for one in record["constraints"]
    ]
    searches: list[list[Cell]] = [
        [_at(one["begun"]), _at(one["values"]), one["objective"], one["outcome"], "yes" if one["here"] else "no"]
        for one in record["searches"]
    ]
    notes = list(map(str, record["notes"]))
    of_values = ("quantity", "value", "unit", "derivative of the objective, SI", "")
    of_searches = ("begun at", "ended at", "objective", "outcome", "the minimum")
    sections = [
        Section("Values", _plain(of_values, values)),
        *([Section("Constraints", _plain(("constraint", "value", "unit", ""), held))] if held else []),
        *([Section("To be heeded", bullets(notes))] if notes else []),
        *_pictures(picture, "Objective and values of all runs"),
        *([Section("Starts", _plain(of_searches, searches))] if searches else []),
        Section("Runs", _trials(record["trials"])),
    ]
    top = joined([verdict(str(record["outcome"]).replace("_", " "), finished, str(record["message"])), facts(counted)])
    return page("minimum", str(record["scene"]), f"least {objective['text']}", top, sections, origin)


def _trials(trials: list[Record]) -> Markup:
    names = list(trials[0]["values"]) if trials else []
    told = [f"The first {MOST} of {len(trials):,}; all are in minimum.json."] if len(trials) > MOST else []
    rows: list[list[Cell]] = [
        [n, *(one["values"][name] for name in names), one["objective"], "yes" if one["feasible"] else "no"]
        for n, one in enumerate(trials[:MOST], 1)
    ]
    heads = ("run", *(f"{name}, SI" for name in names), "objective", "constraints kept")
    return joined([paragraphs(told, "note"), _plain(heads, rows)])


def _plain(heads: Sequence[str], rows: list[list[Cell]]) -> Markup:
    return table([(head, "") for head in heads], rows, digits=7)


def _at(values: Record) -> str:
    return ", ".join(f"{name} = {number_text(value, 6)}" for name, value in values.items())


def _pictures(picture: bytes | None, label: str) -> list[Section]:
    return [Section("Picture", tag("figure", embedded(picture, label)))] if picture is not None else []
