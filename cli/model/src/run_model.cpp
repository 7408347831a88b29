// SPDX-License-Identifier: Apache-2.0
#include "skein/model_tool/run_model.hpp"

#include <memory>
#include <ostream>

#include "line.hpp"
#include "skein/config/parse.hpp"
#include "skein/config/reader.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/interaction/engine.hpp"
#include "skein/interaction/read_automaton.hpp"
#include "skein/trace_lines/read_lines.hpp"

namespace skein::model_tool {

namespace {

using interaction::Automaton;

Result<Automaton, Diagnostics> automaton_of(const std::string& file) {
  const auto value = config::parse_yaml_file(file);
  if (!value) return tl::unexpected<Diagnostics>(value.error());
  Diagnostics problems;
  Automaton automaton = interaction::read_automaton(config::Reader(*value, file, problems));
  if (!problems.empty()) return tl::unexpected<Diagnostics>(std::move(problems));
  return automaton;
}

/// The engine, and where its effects are written.
class Play {
 public:
  Play(Automaton automaton, std::string input_name, std::ostream& out, std::ostream& err)
      : engine_(std::make_shared<const Automaton>(std::move(automaton))),
        input_name_(std::move(input_name)),
        out_(out),
        err_(err) {}

  void line(std::size_t number, const std::string& text) {
    const Result<TraceLine, Failure> line = read_line(text);
    if (!line) return wrong(number, line.error().why);
    const auto effects = engine_.handle(line->input, line->at);
    if (!effects) return wrong(number, effects.error().why);
    last_ = line->at;
    write(*effects);
  }

  void wrong(std::size_t number, const std::string& why) {
    out_ << refused_line(number, why) << '\n';
    err_ << input_name_ << ':' << number << ": " << why << '\n';
    any_wrong_ = true;
  }

  void until(MissionTime end) {
    if (last_ && end < *last_) return;
    if (const auto effects = engine_.handle(interaction::Tick{}, end)) write(*effects);
  }

  bool any_wrong() const { return any_wrong_; }

 private:
  void write(const interaction::Effects& effects) {
    for (const interaction::Effect& effect : effects) out_ << to_line(effect) << '\n';
  }

  interaction::Engine engine_;
  std::string input_name_;
  std::optional<MissionTime> last_;
  bool any_wrong_ = false;
  std::ostream& out_;
  std::ostream& err_;
};

}  // namespace

int run_model(const RunOptions& options, std::istream& in, std::ostream& out, std::ostream& err) {
  auto automaton = automaton_of(options.automaton);
  if (!automaton) {
    err << to_text(automaton.error());
    return kExitBadInput;
  }
  const std::string name = options.input_name.empty() ? "standard input" : options.input_name;
  Play play(std::move(*automaton), name, out, err);
  const bool whole = trace_lines::read_lines(
      in, out, [&](std::size_t number, const std::string& text) { play.line(number, text); },
      [&](std::size_t number, const std::string& why) { play.wrong(number, why); });
  if (!whole) {
    err << name << ": cannot be read\n";
    return kExitBadInput;
  }
  if (options.until) play.until(*options.until);
  out.flush();
  return play.any_wrong() ? kExitNegative : kExitOk;
}

}  // namespace skein::model_tool
