"""Models of SymPy's mechanics as scenes: against the same scenes declared natively, and against the literature."""

import math

import numpy as np
import pytest
import sympy as sp
import sympy_models as models
from derived import Derived, rate_along
from scipy.integrate import solve_ivp
from sympy.physics.mechanics import KanesMethod, Particle, Point, ReferenceFrame, RigidBody, dynamicsymbols, inertia

import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate


def struck(sphere, l):
    """Pair and effects of a bob that strikes a wall, scales and start, for a point of any mechanism."""
    radius, wall = hd.Parameter("radius", "mm", 20), hd.GROUND.at(-hd.Parameter("radius", "mm", 20), 0, 0)
    stiffness, restitution = hd.Parameter("K", "N/m^1.5", 1e8), hd.Parameter("e", "1", 0.7)
    pair = hd.SphereOnPlane("wall", sphere=sphere, radius=radius, plane=wall, normal=hd.X)
    effects = hd.Contact("wall", hd.laws.power(stiffness, 1.5), hd.laws.flores(e=restitution)), hd.EnergyLedger()
    return (
        pair, effects, hd.Scales(length=radius, speed=hd.Parameter("pace", "m/s", 1), arm=l),
        hd.Start(position={"q": hd.Parameter("q0", "rad", 0.5)}),
    )  # fmt: skip


def test_a_pendulum_strikes_a_wall_as_the_native_one_does():
    method, at, units, values = models.pendulum()
    model = hd.from_sympy(method, units=units, parameters=values, origin=at["O"], name="imported_pendulum")
    pair, effects, scales, start = struck(model.at("P"), model.parameters["l"])
    run = simulate(
        load(model.scene(pairs=(pair,), effects=effects, scales=scales, start=start)), duration="2 s", accuracy=1e-8
    )
    l = hd.Parameter("l", "m", 0.5)
    bob = hd.Body("bob", hd.Parameter("m", "kg", 1))
    pair, effects, scales, start = struck(bob.at(0, 0, 0), l)
    native = hd.Scene(
        hd.Mechanism("native_pendulum", (hd.Revolute("q", hd.GROUND, bob.at(0, l, 0), axis=hd.Z),), pairs=(pair,)),
        (hd.Gravity("gravity", hd.Parameter("g", "m/s^2", 9.81), direction=-hd.Y), *effects), scales, start,
    )  # fmt: skip
    other = simulate(load(native), duration="2 s", accuracy=1e-8)
    assert len(run.impacts) == len(other.impacts) == 3
    assert [i.t for i in run.impacts] == pytest.approx([i.t for i in other.impacts], abs=1e-9)
    assert [i.peak_force for i in run.impacts] == pytest.approx([i.peak_force for i in other.impacts], rel=1e-8)
    assert run["q.angle"][-1] == pytest.approx(other["q.angle"][-1], abs=1e-8)
    assert run["energy"][-1] + run["wall.dissipated"][-1] - run["loads.input"][-1] == pytest.approx(
        run["energy"][0], abs=1e-9
    )


def test_a_disc_that_rolls_upright_wobbles_at_the_frequency_of_theory():
    # thin disc, spin W, small lean x: 5/4 x'' = g/r x - 3/2 W y', 1/4 y'' = 1/2 W x' for the yaw y (Neimark, Fufaev 1972, chapter 4)
    method, units, values = models.rolling_disc()
    model = hd.from_sympy(method, units=units, parameters=values, name="disc")
    r = model.parameters["r"]
    scene = model.scene(
        effects=(hd.EnergyLedger(),), scales=hd.Scales(length=r, speed=hd.Parameter("pace", "m/s", 1), arm=r),
        start=hd.Start(position={"q2": hd.Parameter("lean", "rad", 1e-5)}, speed={"u2": hd.Parameter("spin", "rad/s", 8)}),
    )  # fmt: skip
    run = simulate(load(scene), duration="1 s", accuracy=1e-12)
    square = 12 / 5 * 8**2 - 4 / 5 * 9.81 / 0.3
    middle = 1e-5 * 12 / 5 * 8**2 / square
    assert run["q2.angle"] == pytest.approx(middle + (1e-5 - middle) * np.cos(math.sqrt(square) * run.t), abs=1e-12)


