"""Equations of a scene as SymPy's users have them: M du/dt = forcing, q' = rates, with dynamicsymbols.

They are the program's own, before they are solved. A contact's forces are functions of time, along its normal and
tangents, since its laws with their memory are no part of such equations.
"""

from __future__ import annotations

import keyword
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from types import MappingProxyType
from typing import Any

import sympy as sp
from sympy.physics.mechanics import dynamicsymbols
from sympy.printing.str import StrPrinter

from hertzwerk.derive.common.faults import Fault, refuse
from hertzwerk.derive.declare.scene.scene import Scene, require_scene
from hertzwerk.derive.equations.module.equation_system import System
from hertzwerk.derive.equations.motion.absolute_coordinates import absolute
from hertzwerk.derive.equations.motion.constraints import ON_SPEED
from hertzwerk.derive.expressions.algebra.functions import Where, with_pieces
from hertzwerk.derive.expressions.algebra.vectors import scale
from hertzwerk.derive.expressions.dimension.dimension import Dimension
from hertzwerk.derive.expressions.parameter import Parameter
from hertzwerk.derive.program.program import symbols_in

TIME = dynamicsymbols._t  # SymPy's own symbol of time
KNOWN = (sp.Add, sp.Mul, sp.Pow, sp.sin, sp.cos, sp.tan, sp.atan, sp.atan2, sp.asin, sp.acos, sp.exp, sp.log, sp.Abs,
         sp.tanh, sp.sinh, sp.cosh, sp.sign, sp.Max, sp.Min, sp.Piecewise, Where)  # fmt: skip


@dataclass(frozen=True, eq=False)
class SymPyEquations:
    """Equations mass_matrix u' = forcing + G^T multipliers, and q' = kinematics, as SymPy's matrices.

    specified  function of time that is neither coordinate nor speed -> what it is: forces of contacts, inputs
    names      name of a coordinate or a speed in the scene -> its function of time
    steps      the equations as a straight-line program, which a file of them writes
    """

    q: sp.Matrix
    u: sp.Matrix
    kinematics: Mapping[Any, Any]
    mass_matrix: sp.Matrix
    forcing: sp.Matrix
    holonomic_constraints: sp.Matrix
    nonholonomic_constraints: sp.Matrix
    specified: Mapping[Any, str]
    units: dict[Any, str]
    values: Mapping[Any, float]
    names: Mapping[str, Any]
    program: Straight = field(repr=False)

    def kindiffdict(self) -> dict[Any, Any]:
        """Derivatives of the coordinates, as a KanesMethod states them."""
        return dict(self.kinematics)


@dataclass(frozen=True, eq=False)
class Straight:
    """Equations before what they share is written out: assignments in order, and results by name."""

    steps: tuple[tuple[sp.Symbol, Any], ...]
    results: Mapping[str, Any]
    instead: Mapping[sp.Symbol, Any]
    """Symbol of an input -> its symbol or function of time."""


def to_sympy(scene: Scene) -> SymPyEquations:
    """Equations of a scene as SymPy matrices.

    Raises InputError, with every fault, for what has no such form.
    """
    require_scene(scene)
    export = _Export(System(absolute(scene) if scene.coordinates == "absolute" else scene))
    return export.equations()


