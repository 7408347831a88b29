// SPDX-License-Identifier: Apache-2.0
#include "statement.hpp"

#include <charconv>
#include <sstream>

#include "skein/mission/duration_range.hpp"

namespace skein::laws {

namespace {

std::optional<double> as_number(std::string_view text) {
  double number = 0;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || rest != text.data() + text.size()) return std::nullopt;
  return number;
}

std::vector<std::string> words_of(std::string_view text) {
  std::istringstream in{std::string(text)};
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

mission::Argument list_from(std::string_view text) {
  const std::vector<std::string> words = words_of(text);
  std::vector<double> numbers;
  for (const std::string& word : words) {
    if (const auto number = as_number(word)) numbers.push_back(*number);
  }
  if (words.size() == 3 && numbers.size() == 3) {
    return world::Vector3(numbers[0], numbers[1], numbers[2]);
  }
  return words;
}

// "start-after-goal 701 0 to 60", "end-after-goal 701 10 or more".
void read_goal_bound(const std::vector<std::string>& words, mission::HighLevelTask& task) {
  if (words.size() < 5) return;
  const auto goal = as_number(words[1]), least = as_number(words[2]), most = as_number(words[4]);
  if (!goal || !least) return;
  mission::GoalBound bound{mission::GoalId(static_cast<std::uint64_t>(*goal)),
                           words[0] == "end-after-goal", Duration::seconds(*least)};
  if (most) bound.most = Duration::seconds(*most);
  task.after.push_back(bound);
}

void read_bound(const std::string& text, mission::HighLevelTask& task) {
  const std::vector<std::string> words = words_of(text);
  if (words.size() < 2) return;
  if (words[0] == "start-after-goal" || words[0] == "end-after-goal") {
    return read_goal_bound(words, task);
  }
  const auto number = as_number(words[1]);
  if (!number) return;
  const MissionTime at = MissionTime::seconds(*number);
  if (words[0] == "start-after") task.time.start_after = at;
  if (words[0] == "start-before") task.time.start_before = at;
  if (words[0] == "end-after") task.time.end_after = at;
  if (words[0] == "end-before") task.time.end_before = at;
}

void read_bounds(std::string_view text, mission::HighLevelTask& task) {
  std::istringstream in{std::string(text)};
  for (std::string one; std::getline(in, one, ',');) read_bound(one, task);
}

}  // namespace

mission::HighLevelTask task_from(std::string_view statement) {
  mission::HighLevelTask task;
  const std::size_t bounds = statement.find(" [");
  if (bounds != std::string_view::npos) {
    read_bounds(statement.substr(bounds + 2, statement.size() - bounds - 3), task);
    statement = statement.substr(0, bounds);
  }
  while (!statement.empty()) {
    const bool list = statement.front() == '(';
    const std::size_t end = std::min(statement.size(), statement.find(list ? ')' : ' '));
    const std::string_view part = statement.substr(list ? 1 : 0, end - (list ? 1 : 0));
    if (list) {
      task.arguments.push_back(list_from(part));
    } else if (task.name.empty()) {
      task.name = part;
    } else if (const auto number = as_number(part)) {
      task.arguments.emplace_back(*number);
    } else if (!part.empty()) {
      task.arguments.emplace_back(std::string(part));
    }
    statement.remove_prefix(std::min(statement.size(), end + 1));
  }
  return task;
}

std::optional<double> number_of(const mission::Argument& argument) {
  if (const auto range = mission::duration_range_of(argument)) return range->least;
  const auto* number = std::get_if<double>(&argument);
  return number == nullptr ? std::nullopt : std::optional(*number);
}

std::vector<std::string> names_of(const mission::Argument& argument) {
  if (const auto* names = std::get_if<std::vector<std::string>>(&argument)) return *names;
  if (const auto* name = std::get_if<std::string>(&argument)) return {*name};
  return {};
}

}  // namespace skein::laws
