"""Tables as pandas data frames, and as Parquet with units and meanings in its metadata."""

from __future__ import annotations

import io
import json
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Any

from hertzwerk.runtime.output.tables.labelled_table import EXTRA, LabelledTable
from hertzwerk.runtime.system.optional_packages import required

if TYPE_CHECKING:
    from pandas import DataFrame


def data_frame(table: LabelledTable) -> DataFrame:
    """Return a data frame, its index the table's; units, meanings and the rest are its `attrs`."""
    pandas = required("pandas", EXTRA)
    frame = pandas.DataFrame(
        {name: column.values for name, column in table.data.items()},
        index=pandas.Index(table.columns[table.index].values, name=table.index),
    )
    about = {name: column.about for name, column in table.columns.items()}
    for kind in ("units", "long_name"):
        attributes = {name: entries[kind] for name, entries in about.items() if kind in entries}
        frame.attrs |= {kind: attributes} if attributes else {}
    frame.attrs |= table.about
    return frame


def parquet(parts: Iterable[LabelledTable]) -> Iterator[bytes]:
    """Yield the Parquet file of a table as its parts are made.

    Every field has its unit and meaning as metadata; nan is null. Points of the rows are columns of lists.
    """
    writer, file = None, _Parts()
    for part in parts:
        table = _arrow(part)
        if writer is None:
            writer = required("pyarrow.parquet", EXTRA).ParquetWriter(file, table.schema)
        writer.write_table(table.cast(writer.schema))
        yield file.taken()
    if writer is not None:
        writer.close()
    yield file.taken()


class _Parts(io.RawIOBase):
    """File whose content is taken as it is written."""

    def __init__(self) -> None:
        self._content, self._begin = io.BytesIO(), 0

    def writable(self) -> bool:
        return True

    def tell(self) -> int:
        return self._begin + self._content.tell()

    def write(self, content: Any) -> int:
        return self._content.write(content)

    def taken(self) -> bytes:
        """Return what was written since the last call."""
        content = self._content.getvalue()
        self._content, self._begin = io.BytesIO(), self.tell()
        return content


def _arrow(table: LabelledTable) -> Any:
    arrow = required("pyarrow", EXTRA)
    frame = data_frame(table)
    plain = arrow.Table.from_pandas(frame, preserve_index=True)
    about = {**plain.schema.metadata, b"PANDAS_ATTRS": json.dumps(frame.attrs).encode()}  # as pandas itself writes them
    fields = [field.with_metadata(table.columns[field.name].about) for field in plain.schema]
    written = plain.cast(arrow.schema(fields, about))
    for name, points in table.points.items():
        for k, (each, unit) in enumerate(points.units.items()):
            lists = arrow.array([row[:, k].tolist() for row in points.rows], arrow.list_(arrow.float64()))
            field = arrow.field(f"{name}.{each}", lists.type, metadata={"units": unit or "1"})
            written = written.append_column(field, lists)
    return written
