#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
#
# readers.sh SIMULATE: what other programs read of a run that simulate wrote. ASE, which knows no species but elements,
# reads its extended XYZ, VTK its frames; one that is not installed is skipped and named, and 77 says that.
set -euo pipefail
simulate=$(readlink -f "$1")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder"
cat > scene.json <<'SCENE'
{"duration": 0.02, "output_interval": 0.002, "gravity": [0, 0, -9.81],
 "materials": {"Si": {"density": 2500}, "steel": {}, "Cu": {"density": 8900}},
 "interactions": [{"between": ["Si", "Si"], "law": {"name": "linear", "k": 1e4, "c": 0.3}},
                  {"between": ["Si", "Cu"], "law": {"name": "linear", "k": 1e4, "c": 0.3}},
                  {"between": ["Cu", "steel"], "law": {"name": "linear", "k": 1e4, "c": 0.3}},
                  {"between": ["Si", "steel"], "law": {"name": "linear", "k": 1e4, "c": 0.3}}],
 "periodic": {"x": [-0.02, 0.02]},
 "spheres": [{"radius": 0.004, "material": "Cu", "position": [0.02, 0, 0.004], "spin": [1, 2, 3]}],
 "pour": [{"number": 20, "material": "Si", "radius": 0.002, "rate": 2000, "velocity": [0, 0, -1],
           "region": {"low": [-0.02, -0.01, 0.02], "high": [0.02, 0.01, 0.04]}}],
 "walls": [{"point": [0, 0, 0], "inward": [0, 0, 1], "material": "steel"}]}
SCENE
"$simulate" scene.json -o run --format vtk 2> /dev/null

cat > read.py <<'READ'
import csv, json, sys
reader = sys.argv[1]
counts = [int(row["spheres"]) for row in csv.DictReader(open("run/energy.csv"))]
assert len(counts) == 11 and counts[0] == 1 and counts[-1] == 21, counts
if reader == "ASE":
    try:
        import ase.io
    except ImportError:
        sys.exit(77)
    frames = ase.io.read("run/trajectory.xyz", index=":")
    assert [len(f) for f in frames] == counts
    last = frames[-1]
    assert list(last.pbc) == [True, False, False], last.pbc
    assert abs(last.cell[0][0] - 0.04) < 1e-15 and (last.cell.lengths() > 0).all(), last.cell
    assert abs(last.info["Time"] - 0.02) < 1e-15
    names = ["Cu"] + 20 * ["Si"]
    kinds = last.arrays["species"] if "species" in last.arrays else last.get_chemical_symbols()
    assert list(kinds) == names, kinds
    assert last.arrays["radius"][0] == 0.004 and last.arrays["radius"][1] == 0.002
    assert list(last.arrays["angular_velocity"][0]) == [1, 2, 3]
    assert list(last.arrays["id"]) == list(range(1, 22))
    assert (abs(last.positions[:, 0]) <= 0.02).all()
else:
    try:
        import vtk
    except ImportError:
        sys.exit(77)
    series = json.load(open("run/vtk/spheres.vtk.series"))["files"]
    assert len(series) == 11
    for entry, count in zip(series, counts):
        reader = vtk.vtkPolyDataReader()
        reader.SetFileName("run/vtk/" + entry["name"])
        reader.ReadAllScalarsOn()
        reader.ReadAllVectorsOn()
        reader.Update()
        data = reader.GetOutput()
        assert data.GetNumberOfPoints() == count == data.GetNumberOfVerts()
        assert data.GetFieldData().GetArray("TIME").GetValue(0) == entry["time"]
        of = data.GetPointData()
        names = [of.GetArrayName(k) for k in range(of.GetNumberOfArrays())]
        assert sorted(names) == ["mass", "material", "number", "radius", "spin", "velocity"], names
    assert of.GetArray("radius").GetValue(1) == 0.002 and of.GetArray("material").GetValue(0) == 2
    assert of.GetArray("spin").GetTuple(0) == (1, 2, 3)
    assert data.GetPoint(0)[2] < 0.005
READ
# Debian's packages belong to Debian's Python, which need not be the first on the PATH.
skipped=0
for reader in ASE VTK; do
  for python in /usr/bin/python3 python3; do
    code=0
    "$python" read.py "$reader" || code=$?
    [[ $code == 77 ]] || break
  done
  case $code in
    0) ;;
    77) echo "skipped: $reader, which is not installed"; skipped=77 ;;
    *) exit "$code" ;;
  esac
done
exit "$skipped"
