#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""An adapter to begin with, for MercuryDPM, MFiX, Kratos, Chrono or your own code.

    verify conformance --cases CASES && engines/conformance/template.py CASES -o mine.csv --program PROGRAM

Its engine is Python itself, whose "deck" is leapfrog of two spheres with a linear law. Put your engine where it says
HERE. Keep to the case: raise NotRun where your engine has no words for it.
"""

import os
import sys
import tempfile

from adapter import Engine, main, one_by_one, run_engine
from case import Case, NotRun, parameters_of
from outcome import Instant, State, run_of_path

DECK = """
for count, dt, out in runs:
    x, v = [list(p) for p in places[out]], [list(u) for u in velocities]
    with open(out, 'w') as file:
        for i in range(count + 1):
            file.write(' '.join(repr(s) for p, u in zip(x, v) for s in p + u) + '\\n')
            apart = [b - a for a, b in zip(*x)]
            distance = sum(s * s for s in apart) ** 0.5
            rate = sum((a - b) * s / distance for a, b, s in zip(*v, apart))
            force = k * (reach - distance) + c * rate if distance < reach else 0
            for body, sign in ((0, -1), (1, 1)):
                for d in range(3):
                    v[body][d] += dt * sign * max(least, force) * apart[d] / distance / mass[body]
                    x[body][d] += dt * v[body][d]
"""


def deck(case: Case) -> str:
    """HERE: your engine's input, the law in its words, with its factors and signs."""
    law = case.law and parameters_of(case.law, linear=("k", "c"))
    if law is None or len(case.bodies) != 2 or case.walls or case.tangential or any(case.gravity):
        raise NotRun("nothing but two spheres with a linear law, without friction and gravity")
    (k, c), bodies = law, case.bodies
    return f"""k, c, least = {k!r}, {c!r}, {0.0 if case.law.end == "force" else -1e300!r}
reach, mass, velocities = {sum(b.radius for b in bodies)!r}, {[b.mass for b in bodies]}, {[b.velocity for b in bodies]}
places = {({str(n): [b.position for b in case.start(n)] for n in case.steps})}
runs = {[(case.count(n), case.step(n), str(n)) for n in case.steps]}
{DECK}"""


def read(name: str, case: Case):
    """HERE: the bodies after every step, from what your engine wrote; the start comes first."""
    with open(name, encoding="utf-8") as file:
        rows = [tuple(map(float, line.split())) for line in file]
    return [Instant([State(r[6 * i:6 * i + 3], r[6 * i + 3:6 * i + 6], b.spin) for i, b in enumerate(case.bodies)])
            for r in rows]


def run_case(program: str, case: Case, folder: str):
    with open(os.path.join(folder, "deck.py"), "w", encoding="utf-8") as out:
        out.write(deck(case))
    run_engine([program, "deck.py"], folder)  # HERE: your engine's command line
    return [run_of_path(case, n, read(os.path.join(folder, str(n)), case)) for n in case.steps]


def version(program: str) -> str:
    return run_engine([program, "--version"], tempfile.gettempdir()).split()[-1]  # HERE


if __name__ == "__main__":
    sys.exit(main(Engine("Python", "python3", version, one_by_one(run_case))))
