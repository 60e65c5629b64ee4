"""CasADi functions as C: generated, compiled by the system's compiler, cached in the user's folder.

The cache's key is everything the machine code depends on: the C text, the compiler's version, the flags, the
processor. Contraction of a*b + c to one rounding is off, so C and CasADi's virtual machine agree bitwise, but where
that is not asked for.
"""

from __future__ import annotations

import hashlib
import os
import platform
import shlex
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Callable, Iterable, Sequence
from functools import cache, cached_property
from pathlib import Path
from typing import Any

import casadi as ca

from hertzwerk.runtime.host import cache as disk
from hertzwerk.runtime.host.interrupt import raise_interrupts
from hertzwerk.runtime.host.scratch import scratch_folder

FLAGS = (
    *("-march=native", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math"),
    "-fno-tree-slp-vectorize",  # GCC 12 makes of a sum beside a difference one fused instruction all the same
    *("-fno-semantic-interposition", "-fPIC", "-shared", "-w"),  # the first lets CasADi's small functions be inlined
)
FUSED = "-ffp-contract=fast"
LARGE = 1_500_000  # characters of C up to which -O3 is worth its compilation; 10 pairs: 1.1 million, 1.5 times as fast as with -O1
PATIENCE = 0.1  # s between two polls
# s; within a fifth of 8 measured times of 12 to 77 s. What registers hold takes a time with the square of a function's length: of the longest
# text of the built-in scenes, ball_bearing with both methods, two thirds
COMPILE_S, COMPILE_S_PER_CHARACTER, COMPILE_S_PER_SQUARE = 0.8, {"-O1": 7.5e-6, "-O3": 13e-6}, 8e-12


class NoCompilerError(RuntimeError):
    """No working C compiler was found."""


class BrokenCompilerError(NoCompilerError):
    """A C compiler was found, or named by $CC, but it fails."""


class Program:
    """C text of CasADi functions and its library, compiled on demand; raises NoCompilerError.

    bitwise: whether results are those of the virtual machine to the bit
    """

    def __init__(self, *functions: Any, bitwise: bool = True) -> None:
        self._functions, self._compiler = functions, _compiler()
        self._text = c_text(functions)
        self._level = level(self._text)
        self._flags = (self._level, *FLAGS, *(() if bitwise else (FUSED,)))
        parts = (self._text, *self._compiler, _version(self._compiler), *self._flags, _processor())
        digest = hashlib.sha256("\0".join(parts).encode()).hexdigest()
        self._key = f"compiled-{digest[:32]}"
        self._library = disk.entry(self._key, ".so")

    @property
    def seconds(self) -> float:
        """Estimated time [s] to compile; 0 if the library is there already."""
        return 0.0 if self._library is not None else self._estimate

    @cached_property
    def _estimate(self) -> float:
        return compile_seconds(self._text)

    def load(self, poll: Callable[[], object] = lambda: None) -> list[Any]:
        """Return the compiled functions, compiled now if need be.

        poll: called now and then. Raises NoCompilerError, and what `poll` raises.
        """
        if self._library is not None:
            return self._loaded(self._library)
        try:
            with raise_interrupts(), scratch_folder(Path(tempfile.gettempdir())) as folder:
                source = folder / "chunk.c"
                source.write_text(self._text, encoding="utf-8")
                made = compile_files(self._flags, [source], folder / "chunk.so", poll)
                self._library = disk.keep(self._key, ".so", made.read_bytes())
                return self._loaded(self._library or made)  # what is loaded needs no file any more
        except OSError as error:
            raise NoCompilerError(f"nothing can be compiled: {error}") from error

    def _loaded(self, library: Path) -> list[Any]:
        return [ca.external(function.name(), str(library)) for function in self._functions]


def compile_seconds(text: str) -> float:
    """Return the estimated time [s] to compile a C text."""
    squares = sum(len(function) ** 2 for function in text.split("\n}\n"))
    return COMPILE_S + COMPILE_S_PER_CHARACTER[level(text)] * len(text) + COMPILE_S_PER_SQUARE * squares


def level(text: str) -> str:
    """Return the compiler's level of optimisation for a C text."""
    return "-O1" if len(text) > LARGE else "-O3"


def available() -> bool:
    """Return whether there is a C compiler."""
    try:
        _compiler()
    except NoCompilerError:
        return False
    return True


def c_text(functions: Iterable[Any], name: str = "hertzwerk_chunk") -> str:
    """Return the C text of CasADi functions, whose inner names begin with a name."""
    generator = ca.CodeGenerator(f"{name}.c", {"with_header": False})
    for function in functions:
        generator.add(function)
    text: str = generator.dump()
    # what the library's functions give, in line: a call costs as much as ten operations
    for name, order in (("fmin", "<"), ("fmax", ">")):
        text = text.replace(f"return {name}(x, y);", f"return x {order} y || y != y ? x : y;")
    return text


def compile_files(
    flags: tuple[str, ...], sources: Sequence[Path], target: Path, poll: Callable[[], object] = lambda: None
) -> Path:
    """Compile C files to a library; raises NoCompilerError, OSError, and what `poll` raises."""
    command = [*_compiler(), *flags, "-o", str(target), *map(str, sources), "-lm"]
    said, returncode = _run(command, poll)
    if returncode != 0:
        raise BrokenCompilerError(f"{' '.join(command)} failed:\n{said.strip()[:2000]}")
    if not target.is_file():
        raise BrokenCompilerError(f"{' '.join(command)} makes no library")
    return target


def _run(command: list[str], poll: Callable[[], object]) -> tuple[str, int]:
    """Run a command; return its standard error and exit code.

    Killed with all its children where `poll`, called meanwhile, raises.
    """
    group = 0 if os.name == "posix" else None  # a compiler has children
    null, pipe = subprocess.DEVNULL, subprocess.PIPE
    with subprocess.Popen(command, stdout=null, stderr=pipe, text=True, process_group=group) as run:
        try:
            while True:
                try:
                    return run.communicate(timeout=PATIENCE)[1], run.returncode
                except subprocess.TimeoutExpired:
                    poll()
        except BaseException:
            if group is not None:
                os.killpg(run.pid, signal.SIGKILL)
            run.kill()
            raise


@cache
def _compiler() -> tuple[str, ...]:
    """Return the command of the C compiler: $CC with its options, else cc, gcc, clang.

    Raises NoCompilerError.
    """
    asked = os.environ.get("CC", "").strip()
    if asked:
        try:
            name, *options = shlex.split(asked)
        except ValueError as error:
            raise BrokenCompilerError(f"CC={asked!r} is no command: {error}") from error
        path = shutil.which(name)
        if path is None:
            raise BrokenCompilerError(f"CC={asked!r} names no program that can be run")
        return (path, *options)
    for name in ("cc", "gcc", "clang"):
        path = shutil.which(name)
        if path:
            return (path,)
    raise NoCompilerError(
        "found no C compiler (CC, cc, gcc, clang); install one, or run with compiled=False: the results are the same, slower"
    )


@cache
def _version(compiler: tuple[str, ...]) -> str:
    return subprocess.run(
        [*compiler, "--version"], stdin=subprocess.DEVNULL, capture_output=True, text=True, check=False
    ).stdout


@cache
def _processor() -> str:
    """Return the processor's description, on which -march=native depends."""
    try:
        lines = Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines()
    except OSError:
        return f"{platform.machine()} {platform.processor()}"
    wanted = ("model name", "flags", "Features", "CPU part")
    return "\n".join(dict.fromkeys(line for line in lines if line.startswith(wanted)))
