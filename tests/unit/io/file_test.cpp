// SPDX-License-Identifier: GPL-3.0-or-later
#include <limits>
#include <stop_token>

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_exception.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

#include <delref/io/base64.hpp>
#include <delref/io/file.hpp>

#include "scratch.hpp"

using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::MessageMatches;
using delref_test::Scratch;

TEST_CASE("what is written is read again, byte by byte") {
  const Scratch folder;
  std::string text(3'000'000, 'x');
  text += std::string("\0\r\n end", 7);
  delref::write_file(folder / "a", [&](delref::TextSink& out) { out << text; });
  CHECK(delref::read_file(folder / "a") == text);
  CHECK_FALSE(std::filesystem::exists(folder / "a.partial"));
}

TEST_CASE("files that cannot be read say why") {
  const Scratch folder;
  CHECK_THROWS_MATCHES(delref::read_file(folder / "none"), delref::InvalidInput, MessageMatches(ContainsSubstring("there is no such file")));
  CHECK_THROWS_MATCHES(delref::read_file(folder / ""), delref::InvalidInput, MessageMatches(ContainsSubstring("is a directory")));
}

TEST_CASE("reading stops when the token says so") {
  const Scratch folder;
  std::stop_source source;
  source.request_stop();
  CHECK_THROWS_AS(delref::read_file(folder.write("a", "text"), delref::Control({}, source.get_token())), delref::Interrupted);
}

TEST_CASE("a writer that fails leaves the old file and nothing else") {
  const Scratch folder;
  folder.write("a", "old");
  CHECK_THROWS_AS(delref::write_file(folder / "a",
                                     [](delref::TextSink& out) {
                                       out << std::string(1'000'000, 'n');
                                       throw std::runtime_error("no");
                                     }),
                  std::runtime_error);
  CHECK(delref::read_file(folder / "a") == "old");
  CHECK_FALSE(std::filesystem::exists(folder / "a.partial"));
}

TEST_CASE("files that cannot be written say why") {
  const Scratch folder;
  const auto nothing = [](delref::TextSink&) {};
  CHECK_THROWS_MATCHES(delref::write_file(folder / "no/such/folder", nothing), delref::OutputError, MessageMatches(ContainsSubstring("cannot be written")));
  CHECK_THROWS_MATCHES(delref::write_file(folder / "", nothing), delref::OutputError, MessageMatches(ContainsSubstring("is a directory")));
  if (std::filesystem::exists("/dev/full")) {
    CHECK_THROWS_MATCHES(delref::write_file("/dev/full", [](delref::TextSink& out) { out << "text"; }), delref::OutputError,
                         MessageMatches(ContainsSubstring("cannot be written")));
  }
}

TEST_CASE("a symbolic link is followed, not replaced") {
  const Scratch folder;
  folder.write("target", "old");
  std::filesystem::create_symlink(folder / "target", folder / "link");
  delref::write_file(folder / "link", [](delref::TextSink& out) { out << "new"; });
  CHECK(std::filesystem::is_symlink(folder / "link"));
  CHECK(delref::read_file(folder / "target") == "new");
}

TEST_CASE("doubles are written with the fewest digits that read back") {
  std::string text;
  delref::TextSink out([&](std::string_view piece) { text += piece; });
  for (const double value : {0.1, 1.0 / 3, -0.0, 1e22, 5e-324, 1e150, std::numeric_limits<double>::infinity()}) out << value << ' ';
  out << 42 << ' ' << -7 << 'c';
  out.flush();
  CHECK(text == "0.1 0.3333333333333333 -0 1e+22 5e-324 1e+150 inf 42 -7c");
}

TEST_CASE("base64 is as in RFC 4648, and padding may stand inside") {
  std::string text;
  delref::TextSink out([&](std::string_view piece) { text += piece; });
  for (const std::string_view word : {"", "f", "fo", "foo", "foob"}) {
    delref::Base64Writer bytes(out);
    for (const char c : word) bytes.put(c);
    bytes.finish();
    out << ' ';
  }
  out.flush();
  CHECK(text == " Zg== Zm8= Zm9v Zm9vYg== ");
  CHECK(delref::decode_base64("Zg==Zm9v\n") == "ffoo");
  CHECK(delref::decode_base64("Zm9vYmFy", 4) == "foob");
  CHECK_FALSE(delref::decode_base64("Zm9").has_value());
  CHECK_FALSE(delref::decode_base64("Zm9v*").has_value());
  CHECK_FALSE(delref::decode_base64("Z===").has_value());
}
