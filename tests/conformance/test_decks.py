"""Every number that an adapter writes into a deck is one of the case, read back as the engine understands it.

Each engine's deck is read into the same things (`Physics`), by what docs/engines.md says of its words, and compared
with the case's file itself: a factor or a sign that an adapter gets wrong shows without the engine.
"""

import json
import math
import os
import re
import sys
import types
from typing import Dict, List, NamedTuple, Optional, Tuple

import pytest
from pair_case import PAIR, TCOL, kit, read

import lammps
import liggghts
import simulate
import yade

FLIGHT, SCALES, STEPS = 1.25, 1.7, [50, 70]


def body(radius, density, position, velocity, spin):
    mass = density * 4 / 3 * math.pi * radius**3
    return {"radius": radius, "mass": mass, "inertia": 0.4 * mass * radius**2, "position": position,
            "velocity": velocity, "spin": spin}


# No two numbers are the same, so that none can stand for another.
BODIES = [body(1.5e-3, 1000, [-1.5e-3, 2.1e-4, -3.2e-4], [0.25, 0.031, -0.012], [11, -23, 7.5]),
          body(1.1e-3, 1700, [1.1e-3, -1.3e-4, 2.7e-4], [-0.31, 0.017, 0.043], [-5, 3, 31]),
          body(1.9e-3, 2300, [4.2e-3, 5.3e-4, 1.9e-4], [-0.11, -0.19, 0.023], [2.5, 17, -13])]
ALIKE = [{**b, **{key: BODIES[0][key] for key in ("radius", "mass", "inertia")}} for b in BODIES]
WALLS = [{"point": [-0.011, 0.0051, 0.0025], "normal": [1, 0, 0]},
         {"point": [0.0102, 0.0173, 0.0021], "normal": [0, -1, 0]}]
GRAVITY = [0.13, -9.7, 0.31]
ROUGH = {"name": "linear", "parameters": {"k_t": 2100, "c_t": 0}, "mu": 0.31, "torsion": False, "mu_rolling": 0,
         "k_rolling": 0, "c_rolling": 0}
MINDLIN = {**ROUGH, "name": "mindlin", "parameters": {"k_t": 1.3e6, "c_t": 0}}


def law(name, end="force", **parameters):
    return {"name": name, "parameters": parameters, "end": end}


LINEAR = {"law": law("linear", k=7000, c=0.11), "wall_law": law("linear", k=5300, c=0.07)}
ATTRACTS = {key: {**of, "end": "overlap"} for key, of in LINEAR.items()}
KUWABARA_KONO = {"law": law("kuwabara-kono", k=1.1e6, c=21), "wall_law": law("kuwabara-kono", k=1.7e6, c=29)}
TSUJI = {"law": law("tsuji", k=1.1e6, c=1.3), "wall_law": law("tsuji", k=1.4e6, c=1.7)}
HYSTERETIC = {"law": law("hysteretic", k1=4100, k2=9300), "wall_law": law("hysteretic", k1=5200, k2=6700)}
FRACTIONAL = {key: law("fractional", k=7000, c=0.3, alpha=0.4) for key in ("law", "wall_law")}
HERTZ = law("fractional-hertz", k=1.1e6, c=210, alpha=0.6)
ROLLS = {**ROUGH, "mu_rolling": 0.12}  # k_rolling by engine


def case_file(**changes):
    return {**PAIR, "bodies": BODIES, "walls": WALLS, "gravity": GRAVITY, "flight_steps": FLIGHT, "steps": STEPS,
            "duration": SCALES * TCOL, **LINEAR, **changes}


# --- What a deck says ------------------------------------------------------------------------------------------------
class Physics(NamedTuple):
    bodies: List[dict]
    contacts: Dict[Tuple[int, int], dict]  # of two bodies from 0 on; of a body and the wall w: (body, -1 - w)
    walls: List[Tuple[int, Optional[int], float]]  # axis, side (None: both), place
    gravity: List[float]
    step: float
    count: int


def effective(bodies, i, j):
    """(mass, radius) of a contact."""
    a = bodies[i]
    if j < 0:
        return a["mass"], a["radius"]
    b = bodies[j]
    return (1 / (1 / a["mass"] + 1 / b["mass"]), 1 / (1 / a["radius"] + 1 / b["radius"]))


