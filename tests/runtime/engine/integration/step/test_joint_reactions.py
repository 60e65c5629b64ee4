"""Loads that depend on what joints and contacts carry, against hand-made equations and closed forms."""

from dataclasses import replace

import numpy as np
import pytest
import sympy as sp
from scipy.integrate import solve_ivp
from scipy.optimize import brentq

import hertzwerk.derive as hd
from hertzwerk.runtime import equilibrium, load, modes, simulate

pytestmark = pytest.mark.by_turns(2)  # methods and coordinates that run the same code

G, M, J, L, R, MU, V_S = 9.81, 1.3, 0.02, 0.4, 0.06, 0.35, 1e-3
p = hd.Parameter
DOWN = hd.Gravity("gravity", p("g", "m/s^2", G), direction=-hd.Y)
RUBS = hd.laws.smooth_coulomb(p("mu", "1", MU), p("v_s", "m/s", V_S))
SCALES = hd.Scales(p("size", "m", L), p("pace", "m/s", 1), arm=p("size", "m", L))
radius = p("radius", "m", R)
BEARING = hd.JointFriction("bearing", "hinge", RUBS, radius=radius)
BOTH, METHODS = ["tree", "absolute"], ["dop853", "esdirk", "rodas", "auto"]


def pendulum(friction=BEARING, *, lift=1.2, effects=()):
    bob = hd.Body("bob", p("mass", "kg", M), inertia=p("J", "kg m^2", J), centre=(0, -p("size", "m", L), 0))
    mechanism = hd.Mechanism("journal_pendulum", (hd.Revolute("hinge", hd.GROUND, bob, axis=hd.Z),))
    start = hd.Start(position={"hinge": p("lift", "rad", lift)})
    return hd.Scene(mechanism, (DOWN, *((friction,) if friction else ()), *effects, hd.EnergyLedger()), SCALES, start)


def by_hand(lift, times):
    """Swing of a pendulum with the torque mu r |reaction| in its journal, the reaction found by bisection."""

    def slope(t, x):
        angle, w = x
        grip = MU * R * np.tanh(R * w / V_S)

        def acceleration(n):
            return (-M * G * L * np.sin(angle) - grip * n) / (J + M * L**2)

        def left(n):  # of the bob: along the rod and across it
            return n - np.hypot(M * L * w**2 + M * G * np.cos(angle), M * L * acceleration(n) + M * G * np.sin(angle))

        return [w, acceleration(brentq(left, 0, 1e4, xtol=1e-13))]

    return solve_ivp(slope, (0, times[-1]), [lift, 0], method="LSODA", rtol=1e-10, atol=1e-12, t_eval=times).y


@pytest.mark.parametrize(("coordinates", "method"), [("tree", "dop853"), ("absolute", "esdirk")])
def test_a_pendulum_in_its_journal(coordinates, method):
    run = simulate(load(pendulum().with_coordinates(coordinates)), duration=1.2, tolerance=1e-9, method=method)
    times = np.linspace(0, 1.2, 7)
    assert run.at(times)["hinge.angle"] == pytest.approx(by_hand(1.2, times)[0], abs=2e-7)
    pressed = np.hypot(run["hinge.reaction_x"], run["hinge.reaction_y"])
    torque = -MU * R * pressed * np.tanh(R * run["hinge.speed"] / V_S)
    assert run["bearing.torque"] == pytest.approx(torque, rel=1e-9, abs=1e-9)
    assert run.energy_residual < 1e-7


def test_a_reaction_in_an_expression_is_that_of_the_friction():
    drag = (
        -p("mu", "1", MU)
        * radius
        * hd.reaction_of("hinge")
        * sp.tanh(radius * hd.speed_of("hinge") / p("v_s", "m/s", V_S))
    )
    one, two = (
        simulate(load(pendulum(x)), duration=1.0, tolerance=1e-10)
        for x in (BEARING, hd.JointForce("bearing", "hinge", drag))
    )
    assert two["hinge.angle"][-1] == pytest.approx(one["hinge.angle"][-1], abs=1e-9)
    assert two["bearing.input"][-1] == pytest.approx(-one["bearing.dissipated"][-1], rel=1e-8)


