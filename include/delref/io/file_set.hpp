// SPDX-License-Identifier: GPL-3.0-or-later
//
// Several files that belong together, as a mesh of Triangle or TetGen does: all of them or none.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <utility>

#include <delref/core/budget.hpp>
#include <delref/io/file.hpp>
#include <delref/io/text_sink.hpp>

namespace delref {

/// The files of one stem with these extensions, whatever the path's own.
template <std::size_t Count>
std::array<std::filesystem::path, Count> files_of_stem(const std::filesystem::path& path, const char* const (&extensions)[Count]) {
  std::array<std::filesystem::path, Count> files;
  for (std::size_t i = 0; i != Count; ++i) files[i] = std::filesystem::path(path).replace_extension(extensions[i]);
  return files;
}

/// Writes the files that `writer(sinks)` writes, where `sinks[i]` takes the text of `paths[i]`. None of them gets its name before all
/// of them are complete. Throws `OutputError`, and `Interrupted` when the control says stop.
template <std::size_t Count, std::invocable<const std::array<TextSink*, Count>&> Writer>
void write_file_set(const std::array<std::filesystem::path, Count>& paths, Writer&& writer, const Control& control = Control{}) {
  std::array<std::unique_ptr<OutputFile>, Count> files;
  std::array<TextSink*, Count> sinks{};
  for (std::size_t i = 0; i != Count; ++i) {
    files[i] = std::make_unique<OutputFile>(paths[i], control);
    sinks[i] = &files[i]->sink();
  }
  std::forward<Writer>(writer)(std::as_const(sinks));
  for (TextSink* sink : sinks) sink->flush();
  for (const auto& file : files) file->commit();
}

}  // namespace delref
