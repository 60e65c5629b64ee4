"""A generated module as a product: the format and digest that it states, and what is refused."""

import importlib.util
import shutil
from pathlib import Path
from types import SimpleNamespace

import pytest
from each import each

from hertzwerk import InputError, simulate
from hertzwerk.derive import GROUND, Body, Mechanism, Parameter, Prismatic, Scales, Scene, Y, generate
from hertzwerk.derive.common.module_format import EMPTY, FORMAT, is_generated, require_intact, sealed
from hertzwerk.generated import pendulum
from hertzwerk.runtime.engine.model.generated_text import module_of
from hertzwerk.runtime.engine.model.model import EngineModel
from hertzwerk.runtime.engine.model.regenerate import generated_names
from hertzwerk.runtime.engine.solution import saved_run
from hertzwerk.runtime.engine.solution.solution import EngineSolution
from hertzwerk.runtime.loading import engine_model

TEXT = Path(pendulum.__file__).read_text(encoding="utf-8")
ALTERED = {
    "a number": ("9.81", "9.80"), "a table": ("UNCHECKED = CONTRADICTIONS =", "UNCHECKED ="),
    "the last line": ("\n\n\ndef landmarks", "\n\n\n\ndef landmarks"), "its digest": ('DIGEST = "', 'DIGEST = "0'),
    "no digest": ('DIGEST = "', 'DIGESTS = "'),
}  # fmt: skip


def imported(path):
    spec = importlib.util.spec_from_file_location(path.stem, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


@each("name", generated_names())
def test_every_module_states_its_format_and_all_tables(name):
    module = engine_model(name).module
    assert module.FORMAT == FORMAT
    assert [table for table in EMPTY if not hasattr(module, table)] == []


@pytest.mark.parametrize("what", ALTERED)
def test_a_text_that_is_not_as_it_was_written_is_refused_with_the_command_that_regenerates_it(what, tmp_path):
    text = TEXT.replace(*ALTERED[what])
    assert text != TEXT
    assert is_generated(text)
    with pytest.raises(InputError, match=r"does not fit its digest(.|\n)*hertzwerk derive pendulum$"):
        module_of("pendulum", text)
    file = tmp_path / "pendulum.py"
    file.write_text(text)
    with pytest.raises(InputError, match="does not fit its digest"):
        EngineModel(imported(file))


def test_a_module_as_it_was_written_is_not_refused(tmp_path):
    file = Path(shutil.copy(pendulum.__file__, tmp_path))
    assert EngineModel(imported(file)).name == "pendulum"
    file.write_bytes(TEXT.replace("\n", "\r\n").encode())  # as Git checks it out on Windows
    require_intact(file.read_text(encoding="utf-8"), "pendulum")


@pytest.mark.parametrize(
    ("old", "new", "found"),
    [
        (f'FORMAT = "{FORMAT}"', 'FORMAT = "hertzwerk module 0"', "in the format 'hertzwerk module 0'"),
        (f'FORMAT = "{FORMAT}"\n', "", "without a format"),
    ],
)
def test_a_module_of_another_format_is_refused(old, new, found):
    text = sealed(TEXT.replace(old, new))
    assert is_generated(text)
    with pytest.raises(
        InputError, match=rf"{found}(.|\n)*expected 'hertzwerk module 1'(.|\n)*hertzwerk derive pendulum"
    ):
        module_of("pendulum", text)


def test_no_table_is_taken_for_empty_where_it_is_missing():
    tables = {name: value for name, value in vars(pendulum).items() if not name.startswith("__")}
    assert EngineModel(SimpleNamespace(**tables)).slips == ()
    for name in EMPTY:
        with pytest.raises(InputError, match=f"without {name}"):
            EngineModel(SimpleNamespace(**{table: rows for table, rows in tables.items() if table != name}))


def test_a_saved_run_with_tables_of_another_format_is_refused(tmp_path, monkeypatch):
    run = simulate(engine_model("pendulum"), duration="1 ms", tolerance=1e-6)
    now = run.save(tmp_path / "now.npz")
    assert EngineSolution.load(now).engine.model.slips == ()
    for form in ("hertzwerk module 0", None):
        pack = saved_run.packed

        def older(about, histories, form=form, pack=pack):
            tables = {name: rows for name, rows in about["scene"].items() if name not in ("FORMAT", "SLIPS")}
            return pack({**about, "scene": tables | ({"FORMAT": form} if form else {})}, histories)

        monkeypatch.setattr(saved_run, "packed", older)
        file = run.save(tmp_path / f"{form}.npz")
        monkeypatch.undo()
        with pytest.raises(InputError, match=f"tables in the format {form!r}"):
            EngineSolution.load(file)


def test_a_scene_without_a_summary_has_a_title_without_a_gap():
    body = Body("ball", mass=Parameter("mass", "kg", 1))
    scales = Scales(length=Parameter("size", "m", 1), speed=Parameter("speed_scale", "m/s", 1))
    scene = Scene(Mechanism("drop", joints=(Prismatic("vertical", GROUND, body, axis=Y),)), (), scales)
    assert generate(scene).startswith('"""drop. Generated from a scene.\n')
