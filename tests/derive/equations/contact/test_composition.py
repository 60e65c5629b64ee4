"""Any stiffness with any damping with any friction: derived, generated, and in a free impact of two bodies.

A pin slides along x in a bush (or a roller meets another) that slides along z, so that one impact shows both the normal force and the friction.
What comes out is known without the engine: the exact relation of hysteresis damping, an integration of the law expressions alone
(tests/derive/bench.py), and the balance of momentum along z.
"""

import re

import numpy as np
import pytest
from bench import Impact, evaluate, numbers
from derived import Derived
from mpmath import mpf

import hertzwerk.derive as hd
from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import DampingLaw, F, FrictionLaw, N, StiffnessLaw, d, k_t, s, v, v0
from hertzwerk.runtime import simulate
from hertzwerk.runtime.loading import engine_model
from reference.closed_forms import restitution

PACE, SLIP = 0.5, 0.3  # m/s
PIN_MASS, BUSH_MASS = 0.2, 0.3  # kg
STEEL = hd.Material(hd.Parameter("youngs_modulus", "GPa", 207), hd.Parameter("poissons_ratio", "1", 0.3))
RADIUS, CLEARANCE = hd.Parameter("bush_radius", "mm", 10), hd.Parameter("clearance", "mm", 0.5)
LENGTH = hd.Parameter("joint_length", "mm", 15)
SMALL = hd.Parameter("roller_radius", "mm", 9.5)
PIN, BUSH = (
    hd.Body("pin", mass=hd.Parameter("pin_mass", "kg", PIN_MASS)),
    hd.Body("bush", mass=hd.Parameter("bush_mass", "kg", BUSH_MASS)),
)
SLIDE, ALONG = hd.Prismatic("slide", hd.GROUND, PIN, axis=hd.X), hd.Prismatic("along", hd.GROUND, BUSH, axis=hd.Z)
PLACES = (PIN.at(0, 0, 0), BUSH.at(0, 0, 0))
PAIRS = {
    # with the position of the pin where the contact begins
    "pin_in_bush": (hd.PinInBush("joint", *PLACES, hd.Z, RADIUS, CLEARANCE, length=LENGTH), CLEARANCE),
    "parallel_cylinders": (hd.ParallelCylinders("joint", *PLACES, RADIUS, SMALL, hd.Z, LENGTH), -RADIUS - SMALL),
}
GIVEN = {
    "n": 1.5, "K": 2.4e9, "k": 2, "C": hd.Parameter("profile", "1/m", 50),
    "e": 0.7, "gamma": 1e4, "A": 2e-6, "chi": 1e9, "m": 1.5,
    "mu": 0.2, "mu_k": 0.15, "mu_s": 0.25, "v_s": 1e-3, "v_S": 0.05, "v_a": 1e-3, "v_b": 1e-2, "v_r": 0.02, "c_v": 3, "N_t": 10, "xi": 20,
}  # fmt: skip
UNITS = {"K": "N/m^1.5", "chi": "N s/m^2.5"}

STIFFNESS = {name: law for name, law in LAWS.items() if isinstance(law, StiffnessLaw) and law.verdict == "consistent"}
DAMPING = {name: law for name, law in LAWS.items() if isinstance(law, DampingLaw)}
FRICTION = {
    name: law for name, law in LAWS.items() if isinstance(law, FrictionLaw) and not law.modes and not law.memory
}
HYSTERESIS = [name for name, law in DAMPING.items() if law.factor is not None]
MODELS = {"wang_liu_internal": "pin_in_bush", "wang_liu_external": "parallel_cylinders"}


def bound(law, **changed):
    """A law with steel bodies and parameters of the values above."""
    given = {**GIVEN, **changed}
    steel = (STEEL, STEEL) if any(q.name == "E_1" for q in law.parameters) else ()
    rest = [
        q
        for q in law.parameters
        if q.name not in ("E_1", "nu_1", "E_2", "nu_2") and (q not in dict(law.defaults) or q.name in given)
    ]
    values = {
        q.name: given[q.name]
        if not isinstance(given[q.name], int | float) or (q.unit == "1" and q.name in ("n", "k", "m"))
        else hd.Parameter(f"{law.kind}_{q.name}", UNITS.get(q.name, q.unit), given[q.name])
        for q in rest
    }
    return law(*steel, **values)


