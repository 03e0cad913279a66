# SPDX-License-Identifier: GPL-3.0-or-later
"""Types that annotations name."""

from __future__ import annotations

import os
from typing import Any, Callable, Dict, Optional, Union

import numpy as np
import numpy.typing as npt

#: One row a frame or contact: equally long one-dimensional arrays by the name of their column.
Table = Dict[str, npt.NDArray[Any]]
Floats = npt.NDArray[np.float64]
Path = Union[str, "os.PathLike[str]"]
Progress = Optional[Callable[[float, float], object]]
