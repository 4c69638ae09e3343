"""The stub says what the module has."""

import ast
import inspect
import pathlib

import ricochet
from ricochet import _core


def stub():
    path = pathlib.Path(ricochet.__file__).with_name("_core.pyi")
    return ast.parse(path.read_text())


def names_in(body):
    for node in body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            yield node.name
        elif isinstance(node, ast.AnnAssign):
            yield node.target.id
        elif isinstance(node, ast.Assign):
            yield node.targets[0].id


def public(names):
    return {name for name in names if not name.startswith("_") or name in ("__version__", "__len__", "__call__")}


def test_every_name_of_the_module_is_in_the_stub_and_no_other():
    assert public(names_in(stub().body)) == public(vars(_core))


def test_every_attribute_of_every_class_is_in_the_stub_and_no_other():
    inherited = {"name", "units", "parameters"}
    for node in stub().body:
        if isinstance(node, ast.ClassDef) and node.name != "_Law" and node.name != "NotConverged":
            said = public(names_in(node.body)) - {"__init__"}
            if any(getattr(base, "id", "") == "_Law" for base in node.bases):
                said |= inherited
            assert said == public(vars(getattr(_core, node.name))), node.name


def test_every_public_function_has_a_docstring():
    for name, thing in vars(ricochet).items():
        if not name.startswith("_") and inspect.isfunction(thing):
            assert thing.__doc__, name


def test_the_version_is_that_of_the_project():
    text = (pathlib.Path(__file__).resolve().parents[2] / "CMakeLists.txt").read_text()
    assert f"VERSION {ricochet.__version__} " in text


def test_a_star_import_brings_what_is_ours_alone():
    assert not {"np", "Any", "dataclass", "DirectCalibrator"} & set(ricochet.__all__)
    assert {"calibrate", "collide", "Cluster", "Linear", "law_names", "NotConverged"} <= set(ricochet.__all__)