def contact(of, law, rough):
    """The numbers of a contact as the case has them."""
    found = {**law["parameters"], "end": law["end"], "law": law["name"]}
    if rough:
        found.update({"k_t": rough["parameters"]["k_t"], "c_t": rough["parameters"]["c_t"], "mu": rough["mu"]})
        if rough["mu_rolling"] > 0:
            found.update({key: rough[key] for key in ("mu_rolling", "k_rolling")})
    return found


def asked(of, n):
    """What the case's file asks for, without the adapters' own arithmetic."""
    step = of["time_scale"] / n
    bodies = [{key: b[key] for key in ("radius", "mass", "velocity", "spin")} for b in of["bodies"]]
    for b, given in zip(bodies, of["bodies"]):
        b["position"] = [x - FLIGHT * step * v for x, v in zip(given["position"], given["velocity"])]
    count = len(bodies)
    contacts = {(i, j): contact(of, of["law"], of["tangential"]) for i in range(count) for j in range(i + 1, count)}
    contacts.update({(i, -1 - w): contact(of, of["wall_law"], of["tangential"])
                     for i in range(count) for w in range(len(of["walls"]))})
    walls = []
    for w in of["walls"]:
        axis = next(i for i in range(3) if w["normal"][i])
        walls.append((axis, w["normal"][axis], w["point"][axis]))
    return Physics(bodies, contacts, walls, of["gravity"], step, math.ceil(FLIGHT + SCALES * n))


def compare(said, wanted, but=()):
    """`but`: keys of contacts that the engine makes of others."""
    assert said.step == pytest.approx(wanted.step, rel=1e-14) and said.count == wanted.count
    assert said.gravity == pytest.approx(wanted.gravity, rel=1e-14)
    assert len(said.bodies) == len(wanted.bodies)
    for a, b in zip(said.bodies, wanted.bodies):
        for key, value in b.items():
            assert a[key] == pytest.approx(value, rel=1e-13), key
    assert [(axis, place) for axis, _, place in said.walls] == [(axis, place) for axis, _, place in wanted.walls]
    for (_, side, _), (_, inward, _) in zip(said.walls, wanted.walls):
        assert side in (None, inward)
    assert said.contacts.keys() == wanted.contacts.keys()
    for pair, numbers in wanted.contacts.items():
        assert said.contacts[pair].keys() == numbers.keys(), pair
        for key, value in numbers.items():
            if key not in but:
                right = value if isinstance(value, str) else pytest.approx(value, rel=1e-11)
                assert said.contacts[pair][key] == right, (pair, key)


def numbers(words):
    return [float(word) for word in words]


# --- LAMMPS and LIGGGHTS ---------------------------------------------------------------------------------------------
def lines(deck):
    return [line.split() for line in deck.splitlines()]


def of_commands(deck):
    """What the two engines write alike: bodies, gravity, step, steps; and that the box holds all."""
    bodies, gravity, step, count = {}, [0, 0, 0], None, None
    for words in lines(deck):
        if words[0] == "create_atoms":
            bodies[int(words[1])] = {"position": numbers(words[3:6])}
        elif words[:2] == ["set", "atom"]:
            of, values = bodies[int(words[2])], words[3:]
            while values:
                key, take = values[0], 3 if values[0] == "omega" else 1
                of[key], values = numbers(values[1:1 + take]), values[1 + take:]
        elif words[:4] == ["fix", "gravity", "all", "gravity"]:
            direction = numbers(words[6:9])
            gravity = [float(words[4]) * x / math.hypot(*direction) for x in direction]
        elif words[0] == "timestep":
            step = float(words[1])
        elif words[0] == "run":
            count = int(words[1])
    found = []
    for i in sorted(bodies):
        b = bodies[i]
        radius = b["diameter"][0] / 2
        mass = b["mass"][0] if "mass" in b else b["density"][0] * 4 / 3 * math.pi * radius**3
        found.append({"radius": radius, "mass": mass, "position": b["position"],
                      "velocity": [b[key][0] for key in ("vx", "vy", "vz")],
                      "spin": b["omega"] if "omega" in b else [b[key][0] for key in ("omegax", "omegay", "omegaz")]})
    dump = next(words for words in lines(deck) if words[0] == "dump")
    assert dump[4] == str(count) and dump[5].startswith("path.")  # with gravity the start and the end
    assert dump[6:] == "x y z vx vy vz omegax omegay omegaz fx fy fz".split()
    low, high = numbers(next(words for words in lines(deck) if words[0] == "region")[3:5])
    assert low == -high and all(high > max(map(abs, b["position"])) + 2 * b["radius"] for b in found)
    return found, gravity, step, count


