// SPDX-License-Identifier: Apache-2.0
#include "file_text.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>

namespace skein::plan_tool {

namespace {

namespace fs = std::filesystem;

Result<std::string, Failure> rest_of(std::istream& in) {
  std::string text(std::istreambuf_iterator<char>(in), {});
  if (in.bad()) return failure("cannot be read");
  return text;
}

}  // namespace

Result<std::string, Failure> text_of_file(const std::string& file, std::istream& in) try {
  if (file == "-") return rest_of(in);
  std::error_code error;
  const fs::file_status status = fs::status(file, error);
  if (!fs::exists(status)) return failure("there is no such file");
  if (fs::is_directory(status)) return failure("is a folder, not a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return failure("cannot be read");
  if (!fs::is_regular_file(status)) return rest_of(stream);
  std::string text(fs::file_size(file), '\0');
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
} catch (const std::exception&) {  // of the standard library's streams and paths
  return failure("cannot be read");
}

}  // namespace skein::plan_tool
