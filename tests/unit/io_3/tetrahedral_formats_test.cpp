// SPDX-License-Identifier: GPL-3.0-or-later
#include <stop_token>
#include <string>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <delref/io/mesh_formats.hpp>
#include <delref/io/tetrahedral_formats.hpp>

#include "../io/scratch.hpp"
#include "meshes.hpp"

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::Message;
using Catch::Matchers::MessageMatches;
using delref::TetrahedralMesh;
using delref_test::Scratch;

namespace {

std::string replaced(std::string text, std::string_view from, std::string_view to) {
  return text.replace(text.find(from), from.size(), to);
}

const std::string small_medit =
    "MeshVersionFormatted 2\n# by hand\nDimension\n3\nVertices 4 0 0 0 1\n1 0 0 2  0 1 0 0\n0 0 1 -4\n"
    "Corners\n2\n1\n2\nEdges\n1\n1 2 5\nTriangles\n1\n1 2 3 -6\nTetrahedra\n1\n1 2 3 4 7\nRequiredVertices 1 4\nEnd\n";

}  // namespace

TEST_CASE("a tetrahedral mesh survives .vtu with all it carries") {
  const Scratch folder;
  const TetrahedralMesh mesh = delref_test::two_tetrahedra();
  delref::write_tetrahedral_mesh(folder / "m.vtu", mesh);
  const TetrahedralMesh read = delref::read_tetrahedral_mesh(folder / "m.vtu");
  CHECK(read.points == mesh.points);
  CHECK(read.point_markers == mesh.point_markers);
  CHECK(read.carriers == mesh.carriers);
  CHECK(read.provenance == mesh.provenance);
  CHECK(read.level_names == mesh.level_names);
  CHECK(read.tetrahedra == mesh.tetrahedra);
  CHECK(read.regions == mesh.regions);
  CHECK(read.triangles == mesh.triangles);
  CHECK(read.triangle_markers == mesh.triangle_markers);
  CHECK(read.triangle_facets == mesh.triangle_facets);
  CHECK(read.edges == mesh.edges);
  CHECK(read.edge_markers == mesh.edge_markers);
  CHECK(read.edge_segments == mesh.edge_segments);
}

TEST_CASE("points, cells, labels and markers of a tetrahedral mesh survive the formats that others read") {
  const Scratch folder;
  const TetrahedralMesh mesh = delref_test::two_tetrahedra();
  const std::string name = GENERATE("m.msh", "m.mesh", "m.ele");
  delref::write_tetrahedral_mesh(folder / name, mesh);
  const TetrahedralMesh read = delref::read_tetrahedral_mesh(folder / name);
  CHECK(read.points == mesh.points);
  CHECK(read.point_markers == mesh.point_markers);
  CHECK(read.tetrahedra == mesh.tetrahedra);
  CHECK(read.regions == mesh.regions);
  CHECK(read.triangles == mesh.triangles);
  CHECK(read.triangle_markers == mesh.triangle_markers);
  CHECK(read.edges == mesh.edges);
  CHECK(read.edge_markers == mesh.edge_markers);
}

TEST_CASE("a mesh of points and tetrahedra alone survives every format") {
  const Scratch folder;
  TetrahedralMesh mesh;
  mesh.points = delref_test::two_tetrahedra().points;
  mesh.tetrahedra = delref_test::two_tetrahedra().tetrahedra;
  for (const char* name : {"m.node", "m.vtu", "m.msh", "m.mesh"}) {
    delref::write_tetrahedral_mesh(folder / name, mesh);
    const TetrahedralMesh read = delref::read_tetrahedral_mesh(folder / name);
    CHECK(read.points == mesh.points);
    CHECK(read.tetrahedra == mesh.tetrahedra);
    CHECK(read.triangles.empty());
    delref::write_tetrahedral_mesh(folder / name, {});
    CHECK(delref::read_tetrahedral_mesh(folder / name).points.empty());
  }
}

