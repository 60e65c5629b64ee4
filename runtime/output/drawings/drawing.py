"""Drawing of a mechanism on an axis: start, faint later positions, paths of points, names, scales."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import MaxNLocator

from hertzwerk.runtime.output.drawings import force_symbols, labels
from hertzwerk.runtime.output.drawings.drawing_primitives import INK, Paper, nice, shade
from hertzwerk.runtime.output.drawings.parts import ROD, Parts
from hertzwerk.runtime.output.drawings.places import GROUND, SOLIDS, Landmark, Places
from hertzwerk.runtime.output.drawings.view import view_of
from hertzwerk.runtime.output.plots.plot_style import GREY, VERMILLION
from hertzwerk.runtime.output.plots.unit_prefixes import Scale, scale_of
from hertzwerk.runtime.system.arrays import Array
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from matplotlib.axes import Axes

LEAST = (3.0, 1.9)  # least size of an axis, inches
MARGIN = 30.0  # points around the visible parts
MORE = 22.0  # further points, where a spring's ground stands behind a slider
CROWDED, LEAST_SYMBOL = 28.0, 0.3  # bodies shorter than this, in points, get symbols smaller by up to this factor
GHOSTS = 5
DISTINCT = 0.07  # of the size of the mechanism: least distance of ghosts, if less than half a body
PATHS = 3
ROUNDS = 4.0  # of the size of a path: longest part shown, once around a circle and more
MANY = 16  # most names that are placed
ALIKE = 6  # bodies that are numbered alike, of which the first has their name
UNITS = (("m", 1.0), ("cm", 1e-2), ("mm", 1e-3), ("µm", 1e-6))


@dataclass(frozen=True)
class Drawing:
    """Mechanism ready to be drawn.

    size: of the axis [inch]; frame: its limits (left, right, bottom, top); ghosts: instants of the faint positions.
    """

    parts: Parts
    size: tuple[float, float]
    frame: tuple[float, float, float, float]
    ghosts: tuple[int, ...]

    @classmethod
    def of(
        cls, places: Places, panel: tuple[float, float], least: tuple[float, float] = LEAST, margin: float = MARGIN
    ) -> Drawing:
        """Fit a mechanism into a panel [inch]."""
        view = view_of(places)
        rough = float(np.max(np.ptp(Parts(places, view, Scale("m", 1.0)).extents, axis=0)))
        parts = Parts(places, view, _unit(rough or 1.0))
        extents = parts.extents
        low, high = np.min(extents, axis=0), np.max(extents, axis=0)
        around = margin + (MORE if _stands_behind(parts, float(np.max(high - low))) else 0.0)
        room = [inches - 2 * around / 72 for inches in panel]
        per_inch = float(np.max((high - low) / room)) or 0.25 / parts.unit.factor  # of a point mass: a metre
        size = np.maximum((high - low) / per_inch + 2 * around / 72, least)
        middle, half = (low + high) / 2, size * per_inch / 2
        (left, bottom), (right, top) = middle - half, middle + half
        inches = float(size[0]), float(size[1])
        return cls(parts, inches, (left, right, bottom, top), _distinct(parts, float(np.max(high - low))))

    @property
    def point(self) -> float:
        """1/72 inch in the unit of the picture."""
        return (self.frame[1] - self.frame[0]) / self.size[0] / 72

    def on(self, axis: Axes, size: float = 9.0, symbols: float = 1.0, *, times: bool = True) -> None:
        """Draw on an axis: names of a size [points], symbols scaled by a factor, times of faint positions."""
        parts, paper = self.parts, self._paper(axis, symbols)
        for i in self.ghosts:
            parts.draw(paper.faint(), i)
        for mark, way in self.paths:
            paper.path(way, parts.colours[mark.body])
        parts.draw(paper, 0)
        force_symbols.draw(parts, paper, 0)
        self._furniture(paper, symbols)
        labels.place(
            paper, [*self._names(paper, size), *(self._times(paper, size) if times else ())], self.frame, self.point
        )

    def prepare(self, axis: Axes) -> None:
        """Set up an axis for a film: its limits, gravity and scales, away from where anything gets."""
        paper, aside = self._paper(axis, 1.0), self._paper(Figure().add_subplot(), 1.0)
        self.parts.draw(aside, 0)  # for its ink, which tells where the ground of joints has room
        paper.ink.extend([*aside.ink, self.parts.extents])
        self._furniture(paper, 1.0)

    @property
    def symbol(self) -> float:
        """Size of a point of symbols, smaller than `point` where bodies are short."""
        length = self.parts.length(0) or CROWDED * self.point
        return self.point * float(np.clip(length / (CROWDED * self.point), LEAST_SYMBOL, 1.0))

    def _paper(self, axis: Axes, symbols: float) -> Paper:
        axis.set(xlim=self.frame[:2], ylim=self.frame[2:], aspect="equal")
        return Paper(axis, self.symbol * symbols)

    def _furniture(self, paper: Paper, symbols: float) -> None:
        """Draw gravity, and the axes of the view with their scale."""
        self._gravity(paper, self.point * symbols)
        if self.parts.view.names is None:
            self._triad(paper, self.point * symbols)
        else:
            self._scales(paper.axis)

    def caption(self) -> str:
        """Describe the drawing."""
        t = self.parts.places.t
        bent = "".join(f" Bending of {part} enlarged {n:g} times." for part, n in self.parts.bent.items() if n > 1)
        if len(t) == 1:
            return f"At the start.{bent}"
        time = scale_of("s", t[-1])
        later = ", ".join(f"{value:.3g}" for value in time(t[list(self.ghosts)]))
        faint = f"; faint at {later} {time.unit}" if self.ghosts else "; its motion is too small to be visible"
        paths = [mark.part if mark.place in ("pin", "ball", "child") else mark.body for mark, _ in self.paths]
        if not paths:
            return f"At t = 0{faint}.{bent}"
        return (
            f"At t = 0{faint}. "
            + ("Thin lines: paths of " if len(paths) > 1 else "Thin line: path of ")
            + f"{', '.join(dict.fromkeys(paths))}.{bent}"
        )

    # -- paths ---------------------------------------------------------------------------------------------------------

    @cached_property
    def paths(self) -> list[tuple[Landmark, Array]]:
        """Moving landmarks and their paths (n, 2), without duplicates.

        Those of pairs first, then the longest of joints and mass centres.
        """
        parts, reach = self.parts, 8 * self.point
        chosen: list[tuple[Landmark, Array]] = []
        for mark in sorted(parts.places.landmarks, key=self._rank):
            way = parts.flat(parts.positions[id(mark)])
            moves = len(way) > 1 and mark.body != GROUND and np.max(np.ptp(way, axis=0)) > reach
            if moves and self._rank(mark)[0] < 2 and all(np.max(np.abs(way - other)) > reach for _, other in chosen):
                chosen.append((mark, way))
        return [(mark, _cut(way)) for mark, way in chosen[:PATHS]]

    def _rank(self, mark: Landmark) -> tuple[int, float]:
        """Return the priority of a landmark's path.

        Pins, balls and spheres first, then joints and mass centres by the size of their path; others are not shown.
        """
        if mark.place in ("pin", "ball", "sphere", "cylinder", "disc") or mark.kind == "sphere_on_sphere":
            return 0, 0.0
        if mark.kind == "body" or (
            mark.place == "child" and not mark.kind.startswith(("slide_", "turn_", "planar", ROD))
        ):
            return 1, -round(
                float(np.max(np.ptp(self.parts.flat(self.parts.positions[id(mark)]), axis=0))) / (4 * self.point)
            )
        return 2, 0.0

    # -- furniture -----------------------------------------------------------------------------------------------------

    def _names(self, paper: Paper, size: float) -> Iterator[labels.Label]:
        parts = self.parts
        shown = {mark.body for mark in parts.places.landmarks if mark.kind == "body" or mark.kind.startswith(SOLIDS)}
        bodies = [body for body in parts.places.bodies[1:] if body in shown]
        if len(bodies) <= MANY:
            for body, text in _named(bodies).items():
                yield labels.Label(text, parts.beside(paper, body, 0), shade(parts.colours[body]), size)
        for name in parts.rods:
            points = parts.rod(name, 0)[[10, 20, 30]]
            yield labels.Label(name, points, shade(parts.colours[parts.rods[name][0].body]), size)
        for (name, kind), marks in parts.of.items():
            if kind in ("spring", "damper", "bushing", "slide_spring", "slide_damper"):
                sliding = kind in ("slide_spring", "slide_damper")
                a, b = (
                    force_symbols.along_slide(parts, paper, marks, 0)[:2]
                    if sliding
                    else (parts.at(m, 0) for m in marks[:2])
                )
                yield labels.Label(name, np.array([(a + b) / 2, a + 0.3 * (b - a), a + 0.7 * (b - a)]), INK, size - 1)
            elif kind in (
                "belt",
                "force",
                "moment",
                "turn_drive",
                "slide_drive",
                "turn_force",
                "slide_force",
                "turn_motor",
                "slide_motor",
            ):
                yield labels.Label(name, parts.at(marks[0], 0)[None], VERMILLION, size - 1)

    def _times(self, paper: Paper, size: float) -> Iterator[labels.Label]:
        """Yield the times of the faint positions, each beside the body that has moved most."""
        parts = self.parts
        if not self.ghosts:
            return
        time = scale_of("s", parts.places.t[-1])
        for i in self.ghosts:
            moved = {body: self._moved(body, i) for body in parts.places.bodies[1:]}
            anchors = parts.beside(paper, max(moved, key=lambda body: moved[body]), i)
            yield labels.Label(f"{time(parts.places.t[i]):.3g} {time.unit}", anchors, GREY, size - 1.5)

    def _moved(self, body: str, i: int) -> float:
        """Return how far a body is from its start on the paper."""
        start, later = (self.parts.corners(body, k) for k in (0, i))
        return float(np.max(np.abs(np.mean(later, axis=0) - np.mean(start, axis=0)))) if len(start) else 0.0

    def _gravity(self, paper: Paper, p: float) -> None:
        """Draw gravity's arrow in the corner with the least ink."""
        parts, (left, right, bottom, top) = self.parts, self.frame
        marks = [mark for mark in parts.places.landmarks if mark.kind == "gravity"]
        if not marks:
            return
        way, projected = parts.way(marks[0], "axis", 0)
        if projected < 0.5:
            return
        corners = [np.array([x, y]) for y in (top - 22 * p, bottom + 22 * p) for x in (right - 16 * p, left + 16 * p)]
        at = min(corners, key=lambda corner: paper.inked(corner, 20 * p))
        paper.arrow(np.array([at - 12 * p * way, at + 12 * p * way]), GREY, 1.2)
        side = np.array([-way[1], way[0]])
        paper.text(at + 7 * p * side, "g", GREY, 9, style="italic")
        paper.ink.append(at + 7 * p * side + p * np.array([[0, 0], [3, 0], [-3, 0], [0, 3], [0, -3]]))

    def _scales(self, axis: Axes) -> None:
        names = self.parts.view.names or ("", "")
        axis.set(xlabel=f"{names[0]} [{self.parts.unit.unit}]", ylabel=f"{names[1]} [{self.parts.unit.unit}]")
        for side in (axis.xaxis, axis.yaxis):
            side.set_major_locator(MaxNLocator(nbins=6, steps=[1, 2, 2.5, 5, 10], min_n_ticks=3))
        axis.tick_params(labelsize=8.5)

    def _triad(self, paper: Paper, p: float) -> None:
        """Draw the projected axes of the ground, and a scale bar."""
        axis, (left, right, bottom, top) = paper.axis, self.frame
        axis.set_axis_off()
        corners = [np.array([x, y]) for y in (bottom + 30 * p, top - 38 * p) for x in (left + 30 * p, right - 32 * p)]
        at = min(corners, key=lambda corner: paper.inked(corner, 28 * p))
        for name, way in zip("xyz", self.parts.view(np.eye(3)), strict=True):
            paper.arrow(np.array([at, at + 20 * p * way]), INK, 0.9, head=4)
            paper.text(at + 26 * p * way, name)
        length = nice(60 * p)
        middles = [
            np.array([x, y])
            for y in (bottom + 12 * p, top - 12 * p)
            for x in (right - 44 * p, left + 44 * p, (left + right) / 2)
        ]
        x, y = min(
            middles, key=lambda middle: paper.inked(middle, 34 * p) if np.linalg.norm(middle - at) > 60 * p else 1000
        )
        paper.line(np.array([[x - length / 2, y], [x + length / 2, y]]), INK, 1.6, 8)
        paper.text(np.array([x, y + 3 * p]), f"{length:g} {self.parts.unit.unit}", va="bottom")


