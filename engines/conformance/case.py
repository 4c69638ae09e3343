# SPDX-License-Identifier: GPL-3.0-or-later
"""A case of the conformance kit: a file `ricochet/case/1`, as `verify conformance --cases DIR` writes it.

docs/conformance.md describes it. Units are SI. Like all adapters this needs Python's standard library alone, 3.9 or
later.
"""

import json
import math
import os
import pathlib
import re
from typing import Callable, Dict, List, NamedTuple, Optional, Sequence, Tuple

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


# --- What numbers may be ---------------------------------------------------------------------------------------------
class Domain(NamedTuple):
    accepted: str
    contains: Callable[[float], bool]


LEAST, GREATEST = 1e-50, 1e50  # cubes, products and quotients of what lies between are finite still
ANY = Domain("a number", lambda x: True)
NOT_NEGATIVE = Domain("a number >= 0", lambda x: x >= 0)
POSITIVE = Domain("a number > 0", lambda x: x > 0)
DEGREE = Domain("in [0, 1]", lambda x: 0 <= x <= 1)

# The parameters of each law, as scenes have them (docs/scenes.md).
LAWS = {
    "linear": {"k": POSITIVE, "c": NOT_NEGATIVE},
    "kuwabara-kono": {"k": POSITIVE, "c": NOT_NEGATIVE},
    "tsuji": {"k": POSITIVE, "c": NOT_NEGATIVE},
    "hysteretic": {"k1": POSITIVE, "k2": POSITIVE},
    "fractional": {"k": POSITIVE, "c": POSITIVE, "alpha": DEGREE},
    "fractional-kelvin-voigt": {"k": POSITIVE, "c": NOT_NEGATIVE, "alpha": DEGREE},
    "fractional-hertz": {"k": NOT_NEGATIVE, "c": NOT_NEGATIVE, "alpha": DEGREE},
    "fractional-zener": {"k": POSITIVE, "k1": NOT_NEGATIVE, "tau": POSITIVE, "alpha": DEGREE},
}
MOST_STEPS = 10_000_000  # in the time scale, as results files may have
MOST_TIME = 1e6  # time scales in a duration, steps in the flight before it


# --- Reading ---------------------------------------------------------------------------------------------------------
class Unreadable(float):
    """What is no number of double precision, NaN, Infinity or 1e400, and is shown as it is written."""

    def __new__(cls, written: str):
        made = super().__new__(cls, math.nan)
        made.written = written
        return made


def numeral(written: str):
    """Whole numbers that a double may not hold are none that a case has."""
    if len(written) < 16 and written.lstrip("-").isdigit():
        return int(written)
    value = float(written)
    return value if math.isfinite(value) else Unreadable(written)


class Reader:
    """A value of the file together with its place, for messages of one line."""

    def __init__(self, value, file: str, way: str = ""):
        self.value, self.file, self.way = value, file, way
        self.place = f"{file}: {way}" if way else file

    def wrong(self, accepted: str) -> BadCase:
        shown = self.value.written if isinstance(self.value, Unreadable) else json.dumps(self.value)
        return BadCase(f"{self.place} = {shown if len(shown) <= 60 else shown[:57] + '...'}: must be {accepted}")

    def allow(self, *keys: str) -> "Reader":
        if not isinstance(self.value, dict):
            raise self.wrong("an object")
        for key in self.value:
            if key not in keys:
                raise BadCase(f"{self.place}: unknown key {json.dumps(key)}; known are {', '.join(keys)}")
        return self

    def at(self, key: str) -> "Reader":
        if not isinstance(self.value, dict):
            raise self.wrong("an object")
        if key not in self.value:
            raise BadCase(f"{self.place}: {key} is missing")
        return Reader(self.value[key], self.file, f"{self.way}.{key}" if self.way else key)

    def items(self) -> List["Reader"]:
        if not isinstance(self.value, list):
            raise self.wrong("an array")
        return [Reader(v, self.file, f"{self.way}[{i}]") for i, v in enumerate(self.value)]

    def some(self) -> List["Reader"]:
        found = self.items()
        if not found:
            raise self.wrong("an array that is not empty")
        return found

    def number(self, domain: Domain = ANY) -> float:
        good = isinstance(self.value, (int, float)) and not isinstance(self.value, bool)
        if not good or math.isnan(self.value) or not domain.contains(self.value):
            raise self.wrong(domain.accepted)
        if self.value != 0 and not LEAST <= abs(self.value) <= GREATEST:
            raise self.wrong(f"{domain.accepted}, from {LEAST:g} to {GREATEST:g} in size")
        return float(self.value)

    def vector(self) -> Vector:
        numbers = [item.number() for item in self.items()]
        if len(numbers) != 3:
            raise self.wrong("three numbers")
        return (numbers[0], numbers[1], numbers[2])

    def word(self, *accepted: str) -> str:
        if not isinstance(self.value, str) or self.value not in accepted:
            raise self.wrong(" or ".join(accepted))
        return self.value

    def name(self) -> str:
        if not isinstance(self.value, str) or not re.fullmatch(r"[A-Za-z0-9][A-Za-z0-9_.-]{0,99}", self.value):
            raise self.wrong("a name of letters, digits, _ . and -, 100 at most")
        return self.value

    def whole(self, most: int) -> int:
        if not isinstance(self.value, int) or isinstance(self.value, bool) or not 1 <= self.value <= most:
            raise self.wrong(f"a whole number from 1 to {most}")
        return self.value