def granular(words, mass, radius, date):
    """The numbers of a contact by the words of pair_style granular."""
    found = {"end": "force" if words[-1] == "limit_damping" else "overlap"}
    model, k, damping = words[0], float(words[1]), words[words.index("damping") + 1]
    if model == "hooke":
        found.update(law="linear", k=k, c=float(words[2]))
    elif model == "hertz":
        found.update(k=k * math.sqrt(radius))
        if damping == "viscoelastic":
            found.update(law="kuwabara-kono", c=float(words[2]) * mass * math.sqrt(radius))
        else:
            assert damping == ("tsuji" if date < 20240627 else "coeff_restitution")
            log = math.log(float(words[2])) if date > 20240627 else None
            share = (lammps.marshall(float(words[2])) if log is None
                     else -math.sqrt(5) * log / math.sqrt(math.pi**2 + log**2))
            found.update(law="tsuji", c=share * math.sqrt(mass * found["k"]))
    else:
        found.update(law=model, k=k, c=float(words[2]), alpha=float(words[3]), end="force")
    kind, *slide = words[words.index("tangential") + 1:]
    if kind != "linear_nohistory":
        scale = math.sqrt(radius) if kind == "mindlin_rescale/force" else 1
        assert kind in ("linear_history", "mindlin_rescale/force")
        found.update(k_t=float(slide[0]) * scale, c_t=float(slide[1]) * found["c"], mu=float(slide[2]))
    if "rolling" in words:
        k_rolling, _, mu_rolling = numbers(words[words.index("sds") + 1:words.index("sds") + 4])
        found.update(k_rolling=k_rolling * radius**2, mu_rolling=mu_rolling)
    return found


def side(low, high):
    assert (low == "NULL") != (high == "NULL")
    return (1, float(low)) if high == "NULL" else (-1, float(high))


def of_lammps(of, n, date):
    deck = lammps.deck(of, n, date)
    bodies, *rest = of_commands(deck)
    contacts, walls, groups = {}, {}, {}
    for words in lines(deck):
        if words[0] == "group":
            groups[words[1]] = int(words[3]) - 1
        elif words[0] == "pair_coeff" and words[1] != "*":
            i, j = int(words[1]) - 1, int(words[2]) - 1
            contacts[i, j] = granular(words[3:], *effective(bodies, i, j), date)
        elif words[:1] == ["fix"] and words[3] == "wall/gran":
            i, w = groups[words[2]], int(re.match(r"wall(\d+)", words[1])[1])
            place = next(k for k, word in enumerate(words) if word.endswith("plane"))
            walls[w] = ("xyz".index(words[place][0]), *side(*words[place + 1:place + 3]))
            contacts[i, -w] = granular(words[5:place], *effective(bodies, i, -w), date)
    return Physics(bodies, contacts, [walls[w] for w in sorted(walls)], *rest)


def of_liggghts(of, n, program="liggghts"):
    deck = liggghts.deck(liggghts.Contacts(program, of), n)
    bodies, *rest = of_commands(deck)
    count, walls, properties = len(bodies), [], {}
    types = count + (1 if of.walls else 0)
    for words in lines(deck):
        if words[0] == "fix" and words[3].startswith("property"):
            kind, values = words[5], words[6:]
            if kind == "peratomtypepair":
                assert int(values[0]) == types
                values = values[1:]
                assert len(values) == types**2
            properties[words[4]] = (kind, numbers(values))
        elif words[0] == "pair_style":
            pair_model = words[2:]
        elif words[0] == "fix" and words[3] == "wall/gran":
            at = words.index("primitive")
            assert words[at + 1:at + 3] == ["type", str(count + 1)]  # all walls are of the last one
            axis = words[at + 3]
            walls.append(("xyz".index(axis[0]), None, float(words[at + 4])))
            assert words[4:at] + words[at + 5:] == pair_model

    def value(name, i, j):
        kind, values = properties[name]
        return values[0] if kind == "scalar" else values[i * types + j]

    contacts = {}
    for i in range(count):
        for j in [*range(i + 1, count), *(-1 - w for w in range(len(walls)))]:
            mass, radius = effective(bodies, i, j)
            contacts[i, j] = of_model(pair_model, lambda name, i=i, j=j: value(name, i, j if j >= 0 else count),
                                      properties, (i, j if j >= 0 else count), mass, radius)
    return Physics(bodies, contacts, walls, *rest)


