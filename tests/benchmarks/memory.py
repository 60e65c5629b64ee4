"""What a long run needs: steps, rows kept, impacts, processor time per step [us], peak memory [MB]. From the repository's root:

python tests/benchmarks/memory.py slider_crank_frictionless 10_000_000 "28 ms" "300 s"     # 10^7 steps, 10^4 states kept: <= 300 MB
"""

from __future__ import annotations

import json
import resource
import sys
import time
from pathlib import Path


def main(name: str, steps: str, spacing: str, duration: str) -> None:
    from hertzwerk.runtime import load, simulate
    from hertzwerk.runtime.engine.integration.loop.c_compilation import available

    began = time.process_time()
    settings = {"duration": duration, "grid": spacing, "tolerance": 1e-6, "max_events": 10**9}
    # whether a run is compiled is not left to its length: compiling takes memory too
    run = simulate(load(name), **settings, max_steps=int(steps), compiled=available())
    seconds = time.process_time() - began
    found = {
        "outcome": run.outcome.name,
        "steps": run.statistics.steps,
        "rows": len(run.t),
        "impacts": len(run.impacts),
        "energy_residual": run.energy_residual,
        "us_per_step": round(seconds / run.statistics.steps * 1e6, 3),
        "peak_mb": _peak_mb(),
    }
    print(json.dumps(found))


def _peak_mb() -> float:
    """Most memory this process has held [MB]. On Linux not by getrusage, whose number includes the process that started this one."""
    status = Path("/proc/self/status")
    if status.exists():
        line = next(line for line in status.read_text().splitlines() if line.startswith("VmHWM:"))
        return int(line.split()[1]) * 1024 / 1e6
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss * 1024 / 1e6


if __name__ == "__main__":
    main(*sys.argv[1:])
