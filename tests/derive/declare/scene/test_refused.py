"""What derivation refuses of a scene whose declarations are sound by themselves: effects that move nothing, motions that move no mass."""

import pytest

import hertzwerk.derive as hd
from hertzwerk.derive.common.faults import InputError
from hertzwerk.derive.laws import power, smooth_coulomb

L, MASS = hd.Parameter("length", "m", 1.0), hd.Parameter("mass", "kg", 1.0)
TRIPLE = tuple(hd.Parameter(f"J_{k}", "kg m^2", 0.01) for k in "xyz")
BODY, CROSS, MORE = hd.Body("body", MASS, TRIPLE), hd.Body("cross", 0), hd.Body("more", 0)
GRAVITY = hd.Gravity("gravity", hd.Parameter("gravity", "m/s^2", 9.81), -hd.Y)
FORCE, TORQUE, STIFFNESS = (
    hd.Parameter("push_in", "N", 2), hd.Parameter("twist_in", "N m", 3), hd.Parameter("spring_in", "N/m", 4),
)  # fmt: skip
SPEED = hd.Parameter("pace", "m/s", 1.0)


def scene(*joints, effects=(), pairs=()):
    return hd.Scene(hd.Mechanism("tried", joints, pairs), tuple(effects), hd.Scales(length=L, speed=SPEED, arm=L))


def refused(*joints, **options):
    with pytest.raises(InputError) as caught:
        hd.derive(scene(*joints, **options))
    return {fault.where: fault for fault in caught.value.faults}


# -- effects that enter no equation ------------------------------------------------------------------------------------

TRACK = hd.Prismatic("track", hd.GROUND, BODY, axis=hd.X)
BALL = hd.SphereOnPlane("touch", BODY.at(0, 0, 0), hd.Parameter("radius", "m", 0.1), hd.GROUND.at(0, 0, 0), hd.Y)
IDLE = {
    "gravity across a track": GRAVITY,
    "a force across it": hd.PointForce("push", BODY.at(0, 0, 0), (0, FORCE, 0)),
    "a torque on what does not turn": hd.BodyTorque("twist", BODY, (TORQUE, 0, 0)),
    "an energy that is the same everywhere": hd.Potential("store", FORCE * L),
}


@pytest.mark.parametrize("label", IDLE)
def test_an_effect_that_moves_nothing_is_refused(label):
    effect = IDLE[label]
    actual = refused(TRACK, effects=(effect, hd.EnergyLedger()))
    (fault,) = actual.values()
    assert fault.where == f"effect {effect.name}"
    assert fault.found == "no equation that it enters"
    assert "cannot move that way" in fault.expected
    assert f"scene.without('{effect.name}')" in fault.remedy


def test_all_of_them_are_named_and_the_others_are_not():
    spring = hd.JointSpring("spring", "track", STIFFNESS)
    result = refused(TRACK, effects=(*IDLE.values(), spring, hd.EnergyLedger()))
    assert list(result) == ["effect gravity", "effect push", "effect twist", "effect store"]
    hd.derive(scene(TRACK, effects=(spring, hd.EnergyLedger())))


def test_contacts_and_friction_must_act_on_what_can_move():
    """On the plane the ball of a track across it slides but never presses more or less; up and down it presses and cannot slide."""
    touch = hd.Contact("touch", power(hd.Parameter("K", "N/m^1.5", 1e8), 1.5))
    rub = hd.Friction(
        "rub", "touch", smooth_coulomb(mu=hd.Parameter("mu", "1", 0.2), v_s=hd.Parameter("slow", "m/s", 1e-3))
    )
    across = hd.Prismatic("lift", hd.GROUND, BODY, axis=hd.Y)
    assert set(refused(TRACK, effects=(touch,), pairs=(BALL,))) == {"effect touch"}
    assert set(refused(across, effects=(touch, rub), pairs=(BALL,))) == {"effect rub"}
    hd.derive(scene(TRACK, effects=(touch, rub), pairs=(BALL,)))  # friction is what the normal force enters by
    hd.derive(scene(across, effects=(touch,), pairs=(BALL,)))


def test_a_gap_that_is_zero_in_every_position_is_refused():
    """A ball guided at its radius above the plane: nothing ever presses, and friction would have nothing to be a part of. A little nearer it does."""
    touch = hd.Contact("touch", power(hd.Parameter("K", "N/m^1.5", 1e8), 1.5))
    rub = hd.Friction(
        "rub", "touch", smooth_coulomb(mu=hd.Parameter("mu", "1", 0.2), v_s=hd.Parameter("slow", "m/s", 1e-3))
    )
    deep = hd.Parameter("deep", "m", 1e-5)

    def guided(height):
        return hd.Prismatic("track", hd.GROUND.at(0, height, 0), BODY, axis=hd.X)

    for effects in ((touch,), (touch, rub)):
        (fault,) = refused(guided(BALL.radius), effects=effects, pairs=(BALL,)).values()
        assert fault.where == "pair touch, gap"
        assert "never changes" in fault.found
        assert "along the normal" in fault.remedy
    assert hd.generate(scene(guided(BALL.radius - deep), effects=(touch, rub), pairs=(BALL,)))


