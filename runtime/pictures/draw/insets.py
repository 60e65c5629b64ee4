"""Insets that enlarge details of a mechanism: clearances of joints, gaps of faces."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import ConnectionPatch, Polygon

from hertzwerk.runtime.pictures.draw.paper import INK, ROUND, Paper
from hertzwerk.runtime.pictures.draw.parts import INSIDE, Parts
from hertzwerk.runtime.pictures.draw.places import Array, Landmark
from hertzwerk.runtime.pictures.plot_style import GREY

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

WIDTH, HEIGHT = 1.75, 2.2  # inches of an inset, and between two
MOST = 3
UNSEEN = 10.0  # points: smaller details are enlarged
PART = 0.26  # of the radius: size of a clearance as shown, if to scale it were less than...
LEGIBLE = 0.1  # ... this


@dataclass(frozen=True)
class Inset:
    """Window on a detail of the mechanism.

    exaggerated: factor by which the clearance of a joint is enlarged beyond its radii; 0: a gap, all to scale. way:
    show only the path of the pin's centre, where the joint is large in the picture already.
    """

    name: str
    marks: tuple[Landmark, Landmark]
    parts: Parts
    centre: Array
    half: float
    exaggerated: float = 0.0
    alike: int = 1
    way: bool = False

    def on(self, page: Figure, main: Axes, box: tuple[float, float, float, float], point: float, below: bool) -> None:
        """Draw in a box of the page, `below` the main axis or beside it, with a line to the place there.

        point: of the main axis.
        """
        axis = page.add_axes(box)
        axis.set(
            xticks=[],
            yticks=[],
            xlim=self.centre[0] + self.half * np.array([-1, 1]),
            ylim=self.centre[1] + self.half * np.array([-1, 1]),
        )
        for spine in axis.spines.values():
            spine.set(visible=True, color=GREY, linewidth=0.8)
        paper = Paper(axis, 2 * self.half / (WIDTH * 72))
        if self.way:
            self._way(paper)
        elif self.exaggerated:
            self._joint(paper)
        else:
            self.parts.draw(paper, 0)
        enlarged = point / paper.point
        text = f"{'path of the centre ' if self.way else 'enlarged '}{_times(enlarged)}"
        if self.exaggerated > 1:
            text = f"{_times(enlarged)}, its clearance {_times(enlarged * self.exaggerated)}"
        more = f", one of {self.alike} alike" if self.alike > 1 else ""
        where, side = ((0, -0.03), "top") if below else ((0, 1.02), "bottom")
        axis.text(*where, f"{self.name}{more}\n{text}", fontsize=8.5, va=side, transform=axis.transAxes)
        if not self.exaggerated:
            window = self.centre + self.half * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
            main.add_artist(Polygon(window, fill=False, edgecolor=GREY, linewidth=0.7, zorder=8.4))
        edge = self.centre + ([0, -self.half] if below else [self.half, 0])
        line = ConnectionPatch(
            (0.5, 1) if below else (0, 0.5), tuple(edge), "axes fraction", "data",
            axesA=axis, axesB=main, color=GREY, linewidth=0.6, zorder=8.3,
        )  # fmt: skip
        page.add_artist(line)

    def _joint(self, paper: Paper) -> None:
        """Draw the joint with its clearance, and within it the path of the pin's centre against the bush."""
        inner, outer = self.marks
        parts, k, c = self.parts, self.exaggerated, self.centre
        radius, hole = inner.size("radius") / parts.unit.factor, outer.size("radius") / parts.unit.factor
        shown = hole - k * (hole - radius)
        way = parts.flat(self._eccentricity()) * k
        circle = np.stack([np.cos(ROUND), np.sin(ROUND)], axis=-1)
        paper.area(c + 1.25 * hole * circle, parts.colours[outer.body], 5.0)
        paper.hole(c + hole * circle, 5.1)
        paper.area(c + way[0] + shown * circle, parts.colours[inner.body], 5.2, alpha=0.75)
        paper.line(c + (hole - shown) * circle, GREY, 0.6, 5.3, (0, (3, 2)))
        if len(way) > 1:
            paper.line(c + way, INK, 0.5, 5.4)
        paper.pin(c + way[0], 1.6, INK)

    def _way(self, paper: Paper) -> None:
        """Draw the path of the pin's centre in its clearance circle."""
        inner, outer = self.marks
        clearance = (outer.size("radius") - inner.size("radius")) / self.parts.unit.factor
        way = self.centre + self.parts.flat(self._eccentricity())
        paper.line(
            self.centre + clearance * np.stack([np.cos(ROUND), np.sin(ROUND)], axis=-1), GREY, 1.0, 5.0, (0, (3, 2))
        )
        paper.line(way, self.parts.colours[inner.body], 0.9, 5.1)
        paper.pin(way[0], 1.6, INK)

    def _eccentricity(self) -> Array:
        """Return the vector (n, 3) from the bush's centre to the pin's [m].

        In axes that turn with the bush and are the ground's at the start.
        """
        inner, outer = self.marks
        places = self.parts.places
        apart = self.parts.positions[id(inner)] - self.parts.positions[id(outer)]
        turns = places.rotations[:, places.bodies.index(outer.body)]
        return np.asarray(np.einsum("ij,nkj,nk->ni", turns[0], turns.transpose(0, 2, 1), apart))


