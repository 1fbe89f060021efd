# SPDX-License-Identifier: GPL-3.0-or-later
#
# Each option of `delref mesh` does what its help says. `self.mesh` verifies every mesh against its report.
from support import *

# Vertices that no segment touches, close to the lower side.
near_boundary = poly(SQUARE + [(0.1 * i, 0.03) for i in range(1, 10)], ring(4))


class Options(ProgramTest):
    def triangles(self, *arguments, **options):
        return self.mesh(*arguments, **options)["mesh"]["triangles"]

    def test_every_triangle_has_the_angle_asked_for(self):
        for degrees in (0, 15, 20.7, 28, 30):
            quality = self.mesh(blob(60), "--min-angle", str(degrees))["quality"]
            self.assertGreaterEqual(quality["smallest_angle_degrees"], degrees - 1e-6)

    def test_33_degrees_are_reached_with_lenses(self):
        report = self.mesh(blob(80), "--min-angle", "33", "--encroachment", "lens")
        self.assertEqual(report["outcome"]["unmet_count"], 0)
        self.assertGreaterEqual(report["quality"]["smallest_angle_degrees"], 33 - 1e-6)

    def test_no_triangle_is_larger_than_the_area_asked_for(self):
        self.assertLessEqual(self.mesh(square, "--max-area", "1e-3")["quality"]["largest_area"], 1e-3)

    def test_no_edge_is_longer_than_asked_for(self):
        self.assertLessEqual(self.mesh(square, "--max-edge", "0.07")["quality"]["longest_edge"], 0.07 * (1 + 1e-9))

    def test_regions_have_their_own_area_bound_and_label(self):
        report = self.mesh(labelled)
        self.assertEqual(report["input"], {"vertices": 10, "segments": 11, "holes": 1, "regions": 2})
        text = self.run_program("info", "out.vtu").out
        self.assertRegex(text, r"(?m)^ +7 +\d+ +0\.5$")
        self.assertRegex(text, r"(?m)^ +9 +\d+ +0\.48$")

    def test_lenses_need_fewer_triangles_than_circles(self):
        self.assertLess(self.triangles(near_boundary, "--encroachment", "lens"),
                        self.triangles(near_boundary, "--encroachment", "circle"))

    def test_off_centres_need_fewer_triangles_than_circumcentres(self):
        text = blob(200, 0.04)
        self.assertLess(self.triangles(text, "--points", "off-centre"), self.triangles(text, "--points", "circumcentre"))

    def test_a_kept_boundary_has_no_new_vertex(self):
        self.assertGreater(self.mesh(near_boundary)["mesh"]["segments"], 4)
        self.write("in.poly", near_boundary)
        run = self.run_program("mesh", "in.poly", "-o", "out.vtu", "--report", "out.json", "--keep-boundary", expect=UNMET)
        self.assertIn("--keep-boundary", run.out)
        self.assertEqual(json.loads(self.read("out.json"))["mesh"]["segments"], 4)
        self.run_program("verify", "in.poly", "out.vtu", "--report", "out.json")

    def test_crossings_are_split(self):
        self.assertEqual(self.mesh(crossing, "--split-crossings")["mesh"]["vertices"], 5)
        self.run_program("verify", "in.poly", "out.vtu", "--split-crossings")
        self.run_program("verify", "in.poly", "out.vtu", expect=VERIFICATION_FAILED)

    def test_near_vertices_are_merged(self):
        text = poly(SQUARE + [(1.0, 1e-7)], [(0, 1), (4, 2), (2, 3), (3, 0)])
        self.refused(text)
        self.assertEqual(self.mesh(text, "--merge-tolerance", "1e-6")["mesh"]["vertices"], 4)
        self.run_program("verify", "in.poly", "out.vtu", "--merge-tolerance", "1e-6")

    def test_a_limit_of_vertices_stops_with_a_valid_mesh(self):
        report = self.mesh(square, "--max-area", "1e-5", "--max-vertices", "1e3", expect=UNMET)
        self.assertLessEqual(report["mesh"]["vertices"], 1000)
        self.assertEqual(report["outcome"]["stopped_by"], "vertices")
        self.assertGreater(report["outcome"]["unmet_count"], 0)

    def test_a_time_limit_stops_with_a_valid_mesh(self):
        begin = time.monotonic()
        report = self.mesh(square, "--max-area", "1e-9", "--time-limit", "0.2", expect=UNMET)
        self.assertEqual(report["outcome"]["stopped_by"], "time")
        self.assertLess(report["times"]["meshing_seconds"], 2)
        self.assertLess(time.monotonic() - begin, 60)

    def test_a_time_limit_holds_for_the_whole_program(self):
        self.write("in.poly", square)
        for output in ["out.node", "out.vtu"]:
            begin = time.monotonic()
            self.run_program("mesh", "in.poly", "-o", output, "--max-area", "1e-9", "--time-limit", "3", expect=UNMET)
            self.assertLess(time.monotonic() - begin, 4.5)  # on a busy machine; 3.5 is promised

    def test_a_time_limit_before_there_is_a_mesh_writes_nothing_and_says_so(self):
        self.write("in.poly", square)
        run = self.run_program("mesh", "in.poly", "-o", "out.vtu", "--time-limit", "0", expect=UNMET)
        self.assertIn("nothing was written", run.err)
        self.assertFalse(self.exists("out.vtu"))

    def test_a_smallest_edge_leaves_smaller_ones_alone_and_tells(self):
        report = self.mesh(square, "--max-edge", "0.01", "--smallest-edge", "0.1", expect=UNMET)
        self.assertEqual({group["reason"] for group in report["outcome"]["unmet"]}, {"size floor"})
        self.assertLess(report["mesh"]["triangles"], 2000)

    def test_small_input_angles_are_told_and_strictness_makes_them_count(self):
        self.write("in.poly", needle)
        run = self.run_program("mesh", "in.poly", "-o", "out.vtu")
        self.assertIn("small angle", run.out)
        self.run_program("mesh", "in.poly", "-o", "out.vtu", "--strict", expect=UNMET)
        self.mesh(square, "--strict")

    def test_quiet_prints_nothing_when_all_is_met_and_else_what_is_not(self):
        self.write("in.poly", square)
        run = self.run_program("mesh", "in.poly", "-o", "out.vtu", "--quiet")
        self.assertEqual((run.out, run.err), ("", ""))
        self.write("in.poly", needle)
        run = self.run_program("mesh", "in.poly", "-o", "out.vtu", "--quiet")
        self.assertEqual(run.out, "")
        self.assertIn("small angle", run.err)

    def test_the_summary_names_the_files_written(self):
        self.write("in.poly", square)
        out = self.run_program("mesh", "in.poly", "-o", "a.node", "-o", "b.svg", "--report", "c.json").out
        for name in ["a.node", "a.ele", "a.edge", "a.poly", "b.svg", "c.json"]:
            self.assertIn(name, out)
            self.assertTrue(self.exists(name))
        self.assertIn("Every criterion is met.", out)

    def test_the_colours_of_a_picture_can_tell_regions(self):
        self.write("in.poly", labelled)
        self.run_program("mesh", "in.poly", "-o", "a.svg")
        self.run_program("mesh", "in.poly", "-o", "b.svg", "--svg-colour", "region")
        self.assertNotEqual(self.read("a.svg"), self.read("b.svg"))