def of_model(words, value, properties, types, mass, radius):
    """The numbers of a contact by the words and properties of pair_style gran."""
    model, root = words[1], math.sqrt(radius)
    found = {"end": "force"}
    if "limitForce" in words:
        found["end"] = {"on": "force", "off": "overlap"}[words[words.index("limitForce") + 1]]
    if model == "hooke/stiffness":
        assert words[words.index("absolute_damping") + 1] == words[words.index("tangential_damping") + 1] == "on"
        found.update(law="linear", k=value("kn"), c=value("gamman_abs"))
        slide = {"k_t": value("kt"), "c_t": value("gammat_abs")}
    elif model == "hertz/stiffness":
        found.update(law="kuwabara-kono", k=value("kn") * root, c=value("gamman") * mass * root)
        slide = {"k_t": value("kt") * root, "c_t": value("gammat")}
    elif model == "hertz":
        young, nu = (properties[name][1] for name in ("youngsModulus", "poissonsRatio"))
        moduli = [(1 - nu[t]**2) / young[t] for t in types]
        shear = [2 * (2 - nu[t]) * (1 + nu[t]) / young[t] for t in types]
        k, log = 4 / 3 / sum(moduli) * root, math.log(value("coefficientRestitution"))
        found.update(law="tsuji", k=k, c=-log / math.sqrt(math.pi**2 + log**2) * math.sqrt(5 * mass * k))
        slide = {"k_t": 8 / sum(shear) * root, "c_t": 0}
    elif model == "edinburgh/stiffness":
        found.update(law="hysteretic", k1=value("LoadingStiffness"),
                     k2=value("LoadingStiffness") * value("UnloadingStiffness"))
        assert value("overlapExponent") == value("adhesionExponent") == 1
        assert value("pullOffForce") == value("surfaceEnergy") == 0
    else:
        found.update(law=model, k=value("fractionalK"), c=value("fractionalC"), alpha=value("fractionalAlpha"))
        assert value("memoryTime") == pytest.approx(4 * TCOL)
        if "kt" in properties:
            slide = {"k_t": value("kt"), "c_t": value("gammat_abs")}
    if words[words.index("tangential") + 1] == "history":
        found.update(slide, mu=value("coefficientFriction"))
    if "rolling_friction" in words:
        assert words[words.index("rolling_friction") + 1] == "epsd3" and value("coefficientRollingViscousDamping") == 0
        mu = value("coefficientRollingFriction")
        found.update(mu_rolling=mu, k_rolling=value("rollingStiffness") * value("kn") * (mu * radius)**2)
    return found


# --- Yade: its deck is Python, run here with what it asks of Yade in the place of Yade -------------------------------
class Material(types.SimpleNamespace):
    made = 0

    def __init__(self, **said):
        super().__init__(**said)
        Material.made += 1
        self.id = Material.made


