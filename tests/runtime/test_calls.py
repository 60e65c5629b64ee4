"""Calls that a person would try, right and wrong, of every public function: none ends in an error from within.

A wrong call is refused before anything runs, by an error that says what was found; a right one returns something.
"""

from functools import cache
from pathlib import Path

import numpy as np
import pint
import pytest
from each import each

from hertzwerk import derive, runtime
from hertzwerk.derive.common.faults import InputError
from hertzwerk.derive.scenes.bouncing_ball import scene
from hertzwerk.runtime import simulation
from hertzwerk.runtime.engine.run import continuation

T = np.linspace(0, 0.058, 30)
HOW = {"duration": "10 ms", "tolerance": 1e-6}


@cache
def given():
    """Names in the calls and what they are."""
    return {
        **{name: getattr(runtime, name) for name in runtime.__all__},
        **{"ball": runtime.load("bouncing_ball"), "derive": derive, "scene": scene, "np": np, "Path": Path, "T": T},
        **{"HOW": HOW, "FREE": {"drop_height": "0.9..1.1 m"}, "LAWS": {"floor": ["flores", "hunt_crossley"]}},
        "mm": pint.UnitRegistry().mm,
        "run": runtime.simulate("bouncing_ball", **HOW, sensitivities=["mass"]),
        "limit": runtime.rigid_limit("bouncing_ball", runtime.RigidImpact(0.5), **HOW),
        "table": runtime.simulate_many("bouncing_ball", [{}], **HOW, workers=1),
        "still": runtime.modes("bouncing_ball"),
        "wave": runtime.Measurement(T, {"vertical.travel": 1.1 - 4.905 * T**2}, {"vertical.travel": "m"}),
    }


