# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of the examples: saved into the folder after --pictures, left out without it."""

from __future__ import annotations

import contextlib
import sys
from pathlib import Path
from typing import Any, Iterator


class _Nothing:
    """Takes every call and draws nothing."""

    def __getattr__(self, name: str) -> Any:
        return self

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        return self

    def __iter__(self) -> Iterator[Any]:
        return iter([self, self])


@contextlib.contextmanager
def figure(name: str, width_px: int = 720, height_px: int = 400) -> Iterator[Any]:
    """Give a figure of matplotlib, and save it as NAME.png afterwards."""
    folder = Path(sys.argv[sys.argv.index("--pictures") + 1]) if "--pictures" in sys.argv else None
    try:
        import matplotlib

        matplotlib.use("Agg")
        from matplotlib.figure import Figure
    except ImportError:
        print("picture skipped: it needs python3-matplotlib")
        yield _Nothing()
        return
    made = Figure(figsize=(width_px / 100.0, height_px / 100.0), dpi=100, layout="constrained")
    yield made
    if folder is not None:
        folder.mkdir(parents=True, exist_ok=True)
        made.savefig(folder / f"{name}.png", metadata={"Software": None})