def read_law(of: Reader) -> Optional[Law]:
    if of.value is None:
        return None
    name, end = of.allow("name", "parameters", "end").at("name").word(*LAWS), of.at("end").word("force", "overlap")
    domains = LAWS[name]
    parameters = of.at("parameters").allow(*domains)
    numbers = {key: parameters.at(key).number(domain) for key, domain in domains.items()}
    if name == "hysteretic" and numbers["k1"] > numbers["k2"]:
        raise parameters.at("k1").wrong("at most k2")
    if name == "fractional-hertz" and numbers["k"] == numbers["c"] == 0:
        raise parameters.at("c").wrong("> 0 where k = 0")
    return Law(name, numbers, end)


def read_torsion(of: Reader) -> Optional[Torsion]:
    if of.value is False:
        return None
    of.allow("arm", "stiffness", "damping")
    return Torsion(of.at("arm").number(POSITIVE), of.at("stiffness").number(POSITIVE),
                   of.at("damping").number(NOT_NEGATIVE))


def read_tangential(of: Reader) -> Optional[Tangential]:
    if of.value is None:
        return None
    rolling = ("mu_rolling", "k_rolling", "c_rolling")
    of.allow("name", "parameters", "mu", "torsion", *rolling, "rule")
    parameters = of.at("parameters").allow("k_t", "c_t")
    found = Tangential(of.at("name").word("linear", "mindlin"), parameters.at("k_t").number(POSITIVE),
                       parameters.at("c_t").number(NOT_NEGATIVE), of.at("mu").number(NOT_NEGATIVE),
                       read_torsion(of.at("torsion")), *(of.at(key).number(NOT_NEGATIVE) for key in rolling))
    if found.mu_rolling > 0:
        of.at("k_rolling").number(POSITIVE)
    return found


def read_body(of: Reader) -> Body:
    of.allow(*Body._fields)
    return Body(*(of.at(key).number(POSITIVE) for key in ("radius", "mass", "inertia")),
                *(of.at(key).vector() for key in ("position", "velocity", "spin")))


def read_wall(of: Reader) -> Wall:
    normal = of.allow(*Wall._fields).at("normal").vector()
    if abs(length(normal) - 1) > 1e-9:
        raise of.at("normal").wrong("a vector of length 1")
    return Wall(of.at("point").vector(), normal)


def read_steps(of: Reader) -> List[int]:
    steps = [n.whole(MOST_STEPS) for n in of.some()]
    if len(set(steps)) < len(steps):
        raise of.wrong("numbers that differ")
    return steps


KEYS = ("schema case family title source bodies walls gravity law wall_law tangential flight_steps time_scale steps "
        "duration answers expected_order").split()