ARM, LENGTH, GUIDED = 0.2, 0.1, 2.0


def guide(*, inertia=0.01, **start):
    """A block on a guide, with its mass centre an arm above it: friction turns it, and presses its pads."""
    block = hd.Body(
        "block", p("mass", "kg", GUIDED), inertia=p("J", "kg m^2", inertia), centre=(0, p("arm", "m", ARM), 0)
    )
    effects = (
        DOWN, hd.JointFriction("friction", "slide", RUBS, length=p("length", "m", LENGTH)), hd.JointForce("push", "slide", p("push", "N", 0)),
        hd.EnergyLedger(),
    )  # fmt: skip
    mechanism = hd.Mechanism("guide", (hd.Prismatic("slide", hd.GROUND, block, axis=hd.X),))
    return hd.Scene(mechanism, effects, SCALES, hd.Start(speed={"slide": p("v0", "m/s", 1)}))


def test_pads_share_force_and_moment_and_the_time_at_which_a_guide_locks_is_reported():
    """A push at the guide turns the block about its centre: pads press with m g/2 and (push - friction) arm/length."""
    run = simulate(
        load(guide()), duration=0.01, tolerance=1e-9, parameters={"mu": 0.1, "push": (10, "N"), "v0": (1, "m/s")}
    )
    weight = GUIDED * G
    brakes, *_ = (-x for x in run["friction.force"])
    lift = (10 - brakes) * ARM / LENGTH
    assert brakes == pytest.approx(0.1 * (abs(weight / 2 + lift) + abs(weight / 2 - lift)), rel=1e-9)
    # Friction grows with the speed over v_s: a push brings the guide to where mu tanh(v/v_s) = length/(2 arm).
    bound, mu, v_s, push = LENGTH / (2 * ARM), 0.3, 0.5, 40.0
    values = {"mu": mu, "v_s": (v_s, "m/s"), "push": (push, "N"), "v0": (0, "m/s")}
    run = simulate(load(guide()), duration=2.0, tolerance=1e-9, parameters=values)
    assert run.outcome.name == "friction_locks"
    assert run["slide.speed"][-1] == pytest.approx(v_s * np.arctanh(bound / mu), rel=0.1)


def test_friction_in_a_driven_joint_loads_its_drive():
    size = p("size", "m", L)
    wheel = hd.Body("wheel", p("mass", "kg", M), inertia=p("J", "kg m^2", J))
    hung = hd.Body("hung", p("hung_mass", "kg", 1), inertia=p("J", "kg m^2", J), centre=(0, -size, 0))
    joints = (
        hd.Revolute("hinge", hd.GROUND, wheel, axis=hd.Z),
        hd.Revolute("pin", wheel.at(size, 0, 0), hung, axis=hd.Z),
    )
    motor = hd.ConstantSpeed("motor", "hinge", p("w", "rad/s", 3))
    scene = hd.Scene(hd.Mechanism("driven", joints), (DOWN, motor, BEARING, hd.EnergyLedger()), SCALES)
    run = simulate(load(scene), duration=1.0, tolerance=1e-9)
    bare = simulate(load(scene.without("bearing")), duration=1.0, tolerance=1e-9)
    pressed = np.hypot(run["hinge.reaction_x"], run["hinge.reaction_y"])
    assert run["pin.angle"][-1] == pytest.approx(bare["pin.angle"][-1], abs=1e-9)
    assert run["motor.torque"][-1] - bare["motor.torque"][-1] == pytest.approx(MU * R * pressed[-1], rel=1e-6)
    assert run.energy_residual < 1e-7


