"""Set-valued friction of joints under their own reaction, and of contacts beside loads by reactions, from both sides of thresholds."""

from dataclasses import replace
from itertools import product

import casadi as ca
import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.runtime import equilibrium, load, modes, simulate
from hertzwerk.runtime.engine.integration.friction.uniqueness import bound, monotone, pivots

G, M, J, L, R = 9.81, 1.3, 0.02, 0.4, 0.06
p = hd.Parameter
DOWN = hd.Gravity("gravity", p("g", "m/s^2", G), direction=-hd.Y)
SCALES = hd.Scales(p("size", "m", L), p("pace", "m/s", 1), arm=p("size", "m", L))
DRY = hd.laws.coulomb(mu_k=p("mu", "1", 0.2), mu_s=p("mu_s", "1", 0.2))
radius, length = p("radius", "m", R), p("length", "m", 0.1)
BOTH = ["tree", "absolute"]
METHODS, REFERENCES = ["dop853", "dopri5", "esdirk", "rodas", "auto"], ["cvodes", "idas"]


def mu(value, static=None, **others):
    return {"mu": value, "mu_s": value if static is None else static, **others}


def pendulum(law=DRY):
    bob = hd.Body("bob", p("mass", "kg", M), inertia=p("J", "kg m^2", J), centre=(0, -p("size", "m", L), 0))
    effects = (DOWN, hd.JointFriction("bearing", "hinge", law, radius=radius), hd.EnergyLedger())
    start = hd.Start(position={"hinge": p("lift", "rad", 0.05)})
    return hd.Scene(
        hd.Mechanism("dry_pendulum", (hd.Revolute("hinge", hd.GROUND, bob, axis=hd.Z),)), effects, SCALES, start
    )


def guide(*effects, arm=0.2):
    """A block on two pads, its mass centre an arm above them."""
    block = hd.Body("block", p("mass", "kg", 2), inertia=p("J", "kg m^2", J), centre=(0, p("arm", "m", arm), 0))
    rubs = hd.JointFriction("rubs", "slide", DRY, length=length)
    start = hd.Start(speed={"slide": p("v0", "m/s", 1)})
    mechanism = hd.Mechanism("dry_guide", (hd.Prismatic("slide", hd.GROUND, block, axis=hd.X),))
    return hd.Scene(mechanism, (DOWN, rubs, *effects, hd.EnergyLedger()), SCALES, start)


@pytest.mark.parametrize(
    ("method", "coordinates"), [*product(METHODS, BOTH), *((method, "tree") for method in REFERENCES)]
)
@pytest.mark.by_turns(7)
def test_a_swing_loses_as_much_in_every_half(method, coordinates):
    """Torque mu r m g moves the middle by mu r/l, so that each half swing loses 2 mu r/l; it rests within a dead zone.

    Of SUNDIALS' methods local errors add up: energy is open by 4e-6 at 1e-8, in absolute coordinates by 3e-4.
    """
    model, lost = load(pendulum().with_coordinates(coordinates)), 2 * 0.05 * R / L
    tolerance = 1e-10 if method in REFERENCES else 1e-8
    run = simulate(model, duration=4.0, tolerance=tolerance, method=method, parameters=mu(0.05))
    turns = np.flatnonzero(np.diff(run["bearing.slip"])) + 1
    swings = np.abs(np.append(0.05, run["hinge.angle"][turns]))
    assert run.outcome.name == "finished"
    assert np.diff(swings) == pytest.approx(np.full(len(turns), -lost), rel=1e-2)  # up to squares of the angle
    assert run["bearing.slip"][-1] == 0
    assert swings[-1] < lost / 2
    assert run["hinge.angle"][-1] == pytest.approx(run["hinge.angle"][turns[-1]], abs=1e-15)  # nothing creeps
    assert run["bearing.torque"][-1] == pytest.approx(M * G * L * np.sin(run["hinge.angle"][-1]), rel=1e-9)
    assert run.energy_residual < 1e-6


