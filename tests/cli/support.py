# SPDX-License-Identifier: GPL-3.0-or-later
#
# What the tests of the program share: running it, and making inputs.
import json
import math
import os
import pty
import random
import re
import select
import shutil
import signal
import subprocess
import tempfile
import time
import unittest

PROGRAM = os.environ["DELREF_PROGRAM"]
OK, INTERNAL, USAGE, INVALID, UNMET, INTERRUPTED, VERIFICATION_FAILED = range(7)


def poly(points, segments, holes=(), regions=(), markers=None, first=0):
    """The text of a .poly file."""
    lines = [f"{len(points)} 2 0 0"]
    lines += [f"{i + first} {p[0]!r} {p[1]!r}" for i, p in enumerate(points)]
    lines += [f"{len(segments)} {1 if markers else 0}"]
    lines += [f"{i + first} {a + first} {b + first}" + (f" {markers[i]}" if markers else "") for i, (a, b) in enumerate(segments)]
    lines += [f"{len(holes)}"] + [f"{i + first} {h[0]!r} {h[1]!r}" for i, h in enumerate(holes)]
    if regions:
        lines += [f"{len(regions)}"] + [f"{i + first} {r[0]!r} {r[1]!r} {r[2]} {r[3]!r}" for i, r in enumerate(regions)]
    return "\n".join(lines) + "\n"


def ring(count, begin=0):
    """The segments of a closed chain of vertices."""
    return [(begin + i, begin + (i + 1) % count) for i in range(count)]


SQUARE = [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)]
square = poly(SQUARE, ring(4))
crossing = poly(SQUARE, ring(4) + [(0, 2), (1, 3)])
needle = poly([(0.0, 0.0), (1.0, 0.0), (1.0, 0.05)], ring(3))
# Two regions beside each other, one with an area bound; a hole; markers; numbered from 1.
labelled = poly(
    SQUARE + [(0.5, 0.0), (0.5, 1.0), (0.7, 0.4), (0.8, 0.4), (0.8, 0.6), (0.7, 0.6)],
    [(0, 4), (4, 1), (1, 2), (2, 5), (5, 3), (3, 0), (4, 5)] + ring(4, 6),
    holes=[(0.75, 0.5)], regions=[(0.1, 0.1, 7, 0.01), (0.9, 0.1, 9, -1)],
    markers=[1, 1, 2, 3, 3, 4, 5, 6, 6, 6, 6], first=1)


def blob(count, roughness=0.02, seed=1):
    """A ring of vertices with blunt corners."""
    numbers = random.Random(seed)
    points = []
    for i in range(count):
        angle, radius = 2 * math.pi * i / count, 1 + roughness * (numbers.random() - 0.5)
        points.append((radius * math.cos(angle), radius * math.sin(angle)))
    return poly(points, ring(count))


BOX = [(x, y, z) for z in (0.0, 1.0) for y in (0.0, 1.0) for x in (0.0, 1.0)]
BOX_SIDES = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]


def scaled(points, factor, shift=(0.0, 0.0, 0.0)):
    """The same points larger by a factor and then moved."""
    return [tuple(factor * c + s for c, s in zip(p, shift)) for p in points]


def off(points, faces):
    """The text of an .off file."""
    lines = ["OFF", f"{len(points)} {len(faces)} 0"]
    lines += [" ".join(repr(c) for c in p) for p in points]
    return "\n".join(lines + [" ".join(str(i) for i in (len(f), *f)) for f in faces]) + "\n"


def poly_3(points, facets, holes=(), regions=()):
    """The text of a .poly file of space, numbered from 1, with facet i having the marker 10 + i."""
    lines = [f"{len(points)} 3 0 0"] + [f"{i + 1} {p[0]!r} {p[1]!r} {p[2]!r}" for i, p in enumerate(points)]
    lines += [f"{len(facets)} 1"]
    for i, facet in enumerate(facets):
        lines += [f"1 0 {10 + i}", " ".join(str(v) for v in (len(facet), *(v + 1 for v in facet)))]
    lines += [f"{len(holes)}"] + [f"{i + 1} {h[0]!r} {h[1]!r} {h[2]!r}" for i, h in enumerate(holes)]
    lines += [f"{len(regions)}"] + [f"{i + 1} {r[0]!r} {r[1]!r} {r[2]!r} {r[3]} {r[4]!r}" for i, r in enumerate(regions)]
    return "\n".join(lines) + "\n"


