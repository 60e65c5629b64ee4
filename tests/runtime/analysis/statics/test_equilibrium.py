"""Equilibria against closed forms: Hertz' law, virtual work, buckling, friction's range, forces that balance leaves open."""

import math

import casadi as ca
import numpy as np
import pytest
from handmade import point
from loops import cranks, four_bar, rad
from scipy.optimize import brentq

import hertzwerk.derive as hd
from hertzwerk.derive.laws import coulomb, power
from hertzwerk.derive.scenes.slider_crank import scene as slider_crank
from hertzwerk.runtime import equilibrium, modes, simulate
from hertzwerk.runtime.analysis.statics import relaxation
from hertzwerk.runtime.analysis.statics.balance import balance, grips_of
from hertzwerk.runtime.loading import engine_model

p = hd.Parameter

G = 9.81


def test_a_ball_dropped_from_a_metre_rests_on_hertz_law_and_a_run_from_there_stays(ball):
    """K d^(3/2) = m g, and vibrates with k = 3/2 K d^(1/2): Hertz, J. reine angew. Math. 92 (1882) 156."""
    rest = equilibrium(ball, parameters={"mass": "2 kg"})
    depth = (2 * G / 2.4e10) ** (2 / 3)
    assert rest.outcome.name == "found" and rest.stable and not rest.indeterminate
    assert rest.penetrations["floor"] == pytest.approx(depth, rel=1e-9)
    assert rest.contacts["floor"] == pytest.approx(2 * G, rel=1e-9)
    assert modes(rest).frequencies == pytest.approx(
        [math.sqrt(1.5 * 2.4e10 * depth**0.5 / 2) / (2 * math.pi)], rel=1e-9
    )
    rest = equilibrium(ball)
    run = simulate(ball, duration="20 ms", tolerance=1e-8, initial=rest)
    assert dict(rest) == {"vertical.travel": (rest.q[0], "m"), "vertical.speed": (0.0, "m/s")}
    assert run["floor.normal_force"] == pytest.approx(np.full(len(run.t), G), rel=1e-4)


def test_buckling_past_the_critical_load_and_points_that_nothing_or_all_holds():
    """k x = P sin(x) with P = 2 k: the upright is an equilibrium that grows with sqrt(P - k), the buckled one is stable."""
    strut = point(push=lambda t, x, v: -x + 2 * ca.sin(x))
    straight = equilibrium(strut, initial={"path.travel": "0.1 m"}, nearest=True)
    assert straight.q[0] == pytest.approx(0, abs=1e-12) and not straight.stable
    assert max(mode.eigenvalue.real for mode in modes(straight)) == pytest.approx(1, rel=1e-9)
    buckled = equilibrium(strut, initial={"path.travel": "0.1 m"})
    angle = brentq(lambda x: 2 * math.sin(x) - x, 1, 3, xtol=1e-15)
    assert buckled.q[0] == pytest.approx(angle, rel=1e-10) and buckled.stable
    assert modes(buckled).frequencies == pytest.approx([math.sqrt(1 - 2 * math.cos(angle)) / (2 * math.pi)], rel=1e-9)
    falling = equilibrium(point(push=lambda t, x, v: 1 + 0 * x))
    assert falling.outcome.name == "no_equilibrium" and "path.speed" in falling.outcome.message
    assert not falling.converged and not falling.stable and not falling.rows
    with pytest.raises(hd.InputError, match="no equilibrium"):
        modes(falling)
    floating = equilibrium(point())
    assert floating.outcome.name == "not_unique" and floating.indifferent == ("path.travel",)


