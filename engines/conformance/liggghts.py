#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The conformance kit in LIGGGHTS: pair_style gran and fix wall/gran.

    verify conformance --cases CASES && engines/conformance/liggghts.py CASES -o liggghts.csv
    engines/conformance/liggghts.py CASES -o fractional.csv --program build/release/bin/liggghts-ricochet

Written for 3.8.0; docs/engines.md says what each of its words means, docs/liggghts.md those of liggghts-ricochet.
"""

import math
import sys
from typing import Dict, List, NamedTuple, Optional, Tuple

from adapter import Engine, main, one_by_one
from case import (POISSON, Body, Case, Law, NotRun, Tangential, axis_of, effective_mass, effective_radius, length,
                  parameters_of, poisson_of, restitution_of)
from lammps_family import grains, is_ours, run_decks, run_of, version_of_either

version = version_of_either(r"Version LIGGGHTS-PUBLIC ([0-9.]+)", "-log", "none", typed="print ready\n")


# --- Laws ------------------------------------------------------------------------------------------------------------
class Model(NamedTuple):
    """A normal model's name with its settings, and the properties that it takes of this pair."""

    style: str
    settings: str
    properties: Dict[str, float]


def hooke(case: Case, law: Law, k: float, c: float) -> Model:
    t = case.tangential
    if t and t.name != "linear":
        raise NotRun("hooke/stiffness has a constant k_t")
    if t and t.torsion:
        raise NotRun("no torsion but that of rolling_friction, with its spring and limit")
    if t and t.c_rolling > 0:
        raise NotRun("the viscous part of rolling_friction epsd3 is a share of a critical one")
    return Model("hooke/stiffness", "absolute_damping on tangential_damping on",
                 {"kn": k, "gamman_abs": c, "kt": t.k_t if t else 0, "gammat_abs": t.c_t if t else 0})


def without_dashpot(case: Case) -> float:
    """k_t of Mindlin's law beside a Hertzian one."""
    t = case.tangential
    if t and (t.name != "mindlin" or t.c_t > 0 or t.torsion or t.mu_rolling > 0):
        raise NotRun("the Hertzian models let k_t, c_t and the springs of rolling change with the contact")
    return t.k_t if t else 0


def hertz_stiffness(case: Case, k: float, c: float, mass: float, root: float) -> Model:
    """Multiplies by √(R ζ), the dashpot by the mass as well."""
    return Model("hertz/stiffness", "tangential_damping off",
                 {"kn": k / root, "gamman": c / (mass * root), "kt": without_dashpot(case) / root, "gammat": 0})


def hertz(case: Case, k: float, c: float, mass: float, root: float) -> Model:
    """Knows moduli and a restitution, that of a force which may attract."""
    en = restitution_of(c / math.sqrt(5 * mass * k)) or 0
    if not en > 0.05:
        raise NotRun(f"model hertz refuses a coefficientRestitution of 0.05 or less, this law needs {en:.6g}")
    k_t = without_dashpot(case)
    return Model("hertz", "tangential_damping off",
                 {"coefficientRestitution": en, "E*": 0.75 * k / root,
                  "poissonsRatio": poisson_of(k_t / (6 * k)) if k_t > 0 else POISSON})


def edinburgh(case: Case, k1: float, k2: float) -> Model:
    """With fixKc, exponent 1 and no adhesion: k1 while loading, k2 while unloading, at every velocity."""
    if case.tangential:
        raise NotRun("edinburgh/stiffness takes k1 for k_t")
    return Model("edinburgh/stiffness", "tangential_damping off fixKc on",
                 {"LoadingStiffness": k1, "UnloadingStiffness": k2 / k1, "coefficientRestitution": 1,
                  "coefficientAdhesionStiffness": 0, "pullOffForce": 0, "surfaceEnergy": 0})


def memory(case: Case, law: Law) -> Model:
    """The laws that liggghts-ricochet adds, by their parameters: k is fractionalK."""
    if law.end != "force":
        raise NotRun(f"model {law.name} ends contacts by force")
    t = case.tangential
    if t and t.name != "linear":
        raise NotRun(f"model {law.name} has a constant k_t")
    if t and (t.torsion or t.mu_rolling > 0):
        raise NotRun(f"rolling_friction makes its springs of a kn that model {law.name} takes of no case")
    properties = {f"fractional{name.capitalize()}": value for name, value in law.parameters.items()}
    return Model(law.name, "", {**properties, "kt": t.k_t, "gammat_abs": t.c_t} if t else properties)


