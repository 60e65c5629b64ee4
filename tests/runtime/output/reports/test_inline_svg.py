"""Pictures inside a page: names of their own, and nothing but what draws."""

from xml.etree import ElementTree

import pytest

from hertzwerk.runtime.output.reports.inline_svg import picture

SVG = """<?xml version="1.0"?>
<svg xmlns="http://www.w3.org/2000/svg" xmlns:xlink="http://www.w3.org/1999/xlink" width="20pt" height="10pt" onload="alert(1)">
 <style>@import url(http://a.example/x.css);</style>
 <script>alert(1)</script>
 <defs><path id="m1" d="M 0 0"/><clipPath id="c1"><rect width="5" height="5"/></clipPath></defs>
 <g clip-path="url(#c1)" style="fill: url(http://a.example/x)"><use xlink:href="#m1" x="1"/><use href="other.svg#m1"/></g>
 <image href="data:image/png;base64,AAAA"/><image href="http://a.example/x.png"/>
 <foreignObject><body xmlns="http://www.w3.org/1999/xhtml"><img src="x" onerror="alert(1)"/></body></foreignObject>
 <a href="javascript:alert(1)"><text onclick="alert(1)">a &lt;b&gt;</text></a><text>c &lt;d&gt;</text>
</svg>"""


def test_pictures_keep_what_draws_and_nothing_else():
    svg = ElementTree.fromstring(picture(SVG, "p", 'a "label" <x>'))[0]
    assert [element.tag for element in svg.iter()] == [
        *("svg", "defs", "path", "clipPath", "rect", "g", "use", "use", "image", "image", "text")
    ]
    values = [value for element in svg.iter() for value in element.attrib.values()]
    assert not [value for value in values if "example" in value or "alert" in value or "other" in value]
    assert {"p-m1", "p-c1", "url(#p-c1)", "#p-m1", "data:image/png;base64,AAAA", "0 0 20 10"} <= set(values)
    assert svg.attrib["aria-label"] == 'a "label" <x>'
    assert svg.findall("text")[0].text == "c <d>"


def test_text_that_is_no_picture_is_refused():
    for text in ("<svg", "<html/>", ""):
        with pytest.raises(ValueError, match="no SVG picture"):
            picture(text, "p", "")
