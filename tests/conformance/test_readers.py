"""What adapters read of what engines write: every number in its place."""

import pytest
from pair_case import ADAPTERS  # noqa: F401  (the adapters' folder is on the path)

import lammps
import lammps_family
import liggghts
import outcome
import simulate
import yade


def states(*numbers_of_bodies):
    return [outcome.State(n[0:3], n[3:6], n[6:9]) for n in numbers_of_bodies]


FIRST, SECOND = (1.5, 2, 3, 4, 5, 6, 7, 8, 9), (11, 12, 13, 14, 15, 16, 17, 18, 19)
PUSH, PULL = (21, 22, 23), (-21, -22, -23)


def line(*groups):
    return " ".join(str(x) for group in groups for x in group) + "\n"


def dumped(*bodies):
    return "".join(f"ITEM: TIMESTEP\n{k}\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n-1 1\n-1 1\n-1 1\n"
                   "ITEM: ATOMS x y z vx vy vz omegax omegay omegaz fx fy fz\n" + "".join(rows)
                   for k, rows in enumerate(bodies))


def test_a_dump_of_lammps(tmp_path):
    path = tmp_path / "path.50"
    path.write_text(dumped([line(FIRST, PUSH), line(SECOND, PULL)], [line(SECOND, PULL), line(FIRST, PUSH)]))
    assert lammps_family.read_dump(str(path), 2) == [outcome.Instant(states(FIRST, SECOND), PUSH),
                                                     outcome.Instant(states(SECOND, FIRST), PULL)]


@pytest.mark.parametrize("rows", [
    [[line(FIRST, PUSH)], [line(FIRST, PUSH), line(SECOND, PULL)]], [[line(FIRST, PUSH)]],
    [[line(FIRST, PUSH), line(SECOND, PULL), line(SECOND, PULL)]]])
def test_a_dump_of_lammps_that_lost_a_body(tmp_path, rows):
    path = tmp_path / "path.50"
    path.write_text(dumped(*rows))
    with pytest.raises(outcome.EngineFailed, match="a body was lost on its way"):
        lammps_family.read_dump(str(path), 2)


def test_a_path_of_yade(tmp_path):
    path = tmp_path / "0.50"
    path.write_text(line(FIRST, SECOND, PUSH) + line(SECOND, FIRST, PULL))
    assert yade.read_path(str(path), 2) == [outcome.Instant(states(FIRST, SECOND), PUSH),
                                            outcome.Instant(states(SECOND, FIRST), PULL)]


def test_a_trajectory_of_simulate(tmp_path):
    def atom(name, body, number):
        return f"{name} " + line(body[0:3], (1e-3, 2e-6), body[3:9], (number,))

    path = tmp_path / "trajectory.xyz"
    path.write_text("".join("2\nLattice Time=0\n" + atom("grain", a, 1) + atom("grain", b, 2)
                            for a, b in ((FIRST, SECOND), (SECOND, FIRST))))
    assert simulate.read_trajectory(str(path), 2) == [outcome.Instant(states(FIRST, SECOND)),
                                                      outcome.Instant(states(SECOND, FIRST))]


def test_the_first_contact_of_body_1_in_contacts_of_simulate(tmp_path):
    path = tmp_path / "contacts.csv"
    head = "i,j,t_begin [s],t_end [s]\n"
    path.write_text(head + "2,3,0.125,0.25\n3,1,1.5,1.75\n1,2,0.5,1.25\n")
    assert simulate.first_contact_time(str(path)) == 0.75
    path.write_text(head + "1,2,0.5,\n")
    assert simulate.first_contact_time(str(path)) is None
    path.write_text(head)
    assert simulate.first_contact_time(str(path)) is None


@pytest.mark.parametrize("adapter, name, said, version", [
    (lammps, "lmp", "Large-scale Atomic/Molecular Massively Parallel Simulator - 29 Sep 2021 - Update 2",
     "29 Sep 2021 Update 2"),
    (lammps, "lammps-ricochet", "Massively Parallel Simulator - 4 Feb 2025", "4 Feb 2025 with lammps-ricochet"),
    (liggghts, "liggghts", "LIGGGHTS (Version LIGGGHTS-PUBLIC 3.8.0, compiled", "3.8.0"),
    (liggghts, "liggghts-ricochet", "(Version LIGGGHTS-PUBLIC 3.8.0, compiled", "3.8.0 with liggghts-ricochet"),
    (yade, "yade", "Yade version: 2023.02a", "2023.02a"), (simulate, "simulate", "simulate 0.1.0", "0.1.0")])
def test_versions_are_those_that_engines_tell(tmp_path, adapter, name, said, version):
    program = tmp_path / name
    program.write_text(f"#!/bin/sh\necho '{said}'\n")
    program.chmod(0o755)
    assert adapter.version(str(program)) == version
    if adapter is lammps:
        assert lammps.date_of(str(program)) == (20210929 if name == "lmp" else 20250204)
