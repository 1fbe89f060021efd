#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Measures planar meshing next to peers in one run, and writes the tables of benchmarks/results/planar.md.

Peers: CGAL Mesh_2, which the build makes (cgal_driver); Triangle, if --triangle names its program. Every figure is the median of
--runs runs, the programs taken in turn so that a drift of the machine's speed hits all of them; ratios are of medians.
"""
import argparse
import os
import re
import resource
import shutil
import statistics
import subprocess
import tempfile
import time
from pathlib import Path

MESH_2_20_DEGREES = 0.125  # B = (sine of the angle)^2: 20.7 degrees


def run(command, cwd=None):
    """Runs a command; its output and its CPU seconds."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run([str(c) for c in command], cwd=cwd, capture_output=True, text=True, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode not in (0, 4):
        raise SystemExit(f"{command}: exit code {done.returncode}\n{done.stdout}{done.stderr}")
    return done.stdout, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def figures(text):
    words = text.split()
    return {key: float(value) for key, value in zip(words[::2], words[1::2]) if value not in ("true", "false")}


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
            text, _ = run([self.args.triangle, switches, "in.poly"], cwd=folder)
        quality = re.search(r"Quality milliseconds:\s+(\d+)", text)
        made = re.search(r"Mesh vertices:\s+(\d+)", text)
        given = re.search(r"Input vertices:\s+(\d+)", text)
        return {
            "seconds": int(quality[1]) / 1000,
            "vertices_made": int(made[1]) - int(given[1]),
            "triangles": int(re.search(r"Mesh triangles:\s+(\d+)", text)[1]),
        }

    def medians(self, calls):
        """The median figures of each of several calls, taken in turn."""
        results = {name: [] for name in calls}
        for _ in range(self.args.runs):
            for name, call in calls.items():
                results[name].append(call())
        return {
            name: {key: statistics.median(r[key] for r in found) for key in found[0]} for name, found in results.items()
        }


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(str(c) for c in row) + " |" for row in rows]) + "\n"


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
        result = peers.medians(calls)
        for name, r in result.items():
            rows.append([f"area {area}" if name != "CGAL Mesh_2" else f"edge {edge}", name, f"{r['triangles']:,.0f}",
                         f"{r['seconds']:.3f}", f"{rate(r):,.0f}", f"{rate(result['delref']) / rate(r):.1f}",
                         f"{r['megabytes'] * 2**20 / r['triangles']:.0f}" if "megabytes" in r else ""])
    return "## Unit square\n\n" + table(
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
        r = peers.medians(calls)
        rows.append([path.stem, f"{r['delref']['seconds']:.4f}", f"{r['mesh_2']['seconds']:.4f}",
                     f"{r['mesh_2']['seconds'] / r['delref']['seconds']:.1f}",
                     f"{r['triangle']['seconds']:.3f}" if "triangle" in r else ""])
    return "## Refinement alone, 20.7 degrees, circles, seconds\n\n" + table(
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
    return "## Triangles\n\n" + table(["input", "angle", "delref circle", "Triangle -D", "delref lens", "Triangle"], rows)


def queues(peers, folder):
    path = Path(folder) / "square.poly"
    cases = [(path, 20.7, 1.5e-6)] + [(p, 30, 0) for p in inputs(peers)]
    rows = []
    for p, angle, area in cases:
        r = peers.medians({q: lambda q=q: peers.delref(p, angle, area, "circle", q) for q in ("bucket", "lifo", "fifo")})
        rows.append([p.stem, angle] + [f"{r[q]['triangles']:,.0f} in {r[q]['seconds']:.3f} s" for q in r])
    return "## Queue policies of the faces level\n\n" + table(["input", "angle", "buckets (default)", "last in first out", "first in first out"], rows)


def whole_program(peers, folder):
    rows = []
    for path in inputs(peers):
        if path.stem != "canada" or not peers.args.triangle or not peers.args.delref:
            continue
        ours, theirs = [], []
        for _ in range(peers.args.runs):
            start = time.perf_counter()
            run([peers.args.delref, "mesh", path, "-o", Path(folder) / "out.node", "--quiet"])
            ours.append(time.perf_counter() - start)
            shutil.copy(path, Path(folder) / "in.poly")
            start = time.perf_counter()
            run([peers.args.triangle, "-pq20.7DQ", "in.poly"], cwd=folder)
            theirs.append(time.perf_counter() - start)
        a, b = statistics.median(ours), statistics.median(theirs)
        rows.append([path.stem, f"{a:.3f}", f"{b:.3f}", f"{a / b:.2f}"])
    return "## Whole program, read to write of .node and .ele, wall seconds\n\n" + table(
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
