"""The manifest of remesh_many(): a file of rows, one JSON object per line; of one input the last one counts."""
from __future__ import annotations

import json
import os
import pathlib
from typing import Any, Dict, Optional


class Manifest:
    """Rows by input. Each is in the file as soon as it is added; a line that a kill cut off is left out."""

    def __init__(self, path: pathlib.Path) -> None:
        self._path = path
        self._rows: Dict[str, Dict[str, Any]] = {}
        for line in path.read_text(encoding="utf-8").splitlines() if path.exists() else ():
            try:
                row = json.loads(line)
                self._rows[row["input"]] = row
            except (ValueError, KeyError, TypeError):
                continue
        part = path.with_suffix(".part")
        part.write_text("".join(json.dumps(row) + "\n" for row in self._rows.values()), encoding="utf-8")
        os.replace(part, path)
        self._file = path.open("a", encoding="utf-8")

    def __enter__(self) -> "Manifest":
        return self

    def __exit__(self, *_: Any) -> None:
        self._file.close()

    def row(self, name: str) -> Optional[Dict[str, Any]]:
        return self._rows.get(name)

    def add(self, row: Dict[str, Any]) -> None:
        self._rows[row["input"]] = row
        self._file.write(json.dumps(row) + "\n")
        self._file.flush()