class SizePoints(ProgramTest):
    arguments = ["mesh", "in.poly", "-o", "out.vtu", "--size-points", "sizes.txt"]

    def test_edges_are_no_longer_than_the_size_points_say(self):
        self.write("sizes.txt", "# x y size\n\n0 0 0.01  # the corner\n1\t1\t0.5\r\n")
        gentle = self.mesh(square, "--size-points", "sizes.txt", "--gradation", "0.1")
        default = self.mesh(square, "--size-points", "sizes.txt")
        abrupt = self.mesh(square, "--size-points", "sizes.txt", "--gradation", "1")
        plain = self.mesh(square)
        counts = [report["mesh"]["triangles"] for report in (gentle, default, abrupt, plain)]
        self.assertEqual(counts, sorted(counts, reverse=True))
        self.assertEqual(len(set(counts)), 4)
        self.assertLessEqual(gentle["quality"]["longest_edge"], 0.01 + 0.1 * 2**0.5)
        self.assertEqual(default["options"]["gradation"], 0.3)

    def test_a_mesh_can_be_verified_without_a_report(self):
        self.write("sizes.txt", "0 0 0.05\n")
        self.mesh(square, "--size-points", "sizes.txt", "--gradation", "0.2")
        promise = ["verify", "in.poly", "out.vtu", "--size-points", "sizes.txt", "--gradation"]
        self.run_program(*promise, "0.2")
        self.run_program(*promise, "0.01", expect=VERIFICATION_FAILED)

    def test_a_line_that_is_wrong_is_named(self):
        self.write("in.poly", square)
        complaints = {"1 2": "fewer", "1 2 x": '"x"', "1 2 3 4": '"4"', "1 2 0": "greater than 0", "1 2 -1": "greater than 0",
                      "1 2 nan": "greater than 0", "1 2 inf": "greater than 0", "nan 2 1": "1e150", "1e200 2 1": "1e150"}
        for line, word in complaints.items():
            with self.subTest(line=line):
                self.write("sizes.txt", "# sizes\n0 0 1\n" + line + "\n")
                run = self.run_program(*self.arguments, expect=INVALID)
                self.assertIn("sizes.txt, line 3", run.err)
                self.assertIn(word, run.err)

    def test_a_file_without_points_or_no_file_is_told(self):
        self.write("in.poly", square)
        self.assertIn("sizes.txt: there is no such file", self.run_program(*self.arguments, expect=INVALID).err)
        self.write("sizes.txt", "# nothing\n")
        self.assertIn("sizes.txt: has no size points", self.run_program(*self.arguments, expect=INVALID).err)


if __name__ == "__main__":
    main()
