#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The conformance kit in LAMMPS (package GRANULAR): pair_style granular and fix wall/gran.

    verify conformance --cases CASES && engines/conformance/lammps.py CASES -o lammps.csv
    engines/conformance/lammps.py CASES -o fractional.csv --program build/release/bin/lammps-ricochet

Written for 29 Sep 2021 and 4 Feb 2025; docs/engines.md says what each of its words means. lammps-ricochet has the
fractional laws: in 2021 one as a pair style and a wall of its own, in 2025 all as normal models of pair granular.
"""

import math
import sys
from typing import Optional

from adapter import Engine, main, one_by_one
from case import (Body, Case, Law, NotRun, axis_of, effective_mass, effective_radius, parameters_of, restitution_of)
from lammps_family import grains, is_ours, run_decks, run_of, version_of_either

MONTHS = "Jan Feb Mar Apr May Jun Jul Aug Sep Oct Nov Dec".split()
said_version = version_of_either(r"Simulator - (\d+ \w+ \d{4}(?: - Update \d+)?)", "-h")


def version(program: str) -> str:
    return said_version(program).replace(" - ", " ")


def date_of(program: str) -> int:
    """The version as a number, 20210929."""
    day, month, year = version(program).split()[:3]
    return 10000 * int(year) + 100 * (1 + MONTHS.index(month[:3])) + int(day)


# --- Laws ------------------------------------------------------------------------------------------------------------
def marshall(x: float) -> float:
    """The polynomial of damping tsuji: c/√(mk) of its argument."""
    return 1.2728 + x * (-4.2783 + x * (11.087 + x * (-22.348 + x * (27.467 + x * (-18.022 + x * 4.8218)))))


def tsuji_argument(eta: float) -> float:
    """Where the polynomial, which falls, is eta = c/√(mk)."""
    low, high = -1.0, 1.0
    if eta < marshall(high):
        raise NotRun(f"damping tsuji: its polynomial never falls to c/sqrt(m k) = {eta:.6g}")
    while marshall(low) < eta:
        low *= 2
    for _ in range(200):
        middle = (low + high) / 2
        low, high = (middle, high) if marshall(middle) > eta else (low, middle)
    return low


def tsuji_damping(eta: float, date: int) -> str:
    """From 27 Jun 2024 on by a restitution, that of an attractive force, before by the polynomial."""
    beta = eta / math.sqrt(5)
    if date < 20240627:
        return f"{tsuji_argument(eta)!r} damping tsuji"
    en = restitution_of(beta)
    if not en:
        raise NotRun("damping coeff_restitution: an overdamped law has no restitution")
    return f"{en!r} damping coeff_restitution"


def is_fractional(law: Optional[Law]) -> bool:
    return law is not None and law.name.startswith("fractional")


def greatest_speed(case: Case) -> float:
    """Of one body past another or a wall, at the start."""
    velocities = [body.velocity for body in case.bodies]
    return max(math.dist(a, b) for a in velocities for b in velocities + [(0.0, 0.0, 0.0)] * len(case.walls))


def fractional(case: Case, law: Law) -> str:
    """Stiffness, damping and degree, or what the law has in their place, by the names of 2025; of fractional/hertz the
    speed that its collisions are meant for as well."""
    name = law.name.replace("-", "/", 1).replace("-", "_")
    values = [*law.parameters.values(), *([greatest_speed(case)] if law.name == "fractional-hertz" else [])]
    return f"{name} {' '.join(map(repr, values))} damping fractional/memory {4 * case.time_scale!r}"


def normal(law: Law, mass: float, radius: float, date: int) -> str:
    """Stiffness, and damping with its kind. hertz multiplies by √(R ζ), viscoelastic by the mass as well."""
    root = math.sqrt(radius)
    if (of := parameters_of(law, linear=("k", "c"))) is not None:
        return f"hooke {of[0]!r} {of[1]!r} damping velocity"
    if (of := parameters_of(law, kuwabara_kono=("k", "c"))) is not None:
        return f"hertz {of[0] / root!r} {of[1] / (mass * root)!r} damping viscoelastic"
    if (of := parameters_of(law, tsuji=("k", "c"))) is not None:
        if of[1] == 0:
            return f"hertz {of[0] / root!r} 0 damping velocity"
        return f"hertz {of[0] / root!r} {tsuji_damping(of[1] / math.sqrt(mass * of[0]), date)}"
    raise NotRun(f"pair_style granular has no {law.name} law")


def tangential(case: Case, law: Law, radius: float) -> str:
    """Damping is given as a share of the normal one; rolling as a force with the arm R."""
    t = case.tangential
    if t is None:
        return "tangential linear_nohistory 0 0"
    if t.torsion:
        raise NotRun("twisting sds has a limit that does not grow with the contact, marshall a spring of its own")
    damping = law.parameters.get("c", 0) if law.name == "linear" else 0
    if t.c_t > 0 and damping == 0:
        raise NotRun("tangential damping is a share of the normal one, which is 0 or changes during the contact")
    share = t.c_t / damping if t.c_t > 0 else 0
    if t.name == "mindlin":
        words = f"tangential mindlin_rescale/force {t.k_t / math.sqrt(radius)!r} {share!r} {t.mu!r}"
    else:
        words = f"tangential linear_history {t.k_t!r} {share!r} {t.mu!r}"
    if t.mu_rolling > 0:
        words += f" rolling sds {t.k_rolling / radius**2!r} {t.c_rolling / radius**2!r} {t.mu_rolling!r}"
    return words


def contact(case: Case, law: Law, a: Body, b: Optional[Body], date: int) -> str:
    radius = effective_radius(a, b)
    if is_fractional(law):
        return f"{fractional(case, law)} {tangential(case, law, radius)}"
    limit = " limit_damping" if law.end == "force" else ""
    return f"{normal(law, effective_mass(a, b), radius, date)} {tangential(case, law, radius)}{limit}"


# --- Deck ------------------------------------------------------------------------------------------------------------
def of_its_own(case: Case, law: Law) -> str:
    """The parameters of pair_style fractional and fix wall/fractional, which 2021 has in place of sub-models."""
    if case.tangential or law.name != "fractional":
        raise NotRun("pair_style fractional of this version has the fractional law alone, without friction")
    return " ".join(repr(law.parameters[name]) for name in ("k", "c", "alpha"))


def pairs(case: Case, date: int) -> str:
    """Each body has a type of its own. What never meets (a body itself) gets a contact that does."""
    bodies, count = case.bodies, len(case.bodies)
    if date < 20230000 and is_fractional(case.law or case.wall_law):
        words = of_its_own(case, case.law or case.wall_law)
        return f"pair_style fractional memory {4 * case.time_scale!r}\npair_coeff * * {words}\n"
    if not case.law:
        return f"pair_style granular\npair_coeff * * {contact(case, case.wall_law, bodies[0], None, date)}\n"
    text = f"pair_style granular\npair_coeff * * {contact(case, case.law, bodies[0], bodies[1], date)}\n"
    return text + "".join(f"pair_coeff {i + 1} {j + 1} {contact(case, case.law, bodies[i], bodies[j], date)}\n"
                          for i in range(count) for j in range(i + 1, count))


def walls(case: Case, date: int) -> str:
    text = "".join(f"group body{i + 1} id {i + 1}\n" for i in range(len(case.bodies))) if case.walls else ""
    for k, wall in enumerate(case.walls):
        axis, sign = axis_of(wall)
        place = f"{wall.point[axis]!r} NULL" if sign > 0 else f"NULL {wall.point[axis]!r}"
        if date < 20230000 and is_fractional(case.wall_law):
            words = of_its_own(case, case.wall_law)
            text += (f"fix wall{k + 1} all wall/fractional {'xyz'[axis]}plane {place} {words} "
                     f"memory {4 * case.time_scale!r}\n")
            continue
        for i, body in enumerate(case.bodies):
            text += (f"fix wall{k + 1}_{i + 1} body{i + 1} wall/gran granular "
                     f"{contact(case, case.wall_law, body, None, date)} {'xyz'[axis]}plane {place}\n")
    return text


GRAIN = """create_atoms {i} single {x[0]!r} {x[1]!r} {x[2]!r}
set atom {i} diameter {diameter!r}
set atom {i} mass {body.mass!r}
set atom {i} vx {v[0]!r} vy {v[1]!r} vz {v[2]!r}
set atom {i} omega {w[0]!r} {w[1]!r} {w[2]!r}
"""


def deck(case: Case, n: int, date: int) -> str:
    half = case.half_box()
    return f"""units si
atom_style sphere
atom_modify map array sort 0 0
newton off
comm_modify vel yes
boundary f f f
region box block {-half!r} {half!r} {-half!r} {half!r} {-half!r} {half!r}
create_box {len(case.bodies)} box
{grains(case, n, GRAIN)}{pairs(case, date)}{walls(case, date)}neighbor {min(b.radius for b in case.bodies)!r} bin
neigh_modify delay 0 every 1 check yes
{run_of(case, n, "format line")}"""


def require_laws(program: str, case: Case) -> None:
    for law in case.laws():
        if is_fractional(law) and not is_ours(program):
            raise NotRun(f"pair_style granular has no {law.name} law; lammps-ricochet has one")
        if is_fractional(law) and law.end != "force":
            raise NotRun(f"{law.name} ends contacts by force")


def run_case(program: str, case: Case, folder: str):
    require_laws(program, case)
    return run_decks(program, case, folder, lambda n: deck(case, n, date_of(program)))


if __name__ == "__main__":
    sys.exit(main(Engine("LAMMPS", "lmp", version, one_by_one(run_case))))
