# SPDX-License-Identifier: GPL-3.0-or-later
"""What is measured of a run: where the bodies are at its end, and body 1's first contact."""

import math
import os
from typing import List, NamedTuple, Optional, Sequence, Tuple

from case import Case, Vector, dot, length, plus


class EngineFailed(Exception):
    """The engine was there and did not end well: its last words."""


class State(NamedTuple):
    position: Vector
    velocity: Vector
    spin: Vector


class Instant(NamedTuple):
    """All bodies after a step, and the force on the first one, where the engine gives it."""

    bodies: List[State]
    force: Optional[Vector] = None


Path = List[Instant]  # one instant a step, the first one at the start


# --- What an engine wrote --------------------------------------------------------------------------------------------
def lines_of(path: str) -> List[str]:
    try:
        with open(path, encoding="utf-8", errors="replace") as file:
            return file.read().splitlines()
    except OSError as error:
        raise EngineFailed(f"{os.path.basename(path)}: {error.strerror}") from error


def numbers_of(words: Sequence[str], count: int) -> Tuple[float, ...]:
    try:
        numbers = tuple(map(float, words))
    except ValueError as error:
        raise EngineFailed(f"wrote a line that is not of numbers: {' '.join(words)[:60]}") from error
    if len(numbers) < count:
        raise EngineFailed(f"wrote {len(numbers)} numbers in a line, not {count}")
    return numbers


# --- What is measured ------------------------------------------------------------------------------------------------


def overlaps(case: Case, instant: Instant) -> List[Tuple[float, Vector]]:
    """Of body 1 with every other body, then every wall: how deep [m], and the direction away from it."""
    place, radius = instant.bodies[0].position, case.bodies[0].radius
    found = []
    for other, state in zip(case.bodies[1:], instant.bodies[1:]):
        apart = plus(place, state.position, -1)
        distance = length(apart)
        found.append((radius + other.radius - distance, plus((0, 0, 0), apart, 1 / (distance or 1))))
    return found + [(radius - dot(plus(place, wall.point, -1), wall.normal), wall.normal) for wall in case.walls]


def first_contact(case: Case, step: float, path: Path) -> Tuple[Optional[float], Optional[float]]:
    """(contact time, greatest overlap) of body 1's first contact, as far as the path shows them.

    The touch is where the overlap crosses zero between two steps; so is the end of a contact that ends by overlap. An
    end by force is where the line through the last two forces that repel crosses zero: clipped forces have no sign. The
    greatest overlap is that of the parabola through the deepest step and its neighbours. No time is given where the
    bodies overlap from the start or body 1 meets two at once.
    """
    deep = [overlaps(case, instant) for instant in path]
    touch = next((i for i, row in enumerate(deep) if any(z > 0 for z, _ in row)), None)
    if touch is None or touch == 0:
        return None, None
    which = max(range(len(deep[touch])), key=lambda k: deep[touch][k][0])
    overlap = [row[which][0] for row in deep]
    after = next((i for i in range(touch, len(path)) if overlap[i] <= 0), len(path))
    most = greatest(overlap, max(range(touch, after), key=overlap.__getitem__))
    alone = all(z <= 0 for row in deep[touch:after] for k, (z, _) in enumerate(row) if k != which)
    if not alone:
        return None, most
    begin = touch - overlap[touch] / (overlap[touch] - overlap[touch - 1])
    law = case.law if which < len(case.bodies) - 1 else case.wall_law
    if law and law.end == "overlap":
        end = after - overlap[after] / (overlap[after] - overlap[after - 1]) if after < len(path) else None
    else:
        end = end_by_force([dot(p.force, deep[i][which][1]) for i, p in enumerate(path) if p.force], touch)
    return (None if end is None else (end - begin) * step), most


def greatest(values: List[float], i: int) -> float:
    """Of the parabola through the values at i − 1, i, i + 1."""
    if i + 1 >= len(values):
        return values[i]
    slope, bend = (values[i + 1] - values[i - 1]) / 2, values[i + 1] - 2 * values[i] + values[i - 1]
    return values[i] - slope**2 / (2 * bend) if bend < 0 else values[i]


def end_by_force(force: List[float], touch: int) -> Optional[float]:
    for i in range(touch + 1, len(force) - 1):
        if force[i] > 0 and force[i + 1] <= 0 < force[i - 1]:
            return i + force[i] / (force[i - 1] - force[i]) if force[i - 1] > force[i] else float(i)
    return None


class Run(NamedTuple):
    """What one run left: the bodies at its end, and what is known of body 1's first contact."""

    steps: int
    bodies: List[State]
    contact_time: Optional[float] = None
    max_overlap: Optional[float] = None
    note: str = ""


def run_of_path(case: Case, n: int, path: Path) -> Run:
    if len(path) != case.count(n) // case.every(n) + 1:
        raise EngineFailed(f"{len(path)} states came back of {case.count(n)} steps, {case.every(n)} apart")
    if not all(math.isfinite(x) for state in path[-1].bodies for part in state for x in part):
        raise EngineFailed("a body's place or velocity is no number")
    found = first_contact(case, case.step(n), path) if case.every(n) == 1 else (None, None)
    return Run(n, path[-1].bodies, *found)
