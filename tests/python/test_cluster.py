"""Many bodies from arrays."""

import signal
import threading

import numpy as np
import pytest

import ricochet


def pair(law, **options):
    return ricochet.Cluster(
        [[-1.6e-3, 0, 0], [1.6e-3, 0, 0]],
        1.5e-3,
        1000.0,
        ricochet.Interaction(law),
        velocities=[[0.25, 0, 0], [-0.25, 0, 0]],
        **options,
    )


def test_two_spheres_rebound_as_in_a_binary_collision():
    mass = 4 / 3 * np.pi * 1.5e-3**3 * 1000 / 2
    law = ricochet.calibrate("fractional", 1e-4, 0.6, mass_eff=mass)
    cluster = pair(law, step=5e-7)
    assert len(cluster) == 2
    cluster.advance(2500)
    assert cluster.time == pytest.approx(2500 * 5e-7)
    assert cluster.velocities[1, 0] / 0.25 == pytest.approx(0.6, abs=2e-4)  # second order: (step/tcol)^2 and more
    assert np.abs(cluster.momentum).max() < 1e-18
    (one,) = cluster.take_finished()
    assert (one["i"], one["j"]) == (0, 1) and one["end"] - one["begin"] == pytest.approx(1e-4, rel=1e-3)
    assert cluster.take_finished() == []


def energy_error(step):
    """Of the whole collision, relative: the spheres touch at 4e-4 s and part some 1.2e-4 s later."""
    cluster = pair(ricochet.Linear(5000.0, 0.01), step=step)
    before = cluster.energy["total"]
    cluster.advance(round(6e-4 / step))
    assert len(cluster.contacts["force"]) == 0 and cluster.energy["lost_normal"] > 0
    return abs(cluster.energy["total"] / before - 1)


def test_the_balance_of_energy_closes_with_order_2():
    assert 3 < energy_error(2e-6) / energy_error(1e-6) < 5.5


def test_contacts_are_shown():
    cluster = pair(ricochet.Linear(5000.0, 0.01), step=1e-6)
    cluster.advance(450)
    contact = cluster.contacts
    assert contact["pairs"].tolist() == [[0, 1]]
    x = cluster.positions
    # Half a step lies between the two.
    assert contact["overlap"][0] == pytest.approx(3e-3 - (x[1, 0] - x[0, 0]), abs=0.5 * cluster.step)
    assert 0 < contact["force"][0] < 5000.0 * 3e-5


def test_a_sphere_in_a_box_stays_there_and_threads_change_no_bit():
    law = ricochet.Linear(2000.0, 0.02)
    contact = ricochet.TangentialContact(ricochet.LinearTangential(500.0, 0.01), ricochet.Friction(0.4))
    grid = np.stack(np.meshgrid(*[np.arange(4) * 2.2e-3] * 3), axis=-1).reshape(-1, 3)
    ends = []
    for threads in (1, 2):
        cluster = ricochet.Cluster(
            grid,
            1e-3,
            2500.0,
            ricochet.Interaction(law, contact),
            velocities=np.random.default_rng(1).normal(0, 0.1, grid.shape),
            walls=ricochet.box_walls([-2e-3] * 3, [9e-3] * 3),
            gravity=(0, 0, -9.81),
            threads=threads,
        )
        cluster.advance(2000)
        ends.append(cluster.positions)
    assert (ends[0] == ends[1]).all()
    assert (ends[0] > -2e-3).all() and (ends[0] < 9e-3).all()


def test_no_contact_pulls_that_ends_by_force():
    cluster = pair(ricochet.calibrate("linear", 1e-4, 0.5), step=1e-6)
    least = []
    for _ in range(600):
        cluster.advance(1)
        least += cluster.contacts["force"].tolist()
    assert len(least) > 50 and min(least) == 0


def test_wrong_setups_are_named():
    with pytest.raises(ValueError, match=r"radii of shape \(3,\): must be \(2,\), or one number for all"):
        ricochet.Cluster(np.zeros((2, 3)), [1e-3] * 3, 2500, ricochet.Interaction(ricochet.Linear(1000, 0)))
    with pytest.raises(ValueError, match=r"positions of shape \(3,\): must be \(n, 3\)"):
        ricochet.Cluster([0, 0, 0], 1e-3, 1000, ricochet.Interaction(ricochet.Linear(1, 0)))
    with pytest.raises(ValueError, match=r"radii\[0\] = -0.001: must be finite and > 0"):
        ricochet.Cluster([[0, 0, 0]], -1e-3, 1000, ricochet.Interaction(ricochet.Linear(1, 0)), step=1e-6)


def test_what_is_no_interaction_is_named():
    with pytest.raises(TypeError, match="interactions = None: must be an Interaction or a dict"):
        ricochet.Cluster([[0.0, 0.0, 0.0]], 1e-3, 1e3, None)