def test_a_shaft_rests_on_two_balls_and_the_loose_ones_are_indifferent():
    """Of six balls those at 240 and 300 degrees carry 500 N, along the lines from their centres to the shaft's."""
    rest = equilibrium(engine_model("ball_bearing"))
    assert rest.outcome.name == "not_unique"
    assert {f"way_{k}.travel" for k in range(4)} <= set(rest.indifferent)
    assert not any(name.startswith(("shaft", "way_4", "way_5")) for name in rest.indifferent)
    q = dict(zip(rest.model.coordinates, rest.q, strict=True))
    ball = q["way_5.travel"] * np.array([0.5, -math.sqrt(0.75)])
    along = np.array([q["shaft.x"], q["shaft.y"]]) - ball
    assert 2 * rest.contacts["inner_5"] * along[1] / np.hypot(*along) == pytest.approx(500, rel=1e-9)
    assert rest.contacts["inner_5"] == pytest.approx(1e10 * rest.penetrations["inner_5"] ** 1.5, rel=1e-9)


def test_a_governor_at_rest_hangs_straight_down():
    """Its spring is slack where arms and rods hang straight, and each half alone can give way sideways there."""
    rest = equilibrium(engine_model("flyball_governor"))
    q = dict(zip(rest.model.coordinates, rest.q, strict=True))
    assert q["guide.travel"] == pytest.approx(-0.15 - 0.2, abs=1e-12)
    assert rest.stable and rest.indifferent == ("spindle.angle",)


@pytest.mark.parametrize(("name", "value", "test"), [
    ("_sizes", lambda largest: np.maximum(largest, 1e-300), test_a_shaft_rests_on_two_balls_and_the_loose_ones_are_indifferent),
    pytest.param("VANISHED", 0.0, test_a_governor_at_rest_hangs_straight_down, marks=pytest.mark.exhaustive),
])  # fmt: skip
def test_rounding_taken_for_a_direction_would_keep_it_from_rest(name, value, test, monkeypatch):
    monkeypatch.setattr(relaxation, name, value)
    with pytest.raises((AssertionError, KeyError)):
        test()


def test_the_torque_that_holds_a_four_bar_by_virtual_work():
    """M = dV/dtheta, V the potential of the closed linkage by the intersection of two circles."""
    lengths = (1.0, 2.5, 2.0, 2.2)
    above = {"left": rad(0.9), "foot": rad(1.4)}
    rest = equilibrium(engine_model(four_bar(*lengths, 2.0, near=above)), at="0.35 s")

    def potential(theta: float) -> float:
        a, b, c, d = lengths
        tip = a * np.exp(1j * theta)
        far = d - tip
        along = (b**2 - c**2 + abs(far) ** 2) / (2 * abs(far))
        corner = tip + far / abs(far) * (along + 1j * math.sqrt(b**2 - along**2))
        return float(G * (tip.imag / 2 + (tip.imag + corner.imag) / 2 + corner.imag / 2))

    h = 1e-5
    by_work = (potential(0.7 + h) - potential(0.7 - h)) / (2 * h)
    by_statics = rest.drives["drive"]
    assert rest.outcome.name == "found"
    assert by_statics == pytest.approx(by_work, rel=1e-8)
    assert not len(modes(rest))  # nothing is left to vibrate


def test_a_pin_with_clearance_rests_at_the_side_that_carries_at_every_time_of_its_drive():
    """Half the rod's weight hangs on the slider's pin, and the crank's drive holds half of it: the rod lies level."""
    rest = equilibrium(engine_model("slider_crank"))
    assert rest.contacts["slider_pin"] == pytest.approx(0.21 * G / 2, rel=1e-3)
    assert rest.drives["crank_drive"] == pytest.approx(0.05 * 0.21 * G / 2, rel=1e-3)
    assert rest.q[0] == pytest.approx(-0.5e-3 / 0.12, rel=1e-3)  # the rod's end hangs by the clearance
    # M = m g x'(theta)/2 of a rod whose ends carry half each, in every turn the same; 5000 rpm: 12 ms a turn.
    model = engine_model("slider_crank")
    early, late = (equilibrium(model, at=t) for t in ("3.5 ms", "27.5 ms"))
    angle = 5000 * 2 * math.pi / 60 * 3.5e-3
    slider = 0.05 * math.cos(angle) + math.sqrt(0.12**2 - (0.05 * math.sin(angle)) ** 2)
    assert early.converged and early.q[1] == pytest.approx(slider, abs=1e-3)
    assert late.q == pytest.approx(early.q, rel=1e-9)
    # the slider moves freely: the crank carries the rod's weight at half its length
    assert early.drives["crank_drive"] == pytest.approx(0.21 * G * 0.05 * math.cos(angle) / 2, rel=2e-2)


