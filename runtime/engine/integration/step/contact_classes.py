"""Classes of step attempts by the pairs in contact, so that pairs not in contact cost no evaluation.

Class 0 is idle. Then follow the step without contact, one step for each pair alone in contact, and the general step,
which evaluates every contact force and masks it by the pair's mode.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Final, TypeAlias

import casadi as ca
import numpy as np

from hertzwerk.runtime.engine.integration.step.layout import CONTACT, FLIGHT, RELEASED
from hertzwerk.runtime.engine.model.per_model import per_model

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.model.model import EngineModel

Contacts: TypeAlias = tuple[int, ...] | None  # the pairs in contact; BY_MODE: those whose mode says so
BY_MODE: Final = None
IDLE, IN_FLIGHT, IN_CONTACT = range(3)  # IN_FLIGHT: no pair in contact; IN_CONTACT and above: some pair is
ALONE = 10  # most pairs with a class each: every class is built and compiled, with 16 pairs three times as long
LARGE = 1000  # instructions of all those classes beyond which there are none


def contact_classes(model: EngineModel) -> tuple[Contacts, ...]:
    """Return the contacts of the classes IN_FLIGHT, IN_CONTACT, ... in order."""
    alone = tuple((j,) for j in range(model.k if _have_classes(model) else 0))
    several = () if model.k == len(alone) <= 1 else (BY_MODE,)
    return ((), *alone, *several)


@per_model
def _have_classes(model: EngineModel) -> bool:
    """Return whether each pair has a class.

    A model of many or large ones would take too long to build and to compile.
    """
    if model.k > ALONE:
        return False
    motion = model.function("accelerations").n_instructions()
    return (
        sum(model.function(f"contact_{pair}").n_instructions() + motion for pair in model.pairs) <= LARGE
        or model.k == 1
    )


def class_of(model: EngineModel, mode: Any) -> Any:
    """Return the class of the next attempt under modes (k).

    Single-contact classes require that no other pair is released.
    """
    if not model.k:
        return ca.DM(IN_FLIGHT)
    touching = mode == CONTACT
    in_contact = ca.DM(IN_CONTACT)
    if _have_classes(model):
        single = (ca.sum1(touching) == 1) * ca.mmin(mode != RELEASED)
        in_contact = IN_CONTACT + ca.if_else(single, ca.dot(touching, ca.DM(range(model.k))), model.k)
    return ca.if_else(ca.mmax(touching), in_contact, IN_FLIGHT)


def contacts_at(model: EngineModel, mode: np.ndarray) -> np.ndarray:
    """Return the places (n,) in `contact_classes` of the contacts under modes (n, k)."""
    touching = mode == CONTACT
    places = np.where(touching.any(axis=1), len(contact_classes(model)) - 1, 0)
    if model.k and _have_classes(model):
        single = (touching.sum(axis=1) == 1) & (mode != RELEASED).all(axis=1)
        places[single] = 1 + touching[single].argmax(axis=1)
    return places


def modes(model: EngineModel, contacts: tuple[int, ...]) -> Any:
    """Return the constant modes (k) of a class whose contacts are known, with no pair released."""
    return ca.DM([CONTACT if j in contacts else FLIGHT for j in range(model.k)])


def active_contacts(model: EngineModel, contacts: Contacts, mode: Any) -> Iterator[tuple[int, Any, Any]]:
    """Yield (number, contact function, condition) of every pair that may be in contact under modes (k).

    The condition is the constant 1 for a pair certainly in contact.
    """
    for j, pair in enumerate(model.pairs):
        if contacts is BY_MODE or j in contacts:
            yield j, model.function(f"contact_{pair}"), mode[j] == CONTACT if contacts is BY_MODE else ca.DM(1)


def masked(active: Any, value: Any, otherwise: float = 0.0) -> Any:
    """Return the value while active, else `otherwise`; no if_else where `active` is constant."""
    return value if active.is_one() else ca.if_else(active, value, otherwise)
