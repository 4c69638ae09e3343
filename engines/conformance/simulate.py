#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The conformance kit in Ricochet's own simulate.

    verify conformance --cases CASES && engines/conformance/simulate.py CASES -o simulate.csv

docs/scenes.md describes its scenes and what it writes. It locates both ends of a contact inside a step and writes them,
so the contact time is its own.
"""

import csv
import json
import os
import sys
from typing import Optional

from adapter import Engine, main, one_by_one, run_engine, version_by
from case import Case, Law, NotRun, Tangential
from outcome import EngineFailed, Instant, Path, Run, State, lines_of, numbers_of, run_of_path

version = version_by(r"(\d+\.\d+\.\d+\S*)", "--version")


def interaction(case: Case, law: Law, other: str) -> dict:
    found = {"between": ["grain", other], "law": {"name": law.name, **law.parameters, "end": law.end}}
    t = case.tangential
    if t:
        found["friction"] = {"model": t.name, "mu_static": t.mu, "k_t": t.k_t, "c_t": t.c_t}
        if t.torsion:
            raise NotRun("scenes have no torsion with a limit of its own, only the disc's, shared with sliding")
        if t.mu_rolling > 0:
            require_own_rolling(case, t)
            found["friction"]["mu_rolling"] = t.mu_rolling
    return found


def require_own_rolling(case: Case, t: Tangential) -> None:
    """Scenes do not say the spring against rolling: it is 7/2 J/m = 7/5 r² times that against sliding."""
    for b in case.bodies:
        share = 1.4 * b.radius**2
        if t.name != "linear" or abs(t.k_rolling - share * t.k_t) > 1e-9 * t.k_rolling or t.c_rolling != share * t.c_t:
            raise NotRun("scenes make the spring against rolling of that against sliding: (7/2) (J/m) k_t")


def scene(case: Case, n: int) -> dict:
    law = case.law or case.wall_law  # where no two bodies meet, the walls' law stands for theirs
    found = {
        "step": case.step(n), "output_interval": case.step(n) * case.every(n), "duration": case.step(n) * case.count(n),
        "gravity": case.gravity, "materials": {"grain": {}, "stone": {}},
        "interactions": [interaction(case, law, "grain")],
        "spheres": [{"radius": b.radius, "density": b.density, "material": "grain", "position": b.position,
                     "velocity": b.velocity, "spin": b.spin} for b in case.start(n)],
    }
    if case.walls:
        found["interactions"].append(interaction(case, case.wall_law, "stone"))
        found["walls"] = [{"point": w.point, "inward": w.normal, "material": "stone"} for w in case.walls]
    return found


def read_trajectory(name: str, bodies: int) -> Path:
    """Frames of a count, a line about the box, and a line a body: species, place, radius, mass, velocity, spin, id."""
    lines, path = lines_of(name), []
    for i in range(0, len(lines), bodies + 2):
        rows = [numbers_of(line.split()[1:], 11) for line in lines[i + 2:i + 2 + bodies]]
        path.append(Instant([State(r[0:3], r[5:8], r[8:11]) for r in rows]))
    return path


def first_contact_time(name: str) -> Optional[float]:
    """From touch to the first end of the contact in which body 1 was first."""
    rows = [row for row in csv.DictReader(lines_of(name)) if "1" in (row["i"], row["j"])]
    first = min(rows, key=lambda row: float(row["t_begin [s]"]), default=None)
    return float(first["t_end [s]"]) - float(first["t_begin [s]"]) if first and first["t_end [s]"] else None


def run_once(program: str, case: Case, n: int, folder: str) -> Run:
    with open(os.path.join(folder, f"{n}.json"), "w", encoding="utf-8") as out:
        json.dump(scene(case, n), out)
    run_engine([program, f"{n}.json", "-o", str(n)], folder)
    run = run_of_path(case, n, read_trajectory(os.path.join(folder, str(n), "trajectory.xyz"), len(case.bodies)))
    return run._replace(contact_time=first_contact_time(os.path.join(folder, str(n), "contacts.csv")))


def run_case(program: str, case: Case, folder: str):
    """Without the steps that simulate refuses as too long for this law, which the first run's note tells."""
    runs, refused = [], []
    for n in case.steps:
        try:
            runs.append(run_once(program, case, n, folder))
        except EngineFailed as why:
            if "/step = " not in str(why):
                raise
            refused.append((n, why))
    if not runs:
        raise refused[0][1]
    if refused:
        too_long = f"simulate refuses the step of {', '.join(str(n) for n, _ in refused)} as too long"
        runs[0] = runs[0]._replace(note=too_long)
    return runs


if __name__ == "__main__":
    sys.exit(main(Engine("Ricochet simulate", "simulate", version, one_by_one(run_case))))
