"""Parameters of the built-in scenes at the edge of every range they are defined in.

At a closed end, or a millionth of the default from an open one.
"""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

from hertzwerk.runtime.analysis.hard_cases import closed_forms
from hertzwerk.runtime.analysis.hard_cases.case import IMPLICIT, METHODS, HardCase, Known, Source, final, impact

V0 = math.sqrt(2 * 9.81)


def _ball(parameter: str, side: str, **parameters: float | tuple[float, str]) -> HardCase:
    known = (impact(0, "speed", V0, 1e-7 * V0, "free fall"),)
    return _case("bouncing_ball", parameter, side, 0.6, parameters, known)


def _spheres(
    parameter: str, side: str, known: tuple[Known, ...] = (), **parameters: float | tuple[float, str]
) -> HardCase:
    return _case("two_spheres", parameter, side, 0.1, parameters, known)


def _crank(parameter: str, side: str, outcome: str = "finished", **parameters: float | tuple[float, str]) -> HardCase:
    return replace(_case("slider_crank", parameter, side, 0.002, parameters, ()), outcome=outcome)


def _passed_through() -> HardCase:
    reason = "the bodies pass through each other within one step: the scene's scale of lengths is 8000 times the radius"
    case = _case("two_spheres", "radius", "lower", 0.1, {"radius": (2e-8, "m")}, ())
    failures = {(method, name): reason for method in METHODS for name in ("outcome", "depth/bound")}
    return replace(case, outcome="outside_law_range", failures=failures)


def _case(
    scene: str,
    parameter: str,
    side: str,
    duration: float,
    parameters: Mapping[str, float | tuple[float, str]],
    known: tuple[Known, ...],
) -> HardCase:
    values = ", ".join(f"{name} = {_text(value)}" for name, value in parameters.items())
    return HardCase(
        name=f"edge_{scene}_{parameter}_{side}",
        theme="edges of ranges",
        hard=f"{scene} at the {side} end of {parameter}: {values}",
        source=Source(scene),
        duration=duration,
        tolerance=1e-8,
        parameters=parameters,
        known=known,
    )


def _stiff(case: HardCase) -> HardCase:
    """Restrict a case to the methods for stiff problems."""
    return replace(case, hard=f"{case.hard}; stiff", methods=(*IMPLICIT, "auto"))


def _text(value: float | tuple[float, str]) -> str:
    return f"{value[0]:g} {value[1]}" if isinstance(value, tuple) else f"{value:g}"


def _halves(e: float) -> tuple[Known, ...]:
    out = closed_forms.restitution_out(closed_forms.flores(e))
    return tuple(
        final(f"{name}_path.speed", 0.3 * (1 + sign * out) / 2, 3e-7, "momentum and h (1 + e) = ln((1 + h)/(1 - h e))")
        for name, sign in (("striker", -1), ("target", 1))
    )


CASES = (
    _ball("mass", "lower", mass=(1e-6, "kg")),
    _ball("radius", "lower", radius=(1e-7, "m")),
    _ball("stiffness", "lower", stiffness=(2.4e4, "N/m^1.5")),
    _ball("exponent", "lower", exponent=1, stiffness=(2.4e7, "N/m^1")),
    _ball("exponent", "upper", exponent=10, stiffness=(2.4e40, "N/m^10")),
    _stiff(_ball("restitution", "lower", restitution=9e-7)),
    _ball("restitution", "upper", restitution=1.0),
    _ball("approach_floor", "lower", approach_floor=(1e-9, "m/s")),
    _spheres("mass", "lower", _halves(0.7), mass=(9.2e-8, "kg")),
    _passed_through(),
    _spheres("youngs_modulus", "lower", youngs_modulus=(2.07e-4, "GPa")),
    _spheres("poissons_ratio", "lower", _halves(0.7), poissons_ratio=-1 + 3e-7),
    _spheres("poissons_ratio", "upper", _halves(0.7), poissons_ratio=0.5),
    _spheres("density", "lower", _halves(0.7), density=(7.8e-3, "kg/m^3")),
    _stiff(_spheres("restitution", "lower", restitution=7e-7)),
    _spheres("restitution", "upper", _halves(1.0), restitution=1.0),
    _spheres("approach_floor", "lower", _halves(0.7), approach_floor=(1e-9, "m/s")),
    _spheres("speed", "lower", speed=(3e-7, "m/s")),
    _crank("crank_mass", "lower", crank_mass=(3e-7, "kg")),
    _crank("crank_inertia", "lower", crank_inertia=(0, "kg m^2")),
    _crank("rod_mass", "lower", rod_mass=(2.1e-7, "kg")),
    _crank("rod_inertia", "lower", rod_inertia=(0, "kg m^2")),
    _stiff(_crank("slider_mass", "lower", slider_mass=(1.4e-7, "kg"))),
    _crank("bush_radius", "lower", "outside_law_range", bush_radius=(0.5 + 1e-5, "mm")),
    _crank("clearance", "lower", clearance=(5e-7, "mm")),
    _crank("youngs_modulus", "lower", "outside_law_range", youngs_modulus=(2.07e-4, "GPa")),
    _crank("poissons_ratio", "lower", poissons_ratio=-1 + 3e-7),
    _crank("poissons_ratio", "upper", poissons_ratio=0.5),
    _crank("density", "lower", density=(7.8e-3, "kg/m^3")),
    _crank("restitution", "lower", restitution=0.0),
    _crank("restitution", "upper", restitution=1.0),
    _crank("approach_floor", "lower", approach_floor=(1e-9, "m/s")),
    _crank("friction_coefficient", "lower", friction_coefficient=0.0),
    _crank("friction_speed", "lower", friction_speed=(1e-7, "m/s")),
    _crank("rod_length", "lower", rod_length=(0.05 + 1e-6, "m")),
)
