"""Pictures and the handbook's page, from the CSV files in `results/` alone."""

from __future__ import annotations

import math
from pathlib import Path
from typing import Any, NamedTuple

from benchmarks.contact.measuring import NOT_STATED, read
from benchmarks.contact.problems import PROBLEMS
from benchmarks.ratios import seconds

FOLDER = Path(__file__).parent
ROOT = FOLDER.parents[2]
RESULTS = FOLDER / "results"
PAGE = ROOT / "runtime" / "handbook" / "explanation" / "peers.md"
FIGURE = ROOT / ".readme" / "peers.png"
COLOURS = {
    "hertzwerk": "#c0392b", "Drake": "#2471a3", "SciPy": "#7f8c8d", "heyoka": "#1e8449", "Exudyn": "#b9770e",
    "MuJoCo": "#6c3483", "Pinocchio": "#117a65", "C++": "#000000", "CVODE": "#d35db0",
}  # fmt: skip


IMPACTS = (1e-5, 1e-7, 1e-9, 1e-11)  # s


class Best(NamedTuple):
    """Cheapest setting of a peer for an error."""

    seconds: float
    integrator: str
    setting: str


def best(rows: list[dict[str, Any]], target: float, compiled: bool | None = None, column: str = "error") -> Best | None:
    """Return the cheapest setting that meets the error, as do all tighter settings of its integrator; None if none does."""
    found = []
    for name in sorted({row["integrator"] for row in rows}):
        if compiled is not None and name.endswith(" compiled") != compiled:
            continue
        # tight to loose, so far as all meet it
        for row in sorted((r for r in finished(rows) if r["integrator"] == name), key=lambda r: float(r["setting"])):
            if not float(row[column]) <= target:  # nan: not reported
                break
            found.append(Best(float(row["seconds"]), name, row["setting"]))
    return min(found, default=None)


def finished(rows: list[dict[str, Any]]) -> list[dict[str, Any]]:
    """Rows that have a time."""
    return [row for row in rows if row["outcome"] == "finished"]


def sides(rows: list[dict[str, Any]]) -> dict[str, tuple[list[dict[str, Any]], bool | None]]:
    """Rows of each side that is compared; hertzwerk is two, uncompiled and compiled."""
    found: dict[str, tuple[list[dict[str, Any]], bool | None]] = {}
    for name in sorted({row["peer"] for row in rows}, key=lambda name: (name != "hertzwerk", name.lower())):
        own = [row for row in rows if row["peer"] == name]
        if name == "hertzwerk":
            found |= {name: (own, False), "hertzwerk, compiled": (own, True)}
        else:
            found[name] = own, None
    return found


def table(rows: list[dict[str, Any]], targets: tuple[float, ...], column: str = "error") -> list[str]:
    """Lines of a Markdown table: for each error the least processor time of each peer, the least of all in bold."""
    each = sides(rows)
    chosen = {name: [best(own, target, how, column) for target in targets] for name, (own, how) in each.items()}
    least = [min((found[i] for found in chosen.values() if found[i]), default=None) for i in range(len(targets))]
    heads = [f"error at most {target:.0e}".replace("e-0", "e-") for target in targets]
    lines = ["| peer | " + " | ".join(heads) + " |", "|---|" + "---|" * len(targets)]
    absent = []
    for name, found in chosen.items():
        if not any(found):
            own, how = each[name]
            absent.append((name, [r for r in own if how is None or r["integrator"].endswith(" compiled") == how]))
            continue
        cells = []
        for one, first in zip(found, least, strict=True):
            text = f"{seconds(one.seconds)} ({one.integrator.removesuffix(' compiled')}, {one.setting})" if one else "-"
            cells.append(f"**{text}**" if one and one == first else text)
        lines.append(f"| {name} | " + " | ".join(cells) + " |")
    others = []
    for name, own in absent:
        errors = [float(row[column]) for row in finished(own)]
        why = f"smallest error {min(errors):.1e}" if errors else own[0]["outcome"] if own else "not measured"
        if why == NOT_STATED:
            others.append(name)
        else:
            lines.append(f"| {name} | {why} | " + " | ".join("" for _ in targets[1:]) + " |")
    return [*lines, "", f"The benchmark does not state it for {', '.join(others)}."] if others else lines


def measured() -> dict[str, list[dict[str, str]]]:
    """Rows of each problem that has results, in the order of the problems."""
    return {name: read(RESULTS / f"{name}.csv") for name in PROBLEMS if (RESULTS / f"{name}.csv").is_file()}


