"""What hertzwerk is measured against in Python: SciPy's integrators on the same functions, SymPy's mechanics on the same mechanism."""

from __future__ import annotations

from typing import Any

import casadi as ca
import numpy as np
import sympy as sp
import sympy.physics.mechanics as me
from scipy.integrate import solve_ivp


class Buffered:
    """f(t, y) of a CasADi function of (t, y, v0), called through its buffer: no conversion to DM. v0 is shared, by reference."""

    def __init__(self, function: Any, v0: np.ndarray, *, compiled: bool) -> None:
        if compiled:
            from hertzwerk.runtime.engine.integration.loop.c_compilation import Program

            (function,) = Program(function).load()
        buffer, self.evaluate = function.buffer()
        self.buffer = buffer  # keeps the function alive
        self.t, self.y, self.result = np.zeros(1), np.zeros(function.size1_in(1)), np.zeros(function.size1_out(0))
        for i, array in enumerate((self.t, self.y, v0)):
            buffer.set_arg(i, memoryview(array))
        buffer.set_res(0, memoryview(self.result))

    def __call__(self, t: float, y: np.ndarray) -> np.ndarray:
        self.t[0] = t
        self.y[:] = y
        self.evaluate()
        return self.result.copy()


class SolveIvp:
    """solve_ivp on the generated functions of a one-pair model without ledger, in CasADi's virtual machine or as C, restarted at its events."""

    def __init__(self, model: Any, method: str = "LSODA", *, compiled: bool = False) -> None:
        self.method = method
        module, bound = model.module, model.bind({})
        c, p, nq = ca.DM(bound.c), ca.DM(bound.p), model.nq
        self.start = np.array(ca.vertcat(*module.start(p))).ravel()
        self.scale = np.array(ca.vertcat(*module.scales(p)[:2])).ravel()
        self.floor = bound["approach_floor"]
        self.v0 = np.zeros(1)

        t, y, v0 = ca.SX.sym("t"), ca.SX.sym("y", len(self.start)), ca.SX.sym("v0")
        q, u = y[:nq], y[nq:]
        (pair,) = (name for name, _ in module.PAIRS)
        z = ca.SX.zeros(len(module.MEMORY))
        push, *_ = getattr(module, f"contact_{pair}")(t, q, u, z, v0, c)
        applied = module.applied(t, q, u, c)
        gap, gap_rate = module.gaps(t, q, u, c)

        def function(result: Any) -> Buffered:
            return Buffered(ca.Function("f", [t, y, v0], [result], {"cse": True}), self.v0, compiled=compiled)

        def rates(force: Any) -> Buffered:
            return function(ca.vertcat(module.coordinate_rates(t, q, u, c), module.accelerations(t, q, u, force, c)[0]))

        self.flight, self.contact = rates(applied), rates(applied + push)
        self.gap, self.gap_rate = function(gap), function(gap_rate)

    def __call__(self, duration: float, tolerance: float) -> np.ndarray:
        """State at the end; absolute tolerances are `tolerance` in the scene's scales."""
        t, y, touching = 0.0, self.start, False

        def gap(t: float, y: np.ndarray) -> float:
            return float(self.gap(t, y)[0])

        gap.terminal = True
        options = {
            "rtol": max(1e-3 * tolerance, 3e-14),
            "atol": tolerance * self.scale,
            "method": self.method,
            "events": gap,
        }
        while t < duration:
            gap.direction = 1 if touching else -1
            first = min(1e-7, duration - t)  # off the surface, or a return within one step has no change of sign
            run = solve_ivp(self.contact if touching else self.flight, (t, duration), y, first_step=first, **options)
            t, y = float(run.t[-1]), run.y[:, -1]
            if run.status < 0:
                raise ArithmeticError(run.message)
            if run.status == 1:
                touching = not touching
                self.v0[0] = max(-float(self.gap_rate(t, y)[0]), self.floor)
        return y


def kane_slider_crank() -> tuple[Any, Any]:
    """The slider-crank with clearance and friction through sympy.physics.mechanics: KanesMethod, then cse.

    Returns the replacements and the reduced mass matrix and forcing. Less than hertzwerk derives: no gap functions, energy,
    drive torque, poses or audit.
    """
    r, l, s, w, g, c, R_pin = sp.symbols("r l s w g c R_pin", positive=True)
    m_crank, J_crank, m_rod, J_rod, m_slider = sp.symbols("m_crank J_crank m_rod J_rod m_slider", positive=True)
    bush, E, nu, e, v0, mu, v_s = sp.symbols("R_bush E nu e v0 mu v_s", positive=True)
    t = me.dynamicsymbols._t
    angle, travel, spin, speed = me.dynamicsymbols("angle travel spin speed")

    ground = me.ReferenceFrame("N")
    crank_frame = ground.orientnew("C", "Axis", (w * t, ground.z))
    rod_frame = crank_frame.orientnew("R", "Axis", (angle, crank_frame.z))
    crank_frame.set_ang_vel(ground, w * ground.z)
    rod_frame.set_ang_vel(crank_frame, spin * ground.z)

    origin = me.Point("O")
    origin.set_vel(ground, 0)
    crank_pin = origin.locatenew("A", r * crank_frame.x)
    crank_pin.v2pt_theory(origin, ground, crank_frame)
    rod_centre = crank_pin.locatenew("G", s * rod_frame.x)
    rod_centre.v2pt_theory(crank_pin, ground, rod_frame)
    pin = crank_pin.locatenew("P", l * rod_frame.x)
    pin.v2pt_theory(crank_pin, ground, rod_frame)
    bush_centre = origin.locatenew("B", travel * ground.x)
    bush_centre.set_vel(ground, speed * ground.x)

    apart = pin.pos_from(bush_centre).express(ground)
    eccentricity = apart.magnitude()
    normal = apart / eccentricity
    tangent = ground.z.cross(normal)
    contact = pin.locatenew("K", R_pin * normal)
    contact.set_vel(ground, pin.vel(ground) + rod_frame.ang_vel_in(ground).cross(R_pin * normal))
    bush_point = bush_centre.locatenew("Q", bush * normal)
    bush_point.set_vel(ground, bush_centre.vel(ground))
    sliding = contact.vel(ground) - bush_point.vel(ground)
    penetration, rate = eccentricity - c, sliding.dot(normal)
    stiffness = sp.Rational(4, 3) * E / (2 * (1 - nu**2)) * sp.sqrt(bush * R_pin / c)
    force = stiffness * penetration ** sp.Rational(3, 2) * (1 + 3 * (1 - e**2) / 4 * rate / v0)
    friction = mu * force * sp.tanh(sliding.dot(tangent) / v_s)
    push = -force * normal - friction * tangent

    crank = me.RigidBody("crank", origin, crank_frame, m_crank, (J_crank * me.outer(ground.z, ground.z), origin))
    rod = me.RigidBody("rod", rod_centre, rod_frame, m_rod, (J_rod * me.outer(ground.z, ground.z), rod_centre))
    slider = me.Particle("slider", bush_centre, m_slider)
    kane = me.KanesMethod(ground, [angle, travel], [spin, speed], kd_eqs=[spin - angle.diff(t), speed - travel.diff(t)])
    kane.kanes_equations(
        [crank, rod, slider],
        [
            (rod_centre, -m_rod * g * ground.y),
            (bush_centre, -m_slider * g * ground.y),
            (contact, push),
            (bush_point, -push),
        ],
    )
    return sp.cse([kane.mass_matrix, kane.forcing])
