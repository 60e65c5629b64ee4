"""Models of SymPy's mechanics, written from the literature as their users write them."""

from typing import Any

import sympy as sp
import sympy.physics.mechanics as me

g = sp.Symbol("g")


def pendulum(arm: Any = None, extra: Any = 0) -> tuple[Any, Any, dict[Any, str], dict[Any, float]]:
    """A bob at the end of a string by Kane's method, its speed u = dq/dt: method, points, units, values."""
    m, length = sp.symbols("m l")
    q, u = me.dynamicsymbols("q u")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    A = N.orientnew("A", "Axis", (q, N.z))
    A.set_ang_vel(N, u * N.z)
    O.set_vel(N, 0)
    P = O.locatenew("P", -length * A.y if arm is None else arm(A, q, length))
    P.v2pt_theory(O, N, A)
    bob = me.Particle("bob", P, m)
    method = me.KanesMethod(N, [q], [u], kd_eqs=[q.diff() - u])
    method.kanes_equations([bob], [(P, -m * g * N.y + extra * N.x)])
    units, values = {m: "kg", length: "m", g: "m/s^2", q: "rad"}, {m: 1, length: 0.5, g: 9.81}
    return method, {"O": O, "P": P, "A": A}, units, values


def rolling_disc() -> tuple[Any, dict[Any, str], dict[Any, float]]:
    """A thin disc that rolls: yaw, lean and spin, speeds along the axes of the lean; nothing but velocities."""
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    r, m = sp.symbols("r m")
    N = me.ReferenceFrame("N")
    Y = N.orientnew("Y", "Axis", [q[0], N.z])
    L = Y.orientnew("L", "Axis", [q[1], Y.x])
    R = L.orientnew("R", "Axis", [q[2], L.y])
    turning = R.ang_vel_in(N)
    R.set_ang_vel(N, u[0] * L.x + u[1] * L.y + u[2] * L.z)
    C = me.Point("C")
    C.set_vel(N, 0)
    D = C.locatenew("D", r * L.z)
    D.v2pt_theory(C, N, R)
    disc = me.RigidBody("disc", D, R, m, (me.inertia(L, m * r**2 / 4, m * r**2 / 2, m * r**2 / 4), D))
    method = me.KanesMethod(N, q, u, kd_eqs=[(turning - R.ang_vel_in(N)).dot(axis) for axis in L])
    method.kanes_equations([disc], [(D, -m * g * N.z)])
    units = {r: "m", m: "kg", g: "m/s^2"} | dict.fromkeys(q, "rad") | dict.fromkeys(u, "rad/s")
    return method, units, {r: 0.3, m: 2, g: 9.81}


def cart(n: int) -> tuple[Any, Any, dict[Any, str], dict[Any, float]]:
    """n pendulums one below the other on a cart that a force pushes, all by Kane's method; angles to the vertical."""
    q, u = me.dynamicsymbols(f"q0:{n + 1}"), me.dynamicsymbols(f"u0:{n + 1}")
    push, m, length = me.dynamicsymbols("push"), sp.symbols(f"m0:{n + 1}"), sp.symbols(f"l1:{n + 1}")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    at = O.locatenew("P0", q[0] * N.x)
    at.set_vel(N, u[0] * N.x)
    bodies, loads = [me.Particle("cart", at, m[0])], [(at, push * N.x)]
    for i in range(n):
        A = N.orientnew(f"A{i + 1}", "Axis", (q[i + 1], N.z))
        A.set_ang_vel(N, u[i + 1] * N.z)
        below = at.locatenew(f"P{i + 1}", -length[i] * A.y)
        below.v2pt_theory(at, N, A)
        bodies.append(me.Particle(f"bob_{i + 1}", below, m[i + 1]))
        loads.append((below, -m[i + 1] * g * N.y))
        at = below
    method = me.KanesMethod(N, q, u, kd_eqs=[a.diff() - b for a, b in zip(q, u, strict=True)])
    method.kanes_equations(bodies, loads)
    units = (
        {g: "m/s^2", q[0]: "m", push: "N"}
        | dict.fromkeys(m, "kg")
        | dict.fromkeys(length, "m")
        | dict.fromkeys(q[1:], "rad")
    )
    values = {g: 9.81} | {s: 1 + 0.1 * i for i, s in enumerate(m)} | {s: 0.5 - 0.05 * i for i, s in enumerate(length)}
    return method, O, units, values


