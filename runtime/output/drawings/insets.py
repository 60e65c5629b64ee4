"""Insets that enlarge details of a mechanism: clearances of joints, gaps of faces."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.patches import ConnectionPatch, Polygon

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.output.drawings.drawing_primitives import INK, ROUND, Paper, nice
from hertzwerk.runtime.output.drawings.parts import INSIDE, Parts
from hertzwerk.runtime.output.drawings.places import Landmark
from hertzwerk.runtime.output.plots.plot_style import GREY
from hertzwerk.runtime.system.arrays import Array
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure

WIDTH, HEIGHT = 1.75, 2.2  # inches of an inset, and between two
MOST = 3
FARTHEST = 1e12  # times half of its size: farther from the origin the rounding of places would be seen
UNSEEN = 10.0  # points: smaller details are enlarged
PART = 0.26  # of the radius: size of a clearance as shown, if to scale it were less than...
LEGIBLE = 0.1  # ... this
SQUARE = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])


@dataclass
class Link:
    """Line from the window of an inset to its place on the main axis, and the square around a gap there."""

    line: ConnectionPatch
    edge: Array  # from the place to the end of the line
    square: Polygon | None

    def follow(self, inset: Inset, i: int) -> None:
        """Move to the place of a detail at an instant."""
        place = inset.place(i)
        self.line.xy2 = tuple(place + self.edge)
        if self.square is not None:
            self.square.set_xy(place + inset.half * SQUARE)


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
        axis = self.window(page, box, point, below)
        self.draw(Paper(axis, self.point), 0)
        self.link(page, axis, main, below)

    @property
    def point(self) -> float:
        """Size of a point (1/72 inch) in the window, in the unit of the picture."""
        return 2 * self.half / (WIDTH * 72)

    def window(self, page: Figure, box: tuple[float, float, float, float], point: float, below: bool) -> Axes:
        """Return the empty window of `on`, with its name and scale."""
        axis = page.add_axes(box)
        axis.set(xticks=[], yticks=[])
        self.look_at(axis, 0)
        for spine in axis.spines.values():
            spine.set(visible=True, color=GREY, linewidth=0.8)
        enlarged = point / self.point
        text = f"{'path of the centre ' if self.way else 'enlarged '}{_times(enlarged)}"
        if self.exaggerated > 1:
            text = f"{_times(enlarged)}, its clearance {_times(enlarged * self.exaggerated)}"
        more = f", one of {self.alike} alike" if self.alike > 1 else ""
        where, side = ((0, -0.03), "top") if below else ((0, 1.02), "bottom")
        axis.text(*where, f"{self.name}{more}\n{text}", fontsize=8.5, va=side, transform=axis.transAxes)
        return axis

    def look_at(self, axis: Axes, i: int) -> None:
        """Set the limits of a window: a gap stays in its middle, a joint is drawn where it is at the start."""
        middle = self.centre if self.exaggerated or self.way else self.place(i)
        axis.set(xlim=middle[0] + self.half * np.array([-1, 1]), ylim=middle[1] + self.half * np.array([-1, 1]))

    def link(self, page: Figure, axis: Axes, main: Axes, below: bool) -> Link:
        """Draw the line from a window to its place on the main axis."""
        square = None
        if not self.exaggerated:
            square = Polygon(self.centre + self.half * SQUARE, fill=False, edgecolor=GREY, linewidth=0.7, zorder=8.4)
            main.add_artist(square)
        edge = np.array([0, -self.half] if below else [self.half, 0])
        line = ConnectionPatch(
            (0.5, 1) if below else (0, 0.5), tuple(self.centre + edge), "axes fraction", "data",
            axesA=axis, axesB=main, color=GREY, linewidth=0.6, zorder=8.3,
        )  # fmt: skip
        page.add_artist(line)
        return Link(line, edge, square)

    def draw(self, paper: Paper, i: int, until: int | None = None) -> None:
        """Draw the detail at an instant, with the path of a centre up to another, by default the whole of it."""
        if self.way:
            self._way(paper, i, until)
        elif self.exaggerated:
            self._joint(paper, i, until)
        else:
            self.parts.draw(paper, i)

    def place(self, i: int) -> Array:
        """Return the middle of the detail on the main axis at an instant."""
        if self.exaggerated or self.way:
            return self.parts.at(self.marks[1], i)
        gap = _gap(self.parts, list(self.marks), i)
        return self.centre if gap is None else self.parts.flat(gap[1])

    @property
    def pin_radius(self) -> float:
        """Radius of the pin as it is drawn: none where only its centre is."""
        if self.way:
            return 0.0
        inner, outer = (mark.size("radius") / self.parts.unit.factor for mark in self.marks)
        return outer - self.exaggerated * (outer - inner)

    @cached_property
    def path(self) -> Array:
        """Path (n, 2) of the pin's centre about the bush's, as it is drawn."""
        return self.parts.flat(self._eccentricity()) * (self.exaggerated or 1.0)

    def _joint(self, paper: Paper, i: int, until: int | None) -> None:
        """Draw the joint with its clearance, and within it the path of the pin's centre against the bush."""
        inner, outer = self.marks
        parts, c, shown, way = self.parts, self.centre, self.pin_radius, self.path
        hole = outer.size("radius") / parts.unit.factor
        circle = np.stack([np.cos(ROUND), np.sin(ROUND)], axis=-1)
        paper.area(c + 1.25 * hole * circle, parts.colours[outer.body], 5.0)
        paper.hole(c + hole * circle, 5.1)
        paper.area(c + way[i] + shown * circle, parts.colours[inner.body], 5.2, alpha=0.75)
        paper.line(c + (hole - shown) * circle, GREY, 0.6, 5.3, (0, (3, 2)))
        if len(way) > 1:
            paper.line(c + way[:until], INK, 0.5, 5.4)
        paper.pin(c + way[i], 1.6, INK)

    def _way(self, paper: Paper, i: int, until: int | None) -> None:
        """Draw the path of the pin's centre in its clearance circle."""
        inner, outer = self.marks
        clearance = (outer.size("radius") - inner.size("radius")) / self.parts.unit.factor
        way = self.centre + self.path
        paper.line(
            self.centre + clearance * np.stack([np.cos(ROUND), np.sin(ROUND)], axis=-1), GREY, 1.0, 5.0, (0, (3, 2))
        )
        paper.line(way[:until], self.parts.colours[inner.body], 0.9, 5.1)
        paper.pin(way[i], 1.6, INK)

    def _eccentricity(self) -> Array:
        """Return the vector (n, 3) from the bush's centre to the pin's [m].

        In axes that turn with the bush and are the ground's at the start.
        """
        inner, outer = self.marks
        places = self.parts.places
        apart = self.parts.positions[id(inner)] - self.parts.positions[id(outer)]
        turns = places.rotations[:, places.bodies.index(outer.body)]
        return np.asarray(np.einsum("ij,nkj,nk->ni", turns[0], turns, apart))


