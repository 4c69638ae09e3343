# SPDX-License-Identifier: GPL-3.0-or-later
"""What LAMMPS and LIGGGHTS, which began as LAMMPS, say alike: the ends of their decks and what they dump."""

import os
from typing import Callable

from adapter import run_engine, version_by
from case import Case, length, require_solid_spheres
from outcome import EngineFailed, Instant, Path, State, lines_of, numbers_of, run_of_path


def is_ours(program: str) -> bool:
    """lammps-ricochet or liggghts-ricochet."""
    return os.path.basename(program).endswith("-ricochet")


def version_of_either(pattern: str, *arguments: str, typed: str = "") -> Callable[[str], str]:
    """Engine.version, which names our driver too."""
    stock = version_by(pattern, *arguments, typed=typed)
    return lambda program: stock(program) + (f" with {os.path.basename(program)}" if is_ours(program) else "")


def grains(case: Case, n: int, words: str) -> str:
    """The words once a body: {i} its number, {x}, {v}, {w} its place, velocity and spin at the start, {body} itself."""
    return "".join(words.format(i=i, body=b, x=b.position, v=b.velocity, w=b.spin, diameter=2 * b.radius)
                   for i, b in enumerate(case.start(n), 1))


def run_of(case: Case, n: int, line_format: str) -> str:
    """The run and its path, at full precision; `line_format` is the keyword for how a dump's line looks."""
    g = case.gravity
    fall = f"fix gravity all gravity {length(g)!r} vector {g[0]!r} {g[1]!r} {g[2]!r}\n" if any(g) else ""
    return f"""timestep {case.step(n)!r}
fix integrate all nve/sphere
{fall}thermo 100000000
dump path all custom {case.every(n)} path.{n} x y z vx vy vz omegax omegay omegaz fx fy fz
dump_modify path sort id {line_format} "{' '.join(['%.17g'] * 12)}"
run {case.count(n)}
"""


def run_decks(program: str, case: Case, folder: str, deck: Callable[[int], str]):
    """All runs in one call; deck(n) is that of n steps."""
    require_solid_spheres(case)
    with open(os.path.join(folder, "deck"), "w", encoding="utf-8") as out:
        out.write("clear\n".join(deck(n) for n in case.steps))
    run_engine([program, "-in", "deck", "-log", "none"], folder)
    return [run_of_path(case, n, read_dump(os.path.join(folder, f"path.{n}"), len(case.bodies))) for n in case.steps]


def read_dump(name: str, bodies: int) -> Path:
    """A header a step that ends in ITEM: ATOMS, then a line a body."""
    lines, path = lines_of(name), []
    for i in (i for i, line in enumerate(lines) if line.startswith("ITEM: ATOMS")):
        if len(lines) < i + 1 + bodies or lines[i + 1 + bodies:i + 2 + bodies] not in ([], ["ITEM: TIMESTEP"]):
            raise EngineFailed("a body was lost on its way")
        rows = [numbers_of(line.split(), 12) for line in lines[i + 1:i + 1 + bodies]]
        path.append(Instant([State(r[0:3], r[3:6], r[6:9]) for r in rows], rows[0][9:12]))
    return path