def model(program: str, case: Case, law: Law, a: Body, b: Optional[Body]) -> Model:
    mass, root = effective_mass(a, b), math.sqrt(effective_radius(a, b))
    if law.name.startswith("fractional"):
        if not is_ours(program):
            raise NotRun(f"no {law.name} law; liggghts-ricochet has one")
        return memory(case, law)
    if (of := parameters_of(law, linear=("k", "c"))) is not None:
        found = hooke(case, law, *of)
    elif (of := parameters_of(law, kuwabara_kono=("k", "c"))) is not None:
        found = hertz_stiffness(case, *of, mass, root)
    elif (of := parameters_of(law, tsuji=("k", "c"))) is not None:
        found = hertz(case, *of, mass, root)
    elif (of := parameters_of(law, hysteretic=("k1", "k2"))) is not None:
        found = edinburgh(case, *of)
    else:
        raise NotRun(f"no {law.name} law")
    return found._replace(settings=f"{found.settings} limitForce {'on' if law.end == 'force' else 'off'}")


# --- Deck ------------------------------------------------------------------------------------------------------------
class Contacts:
    """The model of every two types that meet: body i has type i + 1, all walls the last one."""

    def __init__(self, program: str, case: Case):
        self.case, bodies = case, case.bodies
        self.types = len(bodies) + (1 if case.walls else 0)
        self.of = {(i, j): model(program, case, case.law, a, b)
                   for i, a in enumerate(bodies) for j, b in enumerate(bodies) if case.law and i < j}
        if case.walls:
            self.of.update({(i, len(bodies)): model(program, case, case.wall_law, a, None)
                            for i, a in enumerate(bodies)})
        self.wall = self.of.get((0, len(bodies)))
        self.pair = self.of.get((0, 1), self.wall) if case.law else self.wall

    def style(self, of: Model) -> str:
        """The model's words, with the tangential part behind them; a wall's own words come between."""
        t = self.case.tangential
        rolling = " rolling_friction epsd3" if t and t.mu_rolling > 0 else ""
        return f"model {of.style} tangential {'history' if t else 'off'}{rolling}"

    def properties(self) -> str:
        names = {name for of in self.of.values() for name in of.properties} - {"E*", "poissonsRatio"}
        text = "".join(self.matrix(name) for name in sorted(names))
        if self.case.tangential:
            text += self.friction(self.case.tangential)
        if any(of.style == "edinburgh/stiffness" for of in self.of.values()):
            text += ("fix overlapExponent all property/global overlapExponent scalar 1\n"
                     "fix adhesionExponent all property/global adhesionExponent scalar 1\n")
        if any(of.style == "fractional-hertz" for of in self.of.values()):
            text += f"fix speed all property/global characteristicVelocity scalar {speed(self.case)!r}\n"
        if any(of.style.startswith("fractional") for of in self.of.values()):
            text += f"fix memory all property/global memoryTime scalar {4 * self.case.time_scale!r}\n"
        return text + self.materials()

    def friction(self, t: Tangential) -> str:
        """epsd3: a spring of rollingStiffness·kn μ²R² against rolling, up to μRF."""
        text = self.constant("coefficientFriction", t.mu)
        if t.mu_rolling == 0:
            return text
        stiffness = {t.k_rolling / (of.properties["kn"] * (t.mu_rolling * self.radius(pair))**2)
                     for pair, of in self.of.items()}
        if spread(stiffness) > 1e-12 or max(stiffness) < 1:
            raise NotRun("rolling_friction epsd3 has one stiffness, 1 kn (mu R)^2 or more, for all contacts")
        return (text + self.constant("coefficientRollingFriction", t.mu_rolling)
                + self.constant("coefficientRollingViscousDamping", 0)
                + f"fix rollingStiffness all property/global rollingStiffness scalar {max(stiffness)!r}\n")

    def radius(self, pair: Tuple[int, int]) -> float:
        bodies = self.case.bodies
        return effective_radius(bodies[pair[0]], bodies[pair[1]] if pair[1] < len(bodies) else None)

    def constant(self, name: str, value: float) -> str:
        row = " ".join([repr(value)] * self.types**2)
        return f"fix {name} all property/global {name} peratomtypepair {self.types} {row}\n"

    def matrix(self, name: str) -> str:
        """A pair that does not meet, as a wall and itself, gets the first value there is."""
        values = {pair: of.properties[name] for pair, of in self.of.items() if name in of.properties}
        other = next(iter(values.values()))
        row = [repr(values.get((min(i, j), max(i, j)), other)) for i in range(self.types) for j in range(self.types)]
        return f"fix {name} all property/global {name} peratomtypepair {self.types} {' '.join(row)}\n"

    def materials(self) -> str:
        """Young's moduli of which 1/E* = (1 − ν²)(1/E₁ + 1/E₂) makes that of every contact."""
        of = self.of_hertz()
        if not of:
            return ""
        poisson = {m.properties["poissonsRatio"] for m in of.values()}
        if len(poisson) > 1:
            raise NotRun("model hertz: no materials give k_t/k of both contacts")
        nu = poisson.pop()
        young = [2 * (1 - nu**2) * e for e in self.halves({pair: m.properties["E*"] for pair, m in of.items()})]
        text = "soft_particles yes\n" if min(young) < 5e6 else ""
        text += "hard_particles yes\n" if max(young) > 1e9 else ""
        for name, values in (("youngsModulus", young), ("poissonsRatio", [nu] * self.types)):
            text += f"fix {name} all property/global {name} peratomtype {' '.join(map(repr, values))}\n"
        return text

    def of_hertz(self) -> Dict:
        return {pair: m for pair, m in self.of.items() if m.style == "hertz"}

    def halves(self, wanted: Dict) -> List[float]:
        """E of every type, where two types have 2/(1/E + 1/E): all alike, or all bodies alike and the walls not."""
        wall = self.types - 1 if self.case.walls else None
        among = {e for (i, j), e in wanted.items() if j != wall}
        beside = {e for (i, j), e in wanted.items() if j == wall}
        if spread(among) > 1e-12 or spread(beside) > 1e-12:
            raise NotRun("model hertz: no materials give the same k to pairs of several radii")
        grain = next(iter(among or beside))
        if not beside:
            return [grain] * self.types
        both = next(iter(beside))
        if both >= 2 * (1 - 1e-9) * grain:
            raise NotRun("model hertz: no wall is so stiff beside these grains")
        return [grain] * (self.types - 1) + [1 / (2 / both - 1 / grain)]

    def commands(self) -> str:
        text = f"{self.properties()}pair_style gran {self.style(self.pair)} {self.pair.settings}\npair_coeff * *\n"
        for k, wall in enumerate(self.case.walls, 1):
            axis, _ = axis_of(wall)
            text += (f"fix wall{k} all wall/gran {self.style(self.wall)} primitive type {self.types} "
                     f"{'xyz'[axis]}plane {wall.point[axis]!r} {self.wall.settings}\n")
        return text