def clearances(parts: Parts, point: float) -> Iterator[Inset]:
    """Yield insets for details smaller than a few points; for gaps of one kind the smallest.

    point: 1/72 inch in the unit of the picture. Raises InputError where numbers do not resolve a detail so far from the origin.
    """
    details: list[Inset] = []
    for (name, kind), marks in parts.of.items():
        if kind in INSIDE:
            inner, outer = marks
            hole = outer.size("radius") / parts.unit.factor
            clearance = (outer.size("radius") - inner.size("radius")) / parts.unit.factor
            if clearance < UNSEEN * point:
                if 2.8 * hole > 0.7 * WIDTH * 72 * point:  # it is as large in the picture
                    details.append(Inset(name, (inner, outer), parts, parts.at(outer, 0), 1.4 * clearance, way=True))
                    continue
                more = 1.0 if clearance > LEGIBLE * hole else max(1.0, nice(PART * hole / clearance * 1.001))
                details.append(Inset(name, (inner, outer), parts, parts.at(outer, 0), 1.4 * hole, more))
    gaps: dict[str, list[tuple[float, str, Array, list[Landmark]]]] = {}
    for (name, kind), marks in parts.of.items():
        gap = _gap(parts, marks)
        if gap is not None and 0 < gap[0] / parts.unit.factor < UNSEEN * point:
            gaps.setdefault(kind, []).append((gap[0] / parts.unit.factor, name, gap[1], marks))
    for several in gaps.values():
        width, name, middle, (first, second) = min(several, key=lambda entry: entry[0])
        alike = sum(other[0] < 1.01 * width for other in several)
        details.append(Inset(name, (first, second), parts, parts.flat(middle), 5 * width, alike=alike))
    for inset in details[:MOST]:
        far = float(np.max(np.abs(inset.centre)))
        if not far <= FARTHEST * inset.half:
            size, away = (x * parts.unit.factor for x in (2 * inset.half, far))
            text = f"{inset.name}, {size:.3g} m large and {away:.3g} m from the origin"
            expected = f"at most {FARTHEST / 2:g} times as far as it is large, so that numbers resolve it"
            raise InputError(parts.places.model.name, [Fault("drawing", text, expected, "check the units of lengths")])
        yield inset


def _gap(parts: Parts, marks: list[Landmark], i: int = 0) -> tuple[float, Array] | None:
    """Return the width of a gap at an instant [m] and its middle (3,), for surfaces that face each other."""
    if len(marks) != 2:  # of a flexible rod more
        return None
    first, second = marks
    one, two = parts.positions[id(first)][i], parts.positions[id(second)][i]
    radius = first.size("radius") if "radius" in first.beside else 0.0
    if parts.view.names and "normal" in second.beside and first.place in ("corner", "sphere", "cylinder"):
        normal = parts.places.direction(second, "normal")[i]
        height = float((one - two) @ normal) - radius
        return height, one - (radius + height / 2) * normal
    if first.kind in ("sphere_on_sphere", "parallel_cylinders"):
        apart = one - two
        distance = float(np.linalg.norm(apart))
        width = distance - radius - second.size("radius")
        return width, two + (second.size("radius") + width / 2) * apart / distance
    return None


def _times(number: float) -> str:
    return f"{number:.2g}×" if number < 100 else f"{float(f'{number:.2g}'):.0f}×"
