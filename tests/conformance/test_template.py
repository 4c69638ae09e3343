"""The template: it runs as it stands, and what it shows is right."""

import csv
import math
import re
import subprocess
import sys
import types

import pytest
from pair_case import ADAPTERS, PAIR, ROOT, kit, read, written

NUMBERS = "none one two three four five six seven eight nine ten eleven twelve".split()


ROUGH = {"name": "linear", "parameters": {"k_t": 2100, "c_t": 0.5}, "mu": 0.31, "torsion": False, "mu_rolling": 0,
         "k_rolling": 0, "c_rolling": 0}
WALL = {"point": [-0.0031, 0, 0], "normal": [1, 0, 0]}


def lines_of_template():
    return (ADAPTERS / "template.py").read_text(encoding="utf-8").splitlines()


def test_the_template_runs_as_it_stands(tmp_path):
    written(tmp_path)
    written(tmp_path, case="rough", tangential=ROUGH)
    written(tmp_path, case="walled", walls=[WALL], wall_law=PAIR["law"])
    written(tmp_path, case="falling", gravity=[0, 0, -9.81])
    result = tmp_path / "mine.csv"
    subprocess.run([sys.executable, ADAPTERS / "template.py", tmp_path, "-o", result, "--program", sys.executable],
                   check=True)
    rows = list(csv.reader(line for line in result.read_text().splitlines() if line[0] != "#"))[1:]
    assert {row[0]: row[14] for row in rows} == {
        "pair": "", "rough": "no friction", "walled": "no walls",
        "falling": "nothing but two spheres, without gravity"}
    errors = [abs(float(row[6]) + 0.25) / 0.25 for row in rows if row[0] == "pair" and row[2] == "1"]
    # Leapfrog of an undamped contact, begun and ended within a step: second order.
    assert errors[1] < errors[0] < (math.pi / 50) ** 2 and errors[1] < (math.pi / 100) ** 2


def test_what_the_template_shows_in_comments_says_what_the_case_says(tmp_path):
    """Walls and friction, uncommented in place of the NotRun above them."""
    text = "\n".join(lines_of_template())
    for why in ("no friction", "no walls"):
        assert text.count(f'    raise NotRun("{why}")\n    # ') == 1
        text = text.replace(f'    raise NotRun("{why}")\n', "")
    text, uncommented = re.subn(r"(?m)^    # ( *\S)", r"    \1", text)
    assert uncommented == 8
    module = types.ModuleType("mine")
    exec(compile(text, "mine.py", "exec"), vars(module))
    wall_law = {"name": "linear", "parameters": {"k": 5300, "c": 0.07}, "end": "force"}
    deck = module.deck(read(tmp_path, walls=[WALL], wall_law=wall_law, tangential=ROUGH), 50)
    assert "k_t, c_t, mu = 2100.0, 0.5, 0.31\n" in deck
    assert "wall((-0.0031, 0.0, 0.0), (1.0, 0.0, 0.0), k=5300.0, c=0.07, end='force')\n" in deck
    for changes, why in (
            ({"tangential": {**ROUGH, "name": "mindlin"}}, "nothing but a constant k_t"),
            ({"walls": [WALL], "wall_law": {**wall_law, "name": "tsuji"}}, "no law of a wall but the linear one")):
        with pytest.raises(kit.NotRun, match=why):
            module.deck(read(tmp_path, **changes), 50)


def test_the_template_has_the_lines_that_it_and_the_documentation_say():
    count = len(lines_of_template())
    assert f"An adapter to begin with, in {count} lines," in "\n".join(lines_of_template())
    page = (ROOT / "docs" / "conformance.md").read_text(encoding="utf-8")
    assert re.findall(r"`template\.py`, (\d+) lines", page) == [str(count)]
    # Every place to change has the mark that the page promises.
    places = len([line for line in lines_of_template() if re.search(r"(# |\"\"\"|^# )HERE: ", line)])
    assert re.findall(r"(\w+) places with `HERE`", page) == [NUMBERS[places]]