class _Export:
    """Equations of one system."""

    def __init__(self, system: System) -> None:
        self.system, self.tape, self.scene = system, system.tape, system.scene
        refuse(f"scene {self.scene.name} to SymPy", list(self._faults()))
        self.specified: dict[sp.Symbol, str] = {}

    def _faults(self) -> Iterator[Fault]:
        """Yield faults of what SymPy's equations do not have."""
        system = self.system
        if system.carried is not None:
            yield Fault(
                "effects", "loads by reactions or normal forces", "loads of time, coordinates, speeds and inputs"
            )
        for name in (*(state.port.name for state in system.kin.drive_states), *self.scene.states):
            yield Fault(f"state {name}", "a state that is no coordinate", "coordinates alone",
                        "Omit the effect or the drive that integrates it.")  # fmt: skip

    def equations(self) -> SymPyEquations:
        """The record."""
        system, equations = self.system, self.system.equations
        free = equations.free
        mass = equations.mass_matrix()
        matrix = [[mass.get((row.key, other.key), sp.S.Zero) for other in free] for row in free]
        contacts = self._contacts()
        forcing = [
            equations.gravity(row)
            + system.force(row.key, carried=False)
            - equations.bias(row)
            + contacts.get(row.key, sp.S.Zero)
            for row in free
        ]
        on_places = [loop.value for loop in system.loops if loop.unit != ON_SPEED and loop.value != 0]
        on_speeds = [loop.rate for loop in system.loops if loop.unit == ON_SPEED or loop.value == 0]
        results = {
            "mass_matrix": matrix, "forcing": forcing, "kinematics": list(system.kin.rates), "holonomic_constraints": on_places,
            "nonholonomic_constraints": on_speeds,
        }  # fmt: skip
        steps = self.tape.needed(_flat(results))
        program = Straight(steps, results, self._instead([*_flat(results), *(e for _, e in steps)]))
        return self._written_out(program)

    def _contacts(self) -> dict[str, Any]:
        """Generalised forces of the contacts, each force a function of time."""
        forces: dict[str, Any] = {}
        for pair, _, friction in self.system.contacts:
            name, touch = pair.pair.name, pair.touch
            ways = [("normal_force", touch.normal, touch.position)]
            if friction is not None:
                tangents = touch.tangents
                numbers = [""] if len(tangents) == 1 else [f"_{i}" for i, _ in enumerate(tangents, 1)]
                ways += [
                    (f"friction_force{i}", way, touch.contact_point) for i, way in zip(numbers, tangents, strict=True)
                ]
            for label, way, place in ways:
                force = self.tape.input(f"{name}_{label}", "exported", Dimension.from_unit("N"))
                self.specified[force] = f"{label.replace('_', ' ')} of {name} on {touch.first.body.name}"
                pushed = self.system.kin.generalised(
                    scale(force, way), place, touch.first.body, touch.second.body, f"{name}_{label}"
                )
                for row, share in pushed.items():
                    forces[row] = forces.get(row, sp.S.Zero) + share
        return forces

    def _instead(self, expressions: list[Any]) -> dict[sp.Symbol, Any]:
        """Functions of time for coordinates, speeds, forces and inputs; symbols for parameters in use."""
        kin = self.system.kin
        instead: dict[sp.Symbol, Any] = {kin.t: TIME}
        moving = [*kin.q, *kin.u, *self.specified]
        for name, value in kin.inputs.items():
            self.specified[value] = f"input {name}"
            moving.append(value)
        instead |= {symbol: dynamicsymbols(symbol.name) for symbol in moving if isinstance(symbol, sp.Symbol)}
        return instead | {p: sp.Symbol(p.name) for p in symbols_in(*expressions) if isinstance(p, Parameter)}

    def _written_out(self, program: Straight) -> SymPyEquations:
        system, kin, instead = self.system, self.system.kin, dict(program.instead)
        inputs = set(kin.inputs.values())
        faults: list[Fault] = []
        for symbol, expression in program.steps:
            if symbol in inputs:
                continue
            strange = _strange(expression)
            if strange is not None:
                faults.append(
                    Fault(f"expression {symbol}", strange, "functions that SymPy has", "Tables and curves have none.")
                )
            instead[symbol] = with_pieces(expression).xreplace(instead)
        refuse(f"scene {self.scene.name} to SymPy", faults)

        def written(value: Any) -> Any:
            return with_pieces(sp.sympify(value)).xreplace(instead)

        r = program.results
        q, u = [instead[s] for s in kin.q], [instead[s] for s in kin.u]
        rates = {a.diff(TIME): written(rate) for a, rate in zip(q, r["kinematics"], strict=True)}
        ports = [*zip(q, system.coordinates, strict=True), *zip(u, system.speeds, strict=True)]
        units = {symbol: port.unit for symbol, port in ports}
        constants = [p for p in instead if isinstance(p, Parameter)]
        units |= {instead[p]: p.unit for p in constants}
        units |= {instead[s]: "N" for s in self.specified if s not in inputs}
        units |= {instead[value]: self.scene.inputs[name].unit for name, value in kin.inputs.items()}
        return SymPyEquations(
            sp.Matrix(q), sp.Matrix(u), rates, sp.Matrix([[written(v) for v in row] for row in r["mass_matrix"]]),
            sp.Matrix([written(v) for v in r["forcing"]]), sp.Matrix([written(v) for v in r["holonomic_constraints"]]),
            sp.Matrix([written(v) for v in r["nonholonomic_constraints"]]), {instead[s]: meaning for s, meaning in self.specified.items()},
            units, {instead[p]: p.default for p in constants},
            {port.name: symbol for symbol, port in ports}, program,
        )  # fmt: skip


def _flat(value: Any) -> list[Any]:
    if isinstance(value, Mapping):
        return [e for part in value.values() for e in _flat(part)]
    return [e for part in value for e in _flat(part)] if isinstance(value, list) else [value]


def _strange(expression: Any) -> str | None:
    """A function that SymPy does not have, in an expression."""
    nodes = (node for node in sp.preorder_traversal(expression) if node.args and not isinstance(node, KNOWN))
    return next((type(node).__name__ for node in nodes if not (node.is_Relational or node.is_Boolean)), None)


# -- file of Python that makes the equations when it is imported -------------------------------------------------------

TAKEN = {"sp", "dynamicsymbols", "t", "q", "u", "kinematics", "mass_matrix", "forcing", "holonomic_constraints",
         "nonholonomic_constraints", "specified", "units", "values", "names"}  # fmt: skip
