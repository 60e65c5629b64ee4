"""Every kind of effect by every method in the graph, in both coordinates, against dop853 at a tight tolerance."""

from functools import cache

import numpy as np
import pytest
import sympy as sp

import hertzwerk.derive as d
import hertzwerk.derive as hd
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.engine.integration.tableaux.methods import IN_GRAPH

pytestmark = pytest.mark.exhaustive

TOLERANCES = {"dop853": 1e-9, "dopri5": 1e-9, "auto": 1e-9, "esdirk": 1e-9, "rodas": 1e-9}
WITHIN = 2e-5  # of the largest value of a state
DURATION = 0.25


@cache
def p(name, unit, value=1.0):
    return d.Parameter(name, unit, value)


SCALES = hd.Scales(p("size", "m", 0.3), p("pace", "m/s", 1), arm=p("arm", "m", 0.3))
GRAVITY = hd.Gravity("gravity", p("g", "m/s^2", 9.81), direction=-hd.Y)
SMOOTH = hd.laws.smooth_coulomb(p("mu", "1", 0.2), p("v_s", "m/s", 0.05))


def body(name, mass=1.0):
    inertia = (p(f"J_{name}", "kg m^2", 0.02),) * 3
    return hd.Body(name, p(f"m_{name}", "kg", mass), inertia, centre=(p(f"s_{name}", "m", 0.15), 0, 0))


ARM, BOB, BLOCK = map(body, ("arm", "bob", "block"))
BALL = hd.Body("ball", p("m_ball", "kg", 0.5), (p("J_ball", "kg m^2", 5e-4),) * 3)
RADIUS = p("radius", "m", 0.05)
LIFTED = {"flight.y": p("lift", "m", 0.06)}
HOOK, TIP, SLACK = hd.GROUND.at(0, p("high", "m", 0.1), 0), BOB.at(0, 0, 0), p("slack", "m", 0.3)
TAUT = p("k", "N/m", 300) * (hd.LENGTH - SLACK) + p("c", "N s/m", 0) * hd.LENGTH_RATE
SLOW = {"speed": p("w_s", "rad/s", 0.5)}
FORCE = hd.laws.power(p("K", "N/m^1.5", 1e5), 1.5), hd.laws.hunt_crossley(p("e", "1", 0.8))
FLOOR = d.SphereOnPlane("floor", BALL.at(0, 0, 0), RADIUS, hd.GROUND.at(0, 0, 0), normal=hd.Y)


def scene(name, joints, effects, start=None, pairs=()):
    """A scene under gravity, with its ledger of energy."""
    return hd.Scene(
        hd.Mechanism(name, joints, pairs), (GRAVITY, *effects, hd.EnergyLedger()), SCALES, start or hd.Start()
    )


def crane(*effects, **start):
    """A block on a slide with a double pendulum below, in a plane."""
    joints = (
        hd.Prismatic("slide", hd.GROUND, BLOCK, axis=hd.X),
        hd.Revolute("main", BLOCK, ARM, axis=hd.Z),
        hd.Revolute("knee", ARM.at(p("l", "m", 0.3), 0, 0), BOB, axis=hd.Z),
    )
    begin = hd.Start(speed=start or {"main": p("w0", "rad/s", 3), "slide": p("v0", "m/s", 0.4)})
    return scene("crane", joints, effects, begin)


def driven(*effects):
    """The crane without the speeds that a drive has."""
    joints = (
        hd.Revolute("main", hd.GROUND, ARM, axis=hd.Z),
        hd.Revolute("knee", ARM.at(p("l", "m", 0.3), 0, 0), BOB, axis=hd.Z),
    )
    return scene("driven", joints, effects)


def hanging(*effects):
    """A body on a ball joint, in space."""
    speed = {"shoulder.angular_speed_x": p("wx", "rad/s", 2), "shoulder.angular_speed_z": p("wz", "rad/s", -3)}
    return scene("hanging", (hd.Spherical("shoulder", hd.GROUND, ARM),), effects, hd.Start(speed=speed))


def floating(*effects):
    """A free body in space."""
    start = hd.Start(speed={"flight.x_speed": p("vx", "m/s", 0.5), "flight.angular_speed_y": p("wy", "rad/s", 2)})
    return scene("floating", (hd.Free("flight", hd.GROUND, BALL),), effects, start)


def rolling(*effects):
    """A ball that falls on a floor and slides."""
    speed = {"flight.x_speed": p("vx", "m/s", 0.5), "flight.angular_speed_y": p("wy", "rad/s", 9)}
    joints, contact = (hd.Free("flight", hd.GROUND, BALL),), d.Contact("floor", *FORCE)
    return scene("rolling", joints, (contact, *effects), hd.Start(position=LIFTED, speed=speed), (FLOOR,))


