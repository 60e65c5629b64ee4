"""Pages looked into: well-formed nesting, tables by heading, and what a real browser finds."""

import base64
import hashlib
import json
import re
import shutil
import subprocess
from html import unescape
from html.parser import HTMLParser

BROWSER = shutil.which("chromium") or shutil.which("chromium-browser")
VOID = ("meta", "br", "col", "img", "link", "wbr")
# px: of a window of 1280; of A4 within its margins, and the padding that a page has on screens alone
WIDTHS = (1232, 736)

LISTENING = """
window.violations = [];
document.addEventListener("securitypolicyviolation", (e) => violations.push(e.violatedDirective + " " + e.blockedURI));
"""
PROBE = """
addEventListener("load", () => {
const named = (e) => e.tagName + "." + (e.getAttribute("class") || "") + ": " + e.textContent.trim().slice(0, 60);
const cut = [];
for (const width of WIDTHS) {
  document.documentElement.style.width = width + "px";
  const right = document.documentElement.getBoundingClientRect().right;
  // what overflows in MathML may be space that nobody sees: there letters count
  for (const e of document.body.querySelectorAll(":not(svg *):not(math, math *), mi, mn, mo, mtext")) {
    const box = e.getBoundingClientRect(), around = e.parentElement.getBoundingClientRect();
    const block = !["SUP", "SPAN", "A", "CODE", "BUTTON", "SCRIPT", "mi", "mn", "mo", "mtext"].includes(e.tagName);
    if (box.width && (box.right > right + 1 || (block && box.right > around.right + 1)
        || (block && !e.querySelector("math") && e.clientWidth && e.scrollWidth > e.clientWidth + 1)))
      cut.push(`${width} ${Math.round(box.right - right)} ${named(e)}`);
  }
}
const column = (table, j) => [...table.tBodies[0].rows].map((row) => row.cells[j].textContent);
const sorted = {};
for (const table of document.querySelectorAll("table.sortable")) {
  [...table.tHead.rows[0].cells].forEach((head, j) => {
    const key = table.closest("section").querySelector("h2").textContent + "/" + head.textContent.trim();
    if (key in sorted) return;
    const button = head.querySelector("button");
    if (!button) { sorted[key] = null; return; }
    const before = column(table, j);
    button.click();
    const up = column(table, j);
    button.click();
    sorted[key] = [before, up, column(table, j)];
  });
}
const found = document.createElement("pre");
found.id = "found";
found.textContent = JSON.stringify({
  cut, sorted, violations, alerted: window.alerted || 0,
  fetched: performance.getEntriesByType("resource").map((entry) => entry.name),
});
document.body.append(found);
});
"""


def seen(html, folder):
    """What a browser finds on a page under its own policy: elements cut, columns sorted, what it tried to fetch."""
    scripts = [LISTENING, f"const WIDTHS = {list(WIDTHS)};{PROBE}"]
    hashes = [base64.b64encode(hashlib.sha256(script.encode()).digest()).decode() for script in scripts]
    allowed = " ".join(["script-src", *(f"&#x27;sha256-{digest}&#x27;" for digest in hashes)])
    assert html.count("script-src") == 1
    html = html.replace("script-src", allowed).replace("<title>", f"<script>{scripts[0]}</script><title>")
    page = folder / "probed.html"
    page.write_text(html.replace("</body>", f"<script>{scripts[1]}</script></body>"), encoding="utf-8")
    off = ("quic", "background-networking", "component-update", "sync", "gpu")
    quiet = ["--no-first-run", "--no-sandbox", *(f"--disable-{what}" for what in off)]
    done = subprocess.run(
        [BROWSER, "--headless", *quiet, f"--user-data-dir={folder / 'profile'}",
         "--window-size=1280,2000", "--dump-dom", page.as_uri()],
        capture_output=True, text=True, timeout=300, check=True,
    )  # fmt: skip
    return json.loads(unescape(re.search(r'<pre id="found">(.*?)</pre>', done.stdout, re.DOTALL)[1]))


class Outline(HTMLParser):
    """Reader of a page that refuses what is not nested; texts by element, tables by the heading above them."""

    def __init__(self, html):
        super().__init__()
        self.open, self.texts, self.tables, self.ids, self.references, self.heading = [], {}, {}, [], [], ""
        self.feed(html)
        self.close()
        assert self.open == []

    def handle_starttag(self, tag, attributes):
        if tag not in VOID:
            self.open.append(tag)
            self.texts.setdefault(tag, []).append("")
        given = dict(attributes)
        assert not [name for name in given if name.startswith("on")]
        self.ids += [given["id"]] if "id" in given else []
        self.references += [given[name] for name in ("src", "href", "xlink:href") if name in given]
        self.references += re.findall(r"url\(([^)]*)\)", " ".join(filter(None, given.values())))
        if tag == "table":
            self.tables.setdefault(self.heading, []).append([])
        elif tag == "tr" and "table" in self.open:
            self.tables[self.heading][-1].append([])
        elif tag in ("td", "th"):
            self.tables[self.heading][-1][-1].append("")

    def handle_startendtag(self, tag, attributes):
        self.handle_starttag(tag, attributes)
        self.handle_endtag(tag)

    def handle_endtag(self, tag):
        assert self.open.pop() == tag
        if tag == "h2":
            self.heading = self.texts["h2"][-1]

    def handle_data(self, text):
        for tag in set(self.open):
            self.texts[tag][-1] += text
        if {"td", "th"} & set(self.open):
            self.tables[self.heading][-1][-1][-1] += text
