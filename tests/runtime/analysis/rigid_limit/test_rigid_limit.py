"""Rigid contacts against closed forms: impacts, sequences of impacts, sliding, sticking, lift-off, the limit of stiffness."""

import math

import numpy as np
import pytest
import sympy as sp

import hertzwerk.derive as hd
from hertzwerk import load
from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import RigidImpact, rigid_limit
from hertzwerk.runtime.analysis.rigid_limit.rigid_derivatives import RigidDerivatives

p = hd.Parameter

G = 9.81
MU = p("mu", "1", 0.3)


def scene(body, joint, pairs, *, start, mu=MU, gravity=-hd.Y):
    frictions = (
        [hd.Friction(f"{pair.name}_friction", pair.name, hd.laws.coulomb(mu, mu)) for pair in pairs]
        if mu is not None
        else []
    )
    contacts = [hd.Contact(pair.name, hd.laws.power(p("K", "N/m^1.5", 1e9), 1.5)) for pair in pairs]
    scales = hd.Scales(length=p("length", "m", 1e-3), speed=p("speed", "m/s", 1), arm=p("arm", "m", 0.1))
    effects = (hd.Gravity("gravity", p("g", "m/s^2", G), direction=gravity), *contacts, *frictions, hd.EnergyLedger())
    return hd.Scene(
        hd.Mechanism(f"{body.name}_scene", joints=(joint,), pairs=pairs), effects=effects, start=start, scales=scales
    )


def thrown_ball(*, space):
    m, r = p("mass", "kg", 1), p("radius", "m", 0.1)
    inertia = 2 * m * r**2 / 5
    ball = hd.Body("ball", mass=m, inertia=(inertia,) * 3 if space else inertia)
    joint = hd.Free("fly", hd.GROUND, ball) if space else hd.Planar("fly", hd.GROUND, ball)
    floor = hd.SphereOnPlane("floor", ball.at(0, 0, 0), r, hd.GROUND.at(0, 0, 0), normal=hd.Y)
    speed = {
        "fly.x_speed": p("along", "m/s", 3),
        **({"fly.z_speed": p("across", "m/s", 4)} if space else {}),
    }
    position = {"fly.y": p("height", "m", 1.1), **({"fly.q0": 1} if space else {})}
    return scene(ball, joint, (floor,), start=hd.Start(position=position, speed=speed))


def block(start_angle, *, half_width=0.25, half_height=1.0):
    b, h, m = (
        p("half_width", "m", half_width),
        p("half_height", "m", half_height),
        p("mass", "kg", 2),
    )
    body = hd.Body("block", mass=m, inertia=m * (b**2 + h**2) / 3)
    foot = hd.BoxOnPlane("foot", body.at(0, 0, 0), 2 * b, 2 * h, hd.GROUND.at(0, 0, 0), normal=hd.Y)
    tilt = p("tilt", "rad", start_angle)
    mechanism = hd.Mechanism("block", joints=(hd.Planar("fly", hd.GROUND, body),), pairs=(foot,))
    start = hd.Start(
        position={"fly.angle": tilt, "fly.y": h * sp.cos(tilt) + b * sp.sin(tilt)},
        speed={"fly.x_speed": p("push", "m/s", 0)},
    )
    return scene(body, mechanism.joints[0], mechanism.pairs, start=start)


def test_ball_comes_to_rest_at_the_sum_of_its_flights_and_without_friction_rules_agree():
    e, first = 0.3, math.sqrt(2 / G)
    run = rigid_limit("bouncing_ball", RigidImpact(e), duration="1 s")
    assert run.outcome.finished
    (end,) = run.accumulations
    assert end.t == pytest.approx(first * (1 + e) / (1 - e), rel=1e-9)
    flights = np.diff([impulse.t for impulse in run.impulses[:10]])
    assert flights == pytest.approx(2 * first * e ** np.arange(1, 10), rel=1e-10)
    assert run.lost == pytest.approx(G, rel=1e-12)  # all of m g h
    assert abs(run.balance) < 1e-10 * G
    assert run.at("vertical.travel", [0.99]) == pytest.approx([0.1], abs=1e-12)
    (other,) = rigid_limit("bouncing_ball", RigidImpact(e + 1e-6), duration="1 s").accumulations
    assert abs(other.t / end.t - 1) > 1e-6  # what the comparison above would see
    runs = [
        rigid_limit("bouncing_ball", RigidImpact(0.5, rule=rule), duration="1.2 s") for rule in ("newton", "poisson")
    ]
    first, second = ([impulse.separation for impulse in run.impulses] for run in runs)
    assert first == pytest.approx(second, rel=1e-12)


