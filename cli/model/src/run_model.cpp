// SPDX-License-Identifier: Apache-2.0
#include "skein/model_tool/run_model.hpp"

#include <algorithm>
#include <memory>
#include <ostream>

#include "line.hpp"
#include "skein/config/parse.hpp"
#include "skein/config/reader.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/joined.hpp"
#include "skein/interaction/engine.hpp"
#include "skein/interaction/read_automaton.hpp"
#include "skein/model_tool/load_models.hpp"
#include "skein/trace_lines/read_lines.hpp"

namespace skein::model_tool {

namespace {

using interaction::Automaton;

tl::unexpected<Diagnostics> wrong(const std::string& file, std::string message,
                                  std::string expected) {
  Diagnostics problems;
  problems.add({file, 0, 0, "", std::move(message), std::move(expected), ""});
  return tl::unexpected<Diagnostics>(std::move(problems));
}

// As it is played in the first variant that has the role; in none, as it is by itself.
Automaton as_played(const interaction::Library& library, const std::string& role) {
  for (const auto& [task, model] : library.models) {
    for (const interaction::Variant& variant : model.variants) {
      const auto& roles = variant.roles;
      if (std::find(roles.begin(), roles.end(), role) == roles.end()) continue;
      return automaton_in(library, variant, role);
    }
  }
  return library.roles.at(role).automaton;
}

Result<Automaton, Diagnostics> role_of(const RunOptions& options) {
  auto loaded = load_models({options.automaton});
  if (!loaded) return tl::unexpected<Diagnostics>(std::move(loaded.error()));
  const auto& roles = loaded->library.roles;
  std::string role = options.role;
  if (role.empty() && roles.size() == 1) role = roles.begin()->first;
  if (roles.count(role) > 0) return as_played(loaded->library, role);
  std::string names;
  for (const auto& [name, one] : roles) names += (names.empty() ? "" : ", ") + name;
  return wrong(options.automaton, role.empty() ? "several roles" : "unknown role '" + role + "'",
               "--role with one of " + names);
}

// Conditions that name parameters get their seconds.
Result<Automaton, Diagnostics> with_set(Automaton automaton, const RunOptions& options) {
  const std::set<std::string> named = named_times(automaton);
  const std::string names = joined({named.begin(), named.end()}, ", ");
  for (const auto& [name, seconds] : options.set) {
    if (!named.contains(name))
      return wrong(options.automaton, "no condition on time names '" + name + "'",
                   named.empty() ? "no --set" : "--set with one of " + names);
  }
  automaton = with_times(std::move(automaton), options.set);
  for (const std::string& name : named_times(automaton))
    return wrong(options.automaton, "a condition names the parameter '" + name + "'",
                 "--set " + name + "=SECONDS");
  return automaton;
}

// A file that is one block, or a role of a library.
Result<Automaton, Diagnostics> automaton_of(const RunOptions& options) {
  const std::string& file = options.automaton;
  const auto value = config::parse_yaml_file(file);
  if (!value) return tl::unexpected<Diagnostics>(value.error());
  if (value->find("roles") != nullptr || value->find("models") != nullptr) return role_of(options);
  Diagnostics problems;
  Automaton automaton = interaction::read_automaton(config::Reader(*value, file, problems));
  if (!problems.empty()) return tl::unexpected<Diagnostics>(std::move(problems));
  if (options.role.empty()) return automaton;
  return wrong(file, "an automaton has no roles", "no --role");
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
  auto automaton = automaton_of(options);
  if (automaton) automaton = with_set(std::move(*automaton), options);
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
