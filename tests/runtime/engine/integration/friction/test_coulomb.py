"""Set-valued Coulomb friction in the engine: slip and stick as modes, against closed forms, impulses, and another way of writing the same thing."""

import math
from functools import cache

import casadi as ca
import numpy as np
import pytest
from blocks import CARRIAGE, GRAVITY, MASS, STIFFNESS, WEIGHT, block
from each import each
from jacobians import check_jacobian, start_of
from scipy.optimize import brentq

import hertzwerk.derive as hd
from hertzwerk.derive.laws import coulomb, kelvin_voigt, power
from hertzwerk.derive.scenes import slider_crank
from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.integration.step import implicit_step
from hertzwerk.runtime.engine.model.generated_text import with_tables
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(7)  # methods and sizes that run the same code

METHODS = ("dop853", "dopri5", "rodas", "esdirk", "auto")
REFERENCES = ("cvodes", "idas")
CVODES, IDAS = (pytest.param(method, marks=pytest.mark.slow) for method in REFERENCES)
MU_K, MU_S = 0.2, 0.3
MOVING = MASS + CARRIAGE  # kg
CRITICAL = math.atan(MU_S * MASS / MOVING)  # rad: MOVING g sin = mu_s MASS g cos


def dry(name="", mu_k=MU_K, mu_s=MU_S):
    return coulomb(hd.Parameter(f"mu_k{name}", "1", mu_k), hd.Parameter(f"mu_s{name}", "1", mu_s))


@cache
def built(scene, *given, **options):
    """The model of a scene, derived once."""
    return engine_model(scene(*given, **options))


DRY = dry()


@pytest.fixture(scope="module")
def model():
    return built(block, DRY)


# ---- one block -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("method", [*METHODS, *REFERENCES])
def test_sliding_to_rest(model, method):
    run = simulate(model, duration="1 s", method=method, tolerance=1e-8, parameters={"slide": "1 m/s"})
    deceleration = MU_K * WEIGHT / MOVING
    slip, force = run["floor_0.slip"], run["floor_0.friction_force"]
    sticks = np.flatnonzero(slip == 0)
    assert run.outcome.finished
    assert run.t[sticks[0]] == pytest.approx(1 / deceleration, rel=1e-8)
    assert run.engine.final["along_0.travel"] == pytest.approx(1 / (2 * deceleration), rel=1e-8)
    assert np.max(np.abs(run["along_0.speed"][sticks])) < 1e-15
    assert np.array_equal(sticks, np.arange(sticks[0], len(slip)))  # once it sticks it stays
    assert np.all(slip[: sticks[0]] == -1)  # the tangent is -x
    assert force[: sticks[0]] == pytest.approx(MU_K * WEIGHT, rel=1e-6)
    assert np.max(np.abs(force[sticks])) < 1e-9
    assert run.energy_residual < 1e-8
    assert run["energy_ledger.input"][-1] == 0 if "energy_ledger.input" in run else True
    assert run.engine.final["rub_0.dissipated"] == pytest.approx(MOVING / 2, rel=1e-8)


@pytest.mark.parametrize("method", METHODS)
def test_just_below_the_friction_angle_nothing_moves(model, method):
    run = simulate(model, duration="10 s", method=method, parameters={"slope": (1 - 1e-6) * CRITICAL}, tolerance=1e-6)
    assert np.all(run["floor_0.slip"] == 0)
    assert np.max(np.abs(run["along_0.speed"])) < 1e-14
    assert np.max(np.abs(run["along_0.travel"])) < 1e-13
    assert run["floor_0.friction_force"][-1] == pytest.approx(MOVING * GRAVITY * math.sin(CRITICAL), rel=2e-6)


@pytest.mark.parametrize("method", [*METHODS, CVODES])
def test_a_tilting_plane_lets_go_at_the_static_angle(method):
    """The turning adds a centripetal acceleration to the load: MOVING g sin = mu_s MASS (g cos - turn^2 height)."""
    turn = 0.2
    run = simulate(built(block, DRY, turn=turn), duration="2 s", method=method, tolerance=1e-8)
    slips = np.flatnonzero(run["floor_0.slip"] != 0)
    height = float(run["up_0.travel"][slips[0]])

    def excess(angle):
        return MOVING * math.sin(angle) - MU_S * MASS * (math.cos(angle) - turn**2 * height / GRAVITY)

    assert turn * run.t[slips[0]] == pytest.approx(brentq(excess, 0.1, 0.4), rel=2e-6)
    assert np.max(np.abs(run["along_0.speed"][: slips[0]])) < 1e-12
    assert run["floor_0.slip"][slips[0]] == run["floor_0.slip"][-1] == 1  # downhill is -x, the tangent too
    assert run.energy_residual < 1e-7