def sliding(*effects):
    """A ball that falls on a floor in a plane, and slides."""
    start = hd.Start(position=LIFTED, speed={"flight.x": p("vx", "m/s", 0.5)})
    joints, contact = (d.Planar("flight", hd.GROUND, BALL, normal=hd.Z),), d.Contact("floor", *FORCE)
    return scene("sliding", joints, (contact, *effects), start, (FLOOR,))


def loose(*effects):
    """An arm that swings on its pin, loose in a bush of the ground, which wears."""
    rate, clearance = p("wear_rate", "1/Pa", 1e-7), p("clearance", "m", 0.005)
    pin, bush, width = ARM.at(0, 0, 0), hd.GROUND.at(0, 0, 0), p("width", "m", 0.02)
    effects = d.Contact("bearing", *FORCE), d.Wear("wear", "bearing", rate, rate, sectors=8), *effects
    start = hd.Start(speed={"flight.angle": p("w0", "rad/s", 3)})
    pairs = (d.PinInBush("bearing", pin, bush, hd.Z, RADIUS, clearance, width),)
    return scene("loose", (d.Planar("flight", hd.GROUND, ARM, normal=hd.Z),), effects, start, pairs)


def motor(control, *more):
    values = p("R", "ohm", 2), p("L", "H", 0.02), p("k", "N m/A", 0.5)
    return crane(d.DCMotor("servo", "main", control.command, *values), control, *more)


def controller(**given):
    gains = p("w", "rad/s", 5), p("Kp", "V s/rad", 2), p("Ki", "V/rad", 10), "V"
    return d.SpeedController("control", "main", *gains, **given)


BAND = -p("mu", "1", 0.2) * p("r", "m", 0.02)
FRAMES = BALL.at(0, 0, 0), hd.GROUND.at(0, p("high", "m", 0.1), 0)
SIX = (*[p("k", "N/m", 200)] * 3, *[p("k_t", "N m/rad", 0.2)] * 3)

