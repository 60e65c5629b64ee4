"""Unfinished files and folders, locked by their process; leftovers of killed processes are removed.

A name beginning with `.hertzwerk-unfinished-` is ours. Its maker holds a lock on it, which the system releases
however that process ends, so that an unlocked one is a leftover. Where there are no such locks (Windows), leftovers
stay.
"""

from __future__ import annotations

import contextlib
import os
import re
import secrets
import shutil
import sys
import time
from collections.abc import Iterable, Iterator
from pathlib import Path

if sys.platform != "win32":
    import fcntl

_PREFIX = ".hertzwerk-unfinished-"
UNFINISHED = re.compile(re.escape(_PREFIX) + "[0-9a-f]{16}")
YOUNG = 60.0  # s: younger files may not be locked yet by their maker


@contextlib.contextmanager
def scratch_folder(parent: Path) -> Iterator[Path]:
    """Make a new folder in `parent`, removed at the end unless it was renamed; raises OSError."""
    _prepare(parent)
    path = parent / f"{_PREFIX}{secrets.token_hex(8)}"
    path.mkdir()
    try:
        with _held(path):
            yield path
    finally:
        shutil.rmtree(path, ignore_errors=True)


def write_atomically(path: Path, content: bytes | Iterable[bytes]) -> None:
    """Write a file so that a reader, a crash, or a power loss never meets half of it; raises OSError.

    content    whole, or in parts that are made as they are written
    """
    _prepare(path.parent)
    temporary = path.with_name(f"{_PREFIX}{secrets.token_hex(8)}")
    try:
        with temporary.open("xb") as stream, _held(temporary):
            stream.writelines((content,) if isinstance(content, bytes) else content)
            stream.flush()
            os.fsync(stream.fileno())
            temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)


def _prepare(parent: Path) -> None:
    """Make a folder where it is missing, else remove what was left in it; raises OSError."""
    parent.mkdir(parents=True, exist_ok=True)
    sweep(parent)


def sweep(parent: Path) -> None:
    """Remove leftovers of killed processes from a folder; those that cannot be removed stay."""
    if sys.platform == "win32":
        return
    with contextlib.suppress(OSError):
        for entry in os.scandir(parent):
            if UNFINISHED.fullmatch(entry.name) and _abandoned(entry):
                if entry.is_dir(follow_symlinks=False):
                    shutil.rmtree(entry.path, ignore_errors=True)
                else:
                    Path(entry.path).unlink(missing_ok=True)


def _abandoned(entry: os.DirEntry[str]) -> bool:
    """Return whether nobody holds an entry that is old enough to have been locked."""
    try:
        if entry.is_symlink() or time.time() - entry.stat(follow_symlinks=False).st_mtime < YOUNG:
            return False
        with _held(Path(entry.path)) as held:
            return held
    except OSError:
        return False


@contextlib.contextmanager
def _held(path: Path) -> Iterator[bool]:
    """Lock a file or folder while this process lives; yield whether that succeeded.

    File systems without locks keep their leftovers.
    """
    if sys.platform == "win32":
        yield False
        return
    descriptor = os.open(path, os.O_RDONLY)
    try:
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
            held = True
        except OSError:
            held = False
        yield held
    finally:
        os.close(descriptor)
