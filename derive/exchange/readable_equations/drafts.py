"""Select the results of a program that are shown, with the section, name and meaning of each equation."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from itertools import chain
from typing import Any

import sympy as sp

from hertzwerk.derive.declare.effects.couplings import Coupling
from hertzwerk.derive.declare.effects.effect import Effect
from hertzwerk.derive.declare.effects.nonholonomic import KnifeEdge, RollingWithoutSlip
from hertzwerk.derive.exchange.readable_equations.symbols import Names, contact_title, words
from hertzwerk.derive.expressions.algebra.functions import Where
from hertzwerk.derive.program.program import Function, Program, Result, symbols_in

HIDDEN = ("constants", "scales", "gap_accelerations", "accelerations", "loads", "settling", "unloaded", "rubbing", "balance", "projection",
           "poses", "motion", "applied", "joint_scales", "placed", "joint_constraints", "landmarks", "rolling_limits")  # fmt: skip
KINEMATICS, MOTION, LEDGER, ENERGY = "Kinematics", "Equations of motion", "Energy ledger", "Energy"
LOOPS, COUPLINGS, ROLLING, OUTPUTS, START = "Closed loops", "Couplings", "Rolling and edges", "Outputs", "Start"
INERTIA, BIAS = "inertia", "bias"
_RATE = r"\frac{\mathrm{d}}{\mathrm{d}t}"


@dataclass
class Part:
    """One term of an equation of motion.

    `factor` is the acceleration that an inertia multiplies; `source` the function of the program that gives a force.
    """

    left: bool
    meaning: str
    expression: Any
    factor: Any = None
    source: str = ""
    effect: str = ""


@dataclass
class Draft:
    """An equation before numbering: `name` = `expression`, or the parts of an equation of motion.

    `symbol` is the symbol it defines; `left` the LaTeX of its left-hand side where it defines none.
    """

    section: str
    name: str
    unit: str
    meaning: str
    expression: Any = None
    symbol: Any = None
    left: str = ""
    parts: list[Part] = field(default_factory=list)
    effects: tuple[str, ...] = ()

    def expressions(self) -> list[Any]:
        """List the expressions of its right-hand side, or of its parts."""
        return [*([] if self.expression is None else [self.expression]), *(part.expression for part in self.parts)]

    def symbols(self) -> list[sp.Symbol]:
        """List the symbols of its right-hand side, or of its parts."""
        factors = [part.factor for part in self.parts if part.factor is not None]
        return list(dict.fromkeys([*(s for e in self.expressions() for s in symbols_in(e)), *factors]))


class Drafts:
    """Drafts of all equations of a program, in the order of its functions.

    `added` are the symbols introduced for results that have no symbol in the program.
    """

    def __init__(self, program: Program, names: Names) -> None:
        self._program, self._names, self._tape = program, names, program.tape
        self._effects = {effect.name: effect for effect in program.scene.effects}
        self._on_speeds = [name for name, unit in program.tables["CONSTRAINTS"] if unit == "m/s"]
        self.added: dict[sp.Symbol, Any] = {}

    def all(self) -> list[Draft]:
        """Equations of motion, then the results of every other function that is not listed in `HIDDEN`."""
        drafts = [*self._rows()]
        for function in self._program.functions:
            if function.name in HIDDEN:
                continue
            for result in function.results:
                if pair_of(function.name) and result.name == "dz_along":
                    drafts.extend(self._friction_power(pair_of(function.name), result))
                    continue
                for label, unit, expression in zip(result.labels, result.units, result.expressions, strict=True):
                    drafts.extend(self._result(function, result.name, label, unit, sp.sympify(expression)))
        once = {draft.symbol if draft.symbol is not None else (draft.section, draft.name): draft for draft in drafts}
        return list(once.values())

    def _result(self, function: Function, result: str, label: str, unit: str, expression: Any) -> Iterator[Draft]:
        pair = pair_of(function.name)
        if pair and result in ("f", "along"):
            return  # shown in the equations of motion
        if pair and result == "holding_force":
            yield from self._friction_with_modes(pair, function, label, expression)
        if pair and label in self._effects and label != pair and result != "dz":
            return  # limits and velocities of turning, which its moments show
        if result == "dz":
            if expression != 0:
                yield self._rate_of_memory(pair, label, unit, expression)
        elif pair or function.name == "gaps":
            if not expression.is_number:  # a law without a limited range
                quantity = {"G": "gap", "dG": "gap_rate"}.get(result, result)
                whose = pair or label
                name = f"{whose}_{quantity}" if label == whose else f"{whose}_{quantity}_{label.replace('.', '_')}"
                yield self._definition(contact_title(whose), name, unit, expression)
        elif function.name == "energy" and result == "stored" and expression in self._tape.assignments:
            yield self._definition(contact_title(label), expression.name, unit, expression)
        elif function.name == "energy":
            short = {"kinetic": r"\mathrm{kin}", "potential": r"\mathrm{pot}"}.get(label, words((result, label)))
            yield Draft(ENERGY, label, unit, f"{label} energy", expression, left=f"E_{{{short}}}")
        elif function.name == "start":
            by_bodies = self._program.tables["JOINT_COORDINATES"] is not None  # starts are given by the joints
            latex = _label(label) if by_bodies else self._names.port(*self._port(result, label))
            text = f"{label} at the start"
            yield Draft(START, text, unit, text, expression, left=rf"{{{latex}}}|_{{t=0}}")
        elif function.name == "outputs":
            if self._tape.inputs.get(expression) == "input":
                return  # a history, and no equation
            yield Draft(OUTPUTS, label, unit, label, expression, left=_label(label))
        elif function.name == "constraints":
            yield from self._constraint(result, label, unit, expression)
        elif function.name != "coordinate_rates":
            title = function.name.replace("_", " ").capitalize()
            left = rf"{words((result,))}_{{{_label(label)}}}"
            name = f"{function.name}.{result}[{label}]"
            yield Draft(title, name, unit, f"{result}, {label}", expression, left=left)
        elif expression not in self._tape.inputs:
            latex = self._names.port(*self._port("q", label))
            yield Draft(KINEMATICS, f"d/dt {label}", unit, f"rate of {label}", expression, left=_RATE + latex)

    def _constraint(self, result: str, label: str, unit: str, expression: Any) -> Iterator[Draft]:
        """Draft of a constraint or its rate."""
        effect, rate = self._holder(label), result == "dphi"
        section, holds = (LOOPS, "loop is closed") if effect is None else (COUPLINGS, "coupling holds")
        if isinstance(effect, RollingWithoutSlip | KnifeEdge):
            section, holds = ROLLING, "surfaces touch"
        text = f"rate of {label}, zero too" if rate else f"{label}, zero while the {holds}"
        left = rf"{_RATE}\Phi_{{{_label(label)}}}" if rate else rf"\Phi_{{{_label(label)}}}"
        if label in self._on_speeds:
            if not rate:
                return
            text, left = f"{label}, zero", _label(label)
        names = () if effect is None else (effect.name,)
        yield Draft(section, f"{result} {label}", unit, text, expression, left=left, effects=names)

    def _holder(self, constraint: str) -> Effect | None:
        """Effect that holds a constraint; None of a joint's."""
        effect = self._effects.get(constraint.rpartition(".")[0])
        return effect if isinstance(effect, Coupling | RollingWithoutSlip | KnifeEdge) else None

    def _slips(self, pair: str) -> dict[str, list[sp.Symbol]]:
        """Friction forces and moments of a contact with stick and slip, by its pair or an effect.

        They act along the tangents or about the axes, against the velocity there.
        """
        place, forces = [name for name, _ in self._program.tables["PAIRS"]].index(pair), dict[str, list[sp.Symbol]]()
        for slip, _, j in self._program.tables["SLIPS"]:
            if j == place:
                whose, _, name = slip.rpartition(".")
                force = name.replace("slip", "friction_force").replace("turning", "moment")
                forces.setdefault(whose, []).append(sp.Symbol(f"{whose}_{force}", real=True))
        return forces

    def _friction_with_modes(self, pair: str, function: Function, whose: str, sliding: Any) -> Iterator[Draft]:
        """Drafts of the friction forces or moments with stick and slip of one that a contact has."""
        results = {result.name: result for result in function.results}
        turning, forces = results.get("turning_velocity"), self._slips(pair)[whose]
        velocities = results["sliding_velocity"].expressions
        if whose != pair and turning is not None:
            rows = zip(turning.labels, turning.expressions, strict=True)
            velocities = tuple(velocity for label, velocity in rows if label == whose)
        if len(velocities) > 2:
            return  # of a patch: integrals, which the declaration tells
        speed = sp.sqrt(sp.Add(*(velocity**2 for velocity in velocities)))
        for velocity, force in zip(velocities, forces, strict=True):
            quantity = (
                force.name.removeprefix(f"{whose}_").replace("friction", "sticking").replace("moment", "resting_moment")
            )
            sticking = sp.Symbol(f"{whose}_{quantity}", real=True)
            if len(velocities) == 1:
                self.added[force] = Where(sp.Ne(velocity, 0), sliding * sp.sign(velocity), sticking)
            else:
                self.added[force] = Where(speed > 0, sliding * velocity / speed, sticking)
            unit = "N" if whose == pair else "N m"
            yield Draft(contact_title(pair), force.name, unit, self._names.meaning(force), force, force)

    def _friction_power(self, pair: str, result: Result) -> Iterator[Draft]:
        """Drafts of the powers of friction with stick and slip, given per newton along each tangent."""
        entries, forces = list(dict.fromkeys(result.labels)), list(chain(*self._slips(pair).values()))
        for i, label in enumerate(entries):
            parts = zip(result.expressions[i :: len(entries)], forces, strict=True)
            power = sp.Add(*(-part * force for part, force in parts))
            if power != 0:
                yield self._rate_of_memory(pair, label, "W", power)

    def _definition(self, section: str, name: str, unit: str, expression: Any) -> Draft:
        """Draft that defines the symbol of this name.

        The symbol is new where the program has the result under another name, or none.
        """
        symbol = expression
        if expression not in self._tape.assignments or expression.name != name:
            symbol = sp.Symbol(name, real=True)
            self.added[symbol] = expression
        return Draft(section, name, unit, self._names.meaning(symbol), symbol, symbol)

    def _rate_of_memory(self, pair: str, label: str, unit: str, expression: Any) -> Draft:
        name, quantity = label.rsplit(".", 1)
        effects = (name,) if name in self._effects else ()
        if quantity == "input" and self._program.scene.ledger is self._effects[name]:
            left, meaning = rf"\dot{{W}}_{{{words((quantity,))}}}", "power the drives put in"
        elif quantity == "input":
            left, meaning = rf"\dot{{W}}_{{{words(name.split('_'))}}}", f"power put in by {name}"
        elif quantity == "dissipated":
            left, meaning = rf"\dot{{W}}_{{{words(name.split('_'))}}}", f"power dissipated by {name}"
        else:
            memory = [s.name for s, group in self._tape.inputs.items() if group == "z"]
            left, meaning = _RATE + self._names.port("z", memory.index(label.replace(".", "_"))), f"rate of {label}"
        section = LEDGER if unit == "W" else contact_title(pair) if pair else KINEMATICS
        return Draft(section, f"d/dt {label}", unit, meaning, expression, left=left, effects=effects)

    def _port(self, group: str, label: str) -> tuple[str, int]:
        """Group and position of a coordinate or speed."""
        table = self._program.tables["COORDINATES" if group == "q" else "SPEEDS"]
        return group, [name for name, _ in table].index(label)

    # -- equations of motion ---------------------------------------------------------------------------------------

    def _rows(self) -> Iterator[Draft]:
        """Yield M a + bias = f, row by row; the row of a driven joint includes the force of its drive."""
        functions = {function.name: function for function in self._program.functions}
        motion, applied = functions["motion"], functions["applied"]
        inputs: dict[str, list[sp.Symbol]] = {"a": [], "reactions": []}
        for symbol, group in self._tape.inputs.items():
            inputs.setdefault(group, []).append(symbol)
        mass, bias, held = motion.results
        labels, units = applied.results[0].labels, applied.results[0].units
        accelerations = dict(zip(labels, inputs["a"], strict=False))
        # the drive of a loop-closing joint is a multiplier
        supplied = dict(zip(labels[len(inputs["a"]) :], inputs["reactions"], strict=False))
        for i, (row, unit) in enumerate(zip(bias.labels, units, strict=False)):  # rows of reactions do not move
            parts = [
                Part(True, INERTIA, sp.sympify(entry), factor=accelerations[column])
                for (of, column), entry in zip((k.split(" ") for k in mass.labels), mass.expressions, strict=True)
                if of == row
            ]
            if bias.expressions[i] != 0:
                parts.append(Part(True, BIAS, bias.expressions[i]))
            for label, column in zip(held.labels, held.expressions, strict=True):
                of, constraint = label.split(" ")
                if of == row:
                    force, effect = multiplier(constraint) * column, self._holder(constraint)
                    name = "" if effect is None else effect.name
                    parts.append(Part(False, name or f"constraint {constraint}", force, effect=name))
            if row in supplied:
                meaning, drive = self._names.meaning(supplied[row]), self._drive_of(row)
                parts.append(Part(False, meaning, supplied[row], effect=drive))
            for function in functions.values():
                if function.name in ("applied", "loads") or pair_of(function.name):
                    force = sp.sympify(function.results[0].expressions[i])
                    parts.append(Part(False, function.summary, force, source=function.name))
                for along in (result for result in function.results if result.name == "along"):
                    columns = along.expressions[i :: len(labels)]
                    forces = chain(*self._slips(pair_of(function.name)).values())
                    friction = sp.Add(*(-force * column for force, column in zip(forces, columns, strict=True)))
                    parts.append(Part(False, function.summary, friction, source=function.name))
            yield Draft(MOTION, f"row {row}", unit, f"motion of {row}", parts=parts)

    def _drive_of(self, row: str) -> str:
        driven = self._program.scene.driven
        drive = driven.get(row) or driven.get(row.rsplit(".", 1)[0])
        return "" if drive is None else drive.name


def multiplier(constraint: str) -> sp.Symbol:
    """Symbol of the Lagrange multiplier (force or torque) of a constraint."""
    return sp.Symbol(f"{constraint.replace('.', '_')}_multiplier", real=True)


def pair_of(function: str) -> str:
    """Name of the pair whose contact a function of the program computes; "" for any other function."""
    return function.removeprefix("contact_") if function.startswith("contact_") else ""


def _label(label: str) -> str:
    return words(label.replace(".", "_").split("_"))
