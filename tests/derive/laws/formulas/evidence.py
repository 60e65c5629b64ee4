"""What is known of every law of the catalogue from elsewhere, as checks of a record: published digits, exact relations, quadratures, other laws in a
limit, and closed forms typed again from the literature.

`test_evidence.py` holds every law to its own; `mutate_laws.py` changes each constant by 1 % and asks that one of them notices. A grade follows: A
needs a check that is more than a formula typed twice.
"""

from __future__ import annotations

import known_damping
import known_friction
import known_plastic
import known_stiffness
from known import Evidence

from hertzwerk.derive.laws import LAWS
from hertzwerk.derive.laws.law import StiffnessLaw

KINDS = known_stiffness, known_plastic, known_damping, known_friction
EVIDENCE: dict[str, tuple[Evidence, ...]] = {name: rows for kind in KINDS for name, rows in kind.EVIDENCE.items()}
EVIDENCE |= {
    name: (*checks, known_stiffness.stored_is_the_integral()) if isinstance(LAWS[name], StiffnessLaw) else checks
    for name, checks in EVIDENCE.items()
}
