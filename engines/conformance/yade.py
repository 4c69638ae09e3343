#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The conformance kit in Yade: ViscElMat for linear laws, FrictMat with MindlinPhys for Tsuji's.

    verify conformance --cases CASES && engines/conformance/yade.py CASES -o yade.csv

Written for 2023.02a; docs/engines.md says what each of its words means. Yade starts slowly, so one process runs all
cases; where it dies in one, another goes on with the next. Velocities are handed over and read back as Yade has them,
half a step behind the places.
"""

import math
import os
import sys
import tempfile
from typing import Dict, List, Sequence, Tuple

from adapter import Engine, main, run_engine, version_by
from case import POISSON, Case, Law, NotRun, axis_of, effective_mass, effective_radius, parameters_of, poisson_of
from outcome import EngineFailed, Instant, Path, State, lines_of, numbers_of, run_of_path

version = version_by(r"Yade version: (\S+)", "--version")


# --- Laws: what defines grain, stone (the walls' material), ip2 and law2 ---------------------------------------------
def other_half(name: str, grain: float, both: float) -> float:
    """The wall's part, where grain and wall in series are to have `both`."""
    if both == 0:
        return 0.0
    if both >= (1 - 1e-9) * grain:
        raise NotRun(f"springs and dashpots in series: no wall has such a {name} beside these grains")
    return 1 / (1 / both - 1 / grain)


def viscous(case: Case, law: Law, wall_law: Law) -> str:
    """In series where that gives both contacts; else, without friction, by tc and en, of which Yade makes k and c."""
    try:
        return in_series(case, law, wall_law)
    except NotRun:
        if case.tangential:
            raise
        return by_time(case, law, wall_law)


def by_time(case: Case, law: Law, wall_law: Law) -> str:
    """k = (π² + ln²en) m/tc², c = −2 ln(en) m/tc, m the pair's effective mass, or half the sphere's at a wall."""
    bodies = case.bodies
    pairs = [effective_mass(a, b) for i, a in enumerate(bodies) for b in bodies[:i]]
    alike("masses", pairs)
    alike("masses", [b.mass for b in bodies])
    grain, wall = tc_en(law, pairs[0]), tc_en(wall_law, bodies[0].mass / 2)

    def match(i: int) -> str:
        return f"MatchMaker(matches=[(grain.id, grain.id, {grain[i]!r}), (grain.id, stone.id, {wall[i]!r})])"

    return ("grain, stone = (ViscElMat(tc=1, en=1, et=1, frictionAngle=0) for _ in range(2))\n"
            + "O.materials.append([grain, stone])\n"
            + f"ip2 = Ip2_ViscElMat_ViscElMat_ViscElPhys(tc={match(0)}, en={match(1)}, "
            + "et=MatchMaker(algo='val', val=1))\nlaw2 = Law2_ScGeom_ViscElPhys_Basic()\n")


def tc_en(law: Law, mass: float) -> Tuple[float, float]:
    k, c = parameters_of(law, linear=("k", "c"))
    left = k - c**2 / (4 * mass)
    if not left > 0:
        raise NotRun("an overdamped law has no tc and en")
    tc = math.pi * math.sqrt(mass / left)
    return tc, math.exp(-c * tc / (2 * mass))


def in_series(case: Case, law: Law, wall_law: Law) -> str:
    """Springs and dashpots of two bodies are in series, so each has twice the pair's."""
    t = case.tangential
    if t and t.name != "linear":
        raise NotRun("ViscElPhys has a constant k_t")
    if t and t.torsion:
        raise NotRun("ViscElPhys has no torsion")
    if t and t.mu_rolling > 0:
        raise NotRun("ViscElPhys resists rolling by a moment of constant size, without a spring")
    k, c = parameters_of(law, linear=("k", "c"))
    k_wall, c_wall = parameters_of(wall_law, linear=("k", "c"))
    k_t, c_t, mu = (t.k_t, t.c_t, t.mu) if t else (0, 0, 0)

    def material(name: str, kn: float, cn: float) -> str:
        return (f"{name} = ViscElMat(kn={kn!r}, cn={cn!r}, ks={2 * k_t!r}, cs={2 * c_t!r}, "
                f"frictionAngle={math.atan(mu)!r})\n")

    return (material("grain", 2 * k, 2 * c)
            + material("stone", other_half("k", 2 * k, k_wall), other_half("c", 2 * c, c_wall))
            + "ip2, law2 = Ip2_ViscElMat_ViscElMat_ViscElPhys(), Law2_ScGeom_ViscElPhys_Basic()\n")