def _cut(way: Array) -> Array:
    """Return the beginning of a path (n, 2), as long as it stays readable."""
    length = np.cumsum(np.linalg.norm(np.diff(way, axis=0), axis=1))
    return way[: 2 + int(np.searchsorted(length, ROUNDS * float(np.max(np.ptp(way, axis=0)))))]


def _stands_behind(parts: Parts, size: float) -> bool:
    """Return whether a spring or damper on a slide is too short to be drawn between its points."""
    ends = [marks for (_, kind), marks in parts.of.items() if kind in ("slide_spring", "slide_damper")]
    return any(np.linalg.norm(parts.at(a, 0) - parts.at(b, 0)) < 0.15 * size for a, b in ends)


def _distinct(parts: Parts, size: float) -> tuple[int, ...]:
    """Select the instants that show most of the motion, by farthest-point sampling from the start."""
    marks = [m for m in parts.places.landmarks if m.body != GROUND]
    if not marks or len(parts.places.t) < 2:
        return ()
    shape = np.concatenate([parts.flat(parts.positions[id(mark)]) for mark in marks], axis=1)
    nearest = np.max(np.abs(shape - shape[0]), axis=1)
    apart = min(DISTINCT * size, parts.length(0) / 2 or size)
    instants: list[int] = []
    while len(instants) < GHOSTS and np.max(nearest) > apart:
        instants.append(int(np.argmax(nearest)))
        nearest = np.minimum(nearest, np.max(np.abs(shape - shape[instants[-1]]), axis=1))
    return tuple(sorted(instants))


def _unit(size: float) -> Scale:
    """Return metres, centimetres or less, for numbers of one to three digits."""
    return Scale(*next((unit for unit in UNITS if size >= 1.2 * unit[1] * (8 if unit[0] == "cm" else 1)), UNITS[-1]))


def _named(bodies: Sequence[str]) -> dict[str, str]:
    """Return bodies and their labels: of many that are numbered alike the first alone, as "ball_0 .. 5"."""
    rows: dict[str, list[str]] = {}
    for body in bodies:
        stem = body.rstrip("0123456789")
        rows.setdefault(stem if stem.endswith("_") else body, []).append(body)
    named: dict[str, str] = {}
    for stem, row in rows.items():
        if len(row) < ALIKE:
            named |= {body: body for body in row}
        else:
            named[row[0]] = f"{row[0]} .. {row[-1].removeprefix(stem)}"
    return named