@pytest.mark.parametrize("method", ["dop853", pytest.param("esdirk", marks=pytest.mark.exhaustive)])
def test_compiled_is_bitwise_the_virtual_machine(model, method):
    parameters = {"slope": 0.2, "height": "2 mm", "slide": "-0.3 m/s", "restitution": 0.6}
    options = {"duration": "0.3 s", "tolerance": 1e-6, "method": method, "parameters": parameters}
    one, two = (simulate(model, compiled=compiled, **options) for compiled in (False, True))
    assert {-1.0, 0.0, 1.0} <= set(one["floor_0.slip"])
    assert np.array_equal(one.engine.history.rows, two.engine.history.rows)


# ---- several contacts ------------------------------------------------------------------------------------------------

FEET = 0.2  # m, from the middle


def sledge(angle=0.0, *, rocks=False, speed=0.0):
    """A body on two feet, 2 kg, on a plane on a heavy ramp; with `rocks` it may turn too."""
    weight, radius, alpha = (
        hd.Parameter("mass", "kg", 2), hd.Parameter("radius", "m", 0.05), hd.Parameter("slope", "rad", angle),
    )  # fmt: skip
    gravity, stiffness = hd.Parameter("gravity", "m/s^2", GRAVITY), hd.Parameter("stiffness", "N/m", STIFFNESS)
    inertia, foot = hd.Parameter("inertia", "kg m^2", 0.03), hd.Parameter("foot", "m", FEET)
    ramp = hd.Body("ramp", mass=weight, inertia=hd.Parameter("ramp_inertia", "kg m^2", 1e16))
    light = hd.Parameter("light", "kg", 1e-9)
    frame, lift = hd.Body("frame", mass=light, inertia=inertia), hd.Body("lift", mass=weight, inertia=inertia)
    joints = [hd.Revolute("tilt", hd.GROUND, ramp, axis=hd.Z), hd.Prismatic("along", ramp, frame, axis=hd.X)]
    body = lift
    if rocks:
        lift, body = hd.Body("lift", mass=light, inertia=inertia), hd.Body("body", mass=weight, inertia=inertia)
    joints.append(hd.Prismatic("up", frame, lift, axis=hd.Y))
    if rocks:
        joints.append(hd.Revolute("rock", lift, body, axis=hd.Z))
    pairs, effects = [], [hd.Gravity("gravity", gravity, direction=-hd.Y), hd.EnergyLedger()]
    for name, x in (("rear", -foot), ("front", foot)):
        pairs.append(hd.SphereOnPlane(name, body.at(x, 0, 0), radius, ramp.at(0, 0, 0), hd.Y))
        effects.append(hd.Contact(name, power(stiffness, 1), kelvin_voigt(hd.Parameter("restitution", "1", 0.2))))
        effects.append(hd.Friction(f"{name}_rub", name, dry(mu_s=0.3)))
    return hd.Scene(
        hd.Mechanism("sledge", tuple(joints), tuple(pairs)), tuple(effects),
        hd.Scales(length=hd.Parameter("depth", "mm", 0.1), speed=hd.Parameter("pace", "m/s", 1), arm=radius),
        hd.Start(position={"up": radius - weight * gravity / (2 * stiffness), "tilt": -alpha}, speed={"along": hd.Parameter("slide", "m/s", speed)}),
    )  # fmt: skip