TEST_CASE("the files of TetGen count from the input's first number and carry its attributes") {
  const Scratch folder;
  delref::Plc input;
  input.first_index = GENERATE(0U, 1U);
  input.attribute_count = 1;
  input.attributes = {2.5, 3.5, 4.5, 5.5};
  const std::vector<delref::Plc::Index> original{3, 1, 0};
  delref::write_tetrahedral_mesh(folder / "m.node", delref_test::two_tetrahedra(), {&input, original, {}});
  const delref::Plc read = delref::read_tetgen_node(folder / "m.node");
  CHECK(read.first_index == input.first_index);
  CHECK(read.attributes == std::vector<double>{5.5, 0, 0, 0, 2.5});
  const std::string wanted = input.first_index == 0 ? "2 4 1\n0 0 1 2 3 -3\n1 0 2 1 4 0\n" : "2 4 1\n1 1 2 3 4 -3\n2 1 3 2 5 0\n";
  CHECK(delref::read_file(folder / "m.ele") == wanted);
  CHECK(delref::read_tetrahedral_mesh(folder / "m.ele").tetrahedra == delref_test::two_tetrahedra().tetrahedra);
  std::filesystem::remove(folder / "m.face");
  std::filesystem::remove(folder / "m.edge");
  CHECK(delref::read_tetrahedral_mesh(folder / "m.ele").triangles.empty());
}

TEST_CASE("the references of a .mesh file of space are regions and markers") {
  const Scratch folder;
  delref::write_tetrahedral_mesh(folder / "m.mesh", delref_test::two_tetrahedra());
  const std::string text = delref::read_file(folder / "m.mesh");
  CHECK_THAT(text, ContainsSubstring("MeshVersionFormatted 2\nDimension 3\nVertices\n5\n0 0 0 1\n"));
  CHECK_THAT(text, ContainsSubstring("Edges\n3\n1 2 7\n3 4 0\n2 3 12\n"));
  CHECK_THAT(text, ContainsSubstring("Triangles\n3\n1 2 3 0\n1 4 2 12\n5 2 3 -2147483648\n"));
  CHECK_THAT(text, ContainsSubstring("Tetrahedra\n2\n1 2 3 4 -3\n1 3 2 5 0\nEnd\n"));
}

TEST_CASE("a .mesh file of others is read, in any lines, with what it tells besides passed over") {
  const TetrahedralMesh mesh = delref::parse_medit<TetrahedralMesh>(small_medit, "m.mesh");
  CHECK(mesh.points[2] == delref::Point3{0, 1, 0});
  CHECK(mesh.point_markers == std::vector<int>{1, 2, 0, -4});
  CHECK(mesh.tetrahedra == std::vector<std::array<TetrahedralMesh::Index, 4>>{{0, 1, 2, 3}});
  CHECK(mesh.regions == std::vector<int>{7});
  CHECK(mesh.triangle_markers == std::vector<int>{-6});
  CHECK(mesh.edge_markers == std::vector<int>{5});
}

TEST_CASE("a form feed is a blank as others are") {
  CHECK(delref::parse_medit<TetrahedralMesh>(replaced(small_medit, "Vertices 4", "\f\vVertices\f4"), "m.mesh").points.size() == 4);
}

TEST_CASE("broken .mesh files are refused with the line") {
  const auto [from, to, message] = GENERATE(table<std::string, std::string, std::string>({
      {"MeshVersionFormatted", "x", "m.mesh, line 1: expected MeshVersionFormatted: this is not a text file in the format of MEDIT"},
      {"Dimension\n3", "Dimension\n2", "line 4: the dimension is 2; only meshes of space are read here"},
      {"Dimension\n3", "Dimension\n4", "line 4: the dimension is 4; it can be 2 or 3"},
      {"Vertices 4", "Vertices 1000000000000", "line 5: the number of vertices is 1000000000000, but only"},
      {"Vertices 4", "Vertices 5", "line 8: expected a number for the x coordinate of vertex 5, found \"Corners\""},
      {"Tetrahedra", "Hexahedra", "Hexahedra are not read; only tetrahedra, triangles and edges are"},
      {"1 2 3 4 7", "1 2 3 5 7", "a vertex of Tetrahedra, number 1 is vertex 5, but the vertices are numbered from 1 and there are 4"},
      {"1 2 3 4 7", "1 2 3 0 7", "a vertex of Tetrahedra, number 1 is vertex 0"},
      {"1 2 3 4 7\nRequiredVertices 1 4\nEnd\n", "1 2 3 4", "the file ends in the middle of a section"},
      {"Vertices", "Vortices", "Edges come before Vertices"},
  }));
  CHECK_THROWS_MATCHES(delref::parse_medit<TetrahedralMesh>(replaced(small_medit, from, to), "m.mesh"), delref::InvalidInput,
                       MessageMatches(ContainsSubstring(message)));
}

