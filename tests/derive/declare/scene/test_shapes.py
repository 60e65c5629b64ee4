"""Declarations of every wrong kind, in every place: one InputError that says what was expected, never the exception of what met it first."""

import warnings
from dataclasses import fields, is_dataclass, replace

import numpy as np
import pytest
import sympy as sp
from each import each

from hertzwerk.derive import (
    APART,
    GROUND,
    BallInSocket,
    Body,
    ConstantSpeed,
    Contact,
    CornerOnFace,
    CustomPair,
    CylinderOnPlane,
    Drive,
    Friction,
    Gravity,
    Harmonic,
    InputError,
    JointDamper,
    JointForce,
    JointSpring,
    Material,
    Mechanism,
    Parameter,
    PinInBush,
    Planar,
    PointForce,
    Prismatic,
    Ramp,
    Revolute,
    Scales,
    Scene,
    SphereOnPlane,
    SphereOnSphere,
    Spherical,
    Start,
    T,
    Table,
    X,
    Y,
    Z,
    coordinate_of,
    speed_of,
)
from hertzwerk.derive.laws import hertz_point, power, smooth_coulomb

BAD = [
    None,
    "text",
    (1, 2),
    [1, 2, 3],
    float("nan"),
    sp.Symbol("stranger"),
    np.eye(3),
    Parameter("other", "kg^2", 1),
    ((1, 2, 3),) * 3,
    object(),
]
SIZE, SPEED, PUSH = Parameter("size", "m", 0.1), Parameter("speed", "m/s", 1), Parameter("push", "N", 1)
RATE, MASS, TIME = Parameter("rate", "rad/s", 3), Parameter("mass", "kg", 1), Parameter("rise", "s", 1)
INERTIA, MU = Parameter("inertia", "kg m^2", 1e-3), Parameter("mu", "1", 0.1)
GRAVITY = Gravity("gravity", Parameter("g", "m/s^2", 9.81), direction=-Y)
LAW = power(Parameter("K", "N/m^1.5", 1e8), 1.5)
BLOCK = Body("block", MASS, INERTIA)
HERE, THERE = BLOCK.at(0, 0, 0), GROUND.at(0, 0, 0)


def scene(joint=None, pair=None, *effects, **more):
    joint = Planar("plane", GROUND, BLOCK) if joint is None else joint
    contact = () if pair is None else (Contact(getattr(pair, "name", "touch"), LAW),)
    mechanism = Mechanism("trial", joints=(joint,), pairs=() if pair is None else (pair,))
    return Scene(mechanism, effects=(GRAVITY, *contact, *effects), **({"scales": Scales(SIZE, SPEED, SIZE)} | more))


def touching(*effects):
    mechanism = Mechanism("trial", (Planar("plane", GROUND, BLOCK),), (SphereOnPlane("floor", HERE, SIZE, THERE, Y),))
    return Scene(mechanism, effects=(GRAVITY, *effects), scales=Scales(SIZE, SPEED, SIZE))


def joint(record):
    return scene(joint=record)


def pair(record):
    return scene(None, record)


def effect(record):
    return scene(None, None, record)


