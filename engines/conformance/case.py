# SPDX-License-Identifier: GPL-3.0-or-later
"""A case of the conformance kit: a file `ricochet/case/1`, as `verify conformance --cases DIR` writes it.

docs/conformance.md describes it. Units are SI. Like all adapters this needs Python's standard library alone, 3.9 or
later.
"""

import json
import math
import os
import pathlib
from typing import Dict, List, NamedTuple, Optional, Sequence, Tuple

Vector = Tuple[float, float, float]


class BadCase(Exception):
    """A case file, option or place that is not as it must be: one line."""


class NotRun(Exception):
    """The engine has no words for this case: why."""


# --- A case ----------------------------------------------------------------------------------------------------------
class Body(NamedTuple):
    radius: float
    mass: float
    inertia: float
    position: Vector
    velocity: Vector
    spin: Vector

    @property
    def density(self) -> float:
        return self.mass / (4 / 3 * math.pi * self.radius**3)


class Wall(NamedTuple):
    """Flat, rigid and at rest; the normal, of length 1, points to the grains."""

    point: Vector
    normal: Vector


class Law(NamedTuple):
    name: str
    parameters: Dict[str, float]
    end: str  # "force" or "overlap"


class Torsion(NamedTuple):
    """Against the spin about the normal: a spring and a dashpot, at most arm·a·mu times the normal force, a the radius
    of the contact."""

    arm: float
    stiffness: float
    damping: float


class Tangential(NamedTuple):
    """Of every contact: −k_t ξ − c_t ξ', mindlin's k_t times √overlap, at most mu times the normal force; against
    rolling a spring and a dashpot, at most mu_rolling·R times the normal force."""

    name: str
    k_t: float
    c_t: float
    mu: float
    torsion: Optional[Torsion] = None
    mu_rolling: float = 0
    k_rolling: float = 0
    c_rolling: float = 0


class Case(NamedTuple):
    name: str
    bodies: List[Body]
    walls: List[Wall]
    gravity: Vector
    law: Optional[Law]  # of two bodies
    wall_law: Optional[Law]  # of a body and a wall
    tangential: Optional[Tangential]
    flight_steps: float
    time_scale: float
    steps: List[int]
    duration: float

    def step(self, n: int) -> float:
        """The time step of the run of n steps in the time scale."""
        return self.time_scale / n

    def count(self, n: int) -> int:
        """How many steps that run has; a duration of whole steps is not made one longer by its rounding."""
        return math.ceil(self.flight_steps + self.duration * n / self.time_scale - 1e-6)

    def every(self, n: int) -> int:
        """How many steps lie between two states that are written. With gravity runs are long, and nothing is asked of
        the first contact: the start and the end are enough."""
        return self.count(n) if any(self.gravity) else 1

    def start(self, n: int) -> List[Body]:
        """The bodies where that run begins: flight_steps before their places, which are those of the first touch."""
        back = self.flight_steps * self.step(n)
        return [b._replace(position=plus(b.position, b.velocity, -back)) for b in self.bodies]

    def half_box(self) -> float:
        """A box of this half width about the origin that nobody leaves [m]."""
        time = self.duration + self.flight_steps * self.step(min(self.steps))
        reach = [length(b.position) + 2 * time * length(b.velocity) + 10 * b.radius for b in self.bodies]
        return max(reach) + length(self.gravity) * time**2 + max([length(w.point) for w in self.walls], default=0)

    def laws(self) -> List[Law]:
        return [law for law in (self.law, self.wall_law) if law]


def plus(a: Sequence[float], b: Sequence[float], factor: float = 1) -> Vector:
    """a + factor b."""
    return (a[0] + factor * b[0], a[1] + factor * b[1], a[2] + factor * b[2])


def dot(a: Sequence[float], b: Sequence[float]) -> float:
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def length(a: Sequence[float]) -> float:
    return math.sqrt(dot(a, a))


def effective_mass(a: Body, b: Optional[Body]) -> float:
    """Of a pair; b = None: a wall."""
    return a.mass * b.mass / (a.mass + b.mass) if b else a.mass


def effective_radius(a: Body, b: Optional[Body]) -> float:
    return a.radius * b.radius / (a.radius + b.radius) if b else a.radius


# --- Reading ---------------------------------------------------------------------------------------------------------
class Reader:
    """A value of the file together with its place, for messages of one line."""

    def __init__(self, value, place: str):
        self.value, self.place = value, place

    def wrong(self, accepted: str):
        shown = json.dumps(self.value)
        return BadCase(f"{self.place} = {shown if len(shown) <= 60 else shown[:57] + '...'}: must be {accepted}")

    def at(self, key: str) -> "Reader":
        if not isinstance(self.value, dict):
            raise self.wrong("an object")
        if key not in self.value:
            raise BadCase(f"{self.place}: {key} is missing")
        return Reader(self.value[key], f"{self.place}.{key}" if self.place[-5:] != ".json" else f"{self.place}: {key}")

    def items(self) -> List["Reader"]:
        if not isinstance(self.value, list):
            raise self.wrong("an array")
        return [Reader(v, f"{self.place}[{i}]") for i, v in enumerate(self.value)]

    def number(self, positive: bool = False) -> float:
        good = isinstance(self.value, (int, float)) and not isinstance(self.value, bool) and math.isfinite(self.value)
        if not good or (positive and self.value <= 0):
            raise self.wrong("a number > 0" if positive else "a number")
        return float(self.value)

    def vector(self) -> Vector:
        numbers = [item.number() for item in self.items()]
        if len(numbers) != 3:
            raise self.wrong("three numbers")
        return (numbers[0], numbers[1], numbers[2])

    def word(self, *accepted: str) -> str:
        if not isinstance(self.value, str) or (accepted and self.value not in accepted):
            raise self.wrong(" or ".join(accepted) or "a text")
        return self.value

    def whole(self) -> int:
        if not isinstance(self.value, int) or isinstance(self.value, bool) or self.value < 1:
            raise self.wrong("a whole number > 0")
        return self.value

    def optional(self, key: str, default) -> "Reader":
        return self.at(key) if key in self.value else Reader(default, f"{self.place}.{key}")