def test_the_circle_of_friction_and_the_smooth_law_converges_to_it():
    """It holds up to sin(angle) = mu_s r/l, and slides back under mu_k, by the resultant reaction."""
    model, limit = load(pendulum()), np.arcsin(0.35 * R / L)
    held, freed = (
        simulate(model, duration=0.3, tolerance=1e-9, parameters=mu(0.2, 0.35, lift=(share * limit, "rad")))
        for share in (1 - 1e-6, 1 + 1e-6)
    )
    assert held["hinge.angle"][-1] == pytest.approx(held["hinge.angle"][0], abs=1e-15)
    assert freed["bearing.slip"][0] == -1
    pressed = np.hypot(freed["hinge.reaction_x"], freed["hinge.reaction_y"])
    assert freed["bearing.friction_force"] == pytest.approx(0.2 * pressed, rel=1e-9)
    model = load(pendulum(hd.laws.smooth_coulomb(p("mu", "1", 0.2), p("v_s", "m/s", 1e-3))))

    def end(model, **given):
        options = {"duration": 1.5, "tolerance": 1e-9, "parameters": {"lift": (1.2, "rad"), **given}}
        return simulate(model, **options)["hinge.angle"][-1]

    exact = end(load(pendulum()))
    error = [abs(end(model, v_s=(v, "m/s")) - exact) for v in (1e-2, 1e-3, 1e-4)]
    assert error[0] > 3 * error[1] > 9 * error[2]
    assert error[2] < 1e-5


@pytest.mark.parametrize("coordinates", BOTH)
def test_a_guide_brakes_to_rest_up_to_where_it_locks(coordinates):
    """By mu g to rest after v^2/(2 mu g), while mu < length/(2 arm); from there on no deceleration balances its pads (Painleve)."""
    model, limit = load(guide().with_coordinates(coordinates)), 0.1 / (2 * 0.2)
    for share in (0.5, 1 - 1e-6):
        run = simulate(model, duration=1.0, tolerance=1e-9, parameters=mu(share * limit))
        assert run["slide.travel"][-1] == pytest.approx(1 / (2 * share * limit * G), rel=1e-9)
        assert run["rubs.slip"][-1] == 0
        assert run["rubs.dissipated"][-1] == pytest.approx(2 * 1 / 2, rel=1e-9)
        assert run.energy_residual < 1e-12
    run = simulate(model, duration=1.0, tolerance=1e-9, parameters=mu((1 + 1e-6) * limit))
    assert (run.outcome.name, run["slide.speed"][-1]) == ("friction_locks", 1)
    assert "slide" in run.outcome.message
    # at rest the coefficient of rest counts: it is told where it stops, not before
    stops = simulate(model, duration=1.0, tolerance=1e-9, parameters=mu(0.5 * limit, 1.01 * limit))
    assert stops.outcome.name == "friction_locks"
    assert stops["slide.travel"][-1] == pytest.approx(1 / (limit * G), rel=1e-6)


def test_a_drawer_jams_whatever_pulls_it_and_a_wedge_locks_itself():
    """A pull F at an offset h presses two pads of length L with F h/L each: it jams for mu > L/(2 h), however strong F is."""
    drawer = hd.Body("drawer", p("mass", "kg", 2), inertia=p("J", "kg m^2", J))
    pull = hd.PointForce("pull", drawer.at(0, p("offset", "m", 0.2), 0), (p("F", "N", 1), 0, 0))
    rubs = hd.JointFriction("rubs", "slide", DRY, length=length)
    model = load(
        hd.Scene(
            hd.Mechanism("drawer", (hd.Prismatic("slide", hd.GROUND, drawer, axis=hd.X),)), (pull, rubs, hd.EnergyLedger()), SCALES,
        )
    )  # fmt: skip
    limit = 0.1 / (2 * 0.2)
    for force in (1e-3, 1e4):
        jams = simulate(model, duration=0.1, tolerance=1e-9, parameters=mu((1 + 1e-6) * limit, F=(force, "N")))
        assert jams["slide.travel"][-1] == 0
        assert jams["rubs.friction_force"][-1] == pytest.approx(-force, rel=1e-12)
        slides = simulate(model, duration=0.1, tolerance=1e-9, parameters=mu(0.9 * limit, F=(force, "N")))
        assert slides["slide.acceleration"] == pytest.approx(0.1 * force / 2, rel=1e-9)
    # A load on a wedge of angle alpha holds for tan(alpha) <= mu; else it goes down with g (sin - mu cos).
    block = hd.Body("block", p("mass", "kg", 2), inertia=p("J", "kg m^2", J))
    slope = hd.Prismatic("slide", hd.GROUND.at(0, 0, 0).turned(hd.Z, p("alpha", "rad", 0.3)), block, axis=hd.X)
    model = load(
        hd.Scene(
            hd.Mechanism("wedge", (slope,)), (DOWN, hd.JointFriction("rubs", "slide", DRY, length=length), hd.EnergyLedger()), SCALES,
        )
    )  # fmt: skip
    for share, moves in ((1 + 1e-9, 0), (1 - 1e-6, 1e-6 * G * np.sin(0.3)), (0.5, 0.5 * G * np.sin(0.3))):
        run = simulate(model, duration=0.1, tolerance=1e-9, parameters=mu(share * np.tan(0.3)))
        assert run["slide.acceleration"][-1] == pytest.approx(-moves, rel=1e-6, abs=1e-15)


