// SPDX-License-Identifier: GPL-3.0-or-later
#include <string>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <delref/io/planar_formats.hpp>

#include "scratch.hpp"

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::Message;
using Catch::Matchers::MessageMatches;
using delref_test::check_same;
using delref_test::replaced;
using delref_test::Scratch;

namespace {

const std::string small_msh =
    "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Comments\nanything at all\n$EndComments\n"
    "$PhysicalNames\n1\n2 9 \"the sea\"\n$EndPhysicalNames\n"
    "$Entities\n0 0 1 0\n5 0 0 0 1 1 0 1 9 0\n$EndEntities\n"
    "$Nodes\n1 3 10 30\n2 5 0 3\n30\n10\n20\n0 0 0\n1 0 0\n0 1 0\n$EndNodes\n"
    "$Elements\n1 1 1 1\n2 5 2 1\n1 30 10 20\n$EndElements\n";

const std::string small_vtu =
    "<VTKFile type=\"UnstructuredGrid\"><UnstructuredGrid><Piece NumberOfPoints=\"3\" NumberOfCells=\"1\">"
    "<CellData><DataArray type=\"Int32\" Name=\"region\" format=\"ascii\">7</DataArray></CellData>"
    "<Points><DataArray type=\"Float64\" NumberOfComponents=\"3\" format=\"ascii\">0 0 0 1 0 0 0 1 0</DataArray></Points>"
    "<Cells><DataArray type=\"Int32\" Name=\"connectivity\" format=\"ascii\">0 1 2</DataArray>"
    "<DataArray type=\"Int32\" Name=\"offsets\" format=\"ascii\">3</DataArray>"
    "<DataArray type=\"UInt8\" Name=\"types\" format=\"ascii\">5</DataArray></Cells></Piece></UnstructuredGrid></VTKFile>";

}  // namespace

TEST_CASE("a mesh survives .vtu with all it carries") {
  const Scratch folder;
  const delref::PlanarMesh mesh = delref_test::square_mesh();
  delref::write_planar_mesh(folder / "m.vtu", mesh);
  const delref::PlanarMesh read = delref::read_planar_mesh(folder / "m.vtu");
  check_same(read, mesh);
  CHECK(read.carriers == mesh.carriers);
  CHECK(read.provenance == mesh.provenance);
  CHECK(read.level_names == mesh.level_names);
  CHECK(read.edge_segments == mesh.edge_segments);
}

TEST_CASE("a mesh survives .msh with labels and markers of any sign") {
  const Scratch folder;
  const delref::PlanarMesh mesh = delref_test::square_mesh();
  delref::write_planar_mesh(folder / "m.msh", mesh);
  check_same(delref::read_planar_mesh(folder / "m.msh"), mesh);
}

TEST_CASE("an empty mesh survives every format that is read") {
  const Scratch folder;
  for (const char* name : {"m.node", "m.vtu", "m.msh"}) {
    delref::write_planar_mesh(folder / name, {});
    CHECK(delref::read_planar_mesh(folder / name).points.empty());
  }
}

TEST_CASE("positive labels are their own physical tags and the others take the smallest that are left") {
  using Pairs = std::vector<std::pair<int, int>>;
  CHECK(delref::PhysicalTags({0}).pairs() == Pairs{{0, 1}});
  CHECK(delref::PhysicalTags({2, 1, 0, -5, 2, 4}).pairs() == Pairs{{-5, 3}, {0, 5}, {1, 1}, {2, 2}, {4, 4}});
  CHECK(delref::PhysicalTags({2147483647, 0}).pairs() == Pairs{{0, 1}, {2147483647, 2147483647}});
}

TEST_CASE("nodes of a .msh file may have any tags, and a physical group any name") {
  const delref::PlanarMesh mesh = delref::parse_msh(small_msh, "m.msh");
  CHECK(mesh.points.size() == 3);
  CHECK(mesh.triangles == std::vector<std::array<delref::PlanarMesh::Index, 3>>{{0, 1, 2}});
  CHECK(mesh.regions == std::vector<int>{9});
}

TEST_CASE("broken .msh files are refused with the line") {
  const auto [from, to, message] = GENERATE(table<std::string, std::string, std::string>({
      {"$MeshFormat\n4.1", "mesh", "expected $MeshFormat: this is not a file in Gmsh's MSH format"},
      {"4.1 0 8", "2.2 0 8", "line 2: the version is 2.2; only 4.1 is read (gmsh -save -format msh41 converts it)"},
      {"4.1 0 8", "4.1 1 8", "the file is binary; only text is read"},
      {"1 3 10 30", "1 3000000000 10 30", "the number of nodes is 3000000000, but only"},
      {"0 1 0\n$EndN", "0 1 2\n$EndN", "node 20 has z coordinate 2; only planar meshes, with z = 0, are read"},
      {"1 30 10 20", "1 30 10 21", "a corner of an element is node 21, but there is no such node"},
      {"30\n10\n20", "30\n10\n30", "node 30 is there twice"},
      {"2 5 2 1\n", "2 5 3 1\n", "the elements are of type 3; only lines (1), triangles (2) and points (15) are read"},
      {"$EndElements", "", "the file ends where $EndElements was expected"},
  }));
  CHECK_THROWS_MATCHES(delref::parse_msh(replaced(small_msh, from, to), "m.msh"), delref::InvalidInput, MessageMatches(ContainsSubstring(message)));
}

