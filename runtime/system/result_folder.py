"""New folders for results: checked before anything is computed, and published complete."""

from __future__ import annotations

import contextlib
import itertools
import os
from collections.abc import Callable, Iterator
from pathlib import Path

from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.system.atomic_files import scratch_folder

RUNS = Path("runs")  # default folder of results


def destination_fault(out: Path | None) -> Fault | None:
    """Return the fault of an output folder (default: below runs/) that cannot be written; None if it can."""
    where, expected = (
        ("runs/", "a folder that can be written to") if out is None else ("--out", "a new or an empty folder")
    )
    remedy = "name another: --out FOLDER" if out is None else ""
    try:
        hindrance = _hindrance(out)
    except OSError as error:  # a name too long, a loop of links
        hindrance = f"{str(out)[:60]}: {error.strerror}"
    except ValueError as error:  # a zero byte
        hindrance = f"{str(out)!r}: {error}"
    if hindrance is None:
        return None
    overwrites = hindrance.endswith("other content")
    return Fault(where, hindrance, expected, "a run never overwrites another" if overwrites else remedy)


def _hindrance(out: Path | None) -> str | None:
    if out is None:
        return unwritable(RUNS)
    try:
        out.lstat()
    except (FileNotFoundError, NotADirectoryError):
        return unwritable(out.absolute().parent)
    if out.is_symlink():
        return f"{out}, which is a link"
    if not out.is_dir():
        return f"{out}, which is a file"
    if any(out.iterdir()):
        return f"{out}, which has other content"
    if out.samefile(Path.cwd()):
        return f"{out}, the working folder"
    return f"{out}, a whole file system" if out.is_mount() else unwritable(out.absolute().parent)


def unwritable(folder: Path) -> str | None:
    """Return the reason why a folder, existing or to be made, cannot be written; None if it can.

    Raises OSError where that cannot be determined.
    """
    while not os.path.lexists(folder) and folder != folder.parent:
        folder = folder.parent
    if not folder.is_dir():
        return f"{folder}, which is a file"
    try:
        with scratch_folder(folder):  # permissions do not tell: of the superuser, of a full or a strange file system
            return None
    except OSError as error:
        return f"{folder}, which cannot be written to ({error.strerror})"


def new_file_faults(where: str, path: Path, way_out: str = "", *, overwrite: bool = False) -> list[Fault]:
    """Return the faults of a file to be written: one that exists, a folder that is not writable."""
    faults = []
    if path.exists() and not overwrite:
        faults.append(Fault(where, f"{path}, which exists", "a new file", way_out))
    hindrance = unwritable(path.absolute().parent)
    if hindrance is not None:
        faults.append(Fault(where, hindrance, "a file in a folder that can be written to"))
    return faults


def new_folder(name: str, out: Path | None, fill: Callable[[Path], list[str]]) -> tuple[Path, list[str]]:
    """Fill the new folder `out`, or the next free runs/<name>-NNN; return it and its files.

    All of it appears at once, or nothing.
    """
    parent = out.parent if out is not None else RUNS
    with scratch_folder(parent) as temporary:
        files = fill(temporary)
        return _publish(temporary, out, parent / name), files


def made_folder(name: str, out: Path | None) -> Path:
    """Make the empty folder `out`, or the next free runs/<name>-NNN, and return it; raises InputError."""
    if out is not None:
        out.mkdir(parents=True, exist_ok=True)
        return out
    paths = numbered(RUNS / name)
    while True:
        path = next(paths)
        with contextlib.suppress(FileExistsError):
            path.mkdir(parents=True)
            return path


def remove_if_empty(folder: Path) -> None:
    """Remove a folder of runs/ that nothing was written to, and runs/ where it held nothing else."""
    for path in (folder, RUNS):
        with contextlib.suppress(OSError):
            path.rmdir()


def failures_of(name: str, make: Callable[[], object]) -> list[str]:
    """Make something that must not fail the rest; return messages on its failure."""
    try:
        make()
    except Exception as error:  # whatever it is
        return [f"{name} could not be made: {type(error).__name__}: {error}"]
    return []


def _publish(temporary: Path, out: Path | None, stem: Path) -> Path:
    """Rename the finished folder to its name.

    A rename onto a folder with content fails, so two runs never mix.
    """
    if out is not None:
        try:
            return temporary.rename(out)
        except OSError as error:
            raise InputError("run", [Fault("--out", str(error), "a new or an empty folder")]) from error
    paths = numbered(stem)
    while True:
        path = next(paths)
        try:
            if not path.exists():
                return temporary.rename(path)
        except FileExistsError:
            pass  # another run took the number meanwhile
        except OSError:
            if not path.exists():
                raise


def numbered(stem: Path) -> Iterator[Path]:
    """Yield <stem>-001, <stem>-002, and so on, without end."""
    return (stem.with_name(f"{stem.name}-{number:03d}") for number in itertools.count(1))
