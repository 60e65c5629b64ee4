"""Every law of the catalogue against what is known of it from elsewhere, and its grade against what that is."""

import pytest
from bench import DIGITS
from each import each
from evidence import EVIDENCE
from known import INDEPENDENT
from mpmath import mp
from mutate_laws import survivors

from hertzwerk.derive.laws import LAWS


@pytest.fixture(autouse=True, scope="module")
def forty_digits():
    with mp.workdps(DIGITS):
        yield


def test_something_is_known_of_every_law():
    assert EVIDENCE.keys() == LAWS.keys()


@each(("name", "evidence"), [(name, known) for name, rows in EVIDENCE.items() for known in rows])  # fmt: skip
def test_a_law_is_what_is_known_of_it(name, evidence):
    evidence.check(LAWS[name])


@each("name", LAWS)
def test_a_grade_says_what_is_really_there(name):
    """A: something that is no formula typed twice, and is about the force; R: a reconstruction."""
    of_the_force = [known for known in EVIDENCE[name] if known.of_the_force]
    independent = [known for known in of_the_force if known.kind in INDEPENDENT]
    assert of_the_force
    grade = LAWS[name].grade
    assert (grade == "R") == name.startswith("wang_liu")
    assert grade != "A" or independent, "nothing but a formula typed again: B or C"


@pytest.mark.parametrize("name", ["radzimovsky", "persson", "hertz_cylinder"])
def test_wrong_line_laws_are_noticed(name):
    """The three that no test saw: here every constant, by 1 %."""
    assert not list(survivors(name))


FORCE = ("force", "factor", "term", "definition", "relation", "along", "across", "couple", "holding")


@pytest.mark.exhaustive
@pytest.mark.parametrize("name", [name for name, law in LAWS.items() if law.grade == "A"])
def test_a_law_of_grade_a_is_pinned_by_more_than_a_formula_typed_again(name):
    """Each constant of what it computes is noticed by what is independent alone."""
    left = [mutant for mutant in survivors(name, INDEPENDENT) if mutant.where.split()[0] in FORCE]
    assert not left