def test_redundant_loops_swing_as_one_pendulum_and_are_named():
    """Three cranks on one coupler, two of which would do: w^2 = g (3 m L/2 + m L) / (3 (J + m L^2/4) + m L^2)."""
    model = engine_model(cranks())
    rest = equilibrium(model)
    assert rest.converged and rest.stable
    assert [math.cos(q) for q in rest.q[[0, 2]]] == pytest.approx([0, 0], abs=1e-9)
    assert {name.partition(".")[0] for name in rest.indeterminate} >= {"right", "middle"}
    wanted = math.sqrt(G * 2.5 / (3 * (0.1 + 0.25) + 1))
    assert 2 * math.pi * modes(rest).frequencies == pytest.approx([wanted], rel=1e-8)


# ---- friction, several contacts ------------------------------------------------------------------------------------------


def sledge(friction=None, floors=1):
    """A sphere that does not turn, on a floor, with a force along it."""
    mass, radius = p("mass", "kg", 1), p("radius", "m", 0.1)
    cart, body = (hd.Body(name, mass=mass) for name in ("cart", "body"))
    pairs = tuple(
        hd.SphereOnPlane(f"floor_{i}", body.at(0, 0, 0), radius, hd.GROUND.at(0, 0, 0), hd.Y) for i in range(floors)
    )
    stiffness = [p(f"stiffness_{i}", "N/m", 1e5 * (i + 1)) for i in range(floors)]
    return hd.Scene(
        hd.Mechanism(
            "sledge", (hd.Prismatic("along", hd.GROUND, cart, axis=hd.X), hd.Prismatic("up", cart, body, axis=hd.Y)), pairs,
        ),
        effects=(
            hd.Gravity("weight", p("weight", "m/s^2", 10), direction=-hd.Y),
            hd.JointForce("downhill", "along", p("downhill", "N", 0)),
            *(hd.Contact(pair.name, power(k, 1)) for pair, k in zip(pairs, stiffness, strict=True)),
            *([hd.Friction("rub", "floor_0", friction)] if friction else []),
        ),
        scales=hd.Scales(length=p("depth", "mm", 0.1), speed=p("pace", "m/s", 1)),
        start=hd.Start(position={"up": radius + p("height", "mm", 5)}),
    )  # fmt: skip


MU = p("mu_k", "1", 0.2), p("mu_s", "1", 0.3)


def test_set_valued_friction_holds_up_to_its_limit_and_no_further():
    """Two bodies of 1 kg weigh 10 N each, only one presses: 0.3 x 10 N hold 2 kg against 2.99 N, not against 1.51."""
    model = engine_model(sledge(coulomb(*MU)))
    held = equilibrium(model, parameters={"downhill": "2.99 N"}, initial={"up.travel": "99.9 mm"})
    assert held.outcome.name == "found" and "one of many" in " ".join(held.notes)
    assert abs(held.sticking["floor_0"]) == pytest.approx(2.99, rel=1e-9)
    assert held.q[0] == pytest.approx(0, abs=1e-12)
    assert 2 * math.pi * modes(held).frequencies == pytest.approx([math.sqrt(1e5)], rel=1e-9)  # the other sticks
    gone = equilibrium(model, parameters={"downhill": "3.01 N"})
    assert gone.outcome.name == "no_equilibrium" and "along.speed" in gone.outcome.message


