"""Picture of the restitution study: a panel per damping law, and all laws in one.

A panel shows the restitution returned less the one requested.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

import matplotlib as mpl
import numpy as np
from matplotlib.figure import Figure

from hertzwerk.runtime.output.plots.plot_style import BLUE, GREY, ORANGE, STYLE, VERMILLION, heading

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from hertzwerk.runtime.analysis.validation.restitution import Curve, Study

COLUMNS = 5
SHADE = "#dbe9f4"
SCALE = 0.12  # common limit of all panels; a law beyond it is shown whole below
STRAYS = 0.1  # distance from the diagonal from which a law is named in the panel of all laws
LABELS = 0.062  # between two labels
EXACT = 5e-5  # smaller deviations count as none
OWN = {  # dimensionless form of a law's own parameter, and its trend
    "ristow": (r"$\gamma\,(m^2/K^2v_0)^{1/5}$", "returns more at higher speed"),
    "power_damping": (r"$\chi\,v_0/K$, $m = n$", "returns less at higher speed"),
    "kuwabara_kono": (r"$A\,(K^2v_0/m^2)^{1/5}$", "returns less at higher speed"),
}


def figure(study: Study) -> Figure:
    """Draw the picture."""
    with mpl.rc_context({**STYLE, "axes.titlesize": 10, "font.size": 9}):
        rows = -(-len(study.curves) // COLUMNS)
        page = Figure(figsize=(14, 2.3 * rows + 5.0), layout="constrained")
        above, below = page.subfigures(2, 1, squeeze=False, height_ratios=(rows, 1.5))[:, 0]
        for i, curve in enumerate(study.curves):
            axis = above.add_subplot(rows, COLUMNS, i + 1)
            _deviation(axis, curve)
            axis.tick_params(labelleft=i % COLUMNS == 0)
            if i % COLUMNS == 0:
                axis.set_ylabel("e out − e in")
            if i + COLUMNS >= len(study.curves):
                axis.set_xlabel("e in")
        together, own = below.subplots(1, 2, width_ratios=(3, 2))
        _together(together, study)
        _own(own, study)
        heading(
            page,
            "Restitution of the damping laws: restitution of one free impact minus the requested one",
            "Shaded: the recommended range, and the largest deviation in it; grey: outside. Lines: closed form; dots: simulated through the engine. "
            "(A) .. (R): grade of the formula.",
        )
    return page


def _deviation(axis: Axes, curve: Curve) -> None:
    axis.axvspan(*(curve.recommended or (0.0, 1.0)), color=SHADE, linewidth=0, zorder=0)
    axis.axhline(0, color=GREY, linewidth=0.9)
    inside = curve.inside
    for shown, colour in ((np.full(len(inside), fill_value=True), GREY), (inside, BLUE)):
        if curve.closed is not None:
            axis.plot(curve.prescribed[shown], (curve.closed - curve.prescribed)[shown], color=colour, linewidth=1.5)
        axis.plot(curve.prescribed[shown], curve.deviation[shown], "o", color=colour, markersize=3.2)
    axis.set(xlim=(0, 1), ylim=(-SCALE, SCALE), xticks=np.linspace(0, 1, 6), yticks=(-0.1, -0.05, 0, 0.05, 0.1))
    axis.set_title(f"{curve.law}  ({curve.grade})")
    e, worst = curve.worst(inside=True)
    said = ["no deviation" if abs(worst) < EXACT else f"{worst:+.3f} at e = {e:g}"]
    if curve.out_at_one is not None and curve.out_at_one < 1:
        said.append(f"e → 1 returns {curve.out_at_one:.3f}")
    if curve.out_at_zero:
        said.append(f"e → 0 returns {curve.out_at_zero:.3f}")
    low = float(np.min(curve.deviation)) > -SCALE / 2  # where no curve is
    axis.text(
        0.03, 0.04 if low else 0.96, "\n".join(said).replace("-", "−"), transform=axis.transAxes,
        verticalalignment="bottom" if low else "top", fontsize=9,
    )  # fmt: skip


def _together(axis: Axes, study: Study) -> None:
    """Draw restitution out over in; laws that stray from the diagonal are named."""
    strays = [curve for curve in study.curves if abs(curve.worst(inside=False)[1]) >= STRAYS]
    near = [curve for curve in study.curves if curve not in strays]
    axis.plot((0, 1), (0, 1), color=GREY, linewidth=0.9)
    for curves, colour in ((near, BLUE), (strays, VERMILLION)):
        for curve in curves:
            axis.plot(curve.prescribed, curve.simulated, color=colour, linewidth=1.2)
    for end, side in ((0, -0.03), (-1, 0.03)):
        named = [curve for curve in strays if (curve.worst(inside=False)[0] < 0.5) == (end == 0)]
        heights = _apart([float(curve.simulated[end]) for curve in named], LABELS)
        for curve, height in zip(named, heights, strict=True):
            x, y = float(curve.prescribed[end]), float(curve.simulated[end])
            axis.annotate(
                curve.law, (x, y), (x + side, height), va="center", ha="left" if end else "right", color=VERMILLION,
                arrowprops={"arrowstyle": "-", "color": VERMILLION, "linewidth": 0.6}, fontsize=9,
            )  # fmt: skip
    if near:
        axis.text(0.4, 0.24, f"the other {len(near)},\nalong the diagonal", color=BLUE, fontsize=9)
    axis.set(xlim=(-0.26, 1.24), ylim=(0, 1), xticks=np.linspace(0, 1, 6))
    axis.set_title("All of them at once: e out over e in")
    axis.set_xlabel("e in")


def _own(axis: Axes, study: Study) -> None:
    """Draw the laws with a parameter of their own over its dimensionless form."""
    for curve, colour in zip(study.others, (BLUE, ORANGE, VERMILLION), strict=True):
        scaled, follows = OWN.get(curve.law, (curve.parameter, ""))
        label = f"{curve.law}, over {scaled}\n{follows}"
        axis.semilogx(curve.prescribed, curve.simulated, "o-", color=colour, markersize=3.2, linewidth=1.4, label=label)
    axis.set(ylim=(0, 1))
    axis.legend(loc="lower left", labelspacing=1.0)
    axis.set_title("Laws that take no e: e out over a number of their own")


def _apart(values: list[float], least: float) -> list[float]:
    """Move values up until labels stand apart."""
    placed: dict[int, float] = {}
    above = -np.inf
    for i in sorted(range(len(values)), key=lambda i: values[i]):
        above = placed[i] = max(values[i], above + least)
    return [placed[i] for i in range(len(values))]