def page() -> str:
    """Text of the handbook's page."""
    results = measured()
    rows = [row for own in results.values() for row in own]
    versions = {row["peer"]: row["version"] for row in rows if row["version"]}
    days: dict[str, set[str]] = {}
    for row in rows:
        days.setdefault(f"{row['machine']}; Python {row['python']}", set()).add(row["date"])
    loads = [float(row["load"]) for row in rows if row["load"]]
    parts = [
        INTRODUCTION.rstrip(),
        "",
        "Versions: " + ", ".join(f"{name} {version}" for name, version in sorted(versions.items())) + ".",
        "",
        *(f"Measured on {' and '.join(sorted(own))}: {where}." for where, own in sorted(days.items())),
        f"The load of the machine was {min(loads):.1f} to {max(loads):.1f}." if loads else "",
        "",
    ]
    for name, own in results.items():
        problem = PROBLEMS[name]()
        parts += [
            f"## {problem.title}",
            "",
            f"The error is the largest of all coordinates at the samples [{problem.unit}].",
            "",
        ]
        parts += [*table(own, problem.targets), "", *verdict(own, problem.targets), *filter(None, [problem.remark]), ""]
        reported = {row["peer"] for row in own if row["impact_error"] not in ("", "nan")}
        if reported:
            parts += ["The largest error of an onset of an impact [s]. A peer without a row reports none:", ""]
            parts += [*table([row for row in own if row["peer"] in reported], IMPACTS, "impact_error"), ""]
    return "\n".join(parts).rstrip() + "\n"


INTRODUCTION = """# How does hertzwerk compare with its peers?

These tables show the least processor time of a call for an error. Less is better, and bold marks the least of a column.
Each peer has every integrator that it offers, over its range of accuracy or step. Its documentation decides how it is set up.
A cell names the integrator and its tolerance, accuracy or step. All tighter settings of that integrator meet the error too.

The time is that of the call a user makes, after a warm-up. Building and compiling a model is not in it.
Times are medians, and the peers alternate. References are in extended precision.
Load raises times, and it varied. Compare the times of one problem, not those of two.

Peers differ in what they take. SciPy and heyoka take equations that a person wrote, and have no search for contacts.
C++ and CVODE are programs for one mechanism, and their time is that of the run within the program.
Pinocchio has no integrator, so SciPy's integrate the accelerations that it computes. The others take bodies.
heyoka gains most where a force is a polynomial of the state, as the laws of the balls and the cradle are.
MuJoCo has its own law of contact, so it is compared with its own limit of small steps.
A dash means that no call within the time limit of the benchmark reached the error.

Run the benchmark with `python tests/benchmarks/contact/run.py`. The README beside it explains how to add a peer by one file.
"""


def verdict(rows: list[dict[str, Any]], targets: tuple[float, ...]) -> list[str]:
    """Sentences that name the fastest side of each error."""
    first: dict[str, list[float]] = {}
    for target in targets:
        found = {name: best(own, target, how) for name, (own, how) in sides(rows).items()}
        reached = {name: one for name, one in found.items() if one is not None}
        if reached:
            first.setdefault(min(reached, key=lambda name: reached[name]), []).append(target)
    return [
        f"The fastest at {', '.join(f'{target:.0e}' for target in own)} is {name}.".replace("e-0", "e-")
        for name, own in first.items()
    ]


# ---- pictures --------------------------------------------------------------------------------------------------------


def draw(axes: Any, rows: list[dict[str, Any]], problem: Any) -> None:
    """Draw work against error: for each peer the front of its best settings as a line, the others as faint dots."""
    for name, (own, how) in sides(rows).items():
        points = sorted(
            (float(r["seconds"]) * 1e3, max(float(r["error"]), 1e-16))
            for r in finished(own)
            if how is None or r["integrator"].endswith(" compiled") == how
        )
        if not points:
            continue
        colour = COLOURS.get(name.split(",")[0], "#555555")
        front, least = [], math.inf
        for time, error in points:
            if error < least:
                front.append((time, error))
                least = error
        axes.plot(*zip(*points, strict=True), ".", color=colour, alpha=0.25, markersize=4)
        style = "--" if how is False else "-"
        axes.plot(*zip(*front, strict=True), style, marker="o", markersize=4, color=colour, label=name)
    axes.set(xscale="log", yscale="log", xlabel="processor time of a call [ms]", ylabel=f"error [{problem.unit}]")
    axes.set_title(problem.title)
    axes.grid(alpha=0.3)


def pictures() -> None:
    """Write a picture for each problem, and the README's."""
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    results = measured()
    for name, rows in results.items():
        figure, axes = pyplot.subplots(figsize=(9, 5), layout="constrained")
        draw(axes, rows, PROBLEMS[name]())
        figure.legend(fontsize=8, loc="outside right upper")
        figure.savefig(RESULTS / f"{name}.png", dpi=100)
        pyplot.close(figure)
    shown = [name for name in SHOWN if name in results]
    if shown:
        figure, all_axes = pyplot.subplots(1, len(shown), figsize=(5 * len(shown), 4.2), layout="constrained")
        for axes, name in zip([all_axes] if len(shown) == 1 else all_axes, shown, strict=True):
            draw(axes, results[name], PROBLEMS[name]())
        handles = {
            label: handle
            for axes in figure.axes
            for handle, label in zip(*axes.get_legend_handles_labels(), strict=True)
        }
        figure.legend(handles.values(), handles.keys(), loc="outside lower center", ncols=8, fontsize=9)
        figure.savefig(FIGURE, dpi=100)
        pyplot.close(figure)


SHOWN = ("ball", "crank", "balls_12")


def write() -> None:
    """Write the pictures and the page."""
    pictures()
    PAGE.write_text(page(), encoding="utf-8")