@pytest.mark.parametrize(
    ("arm", "where", "found"),
    [
        (lambda A, q, l: -A.y, "position of P from O, along A.y", "-1 [1]"),
        (lambda A, q, l: -l * A.y - sp.sin(q) * A.x, "position of P from O, along A.x", "-sin(q(t)) [1]"),
        (lambda A, q, l: -l * (1 + l * sp.cos(q)) * A.y, "position of P from O, along A.y", "l*cos(q(t)) [m], in "),
    ],
)  # fmt: skip
def test_a_length_that_is_forgotten_is_named_in_the_users_own_expression(arm, where, found):
    method, at, units, values = models.pendulum(arm)
    with pytest.raises(hd.InputError) as caught:
        hd.from_sympy(method, units=units, parameters=values, origin=at["O"])
    fault = caught.value.faults[0]
    assert fault.where == where
    assert fault.found.startswith(found)


def test_frames_without_an_orientation_are_named():
    """On the old code SymPy's own ValueError, as of the wheels of its bicycle."""
    q, r, u, w = dynamicsymbols("q r u w")
    N, B, C = map(ReferenceFrame, "NBC")
    O, m, J = Point("O"), *sp.symbols("m J")
    O.set_vel(N, 0)
    P, Q = O.locatenew("P", q * N.x), O.locatenew("Q", q * N.x)
    P.set_vel(N, u * N.x)
    Q.set_vel(N, u * C.x)
    B.set_ang_vel(N, w * B.z)
    spinning = KanesMethod(N, [q, r], [u, w], kd_eqs=[q.diff() - u, r.diff() - w])
    spinning.kanes_equations([RigidBody("wheel", P, B, m, (inertia(B, J, J, J), P))], [])
    units = {m: "kg", J: "kg m^2", q: "m", u: "m/s", r: "rad", w: "rad/s"}
    with pytest.raises(hd.InputError, match=r"frame B: found no orientation in N(.|\n)*B\.orient_axis\(N, N\.z, q\)"):
        hd.from_sympy(spinning, units=units, parameters={m: 1, J: 1}, origin=O)
    sliding = KanesMethod(N, [q], [u], kd_eqs=[q.diff() - u])
    sliding.kanes_equations([Particle("slider", P, m)], [])
    model = hd.from_sympy(sliding, units={m: "kg", q: "m", u: "m/s"}, parameters={m: 1}, origin=O)
    assert model.at(P).body.name == "slider"
    with pytest.raises(hd.InputError, match="frame C: found no orientation in N"):
        model.at(Q)


SCRIPT = """
from sympy.physics.mechanics import KanesMethod, Particle, Point, ReferenceFrame, dynamicsymbols
q, u = dynamicsymbols("q u")
N, O = ReferenceFrame("N"), Point("O")
O.set_vel(N, 0)
P = O.locatenew("P", q * N.x)
P.set_vel(N, u * N.x)
kane = KanesMethod(N, [q], [u], kd_eqs=[q.diff() - u])
kane.kanes_equations([Particle("slider", P, 1)], [])
"""


def test_a_script_of_sympy_that_declares_no_scene_gets_the_line_that_makes_one(tmp_path):
    file = tmp_path / "slider.py"
    file.write_text(SCRIPT)
    for read in (load, hd.audit_path):
        with pytest.raises(hd.InputError, match=r"scene = from_sympy\(kane, units={...}"):
            read(file)
    (tmp_path / "other.py").write_text("from dataclasses import dataclass\nkane = 3\n")
    with pytest.raises(hd.InputError) as caught:
        load(tmp_path / "other.py")
    assert "from_sympy" not in str(caught.value)


