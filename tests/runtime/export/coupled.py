"""A rotor with a torque-speed line drives a slider-crank through a shaft: as one scene, and as two units that are stepped in turns.

`python tests/runtime/export/coupled.py` prints what co-simulation costs in accuracy, the table of howto/exchange/fmi.md of the handbook.
"""

import sys
import tempfile
from pathlib import Path

import fmpy
import numpy as np
from fmpy.fmi3 import FMU3Slave

import hertzwerk.derive as hd
from hertzwerk import simulate
from hertzwerk.derive.scenes.slider_crank import c, crank, l, mechanism, r, rod, slider, steel, w
from hertzwerk.runtime.engine.run.run_request import Settings
from hertzwerk.runtime.engine.solution.error_scales import error
from hertzwerk.runtime.export import fmu
from hertzwerk.runtime.export.export_contents import ExportRequest
from hertzwerk.runtime.loading import engine_model

DURATION, TOLERANCE, STEPS = 6e-3, 1e-9, (30, 100, 300, 1000, 3000)
STIFFNESS, DAMPING = 200.0, 0.05  # of the shaft [N m/rad, N m s/rad]
stiffness = hd.Parameter("shaft_stiffness", "N m/rad", STIFFNESS)
damping = hd.Parameter("shaft_damping", "N m s/rad", DAMPING)
rotor = hd.Body("rotor", hd.Parameter("rotor_mass", "kg", 1), hd.Parameter("rotor_inertia", "kg m^2", 2e-3))
shaft = hd.Revolute("shaft", hd.GROUND, rotor, axis=hd.Z)
engine = hd.JointForce(
    "engine", "shaft", hd.Parameter("stall", "N m", 20) * (1 - hd.speed_of("shaft") / hd.Parameter("idle", "rpm", 5500))
)
joints = (
    hd.Revolute("main_bearing", hd.GROUND, crank, axis=hd.Z),
    hd.Revolute("crank_pin", crank.at(r, 0, 0), rod, axis=hd.Z),
    hd.Prismatic("guide", hd.GROUND, slider, axis=hd.X),
)
effects = (
    hd.Contact("slider_pin", hd.laws.hertz_point(steel, steel), hd.laws.lankarani_nikravesh(hd.Parameter("restitution", "1", 0.9))),
    hd.Friction("slider_pin_friction", "slider_pin", hd.laws.smooth_coulomb(hd.Parameter("mu", "1", 0.1), hd.Parameter("v_s", "m/s", 0.1))),
    hd.EnergyLedger(),
)  # fmt: skip
speeds = {"main_bearing": w, "crank_pin": -w * (1 + r / l)}
scales = hd.Scales(length=c, speed=r * w, arm=l)


def torque(angle, speed):
    """Torque of the shaft on the crank, by angle and speed of its other end."""
    return stiffness * (angle - hd.coordinate_of("main_bearing")) + damping * (speed - hd.speed_of("main_bearing"))


twist = torque(hd.coordinate_of("shaft"), hd.speed_of("shaft"))
WHOLE = hd.Scene(
    hd.Mechanism("engine_and_crank", (shaft, *joints), mechanism.pairs),
    (engine, hd.JointForce("reaction", "shaft", -twist), hd.JointForce("twist", "main_bearing", twist), *effects),
    start=hd.Start(position={"guide": r + l, "main_bearing": 0, "shaft": 0}, speed={"shaft": w, **speeds}),
    scales=scales,
)
ENGINE = hd.Scene(
    hd.Mechanism("engine", (shaft,)), (engine, hd.JointForce("reaction", "shaft", -hd.Input("load", "N m")), hd.EnergyLedger()),
    start=hd.Start(speed={"shaft": w}), scales=scales,
)  # fmt: skip
CRANK = hd.Scene(
    hd.Mechanism("crank", joints, mechanism.pairs),
    (hd.JointForce("twist", "main_bearing", torque(hd.Input("shaft_angle", "rad"), hd.Input("shaft_speed", "rad/s"))), *effects),
    start=hd.Start(position={"guide": r + l, "main_bearing": 0}, speed=speeds), scales=scales,
)  # fmt: skip


