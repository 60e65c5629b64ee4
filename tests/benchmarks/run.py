"""hertzwerk beside its peers, as ratios measured in one run on one machine. From the repository's root:

    python tests/benchmarks/run.py [SECTION...]        (--help lists them)

Every number is a median of at least five measurements that alternate between the sides. A ratio's bar is what the issues ask for: issue 2 ("Speed")
in startup, issue 5 ("Numbers") in chains, issue 6 in honesty (which is no matter of time but of shares), issue 13 in sweep, issue 15 in
sensitivities, issue 36 in size, rows, minute and bodies, issue 38 in measured, issue 40 in overpaid, issues 4 and 40 in limit. Nothing here
fails a test, for seconds depend on the machine.
"""

from __future__ import annotations

import argparse
import itertools
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1] / "runtime"))
sys.path.insert(0, str(Path(__file__).parents[1]))

from benchmarks.bodies import bodies
from benchmarks.chains import chains
from benchmarks.derivatives import sensitivities
from benchmarks.honesty import honesty
from benchmarks.limit import limit
from benchmarks.measured import measured
from benchmarks.minute import minute
from benchmarks.overpaid import overpaid
from benchmarks.ratios import Ratio, medians, timed
from benchmarks.rows import rows
from benchmarks.size import size
from benchmarks.sweep import sweep

# ---- whole process ---------------------------------------------------------------------------------------------------


def startup() -> Iterator[Ratio]:
    """A run from the shell, results written, nothing cached, against the imports nobody can avoid."""
    command = [sys.executable, "-c", "from hertzwerk.command_line import start; start()"]  # as the script does
    with tempfile.TemporaryDirectory() as folder:
        fresh = (Path(folder) / f"run{i}" for i in itertools.count())

        def run() -> None:
            here = next(fresh)
            arguments = ["run", "slider_crank", "--no-plots", "--accuracy", "1e-6", "--out", str(here / "results")]
            here.mkdir()
            environment = {**os.environ, "HERTZWERK_CACHE": str(here / "cache")}
            subprocess.run([*command, *arguments], check=True, capture_output=True, env=environment)

        def imports() -> None:
            subprocess.run([sys.executable, "-c", "import casadi, numpy"], check=True)

        run(), imports()
        whole, least = medians(timed(run), timed(imports), repeats=11)
    yield Ratio("hertzwerk run slider_crank / import casadi, numpy", whole, least, "<= 5")


SECTIONS = {
    "startup": startup, "chains": chains, "limit": limit, "honesty": honesty, "overpaid": overpaid, "sweep": sweep,
    "sensitivities": sensitivities, "size": size, "rows": rows, "minute": minute, "bodies": bodies,
    "measured": measured,
}  # fmt: skip


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("sections", nargs="*", metavar="SECTION", help=f"of {', '.join(SECTIONS)} (default: all)")
    chosen = parser.parse_args().sections or list(SECTIONS)
    if unknown := set(chosen) - set(SECTIONS):
        parser.error(f"no such section: {', '.join(sorted(unknown))}")
    for name in chosen:
        print(f"{name}: {SECTIONS[name].__doc__}")
        for line in SECTIONS[name]():
            print(line, flush=True)


if __name__ == "__main__":
    main()
