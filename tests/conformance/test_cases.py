"""How adapters read cases: what they take of one, and what they say of a wrong one."""

import json
import math
import os
import subprocess
import sys

import pytest
from pair_case import K, MASS, PAIR, RADIUS, TCOL, changed, kit, read, written


def test_a_run_starts_before_the_touch_and_has_whole_steps(tmp_path):
    pair = read(tmp_path)
    assert pair.step(50) == TCOL / 50
    assert pair.count(50) == math.ceil(1.5 + 1.73 * 50)
    start = pair.start(50)
    assert [b.position[0] for b in start] == pytest.approx([-RADIUS - 0.25 * 1.5 * TCOL / 50,
                                                            RADIUS + 0.25 * 1.5 * TCOL / 50], rel=1e-15)
    assert [b.velocity for b in start] == [b.velocity for b in pair.bodies]


@pytest.mark.parametrize("scales", [3, 7, 12, 40])
def test_a_duration_of_whole_steps_is_not_made_longer_by_rounding(tmp_path, scales):
    pair = read(tmp_path, flight_steps=0, duration=scales * TCOL)
    assert [pair.count(n) for n in (25, 49, 800)] == [scales * 25, scales * 49, scales * 800]


def test_with_gravity_the_start_and_the_end_are_written(tmp_path):
    falling = read(tmp_path, gravity=[-9.81, 0, 0], flight_steps=0)
    assert falling.every(50) == falling.count(50)
    assert read(tmp_path).every(50) == 1


def test_nobody_leaves_the_box(tmp_path):
    pair = read(tmp_path)
    assert pair.half_box() > 3 * RADIUS + 0.25 * pair.duration
    falling = read(tmp_path, gravity=[-9.81, 0, 0], duration=1000 * TCOL)
    assert falling.half_box() > RADIUS + 0.5 * 9.81 * falling.duration**2 + 0.25 * falling.duration


def test_pairs_have_effective_masses_and_radii(tmp_path):
    a, b = read(tmp_path).bodies
    b = b._replace(mass=3 * MASS, radius=2 * RADIUS)
    assert kit.effective_mass(a, b) == pytest.approx(0.75 * MASS) and kit.effective_mass(a, None) == MASS
    assert kit.effective_radius(a, b) == pytest.approx(2 / 3 * RADIUS) and kit.effective_radius(a, None) == RADIUS
    assert a.density == pytest.approx(MASS / (4 / 3 * math.pi * RADIUS**3), rel=1e-15)


TORSION = {"arm": 0.5, "stiffness": 1e-3, "damping": 0}
ROUGH = {"name": "linear", "parameters": {"k_t": 2000, "c_t": 0}, "mu": 0.3, "torsion": False, "mu_rolling": 0,
         "k_rolling": 0, "c_rolling": 0}
WALL = {"point": [0, 0, 0], "normal": [1, 0, 0]}


def of_law(name, **parameters):
    return {"name": name, "parameters": parameters, "end": "force"}