def scene(pair, stiffness, damping=None, friction=None, **changed):
    pair, onset = PAIRS[pair]
    resist = bound(LAWS[damping], **changed) if damping else None
    # along x the bush gives no way: the mass that counts is the pin's
    effects = [hd.Contact("joint", bound(LAWS[stiffness]), resist, effective_mass=PIN.mass)]
    effects += [hd.Friction("drag", "joint", bound(LAWS[friction]))] if friction else []
    return hd.Scene(
        hd.Mechanism("impact", (SLIDE, ALONG), (pair,)), (*effects, hd.EnergyLedger()),
        hd.Scales(length=CLEARANCE / 100, speed=hd.Parameter("pace", "m/s", PACE)),
        hd.Start(position={"slide": onset}, speed={"slide": hd.Parameter("approach", "m/s", PACE), "along": hd.Parameter("slip", "m/s", SLIP)}),
    )  # fmt: skip


MEMORY = {"s_0": 1e5, "s_1": 3, "z": 1e-6}
RESISTING = {name: law for name, law in LAWS.items() if isinstance(law, DampingLaw | FrictionLaw)}


@pytest.mark.by_turns(3)
@pytest.mark.parametrize("name", RESISTING)
def test_a_law_without_memory_adds_no_state_and_no_latch(name):
    """And one with memory what its expression names, and no more."""
    law, damping = LAWS[name], isinstance(LAWS[name], DampingLaw)
    effects = [
        hd.Contact("joint", bound(LAWS["hertz_point"]), bound(law) if damping else None, effective_mass=PIN.mass)
    ]
    effects += [] if damping else [hd.Friction("drag", "joint", bound(law, **MEMORY))]
    model = Derived(
        hd.Scene(
            hd.Mechanism("impact", (SLIDE, ALONG), (PAIRS["pin_in_bush"][0],)), effects,
            hd.Scales(length=CLEARANCE / 100, speed=hd.Parameter("pace", "m/s", PACE)), hd.Start(position={"slide": CLEARANCE}),
        )
    )  # fmt: skip
    latches = [("joint.approach_speed", "m/s", 0)] if damping and v0 in law.quantities else []
    assert list(model.LATCHES) == latches
    assert [row[0] for row in model.MEMORY] == (["drag.bristle"] if not damping and law.memory else [])
    assert bool(model.SLIPS) == (not damping and bool(law.modes))
    assert ("approach_floor" in model.text) == ("= m[0]\n" in model.text) == bool(latches)  # which is read
    assert ("= z[0]\n" in model.text) == bool(model.MEMORY)


def pair_for(stiffness):
    return next((name for name in PAIRS if name in LAWS[stiffness].pairs), "pin_in_bush")


def law_numbers(law, pair, **given):
    """Values of a law's symbols at the pair, from its geometry retyped here."""
    R_1, R_2, inside = mpf("0.010"), mpf("0.0095"), pair == "pin_in_bush"
    values = numbers(law, {"E": "207e9", "nu": "0.3", "R_1": "0.010", "R_2": "0.0095", "L": "0.015"}, **given)
    own = {"dR": R_1 - R_2 if inside else R_1 + R_2, "m_eff": mpf(str(PIN_MASS))}
    own["R_eff"] = R_1 * R_2 / own["dR"]
    values = {q: own.get(q.name, x) for q, x in values.items()}
    for symbol, expression in law.definitions:
        values[symbol] = evaluate(expression, values)
    return values


