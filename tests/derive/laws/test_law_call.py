"""Laws with numbers of their own, and the general law K d^n + chi d^m v: from a scene, a file of laws, and text."""

import re

import pytest
import sympy as sp

from hertzwerk.derive import Contact, InputError, Material, Parameter, generate, laws, laws_from
from hertzwerk.derive.laws import power, power_damping
from hertzwerk.derive.laws.law import d, v
from hertzwerk.derive.laws.law_call import split_call
from hertzwerk.derive.scenes.bouncing_ball import scene as ball
from hertzwerk.derive.scenes.slider_crank import scene as crank
from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.model.generated_text import text_of
from hertzwerk.runtime.loading import engine_model

CHI = "power_damping(chi=1e7 N s/m^2.5, m=1.5)"


def bound(text):
    return ball.with_law("floor", text).effect("floor").damping


def test_quantities_become_parameters_and_bare_numbers_constants():
    chi, m = bound(CHI).values
    assert isinstance(chi, Parameter)
    assert (chi.name, chi.unit, chi.default) == ("floor_chi", "N s/m^2.5", 1e7)
    assert m == sp.Rational(3, 2)
    assert bound("ristow( gamma = 3 1/s )").values[0].si == 3
    assert split_call("johnson") == ("johnson", {})


@pytest.mark.parametrize(
    ("text", "said"),
    [
        ("power_damping", "power_damping(chi=..., m=...)"), ("power_damping(chi=1e7 N s/m^2.5)", "no value for m"),
        ("power_damping(chi=1e7 N s/m^2.5, n=2)", "does not take"), ("power_damping(chi=fast, m=1)", "expected a quantity in N s/m^(m+1)"),
        ("power_damping(chi=fast, z=1)", "3 faults"), ("power(K=1e8 N/m^1.3, n=1.3) x ristow(gamma=1 1/s) x flores", "one damping law"),
        ("power_damping(chi, m=1)", "SYMBOL=VALUE"), ("power_damping(m=1, m=2)", "each symbol once"),
        ("power_damping(chi=-1 N s/m^2.5, m=1.5)", "(0, inf)"), ("nope(m=1)", "nope"),
    ],
)  # fmt: skip
def test_bad_values_are_faults(text, said):
    with pytest.raises(InputError) as raised:
        bound(text)
    assert said in str(raised.value)


def test_units_of_the_general_law_are_proven():
    generate(ball.with_law("floor", CHI))
    with pytest.raises(InputError, match="only for m = 3/2"):
        generate(ball.with_law("floor", "power_damping(chi=1e7 N s/m^2.5, m=1)"))


def test_the_same_law_from_a_file(tmp_path):
    path = tmp_path / "laws.toml"
    path.write_text(
        """[[law]]
name = "my_dashpot"
kind = "damping"
source = "a test"
term = "chi*d**m*v"
exponent = "m"
symbols.chi = { unit = "N s/m^(m+1)", meaning = "coefficient of the damping", limits = "(0, inf)" }
symbols.m = { unit = "1", meaning = "exponent of the penetration", limits = "[0, 10]" }
""",
        encoding="utf-8",
    )
    law = laws_from(path)["my_dashpot"]
    chi, m = law.parameters
    assert law.resistance == chi * d**m * v
    mine, own = (
        generate(
            ball.replace(
                floor=Contact(
                    "floor", power(Parameter("K", "N/m^1.5", 1e8), 1.5), either(Parameter("chi", "N s/m^2", 1e4), 1)
                )
            )
        )
        for either in (law, power_damping)
    )
    written = [
        re.sub(r'DIGEST = "\w+"', "", text).split() for text in (mine.replace("my_dashpot", "power_damping"), own)
    ]
    assert written[0] == written[1]  # but for where lines break