def rod():
    """A uniform rod of length 2 a whose lower end slides along a rough straight guide, both ways pressed."""
    a, m = p("a", "m", 0.5), p("m", "kg", 1)
    foot, bar = hd.Body("foot", 0), hd.Body("bar", m, inertia=m * a**2 / 3, centre=(a, 0, 0))
    joints = hd.Prismatic("slide", hd.GROUND, foot, axis=hd.X), hd.Revolute("toe", foot, bar, axis=hd.Z)
    effects = DOWN, hd.JointFriction("rough", "slide", DRY, length=length), hd.EnergyLedger()
    start = hd.Start(position={"toe": p("theta", "rad", np.arctan(2.0))}, speed={"slide": p("v0", "m/s", 1)})
    return hd.Scene(hd.Mechanism("rod", joints), effects, SCALES, start)


@pytest.mark.parametrize("coordinates", BOTH)
@pytest.mark.parametrize("way", [1, -1])
@pytest.mark.by_turns(2)
def test_painleves_rod(coordinates, way):
    """1 + 3 cos^2 = 3 mu sin cos: mu = 4/3 at tan(theta) = 2 is the least critical one. Below, accelerations by hand."""
    model, theta = load(rod().with_coordinates(coordinates)), np.arctan(2.0)
    for share, outcome in ((1 - 1e-6, "finished"), (1 + 1e-6, "friction_locks")):
        run = simulate(model, duration=1e-4, tolerance=1e-8, parameters=mu(share * 4 / 3, v0=(way, "m/s")))
        assert run.outcome.name == outcome
    for angle in (0.9 * theta, 1.1 * theta):
        critical = (1 + 3 * np.cos(angle) ** 2) / (3 * np.sin(angle) * np.cos(angle))
        values = mu(4 / 3 * (1 + 1e-6), v0=(way, "m/s"), theta=(angle, "rad"))
        assert critical > 4 / 3 * (1 + 1e-6)
        assert simulate(model, duration=1e-6, tolerance=1e-8, parameters=values).outcome.name == "finished"
    s, c, rubs, a = np.sin(theta), np.cos(theta), -0.5 * way, 0.5
    left = [[1, -a * s, -rubs], [0, a * c, -1], [0, a**2 / 3, a * c - rubs * a * s]]
    by_hand = np.linalg.solve(left, [0, -G, 0])
    run = simulate(model, duration=1e-6, tolerance=1e-8, parameters=mu(0.5, v0=(way, "m/s")))
    assert [run["slide.acceleration"][0], run["toe.acceleration"][0]] == pytest.approx(by_hand[:2], rel=1e-9)
    assert run["rough.friction_force"][0] == pytest.approx(rubs * by_hand[2], rel=1e-9)


def post(feeds, *, box=False):
    """A cart with a post, on which a foot stands on the floor: the cart is loaded by `feeds` |force of the post|."""
    cart, foot = hd.Body("cart", p("cart_mass", "kg", 2)), hd.Body("foot", p("mass", "kg", 1))
    joints = hd.Prismatic("slide", hd.GROUND, cart, axis=hd.X), hd.Prismatic("post", cart, foot, axis=hd.Y)
    ground, place = hd.GROUND.at(0, 0, 0), foot.at(0, 0, 0)
    stands = (
        hd.BoxOnPlane("floor", place, 2 * radius, 2 * radius, ground, normal=hd.Y)
        if box
        else hd.SphereOnPlane("floor", place, radius, ground, normal=hd.Y)
    )
    effects = (
        DOWN, hd.Contact("floor", hd.laws.power(p("K", "N/m^1.5", 1e6), 1.5), hd.laws.flores(e=p("e", "1", 0.3))),
        hd.Friction("grip", "floor", hd.laws.coulomb(mu_k=p("mu", "1", 0.4), mu_s=p("mu_s", "1", 0.4))),
        hd.JointForce("push", "slide", p("push", "N", 3)), hd.JointForce("fed", "slide", feeds * p("k", "1", 0.5) * hd.reaction_of("post")),
        hd.EnergyLedger(),
    )  # fmt: skip
    deep = (G / (2 if box else 1) / 1e6) ** (2 / 3)
    start = hd.Start(position={"post": radius - p("sink", "m", deep)})
    return load(hd.Scene(hd.Mechanism("post", joints, (stands,)), effects, SCALES, start))


