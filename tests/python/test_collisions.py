"""Laws, collisions, calibration and fits."""

import copy
import math
import pickle
import signal
import subprocess
import sys
import time
from decimal import Decimal
from fractions import Fraction

import numpy as np
import pytest

import ricochet

MASS = 7.06858e-6


def test_every_law_is_a_class_with_its_parameters():
    laws = ricochet.Law.__args__
    assert [law.name for law in laws] == list(ricochet.law_names)
    law = ricochet.Fractional(1e4, c=2.0, alpha=0.25)
    assert law == ricochet.law("fractional", k=1e4, c=2.0, alpha=0.25)
    assert law.parameters == {"k": 1e4, "c": 2.0, "alpha": 0.25}
    assert law.units["k"] == "kg/s^2" and law.alpha == 0.25
    assert eval(repr(law), vars(ricochet)) == law
    assert pickle.loads(pickle.dumps(law)) == law and copy.copy(law) == law and hash(copy.copy(law)) == hash(law)
    assert law != ricochet.Linear(1e4, 2.0)


def test_wrong_parameters_are_named():
    with pytest.raises(ValueError, match="k = -1: must be finite and > 0"):
        ricochet.Linear(-1, 0)
    with pytest.raises(ValueError, match="c: missing: must be given. Contact law linear"):
        ricochet.Linear(1, d=3)
    with pytest.raises(ValueError, match="3 parameters"):
        ricochet.Linear(1, 2, 3)
    with pytest.raises(TypeError, match="k = 'a': must be a number"):
        ricochet.Linear("a", 1)
    for lengths in ((3, 2, 1, 1, 1), (2, 3, 2, 2, 2), (3, 3, 3, 3, 2)):
        with pytest.raises(ValueError, match="columns of different lengths"):
            ricochet._core._DirectCalibrator()("linear", "force", *[np.ones(n) for n in lengths], 0.5, 100.0, True, ())
    with pytest.raises(ValueError, match="law = elastic: must be one of law_names"):
        ricochet.law("elastic", k=1)
    with pytest.raises(TypeError, match="law = 3: must be a contact law"):
        ricochet.collide(3, 0.5, MASS)


def test_a_linear_collision_by_its_closed_form():
    k, c = 7000.0, 0.05
    undamped = math.sqrt(k / MASS)
    ratio = c / (2 * math.sqrt(k * MASS))
    found = ricochet.collide(ricochet.Linear(k, c), [0.1, 1.0], MASS, end="overlap")
    damped = undamped * math.sqrt(1 - ratio**2)
    np.testing.assert_allclose(found.tcol, math.pi / damped, rtol=1e-11)
    np.testing.assert_allclose(found.en, math.exp(-math.pi * ratio * undamped / damped), rtol=1e-11)
    assert list(found.status) == ["ended_by_overlap", "ended_by_overlap"]
    np.testing.assert_allclose(found.max_overlap[1], 10 * found.max_overlap[0], rtol=1e-12)
    one = ricochet.collide(ricochet.Linear(k, c), 0.1, MASS)
    assert one.status == "ended_by_force" and isinstance(one.en, float)


def test_calibrated_laws_do_what_was_asked():
    tcol, en = np.meshgrid([1e-4, 2e-5], [0.3, 0.6, 0.95])
    for name in ("linear", "kuwabara-kono", "tsuji", "hysteretic", "fractional"):
        found = ricochet.calibrate(name, tcol, en)
        for at in np.ndindex(tcol.shape):
            law = ricochet.law(name, **{p: column[at] for p, column in found.items()})
            # The numerical path knows nothing of the tables that the parameters are from.
            achieved = ricochet.collide(law, 0.5, MASS, method="numerical")
            assert achieved.tcol == pytest.approx(tcol[at], rel=1e-9)
            assert achieved.en == pytest.approx(en[at], rel=1e-9)
        assert ricochet.calibrate(name, 1e-4, 0.3) == ricochet.law(name, **{p: v[0, 0] for p, v in found.items()})


