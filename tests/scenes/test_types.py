"""What a type checker reads: each public name, whose home mypy checks for its types."""

import ast
import inspect
from importlib.resources import files

import granular_fronts

PACKAGE = files("granular_fronts")


def test_the_stub_gives_each_public_name_from_its_module():
    assert PACKAGE.joinpath("py.typed").is_file()
    stub = ast.parse(PACKAGE.joinpath("__init__.pyi").read_text(encoding="utf-8"))
    homes = {
        name.asname: f"{statement.module}.{name.name}"
        for statement in stub.body
        if isinstance(statement, ast.ImportFrom)
        for name in statement.names
    }
    public = {name: getattr(granular_fronts, name) for name in granular_fronts.__all__}
    assert homes == {
        name: found.__name__
        if inspect.ismodule(found)
        else f"{found.__module__}.{found.__qualname__}"
        for name, found in public.items()
    }
