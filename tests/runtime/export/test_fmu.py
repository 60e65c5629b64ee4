"""Exported functional mock-up units, validated and run by FMPy: bits of a run, states kept, derivatives, early return."""

import shutil
import subprocess
import zipfile
from pathlib import Path

import fmpy
import numpy as np
import pytest
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu
from libraries import FLAGS

import hertzwerk.derive as hd
from hertzwerk import InputError, simulate
from hertzwerk.runtime.engine.run.run_request import Settings
from hertzwerk.runtime.export import fmu
from hertzwerk.runtime.export.export_contents import ExportRequest
from hertzwerk.runtime.loading import engine_model

TOLERANCE, DURATION, MASS = 1e-8, 1.0, 0.5
HEADERS = Path(fmpy.__file__).parent / "c-code"
slug = hd.Body("slug", hd.Parameter("mass", "kg", MASS))
size = hd.Parameter("length_scale", "m", 0.01)
PUSHED = hd.Scene(
    hd.Mechanism(
        "pushed",
        joints=(hd.Prismatic("slide", hd.GROUND, slug, axis=hd.X),),
        pairs=(hd.SphereOnPlane("wall", slug.at(0, 0, 0), hd.Parameter("radius", "mm", 10), hd.GROUND.at(0, 0, 0), normal=hd.X),),
    ),
    (
        hd.JointForce("motor", "slide", hd.Input("push", "N", "force away from the wall")),
        hd.Contact("wall", hd.laws.power(hd.Parameter("stiffness", "N/m^1.5", 1e6), n=1.5), hd.laws.flores(e=hd.Parameter("restitution", "1", 0.8))),
        hd.EnergyLedger(),
    ),
    start=hd.Start(position={"slide": hd.Parameter("start_x", "m", 0.1)}),
    scales=hd.Scales(length=size, speed=size * hd.Parameter("pace", "rpm", 1000)),
)  # fmt: skip
UNKNOWNS = ("slide.travel", "slide.speed", "slide.acceleration")


def made(folder, model, name, fmi=3, duration=DURATION):
    file = folder / f"{name}.fmu"
    model = model.with_signals({}) if isinstance(model, str) else model
    requested = ExportRequest(model, {}, {}, Settings(duration, None, TOLERANCE, "dop853"), (), fmi)
    fmu.write(requested, file)
    return file


@pytest.fixture(scope="module", params=[pytest.param(2, marks=pytest.mark.slow), 3])
def pushed(request, tmp_path_factory):
    """The unit of a pushed mass, unpacked."""
    folder = tmp_path_factory.mktemp("pushed")
    file = made(folder, engine_model(PUSHED), "pushed_mass", request.param)
    return file, fmpy.read_model_description(file), fmpy.extract(file, folder / "unpacked")


class Unit:
    """A unit in step mode; FMI 2 and 3 by the same names."""

    def __init__(self, pushed, early=False, push=0.0, log=None, **starts):
        _, description, folder = pushed
        self.references = {v.name: v.valueReference for v in description.modelVariables}
        identity = {"modelIdentifier": description.coSimulation.modelIdentifier, "unzipDirectory": folder}
        kind, self.is_3 = (FMU3Slave, True) if description.fmiVersion == "3.0" else (FMU2Slave, False)
        self.unit = kind(guid=description.guid, instanceName="one", **identity)
        extra = {"earlyReturnAllowed": early, "logMessage": log} if self.is_3 else {}
        self.unit.instantiate(loggingOn=log is not None, **extra)
        if self.is_3:
            self.unit.enterInitializationMode(startTime=0.0, stopTime=DURATION)
        else:
            self.unit.setupExperiment(startTime=0.0, stopTime=DURATION)
            self.unit.enterInitializationMode()
        self.set(push=push, **starts)
        self.unit.exitInitializationMode()
        self.t = 0.0

    def set(self, **values):
        method = self.unit.setFloat64 if self.is_3 else self.unit.setReal
        method([self.references[name] for name in values], list(values.values()))

    def get(self, *names):
        method = self.unit.getFloat64 if self.is_3 else self.unit.getReal
        return np.array(method([self.references[name] for name in names]))

    def step(self, length):
        found = self.unit.doStep(currentCommunicationPoint=self.t, communicationStepSize=length)
        self.t = found[3] if self.is_3 else self.t + length
        return found

    def derivative(self, unknowns, known="push"):
        known = [self.references[known]]
        return np.array(self.unit.getDirectionalDerivative([self.references[name] for name in unknowns], known, [1.0]))


