"""The stubs name what the module has, and everything public has a docstring."""

import ast
import inspect
from pathlib import Path

from castaway import _castaway

import castaway

STUB = Path(castaway.__file__).with_name("_castaway.pyi")


def declared():
    """Names of the stub, those of classes as Class.name."""
    for node in ast.parse(STUB.read_text()).body:
        if isinstance(node, ast.ClassDef):
            yield node.name
            for member in node.body:
                if isinstance(member, ast.FunctionDef):
                    yield f"{node.name}.{member.name}"
                elif isinstance(member, ast.AnnAssign):
                    yield f"{node.name}.{member.target.id}"
        elif isinstance(node, ast.FunctionDef):
            yield node.name


def present():
    """The same of the module."""
    kept = {"__init__", "__iter__", "__next__", "__len__"}
    for name, value in vars(_castaway).items():
        if name.startswith("__"):
            continue
        yield name
        if inspect.isclass(value) and name != "Error":
            for member in vars(value):
                if not member.startswith("_") or member in kept:
                    yield f"{name}.{member}"


def test_stubs_are_complete():
    # pybind11 gives classes without a constructor one that raises.
    have = set(present())
    want = set(declared())
    assert want - have == set()
    assert {name for name in have - want if not name.endswith(".__init__")} == set()


def test_the_package_says_that_it_is_typed():
    assert Path(castaway.__file__).with_name("py.typed").exists()


def test_everything_public_has_a_docstring():
    for name in castaway.__all__:
        value = getattr(castaway, name)
        if inspect.isclass(value) or inspect.isroutine(value):
            assert inspect.getdoc(value), name
    for cls in (castaway.Localizer, castaway.MhAmcl, castaway.Run, castaway.Simulation):
        for name, member in inspect.getmembers(cls, inspect.isfunction):
            if not name.startswith("_"):
                assert inspect.getdoc(member), f"{cls.__name__}.{name}"


def test_all_names_what_can_be_imported():
    namespace = {}
    exec("from castaway import *", namespace)  # noqa: S102
    assert set(castaway.__all__) <= namespace.keys()
