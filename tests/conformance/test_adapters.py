"""What the adapters of the conformance kit share, without an engine: cases, contacts along a path, results."""

import copy
import json
import math
import os
import pathlib
import stat
import subprocess
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
ADAPTERS = ROOT / "engines" / "conformance"
sys.path.insert(0, str(ADAPTERS))

import adapter  # noqa: E402
import case as kit  # noqa: E402
import lammps  # noqa: E402
import liggghts  # noqa: E402
import outcome  # noqa: E402
import simulate  # noqa: E402
import yade  # noqa: E402

RADIUS, MASS, K = 1.5e-3, 1.4e-5, 7000.0
TCOL = math.pi * math.sqrt(MASS / 2 / K)


def body(x, v):
    return {"radius": RADIUS, "mass": MASS, "inertia": 0.4 * MASS * RADIUS**2, "position": [x, 0, 0],
            "velocity": [v, 0, 0], "spin": [0, 0, 0]}


PAIR = {
    "schema": "ricochet/case/1", "case": "pair", "bodies": [body(-RADIUS, 0.25), body(RADIUS, -0.25)], "walls": [],
    "gravity": [0, 0, 0], "law": {"name": "linear", "parameters": {"k": K, "c": 0}, "end": "force"}, "wall_law": None,
    "tangential": None, "flight_steps": 1.5, "time_scale": TCOL, "steps": [50, 100], "duration": 1.73 * TCOL,
    "answers": [], "expected_order": {"leapfrog": 2, "located": 2}}


def written(folder, **changes):
    """A file with the pair's case, changed."""
    path = pathlib.Path(folder) / f"{changes.get('case', 'pair')}.json"
    path.write_text(json.dumps({**PAIR, **changes}))
    return path


def read(folder, **changes):
    return kit.read_case(written(folder, **changes))


# --- Cases -----------------------------------------------------------------------------------------------------------
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


def changed(path, value):
    """The pair's case with the value at that path, "bodies.0.radius"; None takes the key away."""
    found = copy.deepcopy(PAIR)
    *way, last = [int(key) if key.isdigit() else key for key in path.split(".")]
    inner = found
    for key in way:
        inner = inner[key]
    if value is None:
        del inner[last]
    else:
        inner[last] = value
    return found


@pytest.mark.parametrize("path, value, message", [
    ("schema", "ricochet/case/2", 'schema = "ricochet/case/2": must be ricochet/case/1'),
    ("bodies.1.radius", 0, "bodies[1].radius = 0: must be a number > 0"),
    ("bodies.0.mass", "heavy", 'bodies[0].mass = "heavy": must be a number > 0'),
    ("bodies.0.velocity", [1, 2], "bodies[0].velocity = [1, 2]: must be three numbers"),
    ("bodies.0.spin", None, "bodies[0]: spin is missing"),
    ("bodies", [], "bodies is empty"),
    ("steps", [50, 0.5], "steps[1] = 0.5: must be a whole number > 0"),
    ("steps", [], "steps is empty"),
    ("duration", True, "duration = true: must be a number > 0"),
    ("gravity", 9.81, "gravity = 9.81: must be an array"),
    ("law.end", "rest", 'law.end = "rest": must be force or overlap'),
    ("law.parameters.k", math.inf, "law.parameters.k = Infinity: must be a number"),
    ("walls", [{"point": [0, 0, 0], "normal": [0, 0, 0]}], "walls[0].normal = [0, 0, 0]: must be a direction"),
    ("walls", [{"point": [0, 0, 0], "normal": [1, 0, 0]}], "wall_law is null, but there are walls"),
    ("tangential", {"name": "rough"}, "tangential: parameters is missing"),
])
def test_a_wrong_case_is_told_in_one_line(tmp_path, path, value, message):
    file = tmp_path / "wrong.json"
    file.write_text(json.dumps(changed(path, value)))
    with pytest.raises(kit.BadCase) as told:
        kit.read_case(file)
    assert str(told.value).startswith(str(file)) and str(told.value).endswith(message)