WRONG = """
load("bouncing_bal")  ->  did you mean bouncing_ball
load("no_such_file.py")  ->  no_such_file.py
load(Path("no_such_file.py"))  ->  no_such_file.py
load(3)  ->  target: found 3
load(None)  ->  target: found None
load([scene])  ->  the name of a built-in scene
load("bouncing_ball", without="gravity")  ->  without: found 'gravity'
load("bouncing_ball", without=["gravety"])  ->  gravety
load("bouncing_ball", laws="flores")  ->  laws: found 'flores'
load("bouncing_ball", laws={"floor": "florez"})  ->  florez
load("bouncing_ball", laws={"flor": "flores"})  ->  flor
load("bouncing_ball", coordinates="polar")  ->  polar
load("bouncing_ball", coordinates=2)  ->  coordinates: found 2
simulate("bouncing_bal", **HOW)  ->  did you mean bouncing_ball
simulate(3, **HOW)  ->  target: found 3
simulate(run, **HOW)  ->  target: found
simulate(ball)  ->  duration: found none
simulate(ball, duration="soon")  ->  duration: found 'soon'
simulate(ball, duration=-1)  ->  duration: found -1
simulate(ball, duration=0)  ->  duration: found 0
simulate(ball, duration="1 kg")  ->  duration: found '1 kg'
simulate(ball, duration="2 rev")  ->  one drive of constant speed
simulate(ball, duration=3 * mm)  ->  duration: found
simulate(ball, duration=True)  ->  duration: found True
simulate(ball, duration="1 s", accuracy="good")  ->  accuracy: found 'good'
simulate(ball, duration="1 s", accuracy=2)  ->  accuracy: found 2
simulate(ball, duration="1 s", tolerance=0)  ->  tolerance: found 0
simulate(ball, duration="1 s", tolerance="1e-6")  ->  tolerance: found '1e-6'
simulate(ball, duration="1 s", accuracy=1e-6, tolerance=1e-6)  ->  one of the two
simulate(ball, **HOW, method="rk4")  ->  rk4
simulate(ball, **HOW, method=5)  ->  method: found 5
simulate(ball, **HOW, method=None)  ->  method: found None
simulate(ball, **HOW, parameters="mass=1")  ->  parameters: found 'mass=1'
simulate(ball, **HOW, parameters=["mass"])  ->  parameters: found
simulate(ball, **HOW, parameters={"mas": "1 kg"})  ->  did you mean mass
simulate(ball, **HOW, parameters={"mass": 1})  ->  a number without a unit
simulate(ball, **HOW, parameters={"mass": "1 m"})  ->  which is m
simulate(ball, **HOW, parameters={"mass": "heavy"})  ->  'heavy'
simulate(ball, **HOW, parameters={"mass": None})  ->  mass: found None
simulate(ball, **HOW, parameters={"mass": "-1 kg"})  ->  mass: found -1 kg
simulate(ball, **HOW, parameters={"mass": 3 * mm})  ->  found 3 mm, which is m
simulate(ball, **HOW, parameters={"mass": float("nan")})  ->  mass
simulate(ball, **HOW, parameters={3: "1 kg"})  ->  3
simulate(ball, **HOW, initial={"height": "1 m"})  ->  height
simulate(ball, **HOW, initial={"vertical.travel": "1 s"})  ->  which is s
simulate(ball, **HOW, initial=run)  ->  floor.gap
simulate(ball, **HOW, initial=1.0)  ->  initial: found 1.0
simulate(ball, **HOW, inputs={"torque": "1 N m"})  ->  torque
simulate(ball, **HOW, inputs=[1, 2])  ->  inputs: found
simulate(ball, **HOW, inputs=np.zeros(3))  ->  inputs: found
simulate(ball, **HOW, grid=1)  ->  grid: found 1 points
simulate(ball, **HOW, grid="steps")  ->  grid: found 'steps'
simulate(ball, **HOW, grid=[0.0, 1.0])  ->  times within the run
simulate(ball, **HOW, grid=[2e-3, 1e-3])  ->  increasing times
simulate(ball, **HOW, grid={"dt": 1e-3})  ->  grid: found
simulate(ball, **HOW, compiled="yes")  ->  compiled: found 'yes'
simulate(ball, **HOW, compiled=1)  ->  compiled: found 1
simulate(ball, **HOW, max_steps=1.5)  ->  max_steps: found 1.5
simulate(ball, **HOW, max_steps=0)  ->  max_steps: found 0
simulate(ball, **HOW, max_steps="many")  ->  max_steps: found 'many'
simulate(ball, **HOW, max_events=-1)  ->  max_events: found -1
simulate(ball, **HOW, max_events=2.5)  ->  max_events: found 2.5
simulate(ball, **HOW, wall_time="1 min")  ->  wall_time: found '1 min'
simulate(ball, **HOW, sensitivities="mass")  ->  sensitivities: found 'mass'
simulate(ball, **HOW, sensitivities=["mas"])  ->  did you mean mass
simulate(ball, **HOW, sensitivities=3)  ->  sensitivities: found 3
simulate(ball, **HOW, progress=3)  ->  progress: found 3
simulate(ball, **HOW, progress=True)  ->  progress: found True
simulate_many(ball, {"mass": "1 kg"}, **HOW)  ->  parameter_sets: found
simulate_many(ball, "mass", **HOW)  ->  parameter_sets: found 'mass'
simulate_many(ball, [1, 2], **HOW)  ->  parameter_sets, row 0
simulate_many(ball, None, **HOW)  ->  parameter_sets: found None
simulate_many(ball, [{}], **HOW, workers=0)  ->  workers: found 0
simulate_many(ball, [{}], **HOW, workers="all")  ->  workers: found 'all'
simulate_many(ball, [{}], **HOW, functions=len)  ->  functions: found
simulate_many(ball, [{}], **HOW, functions={"x": 3})  ->  functions['x']: found 3
simulate_many(ball, [{}], **HOW, functions={"impacts": len})  ->  the name of another column
simulate_many(ball, [{}], **HOW, parameters={"mas": 1})  ->  did you mean mass
simulate_many(ball, [{}], **HOW, max_steps=2.5)  ->  max_steps: found 2.5
simulate_many(ball, [{}], **HOW, progress="bar")  ->  progress: found 'bar'
sweep(ball, "mass", **HOW)  ->  over
sweep(ball, {}, **HOW)  ->  over
sweep(ball, {"mas": "1, 2 kg"}, **HOW)  ->  did you mean mass
sweep(ball, {"mass": "1..2 m:3"}, **HOW)  ->  which is m
sweep(ball, {"mass": "1..2 kg"}, **HOW)  ->  mass
sweep(ball, {"mass": []}, **HOW)  ->  mass
sweep(ball, {"mass": 3 * mm}, **HOW)  ->  mass
sweep(ball, {"mass": None}, **HOW)  ->  mass
sweep(ball, {"mass": "1, 2 kg"}, **HOW, parameters={"mass": "1 kg"})  ->  among parameters and over
sweep(ball, {"mass": "1, 2 kg"}, **HOW, outputs=["peak"])  ->  peak
sweep(ball, {"mass": "1, 2 kg"}, **HOW, outputs="final.vertical.travel")  ->  outputs
sweep(ball, {"mass": "1, 2 kg"}, **HOW, outputs=3)  ->  outputs
sweep(ball, {"mass": "1..2 kg"}, **HOW, sample=0)  ->  sample
sweep(ball, {"mass": "1..2 kg"}, **HOW, sample=4, sampler="monte")  ->  monte
sweep(ball, {"mass": "1, 2 kg"}, **HOW, zip=T)  ->  zip: found array
sweep(ball, {"mass": "1, 2 kg"}, **HOW, after=T)  ->  after: found array
sweep(ball, {"mass": "1, 2 kg"}, **HOW, histories=T)  ->  histories: found array
sweep(ball, {"mass": "1, 2 kg"}, **HOW, continued=T)  ->  continued: found array
sweep(ball, {"mass": "1, 2 kg"}, **HOW, zip="no")  ->  zip
sweep(ball, {"mass": "1, 2 kg"}, **HOW, section="floor")  ->  section
sweep(ball, {"mass": "1, 2 kg"}, **HOW, section=3)  ->  section
sweep(ball, {"mass": "1, 2 kg"}, **HOW, grid="steps")  ->  grid: found 'steps'
sweep(ball, {"mass": "1, 2 kg"}, **HOW, continued="left")  ->  continued
sweep(ball, {"mass": "1, 2 kg"}, **HOW, functions={"mass": len})  ->  the name of another column
sweep(ball, {"mass": "1, 2 kg"}, **HOW, workers=1.5)  ->  workers: found 1.5
sweep(ball, {"mass": "1, 2 kg"}, **HOW, out=5)  ->  out: found 5
sweep(ball, {"mass": "1, 2 kg"}, **HOW, out="rows", widen="no")  ->  widen: found 'no'
sweep(ball, {"mass": "1, 2 kg"}, **HOW, without=["gravety"])  ->  gravety
sweep(ball, {"mass": "1, 2 kg"}, **HOW, progress=3)  ->  progress: found 3
propagate(ball, {"mass": "1 kg"}, **HOW)  ->  mass
propagate(ball, {"mass": "Normal(1 kg)"}, **HOW)  ->  mass
propagate(ball, {"mass": Normal("1 kg", "1 m")}, **HOW)  ->  mass
propagate(ball, {"mas": Normal("1 kg", "1 g")}, **HOW)  ->  did you mean mass
propagate(ball, {"mass": Uniform("1 kg", "2 kg")}, **HOW, workers=T)  ->  workers: found array
propagate(ball, "mass", **HOW)  ->  uncertain
propagate(ball, {}, **HOW)  ->  uncertain
propagate(ball, {"mass": Uniform("2 kg", "1 kg")}, **HOW)  ->  mass
propagate(ball, {"mass": Uniform("1 kg", "2 kg")}, **HOW, sample=10)  ->  a power of two
propagate(ball, {"mass": Uniform("1 kg", "2 kg")}, **HOW, sample="8")  ->  sample: found '8'
propagate(ball, {"mass": Uniform("1 kg", "2 kg")}, **HOW, seed="x")  ->  seed: found 'x'
propagate(ball, {"mass": Uniform("1 kg", "2 kg")}, **HOW, indices="no")  ->  indices: found 'no'
propagate(ball, {"mass": Uniform("1 kg", "2 kg")}, **HOW, correlation={"mass, no": 0.5})  ->  no
propagate(ball, {"mass": Uniform("1 kg", "2 kg")}, ["final.speed"], **HOW)  ->  final.speed
minimise(ball, "final.vertical.travel", {"mass": "1 kg"}, **HOW)  ->  mass
minimise(ball, "final.vertical.travle", {"mass": "1..2 kg"}, **HOW)  ->  final.vertical.travle
minimise(ball, "final.vertical.travel + mass", {"mass": "1..2 kg"}, **HOW)  ->  objective
minimise(ball, 3, {"mass": "1..2 kg"}, **HOW)  ->  objective
minimise(ball, "__import__('os')", {"mass": "1..2 kg"}, **HOW)  ->  os: found no sweep output
minimise(ball, "final.vertical.travel", {"mass": "2..1 kg"}, **HOW)  ->  mass
minimise(ball, "final.vertical.travel", "mass", **HOW)  ->  over
minimise(ball, "final.vertical.travel", {"mass": "1..2 kg"}, ["<= 1 m"], **HOW)  ->  constraints
minimise(ball, "final.vertical.travel", {"mass": "1..2 kg"}, {"final.vertical.travel": 1}, **HOW)  ->  a bound, such as
minimise(ball, "final.vertical.travel", {"mass": "1..2 kg"}, {"final.vertical.travel": "<= 1 kg"}, **HOW)  ->  which is kg
minimise(ball, "final.vertical.travel", {"mass": "1..2 kg"}, **HOW, start={"mass": "9 kg"})  ->  a value within its range
minimise(ball, "final.vertical.travel", {"mass": "1..2 kg"}, **HOW, max_runs=float("inf"))  ->  max_runs: found inf
minimise(ball, "final.vertical.travel", {"mass": "1..2 kg"}, **HOW, precision="high")  ->  precision: found 'high'
minimise(ball, "final.vertical.travel", {"mass": "1..2 kg"}, **HOW, start=T)  ->  start: found array
minimise(ball, "final.vertical.travel", {"mass": "1..2 kg"}, **HOW, progress=3)  ->  progress: found 3
minimise(ball, "final.vertical.travel", {"mass": "1..2 kg"}, **HOW, starts=-1)  ->  starts: found -1
minimise(ball, "final.vertical.travel", {"mass": "1..2 kg"}, **HOW, parameters={"mass": "1 kg"})  ->  among parameters and over
fit(ball, wave, free="drop_height")  ->  free
fit(ball, wave, free={})  ->  free
fit(ball, wave, free={"drop": (1, 2)})  ->  drop
fit(ball, wave, free={"drop_height": "1..2 kg"})  ->  which is kg
fit(ball, wave, free=[["drop_height"]])  ->  free
fit(ball, "no_such.csv", free=FREE)  ->  no_such.csv
fit(ball, 3, free=FREE)  ->  data: found 3
fit(ball, [], free=FREE)  ->  data: found none
fit(ball, run, free=FREE)  ->  data: found
fit(ball, wave, free=FREE, map={"travel": "vertical.travel"})  ->  travel
fit(ball, wave, free=FREE, map={"vertical.travel": "vertical.travle"})  ->  did you mean vertical.travel
fit(ball, wave, free=FREE, map="vertical.travel")  ->  map: found 'vertical.travel'
fit(ball, wave, free=FREE, map={"vertical.travel": ["a"]})  ->  history
fit(ball, wave, free=FREE, noise=0.1)  ->  noise: found 0.1
fit(ball, wave, free=FREE, noise={"vertical.travel": "1 s"})  ->  which is s
fit(ball, wave, free=FREE, gain=2)  ->  gain: found 2
fit(ball, wave, free=FREE, gain={"vertical.travel": "2..1"})  ->  gain of vertical.travel
fit(ball, wave, free=FREE, offset="1 m")  ->  offset: found '1 m'
fit(ball, wave, free=FREE, tolerance=None)  ->  tolerance: found none
fit(ball, wave, free=FREE, compiled="yes")  ->  compiled: found 'yes'
fit(ball, wave, free=FREE, profile=T)  ->  profile: found array
fit(ball, wave, free={"drop_height": T})  ->  drop_height
fit(ball, wave, free=FREE, starts="many")  ->  starts: found 'many'
fit(ball, wave, free=FREE, profile="some")  ->  profile: found 'some'
fit(ball, wave, free=FREE, progress=1)  ->  progress: found 1
fit(ball, Experiment(wave, {"drop_height": "1 m"}), free=FREE)  ->  a value, and it is free
fit(ball, Experiment(wave, 5), free=FREE)  ->  parameters: found 5
fit(ball, Experiment("no.csv"), free=FREE)  ->  no.csv
fit_laws(ball, wave, "flores", free=FREE)  ->  laws: found 'flores'
fit_laws(ball, wave, {"floor": "flores"}, free=FREE)  ->  laws: found
fit_laws(ball, wave, {"floor": 1}, free=FREE)  ->  laws: found
fit_laws(ball, wave, {"floor": ["flores"]}, free=FREE)  ->  two or more
fit_laws(ball, wave, {"floor": ["flores", "florez"]}, free=FREE)  ->  florez
fit_laws(ball, wave, LAWS, free=FREE, noise=3)  ->  noise: found 3
fit_laws(ball, wave, LAWS, free=FREE, compiled=2)  ->  compiled: found 2
fit_laws(ball, wave, LAWS, free=3)  ->  free
fit_moments(ball, {}, free=FREE, duration="1 s")  ->  moments
fit_moments(ball, "floor.impact_rate", free=FREE, duration="1 s")  ->  moments
fit_moments(ball, {"floor.rate": "1 +- 0.1 1/s"}, free=FREE, duration="1 s")  ->  floor.rate
fit_moments(ball, {"floor.impact_rate": "1 1/s"}, free=FREE, duration="1 s")  ->  standard deviation
fit_moments(ball, {"x.rms": None}, free=FREE, duration="1 s")  ->  no measured series
fit_moments(ball, {"x.rms": None}, free=FREE, series="long.csv")  ->  series: found 'long.csv'
fit_moments(ball, {"vertical.travel.rms": None}, free=FREE, series=MeasuredSeries(wave, skip=T))  ->  skip: found array
fit_moments(ball, {"x.rms": None}, free=FREE, series=MeasuredSeries(wave, noise=3))  ->  noise: found 3
fit_moments(ball, {"x.rms": None}, free=FREE, series=MeasuredSeries(wave, map=3))  ->  map: found 3
fit_moments(ball, {"final.vertical.travel": "1 +- 0.1 m"}, free=FREE, duration="1 s", seed=1.5)  ->  seed: found 1.5
fit_moments(ball, {"floor.impact_rate": "9 +- 1 1/s"}, free=FREE, duration="1 s", independent="no")  ->  independent: found 'no'
equilibrium(3)  ->  target: found 3
equilibrium("bouncing_bal")  ->  did you mean bouncing_ball
equilibrium(ball, at="soon")  ->  at: found 'soon'
equilibrium(ball, at=T)  ->  at: found array
equilibrium(ball, at=-1)  ->  at: found -1
equilibrium(ball, parameters={"mass": 1})  ->  a number without a unit
equilibrium(ball, initial={"x": 1})  ->  x
equilibrium(ball, initial="vertical")  ->  initial: found 'vertical'
equilibrium(ball, inputs={"push": 1})  ->  push
equilibrium(ball, nearest="yes")  ->  nearest: found 'yes'
modes(3)  ->  target: found 3
modes(ball, at="soon")  ->  at: found 'soon'
modes(ball, at=T)  ->  at: found array
modes(run, at="1 s")  ->  at: found '1 s'
modes(run, parameters={"mass": "1 kg"})  ->  values beside a run
modes(equilibrium(ball), at=1)  ->  values beside an equilibrium
rigid_limit(3, RigidImpact(0.5))  ->  target: found 3
rigid_limit(ball, 0.5, **HOW)  ->  law of floor: found 0.5
rigid_limit(ball, RigidImpact("half"), **HOW)  ->  half
rigid_limit(ball, RigidImpact(np.ones(2)), **HOW)  ->  restitution of floor: found array
rigid_limit(ball, {"flor": RigidImpact(0.5)}, **HOW)  ->  flor
rigid_limit(ball, RigidImpact(0.5), **HOW, stiffness=3)  ->  3
rigid_limit(ball, RigidImpact(0.5), **HOW, factors=T)  ->  factors: found array
rigid_limit(ball, RigidImpact(0.5), **HOW, impacts=2)  ->  impacts: found 2
rigid_limit(ball, RigidImpact(0.5), **HOW, impacts=T)  ->  impacts: found array
rigid_limit(ball, RigidImpact(0.5), duration="1 s", accuracy="high")  ->  accuracy: found 'high'
limit["height"]  ->  no coordinate or speed of this name
limit.at("vertical.travel", "soon")  ->  times: found 'soon'
limit.at("vertical.travel", 0.5)  ->  some outside the run
limit.gaps("1 kg")  ->  which is kg
still.plot("all")  ->  count: found 'all'
table.load(3)  ->  folder: found 3
compare(run, run)  ->  data: found a run
compare(run, 3)  ->  data: found 3
compare(run, "no_such.csv")  ->  no_such.csv
compare(run, {"t [s]": T})  ->  no column of the data
compare(run, wave, map={"a": "vertical.travel"})  ->  a
compare(run, wave, map={"vertical.travel": "b"})  ->  b
compare(run, wave, order=0)  ->  order: found 0
compare(run, wave, order="four")  ->  order: found 'four'
compare(run, wave, zero_phase="no")  ->  zero_phase: found 'no'
compare(run, wave, bandwidth="5 rad/s")  ->  bandwidth: found '5 rad/s'
compare(run, wave, noise="1 mm")  ->  noise: found '1 mm'
compare(run, wave, offset="2..1 ms")  ->  the lower end first
compare(run, wave, drift=[1])  ->  drift: found
compare(run, wave, compiled=True)  ->  values beside a run
compare(ball, wave, progress=3)  ->  progress: found 3
compare(run, wave, duration="1 s")  ->  values beside a run
compare("bouncing_bal", wave)  ->  did you mean bouncing_ball
study_effects(3, **HOW)  ->  target: found 3
study_effects(ball, **HOW, within=2)  ->  within: found 2
study_effects(ball, **HOW, within="2%")  ->  within: found '2%'
study_effects(ball, **HOW, outputs="peak_force")  ->  outputs: found 'peak_force'
study_effects(ball, **HOW, outputs=["max.height"])  ->  height
study_effects(ball, **HOW, outputs=[3])  ->  outputs: found [3]
study_effects(ball, duration="1 s", tolerance="x")  ->  tolerance: found 'x'
study_effects(ball, **HOW, compiled="yes")  ->  compiled: found 'yes'
study_effects(ball, **HOW, parameters={"mas": 1})  ->  did you mean mass
study_effects(ball, **HOW, progress=T)  ->  progress: found array
study_effects(ball, **HOW, progress=3)  ->  progress: found 3
read_measurement(3)  ->  data: found 3
read_measurement({"t [s]": T}, units=T)  ->  units: found array
read_measurement({"t [s]": T}, decimal=T)  ->  decimal: found array
read_measurement("no_such.csv")  ->  no_such.csv
read_measurement({"t [s]": [0, 1], "x [m]": [0, 1]}, columns=5)  ->  columns: found 5
read_measurement({"t [s]": [0, 1], "x [m]": [0, 1]}, units="m")  ->  units: found 'm'
read_measurement({"t [s]": [0, 1], "x [m]": [0, 1]}, units={"x": 3})  ->  units: found {'x': 3}
read_measurement({"t [s]": [0, 1], "x [m]": [0, 1]}, missing=None)  ->  missing: found None
read_measurement({"t [s]": [0, 1], "x [m]": [0, 1]}, missing=[None])  ->  missing: found [None]
read_measurement({"t [s]": [0, 1], "x": [0, 1]})  ->  x
read_impacts({"t [s]": [0, 1]})  ->  impact
Measurement("t", {"x": [1, 2]}, {"x": "m"})  ->  times
Measurement([1, 0], {"x": [1, 2]}, {"x": "m"})  ->  increasing
Measurement([0, 1], [1, 2], "m")  ->  columns, units
Measurement([0, 1], {"x": ["a", "b"]}, {"x": "m"})  ->  x
Measurement([0, 1], {"x": [1, 2]}, {"x": "parsec per fortnight"})  ->  x
MeasuredImpacts([2, 1], {"t": [1, 2]}, {"t": "s"})  ->  increasing
run[0]  ->  there are t, vertical.travel
run["vertical.travle"]  ->  did you mean vertical.travel
run["floor.Fx"]  ->  normal_force
run["vertical.travel", "kg"]  ->  which is kg
run.at("1 kg")  ->  which is kg
run.extremes("height")  ->  no history 'height'
run.plot(3)  ->  no history 3
run.plot(["vertical.travel", "height"])  ->  no history 'height'
run.averages(skip="1 kg")  ->  skip
run.averages(skip=T)  ->  skip: found array
run.averages(interval=-1)  ->  interval
run.continued("5 ms")  ->  more than the 0.01 s
run.continued("soon")  ->  duration: found 'soon'
run.continued("20 ms", target=3)  ->  target: found 3
run.continued("20 ms", max_steps=1.5)  ->  max_steps: found 1.5
run.sensitivities("mas")  ->  did you mean mass
run.sensitivities(3)  ->  named by int
run.sensitivities("mass")["height", "mass"]  ->  no history 'height'
run.sensitivities("mass")[3, "mass"]  ->  no history 3
run.sensitivities("mass")[3]  ->  no history 3
run.sensitivities("mass").at([0.005], "height", "mass")  ->  no history 'height'
run.sensitivities("mass").at("soon", "vertical.travel", "mass")  ->  times: found 'soon'
run.sensitivities("mass").at(9.0, "vertical.travel", "mass")  ->  some outside the run
run.sensitivities("mass")["vertical.travel", "mas"]  ->  did you mean mass
run.sensitivities("mass")["vertical.travel"]  ->  expected one of mass
run.with_histories("height")  ->  no history 'height'
run.with_histories(["vertical.travel"])  ->  no history ['vertical.travel']
run.lyapunov(0)  ->  count
run.lyapunov("two")  ->  count
run.save(3)  ->  path: found 3
run.to_file(None)  ->  path: found None
run.to_file("states.xls")  ->  a name that ends with .csv
run.report(3)  ->  path: found 3
run.animate("film.avi")  ->  film.avi
run.animate("film.gif", fps=0)  ->  fps
Solution.load("no_such.npz")  ->  no_such.npz
Solution.load(3)  ->  path: found 3
ball.evaluate("energy")  ->  arguments of energy
ball.function("gap")  ->  did you mean gaps
ball.function(T)  ->  a function named by ndarray
ball.function("step", method=T)  ->  a method named by ndarray
ball.function(3)  ->  function
ball.function("step", method="rk4")  ->  rk4
ball.draw(parameters={"mas": 1})  ->  did you mean mass
ball.equations()["floor_gab"]  ->  did you mean floor_gap
ball.equations()[0]  ->  numbers are 1 to 15
ball.equations()[T]  ->  no equation array
table.in_stated_units("x")  ->  most: found 'x'
still["first"]  ->  no mode 'first'
still[9]  ->  no mode 9
derive.from_urdf(3)  ->  path: found 3
derive.laws_from(3)  ->  path: found 3
derive.audit_path(3)  ->  path: found 3
derive.audit_scene("bouncing_ball")  ->  scene: found 'bouncing_ball'
derive.derive(3)  ->  scene: found 3
derive.generate(3)  ->  scene: found 3
derive.to_sympy(3)  ->  scene: found 3
"""
RIGHT = """
load(scene)
load(ball)
load("bouncing_ball", without=("gravity",))
load("bouncing_ball", laws={"floor": "hunt_crossley"})
simulate("bouncing_ball", **HOW)
simulate(scene, **HOW)
simulate(ball, duration=0.01, tolerance=1e-6)
simulate(ball, duration=np.float64(0.01), tolerance=1e-6)
simulate(ball, duration="0.01", tolerance=1e-6)
simulate(ball, duration="10 ms")
simulate(ball, duration="10 ms", accuracy="1e-5 at the end")
simulate(ball, **HOW, parameters={"drop_height": 900 * mm})
simulate(ball, **HOW, parameters={"drop_height": (0.9, "m"), "restitution": 0.5})
simulate(ball, **HOW, parameters={"vertical.speed": "1 m/s"})
simulate(ball, **HOW, initial=equilibrium(ball))
simulate(ball, **HOW, grid=11)
simulate(ball, **HOW, grid="1 ms")
simulate(ball, **HOW, grid=[0.0, 0.005])
simulate(ball, **HOW, grid=np.linspace(0, 0.01, 5))
simulate(ball, **HOW, compiled=False, method="esdirk", max_steps=100, wall_time=60.0)
simulate(ball, **HOW, max_steps=1e6)
simulate(ball, **HOW, progress=lambda part: None)
simulate_many(ball, [{"mass": "1 kg"}, {"vertical.speed": "1 m/s"}], **HOW, workers=1)
simulate_many("bouncing_ball", ({} for _ in range(2)), **HOW, workers=1, functions={"top": lambda run: run["vertical.travel"].max()})
simulate_many(ball, [{}], **HOW, workers=1, parameters={"mass": "2 kg"}, grid=5)
sweep("bouncing_ball", {"mass": "1, 2 kg"}, **HOW, workers=1)
sweep(ball, {"drop_height": [900 * mm, "1 m"]}, **HOW, workers=1, outputs=["final.vertical.speed"])
sweep(ball, {"mass": "1..2 kg"}, **HOW, workers=1, sample=2)
sweep(ball, {"mass": "1, 2 kg"}, **HOW, workers=1, parameters={"restitution": 1}, initial={"vertical.speed": "1 m/s"})
propagate("bouncing_ball", {"mass": "Uniform(1 kg, 2 kg)"}, ["final.vertical.travel"], **HOW, sample=8, workers=1)
minimise("bouncing_ball", "final.vertical.travel", {"drop_height": "1..2 m"}, **HOW, max_runs=8, progress=lambda part: None)
fit("bouncing_ball", wave, free=FREE, starts=0, compiled=False)
fit(ball, {"t [s]": T, "vertical.travel [m]": 1.1 - 4.905 * T**2}, free={"drop_height": None}, starts=0)
equilibrium("bouncing_ball")
equilibrium(ball, nearest=True)
modes("bouncing_ball")
modes(equilibrium(ball))
modes(run, at="5 ms")
rigid_limit(ball, RigidImpact(np.float64(0.5)), **HOW)["vertical.travel"]
compare("bouncing_ball", wave, tolerance=1e-6, compiled=False, progress=lambda part: None)
compare(ball, wave, tolerance=1e-6, parameters={"mass": "2 kg"}, noise={"vertical.travel": "1 mm"})
read_measurement({"t [s]": T, "x [m]": T})
read_impacts({"impact [1]": [1, 2], "t [s]": [0.1, 0.2]})
Measurement(run.t, dict(run), run.units)
dict(run)
list(run)
run["vertical.travel", "mm"]
run.at(0.005)
run.at("5 ms")["vertical.travel"]
repr(run.at([]))
run.sensitivities("mass").at("5 ms", "vertical.travel", "mass")
limit.at("vertical.travel", "5 ms")
limit.get("height", 0)
limit
limit["t"][limit == limit]
{limit: limit.units}
run.extremes("vertical.travel").highest
run.continued("20 ms")
run.sensitivities()["vertical.travel", "mass"]
run.sensitivities("mass", "vertical.speed")
run.sensitivities("restitution")["vertical.travel", "restitution"]
run.with_histories("ball.x")
run.plot(["vertical.travel", "vertical.speed"])
run.plot("floor")
ball.histories
ball.function("gaps")
ball.equations()
"""


@each("row", WRONG.strip().splitlines())
def test_a_wrong_call_is_refused_before_anything_runs(row, monkeypatch, tmp_path):
    names = given()  # runs, which from here on are refused
    monkeypatch.chdir(tmp_path)
    for place in (simulation, continuation):
        monkeypatch.setattr(place, "set_up", lambda *given, **how: pytest.fail("a run was begun"))
    call, _, actual = row.partition("  ->  ")
    with pytest.raises((InputError, LookupError)) as caught:
        eval(call, {**names})
    assert actual in str(caught.value)
    assert not list(tmp_path.iterdir())


@each("call", RIGHT.strip().splitlines())
def test_a_right_call_is_answered(call):
    result = eval(call, {**given()})
    assert result is not None and " at 0x" not in repr(result)


def test_there_are_many_and_of_every_public_function():
    calls = f"{WRONG}{RIGHT}"
    assert len(calls.strip().splitlines()) >= 200
    functions = [name for name in runtime.__all__ if name[0].islower()]
    tried = WRONG, f"{RIGHT}\nstudy_effects(\nfit_"
    missing = [name for name in functions if not all(f"\n{name}(" in text for text in tried)]
    assert missing == ["fit_laws", "fit_moments"]
