"""The error of an input that cannot be computed."""


class ConfigurationError(ValueError):
    """A configuration or a scene that cannot be computed; the message is for people."""
