"""Readings of a run against closed forms, textbook equations, and the multipliers of absolute coordinates."""

from dataclasses import dataclass, replace

import numpy as np
import pytest
from commands import called

import hertzwerk.derive as hd
from hertzwerk.derive.common.module_format import sealed
from hertzwerk.derive.scenes import NAMES
from hertzwerk.runtime import Model, Solution, simulate, sweep
from hertzwerk.runtime.engine.integration.step.explicit_step import flow
from hertzwerk.runtime.engine.model.generated_text import module_of, text_of
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.solution.dense_output import Samples
from hertzwerk.runtime.engine.solution.history import History
from hertzwerk.runtime.loading import engine_model

R, L, S, MC, MR, MS, JR, W, G = 0.05, 0.16, 0.06, 0.3, 0.2, 0.4, 3e-4, 150.0, 9.81
REDUNDANT = ("bricard", "flyball_governor")  # what holds their loops is open by redundancy, and so differs


def gravity():
    return hd.Gravity("weight", hd.Parameter("gravity", "m/s^2", G), direction=-hd.Y)


@pytest.fixture(scope="module")
def crank_run():
    """An ideal slider-crank: its slider's guide closes the loop."""
    r, length = hd.Parameter("r", "m", R), hd.Parameter("l", "m", L)
    crank = hd.Body("crank", hd.Parameter("crank_mass", "kg", MC), hd.Parameter("crank_inertia", "kg m^2", 1e-4))
    rod = hd.Body(
        "rod", hd.Parameter("rod_mass", "kg", MR), hd.Parameter("rod_inertia", "kg m^2", JR), centre=(hd.Parameter("s", "m", S), 0, 0),
    )  # fmt: skip
    slider = hd.Body("slider", hd.Parameter("slider_mass", "kg", MS), hd.Parameter("slider_inertia", "kg m^2", 1e-4))
    joints = (
        hd.Revolute("main", hd.GROUND, crank, axis=hd.Z), hd.Revolute("knee", crank.at(r, 0, 0), rod, axis=hd.Z),
        hd.Revolute("wrist", rod.at(length, 0, 0), slider, axis=hd.Z), hd.Prismatic("guide", hd.GROUND, slider, axis=hd.X),
    )  # fmt: skip
    motor = hd.ConstantSpeed("motor", "main", hd.Parameter("speed", "rad/s", W))
    scene = hd.Scene(
        hd.Mechanism("ideal_crank", joints),
        effects=(motor, gravity(), hd.EnergyLedger()),
        scales=hd.Scales(length=r, speed=hd.Parameter("pace", "m/s", 5), arm=r),
    )
    return simulate(engine_model(scene), duration="30 ms", tolerance=1e-11)


def textbook(angle):
    """Positions of the mass centres of rod and slider, the rod's angle, and the generalised inertia I(angle)."""
    sine = -R * np.sin(angle) / L
    cosine, turn = np.sqrt(1 - sine**2), -R * np.cos(angle) / L
    rate = turn / cosine  # of the rod's angle
    x_rate = -R * np.sin(angle) - L * sine * rate
    rod_rate = -R * np.sin(angle) - S * sine * rate, R * np.cos(angle) + S * cosine * rate
    inertia = 1e-4 + MR * (rod_rate[0] ** 2 + rod_rate[1] ** 2) + JR * rate**2 + MS * x_rate**2
    height = MR * (R * np.sin(angle) + S * sine)
    return R * np.cos(angle) + L * cosine, x_rate, rod_rate[0], inertia, G * height


def derivative(of, angle):
    return of(angle + 1e-30j).imag / 1e-30