@pytest.mark.parametrize("path, value, message", [
    ("schema", "ricochet/case/2", 'schema = "ricochet/case/2": must be ricochet/case/1'),
    ("case", "a\nb", 'case = "a\\nb": must be a name of letters, digits, _ . and -, 100 at most'),
    ("bodies.1.radius", 0, "bodies[1].radius = 0: must be a number > 0"),
    ("bodies.0.mass", "heavy", 'bodies[0].mass = "heavy": must be a number > 0'),
    ("bodies.0.mass", -1, "bodies[0].mass = -1: must be a number > 0"),
    ("bodies.0.mass", 1e-60, "bodies[0].mass = 1e-60: must be a number > 0, from 1e-50 to 1e+50 in size"),
    ("bodies.0.inertia", math.nan, "bodies[0].inertia = NaN: must be a number > 0"),
    ("bodies.0.velocity", [1, 2], "bodies[0].velocity = [1, 2]: must be three numbers"),
    ("bodies.0.velocity", [1, 2, 1e60], "velocity[2] = 1e+60: must be a number, from 1e-50 to 1e+50 in size"),
    ("bodies.0.spin", None, "bodies[0]: spin is missing"),
    ("bodies.0.colour", "red",
     'bodies[0]: unknown key "colour"; known are radius, mass, inertia, position, velocity, spin'),
    ("bodies", [], "bodies = []: must be an array that is not empty"),
    ("steps", [50, 0.5], "steps[1] = 0.5: must be a whole number from 1 to 10000000"),
    ("steps", [50, 10**30], f"steps[1] = {1e30}: must be a whole number from 1 to 10000000"),
    ("steps", [], "steps = []: must be an array that is not empty"),
    ("steps", [50, 50], "steps = [50, 50]: must be numbers that differ"),
    ("duration", True, "duration = true: must be a number > 0"),
    ("duration", 1e9, "duration = 1000000000.0: must be at most 1e+06 times time_scale"),
    ("flight_steps", -1, "flight_steps = -1: must be a number >= 0"),
    ("flight_steps", 1e7, "flight_steps = 10000000.0: must be at most 1e+06"),
    ("gravity", 9.81, "gravity = 9.81: must be an array"),
    ("law.end", "rest", 'law.end = "rest": must be force or overlap'),
    ("law.name", "hertz", 'law.name = "hertz": must be linear or kuwabara-kono or tsuji or hysteretic or fractional or '
                          "fractional-kelvin-voigt or fractional-hertz or fractional-zener"),
    ("law.parameters.k", math.inf, "law.parameters.k = Infinity: must be a number > 0"),
    ("law.parameters.c", -1, "law.parameters.c = -1: must be a number >= 0"),
    ("law.parameters.c", None, "law.parameters: c is missing"),
    ("law.parameters.alpha", 0.5, 'law.parameters: unknown key "alpha"; known are k, c'),
    ("law", of_law("hysteretic", k1=3, k2=2), "law.parameters.k1 = 3: must be at most k2"),
    ("law", of_law("fractional-hertz", k=0, c=0, alpha=0.5), "law.parameters.c = 0: must be > 0 where k = 0"),
    ("law", of_law("fractional-zener", k=1, k1=1, tau=1, alpha=1.5), "law.parameters.alpha = 1.5: must be in [0, 1]"),
    ("law", of_law("fractional", k=1, c=0, alpha=0.5), "law.parameters.c = 0: must be a number > 0"),
    ("walls", [{**WALL, "normal": [0, 0, 0]}], "walls[0].normal = [0, 0, 0]: must be a vector of length 1"),
    ("walls", [WALL], "wall_law = null: must be a law, as there are walls"),
    ("law", "null", "law = null: must be a law, as there is no wall to meet"),
    ("bodies", PAIR["bodies"][:1], "must be null, as there is one body"),
    ("law", 1, "law = 1: must be an object"),
    ("tangential", {"name": "rough"}, "tangential: parameters is missing"),
    ("tangential", {**ROUGH, "mu": -1}, "tangential.mu = -1: must be a number >= 0"),
    ("tangential", {**ROUGH, "parameters": {"k_t": 0, "c_t": 0}}, "parameters.k_t = 0: must be a number > 0"),
    ("tangential", {**ROUGH, "mu_rolling": -0.1}, "tangential.mu_rolling = -0.1: must be a number >= 0"),
    ("tangential", {**ROUGH, "mu_rolling": 0.1}, "tangential.k_rolling = 0: must be a number > 0"),
    ("tangential", {**ROUGH, "torsion": True}, "tangential.torsion = true: must be an object"),
    ("tangential", {**ROUGH, "torsion": {**TORSION, "arm": -1}}, "tangential.torsion.arm = -1: must be a number > 0"),
    ("tangential", {**ROUGH, "torsion": {**TORSION, "damping": -1}}, "torsion.damping = -1: must be a number >= 0"),
])
def test_a_wrong_case_is_told_in_one_line(tmp_path, path, value, message):
    file = tmp_path / "wrong.json"
    file.write_text(json.dumps(changed(path, value)).replace('"null"', "null"))
    with pytest.raises(kit.BadCase) as told:
        kit.read_case(file)
    assert str(told.value).startswith(f"{file}: ") and str(told.value).endswith(message)
    assert "\n" not in str(told.value)


