// SPDX-License-Identifier: Apache-2.0
#include "stn_file.hpp"

#include <fstream>
#include <istream>
#include <ostream>

#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/nearest.hpp"
#include "write_file.hpp"

namespace skein::temporal_tool {

namespace {

bool from_standard_input(const StnOptions& options) {
  return options.file.empty() || options.file == "-";
}

// A little more than is read, so that the reader can refuse it. What cannot be read (a directory)
// may show as an exception of the stream buffer.
std::optional<std::string> all_of(std::istream& in) {
  try {
    std::string text;
    std::string block(1U << 16U, '\0');
    while (in.good() && text.size() <= temporal::kLongestText) {
      in.read(block.data(), static_cast<std::streamsize>(block.size()));
      text.append(block, 0, static_cast<std::size_t>(in.gcount()));
    }
    if (in.bad()) return std::nullopt;
    return text;
  } catch (const std::ios_base::failure&) {
    return std::nullopt;
  }
}

std::optional<std::string> text_of(const StnOptions& options, std::istream& in) {
  return from_standard_input(options) ? all_of(in) : text_of_file(options.file);
}

}  // namespace

std::optional<std::string> text_of_file(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  return in ? all_of(in) : std::nullopt;
}

std::optional<temporal::Format> format_option(const std::string& name, std::ostream& err) {
  const std::optional<temporal::Format> format = temporal::format_named(name);
  if (format) return format;
  err << "--to: unknown format '" << name << "'"
      << did_you_mean(nearest_name(name, temporal::format_names())) << '\n';
  return std::nullopt;
}

std::string input_name(const StnOptions& options) {
  return from_standard_input(options) ? "standard input" : options.file;
}

std::optional<temporal::ReadNetwork> load_network(const StnOptions& options, std::istream& in,
                                                  std::ostream& err) {
  const std::optional<std::string> text = text_of(options, in);
  if (!text) {
    err << input_name(options) << ": cannot be read\n";
    return std::nullopt;
  }
  Result<temporal::ReadNetwork, Diagnostics> read =
      temporal::read_network(*text, input_name(options));
  if (!read) {
    err << to_text(read.error());
    return std::nullopt;
  }
  err << to_text(read->warnings);
  if (options.z_first) temporal::put_origin_first(read->network);
  return std::move(*read);
}

int save_text(const std::string& file, const std::string& text, std::ostream& out,
              std::ostream& err) {
  if (file.empty() || file == "-") {
    out << text;
    return kExitOk;
  }
  const std::optional<Failure> problem = write_file(file, text);
  if (problem) err << file << ": " << problem->why << '\n';
  return problem ? kExitSystem : kExitOk;
}

}  // namespace skein::temporal_tool