def test_every_symbol_without_a_unit_or_a_value_is_reported_at_once():
    wind, k = dynamicsymbols("wind"), sp.Symbol("k")
    method, at, units, values = models.pendulum(extra=wind + k)
    with pytest.raises(hd.InputError) as caught:
        hd.from_sympy(method, units=units, parameters={**values, "m": True, sp.Symbol("drag"): 1}, origin=at["O"])
    reported = {fault.where: fault.found for fault in caught.value.faults}
    assert reported == {
        "symbol m": "value True", "symbol k": "no value", "symbol wind": "no unit", "values, drag": "no such symbol in the model",
        "function wind(t)": "neither a coordinate nor a speed, and not specified",
    }  # fmt: skip
    assert len(caught.value.faults) == 6  # k has no unit either


def test_effects_act_on_coordinates_and_speeds_that_are_no_rates():
    # energy put in and dissipated by effects on q and u of a disc, whose q' = K u
    method, units, values = models.rolling_disc()
    model = hd.from_sympy(method, units=units, parameters=values, name="helped_disc")
    r = model.parameters["r"]
    help_ = (
        hd.JointDamper("damper", "u2", hd.Parameter("c", "N m s", 0.5)), hd.JointSpring("spring", "q2", hd.Parameter("k", "N m", 10)),
        hd.JointForce("steer", "q1", hd.Parameter("M", "N m", 0.2) * hd.coordinate_of("q2")), hd.EnergyLedger(),
    )  # fmt: skip
    scales = hd.Scales(length=r, speed=hd.Parameter("pace", "m/s", 1), arm=r)
    start = hd.Start(position={"q2": hd.Parameter("lean", "rad", 0.1)}, speed={"u2": hd.Parameter("spin", "rad/s", 8)})
    scene = model.scene(effects=help_, scales=scales, start=start)
    run = simulate(load(scene), duration="1 s", accuracy=1e-9)
    balance = run["energy"] + run["damper.dissipated"] - run["loads.input"] - run["steer.input"]
    assert balance == pytest.approx(balance[0], abs=1e-8)
    assert run["damper.dissipated"][-1] > 1
    assert "Energy" in load(scene).equations().markdown()
    with pytest.raises(hd.InputError, match="without joints"):
        load(scene.with_coordinates("absolute"))
    with pytest.raises(hd.InputError, match="whose rate is not a speed"):
        model.scene(effects=(hd.ConstantSpeed("turn", "q1", hd.Parameter("w", "rad/s", 3)),), scales=scales)


def test_a_pivot_that_a_function_of_time_shakes_holds_a_pendulum_upright():
    m, length, g = sp.symbols("m l g")
    q, u, y = dynamicsymbols("q u y")
    N, O = ReferenceFrame("N"), Point("O")
    A = N.orientnew("A", "Axis", (q, N.z))
    A.set_ang_vel(N, u * N.z)
    O.set_vel(N, 0)
    B = O.locatenew("B", y * N.y)
    B.set_vel(N, y.diff() * N.y)
    P = B.locatenew("P", -length * A.y)
    P.v2pt_theory(B, N, A)
    method = KanesMethod(N, [q], [u], kd_eqs=[q.diff() - u])
    method.kanes_equations([Particle("bob", P, m)], [(P, -m * g * N.y)])
    units, values = {m: "kg", length: "m", g: "m/s^2", q: "rad", y: "m"}, {m: 1, length: 0.5, g: 9.81}
    lift = hd.Parameter("lift", "m", 0.02) * sp.cos(hd.Parameter("w", "rad/s", 100) * hd.T)
    model = hd.from_sympy(method, units=units, parameters=values, origin=O, specified={y: lift}, name="shaken")
    l = model.parameters["l"]
    scales = hd.Scales(length=l, speed=hd.Parameter("pace", "m/s", 1), arm=l)
    scene = model.scene(scales=scales, start=hd.Start(position={"q": hd.Parameter("q0", "rad", 3)}))
    run = simulate(load(scene), duration="1 s", accuracy=1e-8)

    def rates(t, s):
        return [s[1], -(9.81 - 0.02 * 100**2 * math.cos(100 * t)) / 0.5 * math.sin(s[0])]

    other = solve_ivp(rates, (0, 1), [3, 0], rtol=1e-10, atol=1e-12, method="DOP853")
    assert run["q.angle"][-1] == pytest.approx(other.y[0, -1], abs=1e-7)
    with pytest.raises(hd.InputError, match="follows time"):
        model.scene(scales=scales, effects=(hd.EnergyLedger(),))
    with pytest.raises(hd.InputError, match="derivatives of coordinates"):
        hd.from_sympy(method, units=units, parameters=values, origin=O, specified={y: hd.Input("y_measured", "m")})


