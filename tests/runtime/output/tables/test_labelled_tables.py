"""Tables for other programs: pandas, pyarrow and xarray alone find every bit, unit and place of them, in memory and in files."""

import sys
from dataclasses import replace

import numpy as np
import pandas as pd
import pyarrow.parquet as pq
import pytest
import xarray as xr

from hertzwerk.derive.common.faults import InputError
from hertzwerk.runtime import Sweep, load, simulate, simulate_many, sweep
from hertzwerk.runtime.output.tables.history_meanings import meaning_of
from hertzwerk.runtime.output.tables.table_file import table_file_faults
from hertzwerk.runtime.studies.sweeps import sweep_table

QUICK = {"duration": "0.5 s", "tolerance": 1e-7, "workers": 1, "compiled": False}
OUTPUTS = ["floor.peak_force", "floor.impact_rate", "final.vertical.speed"]


@pytest.fixture(scope="module")
def ball():
    return load("bouncing_ball")


@pytest.fixture(scope="module")
def grid(ball):
    """3 x 2 rows, those of the negative mass without a run."""
    over = {"drop_height": "0.5..1 m:3", "mass": "0.1, -1 kg"}
    return sweep(ball, over, parameters={"radius": "25 mm"}, outputs=OUTPUTS, **QUICK)


@pytest.fixture(scope="module")
def pairs(ball):
    return sweep(ball, {"drop_height": "0.5..1 m:3", "mass": "0.1, 0.2, 0.3 kg"}, zip=True, outputs=OUTPUTS, **QUICK)


@pytest.fixture(scope="module")
def run(ball):
    return simulate(ball, duration="0.5 s", tolerance=1e-7, parameters={"mass": "50 g"})


def same(found, expected):
    """Compare bit by bit; of texts each."""
    found, expected = np.asarray(found), np.asarray(expected)
    if expected.dtype.kind == "U":
        return found.shape == expected.shape and bool(np.all(found.astype(str) == expected))
    return found.dtype == expected.dtype and found.shape == expected.shape and found.tobytes() == expected.tobytes()


def test_a_data_frame_has_every_column_with_its_unit(grid):
    frame = grid.to_pandas()
    assert tuple(frame.columns) == grid.names
    assert frame.index.name == "row"
    assert list(frame.index) == list(range(6))
    assert all(same(frame[name].to_numpy(), grid[name]) for name in grid.names)
    assert frame.attrs["units"]["floor.impact_rate.half_width"] == "1/s"
    assert frame.attrs["units"]["drop_height"] == "m"
    assert "outcome" not in frame.attrs["units"]
    assert frame.attrs["parameter.radius"] == "25.0 mm"


def test_a_grid_has_what_was_varied_as_dimensions(grid):
    actual = grid.to_xarray()
    assert dict(actual.sizes) == {"drop_height": 3, "mass": 2}
    assert actual["mass"].values.tolist() == [0.1, -1]
    assert actual["mass"].attrs["units"] == "kg"
    assert actual["floor.peak_force"].attrs["units"] == "N"
    for row in grid:
        at = actual.sel(drop_height=row["drop_height"], mass=row["mass"])
        assert all(same(at[name].values, np.asarray(row[name])) for name in OUTPUTS)
        assert at["outcome"].item() == row.outcome == ("finished" if row["mass"] > 0 else "bad_input")
        assert at["message"].item() == row.message
    assert actual.attrs["outcome"] == "finished"
    # Rows come as they are done: those that an interrupted sweep lacks are not the last.
    part = replace(grid, rows=(grid.rows[1], grid.rows[4]))
    actual = part.to_xarray()
    assert actual["outcome"].values.tolist() == [["missing", "bad_input"], ["missing"] * 2, ["finished", "missing"]]
    assert same(actual["floor.peak_force"].values[2, 0], grid["floor.peak_force"][4])
    assert np.isnan(actual["floor.peak_force"].values).sum() == 5


@pytest.mark.parametrize("kind", ["pairs", "samples", "sets"])
def test_no_grid_has_rows_with_coordinates(kind, pairs, ball):
    if kind == "pairs":
        table = pairs
    elif kind == "samples":
        table = sweep(ball, {"drop_height": "0.5..1 m", "mass": "1..2 kg"}, sample=2, outputs=OUTPUTS, **QUICK)
    else:
        table = simulate_many(ball, [{"drop_height": "1 m", "mass": "1 kg"}, {"drop_height": "1 m"}], **QUICK)
    actual = table.to_xarray()
    assert dict(actual.sizes) == {"row": len(table)}
    assert set(actual.coords) == {"row", "drop_height", "mass"}
    assert all(same(actual[name].values, table[name]) for name in table.names)