@pytest.mark.parametrize("method", METHODS)
def test_feet_share_what_they_hold_and_are_loaded_unequally_where_their_body_rocks(method):
    """Two feet that cannot but stick together: one force to share, so each takes half."""
    model = built(sledge)
    run = simulate(model, duration="2 s", method=method, parameters={"slope": 0.25}, tolerance=1e-6)
    assert run.outcome.finished
    for foot in ("rear", "front"):
        assert run[f"{foot}.friction_force"][-1] == pytest.approx(GRAVITY * math.sin(0.25), rel=1e-7)
    assert np.max(np.abs(run["along.speed"])) < 1e-13
    run = simulate(model, duration="1 s", method=method, tolerance=1e-8, parameters={"slope": 0.35})
    assert run.engine.final["along.speed"] == pytest.approx(
        GRAVITY * (math.sin(0.35) - MU_K * math.cos(0.35)), rel=1e-6
    )
    run = simulate(model, duration="1 s", method=method, tolerance=1e-8, parameters={"slide": "1 m/s"})
    assert run.engine.final["along.travel"] == pytest.approx(1 / (2 * MU_K * GRAVITY), rel=1e-8)
    assert run.engine.final["along.speed"] == pytest.approx(0, abs=1e-14)
    assert run.energy_residual < 1e-7
    # Braking at the feet, which are below the middle, loads the front one: mu_k g m radius = (N_front - N_rear) FEET.
    run = simulate(
        built(sledge, rocks=True), duration="1.5 s", method=method, tolerance=1e-8, parameters={"slide": "2 m/s"}
    )
    rows = run.at(np.linspace(0.3, 0.9, 300))
    shift = np.mean(rows["front.normal_force"] - rows["rear.normal_force"])
    assert shift * FEET == pytest.approx(2 * MU_K * GRAVITY * 0.05, rel=1e-3)
    assert run.engine.final["along.travel"] == pytest.approx(2**2 / (2 * MU_K * GRAVITY), rel=1e-5)
    assert run["front.slip"][-1] == run["rear.slip"][-1] == 0
    assert abs(run.engine.final["along.speed"]) < 1e-8  # the tolerance
    assert run.energy_residual < 1e-7


def stack(upper, lower):
    """A slab, 3 kg, on the ground, and a block, 1 kg, on the slab; both slide at 1 m/s at the start."""
    radius, stiffness = hd.Parameter("radius", "m", 0.1), hd.Parameter("stiffness", "N/m", STIFFNESS)
    gravity, light = hd.Parameter("gravity", "m/s^2", GRAVITY), hd.Parameter("light", "kg", 1e-9)
    slab_mass, block_mass = hd.Parameter("slab_mass", "kg", 3), hd.Parameter("block_mass", "kg", 1)
    sled, slab = hd.Body("sled", mass=light), hd.Body("slab", mass=slab_mass)
    cart, top = hd.Body("cart", mass=light), hd.Body("top", mass=block_mass)
    joints = (
        hd.Prismatic("sled_x", hd.GROUND, sled, axis=hd.X), hd.Prismatic("slab_y", sled, slab, axis=hd.Y),
        hd.Prismatic("cart_x", slab, cart, axis=hd.X), hd.Prismatic("top_y", cart, top, axis=hd.Y),
    )  # fmt: skip
    pairs = (
        hd.SphereOnPlane("ground", slab.at(0, 0, 0), radius, hd.GROUND.at(0, 0, 0), hd.Y),
        hd.SphereOnPlane("deck", top.at(0, 0, 0), radius, slab.at(0, 0, 0), hd.Y),
    )
    damping = kelvin_voigt(hd.Parameter("restitution", "1", 0.2))
    return hd.Scene(
        hd.Mechanism("stack", joints, pairs),
        (
            hd.Gravity("gravity", gravity, direction=-hd.Y),
            hd.Contact("ground", power(stiffness, 1), damping), hd.Friction("below", "ground", dry("_below", lower, lower)),
            hd.Contact("deck", power(stiffness, 1), damping), hd.Friction("above", "deck", dry("_above", upper, upper)),
            hd.EnergyLedger(),
        ),
        hd.Scales(length=hd.Parameter("depth", "mm", 0.1), speed=hd.Parameter("pace", "m/s", 1)),
        hd.Start(
            position={
                "slab_y": radius - gravity * (slab_mass + block_mass) / stiffness,
                "top_y": radius - gravity * block_mass / stiffness,
            },
            speed={"sled_x": hd.Parameter("slide", "m/s", 1)},
        ),
    )  # fmt: skip