def hertzian(case: Case, law: Law, wall_law: Law) -> str:
    """MindlinPhys: (4/3)E*√R ζ^{3/2} + 2 betan √(m K_n) ζ', K_n = (3/2)k√ζ; the shear stiffness follows from ν."""
    t = case.tangential
    if t and t.name != "mindlin":
        raise NotRun("MindlinPhys lets k_t grow with the contact")
    if t and (t.c_t > 0 or t.torsion or t.mu_rolling > 0):
        raise NotRun("MindlinPhys is written here without tangential damping, torsion and rolling resistance")
    one, bodies = case.bodies[0], case.bodies
    pairs = [(a, b) for i, a in enumerate(bodies) for b in bodies[:i]] if case.law else []
    k, c = parameters_of(law, tsuji=("k", "c"))
    k_wall, c_wall = parameters_of(wall_law, tsuji=("k", "c"))
    alike("radii", [effective_radius(a, b) for a, b in pairs])
    alike("masses", [effective_mass(a, b) for a, b in pairs] if c > 0 else [])
    if case.walls:
        alike("radii", [b.radius for b in bodies])
        alike("masses", [b.mass for b in bodies] if c_wall > 0 else [])
    mate = pairs[0] if pairs else (one, None)
    nu = poisson_of(t.k_t / (6 * k)) if t else POISSON
    if t and case.walls and abs(k_wall / k - 1) > 1e-12:
        raise NotRun("no materials give k_t/k of both contacts")
    double = 2 * 0.75 * k / math.sqrt(effective_radius(*mate))  # E/(1 − ν²); 1/E* sums its reciprocals
    stone = other_half("k", double, 0.75 * k_wall / math.sqrt(one.radius)) if case.walls else double
    # The damping ratio c/√(5mk), in parts of the critical damping of the tangent stiffness K_n.
    betan = math.sqrt(5 / 6) * c / math.sqrt(5 * effective_mass(*mate) * k)
    betan_wall = math.sqrt(5 / 6) * c_wall / math.sqrt(5 * one.mass * k_wall)
    angle = math.atan(t.mu if t else 0)

    def material(name: str, young: float) -> str:
        return f"{name} = FrictMat(young={young * (1 - nu**2)!r}, poisson={nu!r}, frictionAngle={angle!r})\n"

    return (material("grain", double) + material("stone", stone) + "O.materials.append([grain, stone])\n"
            + "ip2 = Ip2_FrictMat_FrictMat_MindlinPhys(betas=0, betan=MatchMaker(matches=["
            + f"(grain.id, grain.id, {betan!r}), (grain.id, stone.id, {betan_wall!r})]))\n"
            + "law2 = Law2_ScGeom_MindlinPhys_Mindlin()\n")


def alike(what: str, values: Sequence[float]) -> None:
    if values and max(values) / min(values) - 1 > 1e-12:
        raise NotRun(f"no materials give the same law to pairs of several {what}")


def contacts(case: Case) -> str:
    """Where no two bodies meet, or none meets a wall, the other law stands for theirs."""
    law, wall_law = case.law or case.wall_law, case.wall_law or case.law
    if {law.name, wall_law.name} == {"linear"}:
        return viscous(case, law, wall_law)
    if {law.name, wall_law.name} == {"tsuji"}:
        return hertzian(case, law, wall_law)
    if "hysteretic" in (law.name, wall_law.name):
        raise NotRun("LudingPhys lets the unloading stiffness grow with the overlap: no constant k2")
    raise NotRun(f"no {' and '.join(sorted({law.name, wall_law.name}))} law")