def check_forces(pair, stiffness, damping, friction):
    """Normal and friction force of the generated module at some states against the laws by themselves, composed here."""
    model = Derived(scene(pair, stiffness, damping, friction))
    elastic, damp, drag = LAWS[stiffness], LAWS[damping], LAWS[friction]
    onset = float({"pin_in_bush": "0.0005", "parallel_cylinders": "-0.0195"}[pair])
    values = law_numbers(elastic, pair)
    for depth, rate, slip, latched in ((1e-6, 0.4, 0.3, 0.5), (2e-5, -0.2, -0.002, 0.5), (1e-7, -0.01, 0.05, 0.02)):
        q = np.array([onset + depth, 0.0])  # the pin moves on along x, deeper
        penetration = (
            mpf(float(-model.call("outputs", q=q, u=np.zeros(2))[0]))
            if pair != "pin_in_bush"
            else mpf(float(q[0])) - mpf("0.0005")
        )
        got = model.call("contact_joint", q=q, u=np.array([rate, slip]), m=np.full(len(model.LATCHES), latched))
        F_e = evaluate(elastic.force, values | {d: penetration})
        known = law_numbers(damp, pair) | {F: F_e, d: penetration, v: mpf(rate), v0: mpf(latched)}
        if k_t in damp.quantities:
            known[k_t] = evaluate(elastic.force.diff(d), values | {d: penetration})
        normal = F_e + evaluate(damp.resistance, known)
        assert got[2][0] == pytest.approx(float(normal), rel=1e-8, abs=1e-9 * float(F_e))
        pressing = float(got[2][0])
        if damp.release == "gap":  # a law that may pull then presses nothing
            pressing = max(pressing, 0.0)
        force = evaluate(drag.force, law_numbers(drag, pair) | {N: mpf(pressing), s: mpf(abs(slip))})
        assert abs(got[0][1]) == pytest.approx(abs(float(force)), rel=1e-9, abs=1e-12)
        assert got[0][1] * slip * pressing <= 0  # against the motion while the law pushes
        assert got[4][0] == 1


@pytest.mark.by_turns(2)
@pytest.mark.parametrize("stiffness", STIFFNESS)
def test_any_stiffness(stiffness):
    check_forces(pair_for(stiffness), stiffness, "flores", "smooth_coulomb")


@pytest.mark.by_turns(3)
@pytest.mark.parametrize("damping", DAMPING)
@pytest.mark.parametrize(
    ("pair", "stiffness"), [("parallel_cylinders", "johnson"), pytest.param("pin_in_bush", "liu_with_length", marks=pytest.mark.exhaustive)],
)  # fmt: skip
def test_any_damping(damping, pair, stiffness):
    check_forces(pair, stiffness, damping, "smooth_coulomb")


@pytest.mark.parametrize("friction", FRICTION)
def test_any_friction(friction):
    check_forces("pin_in_bush", "johnson", "tsuji", friction)
    check_forces("parallel_cylinders", "wang_liu_external", "exact", friction)


def impact(pair, stiffness, damping, friction=None, **changed):
    run = simulate(
        engine_model(scene(pair, stiffness, damping, friction, **changed)), duration="1 ms", tolerance=1e-10, max_steps=5000,
    )  # fmt: skip
    assert run.outcome.finished, run.outcome
    assert len(run.impacts) == 1
    assert abs(run.energy_residual) < 1e-7
    return run


@pytest.mark.by_turns(2)
@pytest.mark.parametrize(
    ("model", "damping"),
    [  # every factor with one of them, by turns
        pytest.param(model, damping, marks=[] if (i + j) % 2 else pytest.mark.exhaustive)
        for i, model in enumerate(MODELS)
        for j, damping in enumerate(HYSTERESIS)
    ],
)
def test_the_two_models_take_any_damping_factor(model, damping):
    """The claim of Wang and Liu 2020: with the damping factor replaced, the two models describe all existing ones.

    So each factor must return from either model what it returns from any other: the restitution of the exact relation.
    """
    e = 0.2 if damping == "gharib_hurmuzlu" else 0.8
    h = evaluate(LAWS[damping].factor, numbers(LAWS[damping], e=str(e)))
    run = impact(MODELS[model], model, damping, e=e)
    out = -(run.engine.final["slide.speed"]) / PACE
    assert out == pytest.approx(restitution(str(h)), rel=1e-8)


