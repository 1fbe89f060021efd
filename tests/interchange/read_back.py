#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Reads the files of write_samples back with meshio, VTK and gmsh and compares points, cells, labels and markers.

Usage: read_back.py WRITE_SAMPLES FOLDER. Exit code 77 when meshio is missing: the test is skipped.
"""
import os
import shutil
import subprocess
import sys

try:
    import meshio
    import numpy as np
except ImportError as error:
    print(f"skipped: {error}")
    sys.exit(77)


class Expected:
    """A mesh as it was written."""

    def __init__(self, path):
        points, cells = [], {2: [], 3: [], 4: []}
        for line in open(path):
            kind, *fields = line.split()
            (points if kind == "p" else cells[int(kind)]).append(fields)
        self.points = np.array([[float(f) for f in r[:3]] for r in points])
        self.point_markers, self.provenance, self.carrier_dimension, self.carrier = (
            np.array([int(r[k]) for r in points]) for k in range(3, 7))
        # By name in meshio, highest dimension first: the cells with their labels, and the input elements of them.
        names = {4: "tetra", 3: "triangle", 2: "line"}
        self.dimension = 3 if cells[4] else 2
        self.cells = {names[n]: [tuple(map(int, r[:n + 1])) for r in cells[n]] for n in (4, 3, 2) if cells[n]}
        self.elements = {names[n]: [int(r[n + 1]) for r in cells[n]] for n in (3, 2) if n <= self.dimension}
        self.triangles, self.edges = self.cells["triangle"], self.cells["line"]

    def label(self, kind):
        return "region" if kind == next(iter(self.cells)) else "marker"


checks = 0


def same(what, found, wanted):
    global checks
    checks += 1
    if isinstance(found, np.ndarray) or isinstance(wanted, np.ndarray):
        equal = np.array_equal(np.asarray(found), np.asarray(wanted))
    else:
        equal = found == wanted
    if not equal:
        sys.exit(f"FAILED: {what}:\n  found  {found}\n  wanted {wanted}")


def blocks(mesh, kind, data):
    """The cells of one kind, each with its value in the cell data (which has an array per block)."""
    out = []
    for block, values in zip(mesh.cells, data):
        if block.type == kind:
            out += [(*map(int, c), int(v)) for c, v in zip(block.data, values)]
    return out


def labels_by_name(mesh, dimension):
    """From physical tag to the label in the name of the group."""
    return {int(tag): int(name.split()[-1]) for name, (tag, dim) in mesh.field_data.items() if dim == dimension}


def meshio_msh(path, expected, what, exact=True):
    """Not exact: the program that wrote the file may have reordered the points and dropped their last digits."""
    mesh = meshio.read(path)
    if exact:
        same(f"{what}: points", mesh.points, expected.points)
    else:
        key = lambda p: tuple(round(float(x), 9) + 0.0 for x in p)
        place = {key(p): i for i, p in enumerate(expected.points)}
        same(f"{what}: points", sorted(key(p) for p in mesh.points), sorted(place))
        number = np.array([place[key(p)] for p in mesh.points])
        mesh.cells = [meshio.CellBlock(block.type, number[block.data]) for block in mesh.cells]
    for kind, wanted in expected.cells.items():
        names = labels_by_name(mesh, {"tetra": 3, "triangle": 2, "line": 1}[kind])
        found = [(*c[:-1], names[c[-1]]) for c in blocks(mesh, kind, mesh.cell_data["gmsh:physical"])]
        same(f"{what}: {kind}s and their labels", sorted(found), sorted(wanted))
        tags = {label: tag for tag, label in names.items()}
        same(f"{what}: positive labels are their own tags", [tags[l] for l in tags if l > 0], [l for l in tags if l > 0])
    return mesh


def check_meshio(stem, expected):
    mesh = meshio_msh(stem + ".msh", expected, "msh by meshio")
    same("msh by meshio: markers of points", mesh.point_data["marker"].ravel().astype(int), expected.point_markers)

    mesh = meshio.read(stem + ".vtu")
    same("vtu by meshio: points", mesh.points, expected.points)
    for kind, wanted in expected.cells.items():
        same(f"vtu by meshio: {kind}s and their labels", blocks(mesh, kind, mesh.cell_data[expected.label(kind)]), wanted)
    for kind, name in (("line", "segment"), ("triangle", "facet"))[:expected.dimension - 1]:
        same(f"vtu by meshio: {name}s", [c[-1] for c in blocks(mesh, kind, mesh.cell_data[name])], expected.elements[kind])
    for name, wanted in (("marker", expected.point_markers), ("provenance", expected.provenance),
                         ("carrier_dimension", expected.carrier_dimension), ("carrier", expected.carrier)):
        same(f"vtu by meshio: {name} of points", mesh.point_data[name], wanted)

    mesh = meshio.read(stem + ".mesh")
    same("mesh by meshio: points", mesh.points, expected.points[:, :expected.dimension])
    same("mesh by meshio: references of points", mesh.point_data["medit:ref"], expected.point_markers)
    for kind, wanted in expected.cells.items():
        same(f"mesh by meshio: {kind}s", blocks(mesh, kind, mesh.cell_data["medit:ref"]), wanted)


def check_off(folder, expected):
    mesh = meshio.read(folder + "/sample.off")
    same("off by meshio: points", mesh.points, expected.points)
    same("off by meshio: triangles", [tuple(map(int, c)) for c in mesh.cells[0].data], [t[:3] for t in expected.triangles])


def check_triangle_files(folder, expected):
    """.node and .ele are simple enough that reading them here is a second opinion."""
    def rows(extension):
        lines = [line.split() for line in open(folder + "/sample" + extension)]
        return lines[0], lines[1:]

    head, lines = rows(".node")
    same("node: header", head, [str(len(expected.points)), "2", "0", "1"])
    same("node: points", np.array([[float(l[1]), float(l[2]), 0] for l in lines]), expected.points)
    same("node: markers", np.array([int(l[3]) for l in lines]), expected.point_markers)
    head, lines = rows(".ele")
    same("ele: header", head, [str(len(expected.triangles)), "3", "1"])
    same("ele: triangles", [tuple(map(int, l[1:])) for l in lines], expected.triangles)
    head, lines = rows(".edge")
    marked = {tuple(sorted(e[:2])): e[2] for e in expected.edges}
    sides = {tuple(sorted((t[i], t[(i + 1) % 3]))) for t in expected.triangles for i in range(3)}
    same("edge: all edges, with markers", {(int(l[1]), int(l[2])): int(l[3]) for l in lines}, {s: marked.get(s, 0) for s in sides})
    lines = [line.split() for line in open(folder + "/sample.poly")]
    same("poly: segments", [tuple(map(int, l[1:])) for l in lines[2:2 + len(expected.edges)]], expected.edges)


def check_tetgen_files(folder, expected):
    mesh = meshio.read(folder + "/solid.node")
    same("TetGen's files by meshio: points", mesh.points, expected.points)
    same("TetGen's files by meshio: tetrahedra", blocks(mesh, "tetra", mesh.cell_data["tetgen:ref"]), expected.cells["tetra"])
    same("TetGen's files by meshio: markers of points", mesh.point_data["tetgen:ref"], expected.point_markers)
    for extension, kind in ((".face", "triangle"), (".edge", "line")):
        head, *lines = [line.split() for line in open(folder + "/solid" + extension)]
        same(f"{extension}: header", head, [str(len(expected.cells[kind])), "1"])
        same(f"{extension}: rows", [tuple(map(int, l[1:])) for l in lines], expected.cells[kind])


def check_vtk(stem, expected):
    try:
        import vtk
        from vtk.util.numpy_support import vtk_to_numpy
    except ImportError as error:
        print(f"vtk passed over: {error}")
        return
    failures = []
    reader = vtk.vtkXMLUnstructuredGridReader()
    reader.AddObserver("ErrorEvent", lambda *_: failures.append("error"))
    reader.SetFileName(stem + ".vtu")
    reader.Update()
    same("vtu by VTK: errors", failures, [])
    grid = reader.GetOutput()
    same("vtu by VTK: points", vtk_to_numpy(grid.GetPoints().GetData()), expected.points)
    cells = [tuple(grid.GetCell(i).GetPointId(k) for k in range(grid.GetCell(i).GetNumberOfPoints())) for i in range(grid.GetNumberOfCells())]
    same("vtu by VTK: cells", cells, [c[:-1] for rows in expected.cells.values() for c in rows])
    begin = 0
    for kind, rows in expected.cells.items():
        labels = vtk_to_numpy(grid.GetCellData().GetArray(expected.label(kind)))
        same(f"vtu by VTK: labels of {kind}s", labels[begin:begin + len(rows)], np.array([c[-1] for c in rows]))
        begin += len(rows)
    same("vtu by VTK: provenance", vtk_to_numpy(grid.GetPointData().GetArray("provenance")), expected.provenance)
    names = bytes(vtk_to_numpy(grid.GetFieldData().GetArray("level_names"))).decode()
    same("vtu by VTK: names of levels", names.split("\n"), ["edges", "faces"] if expected.dimension == 2 else ["edges", "facets", "tetrahedra"])
    if expected.dimension == 3:
        volumes = vtk.vtkCellSizeFilter()
        volumes.SetInputData(grid)
        volumes.Update()
        volume = vtk_to_numpy(volumes.GetOutput().GetCellData().GetArray("Volume"))[:len(expected.cells["tetra"])]
        same("vtu by VTK: tetrahedra turned inside out", int((volume <= 0).sum()), 0)
        return
    angle = vtk_to_numpy(grid.GetCellData().GetArray("min_angle"))[:len(expected.triangles)]
    for (a, b, c, _), found in zip(expected.triangles, angle):
        p = expected.points[[a, b, c]]
        sides = sorted(np.linalg.norm(p[i] - p[i - 1]) for i in range(3))
        wanted = np.degrees(np.arccos((sides[1]**2 + sides[2]**2 - sides[0]**2) / (2 * sides[1] * sides[2])))
        if abs(found - wanted) > 1e-3:
            sys.exit(f"FAILED: vtu by VTK: the smallest angle of triangle {(a, b, c)} is {wanted}, not {found}")


def check_gmsh(stem, expected):
    program = shutil.which("gmsh")
    if not program:
        print("gmsh passed over: not installed")
        return
    copy = stem + "_by_gmsh.msh"
    run = subprocess.run([program, stem + ".msh", "-save", "-format", "msh41", "-o", copy], capture_output=True, text=True)
    same("msh by gmsh: exit code", run.returncode, 0)
    same("msh by gmsh: complaints", [l for l in run.stdout.splitlines() + run.stderr.splitlines() if "Error" in l or "Warning" in l], [])
    meshio_msh(copy, expected, "msh by gmsh and meshio", exact=False)


def check_svg(folder):
    import xml.etree.ElementTree
    root = xml.etree.ElementTree.parse(folder + "/sample.svg").getroot()
    same("svg: root", root.tag, "{http://www.w3.org/2000/svg}svg")
    triangles = sum(p.get("d").count("z") for p in root.iter("{http://www.w3.org/2000/svg}path"))
    same("svg: triangles", triangles, 288)


def check_surfaces(reader, folder):
    """Surfaces that meshio wrote, read by delref."""
    points = np.array([[0, 0, 0], [1, 0, 0], [1, 1.5, 0], [0, 1, 0], [0.25, 0.5, -2]])
    triangles = np.array([[0, 2, 1], [0, 3, 2], [0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]], dtype=np.int32)
    surface = meshio.Mesh(points, [("triangle", triangles)])
    for name, options in (("a.off", {}), ("a.obj", {}), ("text.ply", {"binary": False}), ("bytes.ply", {"binary": True}),
                          ("text.stl", {"binary": False}), ("bytes.stl", {"binary": True})):
        surface.write(folder + "/" + name, **options)
        rows = [line.split() for line in subprocess.run([reader, "--surface", folder + "/" + name], check=True, capture_output=True,
                                                        text=True).stdout.splitlines()]
        found = np.array([[float(f) for f in r[1:]] for r in rows if r[0] == "p"])
        corners = np.array([[int(f) for f in r[1:]] for r in rows if r[0] == "f"])
        same(f"{name} of meshio: triangles", found[corners], points[triangles])


def main():
    writer, folder = sys.argv[1:3]
    os.makedirs(folder, exist_ok=True)
    subprocess.run([writer, folder], check=True)
    plane, solid = Expected(folder + "/expected.txt"), Expected(folder + "/solid.txt")
    for stem, expected in ((folder + "/sample", plane), (folder + "/solid", solid)):
        check_meshio(stem, expected)
        check_vtk(stem, expected)
        check_gmsh(stem, expected)
    check_off(folder, plane)
    check_triangle_files(folder, plane)
    check_tetgen_files(folder, solid)
    check_surfaces(writer, folder)
    check_svg(folder)
    print(f"{checks} comparisons, all equal")


main()