def test_equations_not_yet_formed_and_other_objects_are_refused():
    with pytest.raises(hd.InputError, match="KanesMethod, a LagrangesMethod or a System"):
        hd.from_sympy("KanesMethod", units={}, parameters={})


def test_pendulums_on_a_cart_have_the_accelerations_of_the_textbook():
    # M_ij = (sum of the masses beyond) l_i l_j cos(q_i - q_j); Spong, Corke, Lozano-type equations written out here
    n = 3
    method, O, units, values = models.cart(n)
    model = hd.from_sympy(
        method, units=units, parameters=values, origin=O, specified={"push": 3 * hd.Parameter("F", "N", 1)}, name="cart"
    )
    scales = hd.Scales(length=model.parameters["l1"], speed=hd.Parameter("pace", "m/s", 1), arm=model.parameters["l1"])
    derived = Derived(model.scene(scales=scales))
    m, l, rng = [1 + 0.1 * i for i in range(n + 1)], [0.5 - 0.05 * i for i in range(n)], np.random.default_rng(1)
    beyond = [sum(m[i + 1 :]) for i in range(n)]
    for _ in range(3):
        q, u = rng.uniform(-1, 1, n + 1), rng.uniform(-1, 1, n + 1)
        M, f = np.zeros((n + 1, n + 1)), np.zeros(n + 1)
        M[0, 0], f[0] = sum(m), 3
        for i in range(n):
            M[0, i + 1] = M[i + 1, 0] = beyond[i] * l[i] * np.cos(q[i + 1])
            f[0] += beyond[i] * l[i] * np.sin(q[i + 1]) * u[i + 1] ** 2
            f[i + 1] = -beyond[i] * l[i] * 9.81 * np.sin(q[i + 1])
            for k in range(n):
                M[i + 1, k + 1] = beyond[max(i, k)] * l[i] * l[k] * np.cos(q[i + 1] - q[k + 1])
                f[i + 1] -= beyond[max(i, k)] * l[i] * l[k] * np.sin(q[i + 1] - q[k + 1]) * u[k + 1] ** 2
        force = derived.call("applied", q=q, u=u)
        result, *_ = derived.call("accelerations", q=q, u=u, f=force)
        assert result == pytest.approx(np.linalg.solve(M, f), rel=1e-10, abs=1e-10)


