"""The study of exponents: n = 3/2 alone is newton, penetrations are those of the closed form, verdicts see faults."""

from dataclasses import replace

import numpy as np
import pytest

from hertzwerk.runtime.studies.paper import study_exponents as study
from hertzwerk.runtime.studies.paper.study_page import Page
from hertzwerk.runtime.studies.paper.study_sweeps import Sweeps

EXPONENTS = (1.0, 1.5, 2.0)


@pytest.fixture(scope="module")
def impacts():
    return study._impacts(EXPONENTS)


def verdicts(impacts):
    return [verdict.holds for verdict in study._impact_verdicts(impacts)]


def test_the_closed_form_is_that_of_a_dropped_ball(monkeypatch):
    """Elastic, 1 kg, 4.43 m/s: scenario data computed independently."""
    for name, value in {"MASS": 1.0, "SPEED": 4.42944692, "STIFFNESS": 2.4e10, "DAMPING": 1e-5}.items():
        monkeypatch.setattr(study, name, value)
    assert study.closed_depth(1.5) == pytest.approx(2.53372286e-4, rel=1e-5)


def test_newton_is_found_for_three_halves_alone(impacts):
    assert {i.unit.exponent: i.unit.unit for i in impacts} == {1.0: "N/m^0.5", 1.5: "N", 2.0: "N m^0.5"}
    assert [i.unit.in_mm for i in impacts] == pytest.approx([1000**-0.5, 1, 1000**0.5], rel=1e-9)
    assert verdicts(impacts) == [True] * 4
    # Nearly, as the damping of e = 0.9 lengthens them: pi sqrt(m/K).
    assert impacts[0].duration == pytest.approx(np.pi * np.sqrt(study.MASS / study.STIFFNESS), rel=5e-3)
    h, e = study.DAMPING, impacts[0].restitution
    assert h * (1 + e) == pytest.approx(np.log((1 + h) / (1 - h * e)), rel=1e-9)


@pytest.mark.parametrize(
    ("fault", "seen"),
    [
        (lambda i: replace(i, unit=replace(i.unit, consistent=True)), 0), (lambda i: replace(i, unit=replace(i.unit, in_mm=1.0)), 1),
        (lambda i: replace(i, depth=i.depth * (1 + 1e-5)), 2), (lambda i: replace(i, restitution=i.restitution + 1e-5), 3),
    ],
)  # fmt: skip
def test_a_fault_in_the_numbers_fails_its_verdict(impacts, fault, seen):
    assert verdicts([fault(impacts[0]), *impacts[1:]]) == [k != seen for k in range(4)]


@pytest.mark.slow
def test_the_whole_page(monkeypatch):
    done = []
    page = study.STUDY.run(True, done.append, Sweeps())
    assert isinstance(page, Page)
    assert page.holds
    panels = [panel for chart in page.charts for panel in chart.panels]
    assert {panel.y.history for panel in panels if panel.x.history == "t"} == study.STUDY.histories.keys()
    assert done == sorted(done)
    table = page.tables[1]
    forces = dict(zip(table.column("n"), table.column("peak force"), strict=True))
    assert forces[1.0] > 5 * forces[1.5] > 10 * forces[2.0]
    assert all(error < 1e-3 * force for error, force in zip(table.column("peak force ±"), forces.values(), strict=True))
    assert table.column("deformation")[0] == "unnoticed"
    assert table.column("deformation")[-1] == "sunk"
