// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whole files in, whole files out. A file is read in one go, since every reader here works on text in memory; a file is written
// aside and renamed when it is complete, so that whoever finds it by its name finds all of it.
#pragma once

#include <cerrno>
#include <concepts>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>
#include <string>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include <delref/core/budget.hpp>
#include <delref/domain/invalid_input.hpp>
#include <delref/io/text_sink.hpp>

namespace delref {

/// Files larger than this are refused: no index of a mesh in them would fit 32 bits.
inline constexpr std::uintmax_t largest_file = std::uintmax_t{64} << 30;

namespace detail {

struct CloseFile {
  // Of a file that was read, or is given up: `OutputFile::commit` closes the others itself, and looks.
  void operator()(std::FILE* file) const { static_cast<void>(std::fclose(file)); }
};
using FileHandle = std::unique_ptr<std::FILE, CloseFile>;

inline std::string system_message(int error) { return std::generic_category().message(error); }

}  // namespace detail

/// The bytes of a file.
/// Throws `InvalidInput` saying why when there is no such file, it is a directory, it cannot be read, or it is larger than
/// `largest_file`; `Interrupted` when the control says stop.
inline std::string read_file(const std::filesystem::path& path, const Control& control = Control{}) {
  const std::string name = path.string();
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  if (status.type() == std::filesystem::file_type::not_found) throw InvalidInput(fmt::format("{}: there is no such file", name));
  if (std::filesystem::is_directory(status)) throw InvalidInput(fmt::format("{}: is a directory, not a file", name));
  const detail::FileHandle file(std::fopen(name.c_str(), "rb"));
  if (!file) throw InvalidInput(fmt::format("{}: cannot be opened: {}", name, detail::system_message(errno)));
  std::string bytes;
  if (std::filesystem::is_regular_file(status)) {
    const auto size = std::filesystem::file_size(path, error);
    if (!error && size > largest_file) {
      throw InvalidInput(fmt::format("{}: has {} bytes; more than {} are not read", name, size, largest_file));
    }
    if (!error) bytes.reserve(size + 1);
  }
  constexpr std::size_t chunk = std::size_t{1} << 20;
  for (std::size_t got = chunk, size = 0; got == chunk; size += got, bytes.resize(size)) {
    throw_if_stopped(control);
    if (size > largest_file) throw InvalidInput(fmt::format("{}: more than {} bytes are not read", name, largest_file));
    bytes.resize(size + chunk);
    got = std::fread(bytes.data() + size, 1, chunk, file.get());
  }
  if (std::ferror(file.get()) != 0) throw InvalidInput(fmt::format("{}: cannot be read to its end", name));
  return bytes;
}

/// Thrown when a file cannot be written. What was there before, if anything, is still there. `what()` names file and reason.
class OutputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

namespace detail {

/// The file that is meant by a path: a symbolic link to a regular file is followed.
inline std::filesystem::path link_target(const std::filesystem::path& path) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(path, error)) return path;
  std::filesystem::path target = std::filesystem::canonical(path, error);
  return error ? path : target;
}

}  // namespace detail

/// Where the text of a file stands until it is complete.
inline std::filesystem::path partial_path(const std::filesystem::path& path) {
  std::filesystem::path partial = detail::link_target(path);
  partial += ".partial";
  return partial;
}

/// A file in the making: `sink()` takes its text, `commit()` gives it its name. Without `commit` nothing remains of it.
///
/// The text goes to `PATH.partial` beside it first. What is not a regular file (a pipe, `/dev/stdout`) is written directly.
/// A symbolic link is followed. Every failure is thrown as `OutputError`. The control is asked with every piece of some 256 KiB that
/// is handed on; when it says stop, `Interrupted` is thrown out of `sink()`.
///
/// This guards against a program that ends in between, not against a machine that does: nothing waits for the disk (fsync) before the
/// renaming. That would take seconds for a large mesh, while a stopped run is to end promptly, and file systems in common use write the
/// text of a file that is renamed over another one before they record its new name.
class OutputFile {
 public:
  explicit OutputFile(const std::filesystem::path& path, const Control& control = Control{})
      : path_(detail::link_target(path)), control_(control) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (std::filesystem::is_directory(status)) throw OutputError(fmt::format("{}: is a directory, not a file", path.string()));
    direct_ = std::filesystem::exists(status) && !std::filesystem::is_regular_file(status);
    partial_ = direct_ ? path_ : partial_path(path_);
    file_.reset(std::fopen(partial_.string().c_str(), "wb"));
    if (!file_) throw OutputError(fmt::format("{}: cannot be written: {}", partial_.string(), detail::system_message(errno)));
    sink_ = std::make_unique<TextSink>([this](std::string_view text) { put(text); });
  }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() {
    if (!file_) return;
    file_.reset();
    std::error_code ignored;
    if (!direct_) std::filesystem::remove(partial_, ignored);
  }

  TextSink& sink() { return *sink_; }

  /// Writes what is left and gives the file its name.
  void commit() {
    sink_->flush();
    if (std::fclose(file_.release()) != 0) fail(errno);
    if (direct_) return;
    std::error_code error;
    std::filesystem::rename(partial_, path_, error);
    if (error) fail(error.value());
  }

 private:
  void put(std::string_view text) {
    throw_if_stopped(control_);
    if (std::fwrite(text.data(), 1, text.size(), file_.get()) != text.size()) {
      throw OutputError(fmt::format("{}: cannot be written: {}", path_.string(), detail::system_message(errno)));
    }
  }
  [[noreturn]] void fail(int error) {
    std::error_code ignored;
    if (!direct_) std::filesystem::remove(partial_, ignored);
    throw OutputError(fmt::format("{}: cannot be written: {}", path_.string(), detail::system_message(error)));
  }

  std::filesystem::path path_, partial_;
  Control control_;
  bool direct_ = false;
  detail::FileHandle file_;
  std::unique_ptr<TextSink> sink_;
};

/// Writes the file that `writer(TextSink&)` writes, all of it or (when anything throws) nothing. Throws `OutputError`, and
/// `Interrupted` when the control says stop.
template <std::invocable<TextSink&> Writer>
void write_file(const std::filesystem::path& path, Writer&& writer, const Control& control = Control{}) {
  OutputFile file(path, control);
  std::forward<Writer>(writer)(file.sink());
  file.commit();
}

}  // namespace delref
