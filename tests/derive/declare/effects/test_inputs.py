"""Inputs in a scene's expressions: units proven, names checked, where they may stand, what the module says of them."""

import pickle
import re
from dataclasses import replace

import pytest
from derived import Derived

import hertzwerk.derive as hd

BLOCK = hd.Body("block", hd.Parameter("mass", "kg", 2), hd.Parameter("inertia", "kg m^2", 1))
SCALES = hd.Scales(hd.Parameter("size", "cm", 10), hd.Parameter("pace", "m/s", 1), hd.Parameter("arm", "m", 1))
STIFFNESS = hd.Parameter("stiffness", "N/m", 50)


def slide(*effects):
    return hd.Scene(
        hd.Mechanism("slide", (hd.Prismatic("guide", hd.GROUND, BLOCK, axis=hd.X),)), (*effects, hd.EnergyLedger()), SCALES,
    )  # fmt: skip


def found(*effects):
    with pytest.raises(hd.InputError) as error:
        slide(*effects)
    return str(error.value)


def test_an_input_has_the_unit_that_it_is_declared_with():
    force, way = hd.Input("push", "kN"), hd.Input("way", "mm")
    slide(hd.JointForce("motor", "guide", force + STIFFNESS * (way - hd.coordinate_of("guide"))))
    assert "way [m]" in found(hd.JointForce("motor", "guide", force + way))
    assert "a quantity in N" in found(hd.JointForce("motor", "guide", way))
    values = hd.Parameter("R", "ohm", 1), hd.Parameter("L", "H", 1), hd.Parameter("k", "N/A", 1)
    assert "voltage: found push [N]" in found(hd.DCMotor("motor", "guide", force, *values))


def test_every_fault_of_a_declaration_is_reported_at_once():
    text = found(
        hd.JointForce("one", "guide", hd.Input("push", "N")), hd.JointForce("two", "guide", hd.Input("push", "kN")),
        hd.JointForce("three", "guide", hd.Input("mass", "N")), hd.JointForce("four", "guide", hd.Input("no name", "N")),
        hd.JointForce("five", "guide", hd.Input("energy", "N")), hd.JointForce("six", "guide", hd.Input("odd", "newtons")),
    )  # fmt: skip
    for part in (
        "two different inputs of this name", "input mass: found a parameter of this name", "no name", "'energy'", "newtons",
    ):  # fmt: skip
        assert part in text
    with pytest.raises(hd.InputError, match="found 3; expected text"):
        hd.Input("push", 3)


def test_an_input_of_another_unit_or_without_a_derivative_is_no_motion():
    assert "m/s" in found(hd.Drive("cam", "guide", position=hd.Input("way", "m/s")))
    assert "which depends on way" in found(
        hd.Coupling("tie", equation=hd.coordinate_of("guide") - hd.Input("way", "m"))
    )
    # what does not vary at all says so
    assert "the symbol way" in found(hd.JointSpring("spring", "guide", hd.Input("way", "N/m")))


def test_the_module_lists_inputs_and_has_their_histories_and_pieces_last_in_c():
    scene = slide(hd.JointForce("motor", "guide", hd.Input("push", "kN", "of the shaker") * hd.Input("gain", "1")))
    text = hd.generate(scene)
    assert '("push", "kN", "of the shaker"),' in text and '("gain", "1", ""),' in text
    assert text.index('("push_begin", "s"),') > text.index('("half_mass", "kg"),')
    names = {"motor.input", "push", "gain"}
    assert all(f'("{name}", ' in text for name in names)
    without = Derived(
        slide(hd.JointForce("motor", "guide", hd.Parameter("F", "N", 1) * hd.T / hd.Parameter("s", "s", 1)))
    )
    assert without.INPUTS == ()


def test_names_of_entries_give_way_to_parameters():
    effects = hd.JointForce("motor", "guide", hd.Input("push", "N") + hd.Parameter("push_c0", "N", 3))
    text = hd.generate(slide(effects))
    assert re.search(r"\bpush_c0\b.* = .*p\[", text)
    assert "push_c0_" in text or "push_c1" in text
    assert hd.generate(slide(effects)) == text


def test_an_input_may_stand_wherever_time_may_but_in_a_prescribed_motion():
    tension = hd.LineForce(
        "rope", hd.GROUND.at(0, 0, 0), BLOCK.at(0, hd.Parameter("up", "m", 1), 0), hd.Input("pull", "N")
    )
    relay = hd.Relay(
        "relay", hd.Input("signal", "m") - hd.coordinate_of("guide"), unit="m", hysteresis=hd.Parameter("band", "mm", 1)
    )
    scene = slide(tension, relay, hd.JointForce("jets", "guide", hd.Parameter("thrust", "N", 1) * relay.output))
    assert list(scene.inputs) == ["pull", "signal"]
    turned = replace(
        scene,
        mechanism=hd.Mechanism("turned", (hd.Revolute("guide", hd.GROUND, BLOCK, axis=hd.Z),)),
        effects=(hd.JointForce("motor", "guide", hd.Input("torque", "N m")),),
    )
    assert list(turned.inputs) == ["torque"]


def test_inputs_are_equal_by_what_they_declare_and_survive_pickling():
    push = hd.Input("push", "N", "of the shaker")
    assert pickle.loads(pickle.dumps(push)) == push == hd.Input("push", "N", "of the shaker")
    assert push != hd.Input("push", "kN", "of the shaker")
