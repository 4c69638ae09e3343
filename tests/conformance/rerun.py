#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a part of the conformance kit again and compares it with the stored results.

    rerun.py VERIFY ADAPTER STORED.csv PROGRAM [CASE…]

All cases, unless some are named, at 50 steps. An engine that is not there, or of another version than the stored
results (our own is held to them in any version), is skipped: exit code 77. What differs is told in a line each: 1.
"""

import csv
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

STEPS = "50"  # compared; 25 run before it, as what an engine refuses is told beside the first that it runs
# Engines are packages, with the same arithmetic everywhere but for the last bits of exp, pow and their like, which a
# hundred or so steps of a contact carry on.
TOLERANCE = 1e-9


def read(path):
    """The comment lines by key, and the rows of STEPS and the notes by case and body."""
    lines = pathlib.Path(path).read_text(encoding="utf-8").splitlines()
    about = dict(line[2:].split(": ", 1) for line in lines if line.startswith("# "))
    rows = list(csv.DictReader(line for line in lines if not line.startswith("#")))
    return about, {(row["case"], row["body"]): row for row in rows if row["steps"] in (STEPS, "")}


def different(stored, again, scales):
    """What differs by more than TOLERANCE of the greatest of its kind in the case."""
    if stored["note"] != again["note"]:
        return [f"note: {stored['note']!r} is now {again['note']!r}"]
    told = []
    for name, scale in scales.items():
        a, b = (float(row[name]) if row[name] else None for row in (stored, again))
        if (a is None) != (b is None) or (a is not None and abs(a - b) > TOLERANCE * scale):
            told.append(f"{name}: {a} is now {b}")
    return told


def scales_of(rows):
    """Places, velocities and spins are compared each with the greatest component of any body."""
    scales = {}
    for group in (("x", "y", "z"), ("vx", "vy", "vz"), ("wx", "wy", "wz"), ("contact_time",), ("max_overlap",)):
        scale = max(abs(float(row[name] or 0)) for row in rows for name in group)
        scales.update({name: scale for name in group})
    return scales


def skip(why):
    print(f"SKIPPED: {why}")
    sys.exit(77)


def main(verify, adapter, stored, program, *only):
    if not shutil.which(program):
        skip(f"there is no {program}")
    about, before = read(stored)
    with tempfile.TemporaryDirectory() as folder:
        cases, results = os.path.join(folder, "cases"), os.path.join(folder, "again.csv")
        subprocess.run([verify, "conformance", "--cases", cases], check=True, stdout=subprocess.DEVNULL)
        options = ["--program", program, "--steps", "25," + STEPS, *(["--only", *only] if only else [])]
        subprocess.run([sys.executable, adapter, cases, "-o", results, *options], check=True)
        now, after = read(results)
    if now["version"] != about["version"] and not now["engine"].startswith("Ricochet"):
        skip(f"{stored} is of {about['version']}, here is {now['version']}")
    before = {key: row for key, row in before.items() if not only or key[0] in only}
    told = [f"{key}: {'is new' if key in after else 'is missing'}" for key in sorted(before.keys() ^ after.keys())]
    for key in sorted(before.keys() & after.keys()):
        scales = scales_of([row for other, row in before.items() if other[0] == key[0]])
        told += [f"{key[0]}, body {key[1]}: {what}" for what in different(before[key], after[key], scales)]
    print("\n".join(told) or f"{len(after)} rows of {now['engine']} {now['version']} are as stored")
    sys.exit(1 if told or not after else 0)


if __name__ == "__main__":
    main(*sys.argv[1:])
