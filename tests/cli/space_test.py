# SPDX-License-Identifier: GPL-3.0-or-later
#
# Domains of space: each option does what its help says, and a run has the manners of one in the plane. `self.mesh` verifies every
# mesh against its report.
import signal

from support import *


class SpaceTest(ProgramTest):
    def mesh(self, text, *options, name="in.off", **others):
        return super().mesh(text, *options, name=name, **others)

    def refused(self, text, *words, name="in.off", **others):
        return super().refused(text, *words, name=name, **others)

    def tetrahedra(self, *arguments, **others):
        return self.mesh(*arguments, **others)["mesh"]["tetrahedra"]


class Options(SpaceTest):
    def test_a_closed_surface_is_filled(self):
        report = self.mesh(box)
        self.assertEqual(report["dimension"], 3)
        self.assertEqual(report["input"], {"vertices": 8, "segments": 0, "facets": 6, "holes": 0, "regions": 0})
        self.assertEqual([level["name"] for level in report["outcome"]["levels"]], ["edges", "facets", "tetrahedra"])
        self.assertTrue(report["outcome"]["conforms"])
        self.assertAlmostEqual(report["quality"]["total_volume"], 1, 12)
        self.assertLessEqual(report["quality"]["worst_radius_edge"], 2)
        self.assertEqual(report["small_input_angles"]["count"], 0)

    def test_radius_edge_ratios_are_within_the_bound_asked_for(self):
        for bound in (2, 1.414, 1.2):
            quality = self.mesh(box, "--radius-edge", str(bound), "--max-volume", "1e-3")["quality"]
            self.assertLessEqual(quality["worst_radius_edge"], bound * (1 + 1e-9))

    def test_no_tetrahedron_is_larger_than_the_volume_asked_for(self):
        self.assertLessEqual(self.mesh(box, "--max-volume", "1e-3")["quality"]["largest_volume"], 1e-3)

    def test_no_tetrahedron_has_a_larger_circumradius_than_asked_for(self):
        self.assertLessEqual(self.mesh(box, "--cell-size", "0.1")["quality"]["longest_edge"], 0.2)
        self.run_program("verify", "in.off", "out.vtu", "--cell-size", "0.1")
        self.run_program("verify", "in.off", "out.vtu", "--cell-size", "0.05", expect=VERIFICATION_FAILED)

    def test_sizes_at_points_are_kept(self):
        self.write("sizes.txt", "# x y z size\n0 0 0 0.02\n1 1 1 0.5\n")
        fine = self.tetrahedra(box, "--size-points", "sizes.txt", "--gradation", "0.2")
        coarse = self.tetrahedra(box, "--size-points", "sizes.txt", "--gradation", "0.4")
        self.assertLess(coarse, fine)
        self.assertLess(self.tetrahedra(box), coarse)
        self.write("sizes.txt", "0 0 0.02\n")
        run = self.run_program("mesh", "in.off", "-o", "out.vtu", "--size-points", "sizes.txt", expect=INVALID)
        self.assertIn("sizes.txt, line 1: has fewer than four numbers; write `x y z size`", run.err)

    def test_coplanar_facets_are_joined(self):
        apart = self.mesh(triangulated_box)["mesh"]["segments"]
        self.assertLess(self.mesh(triangulated_box, "--join-coplanar", "0.01")["mesh"]["segments"], apart)
        self.run_program("verify", "in.off", "out.vtu", "--join-coplanar", "0.01")
        self.run_program("verify", "in.off", "out.vtu", expect=VERIFICATION_FAILED)

    def test_facets_that_are_not_flat_are_taken_within_a_tolerance(self):
        bent = off([(0.0, 0.0, 1e-3)] + BOX[1:], BOX_SIDES)
        self.refused(bent, "not planar")
        self.mesh(bent, "--planarity-tolerance", "0.01")

    def test_near_vertices_are_merged(self):
        sides = [tuple(8 if v == 7 and i == 1 else v for v in side) for i, side in enumerate(BOX_SIDES)]
        split = off(BOX + [(1.0, 1.0, 1.0 + 1e-9)], sides)
        self.refused(split)
        self.assertEqual(self.mesh(split, "--merge-tolerance", "1e-6")["outcome"]["unmet_count"], 0)

    def test_regions_have_their_label_and_volume_bound(self):
        report = self.mesh(nested_boxes, name="in.poly")
        self.assertEqual(report["input"], {"vertices": 16, "segments": 0, "facets": 12, "holes": 0, "regions": 2})
        regions = {region["label"]: region for region in report["quality"]["regions"]}
        self.assertEqual(sorted(regions), [7, 9])
        self.assertAlmostEqual(regions[7]["volume"], 0.875, 12)
        self.assertAlmostEqual(regions[9]["volume"], 0.125, 12)
        self.assertGreaterEqual(regions[9]["tetrahedra"], 125)
        table = r"(?m)^ +7 +[\d,]+ +0\.875\n +9 +[\d,]+ +0\.125$"
        self.assertRegex(self.run_program("mesh", "in.poly", "-o", "out.vtu", "--regions").out, table)
        self.assertRegex(self.run_program("info", "out.vtu").out, table)

    def test_small_input_angles_are_told_with_their_place(self):
        wedge = off([(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (1.0, 0.3, 0.0), (0.0, 0.0, 1.0), (1.0, 0.0, 1.0), (1.0, 0.3, 1.0)],
                    [(0, 2, 1), (3, 4, 5), (0, 1, 4, 3), (1, 2, 5, 4), (2, 0, 3, 5)])
        report = self.mesh(wedge)
        angles = report["small_input_angles"]
        self.assertGreater(angles["count"], 0)
        self.assertAlmostEqual(angles["smallest"][0]["degrees"], math.degrees(math.atan(0.3)), 9)
        self.assertEqual(len(angles["smallest"][0]["place"]), 3)
        self.assertIn("under 90 degrees; the smallest is 16.7", self.run_program("mesh", "in.off", "-o", "out.vtu").out)

    def test_the_mesh_is_read_back_from_every_format(self):
        self.mesh(nested_boxes, name="in.poly")
        outputs = ["a.vtu", "a.msh", "a.mesh", "a.node"]
        out = self.run_program("mesh", "in.poly", *(word for name in outputs for word in ("-o", name))).out
        for name in [*outputs, "a.ele", "a.face", "a.edge"]:
            self.assertIn(name, out)
            self.assertTrue(self.exists(name))
        for name in outputs:
            self.run_program("verify", "in.poly", name)
            text = self.run_program("info", name).out
            for words in ["tetrahedra ", "Radius-edge ratio", "Triangles on facets or surfaces:", "slivers"]:
                self.assertIn(words, text)

    def test_two_runs_write_the_same_bytes(self):
        self.write("in.poly", nested_boxes)
        for name in ("a", "b"):
            self.run_program("mesh", "in.poly", "-o", name + ".vtu", "-o", name + ".msh", "-o", name + ".mesh", "-o", name + ".node",
                             "--report", name + ".json")
        for extension in (".vtu", ".msh", ".mesh", ".node", ".ele", ".face", ".edge"):
            self.assertEqual(self.read("a" + extension).replace(b"a.", b"b."), self.read("b" + extension))
        reports = [self.read(name + ".json").decode().split('"times"')[0] for name in ("a", "b")]
        self.assertEqual(reports[0].replace('"a.', '"b.'), reports[1])


class Refusals(SpaceTest):
    def test_what_encloses_nothing_or_crosses_is_refused_with_places(self):
        self.refused(open_box, "enclose no volume", "4 segments")
        self.refused(off(BOX + scaled(BOX, 1.0, (0.5, 0.5, 0.5)), BOX_SIDES + [tuple(v + 8 for v in s) for s in BOX_SIDES]), "cross")
        self.refused("OFF\n0 0 0\n")
        self.refused(off(BOX, BOX_SIDES).replace("1.0 1.0 1.0", "1.0 nan 1.0"), "nan")

    def test_options_of_the_plane_are_refused_for_space(self):
        self.write("in.off", box)
        for option in ["--min-angle=20", "--max-area=1", "--max-edge=1", "--encroachment=lens", "--points=off-centre", "--keep-boundary",
                       "--split-crossings", "--svg-colour=region"]:
            run = self.run_program("mesh", "in.off", "-o", "out.vtu", option, expect=USAGE)
            self.assertIn(option.split("=")[0] + " is for domains of the plane (2D), but in.off lies in space (3D)", run.err)
            self.assertFalse(self.exists("out.vtu"))
        run = self.run_program("verify", "in.off", "out.vtu", "--max-area", "1", "--max-edge", "1", expect=USAGE)
        self.assertIn("--max-area and --max-edge are for domains of the plane", run.err)

    def test_options_of_space_are_refused_for_the_plane(self):
        self.write("in.poly", square)
        for option in ["--radius-edge=2", "--max-volume=1", "--cell-size=1", "--join-coplanar=1", "--planarity-tolerance=1e-3"]:
            run = self.run_program("mesh", "in.poly", "-o", "out.vtu", option, expect=USAGE)
            self.assertIn(option.split("=")[0] + " is for domains of space (3D), but in.poly lies in the plane (2D)", run.err)

    def test_formats_of_the_plane_are_refused_for_space(self):
        self.write("in.off", box)
        for name in ("out.off",):
            self.assertIn(".vtu", self.run_program("mesh", "in.off", "-o", name, expect=USAGE).err)

    def test_a_report_of_the_plane_promises_nothing_in_space(self):
        self.write("in.poly", square)
        self.run_program("mesh", "in.poly", "-o", "out.vtu", "--report", "plane.json")
        self.mesh(box)
        run = self.run_program("verify", "in.off", "out.vtu", "--report", "plane.json", expect=INVALID)
        self.assertIn("plane.json: is the report of a run in the plane", run.err)

    def test_a_mesh_of_another_domain_is_not_verified(self):
        self.mesh(box)
        self.write("other.off", off(scaled(BOX, 2.0), BOX_SIDES))
        self.run_program("verify", "other.off", "out.vtu", expect=VERIFICATION_FAILED)


class Budgets(SpaceTest):
    long = ["mesh", "in.off", "-o", "out.vtu", "--report", "out.json", "--max-volume", "1e-8"]

    def test_a_limit_of_vertices_stops_with_a_valid_mesh(self):
        report = self.mesh(box, "--max-volume", "1e-6", "--max-vertices", "2000", expect=UNMET)
        self.assertLessEqual(report["mesh"]["vertices"], 2000)
        self.assertEqual(report["outcome"]["stopped_by"], "vertices")

    def test_a_time_limit_holds_for_the_whole_program(self):
        for output in ("out.vtu", "out.node"):
            self.write("in.off", box)
            begin = time.monotonic()
            self.run_program("mesh", "in.off", "-o", output, "--max-volume", "1e-8", "--time-limit", "3", expect=UNMET)
            self.assertLess(time.monotonic() - begin, 4.5)  # on a busy machine; 3.5 is promised

    def test_a_smallest_edge_leaves_smaller_ones_alone_and_tells(self):
        report = self.mesh(box, "--max-volume", "1e-6", "--smallest-edge", "0.1", expect=UNMET)
        self.assertEqual({group["reason"] for group in report["outcome"]["unmet"]}, {"size floor"})

    def test_a_budget_that_ends_before_there_is_a_tetrahedron_writes_no_mesh_and_says_so(self):
        self.write("in.off", box)
        run = self.run_program("mesh", "in.off", "-o", "out.vtu", "--time-limit", "0", expect=UNMET)
        self.assertIn("nothing was written", run.err)
        self.assertFalse(self.exists("out.vtu"))

    def test_a_terminal_shows_vertices_and_the_levels_that_work_waits_in(self):
        self.write("in.off", box)
        run = self.on_terminal(*self.long, "--time-limit", "1.5")
        self.assertEqual(run.code, UNMET)
        self.assertRegex(run.err, r"\rdelref: refining, [\d,]+ vertices, ([\d,]+ (edges|facets), )*[\d,]+ tetrahedra waiting, \d+\.\d s\x1b\[K")
        self.assertTrue(run.err.endswith("\r\x1b[K"), repr(run.err))

    def test_an_interrupt_leaves_a_valid_mesh(self):
        self.write("in.off", box)
        run = self.on_terminal(*self.long, send=signal.SIGINT, when="refining")
        self.assertEqual(run.code, INTERRUPTED, str(run))
        self.assertIn("Interrupted", run.out)
        report = json.loads(self.read("out.json"))
        self.assertEqual(report["outcome"]["stopped_by"], "interrupted")
        if report["outcome"]["conforms"]:
            self.run_program("verify", "in.off", "out.vtu", "--report", "out.json")

    def test_quiet_prints_nothing_when_all_is_met(self):
        self.write("in.off", box)
        run = self.run_program("mesh", "in.off", "-o", "out.vtu", "--quiet")
        self.assertEqual((run.out, run.err), ("", ""))


if __name__ == "__main__":
    main()
