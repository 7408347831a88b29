// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <nlohmann/json.hpp>

#include "instance.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/trace_lines/json_node.hpp"

namespace skein::allocate_tool {

namespace {

using auction::Abilities;
using auction::Place;
using Json = nlohmann::json;

constexpr std::size_t kMostSkills = 64;  // bits of Abilities
constexpr double kFarthest = 1e9;        // [m], [s]

/// Reads one line; what is wrong is told and read as something harmless.
class Reader {
 public:
  Reader(const Json& json, const std::string& file, int line, Diagnostics& problems)
      : json_(&json), file_(&file), line_(line), problems_(&problems) {}

  Instance read() {
    if (!json_->is_object()) {
      wrong("", "not an object", R"({"vehicles":…,"tasks":…} or {"skills":…,"needs":…,…})");
      return {};
    }
    return json_->contains("vehicles") || json_->contains("tasks") ? tours() : robots();
  }

 private:
  void wrong(std::string path, std::string message, std::string expected) {
    problems_->add(
        {*file_, line_, 0, std::move(path), std::move(message), std::move(expected), ""});
  }

  void check_keys(const std::vector<std::string>& known) {
    for (const auto& [key, value] : json_->items()) {
      if (std::find(known.begin(), known.end(), key) != known.end()) continue;
      problems_->add({*file_, line_, 0, key, "unknown key", "", nearest_name(key, known)});
    }
  }

  // An array under a key; empty, and told, if there is none.
  const Json& list(const char* key) {
    static const Json none = Json::array();
    const auto found = json_->find(key);
    if (found != json_->end() && found->is_array()) return *found;
    wrong(key, found == json_->end() ? "missing" : "not an array", "an array");
    return none;
  }

  double number(const Json& json, const std::string& path, double least) {
    const double value = json.is_number() ? json.get<double>() : kFarthest * 2;
    if (value >= least && value <= kFarthest) return value;
    wrong(path, "not a number in range", least < 0 ? "-1e9 to 1e9" : "0 to 1e9");
    return 0;
  }

  Place place(const Json& json, const std::string& path) {
    if (json.is_array() && json.size() == 2) {
      return {number(json[0], path + "[0]", -kFarthest), number(json[1], path + "[1]", -kFarthest)};
    }
    wrong(path, "not a place", "[x, y]");
    return {};
  }

  std::vector<Place> places(const char* key) {
    std::vector<Place> all;
    for (const Json& one : list(key)) all.push_back(place(one, at(key, all.size())));
    return all;
  }

  static std::string at(const std::string& key, std::size_t index) {
    return key + "[" + std::to_string(index) + "]";
  }

  Instance tours() {
    check_keys({"vehicles", "tasks", "name"});
    Instance instance;
    instance.tours = true;
    for (const Place& begin : places("vehicles")) instance.vehicles.push_back({begin});
    if (instance.vehicles.empty()) wrong("vehicles", "none", "at least one");
    for (const Place& where : places("tasks")) {
      auction::Task task;
      task.number = auction::TaskNumber(static_cast<std::uint32_t>(instance.lot.tasks.size()));
      task.at = where;
      instance.lot.tasks.push_back(task);
    }
    return instance;
  }

  Abilities skills(const Json& row, const std::string& path) {
    Abilities abilities = 0;
    if (!row.is_array() || row.size() > kMostSkills) {
      wrong(path, "not a row of skills", "an array of at most 64 times 0 or 1");
      return 0;
    }
    if (!width_) width_ = row.size();
    if (row.size() != *width_) {
      wrong(path, std::to_string(row.size()) + " skills",
            std::to_string(*width_) + ", as elsewhere");
    }
    for (std::size_t k = 0; k < row.size(); ++k) {
      const bool one = row[k] == 1 || row[k] == true;
      if (one)
        abilities |= Abilities{1} << k;
      else if (row[k] != 0 && row[k] != false)
        wrong(at(path, k), "not a skill", "0 or 1");
    }
    return abilities;
  }

  // Task 0 is where all robots begin, the last where they end.
  Instance robots() {
    check_keys({"name", "skills", "needs", "duration", "at", "before", "makespan", "schedule"});
    Instance instance;
    const std::vector<Place> where = places("at");
    const Json& needs = list("needs");
    const Json& durations = list("duration");
    if (where.size() < 2) wrong("at", "less than two places", "those of the start and the end too");
    if (needs.size() != where.size())
      wrong("needs", "not as many as places", std::to_string(where.size()));
    if (durations.size() != where.size()) {
      wrong("duration", "not as many as places", std::to_string(where.size()));
    }
    const Json& rows = list("skills");
    for (std::size_t r = 0; r < rows.size(); ++r) {
      auction::FlatVehicle robot;
      robot.abilities = skills(rows[r], at("skills", r));
      if (where.size() >= 2) {
        robot.begin = where.front();
        robot.end = where.back();
      }
      instance.vehicles.push_back(robot);
    }
    if (rows.empty()) wrong("skills", "no robots", "at least one");
    for (std::size_t t = 0; t < needs.size(); ++t) {
      auction::Task task;
      task.number = auction::TaskNumber(static_cast<std::uint32_t>(t));
      task.needs = skills(needs[t], at("needs", t));
      if (t < durations.size()) task.duration = number(durations[t], at("duration", t), 0);
      if (t < where.size()) task.at = where[t];
      if (t > 0 && t + 1 < needs.size())
        instance.lot.tasks.push_back(task);
      else if (task.needs != 0)
        wrong(at("needs", t), "the start or the end needs skills", "all 0");
      else if (task.duration > 0)
        wrong(at("duration", t), "the start or the end takes time", "0");
    }
    precedences(instance, needs.size());
    return instance;
  }

  void precedences(Instance& instance, std::size_t tasks) {
    if (!json_->contains("before") || tasks == 0) return;
    const Json& pairs = list("before");
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const auto task = [&](std::size_t k) -> std::size_t {
        const bool fine = pairs[i].is_array() && pairs[i].size() == 2 &&
                          pairs[i][k].is_number_integer() && pairs[i][k] >= 0 &&
                          pairs[i][k] < tasks;
        return fine ? pairs[i][k].get<std::size_t>() : tasks;
      };
      const std::size_t first = task(0), then = task(1), last = tasks - 1;
      if (first >= tasks || then >= tasks) {
        wrong(at("before", i), "not a pair of tasks",
              "[first, then], from 0 to " + std::to_string(last));
      } else if (first == last || then == 0 || first == then) {
        wrong(at("before", i), "cannot hold", "nothing before the start or after the end");
      } else if (first != 0 && then != last) {
        instance.lot.precedences.push_back({auction::TaskNumber(static_cast<std::uint32_t>(first)),
                                            auction::TaskNumber(static_cast<std::uint32_t>(then))});
      }
    }
  }

  const Json* json_;
  const std::string* file_;
  int line_;
  Diagnostics* problems_;
  std::optional<std::size_t> width_;
};

}  // namespace

std::optional<Instance> read_instance(std::string_view text, const std::string& file, int line,
                                      Diagnostics& problems) {
  const auto json = trace_lines::parse(text);
  if (!json) {
    problems.add({file, line, 0, "", json.error().why, "one JSON object a line", ""});
    return std::nullopt;
  }
  const std::size_t before = problems.size();
  Instance instance = Reader(*json, file, line, problems).read();
  if (problems.size() > before) return std::nullopt;
  return instance;
}

}  // namespace skein::allocate_tool