def test_driving_torque_and_reactions_of_the_ground_are_those_of_the_textbook(crank_run):
    angle = crank_run["main.angle"]
    np.testing.assert_allclose(angle, W * crank_run.t, rtol=1e-14)
    torque = W**2 / 2 * derivative(lambda a: textbook(a)[3], angle) + derivative(lambda a: textbook(a)[4], angle)
    np.testing.assert_allclose(crank_run["motor.torque"], torque, atol=1e-7 * np.abs(torque).max())
    np.testing.assert_allclose(crank_run["motor.power"], W * torque, atol=1e-7 * W * np.abs(torque).max())
    put_in = Samples(crank_run)
    scale = np.abs(crank_run["energy_ledger.input"]).max()
    assert put_in.integral(lambda history: history["motor.power"]) == pytest.approx(
        crank_run["energy_ledger.input"][-1], abs=1e-7 * scale
    )
    run = crank_run
    np.testing.assert_allclose(run["slider.x"], textbook(angle)[0], atol=1e-9)
    momentum = W * (MR * textbook(angle)[2] + MS * textbook(angle)[1])  # along the guide
    np.testing.assert_allclose(run["rod.momentum_x"] + run["slider.momentum_x"], momentum, atol=1e-7)
    rate = W**2 * derivative(lambda a: MR * textbook(a)[2] + MS * textbook(a)[1], angle)
    np.testing.assert_allclose(run["main.reaction_x"], rate, atol=1e-7 * np.abs(rate).max())
    weight = (MC + MR + MS) * G
    vertical = run["main.reaction_y"] + run["guide.reaction_y"] - weight
    np.testing.assert_allclose(vertical, MR * run["rod.y_acceleration"], atol=1e-7 * np.abs(vertical).max())
    along = MS * W**2 * derivative(lambda a: textbook(a)[1], angle)
    np.testing.assert_allclose(run["wrist.reaction_x"], along, atol=1e-7 * np.abs(along).max())
    np.testing.assert_allclose(run["guide.acceleration"], along / MS, atol=1e-7 * np.abs(along / MS).max())
    np.testing.assert_allclose(run["guide.force_y"], run["guide.reaction_y"], rtol=1e-12)  # its multiplier


@dataclass(frozen=True, init=False)
class Polar(hd.Joint):
    """A turn about Z, then a slide along X: `angle`, `travel`."""

    def __init__(self, name, parent, child):
        super().__init__(name, parent, child)

    @property
    def freedoms(self):
        return self.turn(hd.Z), self.slide(hd.X)


def test_a_slide_beyond_a_turn_is_held_by_a_force_and_a_couple_that_do_no_work():
    """x = 0.1 cosh(w t): the force across is 2 m w x'; about the axis, which the drive turns, the joint has no moment."""
    bead = hd.Body("bead", hd.Parameter("bead_mass", "kg", 0.2), hd.Parameter("bead_inertia", "kg m^2", 1e-4))
    scene = hd.Scene(
        hd.Mechanism("polar", (Polar("arm", hd.GROUND, bead),)), (hd.ConstantSpeed("drive", "arm.angle", hd.Parameter("w", "rad/s", 3.0)),),
        hd.Scales(hd.Parameter("size", "m", 0.1), hd.Parameter("pace", "m/s", 1.0)), hd.Start({"arm.travel": hd.Parameter("x_0", "m", 0.1)}),
    )  # fmt: skip
    run = simulate(engine_model(scene), duration=0.7, tolerance=1e-11)
    x, across = 0.1 * np.cosh(3 * run.t), 0.2 * 2 * 3 * 0.3 * np.sinh(3 * run.t)
    assert run["arm.reaction_x"] == pytest.approx(-np.sin(3 * run.t) * across, abs=1e-8)
    assert run["arm.reaction_y"] == pytest.approx(np.cos(3 * run.t) * across, abs=1e-8)
    assert run["arm.reaction_moment_z"] == pytest.approx(-x * across, abs=1e-8)
    assert run["drive.torque"] == pytest.approx(x * across, abs=1e-8)


def test_a_tilted_disc_on_a_turning_shaft_is_held_by_its_gyroscopic_couple():
    """W x H, with H along the disc's axis and across it; of an upright disc it is J w W."""
    axial, across, spin, turn, tilt = 0.02, 0.013, 40.0, 3.0, 0.4
    frame = hd.Body("frame", hd.Parameter("frame_mass", "kg", 1.0), hd.Parameter("frame_inertia", "kg m^2", 0.1))
    inertia = hd.Parameter("axial", "kg m^2", axial), *[hd.Parameter("across", "kg m^2", across)] * 2
    disc = hd.Body("disc", hd.Parameter("disc_mass", "kg", 2.0), inertia)
    bearing = frame.at(0, 0, 0).turned(hd.Z, hd.Parameter("tilt", "rad", tilt))
    scene = hd.Scene(
        hd.Mechanism(
            "gyroscope",
            (hd.Revolute("shaft", hd.GROUND, frame, axis=hd.Y), hd.Revolute("axle", bearing, disc, axis=hd.X)),
        ),
        (
            hd.ConstantSpeed("drive", "shaft", hd.Parameter("turn", "rad/s", turn)),
            hd.ConstantSpeed("motor", "axle", hd.Parameter("spin", "rad/s", spin)),
            hd.EnergyLedger(),
        ),
        hd.Scales(hd.Parameter("size", "m", 0.1), hd.Parameter("pace", "m/s", 1.0)),
    )
    run = simulate(engine_model(scene), duration=0.5)
    rate = turn * np.cos(tilt) * (axial * (spin + turn * np.sin(tilt)) - across * turn * np.sin(tilt))
    assert run["axle.reaction_moment_x"] == pytest.approx(-rate * np.sin(turn * run.t), abs=1e-9)
    assert run["axle.reaction_moment_z"] == pytest.approx(-rate * np.cos(turn * run.t), abs=1e-9)


