"""CSV, Parquet and netCDF files of tables, by their endings; checked before anything is computed."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from pathlib import Path

from hertzwerk.derive.common.faults import Fault, as_path, refuse
from hertzwerk.runtime.output.tables.data_frame import parquet
from hertzwerk.runtime.output.tables.dataset import netcdf
from hertzwerk.runtime.output.tables.labelled_table import EXTRA, LabelledTable
from hertzwerk.runtime.system.atomic_files import write_atomically
from hertzwerk.runtime.system.optional_packages import missing_of
from hertzwerk.runtime.system.result_folder import new_file_faults

CSV = ".csv"
PACKAGES = {CSV: (), ".parquet": ("pandas", "pyarrow"), ".nc": ("xarray", "h5netcdf", "h5py")}  # by ending


def table_file_faults(path: Path, *, overwrite: bool = False) -> list[Fault]:
    """Return the faults of a file for a table: its ending, missing packages, one that exists, its folder."""
    ending = path.suffix.lower()
    faults = missing_of(EXTRA, *PACKAGES.get(ending, ()))
    if ending not in PACKAGES:
        faults.append(Fault("table", str(path), f"a name that ends with {', '.join(PACKAGES)}"))
    return faults + new_file_faults("table", path, "name another, or overwrite it", overwrite=overwrite)


def write_table(
    path: str | Path,
    table: Callable[[], LabelledTable],
    csv: Callable[[], bytes | Iterable[bytes]],
    parts: Callable[[], Iterable[LabelledTable]] | None = None,
    *,
    overwrite: bool = False,
) -> Path:
    """Write a table by the ending of its file, whole or not at all.

    parts    makes the table some rows at a time, where they are many

    Raises InputError with every fault, OSError.
    """
    path = as_path("path", path)
    refuse("table", table_file_faults(path, overwrite=overwrite))
    ending = path.suffix.lower()
    content: bytes | Iterable[bytes]
    content = (
        csv()
        if ending == CSV
        else parquet([table()] if parts is None else parts())
        if ending == ".parquet"
        else netcdf(table())
    )
    write_atomically(path, content)
    return path