@pytest.mark.parametrize("name", ["fractional-kelvin-voigt", "fractional-hertz", "fractional-zener"])
def test_laws_of_real_solids_hold_what_they_are_told(name):
    law = ricochet.calibrate(name, 1e-4, 0.8, alpha=0.4)
    assert law.alpha == 0.4
    achieved = ricochet.collide(law, 0.5, MASS)
    assert achieved.tcol == pytest.approx(1e-4, rel=1e-7) and achieved.en == pytest.approx(0.8, rel=1e-7)
    if name == "fractional-zener":
        assert law.k1 / law.k == pytest.approx(100, rel=1e-12)
        assert ricochet.calibrate(name, 1e-4, 0.8, stiffening=10.0).k1 < 20 * law.k


def test_a_stiffness_is_held():
    assert ricochet.calibrate("fractional", 1e-4, 0.5, stiffness=1234.0).k == pytest.approx(1234.0, rel=1e-15)


def test_what_cannot_be_reached_says_which_and_why():
    with pytest.raises(ValueError, match=r"^at index 1: en = 1e-300: must be in \[3\.7.*e-44, 1\.0\]: "):
        ricochet.calibrate("linear", 1e-4, [0.5, 1e-300], end="overlap")
    with pytest.raises(ValueError, match=r"^at index \(1, 2\): en = 1e-300"):
        ricochet.calibrate("linear", 1e-4, [[0.5, 0.6, 0.7], [0.8, 0.9, 1e-300]], end="overlap")
    with pytest.raises(ValueError, match="^en = 1e-300: must be in "):
        ricochet.calibrate("linear", 1e-4, 1e-300, end="overlap")
    with pytest.raises(ValueError, match="^at index 2: tcol = -1"):
        ricochet.calibrate("linear", [1e-4, 1e-5, -1.0], 0.5)
    found = ricochet.calibrate("linear", 1e-4, [0.5, 1e-300], end="overlap", unreachable="nan")
    assert np.isfinite(found["k"][0]) and np.isnan(found["k"][1])
    assert ricochet.calibrate("linear", 1e-4, 1e-300, end="overlap", unreachable="nan") is None
    with pytest.raises(ValueError, match="en = 2"):
        ricochet.calibrate("linear", 1e-4, 2.0)
    with pytest.raises(ValueError, match="unreachable = skip"):
        ricochet.calibrate("linear", 1e-4, 0.5, unreachable="skip")


def test_what_a_law_does_not_hold_is_refused():
    for name, held in (
        ("linear", {"alpha": 0.5}),
        ("fractional-hertz", {"stiffening": 10.0}),
        ("tsuji", {"stiffness": 1e4}),
        ("fractional-kelvin-voigt", {"stiffness": 3000.0, "alpha": 0.5}),
    ):
        with pytest.raises(ValueError, match=f"{list(held)[-1]}.*: (law {name} holds none|follows from the stiffness)"):
            ricochet.calibrate(name, 1e-4, 0.7, **held)


def test_a_collision_without_an_end_has_no_restitution():
    found = ricochet.collide(ricochet.Linear(1e3, 1e3), [0.5, 0.6], MASS, end="overlap")
    assert list(found.status) == ["no_separation"] * 2
    assert np.isnan(found.en).all() and np.isnan(found.tcol).all() and (found.max_overlap > 0).all()


def test_an_export_trusts_the_law_and_not_what_is_said_of_it():
    law = ricochet.calibrate("linear", 1e-4, 0.5)
    asked = ricochet.export_law("lammps", law, tcol=1e-4, en=0.5)

    def contact(snippet):
        return [line for line in snippet.text.splitlines() if line.startswith("pair_")]

    assert contact(ricochet.export_law("lammps", law)) == contact(asked) and len(contact(asked)) == 2
    assert repr(asked) == "<Snippet(lammps, exact)>"
    ricochet.export_law("lammps", ricochet.Linear(float(f"{law.k:.9g}"), float(f"{law.c:.9g}")), tcol=1e-4, en=0.5)
    with pytest.raises(ValueError, match="en = 0.9: the law gives 0.5"):
        ricochet.export_law("lammps", law, en=0.9)
    with pytest.raises(ValueError, match="tcol = 0.0001001: the law gives 0.0001"):
        ricochet.export_law("lammps", law, tcol=1.001e-4)
    with pytest.raises(ValueError, match="does not end, but by no_separation"):
        ricochet.export_law("lammps", ricochet.Linear(1e3, 1e3), end="overlap")


