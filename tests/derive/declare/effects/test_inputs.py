"""Inputs in a scene's expressions: units proven, names checked, where they may stand, what the module says of them."""

import pickle
import re
from dataclasses import replace

import pytest
from derived import Derived

from hertzwerk.derive import (
    GROUND,
    Body,
    Coupling,
    DCMotor,
    Drive,
    EnergyLedger,
    Input,
    InputError,
    JointForce,
    JointSpring,
    LineForce,
    Mechanism,
    Parameter,
    Prismatic,
    Relay,
    Revolute,
    Scales,
    Scene,
    T,
    X,
    Z,
    coordinate_of,
    generate,
)

BLOCK = Body("block", Parameter("mass", "kg", 2), Parameter("inertia", "kg m^2", 1))
SCALES = Scales(Parameter("size", "cm", 10), Parameter("pace", "m/s", 1), Parameter("arm", "m", 1))
STIFFNESS = Parameter("stiffness", "N/m", 50)


def slide(*effects):
    return Scene(Mechanism("slide", (Prismatic("guide", GROUND, BLOCK, axis=X),)), (*effects, EnergyLedger()), SCALES)


def found(*effects):
    with pytest.raises(InputError) as error:
        slide(*effects)
    return str(error.value)


def test_an_input_has_the_unit_that_it_is_declared_with():
    force, way = Input("push", "kN"), Input("way", "mm")
    slide(JointForce("motor", "guide", force + STIFFNESS * (way - coordinate_of("guide"))))
    assert "way [m]" in found(JointForce("motor", "guide", force + way))
    assert "a quantity in N" in found(JointForce("motor", "guide", way))
    values = Parameter("R", "ohm", 1), Parameter("L", "H", 1), Parameter("k", "N/A", 1)
    assert "voltage: found push [N]" in found(DCMotor("motor", "guide", force, *values))


def test_every_fault_of_a_declaration_is_reported_at_once():
    text = found(
        JointForce("one", "guide", Input("push", "N")),
        JointForce("two", "guide", Input("push", "kN")),
        JointForce("three", "guide", Input("mass", "N")),
        JointForce("four", "guide", Input("no name", "N")),
        JointForce("five", "guide", Input("energy", "N")),
        JointForce("six", "guide", Input("odd", "newtons")),
    )
    for part in (
        "two different inputs of this name",
        "input mass: found a parameter of this name",
        "no name",
        "'energy'",
        "newtons",
    ):
        assert part in text
    with pytest.raises(InputError, match="found 3; expected text"):
        Input("push", 3)


def test_an_input_of_another_unit_or_without_a_derivative_is_no_motion():
    assert "m/s" in found(Drive("cam", "guide", position=Input("way", "m/s")))
    assert "which depends on way" in found(Coupling("tie", equation=coordinate_of("guide") - Input("way", "m")))
    # what does not vary at all says so
    assert "the symbol way" in found(JointSpring("spring", "guide", Input("way", "N/m")))


def test_the_module_lists_inputs_and_has_their_histories_and_pieces_last_in_c():
    scene = slide(JointForce("motor", "guide", Input("push", "kN", "of the shaker") * Input("gain", "1")))
    text = generate(scene)
    assert '("push", "kN", "of the shaker"),' in text and '("gain", "1", ""),' in text
    assert text.index('("push_begin", "s"),') > text.index('("half_mass", "kg"),')
    names = {"motor.input", "push", "gain"}
    assert all(f'("{name}", ' in text for name in names)
    without = Derived(slide(JointForce("motor", "guide", Parameter("F", "N", 1) * T / Parameter("s", "s", 1))))
    assert without.INPUTS == ()


def test_names_of_entries_give_way_to_parameters():
    effects = JointForce("motor", "guide", Input("push", "N") + Parameter("push_c0", "N", 3))
    text = generate(slide(effects))
    assert re.search(r"\bpush_c0\b.* = .*p\[", text)
    assert "push_c0_" in text or "push_c1" in text
    assert generate(slide(effects)) == text


def test_an_input_may_stand_wherever_time_may_but_in_a_prescribed_motion():
    tension = LineForce("rope", GROUND.at(0, 0, 0), BLOCK.at(0, Parameter("up", "m", 1), 0), Input("pull", "N"))
    relay = Relay(
        "relay", Input("signal", "m") - coordinate_of("guide"), unit="m", hysteresis=Parameter("band", "mm", 1)
    )
    scene = slide(tension, relay, JointForce("jets", "guide", Parameter("thrust", "N", 1) * relay.output))
    assert list(scene.inputs) == ["pull", "signal"]
    turned = replace(
        scene,
        mechanism=Mechanism("turned", (Revolute("guide", GROUND, BLOCK, axis=Z),)),
        effects=(JointForce("motor", "guide", Input("torque", "N m")),),
    )
    assert list(turned.inputs) == ["torque"]


def test_inputs_are_equal_by_what_they_declare_and_survive_pickling():
    push = Input("push", "N", "of the shaker")
    assert pickle.loads(pickle.dumps(push)) == push == Input("push", "N", "of the shaker")
    assert push != Input("push", "kN", "of the shaker")
