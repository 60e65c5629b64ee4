"""Velocities of SymPy models that contradict their positions and axes, by the angular velocities that textbooks have."""

import pytest
import sympy as sp
import sympy.physics.mechanics as me
import sympy_models as models

from hertzwerk.derive import InputError, Parameter, Scales, Start, T, from_sympy
from hertzwerk.derive.exchange.user_files.audit_files import audit_path
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model

UNITS = {"m": "kg", "l": "m", "r": "m", "J": "kg m^2", "g": "m/s^2", "k": "N/m"}
VALUES = {"m": 0.7, "l": 0.4, "r": 0.25, "J": 0.02, "g": 9.81, "k": 300}
m, l, r, J, g, k = map(sp.Symbol, VALUES)


def taken(kane, origin, units, names="m l g", **given):
    """A model with values for the constants of these names."""
    values = {name: VALUES[name] for name in names.split()}
    return from_sympy(kane, units=UNITS | units, parameters=values, origin=origin, **given)


def refused(*given, **named):
    """What is refused, by place: as it was set, and what follows."""
    with pytest.raises(InputError) as caught:
        taken(*given, **named)
    return {fault.where: (fault.found, fault.expected) for fault in caught.value.faults}


def test_a_contradiction_that_is_taken_as_given_is_named_wherever_the_model_goes():
    method, at, units, values = models.pendulum()
    A, N = at["A"], method._inertial
    A.set_ang_vel(N, -A.ang_vel_in(N))
    model = from_sympy(method, units=units, parameters=values, origin=at["O"], kinematics="as given")
    length = model.parameters["l"]
    scales = Scales(length=length, speed=Parameter("pace", "m/s", 1), arm=length)
    loaded = engine_model(model.scene(scales=scales, start=Start(position={"q": Parameter("q0", "rad", 0.5)})))
    ((where, was_set, follows),) = loaded.module.CONTRADICTIONS
    assert where == "angular velocity of A in N"
    assert (was_set[:9], follows[:7]) == ("- u(t)*N.", "u(t)*N.")
    assert "AGAINST ITS OWN POSITIONS: angular velocity of A in N" in loaded.module.__doc__
    assert any(where in warning and "as given" in warning for warning in simulate(loaded, duration=0.01).warnings)
    sound, at, units, values = models.pendulum()
    model = from_sympy(sound, units=units, parameters=values, origin=at["O"], kinematics="as given")
    assert engine_model(model.scene(scales=scales)).module.CONTRADICTIONS == ()
    with pytest.raises(InputError, match="as given"):
        from_sympy(sound, units=units, parameters=values, kinematics="unchecked")


FILE = """
import sympy as sp
import sympy.physics.mechanics as me
from hertzwerk.derive import Parameter, Scales, from_sympy

m, l = sp.symbols("m l")
q, u = me.dynamicsymbols("q u")
N, O = me.ReferenceFrame("N"), me.Point("O")
A = N.orientnew("A", "Axis", (q, N.z))
O.set_vel(N, 0)
P = O.locatenew("P", -l * A.y)
P.set_vel(N, -l * u * A.x)
kane = me.KanesMethod(N, [q], [u], kd_eqs=[q.diff() - u])
kane.kanes_equations([me.Particle("bob", P, m)])
model = from_sympy(kane, units={m: "kg", l: "m", q: "rad"}, parameters={m: 1, l: 0.5}, origin=O, KINEMATICS)
scene = model.scene(scales=Scales(length=model.parameters["l"], speed=Parameter("pace", "m/s", 1), arm=model.parameters["l"]))
"""


def test_an_audit_of_a_file_finds_them(tmp_path):
    file = tmp_path / "bob.py"
    file.write_text(FILE.replace("KINEMATICS", ""))
    with pytest.raises(
        InputError,
        match=r"bob.py, line 15.*\n  velocity of P in N: found - l\*u\(t\)\*A.x,.*expected l\*u\(t\)\*A.x,",
    ):
        audit_path(file)
    file.write_text(FILE.replace("KINEMATICS", 'kinematics="as given"'))
    (actual,) = [finding for finding in audit_path(file) if not finding.sound]
    assert (actual.quantity, actual.verdict, actual.kind) == ("velocity of P in N", "unchecked", "kinematics")
    assert "found - l*u(t)*A.x, as it was set, expected l*u(t)*A.x, the derivative of its position" in str(actual)


# -- ten models, each sound, and with one fault -----------------------------------------------------------------------


def kane(frame, q, u, rates, bodies, loads=(), **constraints):
    method = me.KanesMethod(frame, q, u, kd_eqs=rates, **constraints)
    method.kanes_equations(bodies, list(loads) or None)
    return method


