"""The study of bouncing bodies: elastic impacts against Hertz, restitution against closed forms, faults seen."""

from dataclasses import replace

import pytest

from hertzwerk.runtime.studies.paper import study_bouncing as study

SPHERES, CYLINDERS = study.FORMS
LAWS = ("flores", "tsuji", "kelvin_voigt")


@pytest.fixture(scope="module")
def bounces():
    return [bounce for form in study.FORMS for law in LAWS for bounce in study._bounces(form, law, (0.9,))]


@pytest.fixture(scope="module")
def elastic():
    return [bounce for form in study.FORMS for bounce in study._bounces(form, "lankarani_nikravesh", (1.0,))]


def holds(verdicts):
    return [verdict.holds for verdict in verdicts if verdict.holds is not None]


def test_the_closed_form_is_that_of_a_dropped_ball():
    """1 kg, dropped 1 m, K = 2.4e10 N/m^1.5: scenario data computed independently."""
    form = replace(SPHERES, stiffness=2.4e10)
    scale = (1.0 / study.HEIGHT) ** 0.5  # of the speed
    assert form.depth * scale**0.8 == pytest.approx(2.53372286e-4, rel=1e-7)
    assert form.force * scale**1.2 == pytest.approx(96794.33, rel=1e-6)
    assert form.duration * scale**-0.2 == pytest.approx(1.6836060e-4, rel=1e-7)
    (bounce,) = study._bounces(SPHERES, "hunt_crossley", (0.99,))
    assert bounce.lost == pytest.approx(1 - bounce.out**2, rel=1e-6)
    assert bounce.out == pytest.approx(0.99, abs=1e-3)


def test_elastic_impacts_are_those_of_the_closed_forms(elastic):
    assert holds(study._elastic_verdicts(elastic)) == [True] * 4
    longer = [replace(bounce, duration=bounce.duration * 1.002) for bounce in elastic]
    assert holds(study._elastic_verdicts(longer)) == [False, True] * 2
    harder = [replace(bounce, peak_force=bounce.peak_force * 0.998) for bounce in elastic]
    assert holds(study._elastic_verdicts(harder)) == [True, False] * 2


def test_laws_return_what_their_closed_forms_say(bounces):
    unknown = {(b.form.name, b.law) for b in bounces if b.closed is None}
    assert unknown == {("cylinders", "tsuji"), ("spheres", "kelvin_voigt")}
    assert holds(study._verdicts(bounces)) == [True, True]
    exact = {(b.form.name, b.law): b.out - 0.9 for b in bounces}
    assert (
        abs(exact["spheres", "tsuji"]) < 1e-3 > abs(exact["cylinders", "kelvin_voigt"])
    )  # beside what they were published for
    assert abs(exact["cylinders", "tsuji"]) > 1e-3 < abs(exact["spheres", "kelvin_voigt"])


@pytest.mark.parametrize(("fault", "seen"), [({"out": 0.91}, [False, False]), ({"lost": 0.2}, [True, False])])
def test_a_fault_in_one_impact_fails_its_verdict(bounces, fault, seen):
    assert holds(study._verdicts([replace(bounces[0], **fault), *bounces[1:]])) == seen