def test_a_stored_sweep_has_the_same_dimensions(ball, tmp_path):
    over = {"drop_height": "0.5, 1 m", "mass": "100, 200 g"}
    made = sweep(ball, over, outputs=["impacts"], out=tmp_path / "a", **QUICK)
    assert Sweep.load(tmp_path / "a").to_xarray().identical(made.to_xarray())
    assert made.to_xarray().sizes == {"drop_height": 2, "mass": 2}


def test_points_of_rows_have_a_dimension_of_their_own(ball, tmp_path):
    """Rows of other lengths, a row without a run, a place without a row; times that all rows share are a coordinate."""
    over = {"drop_height": "0.05, 0.2 m", "mass": "0.1, -1 kg"}
    how = {
        "section": "floor.gap = 0 m falling", "grid": "0.1 s", "duration": "1 s", "tolerance": 1e-7, "workers": 1,
        "compiled": False,
    }  # fmt: skip
    made = sweep(ball, over, outputs=["impacts"], **how)
    lengths = [len(t) for t in made.section["t"]]
    assert lengths[0] > lengths[2] > lengths[1] == lengths[3] == 0
    part = replace(made, rows=made.rows[:3])
    for actual in (part.to_xarray(), xr.load_dataset(part.to_file(tmp_path / "t.nc"), engine="h5netcdf")):
        assert dict(actual.sizes) == {"drop_height": 2, "mass": 2, "section.point": lengths[0], "histories.t": 11}
        for kind, arrays in (("section", made.section), ("histories", made.histories)):
            for name in arrays.units:
                if (kind, name) == ("histories", "t"):
                    assert same(actual["histories.t"].values, arrays["t"][0])
                    continue
                values = actual[f"{kind}.{name}"]
                assert values.dims == ("drop_height", "mass", "section.point" if kind == "section" else "histories.t")
                assert values.attrs["units"] == arrays.units[name]
                for i, points in enumerate(arrays[name][:3]):
                    at = values.values.reshape(4, -1)[i]
                    assert same(at[: len(points)], points) and np.isnan(at[len(points) :]).all()
                assert np.isnan(values.values[1, 1]).all()
    lists = pq.read_table(made.to_file(tmp_path / "t.parquet"))
    for kind, arrays in (("section", made.section), ("histories", made.histories)):
        for name, unit in arrays.units.items():
            assert lists.schema.field(f"{kind}.{name}").metadata[b"units"].decode() == (unit or "1")
            read = lists.column(f"{kind}.{name}").to_pylist()
            assert all(same(np.array(mine), points) for mine, points in zip(read, arrays[name], strict=True))


@pytest.mark.parametrize("name", ["grid", "pairs"])
def test_files_open_with_the_programs_they_are_for(name, request, tmp_path):
    table = request.getfixturevalue(name)
    file = table.to_file(tmp_path / "t.parquet")
    frame, plain = pd.read_parquet(file), pq.read_table(file)
    assert (frame.index.name, tuple(frame.columns)) == ("row", table.names)
    assert frame.attrs["units"] == table.to_pandas().attrs["units"]
    for column in table.names:
        assert same(frame[column].to_numpy(), table[column])
        unit = plain.schema.field(column).metadata
        assert (unit or {}).get(b"units") == (
            None if table[column].dtype.kind == "U" else table.unit(column).encode() or b"1"
        )
    peaks = plain.column("floor.peak_force")
    assert peaks.null_count == np.isnan(table["floor.peak_force"]).sum()  # null, which no mean takes for a number
    with xr.open_dataset(table.to_file(tmp_path / "t.nc"), engine="h5netcdf") as actual:
        assert actual.sizes == table.to_xarray().sizes
        flat = actual.stack(row=("drop_height", "mass")) if name == "grid" else actual
        assert all(same(flat[column].values, table[column]) for column in table.names)
        assert actual["final.vertical.speed"].attrs == {"units": "m/s", "long_name": "vertical.speed at the end"}
        assert actual["floor.peak_force"].attrs["long_name"] == "peak normal force of the contacts, of floor"
        assert actual.attrs == table.to_xarray().attrs


def test_histories_of_a_run_have_units_meanings_and_parameters(run, tmp_path):
    frame = run.to_pandas()
    assert same(frame.index.to_numpy(), run.t)
    assert all(same(frame[name].to_numpy(), run[name]) for name in run)
    assert frame.attrs["units"] == run.engine.history.units
    for actual in (run.to_xarray(), xr.load_dataset(run.to_file(tmp_path / "run.nc"), engine="h5netcdf")):
        assert same(actual["t"].values, run.t)
        assert all(same(actual[name].values, run[name]) for name in run)
        assert {name: actual[name].attrs["units"] for name in run} == {name: run.units[name] for name in run}
        assert actual["floor.penetration"].attrs["long_name"] == "penetration of the surfaces, of floor"
        assert actual.attrs["parameter.mass"] == "50.0 g"
        assert actual.attrs["outcome"] == run.outcome.name
    assert same(pd.read_parquet(run.to_file(tmp_path / "run.parquet")).to_numpy(), frame.to_numpy())