@pytest.mark.parametrize("coordinates", BOTH)
def test_a_brake_by_a_normal_force(coordinates):
    """A ball that rests on a floor brakes a wheel by its normal force, and by nothing while it falls."""
    wheel = hd.Body("wheel", p("wheel_mass", "kg", 1), inertia=p("J", "kg m^2", J))
    ball = hd.Body("ball", p("mass", "kg", M))
    joints = (hd.Prismatic("fall", hd.GROUND, ball, axis=hd.Y), hd.Revolute("axle", hd.GROUND, wheel, axis=hd.Z))
    floor = hd.SphereOnPlane("floor", ball.at(0, 0, 0), radius, hd.GROUND.at(0, 0, 0), normal=hd.Y)
    brake = hd.JointForce("brake", "axle", -p("mu", "1", MU) * radius * hd.normal_force_of("floor"))
    effects = (DOWN, hd.Contact("floor", hd.laws.power(p("K", "N/m^1.5", 1e6), 1.5)), brake, hd.EnergyLedger())
    start = hd.Start(position={"fall": radius + p("height", "m", 0.05)}, speed={"axle": p("w", "rad/s", 50)})
    run = simulate(
        load(hd.Scene(hd.Mechanism("brake", joints, (floor,)), effects, SCALES, start, coordinates=coordinates)), duration=0.15, tolerance=1e-9,
    )  # fmt: skip
    touches = run.impacts[0].t
    assert run.at(np.array([touches]))["axle.speed"][0] == 50
    impulse = M * (G * 0.15 + run["fall.speed"][-1])  # of the floor: momentum of the ball
    assert 50 - run["axle.speed"][-1] == pytest.approx(MU * R * impulse / J, rel=1e-6)
    assert run.energy_residual < 1e-7


def test_rest_and_small_vibrations_under_loads_by_reactions():
    """A torque of a tenth of the reaction holds the pendulum at m g l sin(angle) = 0.1 r N with N = m g."""
    torque = p("mu", "1", MU) * radius * hd.reaction_of("hinge")
    rest = equilibrium(load(pendulum(hd.JointForce("bearing", "hinge", torque), lift=0.01)))
    assert rest["hinge.angle"][0] == pytest.approx(np.arcsin(MU * R / L), rel=1e-8)
    # Small vibrations in a journal: the smoothed law damps with c = mu r^2 m g/v_s, as `modes` finds.
    actual = modes(load(pendulum(lift=0)), parameters={"mu": 1e-3})
    stiffness, inertia, damping = M * G * L, J + M * L**2, 1e-3 * R**2 * M * G / V_S
    assert actual.damping_ratios[0] == pytest.approx(damping / (2 * np.sqrt(stiffness * inertia)), rel=1e-9)


