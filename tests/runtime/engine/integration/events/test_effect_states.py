"""States of effects, against closed forms: motors, controllers, relays; events that cascade, chatter, or meet a contact."""

from dataclasses import dataclass
from itertools import product
from typing import Any

import numpy as np
import pytest

import hertzwerk.derive as hd
from hertzwerk.runtime import simulate
from hertzwerk.runtime.engine.solution.error_scales import departure, error
from hertzwerk.runtime.loading import engine_model

pytestmark = pytest.mark.by_turns(3)  # methods and coordinates that run the same code

J, R, L, K, V = 1e-3, 2.0, 5e-3, 0.1, 24.0  # kg m^2, ohm, H, N m/A, V
ROTOR = hd.Body("rotor", hd.Parameter("mass", "kg", 1), hd.Parameter("inertia", "kg m^2", J))
SHAFT = hd.Mechanism("shaft", (hd.Revolute("main", hd.GROUND, ROTOR, axis=hd.Z),))
SCALES = hd.Scales(hd.Parameter("size", "m", 1), hd.Parameter("pace", "m/s", V / K), hd.Parameter("arm", "m", 1))


def shaft(*effects, coordinates="tree"):
    return hd.Scene(SHAFT, (*effects, hd.EnergyLedger()), SCALES, coordinates=coordinates)


def motor(voltage=None, name="motor"):
    given = hd.Parameter("supply", "V", V) if voltage is None else voltage
    values = (hd.Parameter("R", "ohm", R), hd.Parameter("L", "mH", 1e3 * L), hd.Parameter("k", "N m/A", K))
    return hd.DCMotor(name, "main", given, *values)


def step_response(t, resistance=R):
    """Current [A] and speed [rad/s] of a motor switched on at rest, by its two eigenvalues."""
    A, b = np.array([[-resistance / L, -K / L], [K / J, 0.0]]), np.array([V / L, 0.0])
    rates, modes = np.linalg.eig(A)
    still = -np.linalg.solve(A, b)
    parts = np.linalg.solve(modes, -still)
    return (still[:, None] + modes @ (parts[:, None] * np.exp(rates[:, None] * t))).real


@pytest.mark.parametrize("coordinates", ["tree", "absolute"])
@pytest.mark.parametrize("method", ["dop853", "dopri5", "rodas", "esdirk", "auto", "cvodes"])
def test_a_motor_switched_on(method, coordinates):
    """Two time constants, the speed without load V/k, and an energy balance that closes; a resistance 1e-4 off shows."""
    run = simulate(engine_model(shaft(motor(), coordinates=coordinates)), duration=1.0, tolerance=1e-8, method=method)
    assert run.outcome.finished
    actual = np.array([run["motor.current"] / (V / R), run["main.speed"] / (V / K)])
    size = np.array([[V / R], [V / K]])
    error = np.max(np.abs(actual - step_response(run.t) / size))
    assert error < 6e-7
    assert np.max(np.abs(actual - step_response(run.t, R * (1 + 1e-4)) / size)) > 1e-5 > error
    assert run["main.speed"][-1] == pytest.approx(V / K, rel=1e-2)
    assert run["motor.torque"] == pytest.approx(K * run["motor.current"], rel=1e-12)
    # kinetic energy, that of the inductance, heat: the electric energy is their sum
    stored = J * run["main.speed"] ** 2 / 2 + L * run["motor.current"] ** 2 / 2
    assert run["energy"] == pytest.approx(stored, rel=1e-12, abs=1e-12)
    assert stored + run["motor.dissipated"] == pytest.approx(run["motor.input"], rel=1e-6, abs=1e-5)
    assert run.energy_residual < 1e-6


