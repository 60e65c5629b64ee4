"""Tables as xarray datasets, and as netCDF by h5netcdf."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, TypeAlias

import numpy as np

from hertzwerk.runtime.output.tables.labelled_table import EXTRA, LabelledTable, Points
from hertzwerk.runtime.system.optional_packages import required

if TYPE_CHECKING:
    from xarray import Dataset

ABSENT = "missing"  # text of a place of a grid without a row
Variable: TypeAlias = tuple[tuple[str, ...], np.ndarray, dict[str, str]]
"""Dimensions, values and attributes."""


def dataset(table: LabelledTable) -> Dataset:
    """Return a dataset; its dimensions are the axes of the grid, or the index where there is none.

    Places of a grid without a row are nan, and "missing" in texts. Points of the rows have a dimension more, in which
    shorter rows are followed by nan: CF's contiguous ragged arrays, one after the other, would take the axes from them.
    """
    xarray = required("xarray", EXTRA)
    data: dict[str, Variable] = {
        name: (*_placed(table, column.values), column.about) for name, column in table.data.items()
    }
    axes: dict[str, Variable] = {
        name: ((name,), values, table.columns[name].about) for name, values in table.grid.items()
    }
    if not axes:
        index = table.columns[table.index]
        axes = {table.index: ((table.index,), index.values, index.about)}
        axes |= {name: data[name] for name in table.coordinates}
    for name, points in table.points.items():
        of_points = dict(_pointwise(table, name, points))
        axes |= {each: variable for each, variable in of_points.items() if variable[0] == (each,)}
        data |= of_points
    return xarray.Dataset({name: each for name, each in data.items() if name not in axes}, axes, dict(table.about))


def _placed(table: LabelledTable, values: np.ndarray) -> tuple[tuple[str, ...], np.ndarray]:
    """Return the dimensions and values (rows, ...) of a column, on the grid where there is one."""
    if not table.grid:
        return (table.index,), values
    shape = tuple(len(axis) for axis in table.grid.values())
    text = values.dtype.kind not in "fi"
    dtype = np.result_type(values.dtype, f"U{len(ABSENT)}") if text else np.dtype(float)
    placed: np.ndarray = np.full((int(np.prod(shape)), *values.shape[1:]), ABSENT if text else np.nan, dtype)
    placed[table.columns[table.index].values] = values
    return tuple(table.grid), placed.reshape(*shape, *values.shape[1:])


def _pointwise(table: LabelledTable, name: str, points: Points) -> Iterator[tuple[str, Variable]]:
    """Yield the histories at the points of all rows; times that all rows share are a coordinate."""
    longest = max(map(len, points.rows), default=0)
    padded = np.full((len(points.rows), longest, len(points.units)), np.nan)
    for row, values in zip(padded, points.rows, strict=True):
        row[: len(values)] = values
    (time, _), *_ = points.units.items()
    times = [values[:, 0] for values in points.rows if len(values)]
    shared = bool(times) and all(np.array_equal(each, times[0]) for each in times)
    way = f"{name}.{time}" if shared else f"{name}.point"
    for k, (each, unit) in enumerate(points.units.items()):
        about = {"units": unit or "1"}
        if shared and each == time:
            yield way, ((way,), times[0], about)
        else:
            axes, placed = _placed(table, padded[:, :, k])
            yield f"{name}.{each}", ((*axes, way), placed, about)


def netcdf(table: LabelledTable) -> bytes:
    """Return a netCDF file."""
    content = dataset(table)
    for name in ("h5netcdf", "h5py"):
        required(name, EXTRA)
    return bytes(content.to_netcdf(engine="h5netcdf"))
