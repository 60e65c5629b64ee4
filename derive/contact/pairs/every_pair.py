"""Pairs of many spheres, each of which may touch every other."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import Any

from hertzwerk.derive.contact.pairs.round import SphereOnSphere
from hertzwerk.derive.faults import Fault, InputError, shown
from hertzwerk.derive.identifiers import name_faults
from hertzwerk.derive.mechanism.bodies import Body, Point
from hertzwerk.derive.mechanism.pair import Pair
from hertzwerk.derive.mechanism.parameter import Scalar, is_number


@dataclass(frozen=True)
class SphereOfMany(SphereOnSphere):
    """Two of many spheres: a part of all their pairs."""

    whole: str = ""

    @property
    def part_of(self) -> str:  # type: ignore[override]  # of each its own
        """Name that all pairs share."""
        return self.whole


def every_pair(name: str, spheres: Iterable[Body | Point], radius: Scalar) -> tuple[Pair, ...]:
    """Pairs of equal spheres, each of which may touch every other, under one name.

    A sphere is a body, about its mass centre, or a point of one; points of the same body make no pair. `radius` [m] is
    that of all. The pairs are NAME_1_2, NAME_1_3, NAME_2_3.. by the places in `spheres`, from 1. What acts at NAME acts at
    each of them: `Contact("balls", law)` is `Contact("balls_1_2", law)`.., and an effect declared at one of them stands
    there in place of what the others share. Raises InputError, listing every fault.
    """
    listed: list[Any] = list(spheres) if isinstance(spheres, Iterable) else []
    faults = list(_faults(name, spheres, listed, radius))
    if faults:
        raise InputError(f"pairs {name if isinstance(name, str) else shown(name)}", faults)
    places = [(i, _place(sphere)) for i, sphere in enumerate(listed, 1)]
    return tuple(
        SphereOfMany(f"{name}_{i}_{j}", first, second, radius, radius, whole=name)
        for (i, first), (j, second) in combinations(places, 2)
        if first.body != second.body
    )


def _place(sphere: Body | Point) -> Point:
    return sphere if isinstance(sphere, Point) else sphere.at(*sphere.centre)


def _faults(name: Any, spheres: Any, listed: list[Any], radius: Any) -> Iterator[Fault]:
    where = f"pairs {name if isinstance(name, str) else shown(name)}"
    yield from name_faults("pairs", name)
    if not is_number(radius):
        yield Fault(f"{where}, radius", shown(radius), "a Parameter or an expression of parameters")
    if not isinstance(spheres, Iterable):
        yield Fault(f"{where}, spheres", shown(spheres), "a list of bodies, or of points of bodies")
        return
    firsts: dict[Any, int] = {}
    for i, sphere in enumerate(listed, 1):
        if not isinstance(sphere, Body | Point):
            yield Fault(f"{where}, sphere {i}", shown(sphere), "a Body, or a point of one: body.at(x, y, z)")
        elif (first := firsts.setdefault(_place(sphere), i)) != i:
            yield Fault(f"{where}, sphere {i}", f"the place of sphere {first}", "a place of its own", "List it once.")
    if all(isinstance(sphere, Body | Point) for sphere in listed) and len({_place(s).body for s in listed}) < 2:
        yield Fault(f"{where}, spheres", f"{len(listed)} spheres on {len({_place(s).body for s in listed})} bodies",
                    "spheres on two bodies or more")  # fmt: skip