def test_a_stiff_current_is_passed_by_implicit_steps_and_a_jolted_one_is_not_taken_for_stiff():
    """L/R of a microsecond beside a mechanical time constant of 0.2 s: auto and the implicit methods take few steps."""
    model = engine_model(shaft(motor()))
    options = {"duration": 0.5, "tolerance": 1e-6, "parameters": {"L": "2e-3 mH"}}
    runs = {method: simulate(model, method=method, **options) for method in ("esdirk", "rodas", "auto", "dopri5")}
    steps = {method: run.statistics.steps for method, run in runs.items()}
    speed = V / K * (1 - np.exp(-0.5 * K**2 / (R * J)))
    for run in runs.values():
        assert run.engine.final["main.speed"] == pytest.approx(speed, rel=1e-4)
    assert steps["dopri5"] > 30_000 > 20 * steps["auto"]
    assert max(steps["esdirk"], steps["rodas"]) < 300
    # R/L is 500/s; at impacts the current's rate follows the crank's speed, which changes much faster.
    run = simulate(
        engine_model("slider_crank_dc_motor"), duration="6 ms", tolerance=1e-9, method="auto", compiled=False
    )
    assert len(run.impacts) >= 2
    assert not run.engine.history.part("pressure").any()


def test_a_controlled_speed_of_second_order():
    """PI on a torque: e'' + Kp/J e' + Ki/J e = 0 from e = w, e' = -Kp w/J."""
    w, Kp, Ki = 100.0, 0.02, 2.0
    gains = hd.Parameter("Kp", "N m s/rad", Kp), hd.Parameter("Ki", "N m/rad", Ki)
    control = hd.SpeedController("control", "main", hd.Parameter("target", "rad/s", w), *gains, "N m")
    run = simulate(
        engine_model(shaft(hd.JointForce("drive", "main", control.command), control)), duration=0.5, tolerance=1e-10
    )
    decay, natural = Kp / (2 * J), np.sqrt(Ki / J)
    omega = np.sqrt(natural**2 - decay**2)
    e = w * np.exp(-decay * run.t) * (np.cos(omega * run.t) - decay / omega * np.sin(omega * run.t))
    assert w - run["main.speed"] == pytest.approx(e, abs=1e-6 * w)
    assert run["control.error"][-1] == pytest.approx(0, abs=1e-2)  # the integral, with no torque to hold


def sampled(period, duration=0.1999, **given):
    control = hd.SpeedController(
        *("control", "main", hd.Parameter("target", "rad/s", 100), hd.Parameter("Kp", "N m s/rad", 0.05)),
        *(hd.Parameter("Ki", "N m/rad", 1.0), "N m", hd.Parameter("period", "s", period)),
    )
    drag = hd.JointDamper("drag", "main", hd.Parameter("b", "N m s/rad", 0.01))
    return simulate(
        engine_model(shaft(hd.JointForce("drive", "main", control.command), drag, control)), duration=duration, **given
    )


def test_a_sample_that_is_due_at_the_end_of_a_run_is_taken():
    """Else it would be rounding that decides what the last command is."""
    model = sampled(0.01, duration=0.05, tolerance=1e-6).engine.model
    ways = [*product(("dop853", "dopri5", "esdirk"), (1e-4, 1e-6, 1e-10)), ("cvodes", 1e-6)]
    runs = [simulate(model, duration=0.05, method=method, tolerance=tolerance) for method, tolerance in ways]
    assert [run.statistics.events for run in runs] == [5] * len(ways)
    assert [run.engine.final["control.countdown"] for run in runs] == pytest.approx([0.01] * len(ways))
    assert simulate(model, duration=0.05 - 1e-7, tolerance=1e-6).statistics.events == 4


