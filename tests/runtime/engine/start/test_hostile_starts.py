"""Parameters and starts of extreme size, zero, negative or none, through the command line: refused or run, never a traceback."""

import random

import pytest
from click.testing import CliRunner

from hertzwerk.runtime.cli import main
from hertzwerk.runtime.loading import engine_model

SCENES = ("slider_crank", "bouncing_ball", "ball_in_socket", "woodpecker")
NUMBERS = (
    *("0", "-0", "-1", "nan", "inf", "-inf", "1e-300", "5e-324", "1e-160", "1e-12", "-1e-20"),
    *("1e3", "1e6", "0.17E9", "1e12", "-1e9", "1e20", "1e154", "1e300", "1.7976931348623157e308", "1e99999"),
)
BRIEF = ("--duration", "1 ms", "--wall-time", "2 s", "--max-steps", "500", "--json")


def ends(*words: str) -> None:
    """A command ends by an exit code of its own; a warning of NumPy is an error here."""
    result = CliRunner().invoke(main, words, prog_name="hertzwerk")
    assert result.exception is None or isinstance(result.exception, SystemExit), (words, result.exception)
    assert result.exit_code in (0, 1, 2), words
    assert '"exception"' not in result.output, (words, result.output)


@pytest.mark.parametrize("travel", ["0.17E9 m", "-0.17e9 m", "1e200 m", "1e300 m"])
def test_a_pin_far_out_of_its_bush_is_refused(travel):
    """Its clearance followed from the gap by a difference that was 0, and the eccentricity was divided by it."""
    ends("run", "slider_crank", "--set", f"guide.travel={travel}", *BRIEF)


def test_infinite_forces_are_no_equilibrium_nor_infinite_accelerations_a_warning_of_numpy(own_folder):
    """The search divided by a step of 0; where it ended, the stiffness was not finite: `LinAlgError`."""
    ends("modes", "newtons_cradle", "--set", "gravity=1e300 m/s^2", "--set", "string_4.angle=1.7e308 rad", "--json")
    ends("draw", "woodpecker", "--set", "bent=1.7976931348623157e308 rad")


@pytest.mark.parametrize("count", [10, pytest.param(500, marks=[pytest.mark.exhaustive, pytest.mark.timeout(0)])])
@pytest.mark.parametrize("scene", SCENES)
def test_hostile_numbers_are_refused_or_run(scene, count):
    rng, model = random.Random(scene), engine_model(scene)
    units = {name: port.unit for name, port in model.parameters.items()}
    units |= {name: model.units[name] for name in (*model.coordinates, *model.speeds)}
    for _ in range(count):
        chosen = rng.sample(list(units), rng.choice((1, 1, 2, 3)))
        given = [f"{name}={rng.choice(NUMBERS)}{'' if units[name] == '1' else ' ' + units[name]}" for name in chosen]
        sets = [word for text in given for word in ("--set", text)]
        if rng.randrange(4):
            ends("run", scene, *sets, *BRIEF)
        else:
            ends(rng.choice(("statics", "modes")), scene, *sets, "--json")