def spread(values) -> float:
    return max(values) / min(values) - 1 if values else 0


def speed(case: Case) -> float:
    """What characteristicVelocity asks for: the fastest impact, about."""
    return max(length(b.velocity) for b in case.bodies) or 1.0


GRAIN = """create_atoms {i} single {x[0]!r} {x[1]!r} {x[2]!r} units box
set atom {i} diameter {diameter!r} density {body.density!r}
set atom {i} vx {v[0]!r} vy {v[1]!r} vz {v[2]!r}
set atom {i} omegax {w[0]!r} omegay {w[1]!r} omegaz {w[2]!r}
"""


def deck(contacts: Contacts, n: int) -> str:
    case = contacts.case
    half = case.half_box()
    return f"""atom_style granular
atom_modify map array sort 0 0
boundary f f f
newton off
communicate single vel yes
units si
region box block {-half!r} {half!r} {-half!r} {half!r} {-half!r} {half!r} units box
create_box {contacts.types} box
neighbor {min(b.radius for b in case.bodies)!r} bin
neigh_modify delay 0
{contacts.commands()}{grains(case, n, GRAIN)}{run_of(case, n, "format")}"""


def run_case(program: str, case: Case, folder: str):
    contacts = Contacts(program, case)
    return run_decks(program, case, folder, lambda n: deck(contacts, n))


if __name__ == "__main__":
    sys.exit(main(Engine("LIGGGHTS", "liggghts", version, one_by_one(run_case))))