@pytest.mark.parametrize("method", [*METHODS, CVODES])
def test_stuck_on_what_slides_and_sliding_on_what_sticks(method):
    """0.4 above holds what 0.2 below takes: slab and block brake as one, each friction force through the other's mass."""
    run = simulate(built(stack, 0.4, 0.2), duration="0.6 s", method=method, tolerance=1e-8)
    slides = run.t < 0.5
    assert np.all(run["deck.slip"] == 0)
    assert np.abs(run["deck.friction_force"][slides]) == pytest.approx(0.2 * GRAVITY, rel=1e-6)
    assert run.engine.final["sled_x.travel"] == pytest.approx(1 / (2 * 0.2 * GRAVITY), rel=1e-8)
    assert abs(run.engine.final["cart_x.travel"]) < 1e-10
    assert run.energy_residual < 1e-7
    # 0.1 above, 0.3 below: the slab brakes faster and stands still under the block, which slides on for as long as 0.1 g takes.
    run = simulate(built(stack, 0.1, 0.3), duration="1.2 s", method=method, tolerance=1e-8)
    slab = (0.3 * 4 * GRAVITY - 0.1 * GRAVITY) / 3
    assert run.engine.final["sled_x.travel"] == pytest.approx(1 / (2 * slab), rel=1e-8)
    assert run.engine.final["cart_x.travel"] == pytest.approx(1 / (2 * 0.1 * GRAVITY) - 1 / (2 * slab), rel=1e-8)
    between = (run.t > 1 / slab + 0.01) & (run.t < 1 / (0.1 * GRAVITY) - 0.01)
    assert np.all(run["ground.slip"][between] == 0)
    assert np.abs(run["ground.friction_force"][between]) == pytest.approx(0.1 * GRAVITY, rel=1e-6)
    assert run.engine.final["sled_x.speed"] == pytest.approx(0, abs=1e-14)
    assert run.engine.final["cart_x.speed"] == pytest.approx(0, abs=1e-14)


# ---- an oscillator on a belt, written by hand ------------------------------------------------------------------------


@cache
def oscillator(mu_k, mu_s, load_force=10.0, spring=100.0):
    """A point of 1 kg on a spring, pressed on a belt by a constant force; start x0, v0; the belt moves at `belt`."""
    none = ca.SX(0, 1)
    module = with_tables(
        NAME="oscillator", SOURCE="tests/runtime/engine/integration/friction/test_coulomb.py", SUMMARY="",
        PARAMETERS=(("x0", "m", 0.0, ""), ("v0", "m/s", 0.0, ""), ("belt", "m/s", 0.0, "")),
        COORDINATES=(("path.travel", "m"),), SPEEDS=(("path.speed", "m/s"),), MEMORY=(("rub.dissipated", "J"),),
        SLIPS=(("touch.slip", "1", 0),), PAIRS=(("touch", "by_hand"),), RELEASES=("force",), DISSIPATED=(0,),
        CONSTANTS=(("belt", "m/s"),), BODIES=("point",),
        constants=lambda p: p[2],
        start=lambda p: (p[0], p[1]),
        scales=lambda p: (0.1, 1.0, 1.0, ca.SX([0.1, 1.0, 10.0, 1.0])),
        coordinate_rates=lambda t, q, u, c: u,
        gaps=lambda t, q, u, c: (ca.SX(-1), ca.SX(0)),
        gap_accelerations=lambda t, q, u, a, c: ca.SX(0),
        applied=lambda t, q, u, c: -spring * q,
        accelerations=lambda t, q, u, f, c: (f, none),
        contact_touch=lambda t, q, u, z, m, c: (
            ca.SX(0), ca.SX(0), ca.SX(load_force), u - c[0], ca.SX(1),
            ca.SX(1), -(u - c[0]), ca.SX(mu_k * load_force), ca.SX(mu_s * load_force),
        ),
        ledger=lambda t, q, u, reactions, c: ca.SX(0),
        energy=lambda t, q, u, c: (u * u / 2, spring * q * q / 2, ca.SX(0)),
        poses=lambda t, q, c: (ca.vertcat(q, 0, 0), ca.SX([1, 0, 0, 0, 1, 0, 0, 0, 1])),
        outputs=lambda t, q, u, c: none,
    )  # fmt: skip
    return EngineModel(module)


@pytest.mark.parametrize("method", [*METHODS, CVODES, IDAS])
def test_free_oscillations_lose_four_friction_lengths_each(method):
    """Turning points x0 - 2 n mu_k N/k, half a period apart, until one lies within mu_s N/k, where it stays."""
    way, x0 = 0.02, 0.115  # mu_k N/k, m; mu_s N/k = 0.03 m
    run = simulate(
        oscillator(0.2, 0.3), duration="2 s", method=method, tolerance=1e-8, parameters={"x0": f"{x0} m"}
    )  # fmt: skip
    changes = np.flatnonzero(np.diff(run["touch.slip"])) + 1
    turns = 3  # 0.115 -> -0.075 -> 0.035 -> 0.005
    assert run.t[changes] == pytest.approx([math.pi / 10 * n for n in range(1, turns + 1)], rel=1e-6)
    assert run["path.travel"][changes] == pytest.approx([-(x0 - 2 * way), x0 - 4 * way, -(x0 - 6 * way)], abs=2e-8)
    assert list(run["touch.slip"][changes]) == [1, -1, 0]
    assert run.engine.final["path.travel"] == pytest.approx(-(x0 - 6 * way), abs=2e-8)
    assert abs(run.engine.final["path.speed"]) < 1e-16
    assert run.energy_residual < (1e-6 if method in REFERENCES else 1e-7)