def test_gross_sliding_by_coulombs_law():
    mu, radius, mass = 0.1, 2.5e-3, 2.6e-4
    law = ricochet.calibrate("fractional", 1e-5, 0.8, velocity=1.0, mass_eff=mass)
    ball = ricochet.ImpactBody(mass, radius, velocity=(3.0, 0.0, 1.0))
    contact = ricochet.TangentialContact(friction=ricochet.Friction(mu))
    out = ricochet.collide_obliquely(law, contact, ball)
    change = mu * (1 + 0.8)
    assert out.velocity_i[0] == pytest.approx(3 - change, rel=1e-9)
    assert abs(out.spin_i[1]) * radius == pytest.approx(2.5 * change, rel=1e-9)
    assert out.impulse_ratio == pytest.approx(mu, rel=1e-9) and out.en == pytest.approx(0.8, rel=1e-9)
    assert ricochet.Friction(mu).mu_dynamic == mu and ricochet.Friction(mu, 0.05).mu_dynamic == 0.05
    assert sum(out.lost.values()) == pytest.approx(
        0.5 * mass * (10 - out.velocity_i @ out.velocity_i) - 0.2 * mass * radius**2 * out.spin_i @ out.spin_i, rel=1e-8
    )


def test_a_tangential_spring_reverses_the_slip():
    law = ricochet.Linear(1.72e7, 0.0)
    ball = ricochet.ImpactBody(2.6e-4, 2.5e-3, velocity=(0.05, 0.0, 1.0))
    spring = ricochet.TangentialContact(ricochet.LinearTangential(1.48e7 * 2 / 7), ricochet.Friction(0.5))
    assert ricochet.collide_obliquely(law, spring, ball).beta > 0.5
    with pytest.raises(ValueError, match="arm = point"):
        ricochet.collide_obliquely(law, spring, ball, arm="point")


def test_a_fit_finds_the_law_that_made_the_data():
    velocity = np.geomspace(0.05, 2, 20)
    law = ricochet.calibrate("kuwabara-kono", 1e-4, 0.7)
    en = ricochet.collide(law, velocity, MASS).en
    fit = ricochet.fit("kuwabara-kono", velocity, en, en_sigma=0.01)
    assert fit.chi2 < 1e-8 and fit.observations == 20 and fit.errors_known
    np.testing.assert_allclose(fit.predict_en(velocity), en, rtol=1e-6)
    assert all(p.error > 0 for p in fit.parameters.values())
    assert fit.aic < ricochet.fit("linear", velocity, en, en_sigma=0.01).aic
    assert isinstance(fit.predict_en(0.5), float) and repr(fit).startswith("<Fit(kuwabara-kono: ")
    with pytest.raises(ValueError, match="en_sigma = 0.0: must be > 0"):
        ricochet.fit("kuwabara-kono", velocity, en, en_sigma=0.0)


def test_every_column_of_a_collision_is_what_its_name_says():
    k, velocity = 7000.0, np.array([0.1, 1.0])
    found = ricochet.collide(ricochet.Linear(k, 0.0), velocity, MASS)
    frequency = math.sqrt(k / MASS)
    np.testing.assert_allclose(found.max_overlap, velocity / frequency, rtol=1e-11)
    np.testing.assert_allclose(found.max_force, velocity * math.sqrt(k * MASS), rtol=1e-11)
    np.testing.assert_allclose(found.time_max_overlap, math.pi / 2 / frequency, rtol=1e-9)
    np.testing.assert_allclose(found.time_max_force, math.pi / 2 / frequency, rtol=1e-9)
    assert np.abs(found.overlap_end).max() < 1e-15
    # Hysteretic: the overlap left is what k1 and k2 differ by.
    left = ricochet.collide(ricochet.Hysteretic(k, 4 * k), 1.0, MASS)
    assert left.overlap_end == pytest.approx(0.75 * left.max_overlap, rel=1e-9)


