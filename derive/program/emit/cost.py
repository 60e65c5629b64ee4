"""Cost of a program: arithmetic operations, counted in its text."""

from __future__ import annotations

import re
import textwrap

from hertzwerk.derive.program.emit.chain_helpers import CHAIN_HELPERS
from hertzwerk.derive.program.emit.curve_helpers import CURVE_HELPERS
from hertzwerk.derive.program.emit.helpers import HELPERS
from hertzwerk.derive.program.emit.printer import function_text
from hertzwerk.derive.program.program import Program

STAGES = 12  # stages of the default method
PER_STEP = {  # calls per step: in its stages; for events; to close loops, with two corrections of position and one of speeds
    **dict.fromkeys(("coordinate_rates", "applied", "accelerations", "ledger"), STAGES),
    **dict.fromkeys(("gaps", "gap_accelerations"), 1),
    **{"constraints": 4, "projection": 3},
}
OF_CURVES = (*CURVE_HELPERS, *CHAIN_HELPERS)
"""Helpers whose work depends on their curve."""
# A sign precedes its operand, which is no number here, without a blank; a binary minus is surrounded by blanks.
_SIGN = re.compile(r"-(?=[A-Za-z_(]|[\d.]+\*\*)")
_RUN = re.compile(r"\*\[([^\[\]]*)\]\*(\d+)")  # equal entries of a vector
_CALL = re.compile(r"\w\(")


def operations(text: str) -> int:
    """Count arithmetic operations and function calls in the text of a builder.

    Packing, unpacking and signs of numbers are not counted; a search along a curve counts as one call. Counting in the
    text is faster than having Python parse it.
    """
    code = " ".join("".join(text.split('"""')[::2]).split())
    code = _RUN.sub(lambda run: ", ".join([run[1]] * int(run[2])), code)
    if code.startswith("def "):
        code = code.partition(":")[2]
    spaced = sum(code.count(f" {sign} ") for sign in ("+", "-", "<", ">", "<=", ">="))
    products = code.count("*") - code.count("**") + code.count("/")
    calls = len(_CALL.findall(code)) - code.count("ca.vertcat(")
    whole = (name for name in HELPERS if name not in OF_CURVES and f"{name}(" in code)
    helpers = sum(code.count(f"{name}(") * (_helper_operations(name) - 1) for name in whole)
    return spaced + products + len(_SIGN.findall(code)) + calls + helpers


def operations_per_step(program: Program) -> int:
    """Operations per step of a run, by which coordinates "auto" are chosen.

    Those of PER_STEP, and the force of one pair in half of the stages: impacts are short, but steps in them are too,
    and seldom do two pairs touch at a time.
    """
    counts = {function.name: operations(function_text(program, function)) for function in program.functions}
    contacts = [count for name, count in counts.items() if name.startswith("contact_")]
    touching = STAGES // 2 * sum(contacts) // max(len(contacts), 1)
    return touching + sum(times * counts.get(name, 0) for name, times in PER_STEP.items())


def _helper_operations(name: str) -> int:
    """Operations of a helper, including the three iterations of a loop."""
    text = HELPERS[name]
    if "    for _" not in text:
        return operations(text)
    loop = text.index("    for _")
    body = "\n".join(line[4:] for line in text[loop:].splitlines()[1:-1])
    return operations("\n".join(text[:loop].splitlines()[:-1])) + 3 * operations(textwrap.dedent(body))