class Yade:
    """What `from yade import *` gives, as far as decks use it."""

    def __init__(self):
        self.bodies, self.walls, self.all, self.taken = [], [], [], 0
        world = types.SimpleNamespace(dt=None, engines=None, reset=self.reset, step=self.step, bodies=self)
        world.materials = types.SimpleNamespace(append=lambda made: None)
        world.run = lambda count, wait: self.go(count)
        world.forces = types.SimpleNamespace(f=lambda i: (0, 0, 0))
        self.world = world
        utils = types.SimpleNamespace(sphere=self.sphere, wall=self.wall)
        said = {name: lambda *parts, _name=name, **keys: types.SimpleNamespace(name=_name, parts=parts, **keys)
                for name in ("ForceResetter InsertionSortCollider Bo1_Sphere_Aabb Bo1_Wall_Aabb InteractionLoop "
                             "Ig2_Sphere_Sphere_ScGeom Ig2_Wall_Sphere_ScGeom NewtonIntegrator MatchMaker "
                             "Ip2_ViscElMat_ViscElMat_ViscElPhys Law2_ScGeom_ViscElPhys_Basic "
                             "Ip2_FrictMat_FrictMat_MindlinPhys Law2_ScGeom_MindlinPhys_Mindlin").split()}
        self.words = {"O": world, "utils": utils, "ViscElMat": Material, "FrictMat": Material, **said}

    def reset(self):
        self.bodies, self.walls, self.all, self.taken = [], [], [], 0

    def append(self, one):
        self.all.append(one)
        return len(self.all) - 1

    def __getitem__(self, i):
        return self.all[i]

    def sphere(self, position, radius, material):
        state = types.SimpleNamespace(pos=position)
        self.bodies.append(types.SimpleNamespace(state=state, shape=types.SimpleNamespace(radius=radius),
                                                 material=material))
        return self.bodies[-1]

    def wall(self, position, axis, material):
        self.walls.append((axis, position, material))
        return self.walls[-1]

    def step(self):
        self.go(1)

    def go(self, count):
        self.taken += count


def series(a, b):
    return 1 / (1 / a + 1 / b) if a and b else 0


def of_match(maker, one, other):
    return {frozenset(match[:2]): match[2] for match in maker.matches}[frozenset((one.id, other.id))]


def of_materials(one, other, ip2, mass, radius):
    """The numbers of a contact of these two materials. Attraction is cut off, whatever the case asks."""
    found = {"mu": math.tan(min(one.frictionAngle, other.frictionAngle)), "end": "force"}
    if ip2.name == "Ip2_FrictMat_FrictMat_MindlinPhys":
        k = 4 / 3 / sum((1 - m.poisson**2) / m.young for m in (one, other)) * math.sqrt(radius)
        shear = sum(2 * (2 - m.poisson) * (1 + m.poisson) / m.young for m in (one, other))
        return {**found, "law": "tsuji", "k": k, "k_t": 8 / shear * math.sqrt(radius), "c_t": ip2.betas,
                "c": of_match(ip2.betan, one, other) * 2 * math.sqrt(1.5 * mass * k)}
    if hasattr(one, "kn"):
        return {**found, "law": "linear", "k": series(one.kn, other.kn), "c": series(one.cn, other.cn),
                "k_t": series(one.ks, other.ks), "c_t": series(one.cs, other.cs)}
    tc, en = (of_match(maker, one, other) for maker in (ip2.tc, ip2.en))
    # Of the pair's effective mass, at a wall half the sphere's (docs/engines.md).
    log = math.log(en)
    return {**found, "law": "linear", "k": (math.pi**2 + log**2) * mass / tc**2, "c": -2 * log * mass / tc}


def of_yade(of, n, folder, monkeypatch, at_wall=1.0):
    """`at_wall`: Yade's effective mass at a wall in parts of the sphere's."""
    engine, module = Yade(), types.ModuleType("yade")
    vars(module).update(engine.words)
    monkeypatch.setitem(sys.modules, "yade", module)
    monkeypatch.chdir(folder)
    exec(yade.PRELUDE + yade.deck(of._replace(steps=[n]), 7, yade.contacts(of)), {})
    assert os.path.exists("7.done") and not os.path.exists("7.error")
    _, _, loop, newton = engine.world.engines
    assert loop.parts[0][1].hertzian and newton.damping == 0
    bodies = [{"radius": b.shape.radius, "mass": b.state.mass, "position": b.state.pos, "velocity": b.state.vel,
               "spin": b.state.angVel} for b in engine.bodies]
    assert [b.state.inertia[2] for b in engine.bodies] == [b.inertia for b in of.bodies]
    ip2, contacts = loop.parts[1][0], {}
    for i, one in enumerate(engine.bodies):
        for j in range(i + 1, len(bodies)):
            contacts[i, j] = of_materials(one.material, engine.bodies[j].material, ip2, *effective(bodies, i, j))
        for w, (_, _, stone) in enumerate(engine.walls):
            mass, radius = effective(bodies, i, -1)
            contacts[i, -1 - w] = of_materials(one.material, stone, ip2, at_wall * mass, radius)
    if not of.tangential:  # any spring will do
        assert all(of_pair.pop("mu") == 0 for of_pair in contacts.values())
        contacts = {pair: {key: x for key, x in of_pair.items() if key not in ("k_t", "c_t")}
                    for pair, of_pair in contacts.items()}
    with open(f"7.{n}", encoding="ascii") as file:
        states = [numbers(line.split()) for line in file]
    assert states[0][:3] == list(bodies[0]["position"]) and len(states[0]) == 9 * len(bodies) + 3
    # A step behind each state that is written gives the force at it: one more than the run has.
    return Physics(bodies, contacts, [(axis, None, place[axis]) for axis, place, _ in engine.walls],
                   list(newton.gravity), engine.world.dt, engine.taken - 1)


