"""LaTeX and meaning of a program's symbols: a letter for the quantity, its owner as the subscript."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Mapping
from typing import Any

import sympy as sp

from hertzwerk.derive.expressions.algebra.notation import latex_name
from hertzwerk.derive.expressions.parameter import Parameter
from hertzwerk.derive.laws.law import GEOMETRY, Quantity
from hertzwerk.derive.program.program import Program

AXES = ("x", "y", "z")

# Last words of a name -> letter; the words before them become the subscript.
LETTERS = {
    "mass_centre": "s",
    "approach_floor": r"v_{0,\mathrm{min}}",
    "poissons_ratio": r"\nu",
    "youngs_modulus": "E",
    "friction_coefficient": r"\mu",
    "angular_bias": r"\alpha",
    "angular_acceleration": r"\alpha",
    "bias_torque": "B",
    "bias_force": "b",
    "moment": "S",
    "total_moment": "S",
    "total_mass": "m",
    "total_J": "J",
    "J": "J",
    "I": "J",
    "rate": r"\omega",
    "mass": "m",
    "inertia": "J",
    "radius": "r",
    "length": "l",
    "width": "b",
    "height": "h",
    "gravity": "g",
    "clearance": "c",
    "gap": "g",
    "restitution": "e",
    "stiffness": "K",
    "exponent": "n",
    "density": r"\rho",
    "angle": r"\varphi",
    "velocity": "v",
    "arm": "a",
    "torque": "T",
    "force": "F",
    "amplitude": "A",
    "viscosity": r"\eta",
    "boundary_layer": r"h_{0}",
}
# Quantities of a contact pair: the words after the pair's name -> letter, subscript, meaning.
PAIR = {
    "apart": ("d", "", "from the second place to the first"),
    "e": ("e", "", "eccentricity, across the axis"),
    "along": ("d", "a", "distance along the axis"),
    "apart_rate": (r"\dot{d}", "", "rate of the distance"),
    "apart_squared": ("d^{2}", "", "squared distance of the places"),
    "apart_squared_rate": (r"\dot{(d^{2})}", "", "rate of the squared distance"),
    "distance": ("d", "", "distance of the places"),
    "reach": ("d", "0", "distance of the centres at the onset"),
    "direction": ("n", "0", "direction of the second place"),
    "height": ("h", "", "height of the corner over the face"),
    "line": ("l", "", "direction along the face"),
    "way": ("d", "l", "way of the corner along the face, from its middle"),
    "beyond": ("d", r"\mathrm{b}", "way of the corner beyond the nearer end of the face"),
    "beyond_rate": (r"\dot{d}", r"\mathrm{b}", "its rate"),
    "end": ("n", r"\mathrm{b}", "direction out of the nearer end of the face"),
    "axis": ("a", "", "axis of the disc"),
    "tilt": ("n", "a", "normal along the axis of the disc"),
    "up": ("n", r"\mathrm{d}", "part of the normal in the plane of the disc"),
    "rise": ("n", r"\mathrm{r}", "its length"),
    "rim": ("r", r"\mathrm{r}", "from the centre of the disc to its lowest point"),
    "local_apart": ("d", "2", "from the second place to the first, along the axes of the second"),
    "turn": ("R", "", "rotation from the axes of the first place to those of the second"),
    "local_normal": ("n", "2", "normal along the axes of the second place"),
    "local_contact_arm": ("r", "2", "from the second place to the contact point, along its axes"),
    "contact_arm": ("r", r"\mathrm{c}", "from the second place to the contact point"),
    "gap": ("G", "", "gap, positive while open"),
    "gap_rate": (r"\dot{G}", "", "rate of the gap"),
    "normal": ("n", "", "unit vector along which the first place is pushed"),
    "tangent": ("t", "", "tangent"),
    "penetration": (r"\delta", "", "penetration"),
    "penetration_rate": (r"\dot{\delta}", "", "penetration rate"),
    "penetration_limit": (r"\delta", r"\mathrm{max}", "penetration up to which the law holds"),
    "relative_rate": ("w", "", "velocity of the first body against the second at the first place"),
    "sliding_rate": ("w", r"\mathrm{t}", "velocity of the first body against the second at the contact point"),
    "along_rate": ("w", r"\mathrm{n}", "its part along the normal"),
    "slip": ("s", "", "sliding velocity, vector"),
    "slip_squared": ("s^{2}", "", "squared sliding velocity"),
    "sliding_velocity": ("s", "", "sliding velocity"),
    "elastic_force": ("F", r"\mathrm{e}", "elastic force"),
    "tangent_stiffness": ("k", r"\mathrm{t}", "tangent stiffness"),
    "hysteresis_factor": ("h", "", "hysteresis damping factor"),
    "resistance": ("F", r"\mathrm{d}", "damping force"),
    "normal_force": ("F", r"\mathrm{n}", "normal force"),
    "normal_power": ("P", r"\mathrm{n}", "power dissipated by the normal force"),
    "push": ("F", r"\mathrm{n}", "normal force on the first body"),
    "friction_force": ("F", r"\mathrm{t}", "friction force, against the sliding velocity"),
    "friction_force_1": ("F", r"\mathrm{t1}", "friction force along the first tangent, against the sliding velocity"),
    "friction_force_2": ("F", r"\mathrm{t2}", "friction force along the second tangent, against the sliding velocity"),
    "sticking_force_1": (
        "F",
        r"\mathrm{st1}",
        "what keeps the contact from sliding, with the other tangent's at most the holding force",
    ),
    "sticking_force_2": (
        "F",
        r"\mathrm{st2}",
        "what keeps the contact from sliding, with the other tangent's at most the holding force",
    ),
    "sliding_force": ("F", r"\mathrm{sl}", "friction force while sliding"),
    "holding_force": ("F", r"\mathrm{h}", "the most that friction holds at rest"),
    "sticking_force": (
        "F",
        r"\mathrm{st}",
        "what keeps the contact from sliding, at most the holding force; beyond it the contact slides",
    ),
    "friction_power": ("P", r"\mathrm{t}", "power dissipated by friction"),
    "friction_slope": ("c", "0", "slope of the friction force at rest"),
    "friction_stiffness": ("k", r"\mathrm{t}", "friction force per deflection of the bristle"),
    "bristle_decay": ("b", "", "rate at which sliding lets go of the bristle, per deflection"),
    "bristle_gain": ("g", "", "rate at which sliding bends the bristle, per sliding velocity"),
    "opposing": ("F", r"\mathrm{t}", "friction force against the sliding velocity, vector"),
    "normal_rate": (r"\dot{n}", "", "rate of the normal"),
    "twirl": (r"\omega", r"\mathrm{n}", "mean angular velocity of the bodies about the normal"),
    "turning": (r"\omega", r"\mathrm{c}", "angular velocity of the contact"),
    "friction_per_speed": ("c", r"\mathrm{t}", "friction force per sliding velocity"),
    "drag": ("F", r"\mathrm{t}", "friction force on the first body"),
    "stored_energy": ("U", "", "energy stored"),
    "in_range": (r"\chi", "", "1 while the law holds, else 0"),
    "approach_speed": ("v", "0", "approach speed, latched at the onset of the contact"),
}
LANDMARKS = (
    *("apart", "e", "apart_rate", "relative_rate", "gap", "gap_rate", "distance", "normal", "penetration", "penetration_rate", "sliding_velocity"),
    *("height", "way", "beyond", "beyond_rate", "end", "tilt", "rise"),
    *("elastic_force", "tangent_stiffness", "hysteresis_factor", "resistance", "normal_force", "friction_force", "stored_energy"),
)  # fmt: skip
_HOLDS = "_multiplier"
_LAW = {quantity.name: quantity.meaning for quantity in GEOMETRY}


def contact_title(pair: str) -> str:
    """Title of a pair's section."""
    return f"Contact {pair}"


