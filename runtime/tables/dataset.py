"""Tables as xarray datasets, and as netCDF by h5netcdf."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from hertzwerk.runtime.host.extras import required
from hertzwerk.runtime.tables.labelled_table import EXTRA, Column, LabelledTable

if TYPE_CHECKING:
    from xarray import Dataset

ABSENT = "missing"  # text of a place of a grid without a row


def dataset(table: LabelledTable) -> Dataset:
    """Return a dataset; its dimensions are the axes of the grid, or the index where there is none.

    Places of a grid without a row are nan, and "missing" in texts.
    """
    xarray = required("xarray", EXTRA)
    if table.grid:
        axes = {name: ((name,), values, table.columns[name].about) for name, values in table.grid.items()}
        variables = {name: _on_grid(table, column) for name, column in table.data.items() if name not in axes}
        return xarray.Dataset(variables, axes, dict(table.about))
    variables = {name: ((table.index,), column.values, column.about) for name, column in table.columns.items()}
    where = {name: variables.pop(name) for name in (table.index, *table.coordinates)}
    return xarray.Dataset(variables, where, dict(table.about))


def _on_grid(table: LabelledTable, column: Column) -> tuple[tuple[str, ...], np.ndarray, Any]:
    """Return the dimensions, values and attributes of a column on the grid."""
    shape = tuple(len(values) for values in table.grid.values())
    values: np.ndarray = np.full(np.prod(shape), np.nan if column.unit is not None else ABSENT, dtype=object)
    values[table.columns[table.index].values] = column.values
    return tuple(table.grid), values.astype(float if column.unit is not None else str).reshape(shape), column.about


def netcdf(table: LabelledTable) -> bytes:
    """Return a netCDF file."""
    found = dataset(table)
    for name in ("h5netcdf", "h5py"):
        required(name, EXTRA)
    return bytes(found.to_netcdf(engine="h5netcdf"))
