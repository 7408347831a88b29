// SPDX-License-Identifier: Apache-2.0
#include "log_line.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>

#include "skein/foundation/overloaded.hpp"

namespace skein::daemon_main {

namespace {

using journal::Record;
using journal::Value;

/// {key} stands for a field, {key?yes|no} for one of two words. Kinds that are not here are told
/// field by field.
struct Sentence {
  std::string_view kind, words;
};
constexpr std::array kSentences = {
    Sentence{"mission", "mission {state}"},
    Sentence{"phase", "phase {name}"},
    Sentence{"step", "step {name}"},
    Sentence{"operator", "operator {does}"},
    Sentence{"command", "command {command} to {uav}: {what}: {state}"},
    Sentence{"request", "{request} {task}: {accepted?accepted|refused}"},
    Sentence{"task", "{type} {task} {state}"},
    Sentence{"functional", "vehicle {uav}: {type} {task} {state}"},
    Sentence{"sync", "synchronisation {id} {direction}"},
    Sentence{"degree", "degree {degree}"},
    Sentence{"goal", "goal {goal} {statement}: {state}"},
    Sentence{"plan", "plan {revision}: {tasks} tasks for {goals} goals"},
    Sentence{"planned", "planned {type} {task} for goal {goal}"},
    Sentence{"decision", "decision {number}, {operator}: {cause}: {outcome}"},
    Sentence{"answer", "mission {mission}: {planned?planned|not planned}"},
    Sentence{"contact", "contact lost: {policy}"},
    Sentence{"notice", "{text}"},
    Sentence{"alarm", "alarm {alarm} {state}"},
    Sentence{"perception", "{device} of {uav} sees {detections}"},
    Sentence{"message", "{direction} {slot} {sequence} from {from} to {to}"},
    Sentence{"reach", "{peer} {reachable?can be reached|cannot be reached}"},
    Sentence{"link", "radio from {from} to {to} {up?up|down}"},
    Sentence{"dropped", "{slot} of {origin} refused: {field}: {why}"},
    Sentence{"transport", "DDS refuses, on channel {channel}: {why}"},
    Sentence{"unsent", "{slot} to {to} not sent: {why}"},
};

std::string text_of(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", number);
  std::string all = text;
  all.erase(all.find_last_not_of('0') + 1);
  if (all.back() == '.') all.pop_back();
  return all;
}

std::string text_of(const Value& value) {
  return std::visit(Overloaded{[](bool one) { return std::string(one ? "yes" : "no"); },
                               [](std::int64_t one) { return std::to_string(one); },
                               [](double one) { return text_of(one); },
                               [](const std::string& one) { return one; },
                               [](const std::vector<double>& all) {
                                 std::string text;
                                 for (const double one : all)
                                   text += (text.empty() ? "" : " ") + text_of(one);
                                 return text;
                               }},
                    value);
}

/// The place at `open` of the words, filled; `said` gets its key.
std::string filled(const Record& record, std::string_view place, std::set<std::string>& said) {
  const std::size_t question = place.find('?');
  const std::string key(place.substr(0, question));
  const Value* value = record.find(key);
  if (value == nullptr) return {};
  said.insert(key);
  if (question == std::string_view::npos) return text_of(*value);
  const std::string_view words = place.substr(question + 1);
  const std::size_t bar = words.find('|');
  return std::string(record.truth(key) ? words.substr(0, bar) : words.substr(bar + 1));
}

std::string sentence(const Record& record, std::set<std::string>& said) {
  const auto found = std::find_if(kSentences.begin(), kSentences.end(),
                                  [&](const Sentence& one) { return one.kind == record.kind(); });
  if (found == kSentences.end()) return record.kind();
  std::string text;
  std::string_view rest = found->words;
  while (!rest.empty()) {
    const std::size_t open = rest.find('{');
    text += rest.substr(0, open);
    if (open == std::string_view::npos) break;
    const std::size_t close = rest.find('}', open);
    const std::string word = filled(record, rest.substr(open + 1, close - open - 1), said);
    if (word.empty() && !text.empty() && text.back() == ' ') text.pop_back();
    text += word;
    rest.remove_prefix(close + 1);
    if (word.empty() && text.ends_with(':') && rest.starts_with(':')) rest.remove_prefix(1);
  }
  return text;
}

}  // namespace

std::string log_line(const Record& record) {
  std::set<std::string> said;
  std::string line = "[" + to_clock_text(record.at()) + "] " + sentence(record, said);
  std::string more;
  for (const auto& [key, value] : record.fields()) {
    const bool itself = key == "uav" && text_of(value) == record.node();
    const std::string text = text_of(value);
    if (said.count(key) > 0 || itself || text.empty()) continue;
    more += (more.empty() ? " (" : ", ") + key + " " + text;
  }
  return line + (more.empty() ? "" : more + ")");
}

}  // namespace skein::daemon_main