def test_what_is_no_case_is_refused(tmp_path):
    broken = tmp_path / "broken.json"
    broken.write_text('{"case": ')
    with pytest.raises(kit.BadCase, match="is no JSON"):
        kit.read_case(broken)
    with pytest.raises(kit.BadCase, match="No such file"):
        kit.read_case(tmp_path / "absent.json")
    with pytest.raises(kit.BadCase, match="is no folder"):
        kit.read_cases(str(tmp_path / "absent"), [])
    (tmp_path / "empty").mkdir()
    with pytest.raises(kit.BadCase, match="holds no case"):
        kit.read_cases(str(tmp_path / "empty"), [])


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
    with pytest.raises(kit.BadCase, match="law linear: k2 is missing"):
        kit.parameters_of(pair.law, linear=("k2",))
    kit.require_solid_spheres(pair)
    hollow = pair._replace(bodies=[pair.bodies[0]._replace(inertia=2 / 3 * MASS * RADIUS**2)])
    with pytest.raises(kit.NotRun, match="body 1 is no solid sphere"):
        kit.require_solid_spheres(hollow)
    assert kit.axis_of(kit.Wall((0, 0, 0), (0, -1, 0))) == (1, -1)
    with pytest.raises(kit.NotRun, match="no axis"):
        kit.axis_of(kit.Wall((0, 0, 0), (0.6, 0.8, 0)))


@pytest.mark.parametrize("nu", [0.0, 0.3, 0.5])
def test_poissons_ratio_of_a_ratio_of_stiffnesses(nu):
    young = 1e7
    normal, shear = young / (2 * (1 - nu**2)), young / (2 * (1 + nu)) / (2 * (2 - nu))
    assert kit.poisson_of(shear / normal) == pytest.approx(nu, abs=1e-14)


def test_no_material_shears_that_easily():
    with pytest.raises(kit.NotRun, match="Poisson"):
        kit.poisson_of(0.1)


# --- Contacts along a path -------------------------------------------------------------------------------------------
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
    overlap, normal = outcome.overlaps(one, outcome.Instant([outcome.State((-1.2 * RADIUS, 1, 2), (0, 0, 0), (0, 0, 0))]))[0]
    assert overlap == pytest.approx(0.2 * RADIUS) and normal == (1, 0, 0)


def test_a_run_that_is_not_whole_is_a_failure(tmp_path):
    pair = read(tmp_path)
    path = swing(pair, 50)
    assert outcome.run_of_path(pair, 50, path).bodies == path[-1].bodies
    with pytest.raises(outcome.EngineFailed, match="states came back"):
        outcome.run_of_path(pair, 50, path[:-1])
    lost = path[-1]._replace(bodies=[outcome.State((math.nan, 0, 0), (0, 0, 0), (0, 0, 0))] * 2)
    with pytest.raises(outcome.EngineFailed, match="no number"):
        outcome.run_of_path(pair, 50, path[:-1] + [lost])


# --- Results ---------------------------------------------------------------------------------------------------------
def engine(run, version="1.2"):
    return adapter.Engine("Toy", "python3", lambda program: version, adapter.one_by_one(run))


def still(program, case, folder):
    """The bodies stay where they start; the case `odd` has no words, `ill` ends badly."""
    if case.name == "odd":
        raise kit.NotRun("no words for it")
    if case.name == "ill":
        adapter.run_engine(["/bin/sh", "-c", f"echo 'ERROR: {folder}/deck: too bad, really'; echo bye; exit 3"], folder)
    return [outcome.Run(n, [outcome.State(b.position, b.velocity, b.spin) for b in case.bodies], 1e-4, None)
            for n in case.steps]


def test_results_are_rows_and_notes(tmp_path):
    for name in ("odd", "ill", "pair"):
        written(tmp_path, case=name)
    result = tmp_path / "toy.csv"
    assert adapter.main(engine(still), [str(tmp_path), "-o", str(result), "--steps", "50"]) == 0
    lines = result.read_text().splitlines()
    assert lines[:2] == ["# engine: Toy", "# version: 1.2"]
    assert lines[2].startswith("# date: 20") and lines[3].startswith("# by: engines/conformance/")
    assert lines[4] == "case,steps,body,x,y,z,vx,vy,vz,wx,wy,wz,contact_time,max_overlap,note"
    assert lines[5] == 'ill' + "," * 14 + '"failed: ERROR: deck: too bad, really"'
    assert lines[6] == "odd" + "," * 14 + "no words for it"
    assert lines[7] == "pair,50,1,-0.0015,0.0,0.0,0.25,0.0,0.0,0.0,0.0,0.0,0.0001,,"
    assert lines[8] == "pair,50,2,0.0015,0.0,0.0,-0.25,0.0,0.0,0.0,0.0,0.0,0.0001,,"
    assert len(lines) == 9
    assert stat.S_IMODE(result.stat().st_mode) == 0o666 & ~adapter.current_umask()