def test_friction_in_two_directions_holds_up_to_its_size():
    """0.3 x 10 N hold a push along the diagonal of the tangents of 2.97 N, not of 3.03 N, of which each part is 2.14 N."""
    ball, r = hd.Body("ball", p("m", "kg", 1)), p("r", "mm", 10)
    one, two = (hd.Body(f"slide_{i}", p(f"m_{i}", "kg", 1e-3)) for i in (1, 2))
    joints = (
        hd.Prismatic("px", hd.GROUND, one, axis=hd.X), hd.Prismatic("py", one, two, axis=hd.Y), hd.Prismatic("pz", two, ball, axis=hd.Z),
    )  # fmt: skip
    push = p("push", "N", 1)
    scene = hd.Scene(
        hd.Mechanism(
            "pushed", joints, (hd.SphereOnPlane("floor", ball.at(0, 0, 0), r, hd.GROUND.at(0, 0, 0), normal=hd.Z),)
        ),
        (
            hd.Gravity("gravity", p("g", "m/s^2", 10), direction=-hd.Z), hd.Contact("floor", power(p("K", "N/m", 1e5), 1)),
            hd.Friction("rub", "floor", coulomb(p("mu", "1", 0.3), p("mu_s", "1", 0.3))), hd.JointForce("along", "px", push / math.sqrt(2)),
            hd.JointForce("across", "py", push / math.sqrt(2)),
        ),
        hd.Scales(r, p("pace", "m/s", 1)),
        hd.Start(position={"pz": r}),
    )  # fmt: skip
    model = engine_model(scene)
    held = equilibrium(model, parameters={"push": "2.97 N"})
    assert held.converged
    assert held.sticking["floor"] == pytest.approx(2.97, rel=1e-9)
    assert equilibrium(model, parameters={"push": "3.03 N"}).outcome.name == "no_equilibrium"


def test_a_drive_carries_what_friction_holds_on_it():
    """A block of 2 kg sticks to the side of a carriage of 3 kg, whose lift takes the weight of both."""
    carriage, block, r = (
        hd.Body("carriage", p("M", "kg", 3)), hd.Body("block", p("m", "kg", 2)), p("r", "mm", 10),
    )  # fmt: skip
    slide = hd.Body("slide", p("m_0", "kg", 0.1))
    scene = hd.Scene(
        hd.Mechanism(
            "lift",
            (
                hd.Prismatic("lift", hd.GROUND, carriage, axis=hd.Y),
                hd.Prismatic("up", hd.GROUND, slide, axis=hd.Y),
                hd.Prismatic("aside", slide, block, axis=hd.X),
            ),
            (hd.SphereOnPlane("side", block.at(0, 0, 0), r, carriage.at(0, 0, 0), normal=hd.X),),
        ),
        (
            hd.Gravity("gravity", p("g", "m/s^2", G), direction=-hd.Y), hd.Contact("side", power(p("K", "N/m", 1e6), 1)),
            hd.Friction("rub", "side", coulomb(p("mu", "1", 0.5), p("mu_s", "1", 0.5))), hd.JointForce("press", "aside", -p("pressing", "N", 100)),
            hd.Drive("hoist", "lift", position=p("high", "mm", 0)),
        ),
        hd.Scales(r, p("pace", "m/s", 1)),
        hd.Start(position={"aside": r}),
    )  # fmt: skip
    rest = equilibrium(engine_model(scene))
    assert rest.converged
    assert abs(rest.sticking["side"]) == pytest.approx(2.1 * G, rel=1e-9)
    assert rest.drives["hoist"] == pytest.approx(5.1 * G, rel=1e-9)