def test_it_is_valid_and_gives_the_bits_of_a_run(pushed):
    file, description, _ = pushed
    assert validate_fmu(str(file)) == []
    run = simulate(
        engine_model(PUSHED), duration=DURATION, tolerance=TOLERANCE, method="dop853", inputs={"push": "-3 N"}
    )
    assert len(run.impacts) > 2
    names = [v.name for v in description.modelVariables if v.causality == "output"]
    assert {"slide.travel", "wall.normal_force", "energy", "wall.dissipated"} <= {*names}
    whole, parts = Unit(pushed, push=-3.0), Unit(pushed, push=-3.0)
    whole.step(DURATION)
    assert whole.get(*names).tolist() == [run[name][-1] for name in names]
    for _ in range(50):
        parts.step(DURATION / 50)
    assert parts.get("slide.travel", "slide.speed") == pytest.approx(whole.get("slide.travel", "slide.speed"), abs=1e-6)


def test_it_reports_units_starts_and_causality(pushed):
    by_name = {v.name: v for v in pushed[1].modelVariables}
    actual = {name: (v.causality, v.variability, v.unit, v.displayUnit, v.start) for name, v in by_name.items()}
    assert actual["radius"] == ("parameter", "fixed", "m", "mm", "0.01")
    assert actual["stiffness"] == ("parameter", "fixed", "N/m^1.5", None, "1000000.0")
    assert actual["push"] == ("input", "continuous", "N", None, "0.0")
    assert actual["push.rate"][:3] == ("input", "continuous", "N/s")
    assert actual["start.slide.speed"] == ("parameter", "fixed", "m/s", None, "0.0")
    assert actual["start.slide.travel"] == ("parameter", "fixed", "m", None, "0.1")
    assert actual["slide.speed"] == ("output", "continuous", "m/s", None, None)
    assert actual["wall.mode"][:2] == ("output", "discrete")
    assert by_name["push"].description == "force away from the wall"
    units = {unit.name: unit.baseUnit for unit in pushed[1].unitDefinitions}
    assert (units["N"].kg, units["N"].m, units["N"].s) == (1, 1, -2)
    assert units["N/m^1.5"] is None
    shown = {row.name: float(row.factor) for unit in pushed[1].unitDefinitions for row in unit.displayUnits}
    assert shown == {"mm": 1000, "rpm": pytest.approx(60 / (2 * np.pi))}  # value shown = factor * value
    experiment = pushed[1].defaultExperiment
    assert (float(experiment.stopTime), float(experiment.tolerance)) == (DURATION, TOLERANCE)


def test_parameters_and_starts_are_set_before_the_motion(pushed):
    unit = Unit(pushed, push=0.0, mass=0.25, **{"start.slide.speed": -1.0})
    run = simulate(engine_model(PUSHED), duration=DURATION, tolerance=TOLERANCE, method="dop853", inputs={"push": "0 N"},
                   parameters={"mass": "0.25 kg"}, initial={"slide.speed": "-1 m/s"})  # fmt: skip
    unit.step(DURATION)
    assert unit.get("slide.travel").tolist() == [run["slide.travel"][-1]]
    with pytest.raises(Exception, match=r"(?i)error|failed"):
        unit.set(mass=1.0)


def test_inputs_are_held_or_go_on_at_a_rate(pushed):
    held, ramp = Unit(pushed), Unit(pushed)
    held.set(push=2.0)
    held.step(0.25)
    held.set(push=-1.0)
    held.step(0.25)
    speed = 2.0 * 0.25 / MASS
    expected = 0.1 + 2.0 * 0.25**2 / MASS / 2 + speed * 0.25 - 0.25**2 / MASS / 2
    assert held.get("slide.travel")[0] == pytest.approx(expected, rel=1e-12)
    ramp.set(push=1.0, **{"push.rate": 6.0})
    ramp.step(0.5)
    assert ramp.get("slide.travel")[0] == pytest.approx(0.1 + (0.5**2 / 2 + 0.5**3) / MASS, rel=1e-12)
    assert ramp.get("slide.acceleration")[0] == pytest.approx(4 / MASS, rel=1e-12)


def test_a_state_is_kept_in_mid_contact_as_bytes_too(pushed):
    unit = Unit(pushed, push=-3.0)
    while not unit.get("wall.mode")[0]:
        unit.step(1e-4)
    kept, t = (unit.unit.getFMUState if unit.is_3 else unit.unit.getFMUstate)(), unit.t
    names = ("slide.travel", "slide.speed", "wall.normal_force", "wall.dissipated")
    assert unit.get("wall.normal_force")[0] > 0
    unit.step(0.3)
    after = unit.get(*names)
    data = (unit.unit.serializeFMUState if unit.is_3 else unit.unit.serializeFMUstate)(kept)
    other = Unit(pushed)
    back = (other.unit.deserializeFMUState if other.is_3 else other.unit.deSerializeFMUstate)(data)
    for each, state in ((unit, kept), (other, back)):
        (each.unit.setFMUState if each.is_3 else each.unit.setFMUstate)(state)
        each.t = t
        assert each.get("wall.mode")[0] == 1
        each.step(0.3)
        assert each.get(*names).tolist() == after.tolist()
        (each.unit.freeFMUState if each.is_3 else each.unit.freeFMUstate)(state)


