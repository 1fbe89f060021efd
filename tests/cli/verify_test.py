# SPDX-License-Identifier: GPL-3.0-or-later
#
# `delref verify` accepts what was promised and nothing else.
from support import *


class Verify(ProgramTest):
    def setUp(self):
        super().setUp()
        self.write("in.poly", labelled)
        outputs = ["-o", "m.vtu", "-o", "m.msh", "-o", "m.node", "--report", "m.json"]
        self.run_program("mesh", "in.poly", *outputs, "--max-area", "5e-3")

    def change_line(self, file, matching, change):
        """Changes the fields of the first line whose fields match."""
        lines = self.read(file).decode().split("\n")
        for i, line in enumerate(lines[1:], 1):
            if matching(line.split()):
                lines[i] = " ".join(change(line.split()))
                self.write(file, "\n".join(lines))
                return
        self.fail("no line matches")

    def fails(self, *words):
        run = self.run_program("verify", "in.poly", "m.node", "--max-area", "5e-3", expect=VERIFICATION_FAILED)
        self.assertIn("FAILED", run.out)
        self.assertIn("NOT what was promised", run.out)
        for word in words:
            self.assertIn(word, run.out)

    def test_the_mesh_is_accepted_in_each_format_that_is_read(self):
        for name in ("m.vtu", "m.msh", "m.node", "m.ele"):
            self.run_program("verify", "in.poly", name, "--report", "m.json")
            self.run_program("verify", "in.poly", name, "--max-area", "5e-3")

    def test_a_larger_promise_than_was_kept_fails(self):
        for promise in (["--min-angle", "35"], ["--max-area", "1e-4"], ["--max-edge", "0.01"]):
            self.run_program("verify", "in.poly", "m.vtu", *promise, expect=VERIFICATION_FAILED)
        self.run_program("verify", "in.poly", "m.vtu", "--min-angle", "0")

    def test_a_triangle_that_is_missing_is_found(self):
        lines = self.read("m.ele").decode().splitlines()
        header = lines[0].split()
        header[0] = str(int(header[0]) - 1)
        self.write("m.ele", "\n".join([" ".join(header)] + lines[1:-1]) + "\n")
        self.fails()

    def test_a_triangle_that_is_turned_over_is_found(self):
        self.change_line("m.ele", lambda f: f[:1] == ["3"], lambda f: [f[0], f[2], f[1], *f[3:]])
        self.fails("clockwise")

    def test_a_vertex_that_was_moved_is_found(self):
        inside = lambda f: len(f) > 3 and f[3] == "0" and 0.1 < float(f[1]) < 0.4 and 0.1 < float(f[2]) < 0.9
        self.change_line("m.node", inside, lambda f: [f[0], repr(float(f[1]) + 0.03), *f[2:]])
        self.fails()

    def test_a_region_label_that_was_changed_is_found(self):
        self.change_line("m.ele", lambda f: f[-1:] == ["7"], lambda f: f[:-1] + ["9"])
        self.fails("labels")

    def test_a_marker_that_was_changed_is_found(self):
        self.change_line("m.poly", lambda f: f[-1:] == ["5"], lambda f: f[:-1] + ["4"])
        self.fails("markers")

    def test_a_vertex_on_a_boundary_that_was_to_be_kept_is_found(self):
        self.run_program("verify", "in.poly", "m.vtu", "--max-area", "5e-3")
        run = self.run_program("verify", "in.poly", "m.vtu", "--max-area", "5e-3", "--keep-boundary", expect=VERIFICATION_FAILED)
        self.assertIn("inserted on the boundary", run.out)

    def test_another_input_is_found(self):
        self.write("other.poly", square)
        self.run_program("verify", "other.poly", "m.vtu", expect=VERIFICATION_FAILED)

    def test_a_report_that_lists_nothing_excuses_nothing(self):
        impossible = ["--max-edge", "0.01", "--smallest-edge", "0.05"]
        self.run_program("mesh", "in.poly", "-o", "m.vtu", "--report", "m.json", *impossible, expect=UNMET)
        self.run_program("verify", "in.poly", "m.vtu", "--report", "m.json")
        report = json.loads(self.read("m.json"))
        report["outcome"]["unmet"] = []
        self.write("m.json", json.dumps(report))
        self.run_program("verify", "in.poly", "m.vtu", "--report", "m.json", expect=VERIFICATION_FAILED)

    def test_formats_that_carry_too_little_are_refused_in_words(self):
        for name in ("m.svg", "m.off", "m.mesh"):
            self.write(name, "")
            run = self.run_program("verify", "in.poly", name, expect=INVALID)
            self.assertIn(".vtu", run.err)

    def test_files_that_cannot_be_read_are_told(self):
        self.write("broken.vtu", self.read("m.vtu")[:1000])
        self.write("broken.json", "{")
        self.assertIn("broken.vtu", self.run_program("verify", "in.poly", "broken.vtu", expect=INVALID).err)
        run = self.run_program("verify", "in.poly", "m.vtu", "--report", "broken.json", expect=INVALID)
        self.assertIn("broken.json", run.err)
        self.assertIn("none.poly", self.run_program("verify", "none.poly", "m.vtu", expect=INVALID).err)

    def test_size_points_beside_the_report_are_found_from_another_folder(self):
        self.write("sizes.txt", "0 0 0.05\n")
        self.run_program("mesh", "in.poly", "-o", "m.vtu", "--report", "m.json", "--size-points", "sizes.txt")
        os.mkdir(self.path("elsewhere"))
        run = subprocess.run([PROGRAM, "verify", "../in.poly", "../m.vtu", "--report", "../m.json"], cwd=self.path("elsewhere"),
                             capture_output=True, text=True, timeout=240)
        self.assertEqual(run.returncode, OK, run.stdout + run.stderr)


if __name__ == "__main__":
    main()