@pytest.mark.parametrize("box", [False, pytest.param(True, marks=pytest.mark.exhaustive)])
def test_a_contact_sticks_beside_a_load_by_what_it_holds(box):
    """A push P against k times the post's force is held to P = (1 + k) mu m g; two corners share it. Beyond, it slides."""
    model, most = post(-1, box=box), 1.5 * 0.4 * G
    pairs = model.pairs[:2]
    held, freed = (
        simulate(model, duration=0.1, tolerance=1e-8, parameters={"push": (share * most, "N")})
        for share in (0.999, 1.001)
    )
    assert sum(held[f"{pair}.friction_force"][-1] for pair in pairs) == pytest.approx(0.999 * most / 1.5, rel=1e-9)
    assert held["slide.speed"][-1] == pytest.approx(0, abs=1e-12)
    by_hand = (1.001 * most - 1.5 * 0.4 * G) / (2 + 1.5)  # of the cart 2 a = P - 1.5 N, of the foot a = N - mu g
    assert freed["slide.acceleration"][-1] == pytest.approx(by_hand, rel=1e-3)
    assert held.energy_residual < 1e-4


def test_a_load_that_frees_what_holds_it_is_reported():
    """Helped by k times what the post holds, a push of P needs P/(1 - k): from k = 1 on nothing, or more than one force, is in balance."""
    model = post(1)
    run = simulate(model, duration=0.02, tolerance=1e-8, parameters={"push": (1e-4, "N"), "k": 0.999})
    assert abs(run["floor.friction_force"][-1]) == pytest.approx(1e-4 / (1 - 0.999), rel=1e-9)
    beyond = simulate(model, duration=0.02, tolerance=1e-8, parameters={"push": (1e-4, "N"), "k": 1.001})
    assert beyond.outcome.name == "friction_locks"
    assert "floor" in beyond.outcome.message


def test_under_a_declared_normal_force():
    """On a spring it loses 2 mu N/k in every half swing, and stops where mu_s N holds it."""
    block = hd.Body("block", p("mass", "kg", 2))
    rubs = hd.JointFriction("rubs", "slide", DRY, normal_force=p("N", "N", 10))
    effects = rubs, hd.JointSpring("spring", "slide", p("k", "N/m", 50)), hd.EnergyLedger()
    start = hd.Start(position={"slide": p("x0", "m", 0.5)})
    scene = hd.Scene(
        hd.Mechanism("block", (hd.Prismatic("slide", hd.GROUND, block, axis=hd.X),)), effects, SCALES, start
    )
    run = simulate(load(scene), duration=4.0, tolerance=1e-9, parameters=mu(0.3, 0.4))
    turns = np.flatnonzero(np.diff(run["rubs.slip"])) + 1
    assert run["slide.travel"][turns] == pytest.approx([-0.38, 0.26, -0.14, 0.02], abs=1e-8)
    assert run["slide.travel"][-1] == pytest.approx(0.02, abs=1e-8)
    assert run.energy_residual < 1e-9


def two_journals():
    size = p("size", "m", L)
    one, two = (
        hd.Body(name, p(f"{name}_mass", "kg", m), inertia=p("J", "kg m^2", J), centre=(size / 2, 0, 0))
        for name, m in (("one", 1), ("two", 2))
    )
    joints = hd.Revolute("hinge", hd.GROUND, one, axis=hd.Z), hd.Revolute("elbow", one.at(size, 0, 0), two, axis=hd.Z)
    first = hd.JointFriction("first", "hinge", DRY, radius=radius)
    effects = DOWN, first, replace(first, name="second", joint="elbow"), hd.EnergyLedger()
    return hd.Scene(hd.Mechanism("two_journals", joints), effects, SCALES)


