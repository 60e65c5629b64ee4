"""List of the built-in studies, and studies from users' files."""

from __future__ import annotations

from importlib import import_module
from pathlib import Path

from hertzwerk.derive.common.faults import Fault, InputError, unknown
from hertzwerk.runtime.studies.paper.study_page import Study

NAMES = ("exponents", "stiffness", "bouncing", "slider_crank")
"""Built-in studies: NAME is `STUDY` of `study_NAME.py`."""


def study_of(target: str) -> Study:
    """Return a built-in study, or `study` of a Python file, which is executed; raises InputError."""
    from hertzwerk.runtime.engine.model.build import defined_by, is_file

    if target in NAMES:
        return import_module(f"hertzwerk.runtime.studies.paper.study_{target}").STUDY
    if not is_file(target):
        raise InputError("study", [unknown("study", target, NAMES, "or a Python file (its name ends in .py)")])
    own = defined_by(Path(target)).get("study")
    if not isinstance(own, Study):
        actual = "no `study`" if own is None else f"`study` of type {type(own).__name__}"
        raise InputError(target, [Fault(target, actual, "a file that defines `study = Study(name, question, run)`")])
    return own