def test_a_leaning_tower_that_just_touches_carries_the_weights_above():
    """Three rectangles by 5 mm beside each other, held by friction: a corner of each carries by its lever about the other's."""
    w, h, r, K = (p(n, u, v) for n, u, v in (("w", "mm", 100), ("h", "mm", 80), ("r", "mm", 1), ("K", "N/m", 1e6)))
    masses, aside = (0.5, 1.0, 1.5), p("aside", "mm", 5)
    bodies = [hd.Body(f"b{i}", p(f"m{i}", "kg", m), p("J", "kg m^2", 1e-3)) for i, m in enumerate(masses)]
    places = [place.at(0, 0, 0) for place in (hd.GROUND, *bodies)]
    pairs = [hd.BoxOnBox(f"on{i}", places[i + 1], w, h, places[i], w, h, r) for i in range(3)]
    effects = [hd.Gravity("gravity", p("g", "m/s^2", G), -hd.Y)]
    for pair in pairs:
        grip = coulomb(p("mu", "1", 0.3), p("mu_s", "1", 0.4))
        effects += [hd.Contact(pair.name, power(K, 1)), hd.Friction(f"{pair.name}_rub", pair.name, grip)]
    start = hd.Start(position={f"p{i}.{axis}": (i + 1) * by for i in range(3) for axis, by in (("x", aside), ("y", h))})
    joints = [hd.Planar(f"p{i}", hd.GROUND, body) for i, body in enumerate(bodies)]
    rest = equilibrium(
        engine_model(
            hd.Scene(hd.Mechanism("tower", joints, pairs), effects, hd.Scales(r, p("pace", "m/s", 0.1), w), start)
        )
    )
    assert rest.converged and not rest.indifferent
    x = np.array([0, *(rest.q[3 * i] for i in range(3))])
    for i in range(3):
        weights = G * np.array(masses[i:])
        left, right = (sum(rest.contacts[f"on{i}_{k}"] for k in of) for of in ((1, 2), (3, 4)))
        centre = weights @ x[i + 1 :] / weights.sum()
        assert left + right == pytest.approx(weights.sum(), rel=1e-4)
        # corners at 49 mm, the upper's left and the lower's right; friction on both at unlike heights takes up to 0.4 x 2 mm of each force
        assert left * (x[i + 1] - 0.049) + right * (x[i] + 0.049) == pytest.approx(
            weights.sum() * centre, abs=0.4 * 2e-3 * left
        )


def test_two_supports_share_by_their_stiffness_alone():
    model = engine_model(sledge(floors=2))
    rest = equilibrium(model)
    assert rest.outcome.name == "not_unique" and rest.indifferent == ("along.travel",)
    assert rest.indeterminate == ("floor_0", "floor_1")
    assert list(rest.contacts.values()) == pytest.approx([10 / 3, 20 / 3], rel=1e-9)


# ---- the functions -------------------------------------------------------------------------------------------------------


def test_the_tangent_stiffness_is_the_difference_of_forces():
    model = engine_model("newtons_cradle")
    bound, rng = model.bind(), np.random.default_rng(3)
    q, closed, mu = rng.uniform(-0.1, 0.1, model.nq), np.ones(model.k), np.zeros(len(grips_of(model)))
    at = balance(model, bound, 0.0, q, closed, np.zeros(0), mu)
    h, columns = 1e-6, []
    for one in np.eye(model.nq):
        ways = [balance(model, bound, 0.0, q + sign * h * one, closed, np.zeros(0), mu).force for sign in (1, -1)]
        columns.append((ways[1] - ways[0]) / (2 * h))
    assert at.stiffness == pytest.approx(np.array(columns).T, rel=1e-6, abs=1e-6 * np.abs(at.stiffness).max())


def test_times_at_which_a_drive_is_not_known_and_bad_input_are_refused():
    turned = hd.Drive("crank_drive", "main_bearing", speed=p("w", "rad/s", 500))
    model = engine_model(slider_crank.replace(crank_drive=turned))
    assert equilibrium(model).converged
    for request in (equilibrium, modes):
        with pytest.raises(
            hd.InputError, match=r"t = 0.001 s, for which main_bearing.angle would have to be integrated"
        ):
            request(model, at="1 ms")
    with pytest.raises(hd.InputError, match="target"):
        equilibrium(5)
    with pytest.raises(hd.InputError, match="at"):
        equilibrium(engine_model("pendulum"), at="soon")
    with pytest.raises(hd.InputError, match="mass"):
        equilibrium(engine_model("pendulum"), parameters={"mass": "1 m"})


