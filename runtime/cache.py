"""The user's cache folder: derived text and compiled code, both executed when found, so only a folder that nobody else can write is trusted."""

from __future__ import annotations

import contextlib
import os
import secrets
import stat
from pathlib import Path


def folder() -> Path | None:
    """The cache folder, made if need be with access for its user alone; None where there is none to be trusted.

    `HERTZWERK_CACHE` names another one; set but empty it turns the cache off.
    """
    chosen = os.environ.get("HERTZWERK_CACHE")
    if chosen == "":
        return None
    path = Path(chosen) if chosen else _default()
    try:
        path.mkdir(mode=0o700, parents=True, exist_ok=True)
        status = path.stat()
    except OSError:
        return None
    if hasattr(os, "getuid") and (status.st_uid != os.getuid() or stat.S_IMODE(status.st_mode) & 0o022):
        return None
    return path if os.access(path, os.W_OK) else None


def read(name: str) -> str | None:
    """Text of a cached file, or None."""
    path = folder()
    try:
        return (path / name).read_text(encoding="utf-8") if path else None
    except (OSError, UnicodeDecodeError):
        return None


def write(name: str, text: str) -> None:
    """Keep text under a name; another process sees all of it or nothing. A full or vanished disk is no error: it is a cache."""
    path = folder()
    if path is not None:
        with contextlib.suppress(OSError):
            write_atomically(path / name, text.encode())


def write_atomically(path: Path, content: bytes) -> None:
    """Write a file so that a reader, or a crash, never meets half of it; raises OSError."""
    temporary = path.with_name(f".{path.name}-{secrets.token_hex(4)}")
    try:
        with temporary.open("xb") as stream:
            stream.write(content)
        temporary.replace(path)
    finally:
        temporary.unlink(missing_ok=True)


def _default() -> Path:
    base = os.environ.get("LOCALAPPDATA") if os.name == "nt" else os.environ.get("XDG_CACHE_HOME")
    return (Path(base) if base else Path.home() / ".cache") / "hertzwerk"
