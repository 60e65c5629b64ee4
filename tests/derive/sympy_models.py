"""Models of SymPy's mechanics, written from the literature as their users write them."""

from typing import Any

import sympy as sp
from sympy.physics.mechanics import KanesMethod, Particle, Point, ReferenceFrame, RigidBody, dynamicsymbols, inertia

g = sp.Symbol("g")


def pendulum(arm: Any = None, extra: Any = 0) -> tuple[Any, Any, dict[Any, str], dict[Any, float]]:
    """A bob at the end of a string by Kane's method, its speed u = dq/dt: method, points, units, values."""
    m, length = sp.symbols("m l")
    q, u = dynamicsymbols("q u")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (q, N.z))
    A.set_ang_vel(N, u * N.z)
    O.set_vel(N, 0)
    P = O.locatenew("P", -length * A.y if arm is None else arm(A, q, length))
    P.v2pt_theory(O, N, A)
    bob = Particle("bob", P, m)
    method = KanesMethod(N, [q], [u], kd_eqs=[q.diff() - u])
    method.kanes_equations([bob], [(P, -m * g * N.y + extra * N.x)])
    units, values = {m: "kg", length: "m", g: "m/s^2", q: "rad"}, {m: 1, length: 0.5, g: 9.81}
    return method, {"O": O, "P": P, "A": A}, units, values


def rolling_disc() -> tuple[Any, dict[Any, str], dict[Any, float]]:
    """A thin disc that rolls: yaw, lean and spin, speeds along the axes of the lean; nothing but velocities."""
    q, u = dynamicsymbols("q1:4"), dynamicsymbols("u1:4")
    r, m = sp.symbols("r m")
    N = ReferenceFrame("N")
    Y = N.orientnew("Y", "Axis", [q[0], N.z])
    L = Y.orientnew("L", "Axis", [q[1], Y.x])
    R = L.orientnew("R", "Axis", [q[2], L.y])
    turning = R.ang_vel_in(N)
    R.set_ang_vel(N, u[0] * L.x + u[1] * L.y + u[2] * L.z)
    C = Point("C")
    C.set_vel(N, 0)
    D = C.locatenew("D", r * L.z)
    D.v2pt_theory(C, N, R)
    disc = RigidBody("disc", D, R, m, (inertia(L, m * r**2 / 4, m * r**2 / 2, m * r**2 / 4), D))
    method = KanesMethod(N, q, u, kd_eqs=[(turning - R.ang_vel_in(N)).dot(axis) for axis in L])
    method.kanes_equations([disc], [(D, -m * g * N.z)])
    units = {r: "m", m: "kg", g: "m/s^2"} | dict.fromkeys(q, "rad") | dict.fromkeys(u, "rad/s")
    return method, units, {r: 0.3, m: 2, g: 9.81}
