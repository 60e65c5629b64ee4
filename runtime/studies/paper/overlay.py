"""Measured signals laid over the figures of a study, as they are: `hertzwerk compare` judges them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.runtime.studies.paper.study_page import Curve, Page, Panel

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.inputs.measurement_csv import Measurement


def laid_over(page: Page, measured: Measurement) -> Page:
    """Return a page whose panels of a measured history over time show the measurement too.

    Raises InputError where a unit does not fit, and where no panel shows a measured history.
    """
    faults: list[Fault] = []
    charts = tuple(
        replace(chart, panels=tuple(_over(panel, measured, faults) for panel in chart.panels)) for chart in page.charts
    )
    if not faults and all(_shows(panel) not in measured.columns for chart in charts for panel in chart.panels):
        known = dict.fromkeys(filter(None, (_shows(panel) for chart in page.charts for panel in chart.panels)))
        expected = f"some of {', '.join(known)}" if known else "a study that shows histories: this one has none"
        faults.append(Fault("columns", ", ".join(measured.columns), expected))
    refuse(measured.source, faults)
    caption = f"Black dots: measured, from {Path(measured.source).name}, as they are, neither filtered nor shifted."
    return replace(page, charts=charts, paragraphs=(*page.paragraphs, caption))


def _shows(panel: Panel) -> str:
    """Return the history that a panel shows over time; empty if none."""
    return panel.y.history if panel.x.history == "t" else ""


def _over(panel: Panel, measured: Measurement, faults: list[Fault]) -> Panel:
    name = _shows(panel)
    if name not in measured.columns:
        return panel
    time, unit = (parse_unit(axis.unit.replace("²", "^2")) for axis in (panel.x, panel.y))
    if unit.exponents != measured.unit(name).exponents:
        faults.append(Fault(f"column {name}", f"[{measured.units[name]}]", f"a unit like {panel.y.unit}"))
        return panel
    there = np.isfinite(measured.columns[name])
    x, y = measured.times[there] / time.factor, measured.si(name)[there] / unit.factor
    return replace(panel, curves=(*panel.curves, Curve("measured", x, y, look="measured")))
