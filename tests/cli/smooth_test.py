# SPDX-License-Identifier: GPL-3.0-or-later
#
# Functions, images and sets of points: each option does what its help says, and a run has the manners of one on any other input.
# `self.mesh` verifies every mesh against its report. What the program was built without is passed over.
import gzip
import signal
import struct

from support import *

BOX = ["--bounds", "-2", "-2", "-2", "2", "2", "2"]
BALL = ["--implicit", "x^2+y^2+z^2-1", *BOX]
TORUS = ["--implicit", "(sqrt(x^2+y^2)-1)^2+z^2-0.16", *BOX]
TANGLE = ["--implicit", "x^4-5*x^2+y^4-5*y^2+z^4-5*z^2+11.8", "--bounds", "-3", "-3", "-3", "3", "3", "3"]
SIDE = 20  # voxels of the images
VOXELS = [(x, y, z) for z in range(SIDE) for y in range(SIDE) for x in range(SIDE)]


def inr(values, spacing=(1.0, 1.0, 1.0), size=(SIDE,) * 3, kind="float", scalar="f"):
    """The bytes of an INR image."""
    header = "#INRIMAGE-4#{\n" + "".join(f"{k}={v}\n" for k, v in zip(["XDIM", "YDIM", "ZDIM"], size))
    header += f"VDIM=1\nTYPE={kind}\nPIXSIZE={8 * struct.calcsize(scalar)} bits\nSCALE=2**0\nCPU=decm\n"
    header += "".join(f"{k}={v!r}\n" for k, v in zip(["VX", "VY", "VZ"], spacing))
    return (header + "\n" * (252 - len(header)) + "##}\n").encode() + struct.pack(f"<{len(values)}{scalar}", *values)


def labels(values):
    return gzip.compress(inr(values, kind="unsigned fixed", scalar="B"), mtime=0)


def depth(radius, centre=(9.5, 9.5, 9.5)):
    """Per voxel how deep it is in a ball."""
    return [radius - math.dist(v, centre) for v in VOXELS]


ball_image = inr(depth(8))
halves = labels([(4 if v[0] < 10 else 7) if d > 0 else 0 for v, d in zip(VOXELS, depth(8))])


