"""Compilation when it pays: a run starts in CasADi's virtual machine and continues as C.

The change is made once the estimated time saved exceeds the compilation; results are bitwise the same.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from contextlib import suppress
from dataclasses import dataclass
from typing import TYPE_CHECKING, Any

import numpy as np

from hertzwerk.runtime.engine.model.caller import Callers, Rowwise
from hertzwerk.runtime.system.lazy import cached_property

if TYPE_CHECKING:
    from hertzwerk.runtime.engine.integration.loop.c_compilation import Program

LOOK = 0.15  # s left from which it pays to write the C text and look for its library, which takes 0.01 to 0.06 s
SURE = 0.1  # part of the compilation's time that must have been run for the pace to be reliable
GAIN = 0.8  # part of the time left that C saves


@dataclass
class Code:
    """Chunk function of one model and method, in CasADi's virtual machine and, on demand, as C.

    build: builds the function; with_choice: the code that chooses between methods; bitwise: whether C gives the machine's results to
    the bit; callers: of a function
    """

    build: Callable[[], Any]
    with_choice: Callable[[], Code] | None = None
    bitwise: bool = True
    callers: Callable[[Any], Callers] = Callers
    native: Callers | None = None
    _chosen: Code | None = None
    _program: Program | None = None
    _impossible: bool = False
    compiler_failure: str = ""
    """Reason why a compiler that was found could not be used."""

    @cached_property
    def function(self) -> Any:
        """The function, built on first use."""
        return self.build()

    @cached_property
    def machine(self) -> Callers:
        """Callers in CasADi's virtual machine."""
        return self.callers(self.function)

    def choosing(self) -> Code | None:
        """Return the code that chooses between methods, built on first use; None where there is none."""
        if self._chosen is None and self.with_choice is not None:
            self._chosen = self.with_choice()
        return self._chosen

    @property
    def built(self) -> list[Code]:
        """Return itself, and the code that chooses between methods if it is built."""
        return [self] if self._chosen is None else [self, self._chosen]

    def compile(self, poll: Callable[[], object] = lambda: None) -> Callers:
        """Return callers of the C version, compiled now if need be.

        poll: called meanwhile. Raises NoCompilerError, and what `poll` raises.
        """
        if self.native is None:
            self.native = self.callers(*self._made().load(poll))
        return self.native

    def compiled_if_faster(
        self, elapsed: float, ahead: float, poll: Callable[[], object] = lambda: None
    ) -> Callers | None:
        """Return callers of the C version if compiling now saves time; else None.

        elapsed, ahead: time [s] the run took so far and would take uncompiled.
        """
        if self.native is not None:
            return self.native
        if ahead < LOOK or self._impossible:
            return None
        from hertzwerk.runtime.engine.integration.loop.c_compilation import BrokenCompilerError, NoCompilerError

        try:
            needed = self._made().seconds
            return self.compile(poll) if GAIN * ahead > needed and elapsed >= SURE * needed else None
        except NoCompilerError as error:
            self._impossible = True
            self.compiler_failure = str(error) if isinstance(error, BrokenCompilerError) else ""
            return None

    def _made(self) -> Program:
        """Return the C program; raises NoCompilerError."""
        from hertzwerk.runtime.engine.integration.loop.c_compilation import (
            Program,  # only now: a short run needs none of what it imports
        )

        self._program = self._program or Program(self.function, bitwise=self.bitwise)
        return self._program


class AutomaticCallers:
    """Callers of a run's chunks; with `changes` they change to C by themselves.

    compile_s, build_s: time taken to compile, and to build the code that chooses between methods [s].
    """

    watches = False
    """Whether `enter` may change callers after each chunk."""

    def __init__(self, code: Code, *, compiled: bool, changes: bool) -> None:
        self._first, self._compiled, self._changes = code, compiled, changes
        self.compile_s = self.build_s = 0.0
        self.begin()

    def begin(self) -> None:
        """Start a run: `callers` are those of its first steps."""
        self._use(self._first)

    def _take(self, code: Code, poll: Callable[[], object]) -> None:
        """Change `callers` to those of a code, compiled if all are."""
        if self._compiled:
            began = time.perf_counter()
            try:
                code.compile(poll)
            finally:
                self.compile_s += time.perf_counter() - began
        self._use(code)

    def use_choice(self, poll: Callable[[], object]) -> None:
        """Change `callers` to those that choose between methods."""
        began = time.perf_counter()
        code = self._first.choosing()
        self.build_s += time.perf_counter() - began
        if code is not None:
            self._take(code, poll)

    def _use(self, code: Code) -> None:
        self._code = code
        either = self._compiled or self._changes
        self.callers = code.native if code.native is not None and either else code.machine

    def enter(self, state: np.ndarray, controls: np.ndarray, poll: Callable[[], object], *, first: bool) -> np.ndarray:
        """Return the state to go on with; see `CallerProvider`."""
        return state

    @property
    def compiled(self) -> bool:
        """Return whether the callers run C code."""
        return self.callers is not self._code.machine

    @property
    def may_switch(self) -> bool:
        """Return whether `switch_if_faster` may change `callers` in a run."""
        return self._changes

    def switch_if_faster(self, elapsed: float, ahead: float, poll: Callable[[], object]) -> bool:
        """Change `callers` to C if that pays; return whether it did."""
        if not self._changes or self.compiled or ahead < LOOK:
            return False
        began = time.perf_counter()
        try:
            better = self._code.compiled_if_faster(elapsed, ahead, poll)
        finally:  # also where the time is over
            self.compile_s += time.perf_counter() - began
        if better is None:
            return False
        self.callers = better
        return True


def compiled_together(functions: Sequence[Any]) -> list[Any]:
    """Return functions compiled as one program; none where that fails."""
    from hertzwerk.runtime.engine.integration.loop.c_compilation import NoCompilerError, Program

    with suppress(NoCompilerError):
        return Program(*functions).load() if functions else []
    return []


def use_compiled(tables: list[Rowwise]) -> None:
    """Compile functions of tables; where that fails they stay slower, with the same results."""
    left = [table for table in tables if not table.compiled]
    native = compiled_together([function for table in left for function in table.functions])
    for table in left if native else ():
        table.use([native.pop(0) for _ in table.functions])
