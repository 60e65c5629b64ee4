"""What derivation refuses of a scene whose declarations are sound by themselves: effects that move nothing, motions that move no mass."""

import pytest

from hertzwerk.derive import (
    GROUND,
    Body,
    BodyTorque,
    ConstantSpeed,
    Contact,
    Cylindrical,
    DCMotor,
    Direction,
    EnergyLedger,
    Friction,
    Gravity,
    JointForce,
    JointSpring,
    Mechanism,
    Parameter,
    PointForce,
    Potential,
    Prismatic,
    Revolute,
    Scales,
    Scene,
    SphereOnPlane,
    Spherical,
    X,
    Y,
    Z,
    derive,
    generate,
)
from hertzwerk.derive.common.faults import InputError
from hertzwerk.derive.laws import power, smooth_coulomb

L, MASS = Parameter("length", "m", 1.0), Parameter("mass", "kg", 1.0)
TRIPLE = tuple(Parameter(f"J_{k}", "kg m^2", 0.01) for k in "xyz")
BODY, CROSS, MORE = Body("body", MASS, TRIPLE), Body("cross", 0), Body("more", 0)
GRAVITY = Gravity("gravity", Parameter("gravity", "m/s^2", 9.81), -Y)
FORCE, TORQUE, STIFFNESS = (
    Parameter("push_in", "N", 2),
    Parameter("twist_in", "N m", 3),
    Parameter("spring_in", "N/m", 4),
)
SPEED = Parameter("pace", "m/s", 1.0)


def scene(*joints, effects=(), pairs=()):
    return Scene(Mechanism("tried", joints, pairs), tuple(effects), Scales(length=L, speed=SPEED, arm=L))


def refused(*joints, **options):
    with pytest.raises(InputError) as caught:
        derive(scene(*joints, **options))
    return {fault.where: fault for fault in caught.value.faults}


# -- effects that enter no equation ------------------------------------------------------------------------------------

TRACK = Prismatic("track", GROUND, BODY, axis=X)
BALL = SphereOnPlane("touch", BODY.at(0, 0, 0), Parameter("radius", "m", 0.1), GROUND.at(0, 0, 0), Y)
IDLE = {
    "gravity across a track": GRAVITY,
    "a force across it": PointForce("push", BODY.at(0, 0, 0), (0, FORCE, 0)),
    "a torque on what does not turn": BodyTorque("twist", BODY, (TORQUE, 0, 0)),
    "an energy that is the same everywhere": Potential("store", FORCE * L),
}


@pytest.mark.parametrize("label", IDLE)
def test_an_effect_that_moves_nothing_is_refused(label):
    effect = IDLE[label]
    found = refused(TRACK, effects=(effect, EnergyLedger()))
    (fault,) = found.values()
    assert fault.where == f"effect {effect.name}"
    assert fault.found == "no equation that it enters"
    assert "cannot move that way" in fault.expected
    assert f"scene.without('{effect.name}')" in fault.remedy


def test_all_of_them_are_named_and_the_others_are_not():
    spring = JointSpring("spring", "track", STIFFNESS)
    found = refused(TRACK, effects=(*IDLE.values(), spring, EnergyLedger()))
    assert list(found) == ["effect gravity", "effect push", "effect twist", "effect store"]
    derive(scene(TRACK, effects=(spring, EnergyLedger())))


def test_contacts_and_friction_must_act_on_what_can_move():
    """On the plane the ball of a track across it slides but never presses more or less; up and down it presses and cannot slide."""
    touch = Contact("touch", power(Parameter("K", "N/m^1.5", 1e8), 1.5))
    rub = Friction("rub", "touch", smooth_coulomb(mu=Parameter("mu", "1", 0.2), v_s=Parameter("slow", "m/s", 1e-3)))
    across = Prismatic("lift", GROUND, BODY, axis=Y)
    assert set(refused(TRACK, effects=(touch,), pairs=(BALL,))) == {"effect touch"}
    assert set(refused(across, effects=(touch, rub), pairs=(BALL,))) == {"effect rub"}
    derive(scene(TRACK, effects=(touch, rub), pairs=(BALL,)))  # friction is what the normal force enters by
    derive(scene(across, effects=(touch,), pairs=(BALL,)))