def test_a_fit_weighs_times_by_their_own_errors():
    velocity, mean = np.array([0.1, 0.3, 1.0]), 1e-4
    tcol = mean + np.array([1e-6, -1e-6, 0.0])
    fit = ricochet.fit("linear", velocity, np.full(3, 0.8), en_sigma=0.01, tcol=tcol, tcol_sigma=1e-6)
    assert fit.observations == 6 and fit.freedom == 4 and fit.errors_known
    assert fit.chi2 == pytest.approx(2, rel=1e-6)  # two of the times are one standard error off their mean
    # k of a contact ended by force that keeps 0.8 and takes the mean of the times.
    k = ricochet.calibrate("linear", mean, 0.8).k
    assert fit.parameters["k"].value == pytest.approx(k, rel=1e-6)


def test_bodies_that_do_not_part_have_no_numbers_after_it():
    i = ricochet.ImpactBody(1e-5, 1e-3, velocity=(0.1, 0, 1))
    for law, end, status in (
        (ricochet.Linear(5000, 10), "overlap", "no_separation"),
        (ricochet.Fractional(5000, 0.3, 1.2), "force", "permanent_contact"),
    ):
        hit = ricochet.collide_obliquely(law, ricochet.TangentialContact(), i, end=end)
        assert hit.status == status and hit.et is None and hit.beta is None
        for numbers in (hit.velocity_i, hit.velocity_j, hit.spin_i, hit.spin_j, hit.impulse, list(hit.lost.values())):
            assert np.isnan(numbers).all()
        assert np.isnan(hit.impulse_ratio)


def test_a_tangential_law_is_for_what_the_normal_one_does():
    law = ricochet.calibrate("linear", 1e-4, 0.5, mass_eff=1e-3)
    with pytest.raises(ValueError, match="tcol = 0.0001: the law gives"):
        ricochet.tangential_law_for("linear", law, beta0=0.5, tcol=1e-4, en=0.5)  # mass_eff forgotten
    with pytest.raises(ValueError, match="en = 0.6: the law gives 0.5"):
        ricochet.tangential_law_for("linear", law, beta0=0.5, tcol=1e-4, en=0.6, mass_eff=1e-3)
    found = ricochet.tangential_law_for("linear", law, beta0=0.5, tcol=1e-4, en=0.5, mass_eff=1e-3)
    # k_t = 2/7 m (pi^2 + ln^2 beta0)/tcol^2
    assert found.k_t == pytest.approx(2 / 7 * 1e-3 * (np.pi**2 + np.log(0.5) ** 2) / 1e-8, rel=1e-6)
    with pytest.raises(ValueError, match=r"^beta0 = 1.5: must be in \(0.0, 1.0\]: "):
        ricochet.tangential_law_for("linear", law, beta0=1.5, tcol=1e-4, en=0.5, mass_eff=1e-3)


def test_friction_and_its_spring_are_exported_together():
    law = ricochet.calibrate("linear", 1e-4, 0.5)
    with pytest.raises(ValueError, match="mu = 0.3: must have a tangential law"):
        ricochet.export_law("lammps", law, mu=0.3)
    with pytest.raises(ValueError, match="mu: must be given with a tangential law"):
        ricochet.export_law("lammps", law, tangential=ricochet.LinearTangential(1000.0))


def test_columns_that_were_measured_have_one_length():
    v, en = np.array([0.1, 0.2, 0.4]), np.array([0.93, 0.92, 0.9])
    for wrong in ((v[:, None], en), (v, 0.9), (v, en[:2])):
        with pytest.raises(ValueError, match="must be two columns of one length"):
            ricochet.fit("linear", *wrong)
    with pytest.raises(ValueError, match="tcol, tcol_sigma: must be given together"):
        ricochet.fit("linear", v, en, tcol=[1e-4] * 3)
    assert ricochet.fit("linear", v, en, en_sigma=0.01).observations == 3