def test_a_drive_is_never_idle_and_a_force_on_its_joint_is_in_the_books():
    joints = TRACK, hd.Revolute("pin", BODY.at(L, 0, 0), hd.Body("arm", 2 * MASS, TRIPLE, (L, 0, 0)), hd.Z)
    effects = hd.ConstantSpeed("drive", "track", SPEED), hd.JointForce("push", "track", FORCE)
    (fault,) = refused(*joints, effects=effects).values()
    assert "its joint is driven" in fault.expected
    hd.derive(scene(*joints, effects=(*effects, hd.EnergyLedger())))
    # At a constant speed it enters no equation of motion, and yet takes a coordinate away.
    arm = hd.Body("arm", 2 * MASS, TRIPLE, (L, 0, 0))
    hd.derive(
        scene(TRACK, hd.Revolute("pin", BODY, arm, hd.Z), effects=(hd.ConstantSpeed("drive", "track", SPEED), GRAVITY))
    )


# -- motions that move no mass -----------------------------------------------------------------------------------------

OBLIQUE = hd.Direction((1, 1, 0))
SINGULAR = {
    "two hinges on one axis": ((hd.Revolute("one", hd.GROUND, CROSS, hd.Z), hd.Revolute("two", CROSS, BODY, hd.Z)), "joints one and two"),
    "two slides side by side": ((hd.Prismatic("one", hd.GROUND, CROSS, hd.X), hd.Prismatic("two", CROSS, BODY, -hd.X)), "joints one and two"),
    "two slides along directions that are the same but for their length": (
        (hd.Prismatic("one", hd.GROUND, CROSS, OBLIQUE), hd.Prismatic("two", CROSS, BODY, hd.Direction((2, 2, 0)))), "joints one and two",
    ),
    "a hinge on the axis of a cylinder, another axis between": (
        (hd.Cylindrical("one", hd.GROUND, CROSS, hd.Z), hd.Prismatic("two", CROSS, MORE, hd.X), hd.Prismatic("three", MORE, BODY, hd.Z)),
        "joints one and three",
    ),
    "a rod between two balls turns about itself": (
        (hd.Spherical("one", hd.GROUND, CROSS), hd.Spherical("two", CROSS.at(L, 0, 0), BODY)), "joints one and two",
    ),
}  # fmt: skip


@pytest.mark.parametrize("label", SINGULAR)
def test_axes_that_coincide_without_a_mass_between_are_named(label):
    joints, where = SINGULAR[label]
    actual = refused(*joints)
    assert where in actual
    assert "axes that coincide" in actual[where].found
    assert "cross" in actual[where].expected
    assert "Leave one of the joints out" in actual[where].remedy


def test_each_such_motion_is_a_fault_and_a_mass_in_between_is_none():
    joints = (
        hd.Revolute("one", hd.GROUND, CROSS, hd.Z), hd.Revolute("two", CROSS, MORE, hd.Z), hd.Revolute("three", MORE, BODY, hd.Z),
        hd.Prismatic("slide", BODY, hd.Body("last", MASS, TRIPLE), hd.X),
    )  # fmt: skip
    assert set(refused(*joints)) == {"joints one and two", "joints one and three"}
    middle = hd.Body("middle", MASS, TRIPLE)
    hd.derive(scene(hd.Revolute("one", hd.GROUND, middle, hd.Z), hd.Revolute("two", middle, BODY, hd.Z), effects=()))


def test_a_missing_axis_or_arm_is_one_fault_of_what_the_user_wrote():
    with pytest.raises(TypeError, match=r"Prismatic\.__init__\(\) missing .* 'axis'"):
        hd.Prismatic("slide", hd.GROUND, BODY)
    ohm, henry, volt = (hd.Parameter(name, unit, 1) for name, unit in (("R", "ohm"), ("L_a", "H"), ("V", "V")))
    motor = hd.DCMotor("motor", "hinge", volt, ohm, henry, hd.Parameter("k_m", "N m/A", 1))
    with pytest.raises(InputError) as caught:
        hd.Scene(
            hd.Mechanism("driven", (hd.Revolute("hinge", hd.GROUND, BODY, hd.Z),)), (motor,), hd.Scales(L, hd.Parameter("v", "m/s", 1)),
        )  # fmt: skip
    assert [fault.found for fault in caught.value.faults] == ["no arm"]