def test_a_gap_that_is_zero_in_every_position_is_refused():
    """A ball guided at its radius above the plane: nothing ever presses, and friction would have nothing to be a part of. A little nearer it does."""
    touch = Contact("touch", power(Parameter("K", "N/m^1.5", 1e8), 1.5))
    rub = Friction("rub", "touch", smooth_coulomb(mu=Parameter("mu", "1", 0.2), v_s=Parameter("slow", "m/s", 1e-3)))
    deep = Parameter("deep", "m", 1e-5)

    def guided(height):
        return Prismatic("track", GROUND.at(0, height, 0), BODY, axis=X)

    for effects in ((touch,), (touch, rub)):
        (fault,) = refused(guided(BALL.radius), effects=effects, pairs=(BALL,)).values()
        assert fault.where == "pair touch, gap"
        assert "never changes" in fault.found
        assert "along the normal" in fault.remedy
    assert generate(scene(guided(BALL.radius - deep), effects=(touch, rub), pairs=(BALL,)))


def test_a_force_on_a_driven_joint_moves_nothing_but_is_in_the_books():
    joints = TRACK, Revolute("pin", BODY.at(L, 0, 0), Body("arm", 2 * MASS, TRIPLE, (L, 0, 0)), Z)
    effects = ConstantSpeed("drive", "track", SPEED), JointForce("push", "track", FORCE)
    (fault,) = refused(*joints, effects=effects).values()
    assert "its joint is driven" in fault.expected
    derive(scene(*joints, effects=(*effects, EnergyLedger())))


def test_a_drive_is_never_idle():
    """At a constant speed it enters no equation of motion, and yet takes a coordinate away."""
    arm = Body("arm", 2 * MASS, TRIPLE, (L, 0, 0))
    derive(scene(TRACK, Revolute("pin", BODY, arm, Z), effects=(ConstantSpeed("drive", "track", SPEED), GRAVITY)))


# -- motions that move no mass -----------------------------------------------------------------------------------------

OBLIQUE = Direction((1, 1, 0))
SINGULAR = {
    "two hinges on one axis": ((Revolute("one", GROUND, CROSS, Z), Revolute("two", CROSS, BODY, Z)), "joints one and two"),
    "two slides side by side": ((Prismatic("one", GROUND, CROSS, X), Prismatic("two", CROSS, BODY, -X)), "joints one and two"),
    "two slides along directions that are the same but for their length": (
        (Prismatic("one", GROUND, CROSS, OBLIQUE), Prismatic("two", CROSS, BODY, Direction((2, 2, 0)))), "joints one and two",
    ),
    "a hinge on the axis of a cylinder, another axis between": (
        (Cylindrical("one", GROUND, CROSS, Z), Prismatic("two", CROSS, MORE, X), Prismatic("three", MORE, BODY, Z)),
        "joints one and three",
    ),
    "a rod between two balls turns about itself": (
        (Spherical("one", GROUND, CROSS), Spherical("two", CROSS.at(L, 0, 0), BODY)), "joints one and two",
    ),
}  # fmt: skip


@pytest.mark.parametrize("label", SINGULAR)
def test_axes_that_coincide_without_a_mass_between_are_named(label):
    joints, where = SINGULAR[label]
    found = refused(*joints)
    assert where in found
    assert "axes that coincide" in found[where].found
    assert "cross" in found[where].expected
    assert "Leave one of the joints out" in found[where].remedy


def test_each_such_motion_is_a_fault():
    joints = (
        Revolute("one", GROUND, CROSS, Z),
        Revolute("two", CROSS, MORE, Z),
        Revolute("three", MORE, BODY, Z),
        Prismatic("slide", BODY, Body("last", MASS, TRIPLE), X),
    )
    assert set(refused(*joints)) == {"joints one and two", "joints one and three"}


def test_a_mass_in_between_is_no_fault():
    middle = Body("middle", MASS, TRIPLE)
    derive(scene(Revolute("one", GROUND, middle, Z), Revolute("two", middle, BODY, Z), effects=()))


def test_a_missing_axis_or_arm_is_one_fault_of_what_the_user_wrote():
    with pytest.raises(TypeError, match=r"Prismatic\.__init__\(\) missing .* 'axis'"):
        Prismatic("slide", GROUND, BODY)
    ohm, henry, volt = (Parameter(name, unit, 1) for name, unit in (("R", "ohm"), ("L_a", "H"), ("V", "V")))
    motor = DCMotor("motor", "hinge", volt, ohm, henry, Parameter("k_m", "N m/A", 1))
    with pytest.raises(InputError) as caught:
        Scene(Mechanism("driven", (Revolute("hinge", GROUND, BODY, Z),)), (motor,), Scales(L, Parameter("v", "m/s", 1)))
    assert [fault.found for fault in caught.value.faults] == ["no arm"]
