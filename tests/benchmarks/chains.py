"""Derivation of chains beside sympy.physics.mechanics: time and operations (issue 5, "Numbers")."""

from __future__ import annotations

import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from statistics import median
from typing import Any

from benchmarks.ratios import Ratio, medians, timed

LONG = 40  # links of a chain that the import of SymPy is the measure of
SHORTER, LONGER = 10, 100  # links between which cost grows with an exponent of at most 1.2 (issue 36)


def chains() -> Iterator[Ratio]:
    """Scene to module text, audit included, against KanesMethod and cse on the same chain; SymPy's cache emptied before each."""
    sys.path.insert(0, str(Path(__file__).parents[1] / "derive"))
    import sympy as sp
    from kane import chain
    from operations import CHAINS, of_chain
    from sympy.core.cache import clear_cache

    from hertzwerk.derive.equations.derivation import generate

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
    yield from long_chains()


def long_chains() -> Iterator[Ratio]:
    """Processor time of the load and of the first run of a long chain, beside those of one of a tenth of its links."""
    from kane import chain

    from hertzwerk.runtime import load, simulate

    def costs(n: int, coordinates: str) -> tuple[float, float]:
        begin = time.process_time()
        model = load(chain(n, "Z").scene().with_coordinates(coordinates))
        loaded = time.process_time()
        simulate(model, duration="1e-3 s", tolerance=1e-6)
        return loaded - begin, time.process_time() - loaded

    for coordinates in ("tree", "absolute"):
        found = [[costs(n, coordinates) for _ in range(3)] for n in (SHORTER, LONGER)]
        for what, few, many in zip(
            ("load", "first run"), *(map(median, zip(*each, strict=True)) for each in found), strict=True
        ):
            yield Ratio(
                f"{what} of {LONGER} links / {SHORTER}, {coordinates} coordinates",
                many,
                few,
                f"<= {(LONGER / SHORTER) ** 1.2:.1f}",
            )
