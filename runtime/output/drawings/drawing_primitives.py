"""Drawing primitives of mechanisms: bars, discs, blocks, springs, hatching, arrows.

Symbols have sizes in points, surfaces are to scale. Everything is a polygon or a line in the units of the axis, so
that one piece of geometry serves the whole picture and an inset. Drawing leaves ink behind: points that labels keep
away from.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import numpy as np
from matplotlib.collections import LineCollection
from matplotlib.colors import to_hex, to_rgb
from matplotlib.lines import Line2D
from matplotlib.patches import Polygon

from hertzwerk.runtime.output.plots.plot_style import GREY, VERMILLION
from hertzwerk.runtime.system.arrays import Array

if TYPE_CHECKING:
    from matplotlib.axes import Axes

INK = "#222222"
ROUND = np.linspace(0, 2 * np.pi, 181)  # angles of surfaces to scale, which insets enlarge
COARSE = ROUND[::5]  # of symbols, in quarters
GHOST = 0.13  # opacity of a ghost


@dataclass
class Paper:
    """Axis and the size of a point (1/72 inch) in its units.

    ghost: draw faintly, behind everything, without symbols.
    """

    axis: Axes
    point: float
    ghost: bool = False
    ink: list[Array] = field(default_factory=list)
    light: list[Array] = field(default_factory=list)
    """Of ghosts and paths."""

    def faint(self) -> Paper:
        """Return the same paper, for ghosts."""
        return Paper(self.axis, self.point, True, self.ink, self.light)

    # -- shapes --------------------------------------------------------------------------------------------------------

    def polygon(self, outline: Array, **look: Any) -> None:
        """Add a filled outline (n, 2)."""
        self.axis.add_artist(Polygon(outline, **look))

    def stroke(self, points: Array, **look: Any) -> None:
        """Add a line through points (n, 2)."""
        self.axis.add_artist(Line2D(*points.T, **look))

    def strokes(self, lines: Array, **look: Any) -> None:
        """Add separate lines (k, 2, 2)."""
        self.axis.add_artist(LineCollection(list(lines), **look))

    # -- bodies and surfaces -------------------------------------------------------------------------------------------

    def plate(self, corners: Array, radius: float, colour: str, z: float) -> None:
        """Draw the convex hull of corners (n, 2), rounded: a bar for two, a disc for one."""
        around = corners if radius == 0 else np.concatenate([corner + radius * _circle() for corner in corners])
        self.area(hull(around), colour, z)

    def band(self, points: Array, half: float, colour: str, z: float) -> None:
        """Draw a bar along a curve through points (n, 2)."""
        way = np.gradient(points, axis=0)
        side = (
            half * np.stack([-way[:, 1], way[:, 0]], axis=-1) / np.maximum(np.linalg.norm(way, axis=1), 1e-300)[:, None]
        )
        self.area(np.concatenate([points + side, (points - side)[::-1]]), colour, z)

    def area(self, outline: Array, colour: str, z: float, alpha: float = 1.0) -> None:
        """Draw a filled outline (n, 2)."""
        face, edge = tint(colour, 0.42), tint(colour, 1.0)
        if self.ghost:
            look: dict[str, Any] = {
                "facecolor": colour,
                "edgecolor": colour,
                "linewidth": 0.5,
                "zorder": 1,
                "alpha": GHOST,
            }
        else:
            look = {"facecolor": face, "edgecolor": edge, "linewidth": 0.9, "zorder": z, "alpha": alpha}
        self.polygon(outline, joinstyle="round", **look)
        self._mark(np.concatenate([outline, outline[:1]]))

    def hole(self, outline: Array, z: float) -> None:
        """Cut a hole out of a body."""
        if not self.ghost:
            self.polygon(outline, facecolor="white", edgecolor=INK, linewidth=0.7, zorder=z)

    def path(self, points: Array, colour: str) -> None:
        """Draw the path of a point (n, 2), which names avoid where they can."""
        self.stroke(points, color=tint(colour, 0.6), linewidth=0.7, zorder=1.5)
        self.light.append(points)

    # -- lines ---------------------------------------------------------------------------------------------------------

    def line(
        self, points: Array, colour: str = INK, width: float = 1.0, z: float = 5.0, style: Any = "-", ink: bool = True
    ) -> None:
        """Draw a line through points (n, 2)."""
        look: dict[str, Any] = {"color": colour, "linewidth": width, "linestyle": style, "zorder": z}
        self.stroke(points, solid_capstyle="round", solid_joinstyle="round", **look)
        if ink:
            self._mark(points)

    def arrow(self, points: Array, colour: str, width: float = 1.4, z: float = 8.0, head: float = 5.0) -> None:
        """Draw an arrow along points (n, 2), with a head at the last."""
        tip, back = points[-1], points[-2]
        way = (tip - back) / max(float(np.linalg.norm(tip - back)), 1e-300)
        side, size = np.array([-way[1], way[0]]), head * self.point
        self.line(np.concatenate([points[:-1], [tip - 0.7 * size * way]]), colour, width, z)
        barb = np.array([tip, tip - size * way + 0.42 * size * side, tip - size * way - 0.42 * size * side])
        self.polygon(barb, facecolor=colour, edgecolor="none", zorder=z)
        self._mark(barb)

    def zigzag(self, a: Array, b: Array, coils: int = 6) -> None:
        """Draw a spring."""
        steps = np.concatenate([[0.0, 0.12], np.linspace(0.12, 0.88, 4 * coils + 1)[1:-1:2], [0.88, 1.0]])
        sides = np.concatenate([[0, 0], [(-1) ** i for i in range(2 * coils)], [0, 0]])
        way = b - a
        across = np.array([-way[1], way[0]]) / max(float(np.linalg.norm(way)), 1e-300)
        points = a + steps[:, None] * way + 4.5 * self.point * sides[:, None] * across
        self.line(points, "white", 3.0, 6.4)
        self.line(points, INK, 1.0, 6.5)

    def dashpot(self, a: Array, b: Array) -> None:
        """Draw a damper."""
        way = b - a
        length = max(float(np.linalg.norm(way)), 1e-300)
        along, half = way / length, 5 * self.point
        across = np.array([-along[1], along[0]])
        middle, reach = (a + b) / 2, min(9 * self.point, 0.3 * length)
        cup = [middle + reach * along + half * across, middle - reach * along + half * across,
               middle - reach * along - half * across, middle + reach * along - half * across]  # fmt: skip
        for line in (np.array(cup), np.array([a, middle - reach * along]), np.array([middle, b]),
                     np.array([middle + 0.75 * half * across, middle - 0.75 * half * across])):  # fmt: skip
            self.line(line, INK, 1.1, 6.5)

    # -- symbols -------------------------------------------------------------------------------------------------------

    def pin(self, at: Array, size: float = 3.0, face: str = "white", z: float = 7.0) -> None:
        """Draw a revolute joint; filled, a spherical one."""
        self.polygon(at + size * self.point * _circle(), facecolor=face, edgecolor=INK, linewidth=1.0, zorder=z)
        self._mark(at[None])

    def square(self, at: Array, size: float = 2.6) -> None:
        """Draw a weld."""
        corners = size * self.point * np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
        self.polygon(at + corners, facecolor=INK, edgecolor=INK, zorder=7)

    def centre(self, at: Array, size: float = 3.4) -> None:
        """Draw a mass centre: a disc in quarters."""
        disc = size * self.point * _circle()
        self.polygon(at + disc, facecolor="white", edgecolor=INK, linewidth=0.7, zorder=7.5)
        for start in (0, len(disc) // 2):
            quarter = np.concatenate([np.zeros((1, 2)), disc[start : start + len(disc) // 4 + 1]])
            self.polygon(at + quarter, facecolor=INK, edgecolor="none", zorder=7.6)

    def footing(self, at: Array, down: Array) -> None:
        """Draw the ground of a joint: a triangle on hatching."""
        side, p = np.array([-down[1], down[0]]), self.point
        left, right = (at + 10 * p * down + sign * 6.5 * p * side for sign in (-1, 1))
        self.polygon(np.array([at, left, right]), facecolor="#d8d8d8", edgecolor=INK, linewidth=0.9, zorder=2.5)
        self.ground(at + 10 * p * down - 10 * p * side, at + 10 * p * down + 10 * p * side, down)

    def ground(self, a: Array, b: Array, down: Array, z: float = 2.6, width: float = 1.1) -> None:
        """Draw a surface of the ground from a to b, hatched on the side `down` (2,)."""
        self.line(np.array([a, b]), INK, width, z)
        length, p = float(np.linalg.norm(b - a)), self.point
        along = (b - a) / max(length, 1e-300)
        starts = np.arange(0.8 * p, length, 3.6 * p)[:, None]
        feet, back = a + starts * along, np.minimum(starts, 4.2 * p)
        strokes = np.stack([feet, feet + back * (down - along)], axis=1)
        self.strokes(strokes, colors=GREY, linewidths=0.6, zorder=z - 0.1)
        self._mark(np.array([a, b]) + 3 * p * down)

    def text(self, at: Array, text: str, colour: str = INK, size: float = 8.0, **look: Any) -> None:
        """Write a text centred on a place."""
        x, y = (float(part) for part in at)
        self.axis.text(x, y, text, color=colour, fontsize=size, **{"ha": "center", "va": "center", "zorder": 9, **look})

    def turning(self, outline: Array, colour: str = VERMILLION) -> None:
        """Draw a rotation: an arrow along an arc."""
        self.arrow(outline, colour, 1.5, head=5.5)

    def _mark(self, points: Array) -> None:
        """Leave ink along points (n, 2), one for every 3 points of length."""
        way = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
        steps = np.linspace(0.0, way[-1], int(min(way[-1] / (3 * self.point), 2000)) + 1)
        (self.light if self.ghost else self.ink).append(
            np.stack([np.interp(steps, way, points[:, k]) for k in range(2)], axis=-1)
        )

    def inked(self, centre: Array, half: float) -> int:
        """Count the ink in a square about a place."""
        points = np.concatenate([np.zeros((0, 2)), *self.ink])
        return int(np.sum(np.max(np.abs(points - centre), axis=1) < half))


def _circle() -> Array:
    return np.stack([np.cos(COARSE), np.sin(COARSE)], axis=-1)


def goes_round(outline: Array, at: Array) -> bool:
    """Return whether an outline (n, 2) goes round a point: a ray crosses it an odd number of times."""
    (x, y), (to_x, to_y) = outline.T - at[:, None], np.roll(outline, -1, axis=0).T - at[:, None]
    crosses = (y > 0) != (to_y > 0)
    rise = np.where(crosses, to_y - y, 1.0)
    return bool(np.sum(crosses & (x - y * (to_x - x) / rise > 0)) % 2)


def nice(number: float) -> float:
    """Return the nearest of 1, 2, 5, 10, ... below a number."""
    power = 10.0 ** np.floor(np.log10(number))
    return float(max(step * power for step in (1, 2, 5) if step * power <= number))


def tint(colour: str, strength: float) -> tuple[float, float, float]:
    """Mix a colour with white."""
    r, g, b = (1 - strength * (1 - part) for part in to_rgb(colour))
    return (r, g, b)


def shade(colour: str) -> str:
    """Darken a colour until it is readable."""
    r, g, b = (0.78 * part for part in to_rgb(colour))
    return to_hex((r, g, b))


def hull(points: Array) -> Array:
    """Return the convex hull of points (n, 2), counter-clockwise (Andrew's monotone chain)."""
    ordered = sorted(map(tuple, points.tolist()))
    half: list[list[tuple[float, ...]]] = []
    for sweep in (ordered, ordered[::-1]):
        chain: list[tuple[float, ...]] = []
        for point in sweep:
            while len(chain) > 1 and _turn(chain[-2], chain[-1], point) <= 0:
                chain.pop()
            chain.append(point)
        half.append(chain[:-1])
    return np.array(half[0] + half[1]) if len(ordered) > 1 else np.array(ordered)


def _turn(a: tuple[float, ...], b: tuple[float, ...], c: tuple[float, ...]) -> float:
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
