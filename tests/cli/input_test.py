# SPDX-License-Identifier: GPL-3.0-or-later
#
# Every way in which an input can be wrong ends with exit code 3 and a message that says what is wrong, where.
import os

from support import *


class Input(ProgramTest):
    def test_a_crossing_is_named_with_its_place(self):
        self.refused(crossing, "segment 4", "segment 5", "(0.5, 0.5)", "--split-crossings")

    def test_an_overlap_is_named_with_its_place(self):
        points = SQUARE + [(0.2, 0.5), (0.6, 0.5), (0.4, 0.5), (0.8, 0.5)]
        self.refused(poly(points, ring(4) + [(4, 5), (6, 7)]), "segment 4", "segment 5", "overlap", "(0.4, 0.5)")

    def test_a_coordinate_that_is_not_a_number_is_named(self):
        self.refused(square.replace("2 1.0 1.0", "2 nan 1.0"), "vertex 2", "not a number")

    def test_an_infinite_coordinate_is_named(self):
        self.refused(square.replace("2 1.0 1.0", "2 inf 1.0"), "vertex 2", "infinite")

    def test_a_segment_with_a_vertex_that_does_not_exist_is_named(self):
        self.refused(poly(SQUARE, ring(4) + [(0, 77)]), "segment 4", "77")

    def test_an_open_boundary_is_told_with_its_ends(self):
        self.refused(poly(SQUARE, ring(4)[:3]), "(0, 0)", "(0, 1)")

    def test_points_on_one_line_are_refused(self):
        self.refused(poly([(0.0, 0.0), (1.0, 1.0), (2.0, 2.0)], [(0, 1), (1, 2)]), "line")

    def test_a_hole_that_swallows_all_is_named(self):
        self.refused(poly(SQUARE, ring(4), holes=[(0.5, 0.5)]), "hole", "(0.5, 0.5)")

    def test_an_empty_file_is_refused(self):
        self.refused("", "in.poly")

    def test_a_file_without_vertices_is_refused(self):
        self.refused("0 2 0 0\n0 0\n0\n", "in.poly")

    def test_a_file_that_ends_too_early_is_refused_with_the_line(self):
        self.refused(square[:40], "in.poly", "line")

    def test_binary_garbage_is_refused(self):
        self.refused(bytes(range(256)) * 20, "in.poly")
        self.refused(b"\x00" * 5000, "in.geojson", name="in.geojson")

    def test_a_number_of_vertices_that_fits_no_memory_is_refused(self):
        self.refused("99999999999999999999 2 0 0\n", "in.poly")
        self.refused("4000000000 2 0 0\n0 0 0\n", "in.poly")

    def test_geojson_that_is_not_json_is_refused_with_the_line(self):
        self.refused('{"type": "Polygon",\n"coordinates": [[[0, 0], [1,', "line 2", name="in.geojson")

    def test_a_missing_file_is_told(self):
        run = self.run_program("mesh", "nothing.poly", "-o", "out.vtu", expect=INVALID)
        self.assertIn("nothing.poly: there is no such file", run.err)

    def test_a_folder_as_input_is_told(self):
        os.mkdir(self.path("folder.poly"))
        run = self.run_program("mesh", "folder.poly", "-o", "out.vtu", expect=INVALID)
        self.assertIn("directory", run.err)

    def test_an_unknown_extension_of_the_input_is_told_with_those_known(self):
        self.refused(square, ".step", ".poly", ".geojson", ".off", name="in.step")

    def test_elements_are_numbered_as_in_the_file(self):
        points, segments = SQUARE, ring(4) + [(0, 2), (1, 3)]
        self.refused(poly(points, segments, first=1), "segment 5", "segment 6", "vertices 1 and 3")

    def test_doubles_are_merged_and_told(self):
        self.write("in.poly", poly(SQUARE + [(1.0, 0.0)], [(0, 1), (4, 2), (2, 3), (3, 0)]))
        self.assertIn("merged", self.run_program("mesh", "in.poly", "-o", "out.vtu").out)

    def test_sizes_of_coordinates_from_1e_minus_150_to_1e150_are_meshed(self):
        for scale in (1e-150, 1e150):
            self.mesh(poly([(x * scale, y * scale) for x, y in SQUARE], ring(4)))
        self.mesh(poly([(x + 1e9, y + 1e9) for x, y in SQUARE], ring(4)), "--max-area", "0.01")

    def test_geojson_is_meshed(self):
        text = '{"type": "Polygon", "coordinates": [[[0, 0], [1, 0], [1, 1], [0, 1], [0, 0]]]}'
        self.mesh(text, name="in.geojson")


if __name__ == "__main__":
    main()
