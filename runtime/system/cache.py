"""Cache folder of the user for derived text and compiled code.

Both are executed when found, so only a folder that nobody else can write is trusted. An entry's name holds the digest
of its content, `<key>-<digest><suffix>`: a truncated or changed one is detected, removed, and made again. Without a
folder (none can be made, the disk is full) everything works, without reuse.
"""

from __future__ import annotations

import contextlib
import hashlib
import os
import stat
from pathlib import Path

from hertzwerk.runtime.system.atomic_files import write_atomically


def folder() -> Path | None:
    """Return the cache folder, made if need be with access for its user alone; None if none is trusted.

    `HERTZWERK_CACHE` names another one; set but empty it turns the cache off.
    """
    chosen = os.environ.get("HERTZWERK_CACHE")
    if chosen == "":
        return None
    try:
        path = Path(chosen) if chosen else _default()
        path.mkdir(mode=0o700, parents=True, exist_ok=True)
        status = path.stat()
    except (OSError, RuntimeError):  # RuntimeError: a user without a home
        return None
    if hasattr(os, "getuid") and (status.st_uid != os.getuid() or stat.S_IMODE(status.st_mode) & 0o022):
        return None
    return path if os.access(path, os.W_OK) else None


def entry(key: str, suffix: str) -> Path | None:
    """Return the file of an entry with intact content, or None; corrupt files are removed."""
    path = folder()
    for file in path.glob(f"{key}-*{suffix}") if path is not None else ():
        with contextlib.suppress(OSError):
            if file.name == _name(key, suffix, file.read_bytes()):
                return file
            file.unlink()
    return None


def read(key: str, suffix: str) -> str | None:
    """Return the text of an entry, or None."""
    file = entry(key, suffix)
    try:
        return file.read_text(encoding="utf-8") if file else None
    except (OSError, UnicodeDecodeError):
        return None


def keep(key: str, suffix: str, content: bytes) -> Path | None:
    """Store content under a key; return its file, or None if it cannot be stored.

    A full or vanished disk is no error for a cache.
    """
    path = folder()
    if path is None:
        return None
    file = path / _name(key, suffix, content)
    try:
        write_atomically(file, content)
    except OSError:
        return None
    return file


def _name(key: str, suffix: str, content: bytes) -> str:
    return f"{key}-{hashlib.sha256(content).hexdigest()[:32]}{suffix}"


def _default() -> Path:
    base = os.environ.get("LOCALAPPDATA") if os.name == "nt" else os.environ.get("XDG_CACHE_HOME")
    return (Path(base) if base else Path.home() / ".cache") / "hertzwerk"
