"""Pictures as SVG inside a page: shapes and text alone, with names that no other picture has."""

from __future__ import annotations

import re
from xml.etree import ElementTree

from hertzwerk.derive.common.markup import Markup, tag

_ALLOWED = (
    *(
        "svg",
        "g",
        "path",
        "defs",
        "use",
        "clipPath",
        "rect",
        "circle",
        "ellipse",
        "line",
        "polyline",
        "polygon",
        "image",
    ),
    *("text", "tspan", "marker", "linearGradient", "radialGradient", "stop", "pattern", "symbol", "mask"),
)
_INHERITED = {"stroke-linejoin": "round", "stroke-linecap": "butt"}  # what Matplotlib says in a style element
_HREF = re.compile(r"""href\s*=\s*['"]#([^'"]*)""")
_REFERENCE = re.compile(r"url\(\s*['\"]?#([^)'\"]*)['\"]?\s*\)")


def picture(svg: str, name: str, label: str, caption: str = "") -> Markup:
    """Return a figure with an SVG picture; `name` is its own on the page, `label` says what it shows.

    Scripts, styles, foreign content and every reference outside the picture are left out. Raises ValueError for what
    is no SVG.
    """
    try:
        root = ElementTree.fromstring(svg)
    except ElementTree.ParseError as error:
        raise ValueError(f"no SVG picture: {error}") from error
    if _local(root.tag) != "svg":
        raise ValueError(f"no SVG picture: its root is {_local(root.tag)!r}")
    _clean(root, f"{name}-", {name for pattern in (_REFERENCE, _HREF) for name in pattern.findall(svg)})
    size = [root.attrib.pop(side, "") for side in ("width", "height")]
    if "viewBox" not in root.attrib:
        root.set("viewBox", f"0 0 {' '.join(_points(text) for text in size)}")
    for key, value in (_INHERITED | {"role": "img", "aria-label": label}).items():
        root.set(key, value)
    drawn = Markup(ElementTree.tostring(root, encoding="unicode"))
    return tag("figure", drawn, tag("figcaption", caption) if caption else None)


def _clean(element: ElementTree.Element, prefix: str, wanted: set[str]) -> None:
    """Leave of an element what draws, and rename what is referred to; `wanted` are names not met yet."""
    element.tag = _local(element.tag)
    attributes: dict[str, str] = {}
    for key, value in element.attrib.items():
        name = _local(key)
        if name == "href":
            if value.startswith("#"):
                attributes[name] = f"#{prefix}{value[1:]}"
            elif re.match(r"data:image/(png|jpeg);base64,", value):
                attributes[name] = value
        elif name == "id":
            if value in wanted:
                wanted.remove(value)  # Matplotlib repeats a few
                attributes[name] = prefix + value
        elif not name.lower().startswith("on") and "url(" not in _REFERENCE.sub("", value):
            attributes[name] = _REFERENCE.sub(rf"url(#{prefix}\1)", value)
    element.attrib.clear()
    element.attrib.update(attributes)
    for child in list(element):
        if isinstance(child.tag, str) and _local(child.tag) in _ALLOWED:
            _clean(child, prefix, wanted)
        else:
            element.remove(child)


def _local(name: str) -> str:
    return name.rpartition("}")[2]


def _points(length: str) -> str:
    match = re.match(r"\d+(?:\.\d+)?", length)
    return match[0] if match else "100"
