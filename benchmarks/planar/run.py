#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures planar meshing next to peers in one run, and writes the tables of benchmarks/results/planar.md.

Peers: CGAL Mesh_2, which the build makes (cgal_driver); Triangle, if --triangle names its program. Every figure is the median of
--runs runs, the programs taken in turn so that a drift of the machine's speed hits all of them; ratios are of medians.
"""
import argparse
import os
import re
import shutil
import statistics
import sys
import tempfile
import time
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))
from measuring import figures, medians, run, table

MESH_2_20_DEGREES = 0.125  # B = (sine of the angle)^2: 20.7 degrees


class Peers:
    def __init__(self, args):
        self.args = args
        self.bin = Path(args.bin)

    def delref(self, path, angle, area=0, encroachment="circle", queue="bucket", points="off-centre"):
        return figures(run([self.bin / "delref_driver", path, angle, area, encroachment, points, queue])[0])

    def mesh_2(self, path, bound, edge=0):
        return figures(run([self.bin / "cgal_driver", path, bound, edge])[0])

    def triangle(self, path, switches):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(path, Path(folder) / "in.poly")
            text, _ = run([self.args.triangle, switches, "in.poly"], folder)
        quality = re.search(r"Quality milliseconds:\s+(\d+)", text)
        made = re.search(r"Mesh vertices:\s+(\d+)", text)
        given = re.search(r"Input vertices:\s+(\d+)", text)
        return {
            "seconds": int(quality[1]) / 1000,
            "vertices_made": int(made[1]) - int(given[1]),
            "triangles": int(re.search(r"Mesh triangles:\s+(\d+)", text)[1]),
        }


def rate(result):
    return result["vertices_made"] / result["seconds"]


def square(peers, folder):
    path = Path(folder) / "square.poly"
    path.write_text("4 2 0 0\n0 0 0\n1 1 0\n2 1 1\n3 0 1\n4 0\n0 0 1\n1 1 2\n2 2 3\n3 3 0\n0\n")
    rows = []
    for area, edge in ((1.5e-6, 0.00225), (3e-7, 0)):
        calls = {"delref": lambda a=area: peers.delref(path, 20.7, a)}
        if edge:
            calls["CGAL Mesh_2"] = lambda e=edge: peers.mesh_2(path, MESH_2_20_DEGREES, e)
        if peers.args.triangle:
            calls["Triangle"] = lambda a=area: peers.triangle(path, f"-pq20.7a{a:.10f}")
        result = medians(calls, peers.args.runs)
        for name, r in result.items():
            rows.append([f"area {area}" if name != "CGAL Mesh_2" else f"edge {edge}", name, f"{r['triangles']:,.0f}",
                         f"{r['seconds']:.3f}", f"{rate(r):,.0f}", f"{rate(result['delref']) / rate(r):.1f}",
                         f"{r['megabytes'] * 2**20 / r['triangles']:.0f}" if "megabytes" in r else ""])
    return table("Unit square", "",
                 ["bound", "program", "triangles", "seconds", "vertices/s", "delref is times as fast", "bytes a triangle"], rows)


def inputs(peers):
    names = ["naca3", "rand10k", "greece", "canada", "uscounties"]
    return [Path(peers.args.data) / f"{n}.poly" for n in names if (Path(peers.args.data) / f"{n}.poly").exists()]


def refinement(peers):
    rows = []
    for path in inputs(peers):
        calls = {"delref": lambda p=path: peers.delref(p, 20.7), "mesh_2": lambda p=path: peers.mesh_2(p, MESH_2_20_DEGREES)}
        if peers.args.triangle:
            calls["triangle"] = lambda p=path: peers.triangle(p, "-pq20.7D")
        r = medians(calls, peers.args.runs)
        rows.append([path.stem, f"{r['delref']['seconds']:.4f}", f"{r['mesh_2']['seconds']:.4f}",
                     f"{r['mesh_2']['seconds'] / r['delref']['seconds']:.1f}",
                     f"{r['triangle']['seconds']:.3f}" if "triangle" in r else ""])
    return table("Refinement alone, 20.7 degrees, circles, seconds", "",
                 ["input", "delref", "CGAL Mesh_2", "Mesh_2 / delref", "Triangle -D"], rows)


def counts(peers):
    rows = []
    for path in inputs(peers):
        for angle in (20.7, 30, 33):
            row = [path.stem, angle]
            for encroachment, switch in (("circle", "D"), ("lens", "")):
                if angle == 33 and encroachment == "circle":
                    row += ["", ""]
                    continue
                row.append(f"{peers.delref(path, angle, 0, encroachment)['triangles']:,.0f}")
                row.append(f"{peers.triangle(path, f'-pq{angle}{switch}')['triangles']:,.0f}" if peers.args.triangle else "")
            rows.append(row)
    return table("Triangles", "", ["input", "angle", "delref circle", "Triangle -D", "delref lens", "Triangle"], rows)


def queues(peers, folder):
    path = Path(folder) / "square.poly"
    cases = [(path, 20.7, 1.5e-6)] + [(p, 30, 0) for p in inputs(peers)]
    rows = []
    for p, angle, area in cases:
        r = medians({q: lambda q=q: peers.delref(p, angle, area, "circle", q) for q in ("bucket", "lifo", "fifo")}, peers.args.runs)
        rows.append([p.stem, angle] + [f"{r[q]['triangles']:,.0f} in {r[q]['seconds']:.3f} s" for q in r])
    return table("Queue policies of the faces level", "",
                 ["input", "angle", "buckets (default)", "last in first out", "first in first out"], rows)


def whole_program(peers, folder):
    rows = []
    for path in inputs(peers):
        if path.stem != "canada" or not peers.args.triangle or not peers.args.delref:
            continue
        ours, theirs = [], []
        for _ in range(peers.args.runs):
            start = time.perf_counter()
            run([peers.args.delref, "mesh", path, "-o", Path(folder) / "out.node", "--quiet"], accepted=(0, 4))
            ours.append(time.perf_counter() - start)
            shutil.copy(path, Path(folder) / "in.poly")
            start = time.perf_counter()
            run([peers.args.triangle, "-pq20.7DQ", "in.poly"], folder)
            theirs.append(time.perf_counter() - start)
        a, b = statistics.median(ours), statistics.median(theirs)
        rows.append([path.stem, f"{a:.3f}", f"{b:.3f}", f"{a / b:.2f}"])
    return table("Whole program, read to write of .node and .ele, wall seconds", "",
                 ["input", "delref", "Triangle -D", "delref / Triangle"], rows)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--bin", required=True, help="the folder of delref_driver and cgal_driver")
    parser.add_argument("--data", default="", help="a folder with naca3, rand10k, greece, canada, uscounties .poly")
    parser.add_argument("--triangle", help="Triangle's program, built with -ffp-contract=off")
    parser.add_argument("--delref", help="delref's program, for the whole-program figures")
    parser.add_argument("--runs", type=int, default=5)
    args = parser.parse_args()
    if args.triangle:
        args.triangle = os.path.abspath(args.triangle)
    peers = Peers(args)
    with tempfile.TemporaryDirectory() as folder:
        for section in (square(peers, folder), refinement(peers), counts(peers), queues(peers, folder), whole_program(peers, folder)):
            print(section, flush=True)


if __name__ == "__main__":
    main()