@pytest.fixture(scope="module")
def rattling():
    return simulate(engine_model("slider_crank"), duration="3 ms", tolerance=1e-8)


def test_contact_force_is_a_vector_that_moves_the_slider(rattling):
    run = rattling
    touching = run["slider_pin.mode"] == 1
    assert 20 < touching.sum() < len(touching)
    force = np.array([run["slider_pin.force_x"], run["slider_pin.force_y"]])  # on the rod, as its pin is named first
    np.testing.assert_allclose(force[0], -0.14 * run["guide.acceleration"], atol=1e-8 * np.abs(force).max())
    size = np.hypot(run["slider_pin.normal_force"], run["slider_pin.friction_force"])
    np.testing.assert_allclose(np.hypot(*force)[touching], size[touching], rtol=1e-9)
    np.testing.assert_array_less(run["slider_pin.friction_force"] * run["slider_pin.sliding_velocity"], 1e-12)
    bush = 10e-3 - run["slider_pin.penetration"][touching] * 0
    at = np.hypot(run["slider_pin.point_x"] - run["guide.travel"], run["slider_pin.point_y"])[touching]
    np.testing.assert_allclose(at, bush + run["slider_pin.penetration"][touching], atol=1e-12)
    assert np.isnan(run["slider_pin.point_x"][~touching]).all()
    power = run["slider_pin.power"] + run["slider_pin_friction.power"]
    assert power[touching].max() > 0


def carried(run, other):
    """Histories of a model in absolute coordinates at the states of a run in joint coordinates."""
    there, here, model = (
        simulate(other, duration=1e-9, tolerance=1e-3).engine.history, run.engine.history, run.engine.model,
    )  # fmt: skip
    rows, bound = np.repeat(there.rows[:1], len(here.rows), axis=0), other.bind()
    for i, (t, y, mode, m, friction) in enumerate(
        zip(*map(here.part, ("t", "y", "mode", "m", "friction")), strict=True)
    ):
        q, u = other.evaluate("placed", float(t[0]), y[: model.nq], y[model.nq : model.nq + model.nu], bound.c)
        given = {
            "t": t, "y": np.concatenate([q, u, y[model.nq + model.nu :]]), "mode": mode, "m": m, "friction": friction,
        }  # fmt: skip
        given["dy"] = np.array(flow(other).rates(t, given["y"], mode, m, bound.c)).ravel()
        for name, values in given.items():
            rows[i, there.columns(name)] = values
    return History(other, rows, there.controls, there.integrator, steps=False, p=there.p)


def worst_reaction(name, model):
    """Largest difference of a joint's reaction to its multiplier in absolute coordinates, over the largest there.

    By an explicit method: accelerations within an implicit step are as exact as its tolerance.
    """
    seconds = 4e-3 if "crank" in name else 2e-2
    run = simulate(model, duration=seconds, tolerance=1e-7, grid=5, method="dop853")
    there = carried(run, engine_model(name, coordinates="absolute"))
    pairs = [
        (f"{of}.reaction_{what.split('_')[1]}", f"{of}.{what}")
        for of, _, what in (entry.partition(".") for entry in there)
        if what in ("force_x", "force_y", "force_z") and f"{of}.reaction_x" in there.units and of not in model.pairs
    ]
    pairs += [
        (each, each) for each in there.units.everything if ".reaction" in each or each.endswith((".torque", ".power"))
    ]
    # across the plane of motion a tree has none where it is zero by structure
    found = {one: (run[one] if one in run.engine.history.units else np.zeros(5), there[other]) for one, other in pairs}
    scale = {}
    for one, (value, _) in found.items():
        kind = one.rpartition(".")[2].rstrip("xyz")
        scale[kind] = max(scale.get(kind, 1e-6), np.abs(value).max())
    arm = 1e-3  # m: where no joint carries a moment, what rounding leaves is that of forces at some arm
    scale["reaction_moment_"] = max(scale.get("reaction_moment_", 0), arm * scale.get("reaction_", 0))
    return max(
        (np.abs(a - b).max() / scale[one.rpartition(".")[2].rstrip("xyz")] for one, (a, b) in found.items()),
        default=0.0,
    )


