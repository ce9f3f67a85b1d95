"""Where a run keeps what is done: parts as they come, and the results in the order of the input. On a disk that all workers see.

A file has its name only when it is whole: it is written beside under another name and renamed. A part is named by the keys that are
in it, so that a task which runs twice writes the same bytes to the same name.
"""

from __future__ import annotations

import hashlib
import json
import os
import time
import uuid
from collections.abc import Callable, Iterator

import pyarrow as pa
import pyarrow.parquet as pq
from pyarrow import fs

from .._errors import DriftpostError

ROWS_A_FILE = 1000
LEFT_S = 3600
"""A file that is unfinished and was not written to for so long belongs to no run."""


class Store:
    """The folder of results: ``parts/``, ``results/``, ``run.json``. A path, or an address that ``pyarrow.fs`` knows."""

    def __init__(self, place: str):
        self.place = place
        try:
            self.fs, self.root = fs.FileSystem.from_uri(place if "://" in place else os.path.abspath(place))
        except (pa.ArrowException, OSError) as error:
            raise DriftpostError(f"{place}: {error}", "output::unwritable") from None

    def prepare(self) -> None:
        """Makes the folder; what an interrupted run left unfinished is cleared away."""
        try:
            self.fs.create_dir(f"{self.root}/parts", recursive=True)
            for name in self._names("parts"):
                if not name.startswith("part-") and self._is_left(f"parts/{name}"):
                    self.fs.delete_file(f"{self.root}/parts/{name}")
            if self.fs.get_file_info(f"{self.root}/run.json").type != fs.FileType.NotFound:
                self.fs.delete_file(f"{self.root}/run.json")
        except OSError as error:
            raise DriftpostError(f"{self.place}: {error}", "output::unwritable") from None

    def _is_left(self, name: str) -> bool:
        """Whether nobody writes to a file any more: another run may be at work here."""
        info = self.fs.get_file_info(f"{self.root}/{name}")
        return info.mtime_ns is not None and time.time_ns() - info.mtime_ns > LEFT_S * 1_000_000_000

    def write_part(self, table: pa.Table) -> str:
        """Writes rows of results under the name that their keys give; the name."""
        keys = "".join(table["key"].to_pylist())
        name = f"part-{hashlib.sha256(keys.encode()).hexdigest()[:40]}.parquet"
        self.write(f"parts/{name}", lambda file: pq.write_table(table.combine_chunks(), file, compression="zstd"))
        return name

    def index(self) -> dict[str, tuple[str, int]]:
        """Part and row of every key that is done. A part that cannot be read counts as not there."""
        found = {}
        for name in self._names("parts"):
            if not name.startswith("part-"):
                continue
            try:
                keys = pq.read_table(f"{self.root}/parts/{name}", columns=["key"], filesystem=self.fs, partitioning=None)["key"].to_pylist()
            except (pa.ArrowException, OSError):
                continue
            found.update({key: (name, row) for row, key in enumerate(keys)})
        return found

    def collect(self, keys: list[str], index: dict[str, tuple[str, int]], absent: Callable[[str], dict], schema: pa.Schema,
                figures: Callable[[pa.Table], None]) -> dict[str, str]:
        """Writes the rows of ``keys`` in this order as files of 1,000 rows; SHA-256 of each file by its name.

        absent makes the row of a key that no part has; figures is shown each file's rows. Only one file's rows are held at a time.
        """
        self.fs.create_dir(f"{self.root}/results", recursive=True)
        written = {}
        for number, start in enumerate(range(0, max(len(keys), 1), ROWS_A_FILE)):
            table = self._rows(keys[start:start + ROWS_A_FILE], index, absent, schema)
            figures(table)
            sink = pa.BufferOutputStream()
            pq.write_table(table, sink, compression="zstd")
            whole = sink.getvalue()
            name = f"results-{number:05d}.parquet"
            self.write(f"results/{name}", lambda file, whole=whole: file.write(whole))
            written[name] = hashlib.sha256(whole).hexdigest()
        for name in self._names("results"):
            if name not in written:
                self.fs.delete_file(f"{self.root}/results/{name}")
        return written

    def results(self) -> Iterator[pa.Table]:
        """The results, file by file."""
        for name in self._names("results"):
            yield pq.read_table(f"{self.root}/results/{name}", filesystem=self.fs, partitioning=None)

    def finish(self, record: dict) -> None:
        """Writes ``run.json``: where it stands, the results are whole."""
        self.write_text("run.json", json.dumps(record, indent=1) + "\n")

    def write_text(self, name: str, text: str) -> None:
        self.write(name, lambda file: file.write(text.encode("utf-8", "replace")))

    def _rows(self, keys: list[str], index: dict, absent: Callable[[str], dict], schema: pa.Schema) -> pa.Table:
        """The rows of ``keys``; each part is read once, as the parts follow the input's order closely."""
        wanted: dict[str, list[tuple[int, int]]] = {}
        pieces, order = [], []
        for place, key in enumerate(keys):
            if key in index:
                part, row = index[key]
                wanted.setdefault(part, []).append((place, row))
            else:
                pieces.append(pa.Table.from_pylist([absent(key)], schema))
                order.append(place)
        for part, places in wanted.items():
            try:
                held = pq.read_table(f"{self.root}/parts/{part}", filesystem=self.fs, partitioning=None).cast(schema)
            except (pa.ArrowException, OSError) as error:
                raise DriftpostError(f"{self.place}/parts/{part} is damaged: {error}", "fleet::damaged-part",
                                     "Take the file away and run again: its rows are done anew.") from None
            pieces.append(held.take([row for _, row in places]))
            order.extend(place for place, _ in places)
        if not pieces:
            return schema.empty_table()
        back = sorted(range(len(order)), key=order.__getitem__)
        return pa.concat_tables(pieces).take(back).combine_chunks()

    def _names(self, folder: str) -> list[str]:
        chosen = fs.FileSelector(f"{self.root}/{folder}", allow_not_found=True)
        return sorted(info.base_name for info in self.fs.get_file_info(chosen) if info.is_file)

    def write(self, name: str, write: Callable) -> None:
        """Has ``write`` write a file, which has its name when it is whole."""
        folder, _, base = f"{self.root}/{name}".rpartition("/")
        beside = f"{folder}/unfinished-{uuid.uuid4().hex}-{base}"
        try:
            with self.fs.open_output_stream(beside) as file:
                write(file)
            self.fs.move(beside, f"{folder}/{base}")
        except OSError as error:
            raise DriftpostError(f"{self.place}/{name}: {error}", "output::unwritable") from None
