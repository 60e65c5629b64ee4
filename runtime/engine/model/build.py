"""Access to `derive`: from a scene to a loaded module.

Derivation imports SymPy, so every import of derive stands inside a function: a run of a committed scene never comes
here. Variations of the built-in scenes are cached on disk under the hash of everything their text depends on, and
found again without SymPy.
"""

from __future__ import annotations

import hashlib
import re
import sys
from collections.abc import Callable, Iterable, Mapping, Sequence
from functools import cache, partial
from importlib import metadata, resources
from pathlib import Path
from types import ModuleType
from typing import TYPE_CHECKING, Any

from hertzwerk.derive.common.execute_file import file_of_module, names_defined_by, names_imported, sympy_remedy
from hertzwerk.derive.common.faults import Fault, InputError, noted, refuse, unknown
from hertzwerk.derive.common.module_format import without_scene
from hertzwerk.runtime.engine.model.generated_text import module_in, module_of
from hertzwerk.runtime.system import cache as disk

if TYPE_CHECKING:
    from hertzwerk.derive.audit.audit import Finding
    from hertzwerk.derive.declare.scene.scene import Scene
    from hertzwerk.derive.exchange.law_sheets.free_impact import Trial
    from hertzwerk.derive.exchange.law_sheets.law_comparison import ExponentUnit, ForceCurve
    from hertzwerk.derive.exchange.law_sheets.law_sheet import Sheet
    from hertzwerk.derive.exchange.readable_equations.readable_record import Readable
    from hertzwerk.derive.expressions.dimension.tree import Node
    from hertzwerk.derive.laws.law import Law


def built_in_scenes() -> tuple[str, ...]:
    """Names of the scenes that `hertzwerk.derive.scenes` declares, sorted; imports no SymPy."""
    from hertzwerk.derive.scenes import NAMES

    return NAMES


def split_target(target: str | Path) -> tuple[str, str]:
    """Return the file, module or built-in scene of a target, and the name after ":", which may be ""."""
    place, _, name = str(target).rpartition(":")
    named = place.endswith(".py") or all(map(str.isidentifier, place.split(".")))
    return (place, name) if named and name.isidentifier() else (str(target), "")


def is_file(target: str | Path) -> bool:
    """Return whether a target names a Python file, as FILE.py or FILE.py:NAME."""
    place, _ = split_target(target)
    return isinstance(target, Path) or place.endswith(".py") or "/" in place or "\\" in place


def in_python(target: str | Path) -> bool:
    """Return whether a target names a Python file, or package.module:NAME, rather than a built-in scene."""
    return is_file(target) or split_target(target)[1] != ""


def file_of(target: str | Path) -> Path | None:
    """Return the file of a target, None for a built-in scene or a module without one; executes nothing."""
    if is_file(target):
        return Path(split_target(target)[0])
    return file_of_module(split_target(target)[0]) if in_python(target) else None


def located_target(target: str | Path, folder: Path) -> str:
    """Return a target with its file as seen from a folder."""
    place, name = split_target(target)
    if not is_file(target):
        return str(target)
    file = folder / place
    return str(file.resolve() if file.is_absolute() else file) + f":{name}" * bool(name)


def scene_from(target: str | Path) -> Scene:
    """Return the scene that a target names; raises InputError, also for a generated module.

    A built-in name, FILE.py, FILE.py:NAME or package.module:NAME. A file is executed, as `python file.py` would.
    """
    scene = scene_or_module(target)
    if isinstance(scene, ModuleType):
        raise without_scene(str(target), getattr(scene, "SOURCE", ""), getattr(scene, "NAME", str(target)))
    return scene


def scene_or_module(target: str | Path) -> Scene | ModuleType:
    """Return the scene, or the generated module, that a target names; raises InputError."""
    place, name = split_target(target)
    if not in_python(target):
        require_targets([place])
        scene: Scene = __import__(f"hertzwerk.derive.scenes.{place}", fromlist=["scene"]).scene
        return scene
    module = module_in(Path(place)) if is_file(target) else None
    if module is not None and not name:
        return module
    if module is not None:
        actual = f"`{name}` of a generated module"
        raise InputError(str(target), [Fault(str(target), actual, f"the module itself, {place}")])
    content = names_defined_by(Path(place)) if is_file(target) else names_imported(place, name)
    return _scene_in(content, str(target), name or "scene", "file" if is_file(target) else "module")