def test_derivatives_of_the_last_step_by_inputs(pushed):
    unit = Unit(pushed, push=2.0)
    unit.step(0.1)
    unit.step(0.2)  # of a free mass
    assert unit.derivative(UNKNOWNS) == pytest.approx([0.2**2 / 2 / MASS, 0.2 / MASS, 1 / MASS], rel=1e-6)
    assert unit.derivative(UNKNOWNS, "push.rate") == pytest.approx(
        [0.2**3 / 6 / MASS, 0.2**2 / 2 / MASS, 0.2 / MASS], rel=1e-6
    )
    unit = Unit(pushed, push=-3.0)
    unit.step(DURATION)  # through impacts: against runs under other forces
    step, settings = 1e-3, {"duration": DURATION, "tolerance": 1e-11, "method": "dop853"}
    ends = [simulate(engine_model(PUSHED), **settings, inputs={"push": f"{-3 + sign * step} N"}) for sign in (1, -1)]
    expected = [(ends[0][name][-1] - ends[1][name][-1]) / (2 * step) for name in UNKNOWNS[:2]]
    assert unit.derivative(UNKNOWNS[:2]) == pytest.approx(expected, rel=1e-4)


def test_it_returns_early_at_an_impact_where_requested_and_logs_it(pushed):
    said = []
    unit = Unit(pushed, early=True, push=-3.0, log=lambda _, status, *text: said.append((status, *text)))
    actual = unit.step(DURATION)
    if unit.is_3:
        assert actual[2]
        fall = (2 * (0.1 - 0.01) * MASS / 3) ** 0.5
        assert unit.t == pytest.approx(fall, rel=1e-9)
        assert unit.get("wall.mode")[0] == 1
        assert [(status, category) for status, category, _ in said] == [(0, b"logEvents")]
        assert b"1 impacts" in said[0][2]
        with pytest.raises(Exception, match=r"(?i)error|failed"):
            unit.step(-1.0)
        assert said[-1][:2] == (3, b"logStatusError")


@pytest.mark.slow
@pytest.mark.parametrize("compiler", ["gcc", "clang"])
def test_its_sources_keep_the_declarations_of_the_standard(compiler, pushed, tmp_path):
    if shutil.which(compiler) is None:
        pytest.skip(f"NOT TESTED: sources of units with {compiler}, as there is none")
    fmi = pushed[1].fmiVersion[0]
    source = Path(pushed[2]) / "sources" / "fmu.c"
    for headers in ((), ("-I", str(HEADERS), "-include", f"fmi{fmi}Functions.h")):
        flags = [flag for flag in FLAGS if not (headers and flag == "-pedantic")]
        command = [compiler, *flags, *headers, "-c", str(source), "-o", str(tmp_path / "fmu.o")]
        assert subprocess.run(command, capture_output=True, text=True).stderr == ""


def test_a_bad_name_and_an_existing_file_are_refused_at_once(tmp_path):
    taken = tmp_path / "2 balls.zip"
    taken.write_text("kept")
    faults = fmu.faults(taken)
    assert [fault.where for fault in faults] == ["--fmu"] * 3
    reported = " ".join(map(str, faults))
    for word in ("exists", ".fmu", "identifier"):
        assert word in reported
    assert [str(f) for f in fmu.faults(tmp_path / "while.fmu")] != []
    assert fmu.faults(tmp_path / "ball_1.fmu") == []
    with pytest.raises(InputError, match="SUNDIALS"):
        fmu.write(
            ExportRequest(engine_model("bouncing_ball"), {}, {}, Settings(1.0, None, TOLERANCE, "idas")),
            tmp_path / "a.fmu",
        )


def test_two_exports_are_the_same_bytes(pushed):
    file, description, _ = pushed
    with zipfile.ZipFile(file) as archive:
        places = archive.namelist()
        assert all(info.date_time == (1980, 1, 1, 0, 0, 0) for info in archive.infolist())
    assert "sources/pushed_mass.c" in places
    assert "sources/fmu.c" in places
    assert any(place.startswith("binaries/") for place in places)
    assert description.coSimulation.modelIdentifier == "pushed_mass"