def test_the_kernel_begins_at_0():
    kernel = ricochet.memory_kernel(0.3, 1e-6, 1e-3)
    for t in (-1.0, np.nan, [0.0, -1e-9]):
        with pytest.raises(ValueError, match="t = .*: must be"):
            kernel(t)
    assert kernel(0.0) > kernel(1e-6)


@pytest.mark.parametrize(
    "call",
    [
        "ricochet.collide(ricochet.FractionalHertz(1e6, 1e4, 0.5), np.linspace(0.1, 1, 100000), 1e-6)",
        "ricochet.calibrate('fractional-hertz', 1e-4, np.linspace(0.3, 0.9, 100000))",
        "ricochet.mittag_leffler(1.5, 2.0, np.linspace(-16, 2, 20_000_000))",
    ],
)
def test_ctrl_c_ends_a_call_of_many_numbers(call):
    # The program says when it begins; after a while it is interrupted, long before it would be done.
    program = f"import numpy as np, ricochet; print('begins', flush=True); {call}"
    child = subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    assert child.stdout.readline() == "begins\n"
    time.sleep(0.5)
    child.send_signal(signal.SIGINT)
    _, said = child.communicate(timeout=60)
    assert child.returncode != 0 and "KeyboardInterrupt" in said


def test_an_array_tells_which_of_its_numbers_is_wrong():
    with pytest.raises(ValueError, match=r"^at index \(0, 1\): velocity = -1"):
        ricochet.collide(ricochet.Linear(1e4, 0.1), [[0.5, -1.0]], MASS)
    with pytest.raises(ValueError, match="^at index 1: "):
        ricochet.fractional_contact([0.2, 1.5])
    with pytest.raises(ValueError, match="^at index 1: en = 2"):
        ricochet.conversion_degree([0.2, 2.0])
    x = np.zeros((2, 120_000))
    x[1, 3] = 9.0
    with pytest.raises(ValueError, match=r"^at index \(1, 3\): x = 9"):
        ricochet.mittag_leffler(1.0, 1.0, x)
    with pytest.raises(ValueError, match="^x = 9"):
        ricochet.mittag_leffler(1.0, 1.0, 9.0)
    with pytest.raises(ValueError, match="^at index 1: coefficient = -1"):
        ricochet.tcol_estimate([1.0, -1.0], 0.5)


def test_what_is_no_number_is_none():
    hidden = np.ma.array([0.5, 0.6], mask=[False, True])
    for call in (lambda en: ricochet.calibrate("linear", 1e-4, en), lambda x: ricochet.mittag_leffler(0.5, 1.0, x)):
        with pytest.raises(ValueError, match="^(en|x): has masked values"):
            call(hidden)
        for wrong in ("0.5", ["0.5"], 0.5j, [0.5, None]):
            with pytest.raises(TypeError, match="^(en|x): must be real numbers, not "):
                call(wrong)
    shown = ricochet.mittag_leffler(0.5, 1.0, np.ma.array([0.5, 0.6]))
    assert shown.tolist() == ricochet.mittag_leffler(0.5, 1.0, [0.5, 0.6]).tolist()


def test_numbers_of_any_kind_are_numbers():
    law, en = ricochet.Linear(1e4, 0.1), ricochet.collide(ricochet.Linear(1e4, 0.1), 0.5, MASS).en
    for half in (Fraction(1, 2), Decimal("0.5"), np.float32(0.5), np.array(0.5), np.array(0.5, dtype=object)):
        assert ricochet.collide(law, half, MASS).en == en
    assert ricochet.calibrate("fractional-hertz", 1e-4, 0.5, alpha=Fraction(1, 2)).alpha == 0.5
    assert ricochet.tcol_estimate(10**20, 0.5) == ricochet.tcol_estimate(1e20, 0.5)
    for velocity in ([1, 2, 3], np.array([1, 2, 3]), np.array([1, 2, 3], dtype=np.float32)):
        assert "velocity=[1.0, 2.0, 3.0]" in repr(ricochet.ImpactBody(1, 1, velocity))
    for wrong in (np.array(["1", "2", "3"]), np.array([1j, 2, 3])):
        with pytest.raises(TypeError):
            ricochet.ImpactBody(1, 1, wrong)


