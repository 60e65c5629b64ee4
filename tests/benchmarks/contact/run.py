"""Work against error of hertzwerk and its peers in contact. From the repository's root, in an environment with `pip install -e ".[peers]"`:

python tests/benchmarks/contact/run.py                     all problems, about 15 minutes; then pictures and page
python tests/benchmarks/contact/run.py ball --budget 60    one problem, in about 60 s
python tests/benchmarks/contact/run.py --report            pictures and page from the results that are there
"""

from __future__ import annotations

import argparse
import sys
import warnings
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[2] / "runtime"))
sys.path.insert(0, str(Path(__file__).parents[2]))

from benchmarks.contact import measuring, report
from benchmarks.contact.problems import PROBLEMS


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("problems", nargs="*", metavar="PROBLEM", help=f"of {', '.join(PROBLEMS)} (default: all)")
    parser.add_argument(
        "--budget", type=float, metavar="SECONDS", help="processor time for all chosen problems together (default: 900)"
    )
    parser.add_argument("--peers", nargs="+", metavar="PEER", help=f"of {', '.join(measuring.PEERS)} (default: all)")
    parser.add_argument("--report", action="store_true", help="measure nothing; write pictures and page")
    arguments = parser.parse_args()
    chosen = arguments.problems or list(PROBLEMS)
    for name, known in ((chosen, PROBLEMS), (arguments.peers or [], measuring.PEERS)):
        if unknown := sorted(set(name) - set(known)):
            parser.error(f"unknown: {', '.join(unknown)}; known: {', '.join(known)}")
    warnings.simplefilter("ignore")  # of peers
    for name in () if arguments.report else chosen:
        problem = PROBLEMS[name]()
        print(f"{name}: {problem.title}", flush=True)
        budget = (arguments.budget or 900) / len(chosen)
        some = measuring.peers(tuple(arguments.peers or measuring.PEERS))
        rows = measuring.measure(problem, some, budget)
        path = report.RESULTS / f"{name}.csv"
        if arguments.peers and path.is_file():  # the other peers keep their rows
            names = {peer.NAME for peer in some}
            rows += [row for row in measuring.read(path) if row["peer"] not in names]
        measuring.write(rows, path)
        print("\n".join(report.table(rows, problem.targets)), flush=True)
    report.write()


if __name__ == "__main__":
    main()