@pytest.mark.parametrize("space", [False, True])
def test_ball_thrown_onto_a_rough_floor_slides_then_rolls(space):
    mu, e = 0.1, 0.5
    run = rigid_limit(thrown_ball(space=space), RigidImpact(e, "mu"), duration="1.5 s", parameters={"mu": mu})
    first = run.impulses[0]
    speed = math.sqrt(2 * G)
    assert (first.speed, first.separation) == pytest.approx((speed, e * speed), rel=1e-10)
    assert first.tangential_impulse == pytest.approx(mu * (1 + e) * speed, rel=1e-10)  # it slides throughout
    along, across = (run[f"fly.{axis}_speed"][-1] if axis in "x" or space else 0.0 for axis in "xz")
    assert (along, across) == pytest.approx((5 / 7 * 3, 5 / 7 * 4 if space else 0), rel=1e-9)  # rolling keeps 5/7
    assert abs(run.balance) < 1e-10 * run.energy[0]
    held = rigid_limit(thrown_ball(space=space), RigidImpact(e, 5.0), duration="0.5 s").impulses[0]
    slip = math.hypot(3, 4 if space else 0)
    assert held.tangential_impulse == pytest.approx(2 / 7 * slip, rel=1e-10)  # it sticks within the impact


def test_block_that_rocks_loses_what_housner_states():
    run = rigid_limit(block(0.1), RigidImpact(0.0, 5.0), duration="1.5 s")
    kept = (
        1 - 1.5 * math.sin(math.atan(0.25)) ** 2
    )  # Housner, Bull. Seismol. Soc. Am. 53 (1963) 403: of the angular speed
    assert [impulse.contact for impulse in run.impulses] == ["foot_2", "foot_1"]
    for impulse in run.impulses:
        before, *_, after = run["fly.angle_speed"][run.t == impulse.t]
        assert after / before == pytest.approx(kept, rel=1e-12)
    assert abs(run.balance) < 1e-9 * run.energy[0]


def test_bead_leaves_a_dome_at_two_thirds_of_its_height():
    big, small, angle = p("R", "m", 1), p("r", "m", 0.25), p("angle", "rad", 0.3)
    bead = hd.Body("bead", mass=p("mass", "kg", 1), inertia=p("inertia", "kg m^2", 1))
    dome = hd.SphereOnSphere("dome", bead.at(0, 0, 0), hd.GROUND.at(0, 0, 0), small, big)
    begin = hd.Start(position={"fly.x": (big + small) * sp.sin(angle), "fly.y": (big + small) * sp.cos(angle)})
    run = rigid_limit(
        scene(bead, hd.Planar("fly", hd.GROUND, bead), (dome,), start=begin, mu=None), RigidImpact(0.0), duration="1 s"
    )
    heights = run["fly.y"] / np.hypot(run["fly.x"], run["fly.y"])
    (leaves,) = {height for t, height in zip(run.t, heights, strict=True) if np.count_nonzero(run.t == t) > 1}
    assert leaves == pytest.approx(2 / 3 * math.cos(0.3), rel=1e-9)


def test_body_on_an_incline_stops_and_stays():
    slope, mu, push = 0.2, 0.3, 0.5
    m, r = p("mass", "kg", 1), p("radius", "m", 0.1)
    body = hd.Body("runner", mass=m)
    joint = hd.Prismatic("along", hd.GROUND, hd.Body("carriage", 0), axis=hd.X)
    lift = hd.Prismatic("lift", joint.child, body, axis=hd.Y)
    floor = hd.SphereOnPlane("floor", body.at(0, 0, 0), r, hd.GROUND.at(0, 0, 0), normal=hd.Y)
    effects = (
        hd.Gravity("gravity", p("g", "m/s^2", G), direction=hd.Direction((-math.sin(slope), -math.cos(slope), 0))),
        hd.Contact("floor", hd.laws.power(p("K", "N/m^1.5", 1e9), 1.5)), hd.Friction("rubbing", "floor", hd.laws.coulomb(MU, MU)),
    )  # fmt: skip
    start = hd.Start(position={"lift": r}, speed={"along": p("push", "m/s", push)})
    scales = hd.Scales(length=p("length", "m", 1e-3), speed=p("speed", "m/s", 1))
    incline = hd.Scene(
        hd.Mechanism("incline", joints=(joint, lift), pairs=(floor,)), effects=effects, start=start, scales=scales
    )
    run = rigid_limit(incline, RigidImpact(0.0, "mu"), duration="0.3 s")
    deceleration = G * (math.sin(slope) + mu * math.cos(slope))
    assert run["along.travel"][-1] == pytest.approx(push**2 / 2 / deceleration, rel=1e-9)
    assert run["along.speed"][-1] == 0
    assert run.rubbed == pytest.approx(mu * G * math.cos(slope) * push**2 / 2 / deceleration, rel=1e-9)
    slides = rigid_limit(incline, RigidImpact(0.0, 0.1), duration="0.3 s")  # less than tan(slope): it slides back
    up = G * (math.sin(slope) + 0.1 * math.cos(slope))
    down = G * (math.sin(slope) - 0.1 * math.cos(slope))
    assert slides["along.speed"][-1] == pytest.approx(-down * (0.3 - push / up), rel=1e-8)