def test_a_rattleback_turns_back_as_newtons_and_eulers_equations_say():
    method, units, values = models.rattleback()
    model = hd.from_sympy(method, units=units, parameters=values, name="rattleback")
    a = model.parameters["a"]
    half = hd.Parameter("half", "deg", 0.5)
    scene = model.scene(
        effects=(hd.EnergyLedger(),), scales=hd.Scales(length=a, speed=hd.Parameter("pace", "m/s", 1), arm=a),
        start=hd.Start(position={"q2": half, "q3": half}, speed={"u3": hd.Parameter("spin", "rad/s", -5)}),
    )  # fmt: skip
    loaded = load(scene)
    run = simulate(loaded, duration="0.3 s", accuracy=1e-9)
    axes, h, inertia = (
        np.array((0.2, 0.03, 0.02)), 0.01, np.array([[2e-4, -2e-5, 0], [-2e-5, 1.6e-3, 0], [0, 0, 1.7e-3]]),
    )  # fmt: skip

    def rates(_, y):
        w, up = y[:3], y[3:]  # up in the stone's axes
        size = np.sqrt(np.sum((axes * up) ** 2))
        r = axes**2 * up / size - np.array((0, 0, h))  # from the contact to the mass centre, which moves at w x r
        dup = -np.cross(w, up)
        dr = axes**2 * (dup / size - up * np.sum(axes**2 * up * dup) / size**3)
        # I w' + w x I w = -r x F, F = (w' x r + w x dr + w x (w x r)) + 9.81 up
        across = np.array([[0, -r[2], r[1]], [r[2], 0, -r[0]], [-r[1], r[0], 0]])
        known = np.cross(w, dr) + np.cross(w, np.cross(w, r)) + 9.81 * up
        return np.concatenate(
            (np.linalg.solve(inertia - across @ across, -np.cross(w, inertia @ w) - np.cross(r, known)), dup)
        )

    x, z = math.radians(0.5), math.radians(0.5)  # about the stone's x, then its y
    up = np.array((-math.cos(x) * math.sin(z), math.sin(x), math.cos(x) * math.cos(z)))
    other = solve_ivp(rates, (0, 0.3), [0, 0, -5, *up], rtol=1e-10, atol=1e-12, method="DOP853")
    assert [run[f"u{k}.speed"][-1] for k in (1, 2, 3)] == pytest.approx(other.y[:3, -1], abs=1e-7)
    spin = simulate(loaded, duration="4 s", accuracy=1e-6)["u3.speed"]
    assert spin[0] == -5
    assert spin[-1] > 2  # it has turned back


def test_constraints_of_lagranges_equations_hold_a_skate_and_a_bob():
    # the skate's cycloid: Neimark, Fufaev, Dynamics of Nonholonomic Systems (1972), chapter 1; the bob against energy and the native pendulum
    method, units, values = models.skate()
    model = hd.from_sympy(method, units=units, parameters=values, name="skate")
    l = model.parameters["l"]
    nothing = hd.Parameter("nothing", "m", 0)
    scene = model.scene(
        effects=(hd.EnergyLedger(),), scales=hd.Scales(length=l, speed=hd.Parameter("pace", "m/s", 1), arm=l),
        start=hd.Start(position={"a": l, "b": nothing, "x": nothing, "y": nothing, "turn": hd.Parameter("start", "rad", 0)},
                    speed={"turn": hd.Parameter("rate", "rad/s", 2), "b": hd.Parameter("still", "m/s", 0)}),
    )  # fmt: skip
    run = simulate(load(scene), duration="1 s", accuracy=1e-9)
    way, t = 9.81 * math.sin(0.3) / (2 * 2**2), 1.0
    assert run["x.travel"][-1] == pytest.approx(way * math.sin(2 * t) ** 2, abs=1e-8)
    assert run["y.travel"][-1] == pytest.approx(way * (2 * t - math.sin(4 * t) / 2), abs=1e-8)
    assert run["a.travel"] ** 2 + run["b.travel"] ** 2 == pytest.approx(0.25, abs=1e-9)
    assert run["a.speed"] ** 2 + run["b.speed"] ** 2 == pytest.approx(-2 * 9.81 * run["b.travel"], abs=1e-7)
    assert run["energy"] == pytest.approx(run["energy"][0], abs=1e-8)


