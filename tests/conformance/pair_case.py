"""What the tests of the adapters share: a case of two spheres, changed as a test likes."""

import copy
import json
import math
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
ADAPTERS = ROOT / "engines" / "conformance"
sys.path.insert(0, str(ADAPTERS))

import case as kit  # noqa: E402

RADIUS, MASS, K = 1.5e-3, 1.4e-5, 7000.0
TCOL = math.pi * math.sqrt(MASS / 2 / K)


def body(x, v):
    return {"radius": RADIUS, "mass": MASS, "inertia": 0.4 * MASS * RADIUS**2, "position": [x, 0, 0],
            "velocity": [v, 0, 0], "spin": [0, 0, 0]}


PAIR = {
    "schema": "ricochet/case/1", "case": "pair", "bodies": [body(-RADIUS, 0.25), body(RADIUS, -0.25)], "walls": [],
    "gravity": [0, 0, 0], "law": {"name": "linear", "parameters": {"k": K, "c": 0}, "end": "force"}, "wall_law": None,
    "tangential": None, "flight_steps": 1.5, "time_scale": TCOL, "steps": [50, 100], "duration": 1.73 * TCOL,
    "answers": [], "expected_order": {"leapfrog": 2, "located": 2}}


def written(folder, **changes):
    """A file with the pair's case, changed."""
    path = pathlib.Path(folder) / f"{changes.get('case', 'pair')}.json"
    path.write_text(json.dumps({**PAIR, **changes}))
    return path


def read(folder, **changes):
    return kit.read_case(written(folder, **changes))


def changed(path, value):
    """The pair's case with the value at that path, "bodies.0.radius"; None takes the key away."""
    found = copy.deepcopy(PAIR)
    *way, last = [int(key) if key.isdigit() else key for key in path.split(".")]
    inner = found
    for key in way:
        inner = inner[key]
    if value is None:
        del inner[last]
    else:
        inner[last] = value
    return found