TEST_CASE("broken meshes of TetGen are refused with the line") {
  const std::string node = "4 3 0 0\n1 0 0 0\n2 1 0 0\n3 0 1 0\n4 0 0 1\n";
  const auto read = [&](delref::TetgenMeshText text) { return delref::parse_tetgen_mesh(text, "m"); };
  CHECK_THROWS_MATCHES(read({node, "1 4 0\n1 1 2 3 5\n", {}, {}}), delref::InvalidInput,
                       Message("m.ele, line 2: the fourth vertex of tetrahedron 1 is vertex 5, but the vertices are numbered from 1 and there are 4"));
  CHECK_THROWS_MATCHES(read({node, "1 10 0\n1 1 2 3 4\n", {}, {}}), delref::InvalidInput,
                       Message("m.ele, line 1: the tetrahedra have 10 vertices each; only tetrahedra with 4 are read"));
  CHECK_THROWS_MATCHES(read({node, "1 4 0\n1 1 2 3 4\n", "1 1\n1 1 2 3\n", {}}), delref::InvalidInput,
                       Message("m.face, line 2: the line ends where the marker of face 1 was expected"));
  CHECK_THROWS_MATCHES(read({node, "1 4 0\n1 1 2 3 4\n", {}, "9999999999 1\n"}), delref::InvalidInput,
                       MessageMatches(ContainsSubstring("m.edge, line 1: the number of edges is 9999999999, but only")));
}

TEST_CASE("a tetrahedral mesh is no planar one") {
  const Scratch folder;
  delref::write_tetrahedral_mesh(folder / "m.msh", delref_test::two_tetrahedra());
  CHECK_THROWS_MATCHES(delref::read_msh(folder / "m.msh"), delref::InvalidInput, MessageMatches(ContainsSubstring("only planar meshes")));
  delref::write_tetrahedral_mesh(folder / "m.vtu", delref_test::two_tetrahedra());
  CHECK_THROWS_MATCHES(delref::read_vtu(folder / "m.vtu"), delref::InvalidInput, MessageMatches(ContainsSubstring("only planar meshes")));
  delref::write_tetrahedral_mesh(folder / "m.mesh", delref_test::two_tetrahedra());
  CHECK_THROWS_MATCHES(delref::read_medit<delref::PlanarMesh>(folder / "m.mesh"), delref::InvalidInput,
                       MessageMatches(ContainsSubstring("only planar meshes")));
}

TEST_CASE("whether a mesh is planar or tetrahedral is seen in its file") {
  const Scratch folder;
  for (const char* name : {"m.node", "m.vtu", "m.msh"}) {
    delref::write_tetrahedral_mesh(folder / name, delref_test::two_tetrahedra());
    CHECK(std::get<TetrahedralMesh>(delref::read_mesh(folder / name)).regions == delref_test::two_tetrahedra().regions);
    delref::write_planar_mesh(folder / name, delref_test::square_mesh());
    CHECK(std::get<delref::PlanarMesh>(delref::read_mesh(folder / name)).regions == delref_test::square_mesh().regions);
  }
}

TEST_CASE("writing that is stopped leaves no file") {
  const Scratch folder;
  std::stop_source stop;
  stop.request_stop();
  const delref::Control control({}, stop.get_token());
  for (const char* name : {"m.node", "m.vtu", "m.msh", "m.mesh", "m.svg"}) {
    CHECK_THROWS_AS(delref::write_tetrahedral_mesh(folder / name, delref_test::two_tetrahedra(), {}, control), delref::Interrupted);
  }
  CHECK(std::filesystem::is_empty(folder / ""));
}

TEST_CASE("a tetrahedral mesh is never written over the input or in a format that is not known") {
  const Scratch folder;
  const auto input = folder.write("part.node", "text");
  CHECK_THROWS_MATCHES(delref::check_tetrahedral_output(folder / "part.ele", input), delref::OutputError,
                       MessageMatches(ContainsSubstring("would be written over the input")));
  delref::check_tetrahedral_output(folder / "mesh.node", input);
  CHECK(delref::tetrahedral_mesh_files("a.ele").size() == 4);
  CHECK_THROWS_MATCHES(delref::check_tetrahedral_output("a.stl"), delref::OutputError,
                       Message("a.stl: \".stl\" is not the extension of a tetrahedral mesh that can be written; known are .node, .ele, .vtu, .msh, .mesh and .svg"));
}