def case_of(top: Reader) -> Case:
    top.at("schema").word("ricochet/case/1")
    top.allow(*KEYS)
    law, wall_law = read_law(top.at("law")), read_law(top.at("wall_law"))
    scale = top.at("time_scale").number(POSITIVE)
    case = Case(top.at("case").name(), [read_body(b) for b in top.at("bodies").some()],
                [read_wall(w) for w in top.at("walls").items()], top.at("gravity").vector(), law, wall_law,
                read_tangential(top.at("tangential")), top.at("flight_steps").number(NOT_NEGATIVE), scale,
                read_steps(top.at("steps")), top.at("duration").number(POSITIVE))
    if law and len(case.bodies) < 2:
        raise top.at("law").wrong("null, as there is one body")
    if case.walls and not wall_law:
        raise top.at("wall_law").wrong("a law, as there are walls")
    if not case.walls and not law:
        raise top.at("law").wrong("a law, as there is no wall to meet")
    if case.duration > MOST_TIME * scale:
        raise top.at("duration").wrong(f"at most {MOST_TIME:g} times time_scale")
    if case.flight_steps > MOST_TIME:
        raise top.at("flight_steps").wrong(f"at most {MOST_TIME:g}")
    return case


def read_case(path: pathlib.Path) -> Case:
    """Throws BadCase, which names file, place, value and what is accepted."""

    def once(pairs):
        found = dict(pairs)
        if len(found) < len(pairs):
            twice = next(key for i, (key, _) in enumerate(pairs) if key in dict(pairs[:i]))
            raise BadCase(f"{path}: key {json.dumps(twice)} is given twice in one object; it must be given once")
        return found

    try:
        text = path.read_text(encoding="utf-8-sig")
        return case_of(Reader(json.loads(text, parse_int=numeral, parse_float=numeral, parse_constant=Unreadable,
                                         object_pairs_hook=once), str(path)))
    except OSError as error:
        raise BadCase(f"{path}: {error.strerror}") from error
    except ValueError as error:
        raise BadCase(f"{path}: is no JSON: {error}") from error
    except RecursionError as error:
        raise BadCase(f"{path}: brackets in too many brackets; must be fewer") from error


def read_cases(folder: str, only: Sequence[str]) -> List[Case]:
    """Those of `only`, or all, by name."""
    if not os.path.isdir(folder):
        raise BadCase(f"{folder}: is no folder")
    found: Dict[str, Case] = {}
    for path in sorted(pathlib.Path(folder).glob("*.json")):
        case = read_case(path)
        if case.name in found:
            raise BadCase(f"{path}: case = {case.name}: must be of no other file of the folder")
        found[case.name] = case
    if not found:
        raise BadCase(f"{folder}: holds no case (*.json)")
    for name in only:
        if name not in found:
            raise BadCase(f"--only {name}: must be one of {', '.join(found)}")
    return [case for case in found.values() if not only or case.name in only]


# --- What an adapter asks of a case ----------------------------------------------------------------------------------
def parameters_of(law: Law, **words) -> Optional[Tuple]:
    """parameters_of(law, linear=("k", "c")) is (k, c) of a linear law, None of another."""
    keys = words.get(law.name.replace("-", "_"))
    return None if keys is None else tuple(law.parameters[key] for key in keys)


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


POISSON = 0.3  # of materials, where no shear stiffness asks for another


def poisson_of(ratio: float) -> float:
    """Poisson's ratio of two equal solids by q = G*/E* = (1 − ν)/(2(2 − ν)); Mindlin's k_t is 6 q k."""
    nu = (1 - 4 * ratio) / (1 - 2 * ratio) if ratio < 1 / 3 else -1  # where it is -1 or less
    if not -1 < nu <= 0.5:
        raise NotRun(f"k_t/k = {6 * ratio:.6g} is of no material with a Poisson's ratio")
    return nu


def restitution_of(beta: float) -> Optional[float]:
    """Of a linear or Tsuji's law that attracts until the bodies part, with the damping ratio beta; None of one that
    never lets them."""
    return math.exp(-math.pi * beta / math.sqrt(1 - beta**2)) if beta < 1 else None
