"""File of a saved run: arrays, the rest as JSON, and a digest by which altered files are refused."""

from __future__ import annotations

import hashlib
import io
import json
import zipfile
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any, NoReturn, TypeVar

import numpy as np

from hertzwerk.derive.common import module_format
from hertzwerk.derive.common.faults import Fault, InputError
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.solution.history import History, acceleration_of

FORMAT = "hertzwerk run 1"
_OWN = ("about", "digest")

Content = TypeVar("Content")


def packed(about: Mapping[str, Any], histories: Mapping[str, np.ndarray]) -> bytes:
    """Pack a run as npz; raises MemoryError where it does not fit."""
    text = json.dumps(about)
    content = io.BytesIO()
    arrays: dict[str, Any] = {name: np.asarray(values) for name, values in histories.items()}
    # to compress takes 20 times as long, for a fifth of the size
    try:
        np.savez(content, about=text, digest=_digest(text, arrays), **arrays)
    except ValueError as error:  # of an archive that cannot be closed after memory ran out
        raise MemoryError from error
    return content.getvalue()


def unpacked(path: Path, read: Callable[[dict[str, Any], dict[str, np.ndarray]], Content]) -> Content:
    """Return the result of `read` on the parts of a saved file; raises InputError for any other file."""
    try:
        with path.open("rb") as raw, np.load(raw, allow_pickle=False) as file:
            text, digest = str(file["about"]), str(file["digest"])
            histories = {name: file[name] for name in file.files if name not in _OWN}
    except OSError as error:
        _refuse(path, error.strerror or str(error), "a readable file")
    except (KeyError, ValueError, TypeError, AttributeError, EOFError, MemoryError, zipfile.BadZipFile) as error:
        _refuse(path, f"no saved run ({type(error).__name__})", "a file that Solution.save wrote")
    except Exception as error:  # zlib, struct and others, of a damaged archive
        _refuse(path, f"a damaged file ({type(error).__name__}: {error})", "the file as Solution.save wrote it")
    if digest != _digest(text, histories):
        _refuse(path, "another content than was saved", "the file as Solution.save wrote it, by this version")
    try:
        about = json.loads(text)
        form = about["scene"].get("FORMAT")
        if form != module_format.FORMAT:
            _refuse(path, f"tables in the format {form!r}", f"{module_format.FORMAT!r}, of this version")
        return read(about, histories)
    except InputError:
        raise
    except (KeyError, TypeError, ValueError, AttributeError) as error:
        _refuse(path, f"entries that cannot be read ({error})", "a run saved by this version")


def rates(history: History) -> np.ndarray:
    """Return the time derivatives (rows, n) of the histories that have none among them."""
    model, of_states = history.model, history.part("dy")
    coordinates, memory = of_states[:, : model.nq], of_states[:, model.nq + model.nu :]
    return np.hstack([coordinates, memory, history.output_rates(), history.part("force_rate")])


def rates_by_name(
    rates: np.ndarray | None, model: EngineModel, histories: Mapping[str, np.ndarray]
) -> dict[str, np.ndarray]:
    """Return saved rates by their histories' names, those that are histories too; none without steps."""
    if rates is None:
        return {}
    forces = (f"{pair}.normal_force" for pair in model.pairs)
    names = (*model.coordinates, *model.memory, *model.outputs, *forces)
    known = {name: histories[acceleration_of(name)] for name in model.speeds}
    known |= {f"{pair}.gap": histories[f"{pair}.gap_rate"] for pair in model.pairs if pair not in model.journals}
    return known | dict(zip(names, rates.T, strict=True))


def _digest(text: str, histories: Mapping[str, np.ndarray]) -> str:
    digest = hashlib.sha256(f"{FORMAT}\0{text}".encode("utf-8", "surrogatepass"))
    for name, values in sorted(histories.items()):
        digest.update(f"\0{name}\0{values.dtype.str}\0{values.shape}\0".encode("utf-8", "surrogatepass"))
        digest.update(np.ascontiguousarray(values).tobytes())
    return digest.hexdigest()


def _refuse(path: Path, found: str, expected: str) -> NoReturn:
    raise InputError(
        str(path), [Fault("saved run", found, expected, "Run it again; states.csv holds the histories alone.")]
    )