@pytest.mark.parametrize("method", ["dop853", "esdirk", "cvodes"])
def test_a_sampled_controller_is_its_recursion(method):
    """The plant between samples is exact: w' = (u - b w)/J gives w <- a w + (1 - a) u/b, a = exp(-b T/J)."""
    period, b = 0.01, 0.01
    run = sampled(period, tolerance=1e-9, method=method)
    assert run.outcome.finished
    assert run.statistics.events == 19  # that of the start is none
    w, total, commands, speeds = 0.0, 0.0, [], []
    a = np.exp(-b * period / J)
    for _ in range(20):
        e = 100 - w
        commands.append(0.05 * e + 1.0 * total)
        speeds.append(w)
        w, total = a * w + (1 - a) * commands[-1] / b, total + period * e
    middle = (np.arange(20) + 0.5) * period
    assert run.at(middle)["control.command"] == pytest.approx(commands, rel=1e-7, abs=1e-7)
    decay = np.exp(-b * period / 2 / J)
    expected = np.array(speeds) * decay + (1 - decay) * np.array(commands) / b
    assert run.at(middle)["main.speed"] == pytest.approx(expected, rel=1e-7, abs=1e-6)
    late = [0.05 * (100 - x) for x in speeds]  # a controller that forgets its integral
    assert np.max(np.abs(run.at(middle)["control.command"] - late)) > 0.1


# -- effects of one's own ----------------------------------------------------------------------------------------------


@dataclass(frozen=True)
class SpeedRelay(hd.JointEffect):
    """Force +-thrust that keeps the speed of a slide at zero, with hysteresis."""

    name: str
    joint: str
    thrust: Any
    hysteresis: Any
    kind = "relay"

    def slots(self, scene):
        yield hd.Slot(f"{self.where}, thrust", self.thrust, "N")
        yield hd.Slot(f"{self.where}, hysteresis", self.hysteresis, "m/s")

    def states(self, scene):
        yield hd.State("sign", "1", start=1)

    def element(self, kin):
        sign, speed = kin.state(f"{self.name}.sign"), kin.speed(self.joint)
        turn = hd.Event("turn", self.hysteresis - sign * speed, kin.scene.scales.speed, {"sign": -sign})
        force = kin.tape.let(sign * self.thrust, f"{self.name}_force")
        return hd.Element(kin.on_joint(self.joint, force, self.name), input=force * speed, events=(turn,))


@dataclass(frozen=True)
class Latch(hd.JointEffect):
    """State that becomes 1, for good, where a condition [1] falls through zero."""

    name: str
    joint: str
    condition: Any
    kind = "latch"
    enters = ""

    def slots(self, scene):
        yield hd.Varying(f"{self.where}, condition", self.condition, "1")

    def states(self, scene):
        yield hd.State("closed", "1")

    def element(self, kin):
        closed = kin.state(f"{self.name}.closed")
        close = hd.Event("close", kin.expression(self.condition) + 10 * closed, 1, {"closed": 1})
        return hd.Element(events=(close,))


SLED = hd.Mechanism(
    "sled", (hd.Prismatic("slide", hd.GROUND, hd.Body("sled", hd.Parameter("mass", "kg", 2)), axis=hd.X),)
)
SMALL = hd.Scales(hd.Parameter("size", "m", 0.1), hd.Parameter("pace", "m/s", 0.1))


def relay(hysteresis, tolerance=1e-8, method="auto", **limits):
    scene = hd.Scene(
        SLED,
        (
            switching := hd.Relay("relay", hd.speed_of("slide"), "m/s", hd.Parameter("hysteresis", "m/s", hysteresis)),
            hd.JointForce("jets", "slide", hd.Parameter("thrust", "N", 3) * switching.output),
            hd.JointDamper("drag", "slide", hd.Parameter("drag", "N s/m", 12)),
            hd.EnergyLedger(),
        ),
        SMALL,
    )
    return simulate(engine_model(scene), duration=1.0, tolerance=tolerance, method=method, **limits)


@pytest.mark.parametrize("method", ["auto", "esdirk", "cvodes"])
def test_a_relay_on_a_plant_of_first_order(method):
    """Its limit cycle: between -h and h in tau log((w + h)/(w - h)), w = thrust/c, tau = m/c, each way."""
    h, w, tau = 0.05, 3 / 12, 2 / 12
    run = relay(h, method=method)
    turns = run.t[1:][np.diff(run["relay.output"]) != 0]
    assert len(turns) > 10
    tolerance = 1e-5 if method == "cvodes" else 1e-8
    assert turns[0] == pytest.approx(tau * np.log(w / (w - h)), rel=tolerance)
    assert np.diff(turns) == pytest.approx(tau * np.log((w + h) / (w - h)), rel=tolerance)
    assert np.max(np.abs(run["slide.speed"])) == pytest.approx(h, rel=tolerance)
    assert run.energy_residual < 1e-3 if method == "cvodes" else run.energy_residual < 1e-8