@pytest.mark.parametrize("coordinates", [pytest.param("absolute", marks=pytest.mark.exhaustive), "tree"])
def test_two_frictions_feed_each_other(coordinates):
    """Friction holds a joint's acceleration. In a tree its speed is a state, and zero; in absolute coordinates it is a difference of
    two, each off by a tolerance of its scale a step: .06 to .13 tolerances at 1e-7, 1e-9 and 1e-11, zero as sticking begins.
    """
    tolerance = 1e-9
    run = simulate(load(two_journals().with_coordinates(coordinates)), duration=1.0, tolerance=tolerance)
    steps = int(np.sum(run["second.slip"] == 0))
    speed = (
        1e-12
        if coordinates == "tree"
        else 2 * steps * tolerance * run.engine.scales.scene[1] / run.engine.scales.scene[0]
    )
    for joint, name in (("hinge", "first"), ("elbow", "second")):
        pressed, slip = np.hypot(run[f"{joint}.reaction_x"], run[f"{joint}.reaction_y"]), run[f"{name}.slip"]
        force, slides = run[f"{name}.friction_force"], slip != 0
        assert force[slides] == pytest.approx(-0.2 * (slip * pressed)[slides], abs=1e-7)
        assert np.all(np.abs(force) <= 0.2 * pressed + 1e-6)
        assert np.all(slides | (np.abs(run[f"{joint}.speed"]) < speed))
    assert run.energy_residual < 1e-8


def test_derivatives_through_it_and_small_vibrations_of_what_sticks_and_slides():
    """Against differences of runs that stop twice and rest."""
    model, steps = load(pendulum()), {"mu": 1e-5, "lift": 1e-5}
    at = {"mu": 0.05, "lift": 0.05}

    def run(**change):
        values = {name: value + change.get(name, 0.0) for name, value in at.items()}
        return simulate(model, duration=3.0, tolerance=1e-11, parameters=mu(values["mu"], lift=(values["lift"], "rad")))

    derivatives = run().sensitivities(*at)
    assert derivatives.until == 3
    for name, h in steps.items():
        above, below = run(**{name: h}), run(**{name: -h})
        for history in ("hinge.angle", "bearing.dissipated"):
            slope = (above[history][-1] - below[history][-1]) / (2 * h)
            assert derivatives[history, name][-1] == pytest.approx(slope, rel=1e-5), (history, name)
    run = simulate(load(pendulum()), duration=3.0, tolerance=1e-9, parameters=mu(0.05))
    assert len(modes(run, at=0.3).frequencies) == 1
    assert not len(modes(run, at=3.0).frequencies)
    with pytest.raises(hd.InputError, match="wherever they stop"):
        equilibrium(load(pendulum()))


def test_unsupported_friction_is_refused_by_name():
    bob = hd.Body("bob", p("mass", "kg", M), inertia=p("J", "kg m^2", J))
    ball = hd.Body("ball", p("mass", "kg", M), inertia=(p("J", "kg m^2", J),) * 3)
    with pytest.raises(hd.InputError, match="law coulomb"):
        hd.Scene(
            hd.Mechanism("ball", (hd.Spherical("socket", hd.GROUND, ball),)), (hd.BallFriction("rubs", "socket", DRY, radius),), SCALES,
        )  # fmt: skip
    driven = (
        hd.ConstantSpeed("motor", "hinge", p("w", "rad/s", 1)),
        hd.JointFriction("bearing", "hinge", DRY, radius=radius),
    )
    with pytest.raises(hd.InputError, match="which is driven"):
        hd.Scene(hd.Mechanism("driven", (hd.Revolute("hinge", hd.GROUND, bob, axis=hd.Z),)), driven, SCALES)


def test_the_bound_of_uniqueness():
    """Of one joint it is mu |dN/dT| < 1; of one contact what loads change of its acceleration, less than all."""

    def least(*given):
        return float(ca.DM(ca.evalf(ca.mmin(pivots(bound(*(ca.SX(ca.DM(x)) for x in given)))))))

    for value, sign in ((0.499, 1), (0.501, -1)):
        assert np.sign(least([1], [[3]], [[0]], [[value]], [[2]], [[0]])) == sign
        assert np.sign(least([1], [[2]], [[4 * value]], [[0]], [[1]], [[0]])) == sign
    for load_, sign in ((0.249, 1), (0.251, -1)):
        actual = monotone(ca.SX(4 * load_), ca.SX(0.5), ca.SX(0.5))
        assert np.sign(float(ca.DM(ca.evalf(actual)))) == sign