def rattleback() -> tuple[Any, dict[Any, str], dict[Any, float]]:
    """Ellipsoid that rolls on a plane: Kane, Levinson, Int. J. Non-Linear Mech. 17 (1982) 175, and their numbers."""
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    a, b, c, h, m = axes_and_mass = sp.symbols("a b c h m")
    moments = sp.symbols("A B C D")
    N = me.ReferenceFrame("N")
    R = N.orientnew("R", "Body", q, "ZXY")
    turning = R.ang_vel_in(N)
    R.set_ang_vel(N, u[0] * R.x + u[1] * R.y + u[2] * R.z)
    mu = [N.z.dot(axis) for axis in R]  # the way up
    size = sp.sqrt(sum((s * k) ** 2 for s, k in zip((a, b, c), mu, strict=True)))
    P = me.Point("P")
    P.set_vel(N, 0)
    middle = P.locatenew(
        "middle", sum((s**2 * k / size * axis for s, k, axis in zip((a, b, c), mu, R, strict=True)), start=0 * R.x)
    )
    centre = middle.locatenew("centre", -h * R.z)
    centre.set_vel(N, R.ang_vel_in(N).cross(centre.pos_from(P)))
    body = me.RigidBody("stone", centre, R, m, (me.inertia(R, *moments[:3], moments[3]), centre))
    method = me.KanesMethod(N, q, u, kd_eqs=[(turning - R.ang_vel_in(N)).dot(axis) for axis in R])
    method.kanes_equations([body], [(centre, -m * g * N.z)])
    units = dict.fromkeys((a, b, c, h), "m") | {m: "kg", g: "m/s^2"} | dict.fromkeys(moments, "kg m^2")
    units |= dict.fromkeys(q, "rad") | dict.fromkeys(u, "rad/s")
    numbers = dict(
        zip((*axes_and_mass, *moments), (0.2, 0.03, 0.02, 0.01, 1, 2e-4, 1.6e-3, 1.7e-3, -2e-5), strict=True)
    )
    return method, units, {**numbers, g: 9.81}


def skate() -> tuple[Any, dict[Any, str], dict[Any, float]]:
    """A skate on a slope by Lagrange's equations, with a constraint on speeds, and a bob on a circle beside it, with one on coordinates."""
    q = x, y, turn, a, b = me.dynamicsymbols("x y turn a b")
    m, J, slope, length = sp.symbols("m J slope l")
    t = me.dynamicsymbols._t
    kinetic = m * (x.diff(t) ** 2 + y.diff(t) ** 2 + a.diff(t) ** 2 + b.diff(t) ** 2) / 2 + J * turn.diff(t) ** 2 / 2
    lagrangian = kinetic + m * g * sp.sin(slope) * x - m * g * b
    edge = x.diff(t) * sp.sin(turn) - y.diff(t) * sp.cos(turn)
    method = me.LagrangesMethod(lagrangian, list(q), hol_coneqs=[a**2 + b**2 - length**2], nonhol_coneqs=[edge])
    method.form_lagranges_equations()
    units = {m: "kg", J: "kg m^2", slope: "rad", length: "m", g: "m/s^2", turn: "rad"} | dict.fromkeys(
        (x, y, a, b), "m"
    )
    return method, units, {m: 2, J: 0.1, slope: 0.3, length: 0.5, g: 9.81}