class Names:
    """LaTeX and meaning of the symbols of a program; no two symbols look the same."""

    def __init__(self, program: Program, units: dict[sp.Symbol, str], meanings: Mapping[str, str]) -> None:
        self._program, self._units, self._meanings = program, units, meanings
        self._effects = {effect.name: effect for effect in program.scene.effects if effect.quantities}
        words_of = {name: effect.quantities for name, effect in self._effects.items()}
        self._words = dict.fromkeys((name for name, _ in program.tables["PAIRS"]), PAIR) | words_of
        self._owners = sorted(self._words, key=len, reverse=True)
        self._law_meanings = dict(_law_symbols(program.scene))
        self._ports = self._port_names()
        self.latex: dict[sp.Symbol, str] = {}

    def assign(self, symbols: Iterable[sp.Symbol]) -> None:
        """Give each symbol its LaTeX; symbols that would look the same get their whole names."""
        symbols = list(symbols)
        wanted = {symbol: self._letter(symbol) for symbol in symbols}
        count = Counter(wanted.values())
        self.latex = {
            symbol: latex if count[latex] == 1 else words(symbol.name.split("_")) for symbol, latex in wanted.items()
        }

    def meaning(self, symbol: sp.Symbol) -> str:
        """Meaning of a symbol in words."""
        if symbol in self._ports:
            return self._ports[symbol][1]
        if isinstance(symbol, Parameter):
            return str(symbol.meaning or self._meanings.get(symbol.name, ""))
        owner, rest, axis = self._split_owner(symbol.name)
        if owner:
            return self._law_meanings.get(rest) or f"{self._words[owner][rest][2]}{f', {axis}' if axis else ''}"
        text = str(symbol.name).replace("_", " ")
        return f"what holds the constraint {text.removesuffix(' multiplier')}" if symbol.name.endswith(_HOLDS) else text

    def title_of(self, symbol: sp.Symbol) -> str:
        """Title of the section of the contact pair or effect a symbol belongs to; "" for none."""
        owner = next((name for name in self._owners if symbol.name.startswith(f"{name}_")), "")
        return self._effects[owner].section if owner in self._effects else contact_title(owner) if owner else ""

    def port(self, group: str, place: int) -> str:
        """LaTeX of an input, by its group and position."""
        return self._ports[[s for s, of in self._program.tape.inputs.items() if of == group][place]][0]

    def is_landmark(self, symbol: sp.Symbol) -> bool:
        """Whether readers look for it by name: a quantity of a contact or effect, or defined by its laws."""
        owner, rest, _ = self._split_owner(symbol.name)
        landmarks = self._effects[owner].sought if owner in self._effects else LANDMARKS
        return rest in landmarks or rest in self._law_meanings

    # -- letters ---------------------------------------------------------------------------------------------------

    def _letter(self, symbol: sp.Symbol) -> str:
        if symbol in self._ports:
            return self._ports[symbol][0]
        owner, rest, axis = self._split_owner(symbol.name)
        if owner:
            own = self._words[owner]
            letter, below, _ = own.get(rest) or (*_split(latex_name(sp.Symbol(rest))), "")
            whose = words(owner.split("_")) if sum(other is own for other in self._words.values()) > 1 else ""
            return _with_subscript(letter, (axis, below, whose))
        if symbol.name.endswith(_HOLDS):
            return _with_subscript(r"\lambda", (words(symbol.name.removesuffix(_HOLDS).split("_")),))
        parts = symbol.name.split("_")
        axes = tuple(part for part in parts[1:] if part in AXES)
        parts = [part for i, part in enumerate(parts) if i == 0 or part not in AXES]
        number = parts.pop() if len(parts) > 1 and parts[-1].isdigit() else ""
        for start in range(len(parts)):
            last = "_".join(parts[start:])
            letter = r"\omega" if last == "speed" and self._turns(symbol) else "v" if last == "speed" else ""
            letter = letter or LETTERS.get(last, "")
            if letter:
                return _with_subscript(letter, (*axes, number, words(parts[:start])))
        if not axes and len(parts) <= 2 and _is_letter(parts[0]) and all(len(part) <= 3 for part in parts[1:]):
            return latex_name(symbol)  # as mu_k
        return _with_subscript(words(parts), (*axes, number))

    def _turns(self, symbol: sp.Symbol) -> bool:
        return self._units.get(symbol, "") in ("1/s", "rad/s")

    def _split_owner(self, name: str) -> tuple[str, str, str]:
        """Split a name into its pair or film, the quantity and the axis; ("", "", "") for other names."""
        for owner in self._owners:
            if name.startswith(f"{owner}_"):
                rest, axis = name[len(owner) + 1 :], ""
                if rest[-2:] in ("_x", "_y", "_z") and rest not in self._law_meanings:  # a law's d_y is no component
                    rest, axis = rest[:-2], rest[-1]
                if rest in self._words[owner] or (rest in self._law_meanings and not axis):
                    return owner, rest, axis
        return "", "", ""

    # -- ports -----------------------------------------------------------------------------------------------------

    def _port_names(self) -> dict[sp.Symbol, tuple[str, str]]:
        """LaTeX and meaning of the inputs other than parameters."""
        program = self._program
        inputs: dict[str, list[sp.Symbol]] = {group: [] for group in ("t", "q", "u", "a", "z", "reactions")}
        for symbol, group in program.tape.inputs.items():
            inputs.setdefault(group, []).append(symbol)
        entries: dict[sp.Symbol, tuple[str, str]] = dict.fromkeys(inputs["t"], ("t", "time"))
        rates = next(f for f in program.functions if f.name == "coordinate_rates").results[0].expressions
        coordinates: dict[sp.Symbol, tuple[str, str]] = {}
        for symbol, (label, unit), rate in zip(inputs["q"], program.tables["COORDINATES"], rates, strict=True):
            letter, name = self._coordinate(label, unit)
            coordinates[symbol] = letter, name
            if isinstance(rate, sp.Symbol):
                entries[rate] = rf"\dot{{{letter}}}_{{{name}}}", f"rate of {label}"
        entries |= {s: (f"{letter}_{{{name}}}", "") for s, (letter, name) in coordinates.items()}
        labels = [label for label, _ in program.tables["COORDINATES"]]
        for symbol, label in zip(inputs["q"], labels, strict=True):
            entries[symbol] = entries[symbol][0], f"coordinate {label}"
        speeds = [label for label, _ in program.tables["SPEEDS"]]
        for symbol, (label, unit) in zip(inputs["u"], program.tables["SPEEDS"], strict=True):
            if symbol not in entries:
                joint, coordinate = label.rsplit(".", 1)
                axis = ",".join(part for part in coordinate.split("_") if part in AXES)
                letter = r"\omega" if unit == "rad/s" else "v"
                entries[symbol] = _with_subscript(letter, (axis, words(joint.split("_")))), f"speed {label}"
        for speed, symbol, label in zip(inputs["u"], inputs["a"], speeds, strict=True):
            latex = entries[speed][0]
            letter, _, below = latex.partition("_")
            letter = letter.replace(r"\dot", r"\ddot") if letter.startswith(r"\dot") else rf"\dot{{{letter}}}"
            entries[symbol] = f"{letter}_{below}", f"rate of {label}"
        for symbol in inputs["z"]:
            whose = words(symbol.name.split("_")) if len(inputs["z"]) > 1 else ""
            entries[symbol] = _with_subscript("z", (whose,)), str(symbol.name).replace("_", " ")
        rubs = [name for name, *_ in program.tables["RUBBING"]]
        rubbing = {
            f"{name}_coefficient": (r"\mu", name, "coefficient of friction, with its sign, while it slides")
            for name in rubs
        }
        rubbing |= {f"{name}_holding": ("F", name, "friction force while it sticks") for name in rubs}
        for symbol in inputs["reactions"]:
            if symbol.name in rubbing:
                letter, name, meaning = rubbing[symbol.name]
                entries[symbol] = _with_subscript(letter, (words(name.split("_")),)), f"{meaning}, of {name}"
                continue
            joint = symbol.name.removesuffix("_reaction_in")
            if symbol.name == joint:
                entries[symbol] = (
                    _with_subscript("N", (words(joint.split("_")),)),
                    f"magnitude of {joint.replace('_', ' ')}, solved with the accelerations",
                )
                continue
            turns = str(program.tape.declared[symbol]) in ("N m", "J")
            entries[symbol] = (
                _with_subscript("T" if turns else "F", (words(joint.split("_")),)),
                f"{'torque' if turns else 'force'} of the drive of {joint}",
            )
        return entries

    def _coordinate(self, label: str, unit: str) -> tuple[str, str]:
        """Letter and subscript of a coordinate `joint.name`."""
        joint, coordinate = label.rsplit(".", 1)
        name = words(joint.split("_"))
        if coordinate == "travel":
            freedoms = (freedom for j in self._program.scene.mechanism.joints for freedom in j.freedoms)
            axis = next((freedom.axis for freedom in freedoms if freedom.coordinates[0].name == label), None)
            components = () if axis is None else axis.components
            along = [AXES[k] for k, component in enumerate(components) if component]
            return (along[0] if len(along) == 1 else "s"), name
        if coordinate == "angle":
            return r"\varphi", name
        if len(coordinate) <= 2:
            return coordinate[0], ",".join(filter(None, (coordinate[1:], name)))
        letter = {"rad": r"\varphi", "m": "s"}.get(unit, "q")
        return letter, ",".join((words(coordinate.split("_")), name))


def _law_symbols(scene: Any) -> Iterable[tuple[str, str]]:
    """Yield name and meaning of the defined and geometric symbols of the laws in use."""
    yield from _LAW.items()
    for effect in scene.effects:
        for bound in effect.laws:
            yield from ((symbol.name, symbol.meaning) for symbol in bound.law.symbols() if isinstance(symbol, Quantity))


def _split(latex: str) -> tuple[str, str]:
    """Split into letter and subscript."""
    letter, _, below = latex.partition("_")
    return letter, below.removeprefix("{").removesuffix("}") if below.startswith("{") else below


def _is_letter(part: str) -> bool:
    """Whether the first part of a name is a letter, Latin or Greek."""
    return len(part) <= 2 or str(sp.latex(sp.Symbol(part))).startswith("\\")


def words(parts: Iterable[str]) -> str:
    """Words upright in LaTeX."""
    text = r"\,".join(part for part in parts if part)
    return rf"\mathrm{{{text}}}" if text else ""


def _with_subscript(letter: str, below: Iterable[str]) -> str:
    subscript = ",".join(part for part in below if part)
    return f"{letter}_{{{subscript}}}" if subscript else letter