@pytest.mark.parametrize("text, message", [
    ('{"case": ', "is no JSON: Expecting value: line 1 column 10 (char 9)"),
    ("[" * 100_000, "brackets in too many brackets; must be fewer"),
    ('{"schema": ' * 100_000, "brackets in too many brackets; must be fewer"),
    ('{"schema": ' + "[" * 900 + "]" * 900 + "}", f"schema = {'[' * 57}...: must be ricochet/case/1"),
    ('{"a": 1, "a": 2}', 'key "a" is given twice in one object; it must be given once'),
    ("[]", "[]: must be an object"),
    ("\xff", "is no JSON: 'utf-8' codec can't decode byte 0xff in position 0: invalid start byte"),
])
def test_what_is_no_case_is_refused(tmp_path, text, message):
    file = tmp_path / "broken.json"
    file.write_bytes(text.encode("latin-1"))
    with pytest.raises(kit.BadCase) as told:
        kit.read_case(file)
    assert str(told.value).startswith(str(file)) and str(told.value).endswith(message)


@pytest.mark.parametrize("written_as, shown", [
    ("1e400", "1e400"), ("1" + 400 * "0", "1" + 56 * "0" + "..."), ("1" + 5000 * "0", "1" + 56 * "0" + "..."),
    ("-1e999", "-1e999"), ("NaN", "NaN"), ("-Infinity", "-Infinity")])
def test_numbers_that_are_none_are_shown_as_they_stand(tmp_path, written_as, shown):
    file = tmp_path / "great.json"
    for path, accepted in (("bodies.0.mass", "a number > 0"), ("duration", "a number > 0"),
                           ("bodies.1.spin.2", "a number")):
        file.write_text(json.dumps(changed(path, "HERE")).replace('"HERE"', written_as))
        with pytest.raises(kit.BadCase) as told:
            kit.read_case(file)
        assert str(told.value).endswith(f" = {shown}: must be {accepted}")


@pytest.mark.parametrize("text", [
    lambda case: "\ufeff" + case, lambda case: case.replace(",", ",\r\n"), lambda case: case.replace(",", ",\t\r")])
def test_marks_and_line_ends_of_other_systems_are_read(tmp_path, text):
    file = tmp_path / "pair.json"
    file.write_bytes(text(json.dumps(PAIR)).encode())
    assert kit.read_case(file) == read(tmp_path, case="pair")


def test_folders_without_cases_are_refused(tmp_path):
    with pytest.raises(kit.BadCase, match="No such file"):
        kit.read_case(tmp_path / "absent.json")
    with pytest.raises(kit.BadCase, match="is no folder"):
        kit.read_cases(str(tmp_path / "absent"), [])
    with pytest.raises(kit.BadCase, match="holds no case"):
        kit.read_cases(str(tmp_path), [])
    written(tmp_path)
    (tmp_path / "same.json").write_text((tmp_path / "pair.json").read_text())
    with pytest.raises(kit.BadCase, match="same.json: case = pair: must be of no other file of the folder"):
        kit.read_cases(str(tmp_path), [])


def test_cases_are_chosen_by_name(tmp_path):
    for name in ("b", "a", "c"):
        written(tmp_path, case=name)
    assert [c.name for c in kit.read_cases(str(tmp_path), [])] == ["a", "b", "c"]
    assert [c.name for c in kit.read_cases(str(tmp_path), ["c", "a"])] == ["a", "c"]
    with pytest.raises(kit.BadCase, match="--only d: must be one of a, b, c"):
        kit.read_cases(str(tmp_path), ["d"])


