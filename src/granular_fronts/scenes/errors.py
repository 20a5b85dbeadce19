"""The error of an input that cannot be computed."""

import sys
from collections.abc import Iterator
from contextlib import contextmanager


class ConfigurationError(ValueError):
    """A configuration or a scene that cannot be computed; the message is for people."""


@contextmanager
def exit_on_error(heading: str) -> Iterator[None]:
    """End the program with a heading and the sentences of a ConfigurationError, if one is raised.

    Parameters
    ----------
    heading : str
        A sentence, for example ``The configuration cannot be computed.``
    """
    try:
        yield
    except ConfigurationError as error:
        sys.exit(f"{heading}\n{error}")