def test_release_rules_differ_and_tsuji_is_exact_where_the_gap_opens():
    """Tsuji's law returns its e when the contact ends at d = 0; ended where its force runs out it would return more."""
    run = impact("pin_in_bush", "hertz_point", "tsuji", e=0.7)
    assert -run.engine.final["slide.speed"] / PACE == pytest.approx(0.7, rel=1e-8)
    assert run["joint.normal_force"].min() < 0
    model = engine_model(scene("pin_in_bush", "hertz_point", "tsuji", e=0.7))
    model.module.RELEASES = ("force",)
    early = simulate(model, duration="1 ms", tolerance=1e-10)
    assert -early.engine.final["slide.speed"] / PACE > 0.71


def test_modules_label_reconstructions_and_compute_factors_once():
    # The paper's own expressions could not be had: what stands for them is labelled wherever the law is named.
    text = hd.generate(scene("pin_in_bush", "wang_liu_internal", "flores"))
    label = "wang_liu_internal x flores, wang_liu_internal a reconstruction (grade R)"
    assert f"    joint: {label}\n" in text  # header
    assert f'("joint", "contact", "{label}")' in text
    assert "grade R" not in hd.generate(scene("pin_in_bush", "johnson", "flores"))
    # The chain of its definitions stands in constants(p), none of it in the contact.
    text = hd.generate(scene("pin_in_bush", "johnson", "exact"))
    functions = {part.split("(")[0]: part for part in text.split("\ndef ")[1:]}
    assert "ca.exp(" in functions["constants"]
    assert "ca.exp(" not in functions["contact_joint"]
    assert not re.search(r"joint_hysteresis_factor = (?!c\[)", functions["contact_joint"])


def test_effective_mass_is_that_of_both_bodies_by_default():
    """Two free spheres under a law that asks for m_eff: momentum and the restitution of the law expressions alone."""
    ball, other = hd.Body("ball", mass=PIN.mass), hd.Body("other", mass=BUSH.mass)
    paths = (hd.Prismatic("slide", hd.GROUND, ball, axis=hd.X), hd.Prismatic("away", hd.GROUND, other, axis=hd.X))
    pair = hd.SphereOnSphere("joint", ball.at(0, 0, 0), other.at(0, 0, 0), RADIUS, SMALL)
    spheres = hd.Scene(
        hd.Mechanism("spheres", paths, (pair,)),
        (hd.Contact("joint", bound(LAWS["hertz_point"]), bound(LAWS["jankowski"])),),
        hd.Scales(length=CLEARANCE / 100, speed=hd.Parameter("pace", "m/s", PACE)),
        hd.Start(position={"away": RADIUS + SMALL}, speed={"slide": hd.Parameter("approach", "m/s", PACE)}),
    )
    run = simulate(engine_model(spheres), duration="1 ms", tolerance=1e-10)
    mass = PIN_MASS * BUSH_MASS / (PIN_MASS + BUSH_MASS)
    alone = Impact(LAWS["hertz_point"], LAWS["jankowski"], mass=mass, speed=PACE, e="0.7")
    assert (run.engine.final["away.speed"] - run.engine.final["slide.speed"]) / PACE == pytest.approx(
        alone.restitution, rel=1e-7
    )
    assert PIN_MASS * run.engine.final["slide.speed"] + BUSH_MASS * run.engine.final["away.speed"] == pytest.approx(
        PIN_MASS * PACE, rel=1e-9
    )


def test_beyond_reach_the_run_ends():
    """A heavy, fast pin: deeper than Johnson's turning point is outside_law_range, not a wrong branch."""
    run = simulate(
        engine_model(scene("pin_in_bush", "johnson", "exact")), duration="1 ms", tolerance=1e-8, initial={"slide.speed": "90 m/s"},
    )  # fmt: skip
    assert run.outcome.name == "outside_law_range"
    assert "joint" in run.outcome.message
    deepest = run["joint.penetration"].max()
    assert deepest == pytest.approx(4 * np.exp(-2) * 5e-4, rel=0.05)
