#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures the meshing of smooth surfaces and volumes next to peers in one run, and writes the tables of benchmarks/results/smooth.md.

Peers, which the build makes: CGAL Mesh_3 (mesh_3_driver), the same with its undocumented lazy queue (mesh_3_lazy_driver), CGAL's older
Surface_mesher (surface_mesher_driver). Mesh_3 is run with its default error bound, with which its vertices are off the surface, and
with one of 1e-6. Times are seconds of processor time of the refinement alone, medians of --runs runs, the programs taken in turn so
that a drift of the machine's speed hits all of them; ratios are of medians. Meshes are measured by measure_smooth, which shares no
code with any mesher.
"""
import argparse
import math
import sys
import tempfile
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from measuring import figures, medians, run, table

DELREF, MESH_3, LAZY, SURFACE_MESHER, ACCURATE = "delref", "Mesh_3", "Mesh_3, lazy queue", "Surface_mesher", "Mesh_3, error bound 1e-6"
DRIVERS = {DELREF: "delref_driver", MESH_3: "mesh_3_driver", LAZY: "mesh_3_lazy_driver", SURFACE_MESHER: "surface_mesher_driver",
           ACCURATE: "mesh_3_driver"}
VOLUME, SURFACE = [DELREF, MESH_3, LAZY, ACCURATE], [DELREF, MESH_3, LAZY, ACCURATE, SURFACE_MESHER]
SKULL = "skull_2.9.inr.gz"
# Per case: the domain, facet angle, facet size, facet distance, radius-edge ratio, cell size (0 for none), who meshes it.
CASES = {
    "tangle volume": ("tangle", 30, 0.0379, 0, 2, 0, VOLUME),
    "skull volume": (SKULL + ":2.9", 30, 0, 1, 2, 2.285, VOLUME),
    "sphere surface": ("sphere", 30, 0.0092, 0, 0, 0, SURFACE),
    "torus surface": ("torus", 30, 0.0102, 0, 0, 0, SURFACE),
    "tangle surface": ("tangle", 30, 0.0259, 0, 0, 0, SURFACE),
    "tangle volume, a million": ("tangle", 30, 0.0094, 0, 2, 0, [DELREF, MESH_3, LAZY]),
    "tangle volume, distance 0.0012": ("tangle", 30, 0, 0.0012, 2, 0, [DELREF, MESH_3, ACCURATE]),
}
SMALL, LARGE, DISTANCE = "tangle volume", "tangle volume, a million", "tangle volume, distance 0.0012"
# The components of the surfaces, and their Euler characteristic, all together; the skull's are of its trilinear level set.
TOPOLOGY = {"tangle": (1, -8), "sphere": (1, 2), "torus": (1, 0), SKULL + ":2.9": (2, 0)}
RUNAWAY_SECONDS = 60


class Meshers:
    def __init__(self, args, folder):
        self.args = args
        self.bin = Path(args.bin).resolve()
        self.mesh = Path(folder) / "out.mesh"
        self.quality = {}

    def names(self, case):
        """The programs that mesh a case, of those that were built."""
        return [name for name in CASES[case][-1] if (self.bin / DRIVERS[name]).exists()]

    def run(self, name, case):
        """One run; the first one of a program on a case is measured too. Infinite seconds when it did not end."""
        domain, *bounds, _ = CASES[case]
        if domain.startswith(SKULL):
            domain = f"{Path(self.args.data).resolve()}/{domain}"
        is_first = (name, case) not in self.quality
        command = [self.bin / DRIVERS[name], domain, *bounds, self.mesh if is_first else "-"] + [1e-6] * (name == ACCURATE)
        print(*command, file=sys.stderr, flush=True)
        text, megabytes = run(command, seconds=RUNAWAY_SECONDS if case == DISTANCE else None)
        if text is None:
            self.quality[name, case] = None
            return {"seconds": math.inf, "megabytes": megabytes}
        if is_first:
            self.quality[name, case] = figures(run([self.bin / "measure_smooth", self.mesh, domain])[0])
        return figures(text)

    def measure(self, case):
        """The median figures of each program on one case, with those of its mesh."""
        calls = {name: lambda n=name: self.run(n, case) for name in self.names(case)}
        few = dict.fromkeys((MESH_3, LAZY, SURFACE_MESHER, ACCURATE), self.args.peer_runs)
        if case == DISTANCE:
            few[MESH_3] = min(1, self.args.peer_runs)
        found = medians(calls, self.args.large_runs if case == LARGE else self.args.runs, few)
        return {name: {**r, **(self.quality[name, case] or {})} for name, r in found.items()}


def rate(result):
    return result["vertices"] / result["seconds"]


def speed(results):
    rows = []
    for case, of in results.items():
        for name, r in of.items():
            if math.isinf(r["seconds"]):
                rows.append([case, name, "", "", f"not in {RUNAWAY_SECONDS}", "", "", f"{r['megabytes']:,.0f}", "", ""])
                continue
            times = f"{rate(of[DELREF]) / rate(r):.2f}" if DELREF in of and not math.isinf(of[DELREF]["seconds"]) else ""
            rows.append([case, name, f"{r['vertices']:,.0f}", f"{r['tetrahedra'] or r['triangles']:,.0f}", f"{r['seconds']:.3f}",
                         f"{rate(r):,.0f}", times, f"{r['megabytes']:.0f}", f"{r['megabytes'] * 2**20 / r['vertices']:,.0f}",
                         f"{r['evaluations'] / r['vertices']:.0f}" if "evaluations" in r else ""])
    return table("Speed", "Refinement alone. Elements are the tetrahedra of volumes and the triangles of surfaces. Memory is the peak of "
                 "the program. Function values are those asked of the domain, where the program tells.",
                 ["case", "program", "vertices", "elements", "seconds", "vertices/s", "delref is times as fast", "MB", "bytes a vertex",
                  "function values a vertex"], rows)


def growth(results):
    rows = []
    for name in results[SMALL]:
        if name in results[LARGE]:
            small, large = rate(results[SMALL][name]), rate(results[LARGE][name])
            rows.append([name, f"{small:,.0f}", f"{large:,.0f}", f"{100 * (large / small - 1):+.0f} %"])
    return table("From 57,000 vertices to a million", "The tangle volume, vertices/s.", ["program", SMALL, LARGE, "change"], rows)


def topology(results):
    rows = []
    for case, of in results.items():
        components, euler = TOPOLOGY[CASES[case][0]]
        for name, r in of.items():
            if "euler" not in r:
                continue
            torn = r["open_edges"] + r["branching_edges"] + r["pinched_vertices"]
            is_right = torn == 0 and (r["components"], r["euler"]) == (components, euler)
            rows.append([case, name, f"{r['open_edges']:.0f}", f"{r['branching_edges']:.0f}", f"{r['pinched_vertices']:.0f}",
                         f"{r['components']:.0f} ({components})", f"{r['euler']:.0f} ({euler})", "yes" if is_right else "no",
                         f"{r['unmatched_triangles']:.0f}" if "unmatched_triangles" in r else ""])
    return table("Topology", "Of the surface's triangles, the truth in parentheses; edges of one triangle, of three or more, vertices "
                 "between several fans; triangles that are not exactly those around the tetrahedra.",
                 ["case", "program", "open edges", "branching edges", "pinched vertices", "components", "Euler characteristic", "right",
                  "unmatched triangles"], rows)


def quality(results):
    rows = []
    for case, of in results.items():
        for name, r in of.items():
            if "euler" not in r:
                continue
            cells = [f"{r['worst_radius_edge']:.3f}", f"{r['smallest_dihedral']:.2g} to {r['largest_dihedral']:.5g}",
                     f"{r['slivers']:,.0f}"] if r["tetrahedra"] else ["", "", ""]
            rows.append([case, name, f"{r['smallest_angle']:.2f}", *cells, f"{r['mean_error']:.3g}", f"{r['lattice_error']:.3g}",
                         f"{r['largest_error']:.3g}", f"{r['vertex_error']:.1g}"])
    return table("Quality", "The smallest angle of the surface's triangles, the largest radius-edge ratio, dihedral angles in degrees, "
                 "tetrahedra with one under 5 degrees; distances from the true surface: the mean over the triangles by area, that of "
                 "ten points of each (corners, thirds of sides, middle), the largest, the largest of a vertex. Before any smoothing or "
                 "optimisation.",
                 ["case", "program", "smallest angle", "radius-edge", "dihedral angles", "slivers", "mean error", "of ten points",
                  "largest", "of vertices"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, help="the folder of the drivers and of measure_smooth; those that are missing are left out")
    parser.add_argument("--data", default="", help=f"a folder with {SKULL}; without it the functions are measured")
    parser.add_argument("--runs", type=int, default=5)
    parser.add_argument("--large-runs", type=int, default=3, help="runs at a million vertices")
    parser.add_argument("--peer-runs", type=int, default=5, help="at most so many runs of each peer; 0 for none")
    parser.add_argument("--cases", help="some of: " + "; ".join(CASES) + " (with ; between); all by default")
    args = parser.parse_args()
    wanted = [c.strip() for c in args.cases.split(";")] if args.cases else list(CASES)
    unknown = [c for c in wanted if c not in CASES]
    if unknown:
        raise SystemExit(f"no such case: {'; '.join(unknown)}")
    has_skull = bool(args.data) and (Path(args.data) / SKULL).exists()
    chosen = [c for c in CASES if c in wanted and (has_skull or not CASES[c][0].startswith(SKULL))]
    with tempfile.TemporaryDirectory() as folder:
        meshers = Meshers(args, folder)
        results = {case: meshers.measure(case) for case in chosen}
    print(speed(results), flush=True)
    if SMALL in results and LARGE in results:
        print(growth(results), flush=True)
    print(topology(results), quality(results), sep="\n", flush=True)


if __name__ == "__main__":
    main()