def arm_with_a_slider(wrong):
    """A bead on a turning arm by the theory of one point; its own motion along the arm is forgotten."""
    q, s, u, v = me.dynamicsymbols("q s u v")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    A = N.orientnew("A", "Axis", (q, N.z))
    A.set_ang_vel(N, u * N.z)
    O.set_vel(N, 0)
    P = O.locatenew("P", s * A.x)
    P.set_vel(A, 0 if wrong else v * A.x)
    P.v1pt_theory(O, N, A)
    return (
        kane(N, [q, s], [u, v], [q.diff() - u, s.diff() - v], [me.Particle("bead", P, m)]),
        O,
        {q: "rad", s: "m"},
        "m",
    )


def two_links(wrong):
    """A double pendulum whose second bob is fixed in the first link instead of the second."""
    q, u = me.dynamicsymbols("q:2"), me.dynamicsymbols("u:2")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    A, B = (N.orientnew(name, "Axis", (angle, N.z)) for name, angle in zip("AB", q, strict=True))
    for link, rate in zip((A, B), u, strict=True):
        link.set_ang_vel(N, rate * N.z)
    O.set_vel(N, 0)
    P = O.locatenew("P", -l * A.y)
    P.v2pt_theory(O, N, A)
    R = P.locatenew("R", -l * B.y)
    R.v2pt_theory(P, N, A if wrong else B)
    S = R.locatenew("S", -l * B.y)  # what is beyond only inherits it
    S.v2pt_theory(R, N, B)
    bobs = [me.Particle(point.name, point, m) for point in (P, R, S)]
    return kane(N, q, u, [a.diff() - b for a, b in zip(q, u, strict=True)], bobs), O, dict.fromkeys(q, "rad"), "m l"


def body_in_space(wrong):
    """A body that turns about x, then about its own y; with the angular velocity of the other order."""
    (a, b), (p, s) = me.dynamicsymbols("a b"), me.dynamicsymbols("p s")
    N, C = me.ReferenceFrame("N"), me.Point("C")
    C.set_vel(N, 0)
    B = N.orientnew("B", "Body", [a, b, 0], "XYZ")
    other = p * B.x + s * (sp.cos(a) * B.y - sp.sin(a) * B.z)
    B.set_ang_vel(N, other if wrong else p * (sp.cos(b) * B.x + sp.sin(b) * B.z) + s * B.y)
    body = me.RigidBody("body", C, B, m, (me.inertia(B, J, 2 * J, 1.5 * J), C))
    return kane(N, [a, b], [p, s], [a.diff() - p, b.diff() - s], [body]), C, {a: "rad", b: "rad"}, "m J"


def satellite(wrong):
    """A body of four Euler parameters whose speeds are along its own axes; they are set along the ground's."""
    q, u = me.dynamicsymbols("e:4"), me.dynamicsymbols("w:3")
    N, C = me.ReferenceFrame("N"), me.Point("C")
    C.set_vel(N, 0)
    B = N.orientnew("B", "Quaternion", q)
    e0, e1, e2, e3 = q
    x, y, z = u
    B.set_ang_vel(N, x * N.x + y * N.y + z * N.z if wrong else x * B.x + y * B.y + z * B.z)
    rates = (-e1 * x - e2 * y - e3 * z, e0 * x + e2 * z - e3 * y, e0 * y + e3 * x - e1 * z, e0 * z + e1 * y - e2 * x)
    body = me.RigidBody("body", C, B, m, (me.inertia(B, J, 2 * J, 1.5 * J), C))
    equations = [2 * e.diff() - rate for e, rate in zip(q, rates, strict=True)]
    return kane(N, q, u, equations, [body]), C, dict.fromkeys(q, "rad") | dict.fromkeys(u, "rad/s"), "m J"


def disc(wrong):
    """A rolling disc of three angles that spins against its kinematical equation."""
    q, u = me.dynamicsymbols("q1:4"), me.dynamicsymbols("u1:4")
    N = me.ReferenceFrame("N")
    Y = N.orientnew("Y", "Axis", [q[0], N.z])
    L = Y.orientnew("L", "Axis", [q[1], Y.x])
    R = L.orientnew("R", "Axis", [q[2], L.y])
    turning = R.ang_vel_in(N)
    R.set_ang_vel(N, u[0] * L.x + u[1] * L.y + u[2] * L.z)
    C, D = me.Point("C"), me.Point("D")
    C.set_vel(N, 0)
    D.set_pos(C, r * L.z)
    D.v2pt_theory(C, N, R)
    body = me.RigidBody("disc", D, R, m, (me.inertia(L, J, 2 * J, J), D))
    rates = [(turning - R.ang_vel_in(N)).dot(axis) for axis in L]
    if wrong:
        rates[1] = turning.dot(L.y) + u[1]
    return kane(N, q, u, rates, [body]), None, dict.fromkeys(q, "rad") | dict.fromkeys(u, "rad/s"), "m r J"


