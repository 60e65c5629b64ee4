"""Derivation of the slider-crank beside sympy.physics.mechanics on the same mechanism (issue 2, "Speed")."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import sympy as sp
import sympy.physics.mechanics as me
from benchmarks.ratios import Ratio, medians, timed


def derivation() -> Iterator[Ratio]:
    """Scene file to module text, audit included, against KanesMethod and cse; SymPy's cache emptied before each."""
    import importlib.util
    import runpy

    from sympy.core.cache import clear_cache

    from hertzwerk.derive.equations.derivation import generate

    spec = importlib.util.find_spec("hertzwerk.derive.scenes.slider_crank")
    assert spec is not None and spec.origin is not None
    origin = spec.origin

    def ours() -> None:
        clear_cache()
        generate(runpy.run_path(origin)["scene"], "slider_crank")

    def theirs() -> None:
        clear_cache()
        kane_slider_crank()

    ours(), theirs()
    mine, peer = medians(timed(ours), timed(theirs))
    yield Ratio("derive slider_crank / sympy.physics.mechanics + cse", mine, peer, "<= 1")


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