@pytest.mark.parametrize(("impacts", "after"), [("together", (-1 / 3, 2 / 3, 2 / 3)), ("in turn", (0, 0, 1))])
def test_row_of_touching_balls_follows_the_stated_rule(impacts, after):
    m, r = p("mass", "kg", 1), p("radius", "m", 0.1)
    balls = [hd.Body(f"ball_{i}", mass=m) for i in range(3)]
    joints = tuple(hd.Prismatic(f"slide_{i}", hd.GROUND, ball, axis=hd.X) for i, ball in enumerate(balls))
    pairs = tuple(hd.SphereOnSphere(f"gap_{i}", balls[i].at(0, 0, 0), balls[i + 1].at(0, 0, 0), r, r) for i in range(2))
    contacts = tuple(hd.Contact(pair.name, hd.laws.power(p("K", "N/m^1.5", 1e9), 1.5)) for pair in pairs)
    start = hd.Start(
        position={"slide_0": -5 * r, "slide_1": 0 * r, "slide_2": 2 * r},
        speed={"slide_0": p("speed", "m/s", 1)},
    )
    row = hd.Scene(hd.Mechanism("row", joints=joints, pairs=pairs), effects=(*contacts, hd.EnergyLedger()), start=start,
                scales=hd.Scales(length=p("length", "m", 1e-3), speed=p("pace", "m/s", 1)))  # fmt: skip
    run = rigid_limit(row, RigidImpact(1.0), duration="0.5 s", impacts=impacts)
    assert [run[f"slide_{i}.speed"][-1] for i in range(3)] == pytest.approx(after, abs=1e-12)
    assert abs(run.balance) < 1e-12


def test_painleves_rod_is_refused_by_name():
    half, m = p("half_length", "m", 0.5), p("mass", "kg", 1)
    rod = hd.Body("rod", mass=m, inertia=m * half**2 / 3)
    tip = hd.CornerOnFace("tip", rod.at(-half, 0, 0), hd.GROUND.at(0, 0, 0), hd.Y)
    angle = p("angle", "rad", 1.1)
    start = hd.Start(
        position={"fly.angle": angle, "fly.y": half * sp.sin(angle)},
        speed={"fly.x_speed": p("push", "m/s", -1)},
    )
    jammed = scene(rod, hd.Planar("fly", hd.GROUND, rod), (tip,), start=start)

    def opens(mu):  # of the tip by a newton, times the mass: 1 + 3 cos^2 - 3 mu sin cos, as for Painleve's rod
        return 1 + 3 * math.cos(1.1) ** 2 - 3 * mu * math.sin(1.1) * math.cos(1.1)

    outcome = rigid_limit(jammed, RigidImpact(0.0, 1.5), duration="0.01 s").outcome
    assert opens(1.5) < 0
    assert outcome.name == "no_rigid_solution"
    assert "tip" in outcome.message
    assert "Painleve" in outcome.message
    assert opens(1.2) > 0
    assert rigid_limit(jammed, RigidImpact(0.0, 1.2), duration="0.01 s").outcome.finished


def test_compliant_impacts_converge_with_the_stiffness():
    exact = load("bouncing_ball", laws={"floor": "exact"})
    law = RigidImpact("restitution")
    limit = rigid_limit(
        exact, law, duration="1.5 s", stiffness="stiffness", factors=(0.1, 1, 10), parameters={"restitution": 0.8}
    )
    assert limit.orders[1:] == pytest.approx([0.4], rel=1e-3)  # a contact of F = K d^1.5 lasts as K^-0.4 (Hertz)
    assert "0.400" in str(limit)
    late = [each.apart[1] for each in limit.stiffer]
    assert late == sorted(late, reverse=True)