def _scene_in(content: Mapping[str, Any], target: str, name: str, kind: str) -> Scene | ModuleType:
    """Return a scene, or a generated module, by its name; raises InputError with the names of all scenes."""
    value = content.get(name)
    if isinstance(value, ModuleType) and hasattr(value, "FORMAT"):
        return value
    from hertzwerk.derive.declare.scene.scene import Scene

    if isinstance(value, Scene):
        return value
    actual = f"no `{name}`" if value is None else f"`{name}` of type {type(value).__name__}"
    place, _ = split_target(target)
    known = [f"{place}:{each}" for each, scene in content.items() if isinstance(scene, Scene) and each[0] != "_"]
    expected = f"one of {', '.join(known)}" if known else f"a {kind} that defines `{name} = Scene(...)`"
    raise InputError(target, [Fault(target, actual, expected, "" if known else sympy_remedy(content))])


def source_of(target: str | Path) -> str:
    """Return the origin as stated in a generated module's header, without folders of this machine."""
    if is_file(target):
        return Path(str(target)).name
    return str(target) if in_python(target) else f"derive/scenes/{target}.py"


def scene_text(name: str) -> str:
    """Return the source of a built-in scene, without the marks of its formatter."""
    source = resources.files("hertzwerk.derive.scenes").joinpath(f"{name}.py").read_text(encoding="utf-8")
    return source.replace("  # fmt: skip", "")


def vary(
    scene: Scene,
    without: Sequence[str] = (),
    laws: Mapping[str, str] | None = None,
    coordinates: str | None = None,
) -> Scene:
    """Return the scene without some effects, with other laws (effect -> law) or coordinates.

    Raises InputError with all faults.
    """
    faults: list[Fault] = []
    changes: list[Callable[[Scene], Scene]] = [
        *(partial(_with_law, effect=effect, text=law) for effect, law in (laws or {}).items()),
        lambda varied: varied.without(*without) if without else varied,
        lambda varied: varied if coordinates is None else varied.with_coordinates(coordinates),
    ]
    for change in changes:
        with noted(faults):
            scene = change(scene)
    refuse(scene.name, faults)
    return scene


def held(scene: Scene) -> Scene:
    """Return the scene with its drives held where they are at the parameter `held_time`."""
    from hertzwerk.derive.declare.scene.held_drives import with_drives_held

    return with_drives_held(scene)


def loading(scene: Scene) -> Scene:
    """Return the scene with the force of loading of its elastic-plastic contacts as elastic laws."""
    from hertzwerk.derive.declare.scene.held_drives import with_loading_laws

    return with_loading_laws(scene)


_IN_FILE = re.compile(r"(?P<file>[^()=]+?\.toml)(?::(?P<law>\w+))?")
_NOT_IN_FILE = re.compile(r"[()=]| x ")


def _with_law(scene: Scene, effect: str, text: str) -> Scene:
    """Return the scene with another law for an effect, of the catalogue or of `FILE.toml:NAME`."""
    from hertzwerk.derive.laws import LAWS
    from hertzwerk.derive.laws.law_call import split_call, split_laws

    known: dict[str, Law] = dict(LAWS)
    for part in split_laws(text) if ".toml" in text else ():
        name, _ = split_call(part)
        place = _IN_FILE.fullmatch(name)
        if place is not None:
            known[name] = _law_of_file(place["file"], place["law"], effect)
    return scene.with_law(effect, text, known)


def _law_of_file(file: str, name: str | None, effect: str) -> Law:
    """Return a law of a TOML file, by its name where there are several; raises InputError."""
    from hertzwerk.derive.exchange.user_files.law_file import laws_from

    laws = laws_from(file)
    if name is None and len(laws) == 1:
        return next(iter(laws.values()))
    if name in laws:
        return laws[name]
    said = "no name of a law" if name is None else f"law {name!r}"
    offered = ", ".join(f"{file}:{each}" for each in laws)
    raise InputError(file, [Fault(f"effect {effect}", f"{said} of {file}", f"one of {offered}")])


