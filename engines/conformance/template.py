#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""An adapter to begin with, in 100 lines, for MercuryDPM, MFiX, Kratos, Chrono or your own code.

    cp engines/conformance/template.py engines/conformance/mine.py
    verify conformance --cases CASES && engines/conformance/mine.py CASES -o mine.csv

It runs as it stands: its engine is Python itself, and all it can is leapfrog of two spheres with a linear law. Put
yours where it says HERE. Keep to the case: raise NotRun where your engine has no words for it.
"""

import os
import sys

from adapter import Engine, main, one_by_one, run_engine, version_by
from case import Case, NotRun, parameters_of
from outcome import Instant, State, lines_of, numbers_of, run_of_path

# HERE: nothing, this is the engine.
LEAPFROG = """
with open(name, 'w') as file:
    for i in range(count + 1):
        file.write(' '.join(repr(s) for p, u in zip(x, v) for s in p + u) + '\\n')
        apart = [b - a for a, b in zip(*x)]
        distance = sum(s * s for s in apart) ** 0.5
        rate = sum((a - b) * s / distance for a, b, s in zip(*v, apart))
        force = k * (sum(radius) - distance) + c * rate if distance < sum(radius) else 0
        for body, sign in ((0, -1), (1, 1)):
            for d in range(3):
                v[body][d] += dt * sign * max(least, force) * apart[d] / distance / mass[body]
                x[body][d] += dt * v[body][d]
"""


def contact(case: Case) -> str:
    """HERE: the law of two spheres in your engine's words, with its factors and signs, and whether it may attract."""
    law = case.law or case.wall_law  # where no two spheres meet, law is None
    of = parameters_of(law, linear=("k", "c"))
    if not of:
        raise NotRun("no law but the linear one")
    return f"k, c, least = {of[0]!r}, {of[1]!r}, {0.0 if law.end == 'force' else -1e300!r}\n"


def friction(case: Case) -> str:
    """HERE: of all contacts, those with a wall, too."""
    t = case.tangential
    if not t:
        return ""
    raise NotRun("no friction")
    # if t.name != "linear" or t.torsion or t.mu_rolling > 0:  # else k_t grows with the overlap, "mindlin"
    #     raise NotRun("nothing but a constant k_t, without torsion and rolling resistance")
    # return f"k_t, c_t, mu = {t.k_t!r}, {t.c_t!r}, {t.mu!r}\n"


def walls(case: Case) -> str:
    """HERE: planes; the normal points to the spheres, and the law has numbers and an end of its own."""
    if not case.walls:
        return ""
    raise NotRun("no walls")
    # of = parameters_of(case.wall_law, linear=("k", "c"))
    # if not of:
    #     raise NotRun("no law of a wall but the linear one")
    # return "".join(f"wall({w.point!r}, {w.normal!r}, k={of[0]!r}, c={of[1]!r}, end={case.wall_law.end!r})\n"
    #                for w in case.walls)


def spheres(case: Case, n: int) -> str:
    """HERE: where they start. Each has its inertia, too, 2/5 m r²; `density` is there for engines that ask for it."""
    if len(case.bodies) != 2 or any(case.gravity):  # case.gravity is a vector
        raise NotRun("nothing but two spheres, without gravity")
    start = case.start(n)
    return (f"x, v, w = {[list(b.position) for b in start]}, {[list(b.velocity) for b in start]}, "
            f"{[list(b.spin) for b in start]}\nradius, mass = {[b.radius for b in start]}, {[b.mass for b in start]}\n")


def deck(case: Case, n: int) -> str:
    """HERE: all of your engine's input, of case.count(n) steps of the length case.step(n)."""
    return (contact(case) + friction(case) + walls(case) + spheres(case, n)
            + f"dt, count, name = {case.step(n)!r}, {case.count(n)}, 'path.{n}'\n" + LEAPFROG)


def read(case: Case, name: str):
    """HERE: the spheres after every case.every(n) steps, the start first, as your engine wrote them."""
    rows = [numbers_of(line.split(), 6 * len(case.bodies)) for line in lines_of(name)]
    return [Instant([State(r[6 * i:6 * i + 3], r[6 * i + 3:6 * i + 6], b.spin) for i, b in enumerate(case.bodies)])
            for r in rows]


def run_case(program: str, case: Case, folder: str):
    runs = []
    for n in case.steps:
        with open(os.path.join(folder, "deck.py"), "w", encoding="utf-8") as out:
            out.write(deck(case, n))
        run_engine([program, "deck.py"], folder)  # HERE: your engine's command line
        runs.append(run_of_path(case, n, read(case, os.path.join(folder, f"path.{n}"))))
    return runs


if __name__ == "__main__":  # HERE: its name, its program, and how that tells its version
    sys.exit(main(Engine("Python", "python3", version_by(r"Python (\S+)", "--version"), one_by_one(run_case))))
