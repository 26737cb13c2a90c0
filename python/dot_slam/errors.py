# SPDX-FileCopyrightText: 2026 The dot authors
# SPDX-License-Identifier: MIT
"""What can go wrong. All of it is an `Error`; most of it is also the builtin exception that one would expect."""

import re


class Error(Exception):
    """Base of all errors of this package."""


class InvalidArgument(Error, ValueError):
    """An argument is wrong. Nothing was changed: the tracker goes on with the next frame.

    field: the argument, as the caller of this package calls it: "depth", "masks.instances[2].mask", "camera.fx",
    "velocity.keep" for an option; None if the text is about the call as a whole.
    """

    def __init__(self, field: "str | None", text: str) -> None:
        super().__init__(text)
        self.field = field

    def __reduce__(self) -> "tuple[type, tuple[str | None, str]]":  # so that it comes back from another process
        return type(self), (self.field, str(self))


class NoResult(Error, LookupError):
    """No frame was tracked yet, or none since a reset or an internal error."""


class Busy(Error, RuntimeError):
    """Another call on this tracker has not ended. Nothing was changed."""


class Closed(Error, ValueError):
    """The tracker was closed."""


class OutOfMemory(Error, MemoryError):
    """The tracker has been reset and can be used."""


class InternalError(Error, RuntimeError):
    """A fault of the library. The tracker has been reset and can be used."""


# The C library's names of fields, and what they are here.
_SETTING = re.compile(r"options\.settings\[\d+\]\.(?:value \(([^)]*)\)|name is unknown: (.*))")
_FIELD = re.compile(r"(?:(frame|options|policy)\.|(masks|camera|intrinsics|frame_id)\b)([\w.\[\]]*)")


def invalid(field: str, what: str) -> InvalidArgument:
    return InvalidArgument(field, f"{field} {what}")


def from_library(status: int, text: str) -> Error:
    """The exception for a status of dot.h, which is not DOT_OK, and the text that came with it."""
    if status == -1:
        return _invalid_argument(text)
    kinds = {-2: NoResult, -3: OutOfMemory, -5: Busy}
    return kinds.get(status, InternalError)(text)


def _invalid_argument(text: str) -> InvalidArgument:
    setting = _SETTING.match(text)
    if setting:
        name, unknown = setting.groups()
        if unknown is not None:
            unknown, _, field = unknown.partition("; set options.")  # one that the C library has as a field
            hint = f": use the argument {field.split()[0]}= of Tracker" if field else ""
            return InvalidArgument(unknown, f"options: there is no setting {unknown!r}{hint}")
        return InvalidArgument(name, f"options: {name}{text[setting.end():]}")
    field = _FIELD.match(text)
    if not field:
        return InvalidArgument(None, text)
    _, kept, rest = field.groups()
    prefix = {"intrinsics": "camera", None: ""}.get(kept, kept)
    name = (prefix + rest).rstrip(".")
    return InvalidArgument(name, name + text[field.end():])