def located_laws(text: str, folder: Path) -> str:
    """Return laws as text, also "EFFECT=LAW", with their files as seen from a folder."""

    def located(place: re.Match[str]) -> str:
        before, joint, file = place["file"].rpartition(" x ")
        whole = str(folder / file.strip())
        readable = place["file"] if _NOT_IN_FILE.search(whole) else f"{before}{joint}{whole}"
        return readable + place[0][len(place["file"]) :]

    return _IN_FILE.sub(located, text)


def law_files(laws: Mapping[str, str]) -> dict[str, str]:
    """Return the digests of the files that laws by effect are of, by the files as they are named."""
    named = [place["file"].rpartition(" x ")[2].strip() for text in laws.values() for place in _IN_FILE.finditer(text)]
    return {file: hashlib.sha256(Path(file).read_bytes()).hexdigest() for file in named if Path(file).is_file()}


def _laws_as_they_are(laws: Mapping[str, str] | None) -> tuple[tuple[tuple[str, str], ...], tuple[str, ...]]:
    """Return laws by effect, and the content of the files they are of: what a cached text depends on."""
    by_effect = laws or {}
    return tuple(sorted(by_effect.items())), tuple(law_files(by_effect).values())


def build(scene: Scene, source: str = "a scene") -> ModuleType:
    """Derive a scene, generate its module and execute it; raises InputError if it is inconsistent."""
    return module_of(scene.name, derive_text(scene, source))


def derive_text(scene: Scene, source: str, coordinates: str | None = None) -> str:
    """Return the text of the generated module of a scene; raises InputError.

    coordinates    those of `scene`, where the file's scene has others
    """
    from hertzwerk.derive.equations.derivation import generate

    return generate(scene, source, coordinates)


def equations(scene: Scene) -> Readable:
    """Return the equations of a scene for people; raises InputError if it is inconsistent.

    Also where an effect enters no equation.
    """
    from hertzwerk.derive.exchange.readable_equations.equations_for_readers import equations_of

    return equations_of(scene)


def sympy_file(scene: Scene, values: Mapping[str, tuple[float, str]]) -> str:
    """Return a file of Python that makes the equations of a scene with SymPy; raises InputError."""
    from hertzwerk.derive.exchange.sympy_models.to_sympy import python_file, to_sympy

    return python_file(to_sympy(scene), scene.name, values)


def audit_targets(
    targets: Iterable[str], start_faults: Callable[[str | Scene], Iterable[Fault]]
) -> dict[str, tuple[Finding, ...]]:
    """Return findings on built-in scenes, files and folders, by target or file.

    Raises InputError where one is unsound.

    start_faults    of the start of a scene, or of a built-in one by name; added where units are consistent
    """
    from hertzwerk.derive.audit.audit import Finding
    from hertzwerk.derive.equations.derivation import audit_scene
    from hertzwerk.derive.exchange.user_files.audit_files import audit_files

    def whole(scene: Scene, name: str = "") -> tuple[Finding, ...]:
        findings = audit_scene(scene)
        faults = start_faults(name or scene) if all(finding.sound for finding in findings) else ()
        refused = (
            Finding(
                "", fault.where, "", "", "", "refused", "", found=fault.found, expected=fault.expected, kind="start",
                reason=f"{fault.where}: found {fault.found}; expected {fault.expected}", repair=fault.remedy or None,
            )
            for fault in faults
        )  # fmt: skip
        return *findings, *refused

    audited: dict[str, tuple[Finding, ...]] = {}
    for target in targets:
        if target in built_in_scenes() or split_target(target)[1]:
            audited[target] = whole(scene_from(target), target if target in built_in_scenes() else "")
        elif is_file(target) or target.endswith(".toml") or Path(target).is_dir():
            audited.update((str(path), findings) for path, findings in audit_files(Path(target), whole).items())
        else:
            require_targets([target])
    return audited


def audit_text(text: str, units: Sequence[str], values: Sequence[str], expect: str | None) -> Finding:
    """Return the finding on one expression; raises InputError.

    Its names are declared as "NAME=UNIT" and "NAME=NUMBER".
    """
    from hertzwerk.derive.audit import audit_text as of_text

    return of_text.audit_expression(text, *of_text.declarations(units, values), expect)