@pytest.mark.by_turns(12)
@pytest.mark.parametrize(
    "name",
    [
        pytest.param(
            name,
            marks=[pytest.mark.exhaustive]
            * (name in ("ball_bearing", "gears_with_backlash", "geneva_drive", "worn_slider_crank")),
        )
        for name in sorted(set(NAMES) - set(REDUNDANT))
    ],
)
def test_reactions_of_a_tree_are_the_multipliers_of_absolute_coordinates(name):
    assert worst_reaction(name, engine_model(name)) < 1e-9


def test_a_fault_in_the_inertia_is_seen():
    model = engine_model("double_pendulum")
    text = model.declaration.readings("tree")
    assert worst_reaction("double_pendulum", model) < 1e-9
    wrong = sealed(text.replace("gravity = p[", "gravity = 1.0001*p["))
    assert wrong != text
    faulty = EngineModel(model.module, replace(model.declaration))
    faulty.declaration.__dict__["_readings"] = {"tree": wrong}
    assert worst_reaction("double_pendulum", faulty) > 1e-6


def test_all_names_are_reported_and_used_wherever_a_history_is(rattling, tmp_path):
    entries = {entry.name: entry for entry in Model(rattling.engine.model).histories}
    assert entries["crank_drive.torque"].derived and not entries["guide.travel"].derived
    assert (
        entries["main_bearing.reaction_x"].unit == "N" and "main_bearing" in entries["main_bearing.reaction_x"].meaning
    )
    assert "rod.x" not in list(rattling)
    beside = rattling.with_histories("rod.x", "crank_drive.power")
    assert list(beside)[-2:] == ["rod.x", "crank_drive.power"]
    again = Solution.load(beside.save(tmp_path / "run.npz"))
    np.testing.assert_array_equal(again["rod.x"], rattling["rod.x"])
    assert again.engine.history.units["rod.x"] == "m"
    with pytest.raises(KeyError, match="with_histories"):
        again["rod.y"]
    with pytest.raises(KeyError, match="did you mean"):
        rattling["rod.xx"]
    assert beside.to_file(tmp_path / "run.csv").read_text().splitlines()[0].endswith("rod.x [m],crank_drive.power [W]")
    table = sweep("slider_crank", over={"clearance": "0.1, 0.2 mm"}, duration="1 ms", tolerance=1e-6,
                  outputs=["crank_drive.torque.max"], histories=["rod.y"], grid=5)  # fmt: skip
    assert (table["crank_drive.torque.max"] > 0).all() and len(table.histories["rod.y"][0]) == 5
    with pytest.raises(hd.InputError, match=r"rod\.z\.max"):
        sweep("slider_crank", over={"clearance": "0.1, 0.2 mm"}, duration="1 ms", outputs=["rod.z.max"])


def test_a_module_alone_says_where_readings_come_from():
    alone = EngineModel(module_of("alone", text_of(engine_model("pendulum").module)))
    run = simulate(alone, duration="10 ms", tolerance=1e-6)
    with pytest.raises(KeyError, match=r"load the scene, of derive/scenes/pendulum\.py, and simulate"):
        run["hinge.reaction_x"]
    with pytest.raises(hd.InputError, match=r"load\('pendulum'\)"):
        alone.reading_module()


def test_commands_list_and_write_readings(tmp_path):
    actual = called("list", "pendulum").output
    assert "hinge.reaction_x" in actual and "kg m^2/s" in actual
    out = tmp_path / "run"
    called("run", "pendulum", "--duration=10 ms", "--no-plots", f"--out={out}", "--history=hinge.reaction_y")
    assert "hinge.reaction_y [N]" in (out / "states.csv").read_text().splitlines()[0]
    assert "hinge.reaction_y" in called("run", "pendulum", "--history", "hinge.reaction_q", code=2).output
