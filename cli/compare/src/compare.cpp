// SPDX-License-Identifier: Apache-2.0
#include "skein/compare_tool/compare.hpp"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <nlohmann/json.hpp>
#include <ostream>
#include <sstream>

#include "comparison.hpp"
#include "skein/foundation/exit_code.hpp"
#include "skein/foundation/rounded_seconds.hpp"

namespace skein::compare_tool {

namespace {

using Json = nlohmann::ordered_json;
using recording::Run;

constexpr std::size_t kShown = 12;  ///< of each section

std::string number(double value) {
  std::ostringstream text;
  text << std::setprecision(9) << value;
  return text.str();
}

std::string to_text(const std::optional<Fact>& fact) {
  if (!fact) return "-";
  std::string text = fact->value ? number(*fact->value) + " " + fact->text : fact->text;
  if (fact->at)
    text += (text.empty() ? "at " : " at ") + in_seconds(MissionTime::seconds(*fact->at));
  return text;
}

/// " (+4.8 s)" of facts that say the same at other times or in other figures.
std::string gap(const Difference& one) {
  if (!one.first || !one.second || one.first->text != one.second->text) return "";
  const auto both = [&](auto member) {
    return one.first.value().*member && one.second.value().*member;
  };
  std::ostringstream text;
  text << std::showpos << std::setprecision(6);
  if (both(&Fact::at)) {
    text << " (" << *one.second->at - *one.first->at << " s)";
  } else if (both(&Fact::value)) {
    text << " (" << *one.second->value - *one.first->value << ")";
  }
  return text.str();
}

std::string about(const Run& run) {
  return run.folder + ": " + run.info.scenario + ", seed " + std::to_string(run.info.seed) + ", " +
         (run.info.runtime == report::RuntimeKind::kVirtual ? "virtual" : "over DDS") + ", " +
         std::to_string(run.records.size()) + " lines, Skein " + run.info.version;
}

void print_section(const SectionDifference& section, bool all, std::ostream& out) {
  if (section.differences.empty()) return;
  out << section.name << ": " << section.differences.size() << " of " << section.facts
      << " differ\n";
  const std::size_t shown =
      all ? section.differences.size() : std::min(kShown, section.differences.size());
  for (std::size_t i = 0; i < shown; ++i) {
    const Difference& one = section.differences[i];
    out << "  " << one.name << "\n    A: " << to_text(one.first)
        << "\n    B: " << to_text(one.second) << gap(one) << '\n';
  }
  if (shown < section.differences.size())
    out << "  and " << section.differences.size() - shown << " more (--all)\n";
}

void print(const Run& a, const Run& b, const Comparison& comparison, const CompareOptions& options,
           std::ostream& out) {
  out << "A: " << about(a) << "\nB: " << about(b) << '\n';
  if (comparison.same_bytes) {
    out << "same to the byte\n";
    return;
  }
  for (const SectionDifference& section : comparison.sections)
    print_section(section, options.all, out);
  if (comparison.same_facts())
    out << "the same in outcome, expectations, measures, goals, tasks and decisions\n";
  const Divergence& apart = *comparison.divergence;
  out << "the event logs part in line " << apart.line
      << "\n  A: " << apart.first.value_or("(ended)")
      << "\n  B: " << apart.second.value_or("(ended)") << '\n';
}

Json json_of(const std::optional<Fact>& fact) {
  if (!fact) return nullptr;
  Json json{{"text", fact->text}};
  if (fact->at) json["at"] = *fact->at;
  if (fact->value) json["value"] = *fact->value;
  return json;
}

Json json_of(const Run& run) {
  return {
      {"folder", run.folder},        {"scenario", run.info.scenario},
      {"seed", run.info.seed},       {"virtual", run.info.runtime == report::RuntimeKind::kVirtual},
      {"version", run.info.version}, {"lines", run.records.size()}};
}

template <class Text>
Json or_null(const std::optional<Text>& text) {
  return text ? Json(*text) : Json();
}

void print_json(const Run& a, const Run& b, const Comparison& comparison, bool same,
                std::ostream& out) {
  Json json{{"same", same},
            {"same_bytes", comparison.same_bytes},
            {"a", json_of(a)},
            {"b", json_of(b)},
            {"differences", Json::object()}};
  for (const SectionDifference& section : comparison.sections) {
    Json& all = json["differences"][section.name] = Json::array();
    for (const Difference& one : section.differences)
      all.push_back({{"name", one.name}, {"a", json_of(one.first)}, {"b", json_of(one.second)}});
  }
  if (const auto& apart = comparison.divergence)
    json["divergence"] = {
        {"line", apart->line}, {"a", or_null(apart->first)}, {"b", or_null(apart->second)}};
  out << json.dump(2, ' ', false, Json::error_handler_t::replace) << '\n';
}

/// Both folders, or every reason why not; a damaged log cannot be compared.
std::optional<std::pair<Run, Run>> read_both(const CompareOptions& options, std::ostream& err) {
  auto first = recording::read_run(options.first);
  auto second = recording::read_run(options.second);
  bool good = true;
  for (const auto* one : {&first, &second}) {
    const Diagnostics& wrong = one->has_value() ? (*one)->damaged : one->error();
    err << skein::to_text(wrong);
    good = good && wrong.empty();
  }
  if (!good) return std::nullopt;
  return std::pair(std::move(*first), std::move(*second));
}

}  // namespace

int compare(const CompareOptions& options, std::ostream& out, std::ostream& err) {
  const auto both = read_both(options, err);
  if (!both) return kExitBadInput;
  const Comparison comparison = compared(both->first, both->second, options.within.value_or(0));
  const bool same = comparison.same_bytes || (options.within && comparison.same_facts());
  if (options.json) {
    print_json(both->first, both->second, comparison, same, out);
  } else {
    print(both->first, both->second, comparison, options, out);
  }
  return same ? kExitOk : kExitNegative;
}

}  // namespace skein::compare_tool
