// SPDX-License-Identifier: Apache-2.0
#include "skein/mle_tool/mle.hpp"

#include <fstream>
#include <istream>
#include <iterator>
#include <ostream>

#include "line.hpp"
#include "skein/executive/executive.hpp"
#include "skein/foundation/diagnostics.hpp"
#include "skein/trace_lines/read_lines.hpp"

namespace skein::mle_tool {

namespace {

/// The replay: an executive, the present instant, and where its effects are written.
class Replay {
 public:
  Replay(executive::Config config, std::string input_name, std::ostream& out, std::ostream& err)
      : executive_(std::move(config)), input_name_(std::move(input_name)), out_(out), err_(err) {}

  void line(std::size_t number, const std::string& text) {
    const Result<TraceLine, Failure> line = read_line(text);
    if (!line) return wrong(number, line.error().why);
    if (last_ && line->at < *last_) {
      return wrong(number, "at: " + to_text(line->at) + " is before " + to_text(*last_));
    }
    pass_until(line->at);
    last_ = line->at;
    write(executive_.handle(line->input, line->at), line->at);
  }

  void wrong(std::size_t number, const std::string& why) {
    out_ << wrong_line(last_.value_or(MissionTime()), number, why) << '\n';
    err_ << input_name_ << ':' << number << ": " << why << '\n';
    any_wrong_ = true;
  }

  // Instants between lines pass one at a time, so that what happens then bears its own instant.
  void pass_until(MissionTime end) {
    for (auto next = executive_.next_wakeup(); next && *next <= end;
         next = executive_.next_wakeup()) {
      write(executive_.handle(executive::Tick{}, *next), *next);
    }
  }

  bool any_wrong() const { return any_wrong_; }

 private:
  void write(const executive::Effects& effects, MissionTime at) {
    for (const executive::Effect& effect : effects) {
      if (const auto line = to_line(effect, at)) out_ << *line << '\n';
      if (const auto* notice = std::get_if<executive::Notice>(&effect)) {
        err_ << "at " << to_text(at) << ": " << notice->text << '\n';
      }
    }
  }

  executive::Executive executive_;
  std::string input_name_;
  std::optional<MissionTime> last_;
  bool any_wrong_ = false;
  std::ostream& out_;
  std::ostream& err_;
};

Result<executive::TypeTable, Failure> types_from(const std::string& file) {
  if (file.empty()) return executive::TypeTable::elementary();
  try {
    std::ifstream in(file, std::ios::binary);
    if (!in) return failure("cannot be read");
    return read_types(std::string(std::istreambuf_iterator<char>(in), {}));
  } catch (const std::ios_base::failure&) {
    return failure("cannot be read");
  }
}

}  // namespace

int run_mle(const MleOptions& options, std::istream& in, std::ostream& out, std::ostream& err) {
  const Result<executive::TypeTable, Failure> types = types_from(options.types_file);
  if (!types) {
    err << options.types_file << ": " << types.error().why << '\n';
    return 2;
  }
  if (options.timeout && *options.timeout <= Duration()) {
    err << "--timeout: " << to_text(*options.timeout) << " s is not positive\n";
    return 2;
  }
  if (options.sync_validity && *options.sync_validity <= Duration()) {
    err << "--sync-validity: " << to_text(*options.sync_validity) << " s is not positive\n";
    return 2;
  }
  executive::Config config;
  config.sync_validity = options.sync_validity;
  config.name = options.uav;
  config.types = *types;
  config.background_type = options.background;
  config.functional_timeout = options.timeout;
  const std::string name = options.input_name.empty() ? "standard input" : options.input_name;
  Replay replay(std::move(config), name, out, err);
  const bool whole = trace_lines::read_lines(
      in, out, [&](std::size_t number, const std::string& text) { replay.line(number, text); },
      [&](std::size_t number, const std::string& why) { replay.wrong(number, why); });
  if (!whole) {
    err << name << ": cannot be read\n";
    return 2;
  }
  if (options.until) replay.pass_until(*options.until);
  out.flush();
  return replay.any_wrong() ? 1 : 0;
}

}  // namespace skein::mle_tool