def test_every_kind_of_history_has_a_meaning_of_its_own():
    models = [load(name) for name in ("slider_crank", "ball_in_socket", "bricard", "journal_lubricated")]
    for model in models:
        found = simulate(model, duration=1e-6, tolerance=1e-3)
        meanings = [meaning_of(model.engine, name) for name in ("t", *found)]
        assert len(set(meanings)) == len(meanings)
    assert (
        meaning_of(models[0].engine, "slider_pin.eccentricity_y") == "eccentricity in the bush's axes, of slider_pin, y"
    )
    assert meaning_of(models[2].engine, "hinge_f.moment_y") == "moment that holds the closed loop of hinge_f, y"
    assert meaning_of(models[0].engine, "guide.acceleration") == "acceleration of guide"


@pytest.mark.parametrize(
    ("ending", "package"),
    [(".parquet", "pandas"), (".parquet", "pyarrow"), (".nc", "xarray"), (".nc", "h5netcdf"), (".nc", "h5py")],
)
def test_a_missing_extra_is_one_error_that_names_it(ending, package, pairs, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, package, None)
    with pytest.raises(InputError) as caught:
        pairs.to_file(tmp_path / f"t{ending}")
    (fault,) = caught.value.faults
    assert (fault.where, fault.remedy) == (package, "pip install 'hertzwerk[data]'")
    assert list(tmp_path.iterdir()) == []
    pairs.to_file(tmp_path / "t.csv")


@pytest.mark.parametrize("method", ["to_pandas", "to_xarray"])
def test_objects_of_a_missing_package_are_refused_too(method, pairs, run, monkeypatch):
    monkeypatch.setitem(sys.modules, method[3:], None)
    for table in (pairs, run):
        with pytest.raises(InputError, match=r"pip install 'hertzwerk\[data\]'"):
            getattr(table, method)()


def test_a_file_that_is_written_in_parts_is_that_of_the_whole(pairs, grid, tmp_path, monkeypatch):
    """Parts of two rows, the last one shorter or not: numbers, texts, lists, units; without the second part rows are missing."""
    for name, table in (("pairs", pairs), ("grid", grid)):
        whole = pq.read_table(table.to_file(tmp_path / f"{name}.parquet"))
        monkeypatch.setattr(sweep_table, "PART", 2)
        file = table.to_file(tmp_path / f"{name} in parts.parquet")
        assert pq.ParquetFile(file).num_row_groups == -(-len(table) // 2) > 1
        parts = pq.read_table(file)
        assert parts.schema.equals(whole.schema, check_metadata=True)
        pd.testing.assert_frame_equal(parts.to_pandas(), whole.to_pandas())
        assert len(next(iter(table._parts())).columns["row"].values) == 2 < len(parts)
        monkeypatch.undo()


def test_files_are_whole_and_every_fault_of_one_comes_at_once(tmp_path, pairs, monkeypatch):
    file = pairs.to_file(tmp_path / "t.parquet")
    with pytest.raises(InputError, match="which exists"):
        pairs.to_file(file)
    before = file.read_bytes()
    monkeypatch.setattr("os.fsync", lambda _: (_ for _ in ()).throw(OSError("full")))
    with pytest.raises(OSError, match="full"):
        pairs.to_file(file, overwrite=True)
    assert [path.name for path in tmp_path.iterdir()] == ["t.parquet"]
    assert file.read_bytes() == before
    (tmp_path / "t.xls").touch()
    actual = [fault.found for fault in table_file_faults(tmp_path / "t.xls")]
    assert actual == [str(tmp_path / "t.xls"), f"{tmp_path / 't.xls'}, which exists"]
    assert "which is a file" in table_file_faults(tmp_path / "t.xls" / "t.csv")[0].found


def test_the_error_of_a_run_is_the_one_that_was_requested(ball):
    """Along the way to rest it is larger than at the end."""
    whole, end = (
        simulate(ball, duration="2 s", accuracy=requested, compiled=False) for requested in (1e-3, "1e-3 at the end")
    )
    assert whole.to_xarray().attrs["error"] == whole.error.values.max() > whole.error.values[-1]
    assert end.to_xarray().attrs["error"] == max(end.error.values[-1], 1e-13) < end.error.values.max()