def read_expression(text: str, units: Mapping[str, str]) -> tuple[Node, Finding]:
    """Return the tree of an expression, and the finding on it; raises InputError.

    units    of its names
    """
    from hertzwerk.derive.audit.audit_text import audit_expression
    from hertzwerk.derive.expressions.dimension.reader import read

    finding = audit_expression(text, units)
    return read(text).root, finding


def audit_catalogue() -> tuple[tuple[Finding, ...], tuple[str, ...]]:
    """Return findings on every law of the catalogue, and the laws whose recorded verdict differs."""
    from hertzwerk.derive.exchange.user_files.audit_files import audit_catalogue as audited
    from hertzwerk.derive.exchange.user_files.audit_files import differing_verdicts

    findings = audited()
    return findings, differing_verdicts(findings)


def law_summaries(form: str | None) -> tuple[dict[str, str], ...]:
    """Return kind, law, title, what it is made for, grade, verdict and memory of laws of the catalogue.

    form    only consistent laws made for this form of contact
    """
    from hertzwerk.derive.audit.contact_forms import laws_of_form
    from hertzwerk.derive.laws import LAWS
    from hertzwerk.derive.laws.listing import made_for, remembered

    laws = LAWS.values() if form is None else laws_of_form(form)
    return tuple(
        {"kind": law.kind, "law": law.name, "title": law.title, "made for": made_for(law), "grade": law.grade,
         "verdict": law.verdict, "memory": ", ".join(symbol.name for symbol in remembered(law))} for law in laws
    )  # fmt: skip


def law_listing(*, stub: bool) -> str:
    """Return the catalogue as Markdown, or as a stub for type checkers."""
    from hertzwerk.derive.laws import listing

    return listing.stub() if stub else listing.markdown()


def law_file_schemas() -> dict[str, dict[str, Any]]:
    """Return the JSON schema of a law's table in a file, by the kind of law."""
    from hertzwerk.derive.exchange.user_files import law_table

    return law_table.schemas()


def law_sheets(names: Sequence[str]) -> tuple[Sheet, ...]:
    """Return the sheets of the named laws; raises InputError with every unknown name."""
    from hertzwerk.derive.exchange.law_sheets.law_sheet import laws_named, sheet

    return tuple(sheet(law) for law in laws_named(names))


def impact_trials() -> tuple[Trial, ...]:
    """Return the free impact of every damping law: its scene and closed form."""
    from hertzwerk.derive.exchange.law_sheets.free_impact import trials

    return tuple(trials())


def exponent_unit(exponent: float) -> ExponentUnit:
    """Return the unit of Hertz's K d^n with another exponent."""
    from hertzwerk.derive.exchange.law_sheets import law_comparison

    return law_comparison.exponent_unit(exponent)


def force_curve(
    law: str, penetrations: Sequence[float], clearances: Sequence[float], exponent: float | None = None
) -> ForceCurve:
    """Return forces of a stiffness law at penetrations and clearances [m]: `law_comparison.force_curve`."""
    from hertzwerk.derive.exchange.law_sheets import law_comparison

    return law_comparison.force_curve(law, penetrations, clearances, exponent)


def restitution_out(damping: str, e: float, exponent: float) -> float | None:
    """Return the restitution of a free impact in closed form, beside K d^n; None where there is none."""
    from hertzwerk.derive.exchange.law_sheets import free_impact
    from hertzwerk.derive.laws import LAWS
    from hertzwerk.derive.laws.law import DampingLaw

    law = LAWS[damping]
    if not isinstance(law, DampingLaw):
        raise TypeError(f"found {damping}, a {law.kind} law, expected a damping law")
    known = law.factor is not None or float(free_impact.published_exponent(law)) == exponent
    return free_impact.restitution_out(law, e) if known else None


