"""Derivation of chains beside sympy.physics.mechanics: time and operations (issue 5, "Numbers")."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from benchmarks.ratios import Ratio, medians, timed

LONG = 40  # links of a chain that the import of SymPy is the measure of


def chains() -> Iterator[Ratio]:
    """Scene to module text, audit included, against KanesMethod and cse on the same chain; SymPy's cache emptied before each."""
    sys.path.insert(0, str(Path(__file__).parents[1] / "derive"))
    import sympy as sp
    from kane import chain
    from operations import CHAINS, of_chain
    from sympy.core.cache import clear_cache

    from hertzwerk.derive.derivation import generate

    def ours(scene: Any) -> None:
        clear_cache()
        generate(scene)

    for name, (n, axes) in CHAINS.items():
        scene, found = chain(n, axes).scene(ledger=False), []

        def theirs(n: int = n, axes: str = axes, found: list[int] = found) -> None:
            clear_cache()
            mass, forcing, _, _ = chain(n, axes).kane()
            shared, reduced = sp.cse([mass, forcing])
            found.append(sum(e.count_ops() for _, e in shared) + sum(e.count_ops() for part in reduced for e in part))

        peer, mine = medians(timed(theirs), timed(lambda scene=scene: ours(scene)), repeats=5)
        wanted = "" if n < 3 else ">= 10" if n == 6 else ">= 1"
        note = f"operations {sum(of_chain(n, axes).values())}, KanesMethod {found[0]} (without solving)"
        yield Ratio(f"sympy.physics.mechanics + cse / derive {name}", peer, mine, wanted, note)
    imports = timed(lambda: subprocess.run([sys.executable, "-c", "import sympy"], check=True))
    for kind, axes in (("plane", "Z"), ("spatial", "ZYX")):
        scene = chain(LONG, axes).scene(ledger=False)
        mine, least = medians(timed(lambda scene=scene: ours(scene)), imports, repeats=5)
        yield Ratio(f"derive {kind} chain of {LONG} links / import sympy", mine, least, "<= 40")
