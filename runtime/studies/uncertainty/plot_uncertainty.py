"""Picture of a propagation: samples of each output beside the derivatives' spread, and Sobol indices."""

from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from hertzwerk.runtime.output.plots.plot_panel import empty_panel
from hertzwerk.runtime.output.plots.plot_style import BLUE, GREY, SKY, STYLE, VERMILLION, plain
from hertzwerk.runtime.output.plots.title import titled_page
from hertzwerk.runtime.output.plots.unit_prefixes import scale_of
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from hertzwerk.runtime.studies.uncertainty.propagation_result import Propagated, Uncertain

WIDE, HIGH = 4.6, 2.6  # inches of a panel
BINS = 40  # most


def figure(result: Propagated) -> Figure:
    """Draw each output in a row: its samples with the normal curve of its derivatives, and its indices."""
    outputs = [*result]
    subtitle = f"{result.draws} samples of {', '.join(result.names)}"
    indices = any(output.first for output in outputs)
    width = WIDE * (2 if indices else 1)
    with mpl.rc_context(STYLE):
        page = titled_page(width, HIGH * len(outputs), f"{result.scene}: uncertainty", subtitle)
        grid = page.subplots(len(outputs), 2 if indices else 1, squeeze=False)
        for output, row in zip(outputs, grid, strict=True):
            _spread(row[0], output, result.samples[output.name][: result.draws])
            if indices:
                _indices(row[1], output)
        for column in grid.T:
            if labelled := [axis for axis in column if axis.get_legend_handles_labels()[1]]:
                labelled[0].legend(loc="lower right", bbox_to_anchor=(1, 1), ncols=2)
    return page


def _spread(axis: Axes, output: Uncertain, values: Array) -> None:
    """Draw the samples of an output, and the normal curve that its derivatives give."""
    values = values[np.isfinite(values)]
    unit = scale_of(output.unit, values)
    axis.hist(unit(values), bins=min(BINS, max(8, int(np.sqrt(len(values))))), density=True, color=SKY, label="samples")
    if output.linear > 0:
        x = output.nominal + output.linear * np.linspace(-3.5, 3.5, 200)
        curve = np.exp(-(((x - output.nominal) / output.linear) ** 2) / 2) / (output.linear * np.sqrt(2 * np.pi))
        axis.plot(unit(x), curve * unit.factor, color=VERMILLION, label="derivatives")
    axis.set(title=plain(output.name), yticks=[], xlabel=unit.unit)


def _indices(axis: Axes, output: Uncertain) -> None:
    """Draw the parts of an output's variance as bars, with their intervals."""
    names = list(output.first)
    if not names:
        empty_panel(axis, f"{output.name}: no variance to part")
        return
    for shift, parts, colour, label in (
        (0.2, output.first, BLUE, "alone"),
        (-0.2, output.total, GREY, "with interactions"),
    ):
        shares = [parts[name] for name in names]
        value = np.array([part.value for part in shares])
        ends = np.abs(np.array([[part.low for part in shares], [part.high for part in shares]]) - value)
        place = np.arange(len(names))[::-1] + shift
        axis.barh(
            place, value, 0.36, color=colour, label=label, xerr=ends, error_kw={"elinewidth": 0.8, "ecolor": "black"}
        )
    axis.set(
        yticks=np.arange(len(names))[::-1],
        yticklabels=[plain(name) for name in names],
        xlim=(-0.05, 1.15),
        xlabel="part of the variance",
    )
    axis.grid(visible=False, axis="y")
