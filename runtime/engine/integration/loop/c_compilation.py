"""CasADi functions as C: generated, compiled by the system's compiler, cached in the user's folder.

The cache's key is everything the machine code depends on: the C text, the compiler's version, the flags, the
processor. Contraction of a*b + c to one rounding is off, so C and CasADi's virtual machine agree bitwise, but where
that is not requested.
"""

from __future__ import annotations

import hashlib
import os
import platform
import re
import shlex
import shutil
import signal
import subprocess
import sys
import tempfile
from collections.abc import Callable, Iterable, Mapping, Sequence
from contextlib import suppress
from functools import cache, cached_property, partial
from pathlib import Path
from typing import Any

import casadi as ca

from hertzwerk.runtime.engine.integration.loop.c_files import OFTEN, SELDOM, CFile, c_files, fused, looped
from hertzwerk.runtime.system import cache as disk
from hertzwerk.runtime.system.atomic_files import scratch_folder
from hertzwerk.runtime.system.forked_tasks import cores
from hertzwerk.runtime.system.interrupt import raise_interrupts

GCC_ALONE = "-fno-tree-pre", "-fno-code-hoisting"  # one pass in GCC, a tenth of its time; clang refuses the first
FLAGS = (
    *("-march=native", "-ffp-contract=off", "-fno-math-errno", "-fno-trapping-math"),
    *("-fno-gcse", "-fno-gcse-after-reload", *GCC_ALONE),  # find nothing in such text, in a quarter of the time
    *("-ftree-vectorize", "-fvect-cost-model"),  # loops over pairs, at any level: 12 balls run 1.5 times as fast
    "-fno-tree-slp-vectorize",  # GCC 12 makes of a sum beside a difference one fused instruction all the same
    *("-fno-semantic-interposition", "-fPIC", "-w"),  # the first lets CasADi's small functions be inlined
)
FUSED = "-ffp-contract=fast"
# a symbol that is nowhere is an error of the linker, not the end of the process that calls it
DEFINED = () if sys.platform in ("darwin", "win32") else ("-Wl,-z,defs",)
# a loop over the entries of CasADi's vectors, which are one or apart
LOOP, EACH = "\n  for (i=0, rr=", "\n  EACH (i=0, rr="
INDEPENDENT = '#define EACH _Pragma("GCC ivdep") for\n'
PATIENCE = 0.1  # s between two polls
_OPERATION = re.compile(r"^ +/\* #\d+: .* \*/\n", re.MULTILINE)  # CasADi's comment on an operation of a graph
# s of the processor: within 2 of what 10 programs of 1 to 300 pairs took; a loop takes as long as 130 characters
BEGIN_S, PER_CHARACTER_S = 0.1, {OFTEN: 17e-6, SELDOM: 9e-6}
PER_LOOP_S = {OFTEN: 2.2e-3, SELDOM: 0.8e-3}


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
        self._files = c_files(c_text(functions))
        flags = (*FLAGS, *(() if bitwise else (FUSED,)))
        self._flags = tuple(flag for flag in flags if flag not in GCC_ALONE or "clang" not in _version(self._compiler))
        texts = (part for file in self._files for part in (file.text, file.level))
        parts = (*texts, *self._compiler, _version(self._compiler), *self._flags, _processor())
        digest = hashlib.sha256("\0".join(parts).encode()).hexdigest()
        self._key = f"compiled-{digest[:32]}"
        self._library = disk.entry(self._key, ".so")

    @property
    def seconds(self) -> float:
        """Estimated time [s] to compile; 0 if the library is there already."""
        return 0.0 if self._library is not None else self._estimate

    @cached_property
    def _estimate(self) -> float:
        return compile_seconds(self._files)

    def load(self, poll: Callable[[], object] = lambda: None) -> list[Any]:
        """Return the compiled functions, compiled now if need be.

        poll: called now and then. Raises NoCompilerError, and what `poll` raises.
        """
        if self._library is not None:
            return self._loaded(self._library)
        try:
            with raise_interrupts(), scratch_folder(Path(tempfile.gettempdir())) as folder:
                sources = {folder / f"chunk{i}.c": file for i, file in enumerate(self._files)}
                for source, file in sources.items():
                    source.write_text(file.text, encoding="utf-8")
                levels = {source: file.level for source, file in sources.items()}
                made = compile_files(self._flags, levels, folder / "chunk.so", poll)
                self._library = disk.keep(self._key, ".so", made.read_bytes())
                return self._loaded(self._library or made)  # what is loaded needs no file any more
        except OSError as error:
            raise NoCompilerError(f"nothing can be compiled: {error}") from error

    def _loaded(self, library: Path) -> list[Any]:
        return [ca.external(function.name(), str(library)) for function in self._functions]


