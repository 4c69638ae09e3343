"""From a restitution to a running simulation, in Python. Every number is in SI units."""

import numpy as np

import ricochet

# --- A law for a collision time and a restitution ------------------------------------------------------------------
law = ricochet.calibrate("fractional", tcol=1e-4, en=0.5)
print(law.name, {name: float(f"{value:.6g}") for name, value in law.parameters.items()})

# What it does at other speeds: of the fractional law the restitution does not depend on the velocity.
speeds = np.array([0.05, 0.5, 5.0])
for name in ("fractional", "kuwabara-kono", "hysteretic"):
    hit = ricochet.collide(ricochet.calibrate(name, tcol=1e-4, en=0.5), speeds, 7.06858e-6)
    print(f"{name:14s} e_n =", np.round(hit.en, 4), " t_col [us] =", np.round(1e6 * hit.tcol, 2))

# --- Ten thousand targets at once ----------------------------------------------------------------------------------
en = np.linspace(0.1, 0.99, 10_000)
columns = ricochet.calibrate("tsuji", tcol=2e-5, en=en)
print("tsuji: c falls from", f"{columns['c'][0]:.4g}", "to", f"{columns['c'][-1]:.4g}", "kg/(s m^(1/4))")

# --- A law from measured rebounds ----------------------------------------------------------------------------------
measured_v = np.array([0.1, 0.2, 0.4, 0.8, 1.6])
measured_en = np.array([0.93, 0.92, 0.905, 0.89, 0.87])
for name in ("linear", "kuwabara-kono"):
    fit = ricochet.fit(name, measured_v, measured_en, en_sigma=0.01)
    print(f"{name:14s} chi2 = {fit.chi2:.2f}, AIC = {fit.aic:.2f}")

# --- The memory of the fractional law, for an engine of your own ---------------------------------------------------
kernel = ricochet.memory_kernel(law.alpha, shortest=1e-6, longest=1e-3, tolerance=1e-6)
print(f"memory: {len(kernel.rates)} Maxwell arms keep the kernel of D^{law.alpha:.3f} to {kernel.error:.1e}")

# Each arm gains what the overlap grows by and fades; all of them, a spring and a dashpot are the force.
step, mass = 1e-7, 7.06858e-6
decay = np.exp(-kernel.rates * step)
gain = -kernel.strengths * np.expm1(-kernel.rates * step) / kernel.rates
coefficient = law.c**law.alpha * law.k ** (1 - law.alpha)
overlap, rate, time, force, arms = 0.0, 0.5, 0.0, 1.0, np.zeros(len(kernel.rates))
while force > 0:
    overlap += step * rate
    arms = decay * arms + gain * rate
    force = coefficient * (kernel.spring * overlap + kernel.dashpot * rate + arms.sum())
    rate -= step * force / mass
    time += step
print(f"a loop of one's own: {time:.3g} s, restitution {-rate / 0.5:.3f}")

# --- Many grains ---------------------------------------------------------------------------------------------------
contact = ricochet.Interaction(
    law, ricochet.TangentialContact(ricochet.LinearTangential(1500.0, 0.01), ricochet.Friction(0.4))
)
grid = 3.1e-3 * np.stack(np.meshgrid(*[np.arange(3)] * 3), axis=-1).reshape(-1, 3)
box = ricochet.Cluster(
    grid,
    radii=1.5e-3,
    densities=1000.0,
    interactions=contact,
    velocities=np.random.default_rng(1).normal(0, 0.1, grid.shape),
    walls=ricochet.box_walls([-2e-3] * 3, [8.2e-3] * 3),
    gravity=(0, 0, -9.81),
    step=2.5e-6,
)
box.advance(2000)
energy = box.energy
print(f"after {box.time:.4f} s: {len(box.take_finished())} collisions, {len(box.contacts['force'])} contacts")
print(f"{1e9 * energy['kinetic']:.0f} nJ in motion, {1e9 * energy['lost_normal']:.0f} nJ lost along the normals,",
      f"{1e9 * energy['lost_friction']:.0f} nJ to friction")