TEST_CASE("a .vtu file in text is read") {
  const delref::PlanarMesh mesh = delref::parse_vtu(small_vtu, "m.vtu");
  CHECK(mesh.points[1] == delref::Point2{1, 0});
  CHECK(mesh.regions == std::vector<int>{7});
  CHECK(mesh.point_markers.empty());
}

TEST_CASE("appended base64 is read") {
  // The length 9 * 8 as 32 bits, and nine doubles, of which only the fourth and eighth are not 0 but 1.
  std::string data;
  delref::TextSink out([&](std::string_view piece) { data += piece; });
  delref::Base64Writer bytes(out);
  bytes.put(std::uint32_t{72});
  for (const double value : {0., 0., 0., 1., 0., 0., 0., 1., 0.}) bytes.put(value);
  bytes.finish();
  out.flush();
  std::string text = replaced(small_vtu, "format=\"ascii\">0 0 0 1 0 0 0 1 0<", "format=\"appended\" offset=\"0\"><");
  text = replaced(text, "</UnstructuredGrid>", "</UnstructuredGrid><AppendedData encoding=\"base64\">\n _" + data + "\n</AppendedData>");
  CHECK(delref::parse_vtu(text, "m.vtu").points == delref::parse_vtu(small_vtu, "m.vtu").points);
}

TEST_CASE("broken .vtu files are refused in words") {
  const auto [from, to, message] = GENERATE(table<std::string, std::string, std::string>({
      {"</VTKFile>", "", "is not XML"},
      {"<Piece", "<Peace", "is not XML"},
      {"VTKFile type", "VTKFile compressor=\"vtkZLibDataCompressor\" type", "is compressed; save it without compression"},
      {"NumberOfPoints=\"3\"", "NumberOfPoints=\"4\"", "the array \"\" has 9 numbers, not 12"},
      {"NumberOfPoints=\"3\"", "NumberOfPoints=\"4000000000\"", "announces 4000000000 points and 1 cells, more than its"},
      {"0 1 2<", "0 1 3<", "in connectivity, number 2 is 3, which is not an integer from 0 to 2"},
      {">3<", ">4<", "cell 0 should have 3 corners; its offsets are 0 and 4, the connectivity has 3 numbers"},
      {">5<", ">9<", "cell 0 is of type 9; only triangles (5), lines (3) and vertices (1) are read"},
      {">7<", ">x<", "m.vtu, array \"region\", line 1: expected a number for a number, found \"x\""},
      {"ascii\">7<", "binary\">AAAA<", "the array \"region\" does not begin with its length in base64"},
      {"ascii\">7<", "binary\">////////<", "the array \"region\" should have 4294967295 bytes, but is shorter"},
      {"\"connectivity\"", "\"c\"", "the cells have no array \"connectivity\""},
      {"0 0 0 1", "0 0 5 1", "point 0 has z coordinate 5; only planar meshes, with z = 0, are read"},
  }));
  CHECK_THROWS_MATCHES(delref::parse_vtu(replaced(small_vtu, from, to), "m.vtu"), delref::InvalidInput, MessageMatches(ContainsSubstring(message)));
}

TEST_CASE("the references of a .mesh file are regions and markers") {
  const Scratch folder;
  delref::write_planar_mesh(folder / "m.mesh", delref_test::square_mesh());
  const std::string text = delref::read_file(folder / "m.mesh");
  CHECK_THAT(text, ContainsSubstring("Vertices\n4\n0 0 1\n"));
  CHECK_THAT(text, ContainsSubstring("Edges\n3\n1 2 7\n3 4 0\n2 3 -2147483648\n"));
  CHECK_THAT(text, ContainsSubstring("Triangles\n2\n1 2 3 -3\n1 3 4 0\nEnd\n"));
}

TEST_CASE("an extension that is not known is refused with those that are") {
  CHECK_THROWS_MATCHES(delref::read_pslg("a.dxf"), delref::InvalidInput,
                       Message("a.dxf: \".dxf\" is not the extension of a domain; known are .poly, .node, .geojson and .json"));
  CHECK_THROWS_MATCHES(delref::read_planar_mesh("a"), delref::InvalidInput,
                       Message("a: the name has no extension that tells a mesh that can be read; known are .node, .ele, .vtu and .msh"));
  CHECK_THROWS_MATCHES(delref::write_planar_mesh("a.stl", {}), delref::OutputError, MessageMatches(ContainsSubstring(".mesh, .off and .svg")));
}

TEST_CASE("the input is never written over") {
  const Scratch folder;
  const auto input = folder.write("coast.poly", "text");
  CHECK_THROWS_MATCHES(delref::check_planar_output(folder / "coast.node", input), delref::OutputError,
                       MessageMatches(ContainsSubstring("would be written over the input")));
  delref::check_planar_output(folder / "mesh.node", input);
  delref::check_planar_output(folder / "coast.vtu", input);
}