CASES = {
    "gravity": lambda: crane(hd.Gravity("shaking", p("A", "m", 0.05) * p("w", "1/s", 20) ** 2 * sp.sin(p("w", "1/s", 20) * hd.T), direction=hd.X)),
    "constant_speed": lambda: driven(d.ConstantSpeed("drive", "main", p("w", "rad/s", 5))),
    "ramp": lambda: driven(d.Ramp("drive", "main", p("w", "rad/s", 5), rise=p("rise", "s", 0.1))),
    "harmonic": lambda: driven(d.Harmonic("drive", "main", p("A", "rad", 0.3), frequency=p("f", "rad/s", 20))),
    "drive_position": lambda: driven(d.Drive("drive", "main", position=p("A", "rad", 0.3) * sp.sin(p("f", "rad/s", 9) * hd.T))),
    "drive_speed": lambda: driven(d.Drive("drive", "main", speed=p("w", "rad/s", 5) * sp.cos(p("f", "rad/s", 9) * hd.T))),
    "drive_by_input": lambda: driven(d.Drive("drive", "main", position=hd.Input("push", "rad"))),
    "coupling": lambda: crane(d.Coupling("rack", "slide", "main", ratio=p("pitch", "m", 0.1)), main=p("w0", "rad/s", 3)),
    "joint_force": lambda: crane(hd.JointForce("push", "slide", hd.Input("push", "N"))),
    "point_force": lambda: crane(d.PointForce("wind", BOB.at(0, 0, 0), (p("F", "N", 3) * sp.cos(p("f", "rad/s", 9) * hd.T), 0, 0))),
    "body_torque": lambda: crane(d.BodyTorque("brake", BOB, (0, 0, p("M", "N m", 0.3)))),
    "motor_continuous": lambda: motor(controller()),
    "motor_sampled": lambda: motor(controller(period=p("Ts", "s", 0.017))),
    "motor_limited": lambda: motor(controller(limit=p("V", "V", 4))),
    "motor_sampled_limited": lambda: motor(controller(limit=p("V", "V", 4), period=p("Ts", "s", 0.017))),
    "relay": lambda: crane(hd.JointForce("jets", "slide", p("thrust", "N", 9) * RELAY.output), RELAY),
    "potential": lambda: crane(d.Potential("well", p("k", "N/m^3", 400) * hd.coordinate_of("slide") ** 4 / 4)),
    "springs": lambda: crane(hd.JointSpring("spring", "slide", p("k", "N/m", 200)), hd.JointDamper("damper", "main", p("c", "N m s/rad", 0.1))),
    "point_spring": lambda: crane(
        d.PointSpring("rope", HOOK, TIP, p("k", "N/m", 100), rest_length=p("l0", "m", 0.2)), d.PointDamper("strut", HOOK, TIP, p("c", "N s/m", 2))
    ),
    "line_force": lambda: crane(d.LineForce("cord", HOOK, TIP, d.Where(hd.LENGTH > SLACK, TAUT, 0))),
    "friction_normal": lambda: crane(d.JointFriction("drag", "slide", SMOOTH, normal_force=p("N", "N", 20))),
    "friction_journal": lambda: crane(d.JointFriction("journal", "main", SMOOTH, radius=p("r", "m", 0.02))),
    "friction_guide": lambda: crane(d.JointFriction("guiding", "slide", SMOOTH, length=p("pads", "m", 0.4))),
    "load_by_reaction": lambda: crane(hd.JointForce("band", "knee", BAND * hd.reaction_of("main") * hd.speed_of("knee") / p("w1", "rad/s", 10))),
    "belt": lambda: crane(
        d.BeltOnDrum("capstan", drum="main", load="slide", law=SMOOTH, tension=p("hold", "N", 5), radius=p("r", "m", 0.02), wrap=p("wrap", "rad", 3))
    ),
    "ball_friction": lambda: hanging(d.BallFriction("socket", "shoulder", SMOOTH, radius=p("r", "m", 0.02))),
    "spherical_spring": lambda: hanging(
        d.SphericalSpring("centring", ARM.at(0, 0, 0), hd.GROUND.at(0, 0, 0), p("k_t", "N m/rad", 2), damping=p("c_t", "N m s/rad", 0.05))
    ),
    "bushing": lambda: floating(d.Bushing("mount", *FRAMES, stiffness=SIX)),
    "frame_potential": lambda: floating(d.FramePotential("magnet", *FRAMES, -p("m_B", "J", 0.05) * hd.TURN[2][2])),
    "smooth_friction": lambda: rolling(d.Friction("rubbing", "floor", SMOOTH)),
    "resistances": lambda: rolling(
        d.Friction("rubbing", "floor", SMOOTH), d.RollingResistance("roll", "floor", coefficient=p("a", "m", 1e-3), **SLOW),
        d.DrillingResistance("drill", "floor", coefficient=p("b", "m", 1e-3), **SLOW)
    ),
    "set_valued_in_space": lambda: rolling(d.Friction("rubbing", "floor", hd.laws.coulomb(mu_k=p("mu", "1", 0.2), mu_s=p("mu_s", "1", 0.2)))),
    "set_valued": lambda: sliding(d.Friction("rubbing", "floor", hd.laws.coulomb(mu_k=p("mu", "1", 0.2), mu_s=p("mu_s", "1", 0.25)))),
    "wear": lambda: loose(d.Friction("rubbing", "bearing", SMOOTH)),
    "wear_alone": lambda: loose(),
    "wear_set_valued": lambda: loose(d.Friction("rubbing", "bearing", hd.laws.coulomb(mu_k=p("mu", "1", 0.2), mu_s=p("mu_s", "1", 0.25)))),
    "load_by_normal_force": lambda: sliding(d.PointForce("suction", BALL.at(0, 0, 0), (-p("mu", "1", 0.2) * hd.normal_force_of("floor"), 0, 0))),
}  # fmt: skip
AHEAD = hd.coordinate_of("slide") + p("lead", "s", 0.05) * hd.speed_of("slide")
RELAY = d.Relay("relay", AHEAD, unit="m", hysteresis=p("dead", "m", 0.01))


@cache
def run(name, coordinates, method, tolerance):
    model = load(CASES[name](), coordinates=coordinates)
    unit = model.inputs["push"][0] if model.inputs else ""
    t = np.linspace(0, 0.3, 13)
    inputs = {"push": d.Table("pushed", tuple(t), tuple(np.sin(9 * t)), ("s", unit))} if model.inputs else None
    return simulate(model, duration=DURATION, tolerance=tolerance, method=method, inputs=inputs, compiled=False)


@pytest.mark.parametrize("method", list(IN_GRAPH))
@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("name", CASES)
def test_an_effect(name, coordinates, method):
    try:
        expected = run(name, coordinates, "dop853", 1e-12)
    except hd.InputError as refused:
        pytest.skip(str(refused).splitlines()[-1])
    assert expected.outcome.finished and abs(expected.energy_residual) < 1e-7, expected
    actual = run(name, coordinates, method, TOLERANCES[method])
    assert actual.outcome.finished, actual
    for state in expected.engine.final:
        size = max(np.abs(expected[state]).max(), 1e-3)
        assert abs(actual.engine.final[state] - expected.engine.final[state]) <= WITHIN * size, state
    if coordinates == "absolute":
        joints = run(name, "tree", "dop853", 1e-12)
        for state in joints.engine.final:
            if state in expected.engine.model.units or state in expected.engine.final:
                assert expected.engine.final[state] == pytest.approx(
                    joints.engine.final[state], abs=WITHIN * max(np.abs(joints[state]).max(), 1e-3)
                ), state