def test_what_a_case_asks_of_an_engine(tmp_path):
    pair = read(tmp_path)
    assert kit.parameters_of(pair.law, linear=("k", "c")) == (K, 0)
    assert kit.parameters_of(pair.law, tsuji=("k", "c")) is None
    kit.require_solid_spheres(pair)
    hollow = pair._replace(bodies=[pair.bodies[0]._replace(inertia=2 / 3 * MASS * RADIUS**2)])
    with pytest.raises(kit.NotRun, match="body 1 is no solid sphere"):
        kit.require_solid_spheres(hollow)
    assert kit.axis_of(kit.Wall((0, 0, 0), (0, -1, 0))) == (1, -1)
    with pytest.raises(kit.NotRun, match="no axis"):
        kit.axis_of(kit.Wall((0, 0, 0), (0.6, 0.8, 0)))


@pytest.mark.parametrize("nu", [-0.5, 0.0, 0.3, 0.5])
def test_poissons_ratio_of_a_ratio_of_stiffnesses(nu):
    young = 1e7
    normal, shear = young / (2 * (1 - nu**2)), young / (2 * (1 + nu)) / (2 * (2 - nu))
    assert kit.poisson_of(shear / normal) == pytest.approx(nu, abs=1e-14)


@pytest.mark.parametrize("ratio", [0.1, 1 / 3, 0.5, 2.0])
def test_no_material_shears_so(ratio):
    with pytest.raises(kit.NotRun, match="Poisson"):
        kit.poisson_of(ratio)


@pytest.mark.skipif("RICOCHET_VERIFY" not in os.environ, reason="verify is not named")
def test_the_adapters_read_what_verify_writes(tmp_path):
    subprocess.run([os.environ["RICOCHET_VERIFY"], "conformance", "--cases", tmp_path], check=True,
                   stdout=subprocess.DEVNULL)
    cases = kit.read_cases(str(tmp_path), [])
    assert len(cases) > 30
    assert {c.law.name for c in cases if c.law} >= {"linear", "kuwabara-kono", "tsuji", "hysteretic", "fractional"}
    assert any(c.tangential and c.tangential.torsion for c in cases)
    for c in cases:
        kit.require_solid_spheres(c)


@pytest.mark.skipif("RICOCHET_SIMULATE" not in os.environ, reason="simulate is not named")
@pytest.mark.parametrize("name", kit.LAWS)
def test_laws_have_the_parameters_and_domains_that_core_gives_them(tmp_path, name):
    """Asked of simulate, whose scenes name laws as cases do."""
    good = {key: 0.5 for key in kit.LAWS[name]}

    def refusal(parameters):
        law = {"name": name, **parameters, "end": "force"}
        scene = {"step": 1e-6, "duration": 1e-6, "output_interval": 1e-6, "materials": {"grain": {}},
                 "interactions": [{"between": ["grain", "grain"], "law": law}],
                 "spheres": [{"radius": 1, "density": 1, "material": "grain", "position": [0, 0, 0]}]}
        (tmp_path / "scene.json").write_text(json.dumps(scene))
        ran = subprocess.run([os.environ["RICOCHET_SIMULATE"], "scene.json", "-o", "out"], cwd=tmp_path,
                             stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        return ran.stderr if ran.returncode else ""

    assert refusal(good) == ""
    assert 'unknown key "other"' in refusal({**good, "other": 1})
    for key, domain in kit.LAWS[name].items():
        assert f'"{key}" is missing' in refusal({k: v for k, v in good.items() if k != key})
        for value in (-1, 0, 0.5, 1, 1.5):
            told = refusal({**good, key: value})
            assert (f"law/{key} = {value}: must be" in told) == (not domain.contains(value)), told
