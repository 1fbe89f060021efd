// SPDX-License-Identifier: GPL-3.0-or-later
#include <delref/images/image_reader.hpp>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numeric>
#include <string>
#include <variant>
#include <vector>

#include <CGAL/Image_3.h>

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include "../io/scratch.hpp"
#include "image_files.hpp"
#include "images.hpp"

using namespace delref;
using namespace delref_test;
using Catch::Matchers::ContainsSubstring;

namespace {

/// -12, -11, ... 11: as many as there are voxels.
template <class Number>
std::vector<Number> ramp(double factor = 1) {
  std::vector<Number> out;
  for (int i = -12; i != 12; ++i) out.push_back(static_cast<Number>(factor * i));
  return out;
}

template <class Value>
const std::vector<Value>& values_of(const ImageFile& file) {
  REQUIRE(std::holds_alternative<Image<Value>>(file.image));
  return std::get<Image<Value>>(file.image).values;
}

const ImageGrid small_grid{{4, 3, 2}, {0.5, 1, 2}};

/// Every cut of a file and every byte of its header changed: an image or words, nothing else.
template <class Parse>
void check_hostile(const std::string& file, std::size_t header, Parse&& parse) {
  const auto survives = [&](const std::string& bytes) {
    try {
      const ImageFile image = parse(bytes);
      CHECK(grid_of(image.image).voxels() == std::visit([](const auto& i) { return i.values.size(); }, image.image));
      return true;
    } catch (const InvalidInput& error) {
      CHECK(std::string(error.what()).size() > 10);
      return false;
    }
  };
  for (std::size_t cut = 0; cut < file.size(); cut += 11) CHECK_FALSE(survives(file.substr(0, cut)));
  for (std::size_t i = 0; i != header; ++i) {
    for (const int change : {1, 0x20, 0x7f, 0xff}) {
      std::string changed = file;
      changed[i] = static_cast<char>(changed[i] ^ change);
      survives(changed);
    }
  }
}

constexpr auto no_file = [](const std::string&) { return std::string(); };

}  // namespace

