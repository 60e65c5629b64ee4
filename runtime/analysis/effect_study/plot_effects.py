"""Picture of a study of effects: a row per effect, columns for cost and changed outputs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure
from matplotlib.layout_engine import ConstrainedLayoutEngine
from matplotlib.ticker import FuncFormatter, LogLocator, NullLocator
from matplotlib.transforms import ScaledTranslation

from hertzwerk.runtime.analysis.effect_study import effect_study as texts
from hertzwerk.runtime.analysis.effect_study.effect_study import Change, Row, Study
from hertzwerk.runtime.output.plots.plot_style import BLUE, GREY, ORANGE, SKY, STYLE, VERMILLION, heading

if TYPE_CHECKING:
    from matplotlib.axes import Axes


SHADE = "#e3e3e3"
LEAST, MOST = 1e-6, 1e2  # limits of the relative changes shown
COLUMN, ROW = 2.5, 0.42  # inches
BELOW = 0.28  # inches from an axis to the legend under it
BEHIND: Any = {"facecolor": "white", "edgecolor": "none", "pad": 0.6}


def figure(study: Study) -> Figure:
    """Draw the picture."""
    with mpl.rc_context(STYLE):
        columns = 2 + len(study.outputs)
        names = [_name(row) for row in study.rows]
        lines = sum(1 + name.count("\n") * 0.6 for name in names)
        size = 2.4 + COLUMN * columns, 2.1 + ROW * lines
        page = Figure(figsize=size, layout=ConstrainedLayoutEngine(wspace=0.05))
        axes = page.subplots(1, columns, sharey=True, squeeze=False)[0]
        places = np.arange(len(names))
        _operations(axes[0], study, places)
        _times(axes[1], study, places)
        range_shown = _range(study)
        for axis, output in zip(axes[2:], study.outputs, strict=True):
            changes = [row.changes.get(output.name) for row in study.rows]
            _changes(axis, changes, places, range_shown, study.within)
            axis.set_title(f"{output.name}\nchanges by", fontsize=9.5)
        axes[0].set_yticks(places, names)
        axes[0].set_ylim(len(names) - 0.4, -0.6)
        for axis in axes:
            axis.grid(visible=False, axis="y")
            axis.tick_params(axis="y", length=0)
        for tick, row in zip(axes[0].get_yticklabels(), study.rows, strict=True):
            if study.smallest is not None and row.effect in study.smallest.left_out:
                tick.set_color(GREY)
        heading(page, f"{study.scene}: cost and influence of each effect", *_captions(study))
    return page


def _name(row: Row) -> str:
    return "\n".join((row.effect, *(f"with {name}" for name in row.along_with)))


def _operations(axis: Axes, study: Study, places: Any) -> None:
    """Draw operations in flight and, after them, those in contact."""
    costs = [row.cost for row in study.rows]
    flight, contact = (
        np.array([0 if cost is None else getattr(cost, of) for cost in costs]) for of in ("flight", "contact")
    )
    axis.barh(places, flight, color=BLUE, height=0.55, label=f"in flight, of {study.cost.flight}")
    if study.cost.contact:
        left = np.where(flight > 0, flight, 0)
        axis.barh(places, contact, left=left, color=SKY, height=0.55, label=f"in contact, of {study.cost.contact}")
    axis.axvline(0, color=GREY, linewidth=0.9)
    axis.set_title("operations\nof one evaluation", fontsize=9.5)
    low, high = min(0, *flight), max(1, *(flight + contact))
    axis.set_xlim(1.25 * low, high + 0.55 * (high - low))
    for place, a, b in zip(places, flight, contact, strict=True):
        text = " + ".join(str(x) for x in (a, b) if x).replace("+ -", "- ").replace("-", "−")
        axis.text(
            max(a, 0) + max(b, 0),
            place,
            f"  {text or 'none'}",
            va="center",
            fontsize=8.5,
            color="black" if text else GREY,
        )
    below = axis.transAxes + ScaledTranslation(0, -BELOW, axis.figure.dpi_scale_trans)
    axis.legend(
        loc="upper left",
        bbox_to_anchor=(-0.02, 0),
        bbox_transform=below,
        handlelength=1.0,
        labelspacing=0.2,
        borderpad=0.1,
    )


def _times(axis: Axes, study: Study, places: Any) -> None:
    """Draw the share of the time, and the interval of most rounds."""
    ends = [0.0]
    for place, row in zip(places, study.rows, strict=True):
        share = row.share
        if share is None:
            continue
        ends += [share.low, share.high]
        colour = BLUE if share.significant else SHADE
        axis.barh(place, share.median, color=colour, height=0.55)
        axis.plot((share.low, share.high), (place, place), color=GREY, linewidth=1.2)
        text = percent(share.median, sign=False) if share.significant else "below error"
        axis.text(
            max(share.high, 0),
            place,
            f"  {text}",
            va="center",
            fontsize=8.5,
            color="black" if share.significant else GREY,
        )
    low, high = min(ends), max(*ends, 0.01)
    axis.axvline(0, color=GREY, linewidth=0.9)
    axis.set_xlim(low - 0.05 * (high - low), high + 0.5 * (high - low))
    axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{100 * value:.0f} %".replace("-", "−")))
    axis.locator_params(axis="x", nbins=4)
    axis.set_title(f"share of the time,\n{'compiled' if study.compiled else 'virtual machine'}", fontsize=9.5)


def _changes(
    axis: Axes, changes: list[Change | None], places: Any, shown: tuple[float, float], within: float | None
) -> None:
    """Draw the sizes of the changes on a logarithmic axis, grey up to the noise."""
    low, high = shown
    axis.set(xscale="log", xlim=(low, high))
    for place, change in zip(places, changes, strict=True):
        if change is None or change.noise is None:
            text = "" if change is None else change.why
            axis.annotate(
                text, (low, place), (3, 0), textcoords="offset points", va="center", fontsize=8.5, color=VERMILLION
            )
            continue
        noise = float(np.clip(change.noise, low, high))
        axis.barh(place, noise - low, left=low, color=SHADE, height=0.55)
        if change.relative is None:
            axis.annotate(
                change.why, (noise, place), (3, 0), textcoords="offset points", va="center", fontsize=8.5, color=GREY
            )
            continue
        size = float(np.clip(abs(change.relative), low, high))
        up = change.relative > 0
        axis.plot((noise, size), (place, place), color=VERMILLION if up else BLUE, linewidth=1.4)
        axis.plot(size, place, "^" if up else "v", color=VERMILLION if up else BLUE, markersize=6.5)
        beside = np.log(size / low) < 0.5 * np.log(high / low)
        axis.annotate(
            percent(change.relative), (size, place), (8, 0) if beside else (-7, 8), textcoords="offset points", va="center",
            ha="left" if beside else "right", fontsize=8.5, bbox=BEHIND,
        )  # fmt: skip
    if within is not None:
        axis.axvline(within, color=ORANGE, linewidth=1.2, linestyle="--", zorder=0)
    axis.xaxis.set_major_locator(LogLocator(base=100, numticks=20))
    axis.tick_params(axis="x", labelsize=8.5)
    axis.xaxis.set_minor_locator(NullLocator())
    axis.xaxis.set_major_formatter(FuncFormatter(lambda value, _: f"{100 * value:g} %"))


def _range(study: Study) -> tuple[float, float]:
    """Return the limits of the logarithmic axes, around all changes and noises."""
    all_of = [change for row in study.rows for change in row.changes.values()]
    sizes = [abs(change.relative) for change in all_of if change.relative] + [study.within or 1e-2]
    low = 10.0 ** np.floor(np.log10(max(0.3 * min(sizes), LEAST)))
    return low, min(MOST, 10.0 ** np.ceil(np.log10(3 * max(sizes))))


def _captions(study: Study) -> list[str]:
    """Return the notes below the picture."""
    coarse, fine = study.tolerances
    error = (
        "the 95 % intervals of the means of 9 runs, which separate at any tolerance"
        if study.past_horizon
        else f"what local tolerances of {coarse:.2g} to {fine:.2g} change"
    )
    notes = [
        f"Triangles: size and sign of the change, relative to the whole scene, with {study.method} over {study.duration:.4g} s. "
        f"Grey: below the error, by {error}."
    ]
    notes += [f"{row.effect}: {row.fault}" for row in study.rows if row.fault]
    notes += [f"{row.effect}: {note}" for row in study.rows for note in row.notes]
    if study.smallest is not None and study.within is not None:
        effects = ", ".join(study.smallest.effects) or "no effect at all"
        notes.append(
            f"Smallest scene within {100 * study.within:g} % (dashed): {effects}. Names of excluded effects are grey."
        )
    return notes + list(study.warnings)


def percent(value: float, *, sign: bool = True) -> str:
    """Format a fraction in percent, with a typographic minus."""
    return texts.percent(value, sign=sign).replace("-", "−")