"""Names of the file itself."""


class _Printer(StrPrinter):  # type: ignore[misc]  # SymPy is untyped
    """Printer of Python that builds the expression again, exactly."""

    def __init__(self, variables: Mapping[sp.Symbol, str]) -> None:
        super().__init__()
        self.variables = variables

    def _print_Function(self, node: Any) -> str:
        return f"sp.{node.func.__name__}({', '.join(map(self._print, node.args))})"

    _print_Abs = _print_Max = _print_Min = _print_Piecewise = _print_Function

    def _print_ExprCondPair(self, node: Any) -> str:
        return f"({self._print(node.expr)}, {self._print(node.cond)})"

    def _print_Rational(self, node: Any) -> str:
        return f"sp.Rational({node.p}, {node.q})"

    def _print_Float(self, node: Any) -> str:
        return f"sp.Float({float(node)!r})"

    def _print_Pi(self, _: Any) -> str:
        return "sp.pi"

    def _print_Exp1(self, _: Any) -> str:
        return "sp.E"

    def _print_Symbol(self, node: Any) -> str:
        return self.variables.get(node, _variable(node.name))

    def _print_Pow(self, node: Any, rational: bool = False) -> str:
        base, exponent = (f"({self._print(part)})" for part in (node.base, node.exp))
        return f"{base}**{exponent}"


def _variable(name: str) -> str:
    return f"{name}_" if name in TAKEN or keyword.iskeyword(name) else name


FILE = '''"""Equations of {name} for SymPy, written by hertzwerk: mass_matrix u' = forcing, q' = kinematics.
{multipliers}
Units of every symbol are in `units`, defaults of constants in `values`; `specified` are functions of time, as forces of contacts.
"""

import sympy as sp
from sympy.physics.mechanics import dynamicsymbols

t = dynamicsymbols._t
{symbols}
{steps}
q = sp.Matrix([{q}])
u = sp.Matrix([{u}])
kinematics = {{{kinematics}}}
mass_matrix = sp.Matrix([{mass_matrix}])
forcing = sp.Matrix([{forcing}])
holonomic_constraints = sp.Matrix([{holonomic_constraints}])
nonholonomic_constraints = sp.Matrix([{nonholonomic_constraints}])
specified = {{{specified}}}
units = {{{units}}}
values = {{{values}}}
names = {{{names}}}
'''
MULTIPLIERS = "\nForces of the constraints, of the multipliers, come on top of the forcing."


def python_file(
    equations: SymPyEquations, name: str, values: Mapping[str, tuple[float, str]] = MappingProxyType({})
) -> str:
    """Text of the file; `values` with their units stand in place of the parameters' defaults."""
    program = equations.program
    variables = {s: "t" if a == TIME else _variable(s.name) for s, a in program.instead.items()}
    named = {a: variables[s] for s, a in program.instead.items()}
    text = _Printer(variables).doprint

    def of(value: Any) -> str:
        return str(text(with_pieces(sp.sympify(value))))

    stated = {a: values.get(a.name, (value, equations.units[a])) for a, value in equations.values.items()}
    units = equations.units | {a: unit for a, (_, unit) in stated.items()}
    symbols = [
        f'{named[a]} = dynamicsymbols("{a.func.__name__}")\n' if a.args else f'{named[a]} = sp.Symbol("{a.name}")\n'
        for a in program.instead.values()
        if a != TIME
    ]
    steps = [f"{_variable(symbol.name)} = {of(e)}\n" for symbol, e in program.steps if symbol not in variables]
    pairs = zip(equations.q, program.results["kinematics"], strict=True)
    parts: dict[str, Iterable[str]] = {
        "q": (named[a] for a in equations.q),
        "u": (named[a] for a in equations.u),
        "kinematics": (f"{named[a]}.diff(t): {of(rate)}" for a, rate in pairs),
        "mass_matrix": (f"[{', '.join(map(of, row))}]" for row in program.results["mass_matrix"]),
        **{
            part: map(of, program.results[part])
            for part in ("forcing", "holonomic_constraints", "nonholonomic_constraints")
        },
        "specified": (f"{named[a]}: {meaning!r}" for a, meaning in equations.specified.items()),
        "units": (f"{named[a]}: {unit!r}" for a, unit in units.items()),
        "values": (f"{named[a]}: {value!r}" for a, (value, _) in stated.items()),
        "names": (f"{label!r}: {named[a]}" for label, a in equations.names.items()),
    }
    constrained = equations.holonomic_constraints or equations.nonholonomic_constraints
    return FILE.format(
        name=name, multipliers=MULTIPLIERS if constrained else "", symbols="".join(symbols), steps="".join(steps),
        **{part: ", ".join(texts) for part, texts in parts.items()},
    )  # fmt: skip
