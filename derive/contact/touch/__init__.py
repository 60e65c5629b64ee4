"""Contact geometry of the pairs, one file per family."""

from hertzwerk.derive.contact.touch.corner import BoundedFace
from hertzwerk.derive.contact.touch.custom import Custom
from hertzwerk.derive.contact.touch.flat import Face, LyingCylinder, Rim
from hertzwerk.derive.contact.touch.round import Round
from hertzwerk.derive.contact.touch.touch import Touch, touch

__all__ = ["BoundedFace", "Custom", "Face", "LyingCylinder", "Rim", "Round", "Touch", "touch"]