def test_what_is_of_another_type_is_named():
    v, en, law = np.array([0.1, 0.2, 0.4]), np.array([0.93, 0.92, 0.9]), ricochet.Linear(1e4, 0.1)
    for name, call in (
        ("law = 3: must be a str", lambda: ricochet.calibrate(3, 1e-4, 0.5)),
        ("law = .*: must be a str", lambda: ricochet.fit(law, v, en)),
        ("mass_eff = '1': must be a number", lambda: ricochet.fit("linear", v, en, mass_eff="1")),
        ("alpha = 'a': must be a number", lambda: ricochet.calibrate("fractional-hertz", 1e-4, 0.5, alpha="a")),
        ("end = None: must be a str", lambda: ricochet.fractional_contact(0.5, None)),
        ("tangential = 0.5: must be of TangentialContact", lambda: ricochet.collide_obliquely(law, 0.5, 1)),
        ("i = 1: must be of ImpactBody", lambda: ricochet.collide_obliquely(law, ricochet.TangentialContact(), 1)),
    ):
        with pytest.raises(TypeError, match=f"^{name}"):
            call()


def test_what_is_printed_can_be_read_back():
    names, mindlin, spring = vars(ricochet), ricochet.MindlinTangential(5.0), ricochet.Spring(1.0)
    contact = ricochet.TangentialContact(
        ricochet.LinearTangential(500.0, 0.01),
        ricochet.Friction(0.4, 0.3, 2.0, 0.1),
        torsion_limit="disc",
        torsion_spring=ricochet.Spring(1.0, 2.0),
        mu_rolling=0.01,
        rolling_spring=ricochet.Spring(3.0),
    )
    for thing in (
        contact,
        ricochet.TangentialContact(mindlin, torsion_limit="separate", torsion_spring=spring, torsion_arm=0.25),
        ricochet.TangentialContact(),
        ricochet.ImpactBody(1e-3, 2e-3, (0, 1, 2), (3, 4, 5), 0.5),
        ricochet.ImpactBody.wall((0, 0, 1)),
        ricochet.Wall.plane((0, 0, 1), (0, 0, 1), 2, (1, 0, 0)),
        ricochet.Wall.cylinder((0, 0, 1), (0, 1, 0), 0.5, 1, 2.0),
    ):
        again = eval(repr(thing), names)
        assert type(again) is type(thing) and repr(again) == repr(thing)
    assert repr(ricochet.ImpactBody(1e-3, 2e-3, (0, 1, 2))) == (
        "ImpactBody(mass=0.001, radius=0.002, velocity=[0.0, 1.0, 2.0], spin=[0.0, 0.0, 0.0], inertia_ratio=0.4)"
    )
    separate = ricochet.TangentialContact(mindlin, torsion_limit="separate", torsion_spring=spring, torsion_arm=0.25)
    assert "torsion_arm=0.25" in repr(separate) and "torsion_limit='separate'" in repr(separate)
    spinning = ricochet.ImpactBody(np.inf, 1e-3, (0, 0, 0), (0, 300, 0))
    assert "mass=inf" in repr(spinning) and "spin=[0.0, 300.0, 0.0]" in repr(spinning)
    interaction = repr(ricochet.Interaction(ricochet.Linear(1.0, 0.0), contact, end="overlap"))
    assert interaction == f"<Interaction(law='linear', tangential={contact!r}, end='overlap')>"


def test_what_was_never_made_can_be_shown():
    for kind in (
        ricochet.Interaction,
        ricochet.TangentialContact,
        ricochet.Spring,
        ricochet.Wall,
        ricochet.Linear,
        ricochet.Fit,
        ricochet.Snippet,
    ):
        assert repr(kind.__new__(kind)) == f"<{kind.__name__} without a value>"
