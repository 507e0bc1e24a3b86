"""remesh_many(): see its docstring."""


def remesh_many() -> None:
    """Not there yet."""