def test_an_event_a_moment_late_is_no_error_and_one_that_is_missed_is(monkeypatch):
    """Between the instants at which two runs turn a relay it differs by a whole jump, the motion by that moment."""
    truth, late = (relay(0.05, tolerance) for tolerance in (1e-10, 1e-7))
    turns = [run.t[1:][np.diff(run["relay.output"]) != 0] for run in (truth, late)]
    times = np.sort(np.append(np.mean(turns, axis=0), np.linspace(0, 1, 50)))

    def off(run):
        parts = (side.part(name) for name in ("y", "dy") for side in (run.at(times), truth.at(times)))
        return error(run.engine.model, run.engine.scales, *parts).max()

    assert off(late) < 1e-6
    assert off(relay(0.3)) > 1  # which never turns: its output alone, 1, is one that the other has too
    monkeypatch.setitem(late.engine.model.__dict__, "held", ())  # the seeded fault
    assert off(late) == 2


def test_a_countdown_is_no_error_at_the_instant_at_which_it_is_set():
    runs = [sampled(0.01, tolerance=1e-6, method=method) for method in ("dop853", "dopri5")]
    model, scales = runs[0].engine.model, runs[0].engine.scales
    y, reference = (run.at(np.linspace(0.005, 0.195, 20)).part("y") for run in runs)
    for row in (model.coordinates.index("control.countdown"), 0):
        y[:, row] += 0.01
        assert (departure(model, scales, y, reference).max() < 1e-5) == (row > 0)
    assert sampled(0.01, accuracy=1e-6).error.of("control.countdown") == 0  # nor in the estimate of a run


def test_a_relay_without_hysteresis_ends_with_what_it_has():
    """It switches as fast as the tolerance lets it: the run is over after the events it may have, and its speed is held."""
    run = relay(0.0, tolerance=1e-6, max_events=10_000)
    assert run.outcome.name == "event_limit"
    assert "hysteresis" in run.outcome.remedy
    assert 0 < run.t[-1] < 1
    assert np.max(np.abs(run["slide.speed"])) < 1e-8


def test_an_event_is_not_located_below_the_rounding_of_its_margin():
    """A film of 1 um at 10 mm: one digit of the position is 2e-12 of the margin, more than the tolerance here."""
    run = simulate("ball_on_oil", duration="1.74 ms", tolerance=1e-13)
    assert run.outcome.name == "finished" and len(run.t) < 200
    assert run["oil.seams"][-1] == 1


def test_events_follow_each_other_at_one_instant():
    """A latch closes when another has, which closes at a known time; both stay closed."""
    first = Latch("first", "slide", 1 - hd.speed_of("slide") / hd.Parameter("limit", "m/s", 1.0))
    second = Latch("second", "slide", 0.5 - hd.state_of("first.closed"))
    push = hd.JointForce("push", "slide", hd.Parameter("push", "N", 4) * (1 - hd.state_of("second.closed")))
    run = simulate(engine_model(hd.Scene(SLED, (first, second, push), SMALL)), duration=1.0, tolerance=1e-8)
    assert run["first.closed"].tolist() == run["second.closed"].tolist()
    closes = run.t[np.argmax(run["second.closed"] > 0)]
    assert closes == pytest.approx(0.5, rel=1e-9)  # 4 N on 2 kg reach 1 m/s
    assert run.engine.final["slide.speed"] == pytest.approx(1, rel=1e-9)
    ready = simulate(run.engine.model, duration=0.1, tolerance=1e-8, initial={"first.closed": 1})
    assert ready.engine.final["slide.speed"] == 0  # an event is due at the start