def test_weight_with_a_stored_potential_does_no_other_work():
    """A bob on a string beside a push of 2 N: the energy of its height is stored, and only the push puts work in, 2 N times its way."""
    method, at, units, values = models.pendulum(extra=sp.Symbol("push"))
    (bob,) = method.bodies
    m, g = sp.Symbol("m"), sp.Symbol("g")
    bob.potential_energy = m * g * at["P"].pos_from(at["O"]).dot(method._inertial.y)
    model = hd.from_sympy(
        method, units=units | {sp.Symbol("push"): "N"}, parameters=values | {sp.Symbol("push"): 2}, origin=at["O"], name="bob",
    )  # fmt: skip
    l = model.parameters["l"]
    scales = hd.Scales(length=l, speed=hd.Parameter("pace", "m/s", 1), arm=l)
    start = hd.Start(position={"q": hd.Parameter("q0", "rad", 0.5)})
    run = simulate(
        load(model.scene(effects=(hd.EnergyLedger(),), scales=scales, start=start)), duration="1 s", tolerance=1e-10
    )
    way = 0.5 * (np.sin(run["q.angle"]) - np.sin(0.5))
    assert np.ptp(way) > 0.1
    assert run["loads.input"] == pytest.approx(2 * way, abs=1e-8)


def test_a_gap_beside_a_driven_coordinate_accelerates_with_its_drive():
    """A bob below a cart that a law of time moves: the derivative of the gap's rate along the motion, by CasADi."""
    method, O, units, values = models.cart(1)
    model = hd.from_sympy(
        method, units=units, parameters=values, origin=O, specified={"push": 0 * hd.Parameter("F", "N", 1)}, name="cart"
    )
    size, rate = hd.Parameter("size", "m", 0.2), hd.Parameter("rate", "rad/s", 3)
    radius = hd.Parameter("radius", "mm", 20)
    wall = hd.SphereOnPlane("wall", sphere=model.at("P1"), radius=radius, plane=hd.GROUND.at(0, 0, 0), normal=hd.X)
    scene = model.scene(
        pairs=(wall,),
        effects=(hd.Drive("shaker", "q0", position=size * sp.sin(rate * hd.T)), hd.Contact("wall", hd.laws.power(hd.Parameter("K", "N/m", 1e5), 1))),
        scales=hd.Scales(length=radius, speed=hd.Parameter("pace", "m/s", 1), arm=radius),
    )  # fmt: skip
    derived = Derived(scene)
    options = {"t": 0.4, "q": np.array([0.5]), "u": np.array([0.7])}
    a = np.array([1.3])
    expected = rate_along(derived, "gaps", 1, options["t"], options["q"], options["u"], a)
    assert derived.call("gap_accelerations", **options, a=a) == pytest.approx(expected, rel=1e-10)
    driven = -0.2 * 3**2 * np.sin(1.2)  # of the cart, and of the string of 0.5 m as an arm of its own
    assert expected == pytest.approx([driven + 0.5 * (np.cos(0.5) * 1.3 - np.sin(0.5) * 0.7**2)], rel=1e-10)


def test_a_force_beside_the_origin_of_an_imported_body_has_its_arm():
    """A push along X at (x, y) of a string's frame, its origin the bob: F dX/dq with X = x cos q + (l - y) sin q."""
    method, at, units, values = models.pendulum()
    model = hd.from_sympy(method, units=units, parameters=values, origin=at["O"], name="pushed")
    l, x, y = model.parameters["l"], hd.Parameter("x", "m", 0.2), hd.Parameter("y", "m", 0.1)
    place = model.at("P", "A").body.at(x, y, 0)
    push = hd.PointForce("push", place, (hd.Parameter("F", "N", 3), 0, 0))
    derived = Derived(
        model.scene(effects=(push,), scales=hd.Scales(length=l, speed=hd.Parameter("pace", "m/s", 1), arm=l))
    )
    q = 0.6
    actual = derived.call("applied", t=0.0, q=np.array([q]), u=np.array([0.0]))
    expected = 3 * (-0.2 * np.sin(q) + (0.5 - 0.1) * np.cos(q)) - 9.81 * 0.5 * np.sin(q)
    assert actual == pytest.approx([expected], rel=1e-12)