@pytest.mark.parametrize("method", [*METHODS, CVODES])
def test_stick_slip_on_a_belt_has_the_closed_period(method):
    """Sticks until k x = mu_s N, slips as a free oscillation about mu_k N/k until it meets the belt's speed again."""
    belt, omega, rise = 0.05, 10.0, 0.01  # rise: (mu_s - mu_k) N/k
    run = simulate(
        oscillator(0.2, 0.3), duration="6 s", method=method, tolerance=1e-9, parameters={"belt": f"{belt} m/s"}
    )
    slip = run["touch.slip"]
    lets_go = np.flatnonzero((slip[:-1] == 0) & (slip[1:] == -1)) + 1
    holds = np.flatnonzero((slip[:-1] == -1) & (slip[1:] == 0)) + 1
    sliding = 2 * (math.pi - math.atan(omega * rise / belt)) / omega
    assert len(lets_go) >= 5
    assert run["path.travel"][lets_go] == pytest.approx(0.03, rel=1e-7)
    assert np.diff(run.t[lets_go]) == pytest.approx(sliding + 2 * rise / belt, rel=1e-6)
    assert run.t[holds[1:5]] - run.t[lets_go[:4] if holds[0] < lets_go[0] else lets_go[1:5]] == pytest.approx(
        sliding, rel=1e-6
    )
    sticking = slip == 0
    assert run["path.speed"][sticking] == pytest.approx(belt, abs=1e-13)


@pytest.mark.exhaustive
def test_the_pin_of_the_slider_crank_slips_and_sticks_in_its_bush():
    """The smoothed law goes over into the set-valued one as its layer gets thinner."""
    mu = {"friction_coefficient": 0.1}
    sharp = slider_crank.scene.replace(
        slider_pin_friction=hd.Friction("slider_pin_friction", "slider_pin", dry(mu_k=0.1, mu_s=0.1))
    )
    model, smooth = engine_model(sharp), engine_model("slider_crank")
    options = {"duration": "6 ms", "tolerance": 1e-8}
    runs = {method: simulate(model, method=method, **options) for method in ("dop853", "esdirk", "cvodes")}
    travel = runs["dop853"].engine.final["guide.travel"]
    assert {-1.0, 0.0, 1.0} == set(runs["dop853"]["slider_pin.slip"])
    for method, run in runs.items():
        assert run.engine.final["guide.travel"] == pytest.approx(travel, abs=3e-8 if method in REFERENCES else 2e-9)
        assert run.energy_residual < 1e-6
    layers = ("1e-2 m/s", "1e-3 m/s", "1e-4 m/s")
    errors = [
        abs(
            simulate(smooth, method="esdirk", parameters=mu | {"friction_speed": layer}, **options).engine.final[
                "guide.travel"
            ]
            - travel
        )
        for layer in layers
    ]
    assert errors == sorted(errors, reverse=True)
    assert errors[-1] < 1e-7


# ---- the equations ---------------------------------------------------------------------------------------------------


@each("slips", [(0, 0), (0, 1), (-1, 0), (1, -1)])
@pytest.mark.parametrize("large", [False, True])
def test_jacobian_against_differences(monkeypatch, slips, large):
    """Through the solution of sticking written out, and as of a large model from the equations that it solves."""
    monkeypatch.setattr(implicit_step, "LARGE", 0 if large else math.inf)
    model = built.__wrapped__(sledge, rocks=True)
    bound = model.bind({"slope": 0.2})
    q, u = start_of(model, bound)
    u = u + np.array([0, 0.1, -0.02, 0.3])
    q[3] = 0.02  # level, the feet would be one: then only the sum of their forces is known
    q[2] -= 5e-3
    y = np.concatenate([q, u, np.zeros(model.nz)])
    # rounding of what both feet hold, over the step
    check_jacobian(model, y, np.ones(model.k), np.array(slips, dtype=float), bound, steps=1e-3, within=1e-5)
