"""What a type checker reads: each public name, with the types of all its arguments."""

import ast
import inspect
from importlib.resources import files

import pytest

import granular_fronts

PACKAGE = files("granular_fronts")
pytest.importorskip("flint", reason="proofs are among the public names")


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


def functions_of(found):
    """A function itself; of a module or a class all that is public, and what makes instances."""
    if inspect.ismodule(found):
        return [getattr(found, name) for name in found.__all__]
    if not inspect.isclass(found):
        return [found]
    return [
        getattr(member, "fget", None) or getattr(member, "__func__", member)
        for name, member in vars(found).items()
        if name == "__init__" or not name.startswith("_")
        if callable(member) or isinstance(member, (property, classmethod))
    ]


@pytest.mark.parametrize("name", granular_fronts.__all__)
def test_public_functions_and_methods_are_annotated(name):
    for function in functions_of(getattr(granular_fronts, name)):
        signature = inspect.signature(function)
        types = [
            argument.annotation
            for argument in signature.parameters.values()
            if argument.name not in ("self", "cls")
        ]
        assert signature.empty not in [signature.return_annotation, *types], function