def test_wrong_numbers_and_types_are_named_as_python_counts():
    law = ricochet.Interaction(ricochet.Linear(1000.0, 0.0))
    two = [[0, 0, 0], [1, 0, 0]]
    for name, error, call in (
        (r"radii\[1\] = 0.0: must be finite and > 0", ValueError, lambda: ricochet.Cluster(two, [1, 0], 1e3, law)),
        (r"velocities\[1, 2\] = nan: must be finite", ValueError,
         lambda: ricochet.Cluster(two, 1e-3, 1e3, law, velocities=[[0, 0, 0], [0, 0, np.nan]])),
        (r"interactions\[\(0, 0\)\] = .*Linear.*: must be an Interaction", TypeError,
         lambda: ricochet.Cluster(two, 1e-3, 1e3, {(0, 0): ricochet.Linear(1.0, 0.0)})),
        (r"interactions\[0\]: must be a pair of materials", TypeError,
         lambda: ricochet.Cluster(two, 1e-3, 1e3, {0: law})),
        ("walls: must be of Wall, not 3", TypeError, lambda: ricochet.Cluster(two, 1e-3, 1e3, law, walls=[3])),
        ("threads = 1.5: must be a whole number", TypeError,
         lambda: ricochet.Cluster(two, 1e-3, 1e3, law, threads=1.5, step=1e-6)),
        ("gravity: must be real numbers", TypeError, lambda: ricochet.Cluster(two, 1e-3, 1e3, law, gravity="down")),
        ("materials = ", ValueError,
         lambda: ricochet.Cluster(two, 1e-3, 1e3, law, materials=np.ma.array([0, 0], mask=[1, 1]))),
    ):
        with pytest.raises(error, match=f"^{name}"):
            call()
    cluster = pair(ricochet.Linear(5000.0, 0.01), step=1e-6)
    with pytest.raises(ValueError, match="steps = -1: must be at least 0"):
        cluster.advance(-1)
    with pytest.raises(TypeError, match="steps = 10.0: must be a whole number"):
        cluster.advance(10.0)
    cluster.advance(np.int64(3))
    assert cluster.time == pytest.approx(3e-6)


def test_the_handler_of_a_signal_may_look():
    cluster = pair(ricochet.Linear(5000.0, 0.01), step=1e-6)
    seen = []
    before = signal.signal(signal.SIGALRM, lambda *_: seen.append(cluster.time))
    signal.setitimer(signal.ITIMER_REAL, 0.01, 0.01)
    try:
        cluster.advance(400_000)
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
        signal.signal(signal.SIGALRM, before)
    assert seen and all(0 <= time <= 0.4 for time in seen)
    assert cluster.time == pytest.approx(0.4)


def test_a_drum_that_spins_drags_what_lies_in_it():
    mass, k, mu, radius = 4 / 3 * np.pi * 1.5e-3**3 * 2500, 2000.0, 0.5, 0.01
    contact = ricochet.TangentialContact(friction=ricochet.Friction(mu))

    def velocity_and_spin(spin):
        cluster = ricochet.Cluster(
            [[0, 0, -(radius - 1.5e-3) - mass * 9.81 / k]],  # at rest on the spring
            1.5e-3,
            2500.0,
            ricochet.Interaction(ricochet.Linear(k, 0.1), contact),
            walls=[ricochet.Wall.cylinder((0, 0, 0), (0, 1, 0), radius, spin=spin)],
            gravity=(0, 0, -9.81),
            step=1e-6,
        )
        cluster.advance(500)
        return cluster.velocities[0], cluster.spins[0]

    # The lowest point of the wall goes at -3 radii a second along x: mu g for as long as it slides, 1.7 ms or so.
    velocity, spin = velocity_and_spin(3.0)
    assert velocity[0] == pytest.approx(-mu * 9.81 * 5e-4, rel=5e-3)
    assert abs(spin[1]) * 1.5e-3 == pytest.approx(2.5 * mu * 9.81 * 5e-4, rel=5e-3)
    velocity, spin = velocity_and_spin(0.0)
    assert np.abs(velocity).max() < 1e-6 and np.abs(spin).max() < 1e-6


def test_a_step_that_resolves_no_contact_is_refused():
    law = ricochet.calibrate("linear", 1e-4, 0.9, mass_eff=7.06858e-6)
    with pytest.raises(ValueError, match="step = 5e-05: must be at most .* s, a 20th of the stiffest contact's time"):
        pair(law, step=5e-5)
    assert pair(law).step == pytest.approx(2.5e-6, rel=0.1)
    with pytest.raises(AttributeError):
        pair(law).step = 1e-6
    with pytest.raises(ValueError, match="step = None: must be given where no two bodies can touch"):
        ricochet.Cluster([[0, 0, 0]], 1e-3, 1000, ricochet.Interaction(law))


def test_what_would_be_guessed_is_refused():
    law = ricochet.Interaction(ricochet.Linear(1000.0, 0.0))
    two = ([[0, 0, 0], [1, 0, 0]], 1e-3, 1000.0)
    with pytest.raises(ValueError, match=r"materials = \[0, 0.99\]: must be whole numbers from 0"):
        ricochet.Cluster(*two, law, materials=[0, 0.99])
    with pytest.raises(ValueError, match="must have the materials 1 and 0 once"):
        ricochet.Cluster(*two, {(0, 1): law, (1, 0): law, (0, 0): law, (1, 1): law}, materials=[0, 1])
    for name in ("velocities", "spins"):
        with pytest.raises(ValueError, match=rf"{name} of shape \(\): must be \(3,\) or \(2, 3\)"):
            ricochet.Cluster(*two, law, **{name: 0.5})
    with pytest.raises(ValueError, match="torsion_spring: must be given with torsion_limit"):
        ricochet.TangentialContact(torsion_spring=ricochet.Spring(1.0))
    with pytest.raises(ValueError, match="rolling_spring: must be given with a mu_rolling > 0"):
        ricochet.TangentialContact(rolling_spring=ricochet.Spring(1.0))


def test_one_thread_at_a_time():
    cluster = pair(ricochet.Linear(5000.0, 0.01), step=1e-6)
    seen = []

    def look():
        while not done:
            try:
                seen.append(cluster.time)
            except RuntimeError as error:
                seen.append(str(error))

    done = False
    other = threading.Thread(target=look)
    other.start()
    cluster.advance(1_000_000)
    done = True
    other.join()
    assert "the cluster is being advanced by another thread" in seen
    # Between two portions of steps it may be seen, in the middle of one never.
    assert {round(time * 1e6) % 256 for time in seen if not isinstance(time, str)} <= {0, 1_000_000 % 256}
    assert cluster.time == pytest.approx(1.0)
