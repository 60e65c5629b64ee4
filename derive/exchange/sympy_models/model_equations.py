"""Equations and declarations of a model of SymPy's mechanics, as SymPy has built them.

Nothing is simplified or solved here. Where a KanesMethod has eliminated dependent speeds, the same method forms the
equations again without its constraints, which are kept beside them: multipliers are then the constraints' forces.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cached_property
from types import ModuleType
from typing import Any

import sympy as sp
from sympy.physics.mechanics import KanesMethod, LagrangesMethod, Particle, System

from hertzwerk.derive.common.faults import Fault, InputError, shown
from hertzwerk.derive.exchange.sympy_models.to_sympy import TIME, SymPyEquations

KINDS = "a KanesMethod, a LagrangesMethod or a System of sympy.physics.mechanics, or equations by to_sympy"


@dataclass(frozen=True, eq=False)
class Reading:
    """Model as SymPy has it: M u' + bias = force, q' = rates, and constraints.

    frame, origin  inertial frame, and its fixed point or None
    q, u           coordinates, and speeds: their derivatives for Lagrange's equations
    rates          derivative of each coordinate
    mass, bias     mass matrix, and inertia forces at u' = 0 (of a Lagrangian, with the forces of its potential)
    force          generalised forces of the loads
    potential      energy of the Lagrangian's potential, or None
    stored         potential energies of the bodies, whose forces are among the loads, or 0
    holonomic, nonholonomic  constraints, on coordinates and on speeds; `mixed` where the latter may include the former's rates
    lagrangian     of Lagrange's equations, else None
    """

    frame: Any
    origin: Any
    q: tuple[Any, ...]
    u: tuple[Any, ...]
    rates: Mapping[Any, Any]
    bodies: tuple[Any, ...]
    loads: tuple[Any, ...]
    mass: Any
    bias: tuple[Any, ...]
    force: tuple[Any, ...]
    potential: Any
    stored: Any
    holonomic: tuple[Any, ...]
    nonholonomic: tuple[Any, ...]
    lagrangian: Any = None
    mixed: bool = False
    alone: bool = False
    """Whether the equations are all there is, so that neither loads nor a potential are known."""

    @cached_property
    def derivatives(self) -> dict[Any, Any]:
        """Derivatives of the coordinates, by the speeds."""
        return {q.diff(TIME): rate for q, rate in self.rates.items()}

    def velocity(self, point: Any) -> Any:
        """Velocity of a point in the inertial frame: as it was set, else the derivative of its position."""
        try:
            return point.vel(self.frame)
        except ValueError:
            return point.pos_from(self.origin).dt(self.frame)


def reading_of(method: Any, origin: Any) -> Reading:
    """Reading of a method of SymPy; raises InputError for anything else, and for equations not yet formed."""
    if isinstance(method, System):
        return _of_system(method, method.fixed_point if origin is None else origin)
    if isinstance(method, KanesMethod):
        return _of_kane(method, origin)
    if isinstance(method, LagrangesMethod):
        return _of_lagrange(method, origin)
    if isinstance(method, SymPyEquations | ModuleType) and hasattr(method, "kinematics"):
        return _of_equations(method)
    raise InputError("from_sympy", [Fault("method", shown(method), KINDS)])


def _of_system(system: Any, origin: Any) -> Reading:
    """Reading of a System.

    Its equations need not be formed, which would solve the constraints symbolically.
    """
    if isinstance(system.eom_method, LagrangesMethod):
        return _of_lagrange(system.eom_method, origin)
    if not (system.q and system.u and system.bodies):
        actual = f"{len(system.q)} coordinates, {len(system.u)} speeds, {len(system.bodies)} bodies"
        raise InputError(
            "from_sympy", [Fault("System", actual, "some of each", "system.add_bodies(...), add_coordinates(...).")]
        )
    _refuse_auxiliary("System", system.u_aux)
    loads = [*system.loads, *(load for actuator in system.actuators for load in actuator.to_loads())]
    whole = KanesMethod(system.frame, list(system.q), list(system.u), kd_eqs=list(system.kdes))
    whole.kanes_equations(list(system.bodies), loads or None)
    reading = _of_kane(whole, origin)
    own = system._vel_constrs  # in place of the rates of the holonomic ones and the nonholonomic ones
    speeds = system.nonholonomic_constraints if own is None else own
    return replace(
        reading, holonomic=tuple(system.holonomic_constraints), nonholonomic=tuple(speeds), mixed=own is not None
    )


def _of_kane(method: Any, origin: Any) -> Reading:
    if method._frstar is None:
        raise _not_formed("KanesMethod", "method.kanes_equations(bodies, loads)")
    _refuse_auxiliary("KanesMethod", method._uaux)
    rates = {q: method.kindiffdict()[q.diff(TIME)] for q in method.q}
    speeds = method._k_nh * sp.Matrix(method.u) + method._f_nh if method._udep else sp.Matrix()
    whole = method
    if method._udep:
        kinematical = [q.diff(TIME) - rate for q, rate in rates.items()]
        whole = KanesMethod(method._inertial, list(method.q), list(method.u), kd_eqs=kinematical)
        whole.kanes_equations(method.bodylist, method.forcelist or None)
    force, bias = whole._fr, whole._f_d + whole._fr
    return Reading(
        method._inertial, origin, tuple(method.q), tuple(method.u), rates, tuple(method.bodylist),
        tuple(method.forcelist or ()), whole._k_d, tuple(bias), tuple(force), None,
        sp.Add(*(sp.sympify(body.potential_energy, strict=True) for body in method.bodylist)),
        tuple(method._f_h), tuple(speeds), mixed=True,
    )  # fmt: skip


def _of_lagrange(method: Any, origin: Any) -> Reading:
    if method.eom is None:
        raise _not_formed("LagrangesMethod", "method.form_lagranges_equations()")
    if method.bodies and method.inertial is None:
        raise InputError("from_sympy", [Fault("LagrangesMethod", "bodies without an inertial frame", "the frame that they move in",
                                              "LagrangesMethod(..., bodies=bodies, frame=N).")])  # fmt: skip
    q, n = tuple(method.q), len(method.q)
    u = tuple(each.diff(TIME) for each in q)
    (lagrangian,) = method._L
    holonomic = tuple(method._hol_coneqs)
    force = tuple(method._term4)
    return Reading(
        method.inertial, origin, q, u, dict(zip(q, u, strict=True)), tuple(method.bodies or ()),
        tuple(method.forcelist or ()), method._m_d, tuple(force[i] - method._f_d[i] for i in range(n)), force,
        -lagrangian.xreplace(dict.fromkeys(u, sp.S.Zero)), sp.S.Zero,
        holonomic, tuple(method.coneqs)[len(holonomic):], lagrangian=lagrangian,
    )  # fmt: skip


def _of_equations(equations: Any) -> Reading:
    """Reading of equations alone, as `to_sympy` and the file that it writes have them."""
    still = dict.fromkeys(equations.specified, sp.S.Zero)
    alone = [f.xreplace(still) for f in equations.forcing]
    force = tuple(f - rest if f != rest else sp.S.Zero for f, rest in zip(equations.forcing, alone, strict=True))
    return Reading(
        None, None, tuple(equations.q), tuple(equations.u), dict(zip(equations.q, equations.kinematics.values(), strict=True)), (), (),
        equations.mass_matrix, tuple(-rest for rest in alone), force, None, sp.S.Zero, tuple(equations.holonomic_constraints),
        tuple(equations.nonholonomic_constraints), alone=True,
    )  # fmt: skip


def _refuse_auxiliary(kind: str, speeds: Any) -> None:
    if speeds:
        actual = f"auxiliary speeds {', '.join(map(str, speeds))}"
        raise InputError("from_sympy", [Fault(kind, actual, "none: forces of constraints are histories here",
                                              "Omit them, and the loads that they are for.")])  # fmt: skip


def _not_formed(kind: str, how: str) -> InputError:
    return InputError("from_sympy", [Fault(kind, "no equations", "equations that are formed", f"Call {how} first.")])


def mass_centre(body: Any) -> tuple[Any, Any]:
    """Mass centre of a body of SymPy, and its frame: None of a particle."""
    return (body.point, None) if isinstance(body, Particle) else (body.masscenter, body.frame)


def points_of(reading: Reading) -> dict[str, Any]:
    """Points by name that are connected to the origin, the bodies or the loads."""
    starts = [reading.origin, *(mass_centre(body)[0] for body in reading.bodies), *(load[0] for load in reading.loads)]
    return {point.name: point for point in connected([p for p in starts if hasattr(p, "_pos_dict")], "_pos_dict")}


def frames_of(reading: Reading) -> dict[str, Any]:
    """Frames by name that are connected to the inertial one."""
    return {frame.name: frame for frame in connected([reading.frame] if reading.frame else [], "_dcm_dict")}


def connected(starts: list[Any], neighbours: str) -> dict[Any, Any]:
    """Everything that is connected to some nodes, nearest first, with the node that it was reached from."""
    reached = dict.fromkeys(starts)
    pending = list(reached)
    while pending:
        node = pending.pop(0)
        for other in getattr(node, neighbours):
            if other not in reached:
                reached[other] = node
                pending.append(other)
    return reached
