# SPDX-License-Identifier: GPL-3.0-or-later
#
# What is written: the same bytes each time, whole files or none, and meshes that `verify` and `info` read.
from support import *

FORMATS = ["vtu", "msh", "mesh", "off", "svg", "node"]


class Outputs(ProgramTest):
    def mesh_twice(self, *options):
        files = []
        for run in ("first", "second"):
            os.mkdir(self.path(run))
            self.write(run + "/in.poly", labelled)
            outputs = [word for format in FORMATS for word in ("-o", "m." + format)]
            process = subprocess.run([PROGRAM, "mesh", "in.poly", *outputs, "--report", "m.json", *options], cwd=self.path(run),
                                     capture_output=True, text=True, timeout=240)
            self.assertEqual(process.returncode, OK, process.stderr)
            names = sorted(os.listdir(self.path(run)))
            files.append({name: self.read(f"{run}/{name}") for name in names})
            shutil.move(self.path(run), self.path(run + "_done"))
        return files

    def test_two_runs_write_the_same_bytes_in_every_format(self):
        first, second = self.mesh_twice("--max-area", "1e-3")
        written = ["m." + extension for extension in ("edge", "ele", "json", "mesh", "msh", "node", "off", "poly", "svg", "vtu")]
        self.assertEqual(sorted(first), ["in.poly", *written])
        reports = [json.loads(files.pop("m.json")) for files in (first, second)]
        self.assertEqual(first, second)
        for report in reports:
            self.assertGreater(len(report.pop("times")), 0)
        self.assertEqual(*reports)

    def test_a_report_is_what_was_asked_for_and_what_came_out(self):
        report = self.mesh(labelled, "--max-area", "1e-2")
        self.assertEqual(report["options"]["max_area"], 1e-2)
        self.assertEqual(report["input_file"], "in.poly")
        self.assertEqual(report["output_files"], ["out.vtu"])
        self.assertEqual(report["outcome"]["status"], "every criterion met")
        self.assertEqual(sum(report["quality"]["smallest_angles"]), report["mesh"]["triangles"])
        inserted = sum(level["inserted"] for level in report["outcome"]["levels"])
        self.assertGreaterEqual(inserted, report["mesh"]["vertices"] - report["input"]["vertices"])

    def test_a_file_that_was_there_is_replaced(self):
        self.write("out.vtu", "old")
        self.mesh(square)
        self.assertNotEqual(self.read("out.vtu"), b"old")

    def test_a_file_stays_as_it_was_when_the_input_is_refused(self):
        self.write("in.poly", crossing)
        self.write("out.vtu", "old")
        self.run_program("mesh", "in.poly", "-o", "out.vtu", expect=INVALID)
        self.assertEqual(self.read("out.vtu"), b"old")

    @unittest.skipUnless(os.path.exists("/dev/full"), "needs /dev/full")
    def test_a_disk_that_is_full_is_told(self):
        os.symlink("/dev/full", self.path("full.vtu"))
        self.write("in.poly", square)
        run = self.run_program("mesh", "in.poly", "-o", "full.vtu", "-o", "good.vtu", "--max-area", "1e-3", expect=INTERNAL)
        self.assertIn("full.vtu", run.err)
        self.assertTrue(self.exists("good.vtu"))

    def test_info_shows_quality_regions_and_markers_of_each_format_that_is_read(self):
        self.write("in.poly", labelled)
        self.run_program("mesh", "in.poly", "-o", "m.vtu", "-o", "m.msh", "-o", "m.node")
        tables = []
        for name in ("m.vtu", "m.msh", "m.ele", "m.node"):
            out = self.run_program("info", name).out
            for words in ["triangles ", "Smallest angle of each triangle", "All angles", "Regions:", "Subsegments"]:
                self.assertIn(words, out)
            tables.append(out[out.index("Regions:"):out.index("Vertices:")])
        self.assertEqual(tables, tables[:1] * 4)
        self.assertRegex(self.run_program("info", "m.vtu").out, r"(?m)^ +input +10$")

    def test_info_of_what_is_no_mesh_is_refused(self):
        self.write("a.vtu", b"\x00\x01\x02")
        self.assertIn("a.vtu", self.run_program("info", "a.vtu", expect=INVALID).err)
        self.assertIn("no such file", self.run_program("info", "b.vtu", expect=INVALID).err)


if __name__ == "__main__":
    main()
