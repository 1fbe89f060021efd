#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures polyhedral meshing next to peers in one run, and writes the tables of benchmarks/results/polyhedral.md.

Peers: CGAL Mesh_3, which the build makes (cgal_driver); Debian's TetGen 1.5, if --tetgen-15 names it or it is on the path; a newer
TetGen, if --tetgen names it. Times are seconds of processor time of the refinement alone, medians of --runs runs, the programs taken
in turn so that a drift of the machine's speed hits all of them; ratios are of medians.
"""
import argparse
import os
import re
import shutil
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from measuring import figures, medians, run, table

RADIUS_EDGE = 1.414
# Per case: the volume bound of delref and TetGen, and Mesh_3's size, each for about 100,000 vertices, or a million.
CASES = {
    "cube": (3e-6, 0.0197),
    "elephant": (1.6e-7, 0.0072),
    "cubes": (3e-3, 0.21),
    "cubes, step 0.1": (3e-6, 0.021),
    "cube, a million": (2.9e-7, 0.0091),
}
LARGE = {"cube, a million"}
RATIO_BOUNDS = (2, 1.6, 1.414, 1.3, 1.2, 1.15, 1.1, 1.05)
DELREF, MESH_3, TETGEN_15, TETGEN = "delref", "CGAL Mesh_3", "TetGen 1.5", "TetGen, newer"


def write_cubes(path, count, place):
    """A lattice of count cubes a side as a .poly file: a facet per square, a seed per cube if there are several.
    place(i) is the i-th coordinate."""
    n = count + 1
    squares = []
    for axis in range(3):
        u, v = [(1, 2), (2, 0), (0, 1)][axis]
        step = (1, n, n * n)
        for a in range(n):
            for b in range(count):
                for c in range(count):
                    corner = a * step[axis] + b * step[u] + c * step[v]
                    squares.append((corner, corner + step[u], corner + step[u] + step[v], corner + step[v]))
    with open(path, "w", encoding="utf-8") as file:
        file.write(f"{n ** 3} 3 0 0\n")
        for i in range(n ** 3):
            file.write(f"{i} {place(i % n)!r} {place(i // n % n)!r} {place(i // n // n)!r}\n")
        file.write(f"{len(squares)} 0\n")
        for square in squares:
            file.write("1\n4 {} {} {} {}\n".format(*square))
        seeds = count ** 3 if count > 1 else 0
        file.write(f"0\n{seeds}\n")
        for i in range(seeds):
            seed = [0.5 * (place(k) + place(k + 1)) for k in (i % count, i // count % count, i // count // count)]
            file.write(f"{i} {seed[0]!r} {seed[1]!r} {seed[2]!r} {i + 1} 0\n")


class Meshers:
    def __init__(self, args, folder):
        self.args = args
        self.folder = folder
        self.bin = Path(args.bin).resolve()
        self.programs = [DELREF] + [TETGEN_15] * bool(args.tetgen_15) + [TETGEN] * bool(args.tetgen) + [MESH_3]

    def delref(self, path, volume, radius_edge=RADIUS_EDGE, vertices=0):
        return figures(run([self.bin / "delref_driver", path, radius_edge, volume, 0, vertices], self.folder)[0])

    def mesh_3(self, path, size):
        return figures(run([self.bin / "cgal_driver", path, 2, size], self.folder)[0])

    def tetgen(self, path, volume, program, radius_edge=RADIUS_EDGE):
        """TetGen without what it does to the mesh after refinement (O0/0, and s0/0 of the newer one)."""
        after = "O0/0" if program == TETGEN_15 else "O0/0s0/0"
        bound = f"a{volume:.12f}" if volume else ""
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(path, folder)
            command = [self.args.tetgen_15 if program == TETGEN_15 else self.args.tetgen, f"-pq{radius_edge}A{bound}{after}", path.name]
            text, megabytes = run(command, folder)
            seconds = float(re.search(r"Refinement seconds:\s+(\S+)", text)[1])
            mesh = Path(folder) / (path.stem + ".1.ele")
            return {"seconds": seconds, "megabytes": megabytes, **figures(run([self.bin / "measure_mesh", mesh, radius_edge], folder)[0])}

    def mesh(self, program, path, volume, size):
        if program == DELREF:
            return self.delref(path, volume)
        return self.mesh_3(path, size) if program == MESH_3 else self.tetgen(path, volume, program)

    def inputs(self):
        """The input of each case; those that the repository does not make come from --data."""
        cube, elephant = Path(self.folder) / "cube.poly", Path(self.args.data) / "elephant.off"
        write_cubes(cube, 1, float)
        cubes, cubes_by_tenths = Path(self.folder) / "cubes.poly", Path(self.folder) / "cubes_by_tenths.poly"
        write_cubes(cubes, 10, int)
        write_cubes(cubes_by_tenths, 10, lambda i: i * 0.1)
        paths = {"cube": cube, "cubes": cubes, "cubes, step 0.1": cubes_by_tenths, "cube, a million": cube}
        if self.args.data and elephant.exists():
            paths["elephant"] = elephant.resolve()
        return paths


def rate(result):
    return result["vertices"] / result["seconds"]


def measure(meshers, name, path):
    """The median figures of each program on one case."""
    volume, size = CASES[name]
    calls = {program: lambda p=program: meshers.mesh(p, path, volume, size) for program in meshers.programs}
    return medians(calls, meshers.args.large_runs if name in LARGE else meshers.args.runs, {MESH_3: meshers.args.mesh_3_runs})


def speed(results):
    rows = []
    for name, of in results.items():
        for program, r in of.items():
            rows.append([name, program, f"{r['vertices']:,.0f}", f"{r['tetrahedra']:,.0f}", f"{r['seconds']:.3f}", f"{rate(r):,.0f}",
                         f"{rate(of[DELREF]) / rate(r):.2f}" if r["vertices"] else "no mesh", f"{r['megabytes']:.0f}"])
    return table("Speed", "Refinement alone; delref's includes making the triangulation conform to the input, TetGen's and Mesh_3's do "
                 "not include what they do before it. Memory is the peak of the program.",
                 ["case", "program", "vertices", "tetrahedra", "seconds", "vertices/s", "delref is times as fast", "MB"], rows)


def quality(results):
    rows = []
    for name, of in results.items():
        for program, r in of.items():
            rows.append([name, program, f"{r['over_bound']:,.0f}", f"{r['over_2']:,.0f}", f"{r['worst_radius_edge']:.2f}",
                         f"{r['smallest_dihedral']:.2g} to {r['largest_dihedral']:.5g}", f"{r['slivers']:,.0f}", f"{r['volume']:.12g}"])
    return table("Quality", f"Tetrahedra over the radius-edge bound (Mesh_3's is 2, that of the others {RADIUS_EDGE}), over 2, the worst; "
                 "dihedral angles in degrees; tetrahedra with one under 5 degrees. Before any smoothing or optimisation.",
                 ["case", "program", "over the bound", "over 2", "worst", "dihedral angles", "slivers", "volume"], rows)


def counts(meshers, paths):
    """Vertices for the same bounds."""
    rows = []
    for name, path in paths.items():
        if name in LARGE:
            continue
        for factor in (0, 100, 10, 1):
            volume = CASES[name][0] * factor
            ours = meshers.delref(path, volume)["vertices"]
            row = [name, f"{volume:.3g}" if volume else "none", f"{ours:,.0f}"]
            for program in (TETGEN_15, TETGEN):
                if program in meshers.programs:
                    theirs = meshers.tetgen(path, volume, program)["vertices"]
                    row += [f"{theirs:,.0f}", f"{ours / theirs:.3f}"]
                else:
                    row += ["", ""]
            rows.append(row)
    return table("Vertices for the same bounds", f"Radius-edge ratio {RADIUS_EDGE} and a volume bound.",
                 ["case", "volume bound", DELREF, TETGEN_15, "ratio", TETGEN, "ratio"], rows)


def lowest(meshers, path, budget):
    """How low the bound on the radius-edge ratio goes on the cube."""
    rows = []
    for bound in RATIO_BOUNDS:
        row = [bound]
        for volume in (1e-3, 1e-5):
            r = meshers.delref(path, volume, bound, budget)
            row += ["no" if r["stopped"] else "yes", f"{r['vertices']:,.0f}", f"{r['seconds']:.2f}"]
        rows.append(row)
    return table("How low the radius-edge bound goes", f"The cube, delref, a budget of {budget:,} vertices.",
                 ["bound", "volume 1e-3: ends", "vertices", "seconds", "volume 1e-5: ends", "vertices", "seconds"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, help="the folder of delref_driver, cgal_driver and measure_mesh")
    parser.add_argument("--data", default="", help="a folder with elephant.off")
    parser.add_argument("--tetgen-15", default=shutil.which("tetgen"), help="Debian's tetgen; the one on the path by default")
    parser.add_argument("--tetgen", help="a newer TetGen's program")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--large-runs", type=int, default=3, help="runs at a million vertices")
    parser.add_argument("--mesh-3-runs", type=int, default=3, help="at most so many runs of Mesh_3, the slowest; 0 for none")
    parser.add_argument("--cases", help="some of: " + "; ".join(CASES) + " (with ; between), or none; all by default")
    parser.add_argument("--skip", default="", help="sections to leave away: counts, lowest")
    args = parser.parse_args()
    for program in ("tetgen", "tetgen_15"):
        if getattr(args, program):
            setattr(args, program, os.path.abspath(getattr(args, program)))
    with tempfile.TemporaryDirectory() as folder:
        meshers = Meshers(args, folder)
        paths = meshers.inputs()
        wanted = [c.strip() for c in args.cases.split(";")] if args.cases else list(CASES)
        chosen = {name: paths[name] for name in CASES if name in paths and name in wanted}
        results = {name: measure(meshers, name, path) for name, path in chosen.items()}
        if results:
            print(speed(results), quality(results), sep="\n", flush=True)
        if "counts" not in args.skip:
            print(counts(meshers, chosen or paths), flush=True)
        if "lowest" not in args.skip:
            print(lowest(meshers, paths["cube"], 300_000), flush=True)


if __name__ == "__main__":
    main()
