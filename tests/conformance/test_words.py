"""The engines' words for laws, of which docs/engines.md tells."""

import math

import pytest
from pair_case import K, MASS, PAIR, RADIUS, TCOL, kit, read

import lammps
import liggghts
import simulate
import yade


FRACTIONAL = {"name": "fractional", "parameters": {"k": K, "c": 0.1, "alpha": 0.5}, "end": "force"}


def law(name, end="force", **parameters):
    return kit.Law(name, parameters, end)


def test_lammps_counts_damping_its_way(tmp_path):
    m, r = 7e-6, 7.5e-4
    assert lammps.normal(law("linear", k=K, c=0.1), m, r, 20210929) == f"hooke {K!r} 0.1 damping velocity"
    hertz = lammps.normal(law("kuwabara-kono", k=1e6, c=20), m, r, 20210929).split()
    assert float(hertz[1]) == pytest.approx(1e6 / math.sqrt(r))
    assert float(hertz[2]) == pytest.approx(20 / m / math.sqrt(r))
    # The polynomial's value is c/sqrt(m k); from 2024 on by the restitution of an attractive force.
    eta = 1.2 / math.sqrt(m * 1e6)
    old = lammps.normal(law("tsuji", k=1e6, c=1.2), m, r, 20210929).split()
    assert lammps.marshall(float(old[2])) == pytest.approx(eta, rel=1e-12) and old[3:] == ["damping", "tsuji"]
    new = lammps.normal(law("tsuji", k=1e6, c=1.2), m, r, 20250204).split()
    beta = -math.log(float(new[2])) / math.hypot(math.pi, math.log(float(new[2])))
    assert math.sqrt(5) * beta == pytest.approx(eta, rel=1e-12) and new[3:] == ["damping", "coeff_restitution"]
    with pytest.raises(kit.NotRun, match="no hysteretic law"):
        lammps.normal(law("hysteretic", k1=1, k2=2), m, r, 20210929)


def test_lammps_ricochet_has_styles_in_2021_and_sub_models_later(tmp_path):
    pair = read(tmp_path, law=FRACTIONAL)
    memory = repr(4 * TCOL)
    assert lammps.pairs(pair, 20210929) == f"pair_style fractional memory {memory}\npair_coeff * * {K!r} 0.1 0.5\n"
    assert f"fractional {K!r} 0.1 0.5 damping fractional/memory {memory} tangential" in lammps.pairs(pair, 20250204)
    solid = read(tmp_path, law={**FRACTIONAL, "name": "fractional-kelvin-voigt"})
    assert f"fractional/kelvin_voigt {K!r} 0.1 0.5 damping" in lammps.pairs(solid, 20250204)
    with pytest.raises(kit.NotRun, match="the fractional law alone"):
        lammps.pairs(solid, 20210929)
    with pytest.raises(kit.NotRun, match="lammps-ricochet has one"):
        lammps.require_laws("/usr/bin/lmp", pair)
    lammps.require_laws("/usr/bin/lammps-ricochet", pair)
    with pytest.raises(kit.NotRun, match="ends contacts by force"):
        lammps.require_laws("/usr/bin/lammps-ricochet", read(tmp_path, law={**FRACTIONAL, "end": "overlap"}))


def test_liggghts_takes_moduli_that_give_the_stiffness(tmp_path):
    wall = {"point": [-2 * RADIUS, 0, 0], "normal": [1, 0, 0]}
    two = read(tmp_path, law={"name": "tsuji", "parameters": {"k": 1e6, "c": 1.2}, "end": "force"}, walls=[wall],
               wall_law={"name": "tsuji", "parameters": {"k": 2e6, "c": 1.2}, "end": "force"})
    contacts = liggghts.Contacts("liggghts", two)
    fixes = [line.split() for line in contacts.properties().splitlines() if line.startswith("fix")]
    words = {fix[4]: fix[6:] for fix in fixes}
    young, nu = [float(x) for x in words["youngsModulus"]], float(words["poissonsRatio"][0])

    def stiffness(i, j, radius):
        return 4 / 3 / ((1 - nu**2) * (1 / young[i] + 1 / young[j])) * math.sqrt(radius)

    assert stiffness(0, 1, RADIUS / 2) == pytest.approx(1e6) and stiffness(1, 2, RADIUS) == pytest.approx(2e6)
    assert "limitForce on" in contacts.commands()
    with pytest.raises(kit.NotRun, match="liggghts-ricochet has one"):
        liggghts.Contacts("/usr/bin/liggghts", read(tmp_path, law=FRACTIONAL))


def test_yade_puts_springs_in_series(tmp_path):
    pair = read(tmp_path)
    assert f"kn={2 * K!r}" in yade.contacts(pair)
    assert 1 / (1 / 4.0 + 1 / yade.other_half("k", 4.0, 3.0)) == pytest.approx(3.0)
    # A wall twice as stiff is out of reach for springs in series: by tc and en, of half the sphere's mass there.
    wall = {"point": [-2 * RADIUS, 0, 0], "normal": [1, 0, 0]}
    stiff = read(tmp_path, walls=[wall], wall_law={**PAIR["law"], "parameters": {"k": 2 * K, "c": 0}})
    assert repr(math.pi * math.sqrt(MASS / 2 / (2 * K))) in yade.contacts(stiff)
    with pytest.raises(kit.NotRun, match="no wall has such a k beside these grains"):
        yade.other_half("k", 4.0, math.nextafter(4.0, 0))
    with pytest.raises(kit.NotRun, match="no kuwabara-kono law"):
        yade.contacts(read(tmp_path, law={**PAIR["law"], "name": "kuwabara-kono"}))


def test_scenes_cannot_say_every_rolling_spring(tmp_path):
    t = kit.Tangential("linear", 2000.0, 0.0, 0.5, None, 0.1, 1.4 * RADIUS**2 * 2000.0, 0.0)
    pair = read(tmp_path)
    simulate.require_own_rolling(pair, t)
    with pytest.raises(kit.NotRun, match="rolling"):
        simulate.require_own_rolling(pair, t._replace(k_rolling=1.01 * t.k_rolling))