def build_compared(name: str, contact: str, law: str | None) -> ModuleType:
    """Return the module of a built-in scene with another stiffness law, from the cache if possible.

    Laws with inconsistent units run unchecked. None is Hertz's stiffness with a free `exponent`.
    """

    def scene() -> Scene:
        from hertzwerk.derive.exchange.law_sheets import law_comparison

        base = scene_from(name)
        if law is None:
            return law_comparison.with_open_exponent(base, contact)
        return law_comparison.with_stiffness(base, contact, law)

    return module_of(name, _cached_text(("compared", name, contact, law), scene, source_of(name)))


def build_dropped(form: str, damping: str) -> ModuleType:
    """Return the module of a sphere or a cylinder dropped on another, from the cache if possible."""

    def scene() -> Scene:
        from hertzwerk.derive.exchange.law_sheets.law_comparison import dropped

        return dropped(form, damping)

    return module_of(
        f"dropped_{form}",
        _cached_text(("dropped", form, damping), scene, "derive/exchange/law_sheets/law_comparison.py"),
    )


def build_built_in(
    name: str,
    without: Sequence[str] = (),
    laws: Mapping[str, str] | None = None,
    coordinates: str | None = None,
) -> ModuleType:
    """Return the module of a variation of a built-in scene, from the cache if possible."""
    require_targets([name])
    variation = name, tuple(without), _laws_as_they_are(laws), coordinates
    scene = partial(_varied, name, without, laws, coordinates)
    return module_of(name, _cached_text(variation, scene, source_of(name)))


def _varied(name: str, *variation: Any) -> Scene:
    return vary(scene_from(name), *variation)


def readings_text(
    target: str | Scene,
    without: Sequence[str],
    laws: Mapping[str, str],
    coordinates: str,
    scene: Callable[[], Scene],
) -> str:
    """Return the text of a scene's readings, from the cache if possible; raises InputError.

    The others say how the scene was made.
    """

    def text(scene: Scene, source: str) -> str:
        from hertzwerk.derive.equations.derivation import generate_readings

        return generate_readings(scene, source)

    if not isinstance(target, str) or in_python(target):
        return text(scene(), "a scene")
    variation = "readings", target, tuple(without), _laws_as_they_are(laws), coordinates
    return _cached_text(variation, scene, source_of(target), text)


def build_hard_scene(name: str) -> ModuleType:
    """Return the module of a scene of the hard cases, from the cache if possible.

    Raises KeyError for an unknown name.
    """

    def scene() -> Scene:
        from hertzwerk.derive.scenes.hard.hard_scenes import HARD_SCENES

        return HARD_SCENES[name]()

    return module_of(name, _cached_text(("hard", name), scene, "derive/scenes/hard/hard_scenes.py"))


def _cached_text(
    variation: tuple[object, ...],
    scene: Callable[[], Scene],
    source: str,
    derived: Callable[[Scene, str], str] | None = None,
) -> str:
    """Return the text of a module from the cache, or derive and keep it."""
    key = f"generated-{_key(variation)}"
    text = disk.read(key, ".py")
    if text is None:
        text = (derived or derive_text)(scene(), source)
        disk.keep(key, ".py", text.encode())
    return text


def require_targets(targets: Sequence[str]) -> None:
    """Raise InputError with every target that names neither Python nor a built-in scene."""
    known = built_in_scenes()
    way_out = "or a Python file (its name ends in .py)"
    faults = [unknown("scene", name, known, way_out) for name in targets if not in_python(name) and name not in known]
    if faults:
        raise InputError(f"scene {faults[0].where}" if len(faults) == 1 else "scenes", faults)


def _key(variation: tuple[object, ...]) -> str:
    """Return the hash of everything a variation's text depends on: derive's source, SymPy, the variation."""
    parts = repr((derive_digest(), metadata.version("sympy"), sys.version_info[:2], *variation))
    return hashlib.sha256(parts.encode()).hexdigest()[:32]


@cache
def derive_digest(folder: Path | None = None) -> str:
    """Return the hash of derive's sources: of those in use, or of those in a folder."""
    if folder is None:
        with resources.as_file(resources.files("hertzwerk.derive")) as installed:
            return derive_digest(installed)
    digest = hashlib.sha256()
    for file in sorted(folder.rglob("*.py")):
        digest.update(file.relative_to(folder).as_posix().encode() + b"\0" + file.read_bytes() + b"\0")
    return digest.hexdigest()
