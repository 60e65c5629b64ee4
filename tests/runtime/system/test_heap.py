"""Memory that is freed and taken again: without a fault where it is kept, by pages of zeros where it is not."""

import platform
import subprocess
import sys

import pytest

TAKES = """
import resource
from hertzwerk.runtime.system.heap import keep_freed
{}
for _ in range(3):
    before = resource.getrusage(resource.RUSAGE_SELF).ru_minflt
    blocks = [b"x" * n for n in range(480_000, 480_020)]
    del blocks
print(resource.getrusage(resource.RUSAGE_SELF).ru_minflt - before)
"""


def faults(begin):
    """Faults of a new process that takes 20 blocks of 480 kB once more."""
    return int(subprocess.run([sys.executable, "-c", TAKES.format(begin)], capture_output=True, check=True).stdout)


@pytest.mark.skipif(sys.platform != "linux" or platform.libc_ver()[0] != "glibc", reason="GNU's C library")
def test_freed_memory_is_reused_without_page_faults():
    assert faults("keep_freed()") < 20 < 500 < faults("pass")
