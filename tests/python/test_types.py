"""The stub says what the module has."""

import ast
import inspect
import os
import pathlib
import subprocess
import sys

import pytest

import ricochet
from ricochet import _core

root = pathlib.Path(__file__).resolve().parents[2]
package = pathlib.Path(ricochet.__file__).parent


def stub():
    return ast.parse((package / "_core.pyi").read_text())


def names_in(body):
    for node in body:
        if isinstance(node, (ast.ClassDef, ast.FunctionDef)):
            yield node.name
        elif isinstance(node, ast.AnnAssign):
            yield node.target.id
        elif isinstance(node, ast.Assign):
            yield node.targets[0].id


def public(names):
    seen = ("__version__", "__len__", "__call__")
    # What pybind11 adds from 2.13 on is its own.
    ours = {name for name in names if not name.startswith("_pybind11_")}
    return {name for name in ours if not name.startswith("__") or name in seen} - {"_Law"}


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
    text = (root / "CMakeLists.txt").read_text()
    assert f"VERSION {ricochet.__version__} " in text


def test_a_star_import_brings_what_is_ours_alone():
    assert not {"np", "Any", "dataclass", "DirectCalibrator"} & set(ricochet.__all__)
    assert {"calibrate", "collide", "Cluster", "Linear", "law_names", "NotConverged"} <= set(ricochet.__all__)


def mypy(module, *arguments, tmp_path):
    """What mypy, or what comes with it, has to say: nothing, if all is well."""
    pytest.importorskip("mypy", reason="mypy is not installed")
    command = [sys.executable, "-m", module, *arguments]
    environment = {**os.environ, "MYPYPATH": str(package.parent), "MYPY_CACHE_DIR": str(tmp_path)}
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True, check=False)
    return "" if done.returncode == 0 else done.stdout + done.stderr


def test_mypy_finds_the_stub_to_be_what_the_module_is(tmp_path):
    # Of a class of pybind11 it knows neither the metaclass nor what its constructor takes.
    allowed = tmp_path / "allowed"
    allowed.write_text("ricochet\\._core\\.\\w+\nricochet\\._core\\.\\w+\\.__init__\n")
    options = ("--allowlist", str(allowed), "--ignore-unused-allowlist")
    assert mypy("mypy.stubtest", "ricochet._core", *options, tmp_path=tmp_path) == ""


def test_mypy_finds_no_fault_with_the_package_and_its_examples(tmp_path):
    examples = [str(path) for path in sorted((root / "examples/python").glob("*.py"))]
    assert mypy("mypy", "--strict", str(package), tmp_path=tmp_path) == ""
    assert mypy("mypy", *examples, tmp_path=tmp_path) == ""


TYPED = """
from typing import Dict, Optional
import numpy as np
from numpy.typing import NDArray
import ricochet
from ricochet import Collision, FractionalContact

Array = NDArray[np.float64]
number: float = ricochet.mittag_leffler(1.5, 2.0, -3.0)
numbers: Array = ricochet.mittag_leffler(1.5, 2.0, np.linspace(-3.0, 0.0, 5))
listed: Array = ricochet.tcol_estimate([1e6, 2e6], 0.3)
degree: float = ricochet.conversion_degree(0.5)
law: ricochet.Linear = ricochet.calibrate("linear", 1e-4, 0.5)
maybe: Optional[ricochet.Law] = ricochet.calibrate("linear", 1e-4, 0.5, unreachable="nan")
columns: Dict[str, Array] = ricochet.calibrate("tsuji", np.array([1e-4, 2e-4]), 0.5)
one: Collision[float] = ricochet.collide(law, velocity=0.5, mass_eff=7.06858e-6)
print(round(one.en, 9), one.status)
many = ricochet.collide(law, np.array([0.1, 1.0]), 1e-5)
print(many.en.mean(), many.tcol[0], many.en[many.status == "ended_by_force"])
contact: FractionalContact[float] = ricochet.fractional_contact(0.3)
print(contact.max_overlap + 1.0, ricochet.__version__)
grains = ricochet.Cluster([[0.0, 0.0, 0.0]], 1e-3, 1000.0, ricochet.Interaction(law), step=1e-6)
grains.advance(3)
print(grains.positions.shape, grains.energy["total"] + grains.step)
"""


def test_mypy_accepts_numbers_where_numbers_go_in_and_arrays_where_arrays_do(tmp_path):
    program = tmp_path / "typed.py"
    program.write_text(TYPED)
    assert mypy("mypy", "--strict", str(program), tmp_path=tmp_path) == ""
    subprocess.run([sys.executable, str(program)], check=True, stdout=subprocess.DEVNULL)


def test_mypy_sees_what_is_wrong(tmp_path):
    wrong = tmp_path / "wrong.py"
    lines = (
        "ricochet.Linear(k=1.0)",
        "ricochet.Linear(1.0, 2.0).k = 3.0",
        "ricochet.fit('linear')",
        "ricochet.calibrate('linear', [1e-4, 2e-4], 0.5).k",
        "ricochet.collide(ricochet.Linear(1.0, 2.0), 0.5, 1.0).en.mean()",
        "ricochet.Cluster([[0, 0, 0]], 1, 1, ricochet.Interaction(ricochet.Linear(1.0, 2.0)), step=1).step = 2.0",
    )
    wrong.write_text("\n".join(["import ricochet", *lines]))
    said = mypy("mypy", str(wrong), tmp_path=tmp_path)
    assert [n for n in range(2, 2 + len(lines)) if f"wrong.py:{n}" not in said] == []
