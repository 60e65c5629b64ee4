"""Cases of couplings and of the edge of friction fail where what they are of is a little otherwise."""

from dataclasses import replace

import pytest

from hertzwerk.derive import Coupling, InputError, Parameter
from hertzwerk.derive.scenes.hard.coupled_shafts import geared_parallelogram
from hertzwerk.runtime import load, simulate
from hertzwerk.runtime.analysis.hard_cases import runner
from hertzwerk.runtime.analysis.hard_cases.case_table import BY_NAME
from hertzwerk.runtime.analysis.hard_cases.invariants import measure
from hertzwerk.runtime.engine.solution import contact_watch

FAULTS = {
    "gear_beside_a_parallelogram": ({"pace": "10.00001 rad/s"}, {"final left.angle", "final right.angle"}),
    "two_equal_gear_pairs": ({"inertia": "0.01001 kg m^2"}, {"final wheel.angle", "final pinion.angle"}),
    "gear_against_a_parallelogram": ({"torn": "0 rad/s"}, {"outcome", "time"}),  # it allows what the bars do
    "load_turns_on_the_cone": ({"share": 1.0001}, {"final x.travel", "final z.travel", "largest floor.slip"}),
    "load_turns_beyond_the_cone": ({"share": 1.05001}, {"final speed"}),
    "slips_as_it_rolls_off_centre": ({"offset_x": "3.9089 mm"}, {"onset of slip", "final flight.x"}),
    "incline_bounces_to_rest": ({"friction_coefficient": 0.90001}, {"rigid: final travel"}),
    "bounces_with_resistances": ({"rolling_arm": "1.00001 mm"}, {"angular speed"}),
}


@pytest.mark.parametrize("name", FAULTS)
def test_a_fault_is_found(name):
    case, (parameters, broken) = BY_NAME[name], FAULTS[name]
    other = replace(case, parameters={**case.parameters, **parameters})
    run = runner.solve(other, "dop853", compiled=False)
    assert broken <= set(runner.broken(case, run.outcome.name, measure(case, "dop853", run)))


def test_a_crest_beside_steps_of_rounding_is_not_found_at_the_steps(monkeypatch):
    monkeypatch.setattr(contact_watch, "AT_ONCE", 0.0)
    monkeypatch.setattr(contact_watch, "CREST", 0.0)  # nor is one looked for within steps
    case = BY_NAME["peak_beside_a_landing"]
    run = runner.solve(case, "dop853", compiled=False)
    assert runner.broken(case, run.outcome.name, measure(case, "dop853", run)) == ("error of peak forces",)


@pytest.mark.parametrize(
    ("gear", "message"),
    [
        (Coupling("gear", "right", "left", ratio=-1), "positions: .*end open by .*, gear off by"),
        (Coupling("gear", "right", "left", ratio=2, offset=Parameter("off", "rad", -1)), "speeds: .*end open by .*, gear off by"),
    ],
)  # fmt: skip
def test_a_gear_that_contradicts_the_bars_at_the_start_is_refused_by_name(gear, message):
    model = load(geared_parallelogram().replace(gear=gear))
    with pytest.raises(InputError, match=message):
        simulate(model, duration="0.1 s", compiled=False)