def test_slider_crank_converges_impact_by_impact():
    crank = load("slider_crank", laws={"slider_pin": "exact"})
    limit = rigid_limit(
        crank, RigidImpact("restitution", "friction_coefficient"), duration="1.1 ms", stiffness="youngs_modulus",
        parameters={"clearance": "0.5 mm"},
    )  # fmt: skip
    assert limit.outcome.finished
    for impact in (1, 2):
        late = [abs(each.apart[impact]) for each in limit.stiffer]
        assert late[0] > 2 * late[1] > 4 * late[2]
    assert limit.motion.work > 1  # of the drive, at impacts too
    assert abs(limit.balance) < 1e-10 * limit.energy.max()
    apart, end = limit.differences
    assert 0 < apart < 1e-10 and 0 < end < 1e-7


def flights(by):
    """Changes of times and speeds of the ball's impacts, and of the end of its bounces, less those of the closed form."""
    e, first = 0.3, math.sqrt(2 / G)
    run = rigid_limit("bouncing_ball", RigidImpact("restitution"), duration="1 s", parameters={"restitution": e})
    n, (t, speed), found = (
        np.arange(len(run.impulses)),
        np.array(run.impulses)[:, 1:3].astype(float).T,
        run.derivatives(by),
    )
    of_time = first * (1 + 2 * e * (1 - e**n) / (1 - e)), 2 * first * ((1 - e**n) / (1 - e) ** 2 - n * e**n / (1 - e))
    assert t == pytest.approx(of_time[0], rel=1e-10)
    sizes = {
        "restitution": 2 * first / (1 - e) ** 2,
        "gravity": -first * (1 + e) / (1 - e) / 2 / G,
        "vertical.travel": first * (1 + e) / (1 - e) / 2,
    }
    times = {"restitution": of_time[1], "gravity": -t / 2 / G, "vertical.travel": t / 2}
    speeds = {"restitution": speed * n / e, "gravity": speed / 2 / G, "vertical.travel": speed / 2}
    parts = (
        found.impulses("t", by) - times[by],
        found.impulses("speed", by) - speeds[by],
        found.accumulations(by) - sizes[by],
    )
    return max(np.max(np.abs(part)) for part in parts), found


@pytest.mark.parametrize("by", ["restitution", "gravity", "vertical.travel"])
def test_derivatives_of_a_ball_are_those_of_its_closed_form(by):
    apart, found = flights(by)
    assert apart < 1e-8 and found.differences < 1e-7 and found.reason == ""
    assert abs(found.at(0.95, "vertical.speed", by)) < 1e-12  # at rest


def test_a_ball_whose_impacts_keep_their_times_is_seen(monkeypatch):
    monkeypatch.setattr(RigidDerivatives, "_shift", lambda *_: 0.0)
    assert flights("gravity")[0] > 1e-3


@pytest.mark.parametrize(
    ("case", "by"), [("space", "mu"), ("plane", "height"), ("block", "tilt"), ("crank", "clearance")]
)
def test_derivatives_are_those_of_differences_of_runs(case, by):
    """Sliding that turns and ends, sticking, impacts of a corner beside a contact that lasts, a drive in a clearance."""
    target, law, duration, name = {
        "space": (thrown_ball(space=True), RigidImpact(0.5, "mu"), "1.2 s", "fly.x_speed"),
        "plane": (thrown_ball(space=False), RigidImpact(0.5, "mu"), "1.2 s", "fly.x_speed"),
        "block": ("housner_block", RigidImpact(0, "friction"), "0.8 s", "move.angle"),
        "crank": ("slider_crank", RigidImpact("restitution"), "2 ms", "guide.travel"),
    }[case]
    model = load(target)
    run = rigid_limit(model, law, duration=duration)
    found, (value, unit), end = run.derivatives(by), run.run.equations.bound.values[by], run.t[-1] * 0.999
    step = 1e-4 * value
    near = [
        rigid_limit(model, law, duration=duration, parameters={by: (value + k * step, unit)}, tolerance=1e-12)
        for k in (1, -1)
    ]
    change = run.run.equations.bound[by] * 2e-4
    times = np.array([[impulse.t for impulse in each.impulses] for each in near])
    assert found.reason == ""
    assert found.impulses("t", by) == pytest.approx((times[0] - times[1]) / change, rel=1e-5, abs=1e-9)
    states = [each.at(name, [end])[0] for each in near]
    assert found.at([end], name, by) == pytest.approx([(states[0] - states[1]) / change], rel=1e-5)