def compile_seconds(files: Sequence[CFile]) -> float:
    """Return the estimated time [s] to compile files side by side."""
    times = [
        BEGIN_S
        + PER_CHARACTER_S[file.level] * len(file.text)
        + PER_LOOP_S[file.level] * (file.text.count("for (") + file.text.count("EACH ("))
        for file in files
    ]
    return max([*times, sum(times) / cores()])


def require_compiler() -> None:
    """Raise NoCompilerError where there is no C compiler."""
    _compiler()


def available() -> bool:
    """Return whether there is a C compiler."""
    try:
        require_compiler()
    except NoCompilerError:
        return False
    return True


def c_text(functions: Iterable[Any], name: str = "hertzwerk_chunk") -> str:
    """Return the C text of CasADi functions, whose inner names begin with a name."""
    generator = ca.CodeGenerator(f"{name}.c", {"with_header": False})
    functions = list(functions)
    for function in functions:
        generator.add(getattr(function, "one", function))
    text = _OPERATION.sub("", generator.dump())
    for chunk in functions:
        if hasattr(chunk, "one"):
            text = looped(text, chunk)
    # what the library's functions give, in line: a call costs as much as ten operations
    for name, order in (("fmin", "<"), ("fmax", ">")):
        text = text.replace(f"return {name}(x, y);", f"return x {order} y || y != y ? x : y;")
    return INDEPENDENT + fused(text).replace(LOOP, EACH)


def compile_files(
    flags: tuple[str, ...], levels: Mapping[Path, str], target: Path, poll: Callable[[], object] = lambda: None
) -> Path:
    """Compile C files, each at its level, side by side, and link them to a library.

    Raises NoCompilerError, OSError, and what `poll` raises.
    """
    objects = [source.with_suffix(".o") for source in levels]
    compiler = _compiler()
    _run(
        [
            [*compiler, level, *flags, "-c", "-o", str(made), str(source)]
            for made, (source, level) in zip(objects, levels.items(), strict=True)
        ],
        poll,
    )
    command = [*compiler, "-shared", *DEFINED, "-o", str(target), *map(str, objects), "-lm"]
    _run([command], poll)
    if not target.is_file():
        raise BrokenCompilerError(f"{shlex.join(command)} makes no library")
    return target


def _run(commands: Sequence[Sequence[str]], poll: Callable[[], object]) -> None:
    """Run commands side by side, one on each core.

    All are killed with their children where one fails, which raises BrokenCompilerError, or where `poll`, called
    meanwhile, raises.
    """
    group = 0 if os.name == "posix" else None  # a compiler has children
    start = partial(subprocess.Popen, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True, process_group=group)
    waiting, running = list(commands), dict[subprocess.Popen[str], Sequence[str]]()
    try:
        while waiting or running:
            while waiting and len(running) < cores():
                command = waiting.pop(0)
                running[start(command)] = command
            for process, command in running.items():
                with suppress(subprocess.TimeoutExpired):
                    _, said = process.communicate(timeout=PATIENCE / len(running))
                    if process.returncode:
                        raise BrokenCompilerError(f"{shlex.join(command)} failed:\n{said.strip()[:2000]}")
            running = {process: command for process, command in running.items() if process.returncode is None}
            poll()
    except BaseException:
        for process in running:
            with process, suppress(ProcessLookupError):
                (process.kill if group is None else partial(os.killpg, process.pid, signal.SIGKILL))()
        raise


@cache
def _compiler() -> tuple[str, ...]:
    """Return the command of the C compiler: $CC with its options, else cc, gcc, clang.

    Raises NoCompilerError.
    """
    command = os.environ.get("CC", "").strip()
    if command:
        try:
            name, *options = shlex.split(command)
        except ValueError as error:
            raise BrokenCompilerError(f"CC={command!r} is no command: {error}") from error
        path = shutil.which(name)
        if path is None:
            raise BrokenCompilerError(f"CC={command!r} names no program that can be run")
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
