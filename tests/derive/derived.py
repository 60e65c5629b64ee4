"""The generated module of a scene, executed, and its functions called with plain numbers: what the tests of derivation look at."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import casadi as ca
import numpy as np

from hertzwerk.derive import Scene, generate
from hertzwerk.derive.common.units import parse_unit
from hertzwerk.derive.program.program import OWN


class Derived:
    """Text and functions of one scene; parameters at their defaults unless `values` (SI) says otherwise.

    `call("contact_pin", t=.., q=.., u=.., z=.., m=.., f=.., a=..)` gives the function's results as NumPy vectors.
    """

    def __init__(self, scene: Scene | None = None, *, text: str = "", values: dict[str, float] | None = None) -> None:
        self.scene = scene
        self.text = text or generate(scene)
        self.names: dict[str, Any] = {}
        self._jacobians: dict[tuple[Any, ...], Any] = {}
        exec(compile(self.text, "<generated>", "exec"), self.names)
        defaults = {name: parse_unit(unit).to_si(default) for name, unit, default, _ in self.PARAMETERS}
        self.p = np.array([{**defaults, **(values or {})}[name] for name in defaults])
        self.c = _vector(self.names["constants"](ca.DM(self.p)))

    def __getattr__(self, name: str) -> Any:
        try:
            return self.names[name]
        except KeyError:
            raise AttributeError(name) from None

    @property
    def nu(self) -> int:
        return len(self.SPEEDS)

    @property
    def nq(self) -> int:
        return len(self.COORDINATES)

    @property
    def k(self) -> int:
        return len(self.PAIRS)

    def arguments(self, function: str) -> tuple[str, ...]:
        code = self.names[function].__code__
        short = {words: name for name, words in OWN.items()}  # where a parameter has the short name
        return tuple(short.get(name.removesuffix("_2"), name) for name in code.co_varnames[: code.co_argcount])

    def results(self, function: str, given: dict[str, Any]) -> tuple[Any, ...]:
        """The function's results on CasADi values; memory and parameters that are not given are zero and the defaults."""
        known = {"p": self.p, "c": self.c, "t": 0.0, "z": np.zeros(len(self.MEMORY)), **given}
        out = self.names[function](*(_casadi(known[name]) for name in self.arguments(function)))
        return out if isinstance(out, tuple) else (out,)

    def call(self, function: str, **given: Any) -> Any:
        """One vector, or a list of vectors, of numbers."""
        out = [_vector(value) for value in self.results(function, given)]
        return out[0] if len(out) == 1 else out

    def start(self) -> tuple[np.ndarray, np.ndarray]:
        q, u = self.call("start")
        return q, u

    def jacobian(self, function: str, which: str, result: int = 0, **given: Any) -> np.ndarray:
        """Derivative of a result by one argument (`t`, `q`, `u`, ...), at numbers."""
        at = {name: np.atleast_1d(np.asarray(value, float)) for name, value in given.items()}
        known = function, which, result, *((name, value.size) for name, value in at.items())
        if known not in self._jacobians:
            symbols = {name: ca.SX.sym(name, value.size) for name, value in at.items()}
            value = ca.SX(self.results(function, symbols)[result])
            self._jacobians[known] = ca.Function("J", [*symbols.values()], [ca.jacobian(value, symbols[which])])
        return self._jacobians[known](*at.values()).full()

    def with_gap(self, t: float, q: Sequence[float], pair: int, target: float) -> np.ndarray:
        """Coordinates near q at which the gap of `pair` is `target`: Newton's steps of least length, from elsewhere if that fails."""
        rng = np.random.default_rng(0)
        x, zero = ca.SX.sym("q", self.nq), np.zeros(self.nu)
        gap = ca.SX(self.results("gaps", {"t": t, "q": x, "u": zero})[0])[pair]
        function = ca.Function("gap", [x], [gap, ca.jacobian(gap, x)])
        for start in (np.array(q, float), *(q + rng.uniform(-1, 1, (50, self.nq)) * 10 ** rng.uniform(-4, 0, (50, 1)))):
            at = start
            for _ in range(80):
                at = self.of_norm_one(at)
                value, slope = (out.full().reshape(-1) for out in function(at))
                for i in self.QUATERNIONS:
                    slope[i : i + 4] -= (slope[i : i + 4] @ at[i : i + 4]) * at[i : i + 4]
                if abs(value[0] - target) <= 1e-9 * abs(target):
                    return at
                if not slope.any():  # a gap that stands still leads nowhere
                    break
                at = at - (value[0] - target) * slope / (slope @ slope)
        raise AssertionError(f"no coordinates with gap {target} found")

    def of_norm_one(self, q: Sequence[float]) -> np.ndarray:
        """Coordinates with their quaternions normalised."""
        q = np.array(q, float)
        for i in self.QUATERNIONS:
            q[i : i + 4] /= np.linalg.norm(q[i : i + 4])
        return q


def rate_along(derived, function, result, t, q, u, a):
    """d/dt of a result along the motion, by CasADi's derivatives."""
    options = {"t": t, "q": q, "u": u}
    dq = derived.call("coordinate_rates", **options)
    return (
        derived.jacobian(function, "t", result, **options)[:, 0]
        + derived.jacobian(function, "q", result, **options) @ dq
        + derived.jacobian(function, "u", result, **options) @ a
    )


def energy_balance(derived, t, q, u, extra, power_of_extra, dz=None):
    """What is left of d(kinetic + potential + stored)/dt + dissipated - input - power of extra forces, over the sum of what cancels in it.

    Of the energy's rate that is each derivative times the rate of its argument: the accelerations' share is large where bodies are light.
    """
    options = {"t": t, "q": q, "u": u}
    f = derived.call("applied", **options) + extra
    a, reactions = derived.call("accelerations", **options, f=f)
    moving = {"t": np.ones(1), "q": derived.call("coordinate_rates", **options), "u": a}
    parts = [derived.jacobian("energy", x, k, **options) * rate for k in range(3) for x, rate in moving.items()]
    supplied = derived.call("ledger", **options, reactions=reactions)
    terms = np.concatenate([*map(np.ravel, parts), -supplied, [] if dz is None else dz, [-power_of_extra]])
    return abs(np.sum(terms)) / np.sum(np.abs(terms))


def _casadi(value: Any) -> Any:
    return value if isinstance(value, ca.SX | ca.MX | ca.DM) else ca.DM(np.asarray(value, float))


def _vector(value: Any) -> np.ndarray:
    return np.array(ca.DM(value).full()).reshape(-1)