class SmoothTest(ProgramTest):
    needs = "expressions"

    def setUp(self):
        super().setUp()
        probe = {"expressions": [*BALL, "--facet-size", "1"], "images": ["probe.inr", "--iso", "0"], "points": ["probe.xyz"]}[self.needs]
        self.write("probe.inr", ball_image)
        self.write("probe.xyz", "0 0 0\n")
        process = self.start("mesh", *probe, "-o", "probe.vtu", stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
        if "was built without" in process.communicate(timeout=240)[1]:
            self.skipTest("the program was built without " + self.needs)
        for name in os.listdir(self.folder):
            os.remove(self.path(name))

    def smooth(self, *arguments, expect=OK):
        """Meshes, verifies against the report, and gives the report."""
        self.run_program("mesh", *arguments, "-o", "out.vtu", "--report", "out.json", expect=expect)
        files = [arguments[0]] if self.exists(arguments[0]) else []
        self.run_program("verify", *files, "out.vtu", "--report", "out.json")
        return json.loads(self.read("out.json"))

    def told(self, *arguments, expect, words):
        run = self.run_program("mesh", *arguments, "-o", "bad.vtu", expect=expect)
        self.assertEqual(run.out, "")
        for word in words:
            self.assertIn(word, run.err)
        self.assertFalse(self.exists("bad.vtu"))

    def boundaries(self, report):
        return {b["region"]: (b["components"], b["euler_characteristic"], b["closed_manifold"]) for b in report["surface"]["boundaries"]}


class Functions(SmoothTest):
    def test_the_volume_inside_a_surface_is_meshed(self):
        report = self.smooth(*BALL)
        self.assertEqual(self.boundaries(report), {1: (1, 2, True)})
        self.assertEqual(report["surface"]["patches"], [{"marker": 1, "regions": [1, None], "triangles": report["mesh"]["triangles"]}])
        self.assertAlmostEqual(report["quality"]["total_volume"], 4 / 3 * math.pi, delta=0.05)
        self.assertGreaterEqual(report["surface"]["smallest_angle_degrees"], 30)
        self.assertLessEqual(report["quality"]["worst_radius_edge"], 2)
        self.assertEqual([level["name"] for level in report["outcome"]["levels"]], ["surface", "tetrahedra"])

    def test_the_topology_of_the_surface_is_told(self):
        self.assertEqual(self.boundaries(self.smooth(*TORUS)), {1: (1, 0, True)})
        self.assertEqual(self.boundaries(self.smooth(*TANGLE, "--facet-size", "0.2")), {1: (1, -8, True)})
        two = ["--implicit", "min((x-1)^2+y^2+z^2,(x+1)^2+y^2+z^2)-0.3", *BOX]
        report = self.smooth(*two)
        self.assertEqual(self.boundaries(report), {1: (2, 4, True)})
        self.assertEqual((report["surface"]["components"]["found"], report["surface"]["components"]["missed"]), (2, 0))
        out = self.run_program("mesh", *two, "-o", "a.vtu").out
        self.assertRegex(out, r"(?m)^  topology +2 components, Euler characteristic 4$")
        self.assertRegex(out, r"(?m)^  components +2 found ")

    def test_sizes_are_chosen_and_told_where_none_are_given(self):
        report = self.smooth(*BALL)
        self.assertAlmostEqual(report["surface"]["facet_size"], 0.1, delta=0.02)
        self.assertIsNone(report["options"]["facet_size"])
        self.assertRegex(self.run_program("mesh", *BALL, "-o", "a.vtu").out, r"(?m)^  facet size +0\.\d+ at most \(chosen\)$")

    def test_a_mesh_is_verified_with_the_sizes_that_its_run_chose(self):
        report = self.smooth(*BALL)
        self.assertIn("as the run chose", self.run_program("verify", "out.vtu", "--report", "out.json").out)
        self.assertIn("when no size is given", self.run_program("verify", *BALL, "out.vtu").out)
        self.assertNotIn("sizes ", self.run_program("verify", *BALL, "--facet-size", "0.2", "out.vtu").out)
        report["surface"]["facet_size"] /= 2
        self.write("less.json", json.dumps(report))
        self.assertIn("facet size", self.run_program("verify", "out.vtu", "--report", "less.json", expect=VERIFICATION_FAILED).out)

    def test_each_criterion_of_the_surface_is_met(self):
        coarse = self.smooth(*BALL, "--facet-size", "0.4")
        fine = self.smooth(*BALL, "--facet-size", "0.2")
        self.assertGreater(fine["mesh"]["triangles"], 3 * coarse["mesh"]["triangles"])
        near = self.smooth(*BALL, "--facet-distance", "0.005")
        self.assertIsNone(near["surface"]["facet_size"])
        self.assertGreater(self.smooth(*BALL, "--facet-distance", "0.001")["mesh"]["triangles"], 3 * near["mesh"]["triangles"])
        self.assertGreaterEqual(self.smooth(*BALL, "--facet-angle", "20", "--facet-size", "0.2")["surface"]["smallest_angle_degrees"], 20)
        self.run_program("mesh", *BALL, "--facet-size", "0.4", "-o", "out.vtu")
        for option, good, bad in (("--facet-size", "0.4", "0.2"), ("--facet-distance", "1", "0.001"), ("--facet-angle", "30", "45"),
                                  ("--cell-size", "2", "0.2"), ("--radius-edge", "2", "1.05")):
            size = [] if option == "--facet-size" else ["--facet-size", "0.4"]
            self.run_program("verify", *BALL, "out.vtu", *size, option, good)
            self.run_program("verify", *BALL, "out.vtu", *size, option, bad, expect=VERIFICATION_FAILED)

    def test_cells_have_their_size_everywhere_and_by_region(self):
        self.assertLessEqual(self.smooth(*BALL, "--facet-size", "0.3", "--cell-size", "0.2")["quality"]["longest_edge"], 0.4)
        halves = ["--implicit", "(x-0.7)^2+y^2+z^2-0.25", "--implicit", "(x+0.7)^2+y^2+z^2-0.25", *BOX, "--facet-size", "0.15"]
        report = self.smooth(*halves, "--region-cell-size", "2=0.06")
        regions = {region["label"]: region["tetrahedra"] for region in report["quality"]["regions"]}
        self.assertGreater(regions[2], 3 * regions[1])

    def test_sizes_at_points_are_kept(self):
        self.write("sizes.txt", "0 0 1 0.03\n0 0 -1 0.5\n")
        report = self.smooth(*BALL, "--size-points", "sizes.txt", "--facet-size", "0.5")
        self.assertGreater(report["mesh"]["triangles"], 2 * self.smooth(*BALL, "--facet-size", "0.5")["mesh"]["triangles"])

    def test_functions_together_make_regions(self):
        report = self.smooth("--implicit", "(x-0.4)^2+y^2+z^2-1", "--implicit", "(x+0.4)^2+y^2+z^2-1", *BOX, "--facet-size", "0.2")
        self.assertEqual([region["label"] for region in report["quality"]["regions"]], [1, 2, 3])
        patches = [patch["regions"] for patch in report["surface"]["patches"]]
        for between in ([1, None], [2, None], [3, 1], [3, 2]):
            self.assertIn(between, patches)
        self.assertTrue(any("function" in note for note in report["notes"]))

    def test_a_surface_alone_has_no_tetrahedra(self):
        report = self.smooth(*BALL, "--surface-only")
        self.assertEqual((report["mesh"]["tetrahedra"], self.boundaries(report)), (0, {1: (1, 2, True)}))
        self.run_program("verify", *BALL, "out.vtu", expect=VERIFICATION_FAILED)  # a volume was not asked for, and is not there
        for name in ("out.vtu", "a.msh", "a.mesh", "a.node"):
            self.run_program("mesh", *BALL, "--surface-only", "-o", name)
            self.run_program("verify", *BALL, "--surface-only", name)
            self.assertRegex(self.run_program("info", name).out, r"(?m)^pieces +1, Euler characteristic 2$")

    def test_a_domain_that_reaches_its_bounds_ends_there_and_that_is_told(self):
        report = self.smooth("--implicit", "z", *BOX, "--facet-size", "0.5")
        self.assertAlmostEqual(report["quality"]["total_volume"], 32, delta=2)
        self.assertTrue(any("reaches its bounds" in note for note in report["notes"]))

    def test_creases_end_at_the_size_floor_which_is_told(self):
        cube = ["--implicit", "max(abs(x),abs(y),abs(z))-1", *BOX, "--facet-distance", "0.001", "--smallest-facet", "0.01"]
        run = self.run_program("mesh", *cube, "-o", "out.vtu", "--report", "out.json", expect=UNMET)
        report = json.loads(self.read("out.json"))
        stopped = report["surface"]["facets_stopped_by_the_size_floor"]
        self.assertGreater(stopped, 0)
        self.assertIn("as small as the size floor", run.out)
        self.run_program("verify", "out.vtu", "--report", "out.json")

    def test_a_part_that_is_too_thin_for_the_facets_is_told(self):
        plate = ["--implicit", "max(abs(z)-0.02,x^2+y^2-1)", *BOX, "--facet-size", "0.3", "--smallest-facet", "0.05"]
        out = self.run_program("mesh", *plate, "-o", "out.vtu", "--report", "out.json", expect=UNMET).out
        self.assertIn("NOT the whole surface is in the mesh: it lacks parts at", out)
        self.assertGreater(json.loads(self.read("out.json"))["surface"]["components"]["loose_vertices"], 0)
        shell = ["--implicit", "abs(x^2+y^2+z^2-1)-0.05", *BOX, "--facet-size", "0.3", "--surface-only"]
        self.assertIn("but the surface of the mesh has", self.run_program("mesh", *shell, "-o", "out.vtu").out)

    def test_small_pieces_are_found_down_to_the_sampling_distance(self):
        pieces = ["--implicit", "min(x^2+y^2+z^2-1,(x-1.5)^2+(y-1.5)^2+(z-1.5)^2-0.0001)", *BOX, "--sampling", "0.004"]
        self.assertEqual(self.smooth(*pieces)["surface"]["components"]["found"], 2)

    def test_bad_expressions_and_bounds_are_told_in_words(self):
        self.told("--implicit", "x^2+", *BOX, expect=INVALID, words=["--implicit", "position"])
        self.told("--implicit", "x", "--implicit", "q*2", *BOX, expect=INVALID, words=["--implicit number 2", "q"])
        self.told("--implicit", "", *BOX, expect=INVALID, words=["--implicit"])
        self.told("--implicit", "1", *BOX, expect=INVALID, words=["no surface"])
        self.told("--implicit", "x^2+y^2+z^2+1", *BOX, expect=INVALID, words=["no surface"])
        self.told("--implicit", "sqrt(-1-x^2)", *BOX, expect=INVALID, words=["no surface"])
        self.told("--implicit", "x", expect=USAGE, words=["--bounds"])
        self.told("--implicit", "x", "--bounds", "1", "0", "0", "0", "1", "1", expect=USAGE, words=["along x", "from 1 to 0"])
        self.told("--implicit", "x", "--bounds", "0", "0", "0", "1", "1", expect=USAGE, words=["--bounds needs six numbers"])
        self.told("--implicit", "x", "--bounds", "0", "0", "nan", "1", "1", "1", expect=USAGE, words=["along z"])
        self.told(*BALL, "--region-cell-size", "0=1", expect=INVALID, words=["no region 0"])
        self.told(*BALL, "--size-points", "none.txt", expect=INVALID, words=["none.txt"])

    def test_a_function_and_a_file_are_two_inputs(self):
        self.write("in.poly", square)
        self.told("in.poly", *BALL, expect=USAGE, words=["two inputs", "in.poly"])

    def test_two_runs_write_the_same_bytes(self):
        names = ["vtu", "msh", "mesh", "node", "off", "stl", "ply", "obj", "svg"]
        for stem in ("a", "b"):
            self.run_program("mesh", *TORUS, *(w for n in names for w in ("-o", f"{stem}.{n}")), "--report", stem + ".json")
        for extension in [*names, "ele", "face", "edge"]:
            self.assertEqual(self.read("a." + extension).replace(b"a.", b"b."), self.read("b." + extension), extension)
        reports = [self.read(name + ".json").decode().split('"times"')[0] for name in ("a", "b")]
        self.assertEqual(reports[0].replace('"a.', '"b.'), reports[1])


class Formats(SmoothTest):
    def test_the_mesh_is_verified_from_every_format_that_carries_it(self):
        names = ["a.vtu", "a.msh", "a.mesh", "a.node"]
        self.run_program("mesh", *TORUS, *(w for n in names for w in ("-o", n)))
        for name in names:
            self.run_program("verify", *TORUS, name)
            self.assertIn("tetrahedra ", self.run_program("info", name).out)

    def test_the_surface_is_written_closed_and_in_full_precision(self):
        names = ["a.off", "a.stl", "a.ply", "a.obj"]
        self.run_program("mesh", *TORUS, "-o", "a.vtu", *(w for n in names for w in ("-o", n)), "--facet-size", "0.2")
        for name in names:
            # The surface is a solid like any other, of the same volume to the last digits.
            self.run_program("mesh", name, "-o", "again.vtu", "--report", "again.json", "--radius-edge", "8")
            volume = json.loads(self.read("again.json"))["quality"]["total_volume"]
            self.assertAlmostEqual(volume, self.volume("a.off"), 12)

    def volume(self, name):
        lines = [line.split() for line in self.read(name).decode().splitlines() if line]
        vertices, faces = int(lines[1][0]), int(lines[1][1])
        points = [tuple(map(float, line)) for line in lines[2:2 + vertices]]
        total = 0
        for line in lines[2 + vertices:2 + vertices + faces]:
            (ax, ay, az), (bx, by, bz), (cx, cy, cz) = (points[int(i)] for i in line[1:])
            total += ax * (by * cz - bz * cy) - ay * (bx * cz - bz * cx) + az * (bx * cy - by * cx)
        return total / 6

    def test_other_programs_read_the_surfaces(self):
        try:
            import meshio
            import numpy
        except ImportError as error:
            self.skipTest(str(error))
        names = ["a.vtu", "a.off", "a.stl", "a.ply", "a.obj"]
        self.run_program("mesh", *TORUS, "--surface-only", *(w for n in names for w in ("-o", n)))
        surfaces = {}
        for name in names:
            mesh = meshio.read(self.path(name))
            triangles = numpy.vstack([block.data for block in mesh.cells if block.type == "triangle"])
            surfaces[name] = mesh.points[triangles]
            self.assertEqual(surfaces[name].shape, surfaces["a.vtu"].shape, name)
            # meshio keeps the digits of an .stl in 32 bits
            close = 1e-6 if name == "a.stl" else 0
            for corner in range(3):  # the triangles stand in the same order; writers may begin each with another corner
                if numpy.abs(numpy.roll(surfaces[name], corner, axis=1) - surfaces["a.vtu"]).max() <= close:
                    break
            else:
                self.fail(name)

    def test_a_picture_of_a_volume_and_of_a_surface_has_triangles(self):
        for options in ([], ["--surface-only"]):
            self.run_program("mesh", *TORUS, "-o", "a.svg", *options)
            self.assertGreater(self.read("a.svg").count(b"z"), 100)

    def test_formats_of_surfaces_are_for_smooth_domains(self):
        self.write("in.off", box)
        for name in ("a.stl", "a.ply", "a.obj"):
            self.assertIn(".vtu", self.run_program("mesh", "in.off", "-o", name, expect=USAGE).err)
        self.assertIn(".stl", self.run_program("mesh", *BALL, "-o", "a.geojson", expect=USAGE).err)


class Images(SmoothTest):
    needs = "images"

    def test_a_level_set_is_meshed_in_the_unit_of_the_voxels(self):
        self.write("in.inr", ball_image)
        report = self.smooth("in.inr", "--iso", "1.5")
        self.assertEqual(self.boundaries(report), {1: (1, 2, True)})
        self.assertTrue(report["surface"]["components"]["found_exactly"])
        volume = report["quality"]["total_volume"]
        self.assertAlmostEqual(volume, 4 / 3 * math.pi * 6.5**3, delta=0.03 * volume)
        self.write("in.inr", inr(depth(8), spacing=(1.0, 0.5, 2.0)))
        self.assertAlmostEqual(self.smooth("in.inr", "--iso", "1.5", "--facet-size", "0.5")["quality"]["total_volume"], volume, delta=0.05 * volume)

    def test_images_may_be_compressed(self):
        self.write("in.inr", ball_image)
        self.write("in.inr.gz", gzip.compress(ball_image))
        meshes = []
        for name in ("in.inr", "in.inr.gz"):
            self.run_program("mesh", name, "--iso", "1", "-o", "out.vtu")
            meshes.append(self.read("out.vtu"))
        self.assertEqual(meshes[0], meshes[1])

    def test_the_level_set_may_be_turned_round_and_closed_at_the_border(self):
        self.write("in.inr", ball_image)
        self.told("in.inr", "--iso", "2", "--inside", "below", expect=INVALID, words=["in.inr", "leaves the image", "--closed"])
        report = self.smooth("in.inr", "--iso", "2", "--inside", "below", "--closed", "--facet-size", "1.5")
        self.assertEqual(self.boundaries(report), {1: (2, 4, True)})
        self.assertAlmostEqual(report["quality"]["total_volume"], 19**3 - 4 / 3 * math.pi * 6**3, delta=150)

    def test_facets_are_no_larger_than_voxels_call_for_unless_asked_to(self):
        rod = [1 - ((x - 29.5) / 28)**2 - ((y - 4.5) / 4)**2 - ((z - 4.5) / 4)**2 for z in range(10) for y in range(10) for x in range(60)]
        self.write("in.inr", inr(rod, spacing=(0.1, 0.1, 0.1), size=(60, 10, 10)))
        report = self.smooth("in.inr", "--iso", "0")
        self.assertAlmostEqual(report["surface"]["facet_size"], 0.15)
        self.assertTrue(any("one and a half voxels" in note for note in report["notes"]))
        self.assertEqual(self.smooth("in.inr", "--iso", "0", "--facet-size", "0.25")["surface"]["facet_size"], 0.25)

    def test_labels_are_regions_and_the_map_is_told(self):
        self.write("in.inr.gz", halves)
        report = self.smooth("in.inr.gz", "--labels", "--smooth-labels", "1")
        self.assertEqual(self.boundaries(report), {4: (1, 2, True), 7: (1, 2, True)})
        self.assertEqual([p["regions"] for p in report["surface"]["patches"]], [[4, None], [7, None], [7, 4]])
        self.assertEqual([region["label"] for region in report["quality"]["regions"]], [4, 7])
        out = self.run_program("mesh", "in.inr.gz", "--labels", "-o", "a.vtu", "--regions").out
        self.assertRegex(out, r"3: [\d,]+ triangles between region 7 and region 4")
        self.assertRegex(out, r"(?m)^ +4 +[\d,]+ +\d+")

    def test_the_background_may_be_another_label_or_none(self):
        self.write("in.inr.gz", halves)
        report = self.smooth("in.inr.gz", "--labels", "--background", "7", "--facet-size", "2")
        self.assertEqual([region["label"] for region in report["quality"]["regions"]], [0, 4])
        report = self.smooth("in.inr.gz", "--labels", "--background", "none", "--facet-size", "2")
        self.assertEqual([region["label"] for region in report["quality"]["regions"]], [0, 4, 7])

    def test_a_label_of_one_voxel_is_meshed_unless_it_is_smoothed_away(self):
        self.write("in.inr.gz", labels([3 if v == (9, 9, 9) else 1 if d > 0 else 0 for v, d in zip(VOXELS, depth(8))]))
        report = self.smooth("in.inr.gz", "--labels")
        self.assertEqual([region["label"] for region in report["quality"]["regions"]], [1, 3])
        out = self.run_program("mesh", "in.inr.gz", "--labels", "--smooth-labels", "1", "-o", "a.vtu").out
        self.assertIn("smooths away the label 3", out)

    def test_a_region_has_its_own_size(self):
        self.write("in.inr.gz", halves)
        report = self.smooth("in.inr.gz", "--labels", "--smooth-labels", "1", "--region-cell-size", "7=1", "--facet-size", "2")
        regions = {region["label"]: region["tetrahedra"] for region in report["quality"]["regions"]}
        self.assertGreater(regions[7], 2 * regions[4])
        self.told("in.inr.gz", "--labels", "--region-cell-size", "5=1", expect=INVALID, words=["no region 5", "4, 7"])
        self.told("in.inr.gz", "--labels", "--region-cell-size", "5", expect=USAGE, words=["LABEL=SIZE"])

    def test_what_cannot_be_meshed_is_told_in_words(self):
        self.write("in.inr", ball_image)
        self.told("in.inr", expect=USAGE, words=["in.inr is an image", "--iso", "--labels"])
        self.told("in.inr", "--iso", "1", "--labels", expect=USAGE, words=["not both"])
        self.told("in.inr", "--iso", "100", expect=INVALID, words=["no surface", "100", "values go from"])
        self.told("in.inr", "--iso", "-100", expect=INVALID, words=["every voxel is inside"])
        self.told("in.inr", "--labels", expect=INVALID, words=["in.inr"])
        self.told("none.inr", "--iso", "1", expect=INVALID, words=["none.inr: there is no such file"])
        self.write("nan.inr", inr([math.nan] + depth(8)[1:]))
        self.told("nan.inr", "--iso", "1", expect=INVALID, words=["not a finite number"])
        self.write("flat.inr", inr([1.0] * len(VOXELS)))
        self.told("flat.inr", "--iso", "1", expect=INVALID, words=["all voxels have the value 1"])

    def test_truncated_and_lying_headers_are_refused(self):
        for i, bad in enumerate([b"", b"#INR", ball_image[:200], ball_image[:300], ball_image[:-4],
                                 ball_image.replace(b"XDIM=20", b"XDIM=2000000000"), ball_image.replace(b"XDIM=20", b"XDIM=-20"),
                                 ball_image.replace(b"VX=1.0", b"VX=0.0"), ball_image.replace(b"VX=1.0", b"VX=nan"),
                                 ball_image.replace(b"PIXSIZE=32", b"PIXSIZE=33"), gzip.compress(ball_image)[:500], os.urandom(500)]):
            for name in (f"{i}.inr", f"{i}.inr.gz", f"{i}.nii", f"{i}.nrrd", f"{i}.mha"):
                with self.subTest(name=name):
                    self.write(name, bad)
                    self.told(name, "--iso", "1", expect=INVALID, words=[name])

    def test_options_of_other_kinds_are_refused(self):
        self.write("in.inr", ball_image)
        for option in ["--max-area=1", "--max-volume=1", "--merge-tolerance=1", "--join-coplanar=1", "--background=1", "--sampling=1", "--point-set"]:
            self.told("in.inr", "--iso", "1", option, expect=USAGE, words=[option.split("=")[0] + " is for "])
        self.write("in.off", box)
        self.write("in.poly", square)
        for option in ["--iso=1", "--labels", "--facet-size=1", "--surface-only", "--region-cell-size=1=1"]:
            for name in ("in.off", "in.poly"):
                self.told(name, option, expect=USAGE, words=[option.split("=")[0] + " is for ", name])

    def test_a_mesh_of_another_image_is_not_verified(self):
        self.write("in.inr", ball_image)
        self.smooth("in.inr", "--iso", "1")
        self.write("other.inr", inr(depth(6)))
        self.run_program("verify", "other.inr", "out.vtu", "--report", "out.json", expect=VERIFICATION_FAILED)
        self.write("in.off", box)
        self.run_program("verify", "in.off", "out.vtu", "--report", "out.json", expect=INVALID)


class Points(SmoothTest):
    needs = "points"

    def sphere(self, count, normals):
        numbers = random.Random(1)
        lines = []
        for _ in range(count):
            v = [numbers.gauss(0, 1) for _ in range(3)]
            length = math.hypot(*v)
            p = [c / length for c in v]
            lines.append(" ".join(repr(c) for c in (p + p if normals else p)))
        return "\n".join(lines) + "\n"

    def test_the_surface_through_points_is_meshed(self):
        for normals in (True, False):
            self.write("in.xyz", self.sphere(3000, normals))
            report = self.smooth("in.xyz")
            self.assertEqual(self.boundaries(report), {1: (1, 2, True)})
            self.assertAlmostEqual(report["quality"]["total_volume"], 4 / 3 * math.pi, delta=0.1)

    def test_a_ply_is_a_set_of_points_when_asked_for(self):
        rows = self.sphere(2000, True)
        header = "ply\nformat ascii 1.0\nelement vertex 2000\n" + "".join(f"property double {n}\n" for n in ["x", "y", "z", "nx", "ny", "nz"])
        self.write("in.ply", header + "end_header\n" + rows)
        self.assertEqual(self.boundaries(self.smooth("in.ply", "--point-set")), {1: (1, 2, True)})

    def test_bad_points_are_told_in_words(self):
        for text in ("", "0 0 0\n", "0 0 0\n1 0 0\n0 1 0\n1 1 0\n", "a b c\n", "1 2\n", "0 0 nan\n"):
            with self.subTest(text=text):
                self.write("in.xyz", text)
                self.told("in.xyz", expect=INVALID, words=["in.xyz"])


class Budgets(SmoothTest):
    long = ["mesh", *BALL, "-o", "out.vtu", "--report", "out.json", "--facet-size", "0.002"]

    def test_a_limit_of_vertices_stops_with_a_valid_mesh(self):
        report = self.smooth(*TANGLE, "--facet-size", "0.05", "--max-vertices", "3000", expect=UNMET)
        self.assertLessEqual(report["mesh"]["vertices"], 3000)
        self.assertEqual(report["outcome"]["stopped_by"], "vertices")

    def test_a_time_limit_holds_for_the_whole_program(self):
        for output in ("out.vtu", "out.stl", "out.svg"):
            begin = time.monotonic()
            self.run_program("mesh", *BALL, "-o", output, "--facet-size", "0.002", "--time-limit", "4", expect=UNMET)
            self.assertLess(time.monotonic() - begin, 5.5)  # on a busy machine; 4.5 is promised
            self.assertTrue(self.exists(output))

    def test_a_budget_that_ends_before_there_is_a_triangle_writes_no_mesh_and_says_so(self):
        run = self.run_program("mesh", *BALL, "-o", "out.vtu", "--time-limit", "0", expect=UNMET)
        self.assertIn("nothing was written", run.err)
        self.assertFalse(self.exists("out.vtu"))

    def test_a_terminal_shows_vertices_and_what_waits(self):
        run = self.on_terminal(*self.long, "--time-limit", "4")
        self.assertEqual(run.code, UNMET)
        self.assertRegex(run.err, r"\rdelref: refining, [\d,]+ vertices, [\d,]+ facets, [\d,]+ tetrahedra waiting,")

    def test_an_interrupt_leaves_a_valid_mesh(self):
        run = self.on_terminal(*self.long, send=signal.SIGINT, when="refining")
        self.assertEqual(run.code, INTERRUPTED, str(run))
        self.run_program("verify", "out.vtu", "--report", "out.json")

    def test_quiet_prints_nothing_when_all_is_met(self):
        run = self.run_program("mesh", *BALL, "-o", "out.vtu", "--quiet")
        self.assertEqual((run.out, run.err), ("", ""))


if __name__ == "__main__":
    main()
