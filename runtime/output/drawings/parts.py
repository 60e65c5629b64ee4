"""Parts of a mechanism on paper: bodies between their points, surfaces to scale, joints as symbols."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass

import numpy as np

from hertzwerk.runtime.output.drawings.drawing_primitives import INK, ROUND, Paper, goes_round, hull, nice
from hertzwerk.runtime.output.drawings.ground_planes import ground_planes
from hertzwerk.runtime.output.drawings.places import GROUND, SOLIDS, Landmark, Places
from hertzwerk.runtime.output.drawings.view import View
from hertzwerk.runtime.output.plots.plot_style import CYCLE, GREY
from hertzwerk.runtime.output.plots.unit_prefixes import Scale
from hertzwerk.runtime.system.arrays import Array
from hertzwerk.runtime.system.lazy import cached_property

BAR = 3.6  # half the width of a bar, points
BLOCK = (13.0, 8.5)  # half the size of a slider, along and across, points
STUB = 17.0  # half the visible axis of a joint in space, points
FOOT = 13.0  # distance of a joint's ground, points
SLIDING = ("prismatic", "cylindrical")
HOLDING = ("revolute", "universal", "spherical", "weld")
INSIDE = ("pin_in_bush", "ball_in_socket")
ROUNDS = (
    "sphere_on_plane",
    "sphere_on_sphere",
    "parallel_cylinders",
    "cylinder_on_plane",
    "rim_on_plane",
    "sphere_on_box",
    "box_on_box",
    "sphere_on_face",
    "sphere_on_edge",
    "sphere_on_cylinder",
    "circle_on_curve",
    "point_on_curve",
    "face_on_curve",
    "curve_on_curve",
    "track",
)
RIM = 0.25  # width of a bush or socket around its hole, in radii
APART = ("gravity", "force", "moment", "planar")  # kinds that shape no body
FACING = 0.98  # cosine of the angle from which on a tube is looked through
ROD = "flexible_rod"
BENT, TINY = 0.06, 1e4  # largest sag of a rod that is shown, in lengths; factor from which on it counts as straight
THIN = 0.2  # projected length below which a unit direction is not drawn


@dataclass(frozen=True)
class Parts:
    """Projected mechanism: places, view and unit."""

    places: Places
    view: View
    unit: Scale

    @cached_property
    def of(self) -> dict[tuple[str, str], list[Landmark]]:
        """Landmarks by part and kind."""
        return self.places.parts()

    @cached_property
    def colours(self) -> dict[str, str]:
        """Colours of the bodies."""
        bodies = self.places.bodies[1:]
        colours = {GROUND: GREY} | {body: CYCLE[i % len(CYCLE)] for i, body in enumerate(bodies)}
        return colours | {mark.body: colours[marks[0].body] for marks in self.rods.values() for mark in marks}

    @cached_property
    def rods(self) -> dict[str, list[Landmark]]:
        """Sections of the flexible rods from start to end, by part."""
        return {part: marks for (part, kind), marks in self.of.items() if kind == ROD}

    @cached_property
    def bent(self) -> dict[str, float]:
        """Factors by which the sag of each rod, from the line between its ends, is enlarged."""
        factors = {}
        for part, marks in self.rods.items():
            points = np.array([self.positions[id(mark)] for mark in marks])
            line = points[-1] - points[0]
            sag = np.max(np.linalg.norm(points[1:-1] - _on_line(points), axis=-1))
            wanted = BENT * float(np.max(np.linalg.norm(line, axis=-1))) / max(float(sag), 1e-300)
            factors[part] = nice(wanted) if 1 < wanted < TINY and self.places.enlarged else 1.0
        return factors

    def rod(self, part: str, i: int) -> Array:
        """Return a bent rod on the paper, its sag enlarged: points (k, 2)."""
        marks = self.rods[part]
        points = np.array([self.positions[id(mark)] for mark in marks])[:, i]
        ways = np.array([self.places.direction(mark, "along")[i] for mark in marks])
        line = points[-1] - points[0]
        length = float(np.linalg.norm(line))
        straight = np.concatenate([points[:1], _on_line(points), points[-1:]])
        points = straight + self.bent[part] * (points - straight)
        ways = line + self.bent[part] * (ways * length - line)
        return self.flat(_smooth(points, ways / (len(marks) - 1)))

    @cached_property
    def walls(self) -> dict[int, tuple[Array, Array]]:
        """Normals and outlines of planes of the ground that meet in an oblique view, by the landmark's id."""
        return ground_planes(self.places) if self.view.names is None else {}

    # -- on the paper --------------------------------------------------------------------------------------------------

    def flat(self, points: Array) -> Array:
        """Project points in space [m] to the paper, in its unit."""
        return np.asarray(self.unit(self.view(points)))

    @cached_property
    def positions(self) -> dict[int, Array]:
        """Position of every landmark, by its id, over time [m]: (n, 3)."""
        return {id(mark): self.places.point(mark) for mark in self.places.landmarks}

    def at(self, mark: Landmark, i: int) -> Array:
        """Return a landmark on the paper at an instant."""
        return self.flat(self.positions[id(mark)][i])

    def way(self, mark: Landmark, name: str, i: int) -> tuple[Array, float]:
        """Return a direction on the paper as a unit vector, and its projected length."""
        vector = self.places.direction(mark, name)[i]
        projected = self.view(vector / max(float(np.linalg.norm(vector)), 1e-300))
        length = float(np.linalg.norm(projected))
        return (projected / length if length > 1e-6 else np.array([1.0, 0.0])), length

    def ring(self, centre: Array, axis: Array | None, radius: float) -> Array:
        """Return the outline of a circle about an axis, or of a sphere, at a point in space [m]."""
        first, second = (self.view.right, self.view.up) if axis is None else across(axis)
        around = np.cos(ROUND)[:, None] * first + np.sin(ROUND)[:, None] * second
        return self.flat(centre + radius * around)

    # -- everything at an instant --------------------------------------------------------------------------------------

    def draw(self, paper: Paper, i: int) -> None:
        """Draw bodies, surfaces, joints and mass centres; for a ghost only the bodies."""
        bodies = self.places.bodies[1:]
        order = sorted(bodies, key=lambda body: self._depth(body, i)) if self.view.names is None else bodies
        for rank, body in enumerate(order):
            self._body(paper, body, i, 3 + rank / len(bodies))
        if not paper.ghost:
            self._joints(paper, i)
        self._pairs(paper, i)
        if not paper.ghost:
            for mark in self.places.landmarks:
                if mark.kind == "body":
                    paper.centre(self.at(mark, i))

    def _depth(self, body: str, i: int) -> float:
        marks = self.places.of_body(body)
        return float(np.mean([self.view.depth(self.positions[id(mark)][i]) for mark in marks])) if marks else 0.0

    # -- bodies --------------------------------------------------------------------------------------------------------

    def _shaping(self, body: str) -> list[Landmark]:
        """Return the landmarks that a body extends between."""
        marks = [
            m
            for m in self.places.of_body(body)
            if m.kind not in (*APART, ROD) and not m.kind.startswith(("slide_", "turn_", *SOLIDS))
        ]
        return marks or [m for m in self.places.of_body(body) if m.kind == "planar"]

    def corners(self, body: str, i: int) -> Array:
        """Return the points on the paper that a body extends between."""
        marks = self._shaping(body)
        sliding = [
            self._other(mark) for mark in marks if mark.kind in SLIDING and mark.place == "parent"
        ]  # stays on it
        points = [self.at(mark, i) for mark in (*marks, *sliding)]
        points += [at for part, ends in self.rods.items() if ends[0].body == body for at in self.rod(part, i)[::10]]
        return np.unique(np.round(np.array(points), 12), axis=0) if points else np.zeros((0, 2))

    def _other(self, mark: Landmark) -> Landmark:
        return next(other for other in self.of[mark.part, mark.kind] if other.place != mark.place)

    def _body(self, paper: Paper, body: str, i: int, z: float) -> None:
        colour, marks, p = self.colours[body], self._shaping(body), paper.point
        for part in (part for part, sections in self.rods.items() if sections[0].body == body):
            paper.band(self.rod(part, i), BAR * p, colour, z)
        solid = any(mark.place == "corner" for mark in marks)
        rails = [mark for mark in marks if mark.kind in SLIDING and mark.place == "parent"]
        still = np.array([self.at(mark, i) for mark in marks])
        solids = [mark for mark in self.places.of_body(body) if mark.kind.startswith(SOLIDS)]
        if self.view.names is None:
            solids.sort(key=lambda mark: self.view.depth(self.positions[id(mark)][i]))
        for mark in solids:
            self._solid(paper, mark, i, z)
        if len(still) and not solids:
            spread = float(np.max(np.ptp(still, axis=0)))
            blocked = [
                mark
                for mark in marks
                if mark.kind in SLIDING and mark.place == "child" and not self._is_round(mark) and not solid
            ]
            for mark in blocked:
                self._block(paper, mark, i, z)
            if spread > 0.5 * p or not (blocked or any(map(self._is_round, marks)) or rails):
                paper.plate(still, 0.0 if solid else BAR * p, colour, z)
        for mark in rails:
            a, b = self.at(mark, i), self.at(self._other(mark), i)
            way, _ = self.way(mark, "axis", i)
            low, high = np.sort([0.0, (b - a) @ way])
            paper.plate(np.array([a + (low - 4 * p) * way, a + (high + 24 * p) * way]), 0.6 * BAR * p, colour, z - 0.2)

    def solid(self, mark: Landmark, i: int) -> Array:
        """Return the outline on the paper of a shape that a body is made of, or that is taken out of it."""
        where, turned = self.positions[id(mark)][i], self.places.rotations[i, self.places.bodies.index(mark.body)]
        if "size" in mark.beside:
            return hull(self.flat(where + _corners(mark) @ turned.T))
        if "axis" not in mark.beside:
            return self.ring(where, None, mark.size("radius"))
        axis = self._axis(mark, i)
        half = mark.size("length") / 2 * axis
        if mark.kind.endswith("rod"):
            return self.flat(np.array([where - half, where + half]))
        if mark.kind.endswith("cone"):
            tip = self.flat((where + 2 * half)[None])
            return hull(np.concatenate([self.ring(where, axis, mark.size("radius")), tip]))
        ends = [self.ring(where + end, axis, mark.size("radius")) for end in (-half, half)]
        return hull(np.concatenate(ends))

    def _solid(self, paper: Paper, mark: Landmark, i: int, z: float) -> None:
        outline = self.solid(mark, i)
        through = "axis" in mark.beside and abs(self._axis(mark, i) @ self.view.towards) > FACING
        if mark.kind.endswith("rod"):
            paper.plate(outline, BAR * paper.point, self.colours[mark.body], z)
        elif mark.kind.startswith("solid_"):
            paper.area(outline, self.colours[mark.body], z)
            if "hole_radius" in mark.beside and through:
                paper.hole(
                    self.ring(self.positions[id(mark)][i], self._axis(mark, i), mark.size("hole_radius")), z + 0.05
                )
        elif through:
            paper.hole(outline, z + 0.05)

    def _axis(self, mark: Landmark, i: int) -> Array:
        return np.asarray(self.places.direction(mark, "axis")[i])

    def _is_round(self, mark: Landmark) -> bool:
        """Return whether a surface of its body is centred in a landmark."""
        return any(
            other.body == mark.body
            and "radius" in other.beside
            and other.place != "bush"
            and np.allclose(other.point, mark.point)
            for other in self.places.landmarks
        )

    def half_block(self, paper: Paper, mark: Landmark) -> tuple[float, float]:
        """Return half the size of a joint's slider, along and across: large enough for a bush in it."""
        along, across = (size * paper.point for size in BLOCK)
        for other in self.places.of_body(mark.body):
            if "radius" in other.beside and np.linalg.norm(other.point - mark.point) < other.size("radius"):
                reach = other.size("radius") / self.unit.factor * 1.3 + 4 * paper.point
                along, across = max(along, 1.35 * reach), max(across, reach)
        return along, across

    def _block(self, paper: Paper, mark: Landmark, i: int, z: float) -> None:
        way, projected = self.way(mark, "axis", i)
        at, (along, across) = self.at(mark, i), self.half_block(paper, mark)
        if projected < THIN:
            along = across
        side = np.array([-way[1], way[0]])
        outline = [at + a * along * way + b * across * side for a, b in ((1, 1), (-1, 1), (-1, -1), (1, -1))]
        paper.area(np.array(outline), self.colours[mark.body], z + 0.05)

    # -- joints --------------------------------------------------------------------------------------------------------

    def _joints(self, paper: Paper, i: int) -> None:
        for (_, kind), marks in self.of.items():
            parent = marks[0]
            if kind in SLIDING and parent.body == GROUND:
                self._rails(paper, parent, marks[1], i)
            if kind not in HOLDING:
                continue
            at = self.at(parent, i)
            if self.view.names is None and kind == "revolute":
                way, projected = self.way(parent, "axis", i)
                reach = STUB * paper.point * projected * way
                paper.line(np.array([at - reach, at + reach]), INK, 0.7, 6.9, (0, (6, 2, 1.5, 2)))
            if parent.body == GROUND:
                if id(parent) not in self._sides:  # in a film it stays where it was
                    self._sides[id(parent)] = self._free_side(paper, at)
                paper.footing(at, self._sides[id(parent)])
            if kind == "weld":
                paper.square(at)
            elif kind == "spherical":
                paper.pin(at, 3.8, INK)
            elif kind == "universal":
                paper.pin(at, 4.2)
                for mark in marks:
                    way, projected = self.way(mark, "axis", i)
                    paper.line(
                        np.array([at - 4.2 * paper.point * projected * way, at + 4.2 * paper.point * projected * way]),
                        INK,
                        1.1,
                        7.2,
                    )
            else:
                paper.pin(at)

    @cached_property
    def _sides(self) -> dict[int, Array]:
        """Directions that the ground of a joint has been drawn in, by the id of its landmark."""
        return {}

    def _free_side(self, paper: Paper, at: Array) -> Array:
        """Return the direction down, or that with much less ink."""
        reach = FOOT * paper.point
        sides = np.array([[0.0, -1.0], [0.0, 1.0], [-1.0, 0.0], [1.0, 0.0]])
        covered = [paper.inked(at + 0.8 * reach * side, 0.5 * reach) + 1.5 * k for k, side in enumerate(sides)]
        return np.asarray(sides[int(np.argmin(covered))])

    def _rails(self, paper: Paper, parent: Landmark, child: Landmark, i: int) -> None:
        """Draw the ground on both sides of a slider along its travel; only its line where it is no block."""
        way, projected = self.way(parent, "axis", i)
        if projected < THIN:
            return
        at = self.at(parent, i)
        travel = (self.flat(self.positions[id(child)]) - at) @ way
        along, across = self.half_block(paper, child)
        low, high = float(np.min(travel)) - along, float(np.max(travel)) + along
        body = self._shaping(child.body)
        if self._is_round(child) or any(mark.place == "corner" for mark in body):
            more = 16 * paper.point
            paper.line(
                np.array([at + (low - more) * way, at + (high + more) * way]),
                GREY,
                0.7,
                2.0,
                (0, (8, 3, 1.5, 3)),
                ink=False,
            )
            return
        side, more = np.array([-way[1], way[0]]), 6 * paper.point
        for sign in (1, -1):
            edge = sign * (across + 1.5 * paper.point) * side
            paper.ground(at + edge + (low - more) * way, at + edge + (high + more) * way, sign * side, z=2.0)

    # -- surfaces ------------------------------------------------------------------------------------------------------

    def _pairs(self, paper: Paper, i: int) -> None:
        drawn: set[tuple[object, ...]] = set()
        for (_, kind), marks in self.of.items():
            if kind in INSIDE and not paper.ghost:
                self._inside(paper, marks[0], marks[1], i)
            for mark in marks if kind in ROUNDS or kind == "corner_on_face" else ():
                key = (
                    mark.body,
                    mark.place,
                    *np.round(mark.point, 12),
                    *(round(float(x), 12) for v in mark.beside.values() for x in v),
                )
                if key not in drawn:
                    drawn.add(key)
                    self._surface(paper, mark, marks[0], i)
            if kind == "track" and not paper.ghost:
                paper.pin(self.at(marks[-1], i))
            if kind == "custom" and not paper.ghost:
                ends = np.array([self.at(mark, i) for mark in marks])
                paper.line(ends, GREY, 0.8, 6.0, (0, (2, 2)))
                for end in ends:
                    paper.pin(end, 2.2, GREY)

    def axis_of(self, marks: Sequence[Landmark], i: int) -> Array | None:
        """Return the axis of a round pair in space; None for spheres."""
        return next((self.places.direction(mark, "axis")[i] for mark in marks if "axis" in mark.beside), None)

    def _inside(self, paper: Paper, inner: Landmark, outer: Landmark, i: int) -> None:
        axis, radius = self.axis_of((inner, outer), i), outer.size("radius")
        rim = max(3 * paper.point * self.unit.factor, RIM * radius)
        hole, pin = self.positions[id(outer)][i], self.positions[id(inner)][i]
        over = 5.0 if inner.size("radius") > 0.5 * radius else 2.5  # a ring around much else is behind it
        paper.area(self.ring(hole, axis, radius + rim), self.colours[outer.body], over)
        paper.hole(self.ring(hole, axis, radius), over + 0.1)
        paper.area(self.ring(pin, axis, inner.size("radius")), self.colours[inner.body], 5.2)

    def _surface(self, paper: Paper, mark: Landmark, first: Landmark, i: int) -> None:
        where = self.positions[id(mark)][i]
        if mark.curve is not None:
            self._curve(paper, mark, i)
        elif mark.place in ("plane", "face"):
            if not paper.ghost:
                first = next((other for other in self.of[mark.part, mark.kind] if other.curve is not None), first)
                still = mark.body == GROUND and self.view.names is not None
                self._face(paper, mark, self.positions[id(first)][0 if still else i], i)
        elif "size" in mark.beside:
            paper.area(self.solid(mark, i), self.colours[mark.body], 4.4)
        elif mark.place == "edge":
            length = mark.size("length") if "length" in mark.beside else self._reach(paper)
            half = length / 2 * self.places.direction(mark, "along")[i]
            paper.line(self.flat(np.array([where - half, where + half])), INK, 1.6, 4.4)
        elif "radius" in mark.beside:
            alone = mark.place == "sphere"
            axis = None if alone else self.axis_of(self.of[mark.part, mark.kind], i)
            outline = self.ring(where, axis, mark.size("radius"))
            if "length" in mark.beside and axis is not None and self.view.names is None:
                half = self.flat(mark.size("length") / 2 * axis)
                outline = hull(np.concatenate([outline - half, outline + half]))
            paper.area(outline, self.colours[mark.body], 4.5)

    def curve(self, mark: Landmark, i: int) -> Array:
        """Return the points on the paper of the curve that is fixed at a landmark."""
        if mark.curve is None:
            raise ValueError(f"{mark.part}: no curve at {mark.place}")
        b = self.places.bodies.index(mark.body)
        return self.flat(self.places.origins[i, b] + mark.curve @ self.places.rotations[i, b].T)

    def is_covered(self, at: Array, body: str, i: int) -> bool:
        """Return whether the outline of another body goes round a point on the paper."""
        outlines = (mark for mark in self.places.landmarks if "outline" in mark.beside and mark.body != body)
        return any(goes_round(self.curve(mark, i), at) for mark in outlines)

    def _curve(self, paper: Paper, mark: Landmark, i: int) -> None:
        if "outline" in mark.beside:
            paper.area(self.curve(mark, i), self.colours[mark.body], 4.2)
        elif not paper.ghost or mark.body != GROUND:
            paper.line(self.curve(mark, i), self.colours[mark.body] if mark.body != GROUND else INK, 1.4, 4.2)

    def _face(self, paper: Paper, mark: Landmark, seen_from: Array, i: int) -> None:
        """Draw a plane or a face below a point of the body that may touch it."""
        if self.walls and mark.place == "plane" and mark.body == GROUND:
            self._wall(paper, mark)
            return
        normal, middle = self.places.direction(mark, "normal")[i], self.positions[id(mark)][i]
        if "along" in mark.beside:
            half = mark.size("length") / 2 * self.places.direction(mark, "along")[i]
        else:
            middle = seen_from - ((seen_from - middle) @ normal) * normal
            reach = self._reach(paper) * (1.0 if mark.body == GROUND and self.view.names else 0.3)
            across = np.cross(normal, self.view.towards)
            half = reach * across / max(float(np.linalg.norm(across)), 1e-9)
        down, length = self.way(mark, "normal", i)
        if self.view.names is None and "along" not in mark.beside:
            other = np.cross(normal, half)
            outline = self.flat(middle + np.array([half + other, other - half, -half - other, half - other]))
            paper.area(outline, self.colours[mark.body], 1.0, alpha=0.35)
        elif length > THIN:
            paper.ground(self.flat(middle - half), self.flat(middle + half), -down, z=2.4)

    def _wall(self, paper: Paper, mark: Landmark) -> None:
        """Draw a plane of the ground that meets others, once: its outline alone where it is seen from behind."""
        if id(mark) not in self.walls:
            return
        normal, corners = self.walls[id(mark)]
        outline = self.flat(corners)
        if normal @ self.view.towards > 0:
            paper.area(outline, GREY, 1.0, alpha=0.35)
        else:
            paper.line(np.concatenate([outline, outline[:1]]), GREY, 0.6, 6.0)

    def _reach(self, paper: Paper) -> float:
        """Return the diagonal of the whole paper [m]."""
        (left, right), (low, high) = paper.axis.get_xlim(), paper.axis.get_ylim()
        return float(np.hypot(right - left, high - low)) * self.unit.factor

    # -- for labels and extents ----------------------------------------------------------------------------------------

    def beside(self, paper: Paper, body: str, i: int) -> Array:
        """Return the points on the paper a body's name may stand beside.

        The edges of a slider, else the body's middle and points towards its corners.
        """
        corners = self.corners(body, i)
        if not len(corners):
            return self.flat(self.places.origins[i, self.places.bodies.index(body)])[None]
        middle = np.mean(corners, axis=0)
        anchors = [middle[None], middle + 0.5 * (corners - middle)]
        for mark in self._shaping(body):
            if mark.kind in SLIDING and mark.place == "child":
                way, _ = self.way(mark, "axis", i)
                along, across = self.half_block(paper, mark)
                side = np.array([-way[1], way[0]])
                anchors.append(self.at(mark, i) + np.array([across * side, -across * side, along * way, -along * way]))
        return np.concatenate(anchors)

    def length(self, i: int) -> float:
        """Return the median size of the bodies on the paper; 0 where all are points."""
        spans = [
            float(np.max(np.ptp(corners, axis=0)))
            for body in self.places.bodies[1:]
            if len(corners := self.corners(body, i)) > 1
        ]
        return float(np.median(spans)) if spans else 0.0

    @cached_property
    def extents(self) -> Array:
        """The points (k, 2) on the paper that must be visible, over all instants."""
        return np.concatenate(list(self._extents()))

    def _extents(self) -> Iterator[Array]:
        for mark in self.places.landmarks:
            if mark.kind == "gravity" or mark.place in ("plane", "axes"):
                continue
            if mark.kind.startswith(SOLIDS) and "size" not in mark.beside:
                yield from (self.solid(mark, i) for i in range(len(self.positions[id(mark)])))
                continue
            flat = self.flat(self.positions[id(mark)])
            reach = mark.size("radius") / self.unit.factor if "radius" in mark.beside else 0.0
            reach *= 1 + RIM * (mark.place in ("bush", "socket"))
            yield from (flat + reach * np.array(corner) for corner in ((1, 1), (-1, -1)))
            if "size" in mark.beside:
                turned = self.places.rotations[:, self.places.bodies.index(mark.body)]
                corners = self.positions[id(mark)][:, None] + _corners(mark) @ np.swapaxes(turned, 1, 2)
                yield self.flat(corners.reshape(-1, 3))
            elif mark.curve is not None:
                yield from (self.curve(mark, i) for i in range(len(flat)))
            elif mark.kind == "sphere_on_cylinder" and "length" in mark.beside:
                half = self.flat(mark.size("length") / 2 * self.places.direction(mark, "axis"))
                yield from (flat + end + reach * np.array(way) for end in (half, -half) for way in ((1, 1), (-1, -1)))
            elif "along" in mark.beside and "length" in mark.beside:
                half = self.flat(mark.size("length") / 2 * self.places.direction(mark, "along"))
                yield from (flat - half, flat + half)
        yield from (self.rod(part, i) for part in self.rods for i in range(len(self.places.t)))
        yield from (self.flat(outline) for _, outline in self.walls.values())
        for first, second in (marks[:2] for marks in self.of.values() if marks[-1].place == "plane"):
            points, normal = self.positions[id(first)], self.places.direction(second, "normal")
            height = np.sum((points - self.positions[id(second)]) * normal, axis=1, keepdims=True)
            yield self.flat(points - height * normal)


