"""Reports of what commands recorded: studies, fits, propagated uncertainty, minima."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any

from hertzwerk.derive.common.markup import Markup, embedded, joined, tag
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
from hertzwerk.runtime.output.reports.inline_svg import picture
from hertzwerk.runtime.system.digests import read_sealed

Record = Mapping[str, Any]

MOST = 500  # rows of a table
SPREADS = {
    **{"nominal": "at the means", "linear": "std by derivatives", "std": "std of samples", "std_error": "± of std"},
    **{"mean": "mean of samples", "mean_error": "± of mean", "low": "2.5 % quantile", "high": "97.5 % quantile"},
}


def propagation_page(record: Record, folder: Path, origin: Origin) -> str:
    """Return the page of propagated uncertainty from its record and the picture in its folder.

    Raises KeyError, TypeError or ValueError for what is no such record.
    """
    outputs, names, warnings = record["outputs"], [str(n) for n in record["uncertain"]], list(record["warnings"])
    word = "derivatives and samples agree" if not warnings else "to be heeded"
    remark = "" if not warnings else "Derivatives and samples differ, or something is missing: see the warnings."
    counted = {"runs": number_text(int(record["runs"])), "outputs": number_text(len(outputs))}
    rows: list[list[Cell]] = [
        [name, unit_markup(one["unit"]), *(one[key] for key in SPREADS)] for name, one in outputs.items()
    ]
    reasons = [f"{name}: no derivatives, as {one['reason']}" for name, one in outputs.items() if one["reason"]]
    contributions = [_contributions(name, one) for name, one in outputs.items()]
    sections = [
        *([Section("Warnings", bullets(list(map(str, warnings))))] if warnings else []),
        *_pictures(folder / "propagation.png", "Samples of each output, the spread of its derivatives, and its indices"),
        Section("Spread", joined([
            table(("output", "unit", *SPREADS.values()), rows), bullets(reasons) if reasons else None,
        ])),
        Section("Contributions", joined([paragraphs([
            "Standard deviation that each alone causes, by the derivatives; parts of the variance by Sobol's indices, with 95 % intervals.",
        ], "note"), *contributions])),
    ]  # fmt: skip
    top = joined([verdict(word, not warnings, remark), facts(counted)])
    return page("propagation", str(record["scene"]), f"uncertain: {', '.join(names)}", top, sections, origin)


def _contributions(name: str, one: Record) -> Markup:
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
    heads = ("by", "derivative, SI", ("its std", unit or "1"), "part alone", "with interactions")
    return joined([tag("h3", name), table(heads, rows, digits=4)])


def _index(index: Record | None) -> str | None:
    if index is None:
        return None
    value, low, high = (number_text(float(index[key]), 3) for key in ("value", "low", "high"))
    return f"{value} ({low} to {high})"


def minimum_page(record: Record, folder: Path, origin: Origin) -> str:
    """Return the page of a minimisation from its record and the picture in its folder.

    Raises KeyError, TypeError or ValueError for what is no such record.
    """
    objective, finished = record["objective"], record["outcome"] == "finished"
    unit = f" {objective['unit']}" if objective["unit"] else ""
    counted = {
        "minimum": f"{number_text(objective['value'], 6)}{unit}",
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
        Section("Values", table(of_values, values, digits=7)),
        *([Section("Constraints", table(("constraint", "value", "unit", ""), held, digits=7))] if held else []),
        *([Section("To be heeded", bullets(notes))] if notes else []),
        *_pictures(folder / "minimum.png", "Objective and values of all runs"),
        *([Section("Starts", table(of_searches, searches, digits=7))] if searches else []),
        Section("Runs", _trials(record["trials"])),
    ]
    top = joined([verdict(str(record["outcome"]).replace("_", " "), finished, str(record["message"])), facts(counted)])
    return page("minimum", str(record["scene"]), f"minimum {objective['text']}", top, sections, origin)


def _trials(trials: list[Record]) -> Markup:
    names = list(trials[0]["values"]) if trials else []
    remark = [f"The first {MOST} of {len(trials):,}; all are in minimum.json."] if len(trials) > MOST else []
    rows: list[list[Cell]] = [
        [n, *(one["values"][name] for name in names), one["objective"], "yes" if one["feasible"] else "no"]
        for n, one in enumerate(trials[:MOST], 1)
    ]
    heads = ("run", *(f"{name}, SI" for name in names), "objective", "constraints kept")
    return joined([paragraphs(remark, "note"), table(heads, rows, digits=7)])


def _at(values: Record) -> str:
    return ", ".join(f"{name} = {number_text(value, 6)}" for name, value in values.items())


def _pictures(file: Path, label: str) -> list[Section]:
    return [Section("Picture", shown)] if (shown := _embedded(file, label)) else []


def _embedded(file: Path, label: str) -> Markup | None:
    return tag("figure", embedded(file.read_bytes(), label)) if file.is_file() else None


MARKS = {True: "holds", False: "fails", None: "found"}


def study_page(record: Record, folder: Path, origin: Origin) -> str:
    """Return the page of a study from its record and the figures (SVG) in its folder.

    Raises KeyError, TypeError or ValueError for what is no such record.
    """
    verdicts = [(v["text"], v["source"], v["holds"]) for v in record["verdicts"]]
    compared = [holds for _, _, holds in verdicts if holds is not None]
    top = paragraphs([str(record["question"])], "lead") if "question" in record else Markup("")
    if compared:
        said = f"{sum(compared)} of {len(compared)} comparisons hold"
        top = joined([top, verdict(said, all(compared), "All numbers are in the verdicts and tables below.")])
    lacking = [str(text) for text in record["lacking"]]
    sections = [
        Section("Method", paragraphs([str(text) for text in record["paragraphs"]])),
        *([Section("Verdicts", _verdicts(verdicts))] if verdicts else []),
        *([Section("Missing", bullets(lacking))] if lacking else []),
        *(Section(str(f["title"]), _figure(f, folder, i)) for i, f in enumerate(record["figures"])),
        *(Section(str(t["title"]), _table(t)) for t in record["tables"]),
    ]
    return page("study", str(record["title"]), "", top, sections, origin)


def _verdicts(verdicts: list[tuple[str, str, bool | None]]) -> Markup:
    looks = {True: "badge good", False: "badge", None: "badge neutral"}
    return bullets([
        joined([tag("span", MARKS[holds], class_=looks[holds]), f" {text} ", tag("span", f"({source})", class_="note")])
        for text, source, holds in verdicts
    ])  # fmt: skip


def _figure(figure: Record, folder: Path, number: int) -> Markup:
    title, path = str(figure["title"]), str(figure["path"])
    file = folder / path
    if Path(path).name != path or not file.is_file():  # nothing outside
        return paragraphs([f"{path} is not in the folder of the record."], "note")
    return guarded(f"The picture {path}", lambda: picture(file.read_text("utf-8"), f"figure-{number}", title))


def _table(content: Record) -> Markup:
    rows = content["rows"]
    remark = (
        [f"The first {MOST} of {len(rows):,} rows; all of them are in {content['name']}.csv."]
        if len(rows) > MOST
        else []
    )
    heads = [(str(name), str(unit)) for name, unit in content["header"]]
    shown = [
        [cell if isinstance(cell, (int, float)) or cell is None else str(cell) for cell in row] for row in rows[:MOST]
    ]
    return joined([paragraphs(remark, "note"), table(heads, shown, digits=4)])


def fit_page(record: Record, folder: Path, origin: Origin) -> str:
    """Return the page of a fit from its record, and the picture and the ranking of laws in its folder.

    Raises KeyError, TypeError or ValueError for what is no such record.
    """
    known, identified = record["explained"], not record["unidentified"]
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
    good = False if known is False or not identified else known
    top = joined([verdict(words[known], good, str(record["verdict"])), facts(counted)])
    warnings = [str(text) for text in record["warnings"]]
    of_moments = "Fitted statistics beside measured ones, and the objective along each quantity"
    label = "Measured data over the best fit, and the residuals" if "signals" in record else of_moments
    residuals = _signals(record["signals"]) if "signals" in record else _moments(record["moments"])
    laws = folder / "laws.json"
    sections = [
        Section("Values", _values({**record["values"], **record.get("nuisance", {})})),
        *([Section("Warnings", bullets(warnings))] if warnings else []),
        Section("Residuals", joined([_embedded(folder / "fit.png", label), residuals])),
        Section("Identifiability", _identifiability(record)),
        *([Section("Laws", _laws(read_sealed(laws)))] if laws.is_file() else []),
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
    return table(heads, rows, digits=7)


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
    return table(heads, rows)


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
    return table(heads, rows)


def _identifiability(record: Record) -> Markup:
    """Return correlations, singular values with their directions, and the unidentifiable combinations."""
    names = [str(name) for name in record.get("names", record["values"])]
    unidentified = [str(text) for text in record["unidentified"]]
    pairs: list[list[Cell]] = [
        [name, *(None if value is None else float(value) for value in row)]
        for name, row in zip(names, record["correlation"], strict=True)
    ]
    parts = [
        paragraphs(["Combinations that the data do not identify; do not use the values of their quantities."]),
        bullets(unidentified),
    ]
    singular: list[list[Cell]] = [
        [float(value), *map(float, direction)]
        for value, direction in zip(record["singular_values"], record["directions"], strict=True)
    ]
    return joined([
        *(parts if unidentified else [paragraphs(["The data identify every combination of the quantities."])]),
        tag("h3", "Correlation of the estimates"),
        table(("", *names), pairs, digits=3),
        tag("h3", "Singular values of the scaled Jacobian"),
        paragraphs(["Each is 1 over the standard deviation of its direction, in half ranges or factors of e."], "note"),
        table(("singular value", *names), singular, digits=3),
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
    return joined([paragraphs([str(laws["verdict"])]), table(heads, rows)])
