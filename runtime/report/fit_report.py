"""Report of a fit: values with intervals, what the data tell, goodness, residuals, laws."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from hertzwerk.derive.html.markup import Markup, embedded, joined, tag
from hertzwerk.runtime.report.html_page import Origin, Section, bullets, facts, page, paragraphs, verdict
from hertzwerk.runtime.report.html_table import Cell, number_text, table

Record = Mapping[str, Any]


def fit_page(record: Record, picture: bytes | None, laws: Record | None, origin: Origin) -> str:
    """Return the page of a fit from its record (`fit.json`), its picture, and a ranking of laws.

    Raises KeyError, TypeError or ValueError for what is no such record.
    """
    known, told = record["explained"], not record["untold"]
    words = {True: "explained", False: "rejected", None: "not judged"}
    counted = {"runs made": number_text(int(record["runs_made"]))}
    if "share" in record:
        used, all_data = (sum(int(signal[key]) for signal in record["signals"]) for key in ("used", "data"))
        counted |= {"data": number_text(all_data), "used": number_text(used)}
    if (goodness := record["goodness"]) is not None:
        counted |= {
            "chi-squared": number_text(float(goodness["chi_square"])),
            "degrees of freedom": number_text(int(goodness["freedom"])),
            "p-value": number_text(float(goodness["p_value"]), 3),
        }
    good = False if known is False or not told else known
    top = joined([verdict(words[known], good, str(record["verdict"])), facts(counted)])
    warnings = [str(text) for text in record["warnings"]]
    of_moments = "Fitted statistics beside measured ones, and the objective along each quantity"
    label = "Measured data over the best fit, and the residuals" if "signals" in record else of_moments
    shown = [tag("figure", embedded(picture, label))] if picture is not None else []
    residuals = [_signals(record["signals"])] if "signals" in record else [_moments(record["moments"])]
    sections = [
        Section("Values", _values({**record["values"], **record.get("nuisance", {})})),
        *([Section("Warnings", bullets(warnings))] if warnings else []),
        Section("Residuals", joined([*shown, *residuals])),
        Section("What the data tell", _told(record)),
        *([Section("Laws", _laws(laws))] if laws is not None else []),
    ]
    lead = ", ".join(map(str, record["runs"])) if "runs" in record else "statistics of long runs"
    return page("fit", str(record["scene"]), f"fitted to {lead}", top, sections, origin)


def _values(values: Mapping[str, Record]) -> Markup:
    rows: list[list[Cell]] = []
    for name, value in values.items():
        ends = value["interval"]
        low, high = (
            f"{'open at ' if ends[f'open_{end}'] else ''}{number_text(ends[end], 6)}" for end in ("low", "high")
        )
        searched = f"{number_text(value['low'])} to {number_text(value['high'])}{', by ratios' if value['log'] else ''}"
        rows.append([name, float(value["value"]), str(value["unit"]), low, high, searched, str(ends["how"])])
    heads = ("quantity", "value", "unit", "95 % from", "to", "searched", "interval obtained by")
    return table([(head, "") for head in heads], rows, digits=7)


def _signals(signals: Sequence[Record]) -> Markup:
    rows: list[list[Cell]] = []
    for signal in signals:
        residual = signal["residual"] or {}
        kind = "stated" if signal["noise_stated"] else "from the residuals"
        rows.append([
            str(signal["run"]), str(signal["column"]), str(signal["history"]), str(signal["unit"]), int(signal["used"]),
            residual.get("rms"), residual.get("peak"), float(signal["noise"]), kind,
        ])  # fmt: skip
    heads = ("run", "column", "history", "unit", "data used", "rms", "peak", "noise", "noise is")
    return table([(head, "") for head in heads], rows)


def _moments(moments: Sequence[Record]) -> Markup:
    rows: list[list[Cell]] = [
        [
            str(one["name"]),
            str(one["unit"]),
            *(float(one[key]) for key in ("value", "deviation", "fitted", "fitted_deviation")),
            (one["value"] - one["fitted"]) / (one["deviation"] ** 2 + one["fitted_deviation"] ** 2) ** 0.5,
        ]
        for one in moments
    ]
    heads = ("statistic", "unit", "measured", "deviation", "fitted", "its deviation", "differs by deviations")
    return table([(head, "") for head in heads], rows)


def _told(record: Record) -> Markup:
    """Return correlations, singular values with their directions, and the combinations that are not told."""
    names = [str(name) for name in record.get("names", record["values"])]
    untold = [str(text) for text in record["untold"]]
    pairs: list[list[Cell]] = [
        [name, *(None if value is None else float(value) for value in row)]
        for name, row in zip(names, record["correlation"], strict=True)
    ]
    parts = [
        paragraphs(["Combinations that the data do not identify; do not use the values of their quantities."]),
        bullets(untold),
    ]
    singular: list[list[Cell]] = [
        [float(value), *map(float, direction)]
        for value, direction in zip(record["singular_values"], record["directions"], strict=True)
    ]
    return joined([
        *(parts if untold else [paragraphs(["The data tell every combination of the quantities."])]),
        tag("h3", "Correlation of the estimates"),
        table([("", ""), *((name, "") for name in names)], pairs, digits=3),
        tag("h3", "Singular values of the scaled Jacobian"),
        paragraphs(["Each is 1 over the standard deviation of its direction, in half ranges or factors of e."], "note"),
        table([("singular value", ""), *((name, "") for name in names)], singular, digits=3),
    ])  # fmt: skip


def _laws(laws: Record) -> Markup:
    rows: list[list[Cell]] = []
    for law in laws["laws"]:
        goodness = law["fit"]["goodness"]
        p = None if goodness is None else float(goodness["p_value"])
        values = ", ".join(
            f"{n} = {number_text(v['value'])} {v['unit']}".removesuffix(" 1") for n, v in law["fit"]["values"].items()
        )
        held = float(sum(law["held_out"])) if law["held_out"] else None
        rows.append([str(law["name"]), float(law["difference"]), float(law["weight"]), held, p, values])
    heads = ("law", "AICc less the best", "weight", "held-out log-density", "p-value", "fitted")
    return joined([paragraphs([str(laws["verdict"])]), table([(head, "") for head in heads], rows)])
