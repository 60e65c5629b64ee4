"""Contact laws: stiffness, damping and friction records, and the catalogue of all of them by name."""

from hertzwerk.derive.laws.catalogue import LAWS
from hertzwerk.derive.laws.damping import flores, hunt_crossley, lankarani_nikravesh
from hertzwerk.derive.laws.friction import smooth_coulomb
from hertzwerk.derive.laws.stiffness import hertz_point, lankarani_nikravesh_cylinders, power

__all__ = [
    "LAWS",
    "flores",
    "hertz_point",
    "hunt_crossley",
    "lankarani_nikravesh",
    "lankarani_nikravesh_cylinders",
    "power",
    "smooth_coulomb",
]