def read_law(of: Reader) -> Optional[Law]:
    if of.value is None:
        return None
    parameters = of.at("parameters")
    if not isinstance(parameters.value, dict):
        raise parameters.wrong("an object")
    numbers = {name: parameters.at(name).number() for name in parameters.value}
    return Law(of.at("name").word(), numbers, of.at("end").word("force", "overlap"))


def read_tangential(of: Reader) -> Optional[Tangential]:
    if of.value is None:
        return None
    parameters, torsion = of.at("parameters"), None
    if of.optional("torsion", False).value is not False:
        torsion = Torsion(*(of.at("torsion").at(key).number() for key in ("arm", "stiffness", "damping")))
    return Tangential(of.at("name").word("linear", "mindlin"), parameters.at("k_t").number(True),
                      parameters.optional("c_t", 0).number(), of.at("mu").number(), torsion,
                      *(of.optional(key, 0).number() for key in ("mu_rolling", "k_rolling", "c_rolling")))


def read_body(of: Reader) -> Body:
    return Body(of.at("radius").number(True), of.at("mass").number(True), of.at("inertia").number(True),
                of.at("position").vector(), of.at("velocity").vector(), of.at("spin").vector())


def read_wall(of: Reader) -> Wall:
    normal = of.at("normal").vector()
    if length(normal) == 0:
        raise of.at("normal").wrong("a direction")
    return Wall(of.at("point").vector(), plus((0, 0, 0), normal, 1 / length(normal)))


def read_case(path: pathlib.Path) -> Case:
    """Throws BadCase, which names file, place, value and what is accepted."""
    try:
        top = Reader(json.loads(path.read_text(encoding="utf-8")), str(path))
    except OSError as error:
        raise BadCase(f"{path}: {error.strerror}") from error
    except ValueError as error:
        raise BadCase(f"{path}: is no JSON: {error}") from error
    top.at("schema").word("ricochet/case/1")
    case = Case(top.at("case").word(), [read_body(b) for b in top.at("bodies").items()],
                [read_wall(w) for w in top.at("walls").items()], top.at("gravity").vector(), read_law(top.at("law")),
                read_law(top.at("wall_law")), read_tangential(top.at("tangential")), top.at("flight_steps").number(),
                top.at("time_scale").number(True), [n.whole() for n in top.at("steps").items()],
                top.at("duration").number(True))
    if not case.bodies or not case.steps:
        raise BadCase(f"{path}: {'bodies' if case.steps else 'steps'} is empty")
    if case.walls and not case.wall_law:
        raise BadCase(f"{path}: wall_law is null, but there are walls")
    return case


def read_cases(folder: str, only: Sequence[str]) -> List[Case]:
    """Those of `only`, or all, by name."""
    if not os.path.isdir(folder):
        raise BadCase(f"{folder}: is no folder")
    cases = [read_case(path) for path in sorted(pathlib.Path(folder).glob("*.json"))]
    if not cases:
        raise BadCase(f"{folder}: holds no case (*.json)")
    names = [case.name for case in cases]
    for name in only:
        if name not in names:
            raise BadCase(f"--only {name}: must be one of {', '.join(names)}")
    return [case for case in cases if not only or case.name in only]


# --- What an adapter asks of a case ----------------------------------------------------------------------------------
def parameters_of(law: Law, **words) -> Optional[Tuple]:
    """parameters_of(law, linear=("k", "c")) is (k, c) of a linear law, None of another."""
    keys = words.get(law.name.replace("-", "_"))
    if keys is None:
        return None
    for key in keys:
        if key not in law.parameters:
            raise BadCase(f"law {law.name}: {key} is missing")
    return tuple(law.parameters[key] for key in keys)


def require_solid_spheres(case: Case) -> None:
    """Engines take mass and radius and make the moment of inertia of them."""
    for i, b in enumerate(case.bodies):
        if abs(b.inertia / (0.4 * b.mass * b.radius**2) - 1) > 1e-9:
            raise NotRun(f"body {i + 1} is no solid sphere, its inertia is not 2/5 m r^2")


def axis_of(wall: Wall) -> Tuple[int, int]:
    """(axis, sign) of a wall that stands across an axis; NotRun where it does not."""
    for axis in range(3):
        if abs(wall.normal[axis]) == 1:
            return axis, int(wall.normal[axis])
    raise NotRun("a wall that stands across no axis")


def poisson_of(ratio: float) -> float:
    """Poisson's ratio of two equal solids by q = G*/E* = (1 − ν)/(2(2 − ν)); Mindlin's k_t is 6 q k."""
    nu = (1 - 4 * ratio) / (1 - 2 * ratio)
    if not -1 < nu <= 0.5:
        raise NotRun(f"k_t/k = {6 * ratio:.6g} is of no material with a Poisson's ratio")
    return nu