# --- Deck ------------------------------------------------------------------------------------------------------------
PRELUDE = """from yade import *

def put(sphere, mass, inertia, velocity, spin):
  state = O.bodies[O.bodies.append(sphere)].state
  state.mass, state.inertia, state.vel, state.angVel = mass, (inertia, inertia, inertia), velocity, spin

def go(name, step, count, every, bodies, gravity, ip2, law2):
  # hertzian: a wall is flat, not a sphere as large as the grain
  O.engines = [ForceResetter(),
    InsertionSortCollider([Bo1_Sphere_Aabb(), Bo1_Wall_Aabb()], verletDist=O.bodies[0].shape.radius / 2),
    InteractionLoop([Ig2_Sphere_Sphere_ScGeom(), Ig2_Wall_Sphere_ScGeom(hertzian=True)], [ip2], [law2]),
    NewtonIntegrator(damping=0, gravity=gravity)]
  O.dt = step
  with open(name, 'w') as out:
    for i in range(0, count + 1, every):
      rows = [[*s.pos, *s.vel, *s.angVel] for s in (O.bodies[b].state for b in range(bodies))]
      O.step()  # the forces are those at the places before
      out.write(' '.join(repr(x) for row in rows for x in row) + ' %r %r %r\\n' % tuple(O.forces.f(0)))
      if i < count and every > 1: O.run(every - 1, True)

def attempt(name, run):
  try:
    run()
  except Exception as error:
    open(name + '.error', 'w').write(repr(error))
  open(name + '.done', 'w').close()

"""


def once(case: Case, i: int, n: int, setup: str) -> str:
    text = "O.reset()\n" + setup
    for b in case.start(n):
        text += (f"put(utils.sphere({b.position!r}, {b.radius!r}, material=grain), {b.mass!r}, {b.inertia!r}, "
                 f"{b.velocity!r}, {b.spin!r})\n")
    for wall in case.walls:
        axis, _ = axis_of(wall)
        text += f"O.bodies.append(utils.wall({wall.point!r}, axis={axis}, material=stone))\n"
    return text + (f"go('{i}.{n}', {case.step(n)!r}, {case.count(n)}, {case.every(n)}, {len(case.bodies)}, "
                   f"{case.gravity!r}, ip2, law2)\n")


def deck(case: Case, i: int, setup: str) -> str:
    runs = "".join(once(case, i, n, setup) for n in case.steps)
    return f"# {case.name}\ndef case{i}():\n  " + runs.strip().replace("\n", "\n  ") + f"\nattempt('{i}', case{i})\n\n"


def read_path(name: str, bodies: int) -> Path:
    """A line an instant: place, velocity and spin of each body, then the force on the first."""
    path = []
    for line in lines_of(name):
        x = numbers_of(line.split(), 9 * bodies + 3)
        path.append(Instant([State(x[i:i + 3], x[i + 3:i + 6], x[i + 6:i + 9]) for i in range(0, 9 * bodies, 9)],
                            x[-3:]))
    return path


def outcome(case: Case, place: str):
    """Its runs, or what Yade's Python raised."""
    if os.path.exists(place + ".error"):
        with open(place + ".error", encoding="utf-8") as file:
            return EngineFailed(file.read())
    try:
        return [run_of_path(case, n, read_path(f"{place}.{n}", len(case.bodies))) for n in case.steps]
    except EngineFailed as why:
        return why


def run(program: str, cases: Sequence[Case]):
    decks: Dict[int, str] = {}
    for i, case in enumerate(cases):
        try:
            decks[i] = deck(case, i, contacts(case))
        except NotRun as why:
            yield case, why
    waiting: List[int] = list(decks)
    while waiting:
        with tempfile.TemporaryDirectory(prefix="conformance-") as folder:
            with open(os.path.join(folder, "deck.py"), "w", encoding="utf-8") as out:
                out.write(PRELUDE + "".join(decks[i] for i in waiting))
            died = EngineFailed("ended before its time")
            try:
                run_engine([program, "-n", "-x", "deck.py"], folder, QT_QPA_PLATFORM="offscreen")
            except EngineFailed as why:
                died = why
            done = [i for i in waiting if os.path.exists(os.path.join(folder, f"{i}.done"))]
            for i in done:
                yield cases[i], outcome(cases[i], os.path.join(folder, str(i)))
        waiting = waiting[len(done):]
        if waiting:
            yield cases[waiting.pop(0)], died


if __name__ == "__main__":
    sys.exit(main(Engine("Yade", "yade", version, run)))
