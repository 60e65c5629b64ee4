"""Catalogue of all contact laws by name. A file of laws is imported when one of them is first wanted.

To build all of them takes as long as to import two thirds of SymPy.
"""

from __future__ import annotations

from collections.abc import Iterator, MutableMapping
from importlib import import_module

from hertzwerk.derive.laws.law import Law

FILES = (
    ("stiffness", "hertz_point power galin_sneddon"),
    ("plastic", "thornton kogut_etsion jackson_green"),
    ("logarithmic", "johnson hertz_cylinder radzimovsky goldsmith goldsmith_m3 dubowsky_freudenstein esdu_78035"),
    (
        "line",
        "palmgren palmgren_si pereira_internal pereira_internal_si pereira_external pereira_external_si lankarani_nikravesh_cylinders "
        "liu liu_with_length bai_zhao bai_zhao_repaired persson popov_line hertz_half_width",
    ),
    ("reconstruction", "wang_liu_external wang_liu_internal wang_liu_secant wang_liu_half_width wang_liu_johnson"),
    (
        "damping",
        "hunt_crossley herbert_mcwhannell lee_wang lankarani_nikravesh gonthier zhiying_qishao flores "
        "gharib_hurmuzlu hu_guo carvalho_martins safaeifar_farshidianfar",
    ),
    ("exact_factor", "exact"),
    ("damping", "kelvin_voigt power_damping ristow tsuji kuwabara_kono jankowski"),
    ("friction", "coulomb smooth_coulomb ambrosio threlfall stribeck brown_mcphee bengisu_akay lugre"),
    ("lubrication", "short_bearing short_bearing_full long_bearing long_bearing_full sphere_film brenner"),
)
"""The files of laws, and the names of those in each, in the order of the catalogue."""


class Catalogue(MutableMapping[str, Law]):
    """Contact laws by name."""

    def __init__(self) -> None:
        self._files = {name: file for file, names in FILES for name in names.split()}
        self._laws: dict[str, Law | None] = dict.fromkeys(self._files)  # None before its file is imported

    def __getitem__(self, name: str) -> Law:
        law = self._laws[name]
        if law is None:
            module = import_module(f".formulas.{self._files[name]}", __package__)
            law = {law.name: law for law in vars(module).values() if isinstance(law, Law)}[name]
            self._laws[name] = law
        return law

    def __setitem__(self, name: str, law: Law) -> None:
        self._laws[name] = law

    def __delitem__(self, name: str) -> None:
        del self._laws[name]

    def __contains__(self, name: object) -> bool:
        return name in self._laws

    def __iter__(self) -> Iterator[str]:
        return iter(self._laws)

    def __len__(self) -> int:
        return len(self._laws)


LAWS = Catalogue()
