# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""Single numbers as the C library takes them. ctypes would cut off what does not fit."""

from __future__ import annotations

from typing import Any

import numpy as np

from .errors import invalid


def number(value: Any, field: str) -> float:
    """Text is none, even where it could be read as one."""
    if isinstance(value, (str, bytes)):
        raise invalid(field, f"is {value!r}, must be a number")
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise invalid(field, f"is {value!r}, must be a number") from None


def in_range(value: Any, low: float, high: float, field: str) -> float:
    result = number(value, field)
    if not low <= result <= high:  # NaN neither
        raise invalid(field, f"is {value!r}, must be {low:g} to {high:g}")
    return result


def whole(value: Any, low: int, high: int, field: str) -> int:
    if not isinstance(value, (int, np.integer)) or not low <= int(value) <= high:
        raise invalid(field, f"is {value!r}, must be a whole number from {low} to {high}")
    return int(value)