DECLARED = {
    "body": (BLOCK, lambda body: scene(Planar("plane", GROUND, body))),
    "point": (HERE, lambda place: pair(SphereOnPlane("floor", place, SIZE, THERE, Y))),
    "direction": (X, lambda axis: joint(Prismatic("slide", GROUND, BLOCK, axis=axis))),
    "revolute": (Revolute("pin", GROUND, BLOCK, axis=Z), joint),
    "spherical": (Spherical("ball", GROUND, Body("block", MASS, (INERTIA,) * 3)), joint),
    "sphere": (SphereOnPlane("touch", HERE, SIZE, THERE, Y), pair),
    "spheres": (SphereOnSphere("touch", HERE, THERE, SIZE, SIZE), pair),
    "pin": (PinInBush("touch", HERE, THERE, Z, SIZE, Parameter("gap", "mm", 1)), pair),
    "socket": (BallInSocket("touch", HERE, THERE, SIZE, Parameter("gap", "mm", 1)), pair),
    "cylinder": (CylinderOnPlane("touch", HERE, Z, SIZE, SIZE, THERE, Y), pair),
    "corner": (CornerOnFace("touch", HERE, THERE, Y, X, SIZE), pair),
    "custom": (CustomPair("touch", HERE, THERE, APART[1] - SIZE, (0, 1, 0), (APART[0], 0, APART[2])), pair),
    "gravity": (GRAVITY, lambda record: scene().replace(gravity=record)),
    "contact": (Contact("floor", LAW), touching),
    "friction": (Friction("rub", "floor", smooth_coulomb(MU, SPEED)), lambda record: touching(Contact("floor", LAW), record)),
    "material": (Material(Parameter("E", "GPa", 207), Parameter("nu", "1", 0.3)),
                 lambda record: touching(Contact("floor", hertz_point(record, record)))),
    "constant speed": (ConstantSpeed("drive", "plane.angle", RATE), effect),
    "ramp": (Ramp("drive", "plane.angle", RATE, TIME), effect),
    "harmonic": (Harmonic("drive", "plane.angle", MU, RATE), effect),
    "drive": (Drive("drive", "plane.angle", position=RATE * T), effect),
    "force": (JointForce("push", "plane.x", PUSH), effect),
    "spring": (JointSpring("spring", "plane.x", Parameter("k", "N/m", 1)), effect),
    "damper": (JointDamper("damper", "plane.x", Parameter("d", "N s/m", 1)), effect),
    "point force": (PointForce("push", HERE, (0, PUSH, 0)), effect),
    "scales": (Scales(SIZE, SPEED, SIZE), lambda scales: scene(scales=scales)),
    "start": (Start({"plane.x": SIZE}, {"plane.x_speed": SPEED}), lambda start: scene(start=start)),
    "mechanism": (scene().mechanism, lambda mechanism: Scene(mechanism, (GRAVITY,), Scales(SIZE, SPEED, SIZE))),
    "scene": (scene(), lambda whole: whole),
}  # fmt: skip


def refused(make):
    """The InputError of a declaration, or None where it stands; any other exception, and any warning, is raised."""
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        try:
            make()
        except InputError as error:
            return error
    return None


@pytest.mark.parametrize("name", DECLARED)
def test_every_field_takes_what_it_takes_or_says_so(name):
    record, use = DECLARED[name]
    use(record)
    assert is_dataclass(record)
    told = 0
    for entry in fields(record):
        for value in BAD:
            error = refused(lambda: use(replace(record, **{entry.name: value})))  # noqa: B023 -- called here
            if error is not None:
                told += 1
                assert all(len(fault.expected) > 3 and not fault.expected.endswith("one of ") for fault in error.faults)
    assert told >= 4 * len(fields(record))


@each("value", [None, 5, [1], object()])
@each(
    "make",
    [
        lambda value: Parameter(value, "kg", 1),
        lambda value: Parameter("mass", value, 1),
        lambda value: coordinate_of(value),
        lambda value: speed_of(value),
        lambda value: HERE.turned(value, 0),
        lambda value: touching(Contact("floor", LAW)).with_law("floor", value),
        lambda value: touching(Contact("floor", LAW)).without(value),
    ],
)
def test_functions_refuse_what_is_no_name(make, value):
    assert refused(lambda: make(value)) is not None


def test_a_table_is_no_surface():
    """The second rate of a distance to it would be a third derivative, which a spline does not have."""
    bump = Table("bump", (0, 0.1, 0.2), (0, 0.01, 0), ("m", "m"))
    with pytest.raises(
        InputError, match="found the table bump; expected an expression of APART, TURN and Parameters without"
    ):
        pair(CustomPair("touch", HERE, THERE, APART[1] - bump(APART[0]), (0, 1, 0), (APART[0], 0, APART[2])))


def test_a_matrix_of_inertia_is_refused_with_the_accepted_forms():
    for matrix in ([[1, 0, 0], [0, 1, 0], [0, 0, 1]], np.eye(3)):
        with pytest.raises(InputError, match=r"body block, inertia[\s\S]*three principal ones"):
            joint(Revolute("pin", GROUND, Body("block", MASS, matrix), axis=Z))


@pytest.mark.parametrize(
    ("make", "expected"),
    [
        (lambda: effect(Contact("floor", LAW)), "a pair of the mechanism, which has none"),
        (lambda: joint(Spherical("ball", GROUND, Body("block", MASS, (INERTIA,) * 3))).replace(gravity=JointForce("push", "x", PUSH)),
         "a joint with one coordinate, of which the mechanism has none"),
    ],
)  # fmt: skip
def test_a_list_of_nothing_is_said_in_words(make, expected):
    error = refused(make)
    assert error is not None
    assert expected in str(error)