TEST_CASE("INR images keep the values of every type") {
  const Scratch scratch;
  const auto read = [&](const std::string& bytes) { return read_image(scratch.write("a.inr", bytes)); };
  const ImageFile file = read(inr("float", bytes_of(ramp<float>(0.1), std::endian::little), "PIXSIZE=32 bits\nTX=1\nTY=2\nTZ=-3\n"));
  CHECK(values_of<float>(file) == ramp<float>(0.1));
  ImageGrid moved = small_grid;
  moved.origin = {1, 2, -3};
  CHECK(grid_of(file.image) == moved);
  CHECK(values_of<double>(read(inr("float", bytes_of(ramp<double>(0.1), std::endian::little), "PIXSIZE=64 bits\n"))) == ramp<double>(0.1));
  CHECK(values_of<std::int32_t>(read(inr("signed fixed", bytes_of(ramp<std::int8_t>()), "PIXSIZE=8 bits\n"))) == ramp<std::int32_t>());
  CHECK(values_of<std::int32_t>(read(inr("signed fixed", bytes_of(ramp<std::int16_t>(2000), std::endian::big),
                                         "PIXSIZE=16 bits\nCPU=sun\n"))) == ramp<std::int32_t>(2000));
  CHECK(values_of<std::int32_t>(read(inr("signed fixed", bytes_of(ramp<std::int64_t>(), std::endian::little),
                                         "PIXSIZE=64 bits\n"))) == ramp<std::int32_t>());
  std::vector<std::uint32_t> large(24, 4'000'000'001U);
  CHECK(values_of<double>(read(inr("unsigned fixed", bytes_of(large, std::endian::little), "PIXSIZE=32 bits\n")))[5] == 4'000'000'001.0);
  const std::vector<std::uint64_t> huge(24, (std::uint64_t{1} << 53) + 1);
  CHECK_THAT(refusal([&] { read(inr("unsigned fixed", bytes_of(huge, std::endian::little), "PIXSIZE=64 bits\n")); }),
             ContainsSubstring("9007199254740993 has more than 53 bits"));
}

TEST_CASE("compressed images are read as others are, in several pieces too") {
  const Scratch scratch;
  const std::string plain = inr("float", bytes_of(ramp<float>(), std::endian::little), "PIXSIZE=32 bits\n");
  CHECK(values_of<float>(read_image(scratch.write("a.inr.gz", deflated(plain)))) == ramp<float>());
  CHECK(values_of<float>(read_image(scratch.write("b.inr.gz", deflated(plain.substr(0, 300)) + deflated(plain.substr(300))))) == ramp<float>());
}

TEST_CASE("INR images are what CGAL's ImageIO reads") {
  const Scratch scratch;
  const auto path = scratch.write("a.inr.gz", deflated(inr("signed fixed", bytes_of(ramp<std::int16_t>(7), std::endian::big),
                                                           "PIXSIZE=16 bits\nCPU=sun\nTX=4\n")));
  const ImageFile ours = read_image(path);
  CGAL::Image_3 theirs;
  REQUIRE(theirs.read(path.string().c_str()));
  const ImageGrid& grid = grid_of(ours.image);
  CHECK((grid.size[0] == static_cast<int>(theirs.xdim()) && grid.size[1] == static_cast<int>(theirs.ydim()) &&
         grid.size[2] == static_cast<int>(theirs.zdim())));
  CHECK((grid.spacing[0] == theirs.vx() && grid.spacing[1] == theirs.vy() && grid.spacing[2] == theirs.vz()));
  CHECK(grid.origin.x == static_cast<double>(theirs.image()->tx));
  for (std::size_t z = 0; z != 2; ++z) {
    for (std::size_t y = 0; y != 3; ++y) {
      for (std::size_t x = 0; x != 4; ++x) CHECK(values_of<std::int32_t>(ours)[(z * 3 + y) * 4 + x] == static_cast<int>(theirs.value(x, y, z)));
    }
  }
}

TEST_CASE("INR headers that lie or cannot be read are refused in words") {
  const std::string values = bytes_of(ramp<std::int16_t>());
  const auto words = [&](const std::string& fields, const std::string& type = "signed fixed") {
    return refusal([&] { parse_inr(inr(type, values, fields), "a.inr"); });
  };
  CHECK(words("PIXSIZE=16 bits\n").empty());
  CHECK_THAT(words("PIXSIZE=32 bits\n"), ContainsSubstring("96 voxels") || ContainsSubstring("4 x 3 x 2 voxels of 4 bytes"));
  CHECK_THAT(words("PIXSIZE=16 bits\nXDIM=1000000000\nYDIM=1000000000\nZDIM=1000000000\n"),
             ContainsSubstring("more than 1000000 are not supported"));
  CHECK_THAT(words("PIXSIZE=16 bits\nXDIM=999999\nYDIM=999999\nZDIM=999999\n"), ContainsSubstring("the header lies"));
  CHECK_THAT(words("PIXSIZE=16 bits\nXDIM=-1\n"), ContainsSubstring("positive whole number"));
  CHECK_THAT(words("PIXSIZE=16 bits\nVX=0\n"), ContainsSubstring("spacing of the voxels along x is 0"));
  CHECK_THAT(words("PIXSIZE=16 bits\nVZ=nan\n"), ContainsSubstring("spacing of the voxels along z is nan"));
  CHECK_THAT(words("PIXSIZE=16 bits\nVDIM=3\n"), ContainsSubstring("several values per voxel"));
  CHECK_THAT(words("PIXSIZE=16 bits\nCPU=pdp\n"), ContainsSubstring("known are decm"));
  CHECK_THAT(words("PIXSIZE=16 bits\nRX=1\n"), ContainsSubstring("turned INR images"));
  CHECK_THAT(words("PIXSIZE=12 bits\n"), ContainsSubstring("known are 8, 16, 32 and 64"));
  CHECK_THAT(words("PIXSIZE=16 bits\n", "float"), ContainsSubstring("float of 16 bits"));
  CHECK_THAT(words(""), ContainsSubstring("TYPE and PIXSIZE"));
  CHECK_THAT(refusal([] { parse_inr("P6 1 1", "a.inr"); }), ContainsSubstring("is no INR image"));
  CHECK_THAT(refusal([] { parse_inr("#INRIMAGE-4#{\nXDIM=4\n", "a.inr"); }), ContainsSubstring("has no end"));
}

TEST_CASE("damaged INR images give words, never anything else") {
  const std::string file = inr("signed fixed", bytes_of(ramp<std::int16_t>()), "PIXSIZE=16 bits\n");
  check_hostile(file, 256, [](const std::string& bytes) { return parse_inr(bytes, "a.inr"); });
  const std::string compressed = deflated(file);
  check_hostile(compressed, compressed.size(), [](const std::string& bytes) { return parse_inr(bytes, "a.inr.gz"); });
}

TEST_CASE("a small file that decompresses to a large one is not decompressed further than its header says") {
  const std::string file = inr("signed fixed", bytes_of(ramp<std::int16_t>()), "PIXSIZE=16 bits\n") + std::string(8'000'000, '\0');
  CHECK(values_of<std::int32_t>(parse_inr(deflated(file), "a.inr.gz")) == ramp<std::int32_t>());
}

TEST_CASE("NIfTI images are placed by their matrices and scaled") {
  nifti_1_header h = nifti_header();
  const std::string values = bytes_of(ramp<std::int16_t>());
  CHECK(grid_of(parse_nifti(nifti(h, values), "a.nii").image) == small_grid);
  CHECK(values_of<std::int32_t>(parse_nifti(nifti(h, values), "a.nii")) == ramp<std::int32_t>());

  h.scl_slope = 0.5F, h.scl_inter = 1;
  CHECK(values_of<float>(parse_nifti(deflated(nifti(h, values)), "a.nii.gz"))[0] == -5.0F);

  // A quarter turn around z: x goes to y.
  h.qform_code = 1;
  h.quatern_d = static_cast<float>(std::sqrt(0.5));
  h.qoffset_x = 10;
  const ImageFile turned = parse_nifti(nifti(h, values), "a.nii");
  CHECK(squared_distance(grid_of(turned.image).world({2, 0, 1}), Point3{10, 1, 2}) < 1e-12);

  // The general matrix comes first, unless it is sheared.
  h.sform_code = 1;
  h.srow_x[0] = -0.5F, h.srow_y[1] = 1, h.srow_z[2] = 2, h.srow_z[3] = 7;
  const ImageFile mirrored = parse_nifti(nifti(h, values), "a.nii");
  CHECK(squared_distance(grid_of(mirrored.image).world({2, 1, 0}), Point3{-1, 1, 7}) < 1e-12);
  h.srow_x[1] = 0.3F;
  const ImageFile sheared = parse_nifti(nifti(h, values), "a.nii");
  CHECK(grid_of(sheared.image) == grid_of(turned.image));
  REQUIRE(sheared.notes.size() == 1);
  CHECK_THAT(sheared.notes[0], ContainsSubstring("the rigid one (qform) is used"));
  h.qform_code = 0;
  CHECK_THAT(refusal([&] { parse_nifti(nifti(h, values), "a.nii"); }), ContainsSubstring("x and y are not at right angles"));
}

TEST_CASE("NIfTI images of the second version are read") {
  nifti_2_header h{};
  h.sizeof_hdr = 540;
  std::memcpy(h.magic, "n+2\0\r\n\032\n", 8);
  h.dim[0] = 3, h.dim[1] = 4, h.dim[2] = 3, h.dim[3] = 2;
  h.datatype = DT_FLOAT64, h.bitpix = 64;
  h.pixdim[0] = 1, h.pixdim[1] = 0.5, h.pixdim[2] = 1, h.pixdim[3] = 2;
  h.vox_offset = 544;
  const ImageFile file = parse_nifti(nifti(h, bytes_of(ramp<double>(0.1))), "a.nii");
  CHECK(values_of<double>(file) == ramp<double>(0.1));
  CHECK(grid_of(file.image) == small_grid);
}

TEST_CASE("pairs of NIfTI and Analyze files are read by either name, compressed or not") {
  nifti_1_header h = nifti_header();
  h.vox_offset = 0;
  std::memcpy(h.magic, "ni1", 4);
  const std::string values = bytes_of(ramp<std::int16_t>());
  const Scratch scratch;
  const auto header = scratch.write("a.hdr", nifti(h, "", 0));
  const auto image = scratch.write("a.img", values);
  CHECK(values_of<std::int32_t>(read_image(header)) == ramp<std::int32_t>());
  CHECK(values_of<std::int32_t>(read_image(image)) == ramp<std::int32_t>());
  std::memset(h.magic, 0, 4);  // Analyze
  h.dim[0] = 4;                // with no volume in time, as some write one volume
  const auto analyze = scratch.write("b.hdr.gz", deflated(nifti(h, "", 0)));
  CHECK_THAT(refusal([&] { read_image(analyze); }), ContainsSubstring("b.img: there is no such file"));
  scratch.write("b.img.gz", deflated(values));
  CHECK(grid_of(read_image(analyze).image) == small_grid);
  CHECK(values_of<std::int32_t>(read_image(analyze)) == ramp<std::int32_t>());
  CHECK_THAT(refusal([&] { parse_nifti(nifti(h, values), "a.nii"); }), ContainsSubstring("one of two files"));
}

TEST_CASE("NIfTI headers that lie or cannot be read are refused in words") {
  const std::string values = bytes_of(ramp<std::int16_t>());
  const auto words = [&](auto&& change) {
    nifti_1_header h = nifti_header();
    change(h);
    return refusal([&] { parse_nifti(nifti(h, values), "a.nii"); });
  };
  CHECK(words([](auto&) {}).empty());
  CHECK_THAT(words([](auto& h) { h.sizeof_hdr = 12; }), ContainsSubstring("is no NIfTI or Analyze image"));
  CHECK_THAT(words([](auto& h) { h.dim[0] = 90; }), ContainsSubstring("90 dimensions"));
  CHECK_THAT(words([](auto& h) { h.dim[2] = -3; }), ContainsSubstring("-3 voxels along axis 2"));
  CHECK_THAT(words([](auto& h) { h.dim[1] = h.dim[2] = h.dim[3] = 32767; }), ContainsSubstring("the header lies"));
  CHECK_THAT(words([](auto& h) { h.dim[0] = 4, h.dim[4] = 20; }), ContainsSubstring("20 volumes"));
  CHECK_THAT(words([](auto& h) { h.pixdim[2] = 0; }), ContainsSubstring("spacing along axis 2 is 0"));
  CHECK_THAT(words([](auto& h) { h.pixdim[3] = std::numeric_limits<float>::quiet_NaN(); }), ContainsSubstring("spacing along axis 3 is nan"));
  CHECK_THAT(words([](auto& h) { h.datatype = DT_RGB24, h.bitpix = 24; }), ContainsSubstring("colour"));
  CHECK_THAT(words([](auto& h) { h.datatype = DT_COMPLEX64, h.bitpix = 64; }), ContainsSubstring("complex"));
  CHECK_THAT(words([](auto& h) { h.datatype = 77; }), ContainsSubstring("type of values, 77"));
  CHECK_THAT(words([](auto& h) { h.bitpix = 8; }), ContainsSubstring("8 bits per voxel"));
  CHECK_THAT(words([](auto& h) { h.vox_offset = 1e9F; }), ContainsSubstring("the header lies"));
  CHECK_THAT(words([](auto& h) { h.vox_offset = -1; }), ContainsSubstring("begin at byte -1"));
  CHECK_THAT(words([](auto& h) { h.scl_slope = std::numeric_limits<float>::infinity(); }), ContainsSubstring("scaled by inf"));
  CHECK_THAT(words([](auto& h) { h.qform_code = 1, h.quatern_b = std::numeric_limits<float>::quiet_NaN(); }),
             ContainsSubstring("entries that are not numbers"));
}

TEST_CASE("damaged NIfTI images give words, never anything else") {
  nifti_1_header h = nifti_header();
  h.qform_code = 1, h.sform_code = 1;
  h.srow_x[0] = 1, h.srow_y[1] = 1, h.srow_z[2] = 1;
  check_hostile(nifti(h, bytes_of(ramp<std::int16_t>())), 352, [](const std::string& bytes) { return parse_nifti(bytes, "a.nii"); });
}

TEST_CASE("NRRD images are read, attached and beside their header") {
  const std::string start =
      "NRRD0005\n# made by hand\ntype: short\ndimension: 3\nsizes: 4 3 2\nendian: big\nspace: "
      "left-posterior-superior\nkey:=value\n";
  const std::string place = "space directions: (0,0.5,0) (-1,0,0) (0,0,2)\nspace origin: (1,2,3)\n";
  const std::string values = bytes_of(ramp<std::int16_t>(), std::endian::big);
  const auto parse = [](const std::string& bytes) { return parse_nrrd(bytes, no_file, "a.nrrd"); };
  const ImageFile raw = parse(start + place + "encoding: raw\n\n" + values);
  CHECK(values_of<std::int32_t>(raw) == ramp<std::int32_t>());
  CHECK(squared_distance(grid_of(raw.image).world({2, 1, 1}), Point3{0, 3, 5}) < 1e-24);
  const ImageFile packed = parse(start + "spacings: 0.5 1 2\nencoding: gzip\n\n" + deflated(values));
  CHECK(values_of<std::int32_t>(packed) == ramp<std::int32_t>());
  CHECK(grid_of(packed.image) == small_grid);
  const Scratch scratch;
  scratch.write("b.raw", values);
  CHECK(values_of<std::int32_t>(read_image(scratch.write("b.nhdr", start + "encoding: raw\ndata file: b.raw\n"))) == ramp<std::int32_t>());
  CHECK_THAT(refusal([&] { read_image(scratch.write("c.nhdr", start + "encoding: raw\ndata file: c.raw\n")); }),
             ContainsSubstring("that holds its values is not there"));
  CHECK_THAT(refusal([&] { parse(start + "encoding: raw\ndata file: ../b.raw\n"); }), ContainsSubstring("beside the header"));
  CHECK_THAT(refusal([&] { parse(start + "encoding: bzip2\n\n" + values); }), ContainsSubstring("known are raw and gzip"));
  CHECK_THAT(refusal([&] { parse("NRRD0004\ntype: uchar\ndimension: 4\nsizes: 3 4 3 2\nencoding: raw\n\n"); }),
             ContainsSubstring("three dimensions"));
  check_hostile(start + place + "encoding: raw\n\n" + values, 200, parse);
}

TEST_CASE("MetaImages are read, attached and beside their header") {
  const std::string start =
      "ObjectType = Image\nNDims = 3\nBinaryData = True\nBinaryDataByteOrderMSB = False\n"
      "TransformMatrix = 0 1 0 -1 0 0 0 0 1\nOffset = 1 2 3\nElementSpacing = 0.5 1 2\nDimSize = 4 3 2\nElementType = "
      "MET_SHORT\n";
  const std::string values = bytes_of(ramp<std::int16_t>(), std::endian::little);
  const auto parse = [](const std::string& bytes) { return parse_meta_image(bytes, no_file, "a.mha"); };
  const ImageFile raw = parse(start + "ElementDataFile = LOCAL\n" + values);
  CHECK(values_of<std::int32_t>(raw) == ramp<std::int32_t>());
  CHECK(squared_distance(grid_of(raw.image).world({2, 1, 1}), Point3{0, 3, 5}) < 1e-24);
  CHECK(values_of<std::int32_t>(parse(start + "CompressedData = True\nElementDataFile = LOCAL\n" + deflated(values, 15))) ==
        ramp<std::int32_t>());
  const Scratch scratch;
  scratch.write("b.raw", values);
  CHECK(values_of<std::int32_t>(read_image(scratch.write("b.mhd", start + "ElementDataFile = b.raw\n"))) == ramp<std::int32_t>());
  CHECK_THAT(refusal([&] { parse(start + "ElementDataFile = /b.raw\n"); }), ContainsSubstring("beside the header"));
  CHECK_THAT(refusal([&] { parse(start + "ElementNumberOfChannels = 3\nElementDataFile = LOCAL\n" + values); }),
             ContainsSubstring("several values per voxel"));
  check_hostile(start + "ElementDataFile = LOCAL\n" + values, 200, parse);
}

TEST_CASE("files that are no images are refused by name") {
  CHECK_THAT(refusal([] { read_image("a.png"); }), ContainsSubstring("\".png\" is not the extension of an image"));
  CHECK_THAT(refusal([] { read_image("nowhere.inr"); }), ContainsSubstring("there is no such file"));
  CHECK(is_image_file("a/B.NII.gz"));
  CHECK_FALSE(is_image_file("a.vtu"));
  CHECK_FALSE(is_image_file("a.gz"));
}
