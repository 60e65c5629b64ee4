"""Pairs of many spheres, each of which may touch every other."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import dataclass
from itertools import combinations
from typing import Any

from hertzwerk.derive.common.faults import Fault, InputError, shown
from hertzwerk.derive.common.identifiers import name_faults
from hertzwerk.derive.declare.mechanism.bodies import Body, Point
from hertzwerk.derive.declare.mechanism.pair import Pair
from hertzwerk.derive.equations.contact.pairs.on_sphere_or_cylinder import SphereOnSphere
from hertzwerk.derive.expressions.parameter import Scalar, is_number


@dataclass(frozen=True)
class SphereOfMany(SphereOnSphere):
    """Two of many spheres: a part of all their pairs."""

    whole: str = ""


def every_pair(name: str, spheres: Iterable[Body | Point], radius: Scalar) -> tuple[Pair, ...]:
    """Pairs of equal spheres, each of which may touch every other, under one name.

    A sphere is a body, about its mass centre, or a point of one; points of the same body make no pair. `radius` [m] is
    that of all. The pairs are NAME_1_2, NAME_1_3, NAME_2_3.. by the places in `spheres`, from 1. What acts at NAME acts at
    each of them: `Contact("balls", law)` is `Contact("balls_1_2", law)`.., and an effect declared at one of them stands
    there in place of what the others share. Raises InputError, listing every fault.
    """
    where = f"pairs {name if isinstance(name, str) else shown(name)}"
    places: list[Any] | None = None
    if isinstance(spheres, Iterable):  # what is no body or point is a fault
        places = [sphere.at(*sphere.centre) if isinstance(sphere, Body) else sphere for sphere in spheres]
    faults = [*name_faults("pairs", name), *_faults(where, spheres, places, radius)]
    if places is None or faults:
        raise InputError(where, faults)
    return tuple(
        SphereOfMany(f"{name}_{i}_{j}", first, second, radius, radius, whole=name)
        for (i, first), (j, second) in combinations(enumerate(places, 1), 2)
        if first.body != second.body
    )


def _faults(where: str, spheres: Any, places: list[Any] | None, radius: Any) -> Iterator[Fault]:
    if not is_number(radius):
        yield Fault(f"{where}, radius", shown(radius), "a Parameter or an expression of parameters")
    if places is None:
        yield Fault(f"{where}, spheres", shown(spheres), "a list of bodies, or of points of bodies")
        return
    firsts: dict[Any, int] = {}
    for i, place in enumerate(places, 1):
        if not isinstance(place, Point):
            yield Fault(f"{where}, sphere {i}", shown(place), "a Body, or a point of one: body.at(x, y, z)")
        elif (first := firsts.setdefault(place, i)) != i:
            yield Fault(f"{where}, sphere {i}", f"the place of sphere {first}", "a place of its own", "List it once.")
    if all(isinstance(place, Point) for place in places) and (count := len({place.body for place in places})) < 2:
        actual = f"{len(places)} spheres on {count} bodies"
        yield Fault(f"{where}, spheres", actual, "spheres on two bodies or more")
