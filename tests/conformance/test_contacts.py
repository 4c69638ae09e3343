"""What adapters measure of a path: body 1's first contact."""

import math

import pytest
from pair_case import K, MASS, PAIR, RADIUS, TCOL, body, read

import outcome


def swing(pair, n, end_of_force=math.inf, rub=0.0):
    """The exact path of the undamped pair, which stays pressed by no force after `end_of_force`."""
    omega = math.sqrt(K / (MASS / 2))
    path = []
    for i in range(pair.count(n) + 1):
        t = (i - pair.flight_steps) * pair.step(n)
        overlap = 0.5 / omega * math.sin(omega * t) if 0 <= t <= TCOL else 0.5 * t if t < 0 else 0.5 * (TCOL - t)
        force = -K * overlap if 0 < t < end_of_force and overlap > 0 else 0.0
        places = (-RADIUS + overlap / 2, RADIUS - overlap / 2)
        path.append(outcome.Instant([outcome.State((x, 0, 0), (0, 0, 0), (0, 0, 0)) for x in places], (force, rub, 0)))
    return path


@pytest.mark.parametrize("end", ["force", "overlap"])
def test_time_and_depth_of_a_contact_come_from_the_path_at_second_order(tmp_path, end):
    pair = read(tmp_path, law={**PAIR["law"], "end": end})
    depth = 0.5 / math.sqrt(K / (MASS / 2))
    errors = []
    for n in (50, 100, 200):
        time, deepest = outcome.first_contact(pair, pair.step(n), swing(pair, n))
        errors.append(abs(time / TCOL - 1))
        # The parabola's own error is of fourth order, (pi/n)^4/50 or so.
        assert abs(deepest / depth - 1) < (math.pi / n) ** 4 / 20
    # The sine bends little at its zeros: third order, (pi/n)^3/6 at most, at either end.
    assert all(error < 2 * (math.pi / n) ** 3 / 6 for error, n in zip(errors, (50, 100, 200)))
    assert errors[2] > 0


def test_a_clipped_force_ends_where_the_last_two_that_repel_point_to(tmp_path):
    pair = read(tmp_path)
    time, _ = outcome.first_contact(pair, pair.step(100), swing(pair, 100, 0.9 * TCOL))
    # The line through two forces before 0.9 t_col reaches zero by the slope there, near t_col itself.
    assert 0.9 < time / TCOL < 1.01


def test_no_contact_and_a_lasting_one_have_no_time(tmp_path):
    pair = read(tmp_path)
    path = swing(pair, 50)
    assert outcome.first_contact(pair, pair.step(50), path[:2]) == (None, None)
    assert outcome.first_contact(pair, pair.step(50), path[10:]) == (None, None)
    time, depth = outcome.first_contact(pair, pair.step(50), path[:40])
    assert time is None and depth > 0
    forceless = [instant._replace(force=None) for instant in path]
    assert outcome.first_contact(pair, pair.step(50), forceless)[0] is None


def test_body_1_that_meets_two_at_once_has_a_depth_alone(tmp_path):
    bodies = PAIR["bodies"] + [{**body(-3 * RADIUS, 0)}]
    three = read(tmp_path, bodies=bodies)
    path = [instant._replace(bodies=[*instant.bodies, outcome.State((-3 * RADIUS + 1e-7, 0, 0), (0, 0, 0), (0, 0, 0))])
            for instant in swing(three, 50)]
    assert outcome.first_contact(three, three.step(50), path) == (None, None)  # it overlaps at the start
    path[0] = path[0]._replace(bodies=[*path[0].bodies[:2], outcome.State((-9 * RADIUS, 0, 0), (0, 0, 0), (0, 0, 0))])
    time, depth = outcome.first_contact(three, three.step(50), path)
    assert time is None and depth is not None


def test_a_wall_is_met_along_its_normal(tmp_path):
    wall = {"point": [-2 * RADIUS, 0, 0], "normal": [1, 0, 0]}
    one = read(tmp_path, bodies=[body(-RADIUS, -0.5)], walls=[wall], wall_law=PAIR["law"], law=None)
    instant = outcome.Instant([outcome.State((-1.2 * RADIUS, 1, 2), (0, 0, 0), (0, 0, 0))])
    overlap, normal = outcome.overlaps(one, instant)[0]
    assert overlap == pytest.approx(0.2 * RADIUS) and normal == (1, 0, 0)


def test_a_run_that_is_not_whole_is_a_failure(tmp_path):
    pair = read(tmp_path)
    path = swing(pair, 50)
    assert outcome.run_of_path(pair, 50, path).bodies == path[-1].bodies
    with pytest.raises(outcome.EngineFailed, match="states came back"):
        outcome.run_of_path(pair, 50, path[:-1])
    lost = path[-1]._replace(bodies=[outcome.State((math.nan, 0, 0), (0, 0, 0), (0, 0, 0))] * 2)
    on_each_other = outcome.Instant([path[0].bodies[0]] * 2)
    assert outcome.overlaps(pair, on_each_other)[0][0] == 2 * RADIUS
    with pytest.raises(outcome.EngineFailed, match="no number"):
        outcome.run_of_path(pair, 50, path[:-1] + [lost])
