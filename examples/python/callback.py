"""Samples of what an engineer varies, turned into one engine deck each.

Calibration tools such as GrainLearning call back with a table of samples and expect a simulation for each. The samples
here are the collision's own terms, in which a prior is easily stated: collision time, restitution, tangential
restitution and friction.

    python3 callback.py FOLDER        writes FOLDER/sample_0.lammps …
"""

import pathlib
import sys

import numpy as np

import ricochet

NAMES = ("tcol", "en", "beta0", "mu")
RADIUS, DENSITY, SPEED = 1.5e-3, 2500.0, 0.5
MASS_EFF = 4 / 3 * np.pi * RADIUS**3 * DENSITY / 2


def deck(tcol, en, beta0, mu, engine="lammps", law="linear"):
    """The engine's contact block for one sample."""
    impact = {"tcol": tcol, "en": en, "velocity": SPEED, "mass_eff": MASS_EFF}
    normal = ricochet.calibrate(law, **impact)
    tangential = ricochet.tangential_law_for("linear", normal, beta0=beta0, **impact)
    return ricochet.export_law(
        engine, normal, radius_eff=RADIUS / 2, density=DENSITY, tangential=tangential, mu=mu, **impact
    ).text


def callback(samples, folder):
    """One file a row of `samples`, shape (n, 4); returns their paths."""
    folder = pathlib.Path(folder)
    folder.mkdir(parents=True, exist_ok=True)
    paths = [folder / f"sample_{i}.lammps" for i in range(len(samples))]
    for path, row in zip(paths, samples):
        path.write_text(deck(**dict(zip(NAMES, map(float, row)))))
    return paths


if __name__ == "__main__":
    low, high = np.array([2e-5, 0.3, 0.1, 0.1]), np.array([1e-4, 0.9, 0.9, 0.6])
    drawn = low + (high - low) * np.random.default_rng(0).random((5, 4))
    for path in callback(drawn, sys.argv[1] if len(sys.argv) > 1 else "decks"):
        print(path)