def test_undefined_reactions_are_refused_at_once():
    ball = hd.Body("ball", p("mass", "kg", M), inertia=p("J", "kg m^2", J))
    table = hd.Mechanism("table", (hd.Planar("table", hd.GROUND, ball, normal=hd.Z),))
    with pytest.raises(hd.InputError, match="under its own reaction"):
        hd.Scene(table, (hd.JointFriction("drag", "table.x", RUBS),), SCALES)
    with pytest.raises(hd.InputError) as caught:
        hd.Scene(
            pendulum().mechanism,
            (
                replace(BEARING, name="a", length=radius),
                replace(BEARING, name="b", law=hd.laws.brown_mcphee(MU, 2 * MU, p("v_s", "m/s", V_S), p("c", "N s/m", 1), p("N_t", "N", 1))),
                hd.JointForce("c", "hinge", hd.reaction_of("hunge") * radius), hd.JointForce("d", "hinge", hd.normal_force_of("floor") * radius),
                hd.JointForce("e", "hinge", hd.reaction_of("hinge") * hd.T),
            ),
            SCALES,
        )  # fmt: skip
    assert {fault.where.split(",")[0] for fault in caught.value.faults} == {f"effect {name}" for name in "abcde"}
    with pytest.raises(hd.InputError, match="linear"):
        load(pendulum(hd.JointForce("bearing", "hinge", radius * hd.reaction_of("hinge") ** 2 / p("F", "N", 1))))
    with pytest.raises(hd.InputError, match="length of the guide"):
        hd.Scene(guide().mechanism, (hd.JointFriction("friction", "slide", RUBS),), SCALES)
    ball = hd.Body("ball", p("mass", "kg", M), inertia=(p("J", "kg m^2", J),) * 3)
    wheel = hd.Body("wheel", p("mass", "kg", M), inertia=p("J", "kg m^2", J))
    joints = (hd.Free("fly", hd.GROUND, ball), hd.Revolute("hinge", hd.GROUND, wheel, axis=hd.Z))
    floor = hd.SphereOnPlane("floor", ball.at(0, 0, 0), radius, hd.GROUND.at(0, 0, 0), normal=hd.Y)
    sticks = (
        hd.Contact("floor", hd.laws.power(p("K", "N/m^1.5", 1e6), 1.5)),
        hd.Friction("grip", "floor", hd.laws.coulomb(MU, MU)),
    )
    with pytest.raises(hd.InputError, match="set-valued, in several directions beside loads"):
        load(hd.Scene(hd.Mechanism("sticks", joints, (floor,)), (DOWN, *sticks, BEARING), SCALES))


@pytest.mark.parametrize("coordinates", BOTH)
def test_a_guide_is_pressed_across_the_plane_too(coordinates):
    """Weight across the plane of motion; the mass centre beside the guide: friction F turns the block by F arm about Z."""
    effects = [replace(e, direction=-hd.Z) if e is DOWN else e for e in guide().effects]
    scene = replace(guide(), effects=tuple(effects), coordinates=coordinates)
    run = simulate(load(scene), duration=0.1, tolerance=1e-10, parameters={"mu": 0.1})

    def left(
        brakes,
    ):  # weight shared, and the moments of friction about Z and of the weight about X, which no pad carries
        return brakes - 2 * 0.1 * np.hypot(GUIDED * G / 2, brakes * ARM / LENGTH)

    assert -run["friction.force"][0] == pytest.approx(brentq(left, 0, 100), rel=1e-9)
    assert run.energy_residual < 1e-12


def test_a_guide_in_a_turning_body():
    """A ring on a spoke that turns steadily: it is pressed by 2 m w v, shared by its pads."""
    spoke, ring = (
        hd.Body("spoke", p("spoke_mass", "kg", 1), inertia=p("J", "kg m^2", J)),
        hd.Body("ring", p("mass", "kg", M), inertia=p("J", "kg m^2", J)),
    )
    joints = (hd.Revolute("hub", hd.GROUND, spoke, axis=hd.Z), hd.Prismatic("slide", spoke, ring, axis=hd.X))
    effects = (
        hd.ConstantSpeed("motor", "hub", p("w", "rad/s", 5)),
        hd.JointFriction("friction", "slide", RUBS, length=p("length", "m", LENGTH)),
        hd.EnergyLedger(),
    )
    start = hd.Start(position={"slide": p("x0", "m", 0.1)}, speed={"slide": p("v0", "m/s", 0.2)})
    scene = hd.Scene(hd.Mechanism("spoke", joints), effects, SCALES, start)
    run = simulate(load(scene), duration=0.3, tolerance=1e-10)
    root, grip = np.sqrt(MU**2 + 1) * 5, MU * 5  # x'' = w^2 x - 2 mu w x'
    (a, b), t = np.linalg.solve([[1, 1], [root - grip, -root - grip]], [0.1, 0.2]), run.t
    assert run["slide.travel"] == pytest.approx(
        a * np.exp((root - grip) * t) + b * np.exp((-root - grip) * t), abs=1e-8
    )
    assert run.energy_residual < 1e-9
    with pytest.raises(hd.InputError, match="guide on a moving body"):
        load(scene.with_coordinates("absolute"))
