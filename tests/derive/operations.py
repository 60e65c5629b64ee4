"""Operation counts of every built-in scene and of the chains that derivations are compared on: a baseline that a change has to accept.

python tests/derive/operations.py    writes operations.json anew
"""

from __future__ import annotations

import json
import sys
from importlib import import_module
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parent))

from derived import Derived
from kane import chain

from hertzwerk.derive.scenes import NAMES

BASELINE = Path(__file__).with_name("operations.json")
ACCEPT = "python tests/derive/operations.py"
CHAINS = {
    f"{kind} chain of {n} links": (n, axes) for kind, axes in (("plane", "Z"), ("spatial", "ZYX")) for n in range(2, 9)
}
COUNTED = [name for name, (n, _) in CHAINS.items() if n < 6]
IN_BOTH = ("plane chain of 5 links", "spatial chain of 4 links")


def counts() -> dict[str, dict[str, int]]:
    """By scene or chain, the operations of each of its functions; scenes as committed, which test_cli.py holds to what they derive to."""
    scenes = {name: dict(import_module(f"hertzwerk.generated.{name}").OPERATIONS) for name in NAMES}
    absolute = {f"{name} in absolute coordinates": of_chain(*CHAINS[name], "absolute") for name in IN_BOTH}
    return scenes | {name: of_chain(*CHAINS[name]) for name in COUNTED} | absolute


def of_chain(n: int, axes: str, coordinates: str = "tree") -> dict[str, int]:
    """The operations of a chain's equations of motion: gravity, and accelerations, which includes solving for them."""
    found = dict(Derived(chain(n, axes).scene(ledger=False).with_coordinates(coordinates)).OPERATIONS)
    return {name: found[name] for name in ("applied", "accelerations")}


def text(found: dict[str, dict[str, int]]) -> str:
    """As it is written: one line per function."""
    return json.dumps(found, indent=1) + "\n"


if __name__ == "__main__":
    BASELINE.write_text(text(counts()), encoding="utf-8")
    print(f"written  {BASELINE}")