def test_events_between_impacts():
    """A ball thrown between a floor and a relay's thrust: both kinds of events, one energy balance."""
    mass = hd.Parameter("mass", "kg", 0.1)
    ball = hd.Body("ball", mass)
    pair = hd.SphereOnPlane(
        "wall", ball.at(0, 0, 0), hd.Parameter("radius", "mm", 10), hd.GROUND.at(0, 0, 0), normal=hd.X
    )
    scene = hd.Scene(
        hd.Mechanism("thrown", (hd.Prismatic("slide", hd.GROUND, ball, axis=hd.X),), (pair,)),
        (
            SpeedRelay("relay", "slide", hd.Parameter("thrust", "N", 1), hd.Parameter("hysteresis", "m/s", 0.5)),
            hd.Contact("wall", hd.laws.power(hd.Parameter("stiffness", "N/m^1.5", 1e8), n=1.5)),
            hd.EnergyLedger(),
        ),
        hd.Scales(hd.Parameter("size", "mm", 10), hd.Parameter("pace", "m/s", 1)),
        hd.Start(
            position={"slide": hd.Parameter("height", "m", 0.012)}, speed={"slide": hd.Parameter("thrown", "m/s", -0.4)}
        ),
    )
    runs = {
        method: simulate(engine_model(scene), duration=1.0, tolerance=1e-9, method=method)
        for method in ("dop853", "esdirk")
    }
    for run in runs.values():
        assert run.outcome.finished
        assert len(run.impacts) >= 1
        assert np.count_nonzero(np.diff(run["relay.sign"])) >= 4
        assert run.energy_residual < 1e-6
    one, other = runs.values()
    assert one.engine.final["slide.travel"] == pytest.approx(other.engine.final["slide.travel"], rel=1e-5)


# -- faults ------------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"states": lambda self, scene: iter(())}, "unknown|sign"),
        ({"states": lambda self, scene: iter((hd.State("sign", "1"), hd.State("idle", "1")))}, "which nothing changes"),
        ({"states": lambda self, scene: iter((hd.State("sign", "A"),))}, "size"),
    ],
)
def test_states_that_are_not_declared_or_not_used(change, message):
    wrong = type("Wrong", (SpeedRelay,), change)
    with pytest.raises(hd.InputError, match=message):
        engine_model(
            hd.Scene(
                SLED, (wrong("relay", "slide", hd.Parameter("thrust", "N", 3), hd.Parameter("h", "m/s", 0.1)),), SMALL
            )
        )


def test_bad_motors_and_controllers_and_rates_of_the_wrong_unit_are_reported():
    control = hd.SpeedController(
        *("control", "main", hd.Parameter("target", "N", 1), hd.Parameter("Kp", "V", 1)),
        *(hd.Parameter("Ki", "V/rad", 1), "furlong"),
    )
    with pytest.raises(hd.InputError, match="furlong"):
        shaft(control)
    bad = hd.DCMotor(
        "motor", "main", hd.state_of("contrl.command"), hd.Parameter("R", "V", 1), "2 mH", hd.Parameter("k", "N m", 1)
    )
    with pytest.raises(hd.InputError) as error:
        shaft(bad)
    places = " ".join(fault.where for fault in error.value.faults)
    for what in ("voltage", "resistance", "inductance", "constant"):
        assert what in places

    class Wrong(SpeedRelay):
        def states(self, scene):
            yield hd.State("sign", "1", start=1)
            yield hd.State("spent", "N", size=self.thrust)

        def element(self, kin):
            from dataclasses import replace

            return replace(super().element(kin), rates={"spent": self.thrust})

    wrong = Wrong("relay", "slide", hd.Parameter("thrust", "N", 3), hd.Parameter("h", "m/s", 0.1))
    with pytest.raises(hd.InputError, match="expected W/m"):
        engine_model(hd.Scene(SLED, (wrong,), SMALL))