box = off(BOX, BOX_SIDES)
triangulated_box = off(BOX, [side for a, b, c, d in BOX_SIDES for side in ((a, b, c), (a, c, d))])
open_box = off(BOX, BOX_SIDES[1:])
# A box in a box: two regions, the inner one with a volume bound.
nested_boxes = poly_3(BOX + scaled(BOX, 0.5, (0.25, 0.25, 0.25)), BOX_SIDES + [tuple(v + 8 for v in side) for side in BOX_SIDES],
                      regions=[(0.1, 0.1, 0.1, 7, -1), (0.5, 0.5, 0.5, 9, 0.001)])


class Run:
    """What a finished run of the program gave."""

    def __init__(self, code, out, err):
        self.code, self.out, self.err = code, out, err

    def __str__(self):
        return f"exit code {self.code}\n--- stdout\n{self.out}\n--- stderr\n{self.err}"


class ProgramTest(unittest.TestCase):
    """A test in a folder of its own, which is the working directory."""

    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="delref_cli_")
        self.addCleanup(shutil.rmtree, self.folder, ignore_errors=True)

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "wb") as file:
            file.write(text if isinstance(text, bytes) else text.encode())
        return name

    def read(self, name):
        with open(self.path(name), "rb") as file:
            return file.read()

    def exists(self, name):
        return os.path.exists(self.path(name))

    def start(self, *arguments, **options):
        return subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, stdin=subprocess.DEVNULL, **options)

    def run_program(self, *arguments, expect=OK):
        process = self.start(*arguments, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        out, err = process.communicate(timeout=240)
        run = Run(process.returncode, out, err)
        self.assertEqual(run.code, expect, f"delref {' '.join(arguments)}: {run}")
        self.assertEqual([name for name in os.listdir(self.folder) if name.endswith(".partial")], [])
        return run

    def mesh(self, text, *options, expect=OK, name="in.poly"):
        """Meshes an input, verifies the mesh against its report, and gives the report."""
        self.write(name, text)
        self.run_program("mesh", name, "-o", "out.vtu", "--report", "out.json", *options, expect=expect)
        self.run_program("verify", name, "out.vtu", "--report", "out.json")
        return json.loads(self.read("out.json"))

    def refused(self, text, *words, options=(), name="in.poly"):
        """Asserts that an input is refused with words, and that nothing is written."""
        self.write(name, text)
        run = self.run_program("mesh", name, "-o", "out.vtu", *options, expect=INVALID)
        self.assertEqual(run.out, "")
        for word in words:
            self.assertIn(word, run.err)
        self.assertFalse(self.exists("out.vtu"))
        return run

    def on_terminal(self, *arguments, send=None, when=None, times=1):
        """Runs with standard error on a terminal; sends a signal once `when` is seen there. Gives the run."""
        master, slave = pty.openpty()
        environment = dict(os.environ, TERM="xterm")
        process = self.start(*arguments, stdout=subprocess.PIPE, stderr=slave, text=True, env=environment)
        os.close(slave)
        seen, deadline, sent_at = "", time.monotonic() + 240, None
        while time.monotonic() < deadline:
            if select.select([master], [], [], 0.05)[0]:
                try:
                    got = os.read(master, 65536).decode()
                except OSError:  # the other end is closed
                    got = ""
                if not got:
                    break
                seen += got
            if send and re.search(when, seen):
                process.send_signal(send)
                times -= 1
                send = send if times else None
                sent_at = time.monotonic()
        out, _ = process.communicate(timeout=240)
        os.close(master)
        run = Run(process.returncode, out, seen)
        run.seconds_after_signal = time.monotonic() - sent_at if sent_at else None
        return run


def main():
    unittest.main(verbosity=2)