# --- simulate --------------------------------------------------------------------------------------------------------
def of_simulate(of, n):
    scene = json.loads(json.dumps(simulate.scene(of, n)))
    bodies = [{**{key: s[key] for key in ("radius", "position", "velocity", "spin")},
               "mass": s["density"] * 4 / 3 * math.pi * s["radius"]**3} for s in scene["spheres"]]
    by_pair = {}
    for one in scene["interactions"]:
        numbers = {key: value for key, value in one["law"].items() if key != "name"}
        numbers["law"] = one["law"]["name"]
        if "friction" in one:
            rough = one["friction"]
            numbers.update({key: rough[key] for key in ("k_t", "c_t")}, mu=rough["mu_static"])
            if "mu_rolling" in rough:  # its spring is by k_t
                numbers.update(mu_rolling=rough["mu_rolling"], k_rolling=None)
        by_pair[tuple(one["between"])] = numbers
    walls = []
    for w in scene["walls"]:
        axis = next(i for i in range(3) if w["inward"][i])
        walls.append((axis, w["inward"][axis], w["point"][axis]))
    count = len(bodies)
    contacts = {(i, j): by_pair["grain", "grain"] for i in range(count) for j in range(i + 1, count)}
    contacts.update({(i, -1 - w): by_pair["grain", "stone"] for i in range(count) for w in range(len(walls))})
    step, every = scene["step"], scene["output_interval"] / scene["step"]
    whole = round(scene["duration"] / step)
    assert every == pytest.approx(whole) and scene["duration"] == pytest.approx(whole * step, rel=1e-14)
    return Physics(bodies, contacts, walls, scene["gravity"], step, whole)


# --- Each engine with each law that it has ---------------------------------------------------------------------------
LAMMPS_CASES = [LINEAR, ATTRACTS, KUWABARA_KONO, TSUJI, {**LINEAR, "tangential": ROUGH},
                {**LINEAR, "tangential": {**ROUGH, "parameters": {"k_t": 2100, "c_t": 0.033}}},
                {**TSUJI, "tangential": MINDLIN}, {**ATTRACTS, "tangential": {**ROLLS, "k_rolling": 0.0031}}]


@pytest.mark.parametrize("n", STEPS)
@pytest.mark.parametrize("date", [20210929, 20250204])
@pytest.mark.parametrize("changes", LAMMPS_CASES)
def test_decks_of_lammps_say_what_the_case_says(tmp_path, changes, date, n):
    of = case_file(**changes)
    compare(of_lammps(read(tmp_path, **of), n, date), asked(of, n))


def test_a_deck_of_lammps_ricochet_says_what_the_case_says(tmp_path):
    of = case_file(**FRACTIONAL)
    compare(of_lammps(read(tmp_path, **of), 50, 20250204), asked(of, 50))
    deck = lines(lammps.deck(read(tmp_path, **of), 50, 20210929))
    assert ["pair_coeff", "*", "*", "7000.0", "0.3", "0.4"] in deck
    walls = [words for words in deck if words[0] == "fix" and words[3] == "wall/fractional"]
    memory = ["memory", repr(4 * TCOL)]
    assert ["pair_style", "fractional", *memory] in deck
    assert [words[4:] for words in walls] == [["xplane", "-0.011", "NULL", "7000.0", "0.3", "0.4", *memory],
                                              ["yplane", "NULL", "0.0173", "7000.0", "0.3", "0.4", *memory]]


