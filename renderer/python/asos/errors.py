"""Exceptions of the package asos.

Each has `subject`, the file, setting or object concerned, and `reason`, a text for a person.
"""


class Error(Exception):
    """A call of the renderer has failed."""

    def __init__(self, message: str, subject: str = "", reason: str = ""):
        super().__init__(message)
        self.subject = subject
        self.reason = reason


class InvalidArgument(Error, ValueError):
    """A value is out of range, or not finite."""


class CannotOpen(Error, OSError):
    """A file cannot be read, or is damaged."""


class CannotWrite(Error, OSError):
    """A file cannot be written."""


class Unsupported(Error):
    """The method cannot render this scene."""


class Cancelled(Error):
    """The caller asked for a stop."""


class OutOfMemory(Error, MemoryError):
    """There is not enough memory."""


# In the order of asos::api::ErrorCode.
_by_code = (InvalidArgument, CannotOpen, CannotWrite, Unsupported, Cancelled, OutOfMemory, Error)


def exception_of(code: int, subject: str, reason: str, message: str) -> Error:
    """Return the exception for an error of the library."""
    return _by_code[code](message, subject, reason)
