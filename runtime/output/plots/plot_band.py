"""Picture of a reconstruction: band of the candidates' forces over penetration, local exponents."""

from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from hertzwerk.runtime.output.plots.plot_style import CYCLE, GREY, STYLE, heading

if TYPE_CHECKING:
    from hertzwerk.derive.exchange.law_sheets.law_sheet import Sheet

SHADE = "#dbe9f4"
DASHES = ("-", "--", "-.", ":", (0, (6, 2, 1, 2, 1, 2)))  # two candidates may coincide


def figure(sheet: Sheet) -> Figure:
    """Draw forces over the penetration with the band between them, and the local exponents."""
    band = sheet.band
    if band is None:
        raise ValueError(f"{sheet.law.name} is no reconstruction: it has no candidates")
    depths = np.array(band.penetrations) * 1e6
    forces = np.array([candidate.forces for candidate in band.candidates])
    with mpl.rc_context(STYLE):
        page = Figure(figsize=(11, 4.8), layout="constrained")
        force, exponent = page.subplots(1, 2, width_ratios=(3, 2))
        force.fill_between(depths, forces.min(axis=0), forces.max(axis=0), color=SHADE, linewidth=0)
        for k, candidate in enumerate(band.candidates):
            look = {
                "color": CYCLE[k % len(CYCLE)],
                "linestyle": DASHES[k % len(DASHES)],
                "linewidth": 2.4 if k == 0 else 1.5,
            }
            force.loglog(depths, candidate.forces, label=candidate.law, **look)
            exponent.semilogx(depths, candidate.exponents, **look)
        exponent.axhline(1, color=GREY, linewidth=0.8)
        exponent.annotate(
            "n = 1, as the paper says", (depths[-1], 1), (-2, -12), textcoords="offset points", ha="right", color=GREY
        )
        exponent.set(ylim=(0.9, 1.6), xlabel="penetration [µm]", title="Local exponent dlnF/dlnd")
        force.set(xlabel="penetration [µm]", ylabel="force [N]", title="Force, and the band of the candidates")
        force.legend(loc="upper left")
        spread = band.spread
        differ = f"Its candidates differ by a factor of {min(spread):.1f} to {max(spread):.0f}"
        heading(page, f"{sheet.law.name}: a reconstruction (grade R). {differ}", f"Example: {sheet.example}")
    return page