def test_a_body_moved_by_drives_alone_has_forces():
    """A ball that is held half a millimetre deep in a floor: K d carries, and its drive takes what that is beside the weight."""
    ball, r, deep = hd.Body("ball", p("m", "kg", 1)), p("r", "mm", 10), p("h", "mm", 9.5)
    scene = hd.Scene(
        hd.Mechanism(
            "held_down",
            (hd.Prismatic("lift", hd.GROUND, ball, axis=hd.Y),),
            (hd.SphereOnPlane("floor", ball.at(0, 0, 0), r, hd.GROUND.at(0, 0, 0), normal=hd.Y),),
        ),
        (
            hd.Gravity("gravity", p("g", "m/s^2", G), direction=-hd.Y), hd.Contact("floor", power(p("K", "N/m", 1e5), 1)),
            hd.Drive("press", "lift", position=deep), hd.EnergyLedger(),
        ),
        hd.Scales(r, p("pace", "m/s", 1)),
    )  # fmt: skip
    for coordinates in ("tree", "absolute"):
        rest = equilibrium(engine_model(scene.with_coordinates(coordinates)))
        assert rest.outcome.name == "found"
        assert rest.contacts == pytest.approx({"floor": 50})
        assert rest.drives == pytest.approx({"press": G - 50})


def motor(volts, *effects):
    """A DC motor on a shaft, and effects on it."""
    shaft = hd.Mechanism(
        "motor", (hd.Revolute("main", hd.GROUND, hd.Body("rotor", p("m", "kg", 1), p("J", "kg m^2", 0.01)), hd.Z),)
    )
    ohms, henry, constant = p("ohms", "ohm", 0.5), p("L", "mH", 2), p("k", "N m/A", 0.1)
    size, pace = p("size", "m", 0.1), p("pace", "m/s", 1)
    winding = hd.DCMotor("motor", "main", volts, ohms, henry, constant)
    return engine_model(hd.Scene(shaft, (winding, *effects, hd.EnergyLedger()), hd.Scales(size, pace, size)))


def test_a_motor_s_current_comes_to_rest_where_its_winding_takes_the_voltage():
    """Moving-coil meter: i = V/R, and the spring turns by k i/k_t."""
    meter = motor(p("volts", "V", 2), hd.JointSpring("spring", "main", p("k_t", "N m/rad", 0.8)))
    for nearest in (False, True):
        rest = equilibrium(meter, nearest=nearest)
        assert rest.outcome.name == "found" and rest.stable
        assert rest["motor.current"][0] == pytest.approx(4) and rest["main.angle"][0] == pytest.approx(0.5)
    run = simulate(meter, duration="0.2 s", tolerance=1e-9, initial=rest)
    assert np.ptp(run["main.angle"]) < 1e-9


def test_a_mechanism_that_keeps_a_speed_has_no_equilibrium_and_one_that_only_counts_has():
    control = hd.SpeedController(
        "control", "main", p("w", "rad/s", 5), p("Kp", "V s/rad", 0.5), p("Ki", "V/rad", 5), unit="V",
    )  # fmt: skip
    rest = equilibrium(motor(control.command, control, hd.JointForce("load", "main", p("M", "N m", -0.5))))
    assert rest.outcome.name == "no_equilibrium"
    assert "control.error by 5 (rad)/s" in rest.outcome.message and "modes(run" in rest.outcome.remedy
    # A sampled controller's time to the next sample goes on; its command is held.
    gains = p("Kp", "N m s/rad", 0.5), p("Ki", "N m/rad", 5)
    control = hd.SpeedController("control", "main", p("w", "rad/s", 5), *gains, unit="N m", period=p("Ts", "ms", 1))
    rest = equilibrium(
        motor(
            p("volts", "V", 2), control, hd.JointForce("drive", "main", control.command), hd.JointSpring("spring", "main", p("k_t", "N m/rad", 0.8)),
        )
    )  # fmt: skip
    assert rest.outcome.name == "found" and rest["main.angle"][0] == pytest.approx(0.5)