def test_results_appear_whole_or_not_at_all(tmp_path, monkeypatch, capsys):
    written(tmp_path)
    result = tmp_path / "toy.csv"
    result.write_text("before")

    def full(*_):
        raise OSError(28, "No space left on device")

    with monkeypatch.context() as patch:
        patch.setattr(os, "replace", full)
        assert adapter.main(engine(still), [str(tmp_path), "-o", str(result)]) == 4
    assert capsys.readouterr().err == f"{result}: No space left on device\n"
    assert result.read_text() == "before" and sorted(p.name for p in tmp_path.iterdir()) == ["pair.json", "toy.csv"]


def test_exit_codes(tmp_path, capsys):
    written(tmp_path)
    assert adapter.main(engine(still), [str(tmp_path), "-o", "-", "--only", "none"]) == 2
    assert adapter.main(engine(still), [str(tmp_path), "-o", "-", "--program", "no-such-engine"]) == 4
    assert adapter.main(engine(still), [str(tmp_path), "-o", str(tmp_path / "absent" / "x.csv")]) == 2
    assert capsys.readouterr().err.splitlines() == [
        "--only none: must be one of pair", "Toy: --program no-such-engine: there is no such program",
        f"-o {tmp_path}/absent/x.csv: there is no such folder"]

    case = (tmp_path / "pair.json").read_text()
    assert adapter.main(engine(still), [str(tmp_path), "-o", str(tmp_path / "pair.json")]) == 2
    assert adapter.main(engine(still), [str(tmp_path), "-o", str(tmp_path)]) == 2
    assert capsys.readouterr().err.splitlines() == [
        f"-o {tmp_path}/pair.json: must not be one of the cases", f"-o {tmp_path}: must be a file"]
    assert (tmp_path / "pair.json").read_text() == case

    def stopped(*_):
        raise KeyboardInterrupt

    assert adapter.main(engine(stopped), [str(tmp_path), "-o", str(tmp_path / "x.csv")]) == 130
    assert not (tmp_path / "x.csv").exists()
    with pytest.raises(SystemExit) as ended:
        adapter.main(engine(still), [str(tmp_path), "-o", "-", "--steps", "50,0"])
    assert ended.value.code == 2
    with pytest.raises(SystemExit) as ended:
        adapter.main(engine(still), [str(tmp_path), "-o", "-", "--steps", "50,100,50"])
    assert ended.value.code == 2


def test_an_engine_that_hangs_is_stopped(tmp_path, monkeypatch):
    monkeypatch.setattr(adapter, "TIME_LIMIT", 0.2)
    with pytest.raises(outcome.EngineFailed, match="did not end within 0.2 s"):
        adapter.run_engine(["/bin/sleep", "5"], str(tmp_path))
    with pytest.raises(outcome.EngineFailed, match="/no-such-engine: No such file"):
        adapter.run_engine(["/no-such-engine"], str(tmp_path))


def test_last_words_are_the_last_error():
    assert adapter.last_words("start\nERROR: lost atoms\nlast\n\n") == "ERROR: lost atoms"
    assert adapter.last_words("start\nlast  \n \n") == "last" and adapter.last_words("") == ""


# --- The engines' words, of which docs/engines.md tells --------------------------------------------------------------
def law(name, end="force", **parameters):
    return kit.Law(name, parameters, end)