def test_shape_parameters_of_a_cam_have_derivatives():
    def rigid(**lift):
        how = {"duration": "8 ms", "initial": {"guide.travel": "41 mm"}, "parameters": lift}
        return rigid_limit("cam_follower", RigidImpact(0.5), **how)

    run, (high, low) = rigid(), (rigid(lift=f"{x} mm") for x in (10.001, 9.999))
    assert len(run.impulses) == 3
    change = [(a.t - b.t) / 2e-6 for a, b in zip(high.impulses, low.impulses, strict=True)]
    assert run.derivatives("lift").impulses("t", "lift") == pytest.approx(change, rel=1e-5)


def test_derivatives_end_where_the_motion_is_not_smooth():
    both = rigid_limit(block(0.0), RigidImpact(0.5), duration="0.5 s", initial={"fly.y": "1.2 m"}).derivatives("g")
    assert "foot_1 and foot_2 collide at one instant" in both.reason and both.until == pytest.approx(math.sqrt(0.4 / G))
    assert math.isnan(both.impulses("t", "g")[0]) and math.isnan(both.at(0.4, "fly.y", "g")[0])
    raised = rigid_limit(block(0.1), RigidImpact(0.0, 5.0), duration="0.1 s").derivatives("fly.y")
    assert raised.until == 0 and "opens or closes" in raised.reason
    with pytest.raises(InputError) as error:
        rigid_limit("bouncing_ball", RigidImpact(0.5), duration="0.1 s").derivatives("weight")
    assert "weight" in str(error.value)


def test_bad_input_lists_every_fault():
    with pytest.raises(InputError) as error:
        rigid_limit(
            "bouncing_ball",
            RigidImpact(1.5, "mas", "stokes"),
            duration="1 s",
            impacts="at will",
            stiffness="K",
            factors=(3, 2),
        )
    text = str(error.value)
    for fault in ("restitution of floor", "mas", "stokes", "impacts", "factors", "K:"):
        assert fault in text
    with pytest.raises(
        InputError,
        match=r"restitution of floor: found mass, a parameter in kg; expected one without a unit: .*restitution",
    ):
        rigid_limit("bouncing_ball", RigidImpact("mass"), duration="1 s")
    with pytest.raises(InputError, match="no tangents"):
        rigid_limit("bouncing_ball", RigidImpact(0.5, 0.1), duration="1 s")
    with pytest.raises(InputError, match="floor"):
        rigid_limit("bouncing_ball", {}, duration="1 s")
    with pytest.raises(InputError, match="no contact pair"):
        rigid_limit("pendulum", RigidImpact(0.5), duration="1 s")


def test_constraints_hold_coordinates_agree_and_the_error_is_that_of_a_run_far_finer():
    times = []
    for coordinates in ("tree", "absolute"):
        run = rigid_limit(load("four_bar_clearance", coordinates=coordinates), RigidImpact(0.5), duration="2 ms")
        model, y = run.model, run.motion.y[-1]
        if coordinates == "absolute":
            phi, _ = model.evaluate("constraints", run.t[-1], y[: model.nq], y[model.nq :], run.run.equations.bound.c)
            assert np.max(np.abs(phi)) < 1e-12
        times.append([impulse.t for impulse in run.impulses])
    assert len(times[0]) > 2
    assert times[0] == pytest.approx(times[1], rel=1e-8)
    # Of a four-bar with clearance, whose impacts amplify the tolerance; not that of a run as coarse.
    coarse, finest = (
        rigid_limit("four_bar_clearance", RigidImpact(0.5), duration="8 ms", tolerance=tolerance)
        for tolerance in (1e-5, 1e-11)
    )
    end = np.max(np.abs(coarse.motion.y[-1] - finest.motion.y[-1]) / coarse.run.sizes)
    assert coarse.differences[1] == pytest.approx(end, rel=0.1)
    assert finest.differences[1] < 1e-3 * end  # the seeded fault: one that does not depend on the tolerance


@pytest.mark.slow
def test_contact_whose_force_ends_at_the_instant_of_an_event_lifts_off():
    """A pin in a slot of a Geneva wheel: the event of its force was answered at one instant for ever."""
    run = rigid_limit("geneva_drive", RigidImpact(0.5), duration="0.16 s")
    assert run.outcome.finished
    assert len(run.accumulations) > 0
