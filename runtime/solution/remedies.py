"""Recommendation of another method for a run whose steps became many or small, by the cause."""

from __future__ import annotations

from typing import TYPE_CHECKING

import numpy as np

from hertzwerk.runtime.integrate.loop import choose
from hertzwerk.runtime.integrate.tableaux.explicit_tableaux import RungeKutta
from hertzwerk.runtime.integrate.tableaux.methods import IMPLICIT, METHODS, SUNDIALS
from hertzwerk.runtime.model.caller import Rowwise
from hertzwerk.runtime.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.model.model import Model
    from hertzwerk.runtime.solution.history import History

LAST = 200  # rows examined
MOST = 0.5  # of these, for a cause to be recognised
AUTO = 'take method="auto"'


def of_steps(method: str, history: History) -> str:
    """Recommend a method in place of one whose steps were many or too small; "" if none need be better."""
    (table, *others) = (table() for table in METHODS[method])
    if others or method in SUNDIALS or not len(history.rows):
        return ""
    rows = history.rows[-LAST:]
    (found,) = _fastest(history.model)(history.controls, rows)
    stiff = bool(np.mean(found[:, 0] > choose.STIFF / 2) > MOST)
    explicit = isinstance(table, RungeKutta)
    if explicit and stiff:
        return f"stability holds the steps of {method} down, not accuracy: {AUTO}, or {' or '.join(IMPLICIT)}"
    if explicit and _alternates(found[:, 1:]):
        return f"step after step of {method} crosses the layer in which friction reverses: {AUTO}, or {' or '.join(IMPLICIT)}"
    if not explicit and not stiff:
        return f"nothing is stiff there, and steps of {method} are shorter than those of dop853: {AUTO}"
    return ""


@per_model
def _fastest(model: Model) -> Rowwise:
    return Rowwise(choose.fastest(model), constant=1)


def of_accuracy(method: str) -> str:
    """Recommend a method in place of one that cannot reach some error."""
    if method in ("auto", "dop853"):
        return ""
    return f"many steps of {method} leave more rounding than the few of dop853, of higher order: {AUTO}"


def _alternates(sliding: np.ndarray) -> bool:
    """Return whether a sliding velocity (rows, n) changes its sign about every other step."""
    turned = np.diff(np.sign(sliding), axis=0) != 0
    return bool(turned.size and np.max(np.mean(turned, axis=0)) > MOST / 2)
