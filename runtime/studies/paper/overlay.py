"""Measured signals laid over the figures of a study, as they are: `hertzwerk compare` judges them."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.runtime.studies.paper.study_page import Curve, Page, Panel, Study

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.inputs.measurement_csv import Measurement


def require_columns(study: Study, measured: Measurement) -> None:
    """Raise InputError where a measured unit does not fit, and where a study shows no measured history."""
    shown = study.histories
    faults = [
        Fault(f"column {name}", f"[{measured.units[name]}]", f"a unit like {unit}")
        for name, unit in shown.items()
        if name in measured.columns and parse_unit(unit).exponents != measured.unit(name).exponents
    ]
    if not shown.keys() & measured.columns.keys():
        expected = f"some of {', '.join(shown)}" if shown else f"histories of study {study.name}, which states none"
        faults.append(Fault("columns", ", ".join(measured.columns), expected))
    refuse(measured.source, faults)


def laid_over(page: Page, measured: Measurement) -> Page:
    """Return a page whose panels of a measured history over time show the measurement too."""
    charts = (replace(chart, panels=tuple(_over(panel, measured) for panel in chart.panels)) for chart in page.charts)
    caption = f"Black dots: measured, from {Path(measured.source).name}, as they are, neither filtered nor shifted."
    return replace(page, charts=tuple(charts), paragraphs=(*page.paragraphs, caption))


def _over(panel: Panel, measured: Measurement) -> Panel:
    name = panel.y.history
    if panel.x.history != "t" or name not in measured.columns:
        return panel
    time, unit = (parse_unit(axis.unit.replace("²", "^2")) for axis in (panel.x, panel.y))
    there = np.isfinite(measured.columns[name])
    x, y = measured.times[there] / time.factor, measured.si(name)[there] / unit.factor
    return replace(panel, curves=(*panel.curves, Curve("measured", x, y, look="measured")))