# Mindlin's k_t of liggghts: one Poisson's ratio for all, so walls as stiff as the spheres.
SAME = {"law": law("tsuji", k=1.1e6, c=1.3), "wall_law": law("tsuji", k=1.1e6, c=1.3)}


@pytest.mark.parametrize("n", STEPS)
@pytest.mark.parametrize("changes", [
    LINEAR, ATTRACTS, KUWABARA_KONO, HYSTERETIC, {**LINEAR, "tangential": ROUGH},
    {**LINEAR, "tangential": {**ROUGH, "parameters": {"k_t": 2100, "c_t": 0.033}}},
    {**TSUJI, "bodies": ALIKE}, {**SAME, "bodies": ALIKE, "tangential": MINDLIN},
    {**KUWABARA_KONO, "tangential": MINDLIN}])
def test_decks_of_liggghts_say_what_the_case_says(tmp_path, changes, n):
    of = case_file(**changes)
    compare(of_liggghts(read(tmp_path, **of), n), asked(of, n))


def test_a_deck_of_liggghts_has_one_spring_against_rolling(tmp_path):
    """rollingStiffness s of kn (mu R)^2: of two spheres alone."""
    of = case_file(walls=[], bodies=BODIES[:2], tangential={**ROLLS, "k_rolling": 0.0031})
    compare(of_liggghts(read(tmp_path, **of), 50), asked(of, 50))


@pytest.mark.parametrize("changes", [
    FRACTIONAL, {**FRACTIONAL, "tangential": {**ROUGH, "parameters": {"k_t": 2100, "c_t": 0.033}}},
    {"law": HERTZ, "wall_law": HERTZ}])
def test_a_deck_of_liggghts_ricochet_says_what_the_case_says(tmp_path, changes):
    of = case_file(**changes)
    compare(of_liggghts(read(tmp_path, **of), 50, "/usr/bin/liggghts-ricochet"), asked(of, 50))
    if changes["law"] is HERTZ:
        deck = liggghts.deck(liggghts.Contacts("liggghts-ricochet", read(tmp_path, **of)), 50)
        fastest = max(math.hypot(*b["velocity"]) for b in BODIES)
        assert f"characteristicVelocity scalar {fastest!r}" in deck


@pytest.mark.parametrize("n", STEPS)
@pytest.mark.parametrize("changes", [
    {**LINEAR, "tangential": {**ROUGH, "parameters": {"k_t": 2100, "c_t": 0.033}}},
    {**TSUJI, "bodies": ALIKE}, {**SAME, "bodies": ALIKE, "tangential": MINDLIN}])
def test_decks_of_yade_say_what_the_case_says(tmp_path, monkeypatch, changes, n):
    of = case_file(**changes)
    compare(of_yade(read(tmp_path, **of), n, tmp_path, monkeypatch), asked(of, n))


def test_a_deck_of_yade_by_time_and_restitution(tmp_path, monkeypatch):
    """A wall twice as stiff as the pair is out of reach for springs in series."""
    stiff = {"law": law("linear", k=7000, c=0.11), "wall_law": law("linear", k=21000, c=0.07)}
    of = case_file(**stiff, bodies=ALIKE)
    compare(of_yade(read(tmp_path, **of), 50, tmp_path, monkeypatch, at_wall=0.5), asked(of, 50))


@pytest.mark.parametrize("n", STEPS)
@pytest.mark.parametrize("changes", [
    LINEAR, ATTRACTS, KUWABARA_KONO, TSUJI, HYSTERETIC, FRACTIONAL,
    {**LINEAR, "tangential": {**ROUGH, "parameters": {"k_t": 2100, "c_t": 0.033}}}, {**TSUJI, "tangential": MINDLIN},
    {**LINEAR, "bodies": ALIKE, "tangential": {**ROLLS, "k_rolling": 1.4 * ALIKE[0]["radius"]**2 * 2100}}])
def test_scenes_of_simulate_say_what_the_case_says(tmp_path, changes, n):
    of = case_file(**changes)
    compare(of_simulate(read(tmp_path, **of), n), asked(of, n), but=("k_rolling",))
