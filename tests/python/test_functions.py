"""Mittag-Leffler, the fractional collision and memory kernels, against values from elsewhere."""

import csv
import math
import pathlib

import numpy as np
import pytest

import ricochet

DATA = pathlib.Path(__file__).resolve().parents[2] / "data"


def table(name):
    with open(DATA / name, newline="") as file:
        rows = csv.DictReader(line for line in file if not line.startswith("#"))
        return list(rows)


def test_mittag_leffler_gives_the_reference_values():
    rows = table("mittag_leffler_reference.csv")
    a, b, x, wanted = (np.array([float(row[c]) for row in rows]) for c in list(rows[0])[:4])
    inside = (x <= 5) & (b <= 100)
    found = ricochet.mittag_leffler(a[inside], b[inside], x[inside])
    np.testing.assert_allclose(found, wanted[inside], rtol=1e-11)


def test_mittag_leffler_broadcasts_and_keeps_numbers_numbers():
    x = np.linspace(-3, 1, 5)
    both = ricochet.mittag_leffler([[1.0], [2.0]], 1.0, x)
    assert both.shape == (2, 5)
    np.testing.assert_allclose(both[0], np.exp(x), rtol=1e-13)
    np.testing.assert_allclose(both[1, x <= 0], np.cos(np.sqrt(-x[x <= 0])), rtol=1e-13)
    assert isinstance(ricochet.mittag_leffler(1, 1, 0.5), float)


def test_a_prepared_function_agrees_with_the_plain_one():
    x = np.linspace(-10, 2, 101)
    prepared = ricochet.MittagLeffler(1.5, 2.0)
    assert (prepared.a, prepared.b) == (1.5, 2.0)
    np.testing.assert_allclose(prepared(x), ricochet.mittag_leffler(1.5, 2.0, x), rtol=1e-11, atol=1e-13)


def test_a_number_outside_the_domain_is_named():
    with pytest.raises(ValueError, match="= 4"):
        ricochet.mittag_leffler(4, 1, 0)
    with pytest.raises(ValueError, match=r"shapes of .* must be such that one can be spread"):
        ricochet.mittag_leffler([1.0, 2.0], 1.0, [0.0, 1.0, 2.0])


def test_the_fractional_collision_and_its_inverse():
    alpha = np.array([0.05, 0.25, 0.5, 0.9])
    contact = ricochet.fractional_contact(alpha)
    np.testing.assert_allclose(ricochet.conversion_degree(contact.en), alpha, rtol=1e-11)
    # The force E_{2-a,2-a}(-z) vanishes at z_star, where the rate is -en.
    for i, a in enumerate(alpha):
        assert abs(ricochet.mittag_leffler(2 - a, 2 - a, -contact.z_star[i])) < 1e-12
        assert -ricochet.mittag_leffler(2 - a, 1, -contact.z_star[i]) == pytest.approx(contact.en[i], rel=1e-11)
    assert ricochet.fractional_contact(0.25, "overlap").en < ricochet.fractional_contact(0.25).en
    with pytest.raises(ValueError, match="end = middle: must be force or overlap"):
        ricochet.fractional_contact(0.25, "middle")


def test_a_memory_kernel_is_a_power_of_time():
    kernel = ricochet.memory_kernel(0.4, 1e-3, 1.0, 1e-9)
    t = np.geomspace(1e-3, 1, 200)
    np.testing.assert_allclose(kernel(t), t**-0.4 / math.gamma(0.6), rtol=1.01 * kernel.error)
    by_hand = kernel.spring + (kernel.strengths * np.exp(-np.multiply.outer(t, kernel.rates))).sum(axis=1)
    np.testing.assert_allclose(kernel(t), by_hand, rtol=1e-13)
    assert kernel.error <= 1e-9 and (kernel.strengths > 0).all()


def test_the_extremes_of_the_fractional_collision_are_those_of_its_motion():
    a = 0.25
    contact = ricochet.fractional_contact(a)
    A = contact.z_star  # in units of v0 and tcol
    t = np.linspace(0, 1, 20001)[1:]
    z = A * t ** (2 - a)
    overlap = t * ricochet.mittag_leffler(2 - a, 2, -z)
    force = A * t ** (1 - a) * ricochet.mittag_leffler(2 - a, 2 - a, -z)
    assert contact.max_overlap == pytest.approx(overlap.max(), rel=1e-8)
    assert contact.t_max_overlap == pytest.approx(t[overlap.argmax()], abs=1e-4)
    assert contact.max_force == pytest.approx(force.max(), rel=1e-8)
    assert contact.t_max_force == pytest.approx(t[force.argmax()], abs=1e-4)
    assert contact.overlap_end == pytest.approx(overlap[-1], rel=1e-10)
    assert contact.tau ** (2 - a) == pytest.approx(contact.z_star, rel=1e-12)


def test_many_numbers_are_those_of_few():
    # Portions of 100,000: across their borders, broadcast, and in more dimensions than one.
    x = np.linspace(-3, 0, 250_001)
    many = ricochet.mittag_leffler(1.5, 2.0, x)
    for at in (0, 99_998, 99_999, 100_000, 100_001, 199_999, 200_000, 250_000):
        assert many[at] == ricochet.mittag_leffler(1.5, 2.0, float(x[at]))
    table = ricochet.mittag_leffler([[1.25], [1.5]], 2.0, x[:60_001])
    assert table.shape == (2, 60_001)
    assert (table[1] == many[:60_001]).all()
    assert table[0, 60_000] == ricochet.mittag_leffler(1.25, 2.0, float(x[60_000]))