def clearances(parts: Parts, point: float) -> Iterator[Inset]:
    """Yield insets for details smaller than a few points; for gaps of one kind the smallest.

    point: 1/72 inch in the unit of the picture.
    """
    found: list[Inset] = []
    for (name, kind), marks in parts.of.items():
        if kind in INSIDE:
            inner, outer = marks
            hole = outer.size("radius") / parts.unit.factor
            clearance = (outer.size("radius") - inner.size("radius")) / parts.unit.factor
            if clearance < UNSEEN * point:
                if 2.8 * hole > 0.7 * WIDTH * 72 * point:  # it is as large in the picture
                    found.append(Inset(name, (inner, outer), parts, parts.at(outer, 0), 1.4 * clearance, way=True))
                    continue
                more = 1.0 if clearance > LEGIBLE * hole else max(1.0, _round(PART * hole / clearance))
                found.append(Inset(name, (inner, outer), parts, parts.at(outer, 0), 1.4 * hole, more))
    gaps: dict[str, list[tuple[float, str, Array, list[Landmark]]]] = {}
    for (name, kind), marks in parts.of.items():
        gap = _gap(parts, marks)
        if gap is not None and 0 < gap[0] / parts.unit.factor < UNSEEN * point:
            gaps.setdefault(kind, []).append((gap[0] / parts.unit.factor, name, gap[1], marks))
    for several in gaps.values():
        width, name, middle, (first, second) = min(several, key=lambda entry: entry[0])
        alike = sum(other[0] < 1.01 * width for other in several)
        found.append(Inset(name, (first, second), parts, parts.flat(middle), 5 * width, alike=alike))
    yield from found[:MOST]


def _gap(parts: Parts, marks: list[Landmark]) -> tuple[float, Array] | None:
    """Return the width of a gap at the start [m] and its middle (3,), for surfaces that face each other."""
    if len(marks) < 2:
        return None
    first, second = marks
    one, two = parts.positions[id(first)][0], parts.positions[id(second)][0]
    radius = first.size("radius") if "radius" in first.beside else 0.0
    if parts.view.names and "normal" in second.beside and first.place in ("corner", "sphere", "cylinder"):
        normal = parts.places.direction(second, "normal")[0]
        height = float((one - two) @ normal) - radius
        return height, one - (radius + height / 2) * normal
    if first.kind in ("sphere_on_sphere", "parallel_cylinders"):
        apart = one - two
        distance = float(np.linalg.norm(apart))
        width = distance - radius - second.size("radius")
        return width, two + (second.size("radius") + width / 2) * apart / distance
    return None


def _round(number: float) -> float:
    """Return the nearest of 1, 2, 5, 10, ... below a number."""
    power = 10.0 ** np.floor(np.log10(number * 1.001))
    return float(max(step * power for step in (1, 2, 5) if step * power <= number * 1.001))


def _times(number: float) -> str:
    return f"{number:.2g}×" if number < 100 else f"{float(f'{number:.2g}'):.0f}×"
