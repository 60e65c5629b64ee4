"""Memory of a process that does alike things again and again: what it frees stays its own.

The C library gives large blocks back to the kernel as they are freed, and gets them anew as pages of zeros, each by a fault of
its own: of short runs whose steps are kept that is a tenth of all time.
"""

from __future__ import annotations

import ctypes
import math
import sys
from pathlib import Path

BLOCK, UNUSED = (
    2**25,
    2**26,
)  # bytes: largest block that is not given back, as large as may be; most that is kept unused
_TRIM, _MMAP = -1, -3  # M_TRIM_THRESHOLD, M_MMAP_THRESHOLD of malloc.h


def available() -> float:
    """Return the memory that is left to new data [bytes], infinite where the system does not say."""
    try:
        lines = Path("/proc/meminfo").read_text(encoding="ascii").splitlines()
        (kilobytes,) = (line.split()[1] for line in lines if line.startswith("MemAvailable:"))
    except (OSError, ValueError):
        return math.inf
    return 1024.0 * int(kilobytes)


def keep_freed() -> None:
    """Have this process keep the memory that it frees, up to UNUSED bytes, where the C library is GNU's."""
    mallopt = getattr(ctypes.CDLL(None), "mallopt", None) if sys.platform == "linux" else None
    if mallopt is not None:
        mallopt(_TRIM, UNUSED)
        mallopt(_MMAP, BLOCK)