def test_several_laws_and_names_of_parameters_at_once():
    scene = crank.with_law("slider_pin", "power(K=1e9 N/m^1.3, n=1.3) x flores")
    contact = scene.effect("slider_pin")
    assert (contact.stiffness.law.name, contact.damping.law.name) == ("power", "flores")
    assert contact.stiffness.values[0].unit == "N/m^1.3" and contact.stiffness.values[1] == sp.Rational(13, 10)
    assert contact.damping.values == crank.effect("slider_pin").damping.values  # restitution, shared by name
    friction = crank.with_law("slider_pin_friction", "coulomb(mu_k=friction_coefficient, mu_s=0.2)")
    assert friction.effect("slider_pin_friction").law.values == (
        crank.parameters["friction_coefficient"],
        sp.Rational(1, 5),
    )
    assert "friction_speed" not in friction.parameters  # no law has it any more


def test_missing_quantities_of_a_law_are_listed_in_one_error():
    with pytest.raises(InputError) as raised:
        engine_model("slider_crank", laws={"slider_pin_friction": "lugre(mu_s=0.2)", "slider_pin": "power(n=1.3)"})
    said = str(raised.value)
    assert "2 faults" in said and "K [N/m^n], stiffness" in said
    assert all(f"{name} [" in said for name in ("mu_k", "v_S", "s_0", "s_1", "c_v")) and "mu_s [" not in said


FOAM = """[[law]]
name = "foam"
kind = "stiffness"
source = "a test"
form = "any"
force = "K*d**1.5"
symbols.K = { unit = "N/m^1.5", meaning = "stiffness" }
"""


def test_a_law_of_a_file_is_taken_by_its_name(own_folder):
    file = own_folder / "foam.toml"
    file.write_text(FOAM, encoding="utf-8")
    own = "foam(K=1e8 N/m^1.5)"
    for text, said in (
        ("foam.toml(K=1e8 N/m^1.5)", "foam x flores"),
        (f"foam.toml:{own} x hunt_crossley", "foam x hunt_crossley"),
        (f"{file}:{own}", "foam x flores"),
    ):
        assert ("floor", "contact", said) in engine_model("bouncing_ball", laws={"floor": text}).module.EFFECTS
    once = engine_model("bouncing_ball", laws={"floor": "foam.toml(K=1e8 N/m^1.5)"}).module
    file.write_text(FOAM.replace("d**1.5", "2*d**1.5"), encoding="utf-8")
    again = engine_model("bouncing_ball", laws={"floor": "foam.toml(K=1e8 N/m^1.5)"}).module
    assert text_of(again) != text_of(once)  # the cache knows what is in the file
    with pytest.raises(InputError, match=r"one of .*foam\.toml:foam"):
        engine_model("bouncing_ball", laws={"floor": "foam.toml:wool(K=1 N/m)"})
    with pytest.raises(InputError, match=r"none\.toml"):
        engine_model("bouncing_ball", laws={"floor": "none.toml"})
    evil = "foam.toml(K=__import__('os').abort())"
    with pytest.raises(InputError, match="a quantity in"):
        engine_model("bouncing_ball", laws={"floor": evil})


def test_friction_with_modes_and_memory_by_the_text_of_a_law():
    for law in (
        "coulomb(mu_k=friction_coefficient, mu_s=0.15)",
        "lugre(mu_k=0.1, mu_s=0.15, v_S=0.1 m/s, s_0=1e5 1/m, s_1=100 s/m, c_v=0 N s/m)",
    ):
        run = simulate(
            engine_model("slider_crank", laws={"slider_pin_friction": law}), duration="1.5 ms", tolerance=1e-6
        )
        assert run.outcome.finished and run["slider_pin_friction.dissipated"][-1] > 0


@pytest.mark.parametrize(
    ("call", "fault"),
    [
        (lambda: laws.lankarani_nikravesh(1, 2), r"lankarani_nikravesh takes \(e\): 2 values for 1$"),
        (lambda: laws.kelvin_voigt(K=1), r"kelvin_voigt takes \(e\): missing e; not expected K$"),
        (lambda: laws.thornton(*[Material(1, 0.3)] * 2), r"missing sigma_y; no material has a yield_strength$"),
        (lambda: laws.power(1, 2, n=3), r"power takes \(K, n\): not expected n$"),
    ],
)  # fmt: skip
def test_a_call_that_does_not_fit_names_what_is_wrong(call, fault):
    with pytest.raises(TypeError, match=fault):
        call()