def _smooth(points: Array, ways: Array) -> Array:
    """Return a curve through points (k, 3) by Hermite's cubics, ten places between two.

    ways: slopes by the number of the point.
    """
    at = np.arange(10)[:, None] / 10
    pieces = [
        (1 - at) ** 2 * ((1 + 2 * at) * a + at * slope) + at**2 * ((3 - 2 * at) * b + (at - 1) * end)
        for a, b, slope, end in zip(points, points[1:], ways, ways[1:], strict=False)
    ]
    return np.concatenate([*pieces, points[-1:]])


def _on_line(points: Array) -> Array:
    """Return the inner points (k, ..., 3) evenly on the line from the first to the last."""
    at = np.linspace(0, 1, len(points))[1:-1].reshape(-1, *(1,) * (points.ndim - 1))
    return np.asarray((1 - at) * points[0] + at * points[-1])


def _corners(mark: Landmark) -> Array:
    """Return the corners of a box (8, 3) from its middle, along its body's axes."""
    corners = np.array(np.meshgrid(*[(-0.5, 0.5)] * 3)).reshape(3, -1).T * mark.beside["size"]
    if "along" in mark.beside:
        along, over = mark.beside["along"], mark.beside["across"]
        corners = corners @ np.array([along, over, np.cross(along, over)])
    return np.asarray(corners)


def across(axis: Array) -> tuple[Array, Array]:
    """Return two unit vectors across an axis, the second a quarter turn about it after the first."""
    axis = axis / np.linalg.norm(axis)
    least = np.eye(3)[int(np.argmin(np.abs(axis)))]
    first = least - (least @ axis) * axis
    first /= np.linalg.norm(first)
    return first, np.cross(axis, first)
