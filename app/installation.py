"""What is installed, and what to do if that cannot work."""

from importlib.metadata import PackageNotFoundError, version

DISTRIBUTION = "laws-of-motion"


def installed(distribution: str) -> str | None:
    """The version of a package, or None if it is not installed."""
    try:
        return version(distribution)
    except PackageNotFoundError:
        return None


def own_version() -> str:
    """The version of this program; "not installed" if it runs from its sources."""
    return installed(DISTRIBUTION) or "not installed"


def pygame_trouble() -> str | None:
    """What is wrong with pygame, and the command that mends it; None if it is in order."""
    if installed("pygame") is not None:
        return (
            "pygame and pygame-ce overwrite each other's files, and both are installed: "
            "python -m pip uninstall -y pygame pygame-ce && python -m pip install pygame-ce"
            if installed("pygame-ce") is not None
            else "pygame is installed instead of pygame-ce: "
            "python -m pip uninstall -y pygame && python -m pip install pygame-ce"
        )
    if installed("pygame-ce") is None:
        return "pygame-ce is not installed: python -m pip install pygame-ce"
    return None


def extra_command(extra: str) -> str:
    """The command that installs an extra."""
    return f'python -m pip install "{DISTRIBUTION}[{extra}]"'
