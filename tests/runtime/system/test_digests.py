"""Records that are read back: no flipped bit changes what they say."""

import json

import pytest
from commands import called

from hertzwerk.runtime.cli.page_folder import REQUEST, ROWS
from hertzwerk.runtime.system import digests
from hertzwerk.runtime.system.digests import record_text

RECORD = {"values": {"restitution": 0.1 + 0.2}, "names": ("a",), "none": None, "nan": float("nan")}
RECORD |= {"by_number": {9: 1, 10: 2}}


def test_a_flipped_bit_is_refused_or_changes_nothing(tmp_path):
    file, content = tmp_path / "record.json", record_text(RECORD).encode()
    file.write_bytes(content)
    whole = digests.read_sealed(file)
    assert whole["values"] == RECORD["values"]
    refused = 0
    bits = range(0, 8 * len(content), 5)  # of every byte some
    for i in bits:
        flipped = bytearray(content)
        flipped[i // 8] ^= 1 << i % 8
        file.write_bytes(flipped)
        try:
            assert digests.read_sealed(file) == whole, i
        except ValueError:
            refused += 1
    assert refused > 0.9 * len(bits)


OUTPUT = ("--output", "final.vertical.speed")


@pytest.mark.parametrize(
    ("file", "arguments"),
    [
        ("fit.json", ("propagate", "bouncing_ball", *OUTPUT, "--duration", "0.1 s", "--fitted")),
        ("run.json", ("run", "--duration", "1 s", "--continue")), (f"{ROWS}/{REQUEST}", ("study", "--resume")), ("study.json", ("report",)),
        ("propagation.json", ("report",)),
    ],
)  # fmt: skip
def test_damaged_records_are_refused(tmp_path, file, arguments):
    (tmp_path / file).parent.mkdir(exist_ok=True)
    content = {"distribution": {"names": ["mass"]}, "request": {"target": "bouncing_ball"}, "name": "bouncing"}
    (tmp_path / file).write_text(json.dumps({**digests.sealed(content), "name": "exponents"}))
    assert "digest does not fit" in " ".join(called(*arguments, tmp_path, code=2).output.split())