def test_lammps_counts_damping_its_way(tmp_path):
    m, r = 7e-6, 7.5e-4
    assert lammps.normal(law("linear", k=K, c=0.1), m, r, 20210929) == f"hooke {K!r} 0.1 damping velocity"
    hertz = lammps.normal(law("kuwabara-kono", k=1e6, c=20), m, r, 20210929).split()
    assert float(hertz[1]) == pytest.approx(1e6 / math.sqrt(r)) and float(hertz[2]) == pytest.approx(20 / m / math.sqrt(r))
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
    fractional = {"name": "fractional-kelvin-voigt", "parameters": {"k": K, "c": 0.1, "alpha": 0.5}, "end": "force"}
    pair = read(tmp_path, law={**fractional, "name": "fractional"})
    memory = repr(4 * TCOL)
    assert lammps.pairs(pair, 20210929) == f"pair_style fractional memory {memory}\npair_coeff * * {K!r} 0.1 0.5\n"
    assert f"fractional {K!r} 0.1 0.5 damping fractional/memory {memory} tangential" in lammps.pairs(pair, 20250204)
    solid = read(tmp_path, law=fractional)
    assert f"fractional/kelvin_voigt {K!r} 0.1 0.5 damping" in lammps.pairs(solid, 20250204)
    with pytest.raises(kit.NotRun, match="the fractional law alone"):
        lammps.pairs(solid, 20210929)
    with pytest.raises(kit.NotRun, match="lammps-ricochet has one"):
        lammps.require_laws("/usr/bin/lmp", pair)
    lammps.require_laws("/usr/bin/lammps-ricochet", pair)
    with pytest.raises(kit.NotRun, match="ends contacts by force"):
        lammps.require_laws("/usr/bin/lammps-ricochet", read(tmp_path, law={**fractional, "end": "overlap"}))


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
        liggghts.Contacts("/usr/bin/liggghts", read(tmp_path, law={**PAIR["law"], "name": "fractional"}))


def test_yade_puts_springs_in_series(tmp_path):
    pair = read(tmp_path)
    assert f"kn={2 * K!r}" in yade.contacts(pair)
    assert 1 / (1 / 4.0 + 1 / yade.other_half("k", 4.0, 3.0)) == pytest.approx(3.0)
    # A wall twice as stiff is out of reach for springs in series: by tc and en, of half the sphere's mass there.
    wall = {"point": [-2 * RADIUS, 0, 0], "normal": [1, 0, 0]}
    stiff = read(tmp_path, walls=[wall], wall_law={**PAIR["law"], "parameters": {"k": 2 * K, "c": 0}})
    assert repr(math.pi * math.sqrt(MASS / 2 / (2 * K))) in yade.contacts(stiff)
    with pytest.raises(kit.NotRun, match="no kuwabara-kono law"):
        yade.contacts(read(tmp_path, law={**PAIR["law"], "name": "kuwabara-kono"}))


def test_scenes_cannot_say_every_rolling_spring(tmp_path):
    t = kit.Tangential("linear", 2000.0, 0.0, 0.5, None, 0.1, 1.4 * RADIUS**2 * 2000.0, 0.0)
    pair = read(tmp_path)
    simulate.require_own_rolling(pair, t)
    with pytest.raises(kit.NotRun, match="rolling"):
        simulate.require_own_rolling(pair, t._replace(k_rolling=1.01 * t.k_rolling))


# --- The template ----------------------------------------------------------------------------------------------------
def test_the_template_runs_as_it_stands(tmp_path):
    written(tmp_path)
    written(tmp_path, case="rough", tangential={"name": "linear", "parameters": {"k_t": 1, "c_t": 0}, "mu": 0.3})
    result = tmp_path / "mine.csv"
    subprocess.run([sys.executable, ADAPTERS / "template.py", tmp_path, "-o", result, "--program", sys.executable],
                   check=True)
    rows = [line.split(",") for line in result.read_text().splitlines() if line[0] != "#"][1:]
    assert rows[-1][0] == "rough" and "without friction" in ",".join(rows[-1][14:])
    errors = [abs(float(row[6]) + 0.25) / 0.25 for row in rows[:-1:2]]
    # Leapfrog of an undamped contact, begun and ended within a step: second order.
    assert errors[1] < errors[0] < (math.pi / 50) ** 2 and errors[1] < (math.pi / 100) ** 2


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