def shaken(wrong):
    """A pendulum on a pivot that follows a function of time, whose velocity has the wrong sign; the bob inherits it."""
    q, u, y = me.dynamicsymbols("q u y")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    A = N.orientnew("A", "Axis", (q, N.z))
    O.set_vel(N, 0)
    V = O.locatenew("V", y * N.y)
    V.set_vel(N, (-1 if wrong else 1) * y.diff() * N.y)
    P = V.locatenew("P", -l * A.y)
    P.v2pt_theory(V, N, A)
    return kane(N, [q], [u], [q.diff() - u], [me.Particle("bob", P, m)]), O, {q: "rad", y: "m"}, "m l"


def rolling(wrong):
    """A wheel that rolls in a plane: its hub's velocity by its spin, as the constraint alone has it; with a wrong sign."""
    x, q, v, u = me.dynamicsymbols("x q v u")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    W = N.orientnew("W", "Axis", (q, N.z))
    W.set_ang_vel(N, u * N.z)
    O.set_vel(N, 0)
    H = O.locatenew("H", x * N.x + r * N.y)
    H.set_vel(N, (r if wrong else -r) * u * N.x)
    G = H.locatenew("G", -r * N.y)  # the wheel's point on the ground is at rest there, and moves along in position
    G.set_vel(N, H.vel(N) + r * u * N.x)
    wheel = me.RigidBody("wheel", H, W, m, (me.inertia(W, J, J, 2 * J), H))
    slip = {"u_dependent": [v], "velocity_constraints": [v + r * u]}
    made = kane(N, [x, q], [u], [x.diff() - v, q.diff() - u], [wheel], [(G, m * g * N.x)], **slip)
    return made, O, {x: "m", q: "rad", v: "m/s", u: "rad/s"}, "m r g J"


def bar_in_a_circle(wrong):
    """A bead whose two coordinates a circle holds; its velocity is written with the radius, as the circle alone has it."""
    x, y, v, w = me.dynamicsymbols("x y v w")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, 0)
    P = O.locatenew("P", x * N.x + y * N.y)
    P.set_vel(N, v * (x**2 + y**2) / l**2 * N.x + (w if wrong else -v * x / y) * N.y * (2 if wrong else 1))
    held = {
        "q_dependent": [y], "u_dependent": [w], "configuration_constraints": [x**2 + y**2 - l**2],
        "velocity_constraints": [x * v + y * w],
    }  # fmt: skip
    made = kane(N, [x], [v], [x.diff() - v, y.diff() - w], [me.Particle("bead", P, m)], **held)
    return made, O, {x: "m", y: "m"}, "m l"


def cart(wrong):
    """Lagrange's equations of a cart on whose track the origin itself is said to move."""
    x = me.dynamicsymbols("x")
    N, O = me.ReferenceFrame("N"), me.Point("O")
    O.set_vel(N, x.diff() * N.x if wrong else 0)
    P = O.locatenew("P", x * N.x)
    P.set_vel(N, O.vel(N) + x.diff() * N.x)
    body = me.Particle("cart", P, m)
    method = me.LagrangesMethod(m * x.diff() ** 2 / 2 - k * x**2 / 2, [x], bodies=[body], frame=N)
    method.form_lagranges_equations()
    return method, O, {x: "m"}, "m k"


def chain_by_joints(wrong):
    """A System of two pin joints, one of whose frames is set to turn against its joint."""
    ground, *links = (me.RigidBody(name, frame=me.ReferenceFrame(name), mass=m) for name in "NAB")
    for body in (ground, *links):
        body.inertia = (me.inertia(body.frame, J, J, J), body.masscenter)
    system = me.System.from_newtonian(ground)
    for i, (one, other) in enumerate(((ground, links[0]), (links[0], links[1]))):
        joint = me.PinJoint(
            f"joint{i}", one, other, *me.dynamicsymbols(f"q{i} u{i}"), child_point=l * other.frame.y,
            joint_axis=one.frame.z,
        )  # fmt: skip
        system.add_joints(joint)
    if wrong:
        links[1].frame.set_ang_vel(links[0].frame, -links[1].frame.ang_vel_in(links[0].frame))
    return system, None, dict.fromkeys(("q0", "q1"), "rad"), "m l J"


PLANTED = {
    arm_with_a_slider: "velocity of P in N", two_links: "velocity of R in N",
    body_in_space: "angular velocity of B in N", satellite: "angular velocity of B in N",
    disc: "angular velocity of R in N", shaken: "velocity of V in N", rolling: "velocity of H in N",
    bar_in_a_circle: "velocity of P in N", cart: "velocity of O in N", chain_by_joints: "angular velocity of B in A",
}  # fmt: skip


@pytest.mark.parametrize("model", PLANTED, ids=lambda model: model.__name__)
def test_one_wrong_sign_or_order_is_named_where_it_begins(model):
    method, origin, units, names = model(wrong=False)
    options = {"specified": {"y": sp.sin(T)}} if model is shaken else {}
    assert taken(method, origin, {**units}, names, **options).bodies
    method, origin, units, names = model(wrong=True)
    assert list(refused(method, origin, {**units}, names, **options)) == [PLANTED[model]]
