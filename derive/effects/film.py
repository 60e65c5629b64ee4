"""The film of a lubricated pin on the tape: its force midway between the centres, its couple, what it dissipates."""

from __future__ import annotations

from typing import Any

import sympy as sp

from hertzwerk.derive.algebra.functions import Where
from hertzwerk.derive.algebra.vectors import Vector, add, cross, dot, scale, sub
from hertzwerk.derive.contact.touch import touch
from hertzwerk.derive.declare.scene import Scene
from hertzwerk.derive.dimension.dimension import Dimension
from hertzwerk.derive.effects.element import Element
from hertzwerk.derive.effects.lubrication import Lubrication
from hertzwerk.derive.laws.law import eps_c, eps_w
from hertzwerk.derive.motion.kinematics import Kinematics
from hertzwerk.derive.units import parse_unit


def film(effect: Lubrication, kin: Kinematics, scene: Scene) -> Element:
    """The element of a film; its outputs are the size of its force [N] and its least thickness [m], which is a boundary layer where that is more."""
    return _Film(effect, kin, scene).element()


class _Film:
    def __init__(self, effect: Lubrication, kin: Kinematics, scene: Scene) -> None:
        self.effect, self.kin, self.scene = effect, kin, scene
        pair = next(pair for pair in scene.mechanism.pairs if pair.name == effect.pair)
        if not pair.holds_film:
            raise TypeError(f"{effect.name}: a film at {pair.name}, which holds none")
        self.touch: Any = touch(pair, kin)
        self.clearance = sp.sympify(self.touch.pair.clearance)
        self.layer = sp.sympify(effect.boundary_layer) / self.clearance

    def let(self, expression: Any, what: str, stated: str = "") -> Any:
        """Name a result on the tape; of an unchecked law the unit it claims."""
        dimension = Dimension.from_unit(parse_unit(stated), {}) if stated and self.effect.unchecked else None
        return self.kin.tape.let(expression, f"{self.effect.name}_{what}", dimension)

    def named(self, vector: Vector, what: str) -> Vector:
        """Name a vector on the tape."""
        return self.kin.tape.vector(vector, f"{self.effect.name}_{what}")

    def element(self) -> Element:
        """Forces, dissipated power, outputs."""
        touch, kin = self.touch, self.kin
        axis = self.named(kin.direction(touch.second, touch.pair.axis), "axis")
        middle = add(touch.base, scale(sp.Rational(1, 2), touch.apart))
        rate = self.named(touch.rate_at(middle), "squeeze")
        squeeze = self.named(sub(rate, scale(self.let(dot(rate, axis), "along"), axis)), "squeeze")
        across = self.named(cross(axis, squeeze), "across")
        bodies = touch.first.body, touch.second.body
        turning = sub(*(kin.motion(body).angular_velocity for body in bodies))
        spin = self.let(dot(axis, turning), "spin")

        near, faded = self._closeness()
        along_drag, across_drag, spin_drag = self._drags(squeeze, across, near)
        force = self.named(scale(-faded, add(scale(along_drag, squeeze), scale(across_drag, across))), "force")
        couple = self.let(-faded * spin_drag * spin, "couple")

        forces = kin.generalised(force, middle, *bodies, self.effect.name)
        for row, moment in kin.generalised_moment(scale(couple, axis), *bodies, f"{self.effect.name}_couple").items():
            forces[row] = forces.get(row, sp.S.Zero) + moment
        power = self.let(-dot(force, squeeze) - couple * spin, "power")
        thickness = self.let(self.clearance * (1 - near * self.let(sp.sqrt(self._squared), "e_size")), "thickness")
        size = self.let(sp.sqrt(dot(force, force)), "force_size")
        outputs = (f"{self.effect.name}.force", "N", size), (f"{self.effect.name}.thickness", "m", thickness)
        return Element(forces, power=power, outputs=outputs)

    @property
    def _squared(self) -> Any:
        """Of the eccentricity [m^2]."""
        return self.let(dot(self.touch.eccentricity, self.touch.eccentricity), "e_squared")

    def _closeness(self) -> tuple[Any, Any]:
        """What the eccentricity is multiplied by [1/m], 1/clearance up to a film of two layers, so that the film is never thinner than one; and the
        share of the film that is left in contact."""
        layer, clearance = self.layer, self.clearance
        free = self.let(1 - 2 * layer, "free")
        squared = self.let(self._squared / clearance**2, "epsilon_squared")
        # not of the centre, where a root has no derivative
        ratio = self.let(sp.sqrt(Where(squared > free**2, squared, free**2)), "epsilon")
        thinning = self.let(Where(squared < 1, (ratio - free) / (2 * layer), 1), "thinning")
        # from 1 - 2 layer to 1 - layer, with slope 1 at the one end and 0 at the other, and no curvature at either
        limited = self.let(free + 2 * layer * thinning * (1 - thinning**2 * (1 - thinning / 2)), "limited")
        sinking = self.let(Where(squared > 1, (ratio - 1) / layer, 0), "sinking")
        share = Where(squared < (1 + layer) ** 2, 1 - sinking**2 * (3 - 2 * sinking), 0)
        return self.let(limited / (ratio * clearance), "per_e"), self.let(share, "share")

    def _drags(self, squeeze: Vector, across: Vector, near: Any) -> list[Any]:
        """Of the law, at the place of the pin: along, across, against the spin."""
        bound, e = self.effect.law, self.touch.eccentricity
        squared = self.let(dot(squeeze, squeeze), "squeeze_squared")
        pace = sp.sympify(self.scene.scales.speed)
        nonzero = self.let(sp.sqrt(Where(squared > 0, squared, pace**2)), "squeeze_speed")
        values: dict[sp.Symbol, Any] = {
            eps_w: self.let(near * dot(e, squeeze) / nonzero, "epsilon_w"),
            eps_c: self.let(near * dot(e, across) / nonzero, "epsilon_c"),
            **bound.binding,
        }
        geometry = self.scene.geometry(self.effect.pair)
        values |= {quantity: geometry[quantity.name] for quantity in bound.law.geometry()}
        for symbol, expression in bound.law.definitions:
            values[symbol] = self.let(expression.xreplace(values), symbol.name, symbol.unit)
        return [
            self.let(expression.xreplace(values), f"drag_{name}", unit)
            for name, (_, expression, unit) in zip(("along", "across", "spin"), bound.law.expressions(), strict=True)
        ]