class Part:
    """A unit of FMI 3.0 in step mode."""

    def __init__(self, scene, folder, **inputs):
        file = folder / f"{scene.name}.fmu"
        if not file.exists():
            fmu.write(ExportRequest(engine_model(scene), {}, {}, Settings(DURATION, None, TOLERANCE, "dop853")), file)
            fmpy.extract(file, folder / scene.name)
        about = fmpy.read_model_description(file)
        self.references = {v.name: v.valueReference for v in about.modelVariables}
        name = about.coSimulation.modelIdentifier
        self.unit = FMU3Slave(
            guid=about.guid, unzipDirectory=str(folder / scene.name), modelIdentifier=name, instanceName=name
        )
        self.unit.instantiate()
        self.unit.enterInitializationMode(startTime=0.0, stopTime=DURATION)
        self.set(**inputs)
        self.unit.exitInitializationMode()

    def set(self, **values):
        self.unit.setFloat64([self.references[name.replace("__", ".")] for name in values], list(values.values()))

    def get(self, *names):
        return self.unit.getFloat64([self.references[name] for name in names])

    def step(self, t, length):
        self.unit.doStep(currentCommunicationPoint=t, communicationStepSize=length)


def coupled(folder, steps, linear):
    """States by name at the end of both units, stepped at the same time; inputs are held, or go on as they changed."""
    wide = DURATION / steps
    one, other = (
        Part(ENGINE, folder, load=0.0),
        Part(CRANK, folder, shaft_angle=0.0, shaft_speed=float(5000 * np.pi / 30)),
    )
    before = None
    for k in range(steps):
        angle, speed, acceleration = one.get("shaft.angle", "shaft.speed", "shaft.acceleration")
        turned, turning = other.get("main_bearing.angle", "main_bearing.speed")
        load_now = STIFFNESS * (angle - turned) + DAMPING * (speed - turning)
        rates = {}
        if linear:
            rates = {"load__rate": 0.0 if before is None else (load_now - before) / wide}
        one.set(load=load_now, **rates)
        rates = {"shaft_angle__rate": speed, "shaft_speed__rate": acceleration} if linear else {}
        other.set(shaft_angle=angle, shaft_speed=speed, **rates)
        before = load_now
        for part in (one, other):
            part.step(k * wide, wide)
    return {name: part.get(name)[0] for part in (one, other) for name in part.references if name in WHOLE_STATES}


WHOLE_STATES = ["shaft.angle", "main_bearing.angle", "crank_pin.angle", "guide.travel"]
WHOLE_STATES += [f"{joint}.speed" for joint in ("shaft", "main_bearing", "crank_pin", "guide")]


def study(folder, steps=STEPS):
    """Rows (communication step [s], error with held inputs, with linear ones), and the error of the scene itself."""
    model = engine_model(WHOLE)
    whole, check = (
        simulate(model, duration=DURATION, tolerance=each, method="dop853") for each in (TOLERANCE, TOLERANCE / 100)
    )

    def error_of(ends):
        y = np.array([ends(name) for name in (*model.coordinates, *model.speeds)])
        exact = np.array([check[name][-1] for name in (*model.coordinates, *model.speeds)])
        return float(error(model, whole.engine.scales, y, exact))

    rows = [(DURATION / n, *(error_of(coupled(folder, n, linear).get) for linear in (False, True))) for n in steps]
    return rows, error_of(lambda name: whole[name][-1]), len(whole.impacts)


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as place:
        rows, own, impacts = study(Path(place), [int(n) for n in sys.argv[1:]] or STEPS)
    print(f"{impacts} impacts; the scene itself: {own:.1e}")
    print("| communication step | inputs held | inputs linear |\n|---|---|---|")
    for wide, *errors in rows:
        print(f"| {wide * 1e6:g} us | {' | '.join(f'{x:.1e}' for x in errors)} |")
