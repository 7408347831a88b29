// SPDX-License-Identifier: Apache-2.0
#include "skein/supervisor/plan_reader.hpp"

#include <algorithm>
#include <cmath>

#include "planning/terms.hpp"
#include "skein/foundation/nearest.hpp"
#include "skein/functional/task_types.hpp"

namespace skein::supervisor {

using htn::kNil;
using htn::Term;
using htn::TermKind;
using htn::TermStore;
using mission::ElementaryTask;

namespace {

constexpr std::size_t kShape = 8;
constexpr std::string_view kTask = "!task-", kStop = "!stop-";

Duration duration_of(double seconds) {
  return std::isinf(seconds) ? Duration::max() : Duration::seconds(seconds);
}

mission::Interval interval_of(const Seconds& seconds) {
  return {duration_of(seconds.least), duration_of(seconds.most)};
}

std::optional<std::uint64_t> count_of(const TermStore& store, Term term) {
  const auto number = number_of(store, term);
  if (!number || *number < 0 || *number > 9e15 || *number != std::floor(*number)) return {};
  return static_cast<std::uint64_t>(*number);
}

std::optional<std::vector<mission::Dependence>> dependences_of(const TermStore& store, Term term) {
  if (!store.is_list(term)) return std::nullopt;
  std::vector<mission::Dependence> all;
  for (const Term one : store.items(term)) {
    const std::vector<Term> parts = store.is_list(one) ? store.items(one) : std::vector<Term>{};
    if (parts.size() != 2) return std::nullopt;
    const auto kind = mission::dependence_kind_from(text_of(store, parts[0]));
    const auto id = count_of(store, parts[1]);
    if (!kind || !id) return std::nullopt;
    all.push_back({*kind, executive::TaskId(*id)});
  }
  return all;
}

class Reader {
 public:
  Reader(const TermStore& store, const Knowledge& knowledge, MissionTime origin)
      : store_(store), knowledge_(knowledge), origin_(origin) {}

  /// Empty: it has the shape.
  std::string read(Term action, mission::ElementaryPlan& plan) {
    const std::vector<Term> parts = store_.items(action);
    const std::string name = text_of(store_, parts.front());
    const bool stops = name.starts_with(kStop);
    if (parts.size() != kShape || (!stops && !name.starts_with(kTask)))
      return "expected (!task-NAME or !stop-NAME ID DEPENDENCES PARAMS START DURATION "
             "TIME-CONSTRAINTS ORIGIN)";
    return stops ? read_stop(parts, plan) : read_task(name, parts, plan);
  }

 private:
  std::string read_stop(const std::vector<Term>& parts, mission::ElementaryPlan& plan) const {
    const auto id = count_of(store_, parts[1]);
    const auto dependences = dependences_of(store_, parts[2]);
    const auto stopped = std::find_if(plan.tasks.rbegin(), plan.tasks.rend(), [&](const auto& one) {
      return id && one.id == executive::TaskId(*id);
    });
    if (!dependences || dependences->empty()) return "expected dependences, ((ended 102) …)";
    if (stopped == plan.tasks.rend()) return "expected the id of a task before it";
    if (!mission::type_of(*stopped).can_end(functional::Ending::kByStop))
      return "a task of type '" + stopped->type + "' cannot be stopped";
    stopped->stop = *dependences;
    return {};
  }

  std::string read_task(const std::string& name, const std::vector<Term>& parts,
                        mission::ElementaryPlan& plan) const {
    const auto id = count_of(store_, parts[1]), origin = count_of(store_, parts[7]);
    const auto dependences = dependences_of(store_, parts[2]);
    const auto start = seconds_of(store_, parts[4]), duration = seconds_of(store_, parts[5]);
    if (!id || !origin) return "expected whole numbers as id and origin";
    if (!dependences) return "expected dependences, ((ended 102) …)";
    if (!start || !duration) return "expected start and duration, ((num LEAST) (num MOST))";
    ElementaryTask task;
    task.id = executive::TaskId(*id);
    task.name = name.substr(1);
    task.dependences = *dependences;
    task.start = interval_of(*start);
    task.duration = interval_of(*duration);
    task.origin = mission::GoalId(*origin);
    if (std::string why = read_constraints(parts[6], task); !why.empty()) return why;
    if (std::string why = read_params(parts[3], task); !why.empty()) return why;
    plan.tasks.push_back(std::move(task));
    return {};
  }

  std::string read_constraints(Term term, ElementaryTask& task) const {
    if (term == kNil) return {};
    const std::vector<Term> all = store_.is_list(term) ? store_.items(term) : std::vector<Term>{};
    if (all.size() != 4) return "expected four time constraints, or nil";
    std::optional<MissionTime>* const bounds[] = {&task.time.start_before, &task.time.start_after,
                                                  &task.time.end_before, &task.time.end_after};
    for (std::size_t i = 0; i < 4; ++i) {
      const auto seconds = number_of(store_, all[i]);
      if (seconds) *bounds[i] = origin_ + Duration::seconds(*seconds);
    }
    return {};
  }

  std::string read_params(Term term, ElementaryTask& task) const {
    if (!store_.is_list(term)) return "expected a list of parameters";
    for (const Term one : store_.items(term)) {
      const std::vector<Term> parts = store_.is_list(one) ? store_.items(one) : std::vector<Term>{};
      if (parts.empty()) return "expected (NAME VALUE…) as parameter";
      const std::string key = text_of(store_, parts.front());
      const std::vector<Term> values(parts.begin() + 1, parts.end());
      if (!read_own(key, values, task)) task.parameters.add(parameter(key, values));
    }
    if (task.type.empty()) return "expected (type TYPE) among the parameters";
    return misfit(task);
  }

  /// What its type does not allow.
  static std::string misfit(const ElementaryTask& task) {
    const auto& types = functional::TaskTypes::shipped();
    const functional::TaskType* type = types.find(task.type);
    if (type == nullptr) {
      return "unknown type '" + task.type + "'" +
             did_you_mean(nearest_name(task.type, types.names()));
    }
    if (type->synchronises() && !task.synchronisation)
      return "expected (sync ID SENDERS RECEIVERS) among the parameters";
    if (task.open_ended && !type->can_end(functional::Ending::kByOrder))
      return "a task of type '" + task.type + "' does not end by order";
    for (const executive::Parameter& one : task.parameters.all())
      if (!type->takes(one.name))
        return "a task of type '" + task.type + "' takes no parameter '" + one.name + "'";
    return {};
  }

  /// What the reader keeps for itself.
  bool read_own(const std::string& key, const std::vector<Term>& values,
                ElementaryTask& task) const {
    if (key == "type" && values.size() == 1) {
      task.type = text_of(store_, values[0]);
    } else if (key == "energy" && values.size() == 1) {
      task.energy = number_of(store_, values[0]).value_or(0);
    } else if (key == "open-ended") {
      task.open_ended = true;
    } else if (key == "way") {
      for (const Term one : values)
        if (const auto at = location_of(store_, one)) task.way.push_back(*at);
    } else if (key == "sync" && values.size() == 3) {
      task.synchronisation.emplace();
      task.synchronisation->id = count_of(store_, values[0]).value_or(0);
      task.synchronisation->senders = names(values[1]);
      task.synchronisation->receivers = names(values[2]);
    } else {
      return false;
    }
    return true;
  }

  /// Numbers and locations become numbers, names a text with spaces.
  executive::Parameter parameter(const std::string& key, const std::vector<Term>& values) const {
    executive::Parameter made{key, {}, {}};
    const auto say = [&](const std::string& word) {
      made.text += (made.text.empty() ? "" : " ") + word;
    };
    for (const Term raw : values) {
      const Term value = unquoted(store_, raw);
      if (const auto at = location_of(store_, value))
        made.numbers.insert(made.numbers.end(), {at->x(), at->y(), at->z()});
      else if (const auto number = number_of(store_, value))
        made.numbers.push_back(*number);
      else if (value.is(TermKind::kPair) && store_.is_list(value))
        for (const std::string& word : names(value)) say(word);
      else
        say(in_its_letters(text_of(store_, value)));
    }
    return made;
  }

  std::vector<std::string> names(Term list) const {
    std::vector<std::string> all;
    if (!store_.is_list(list)) return all;
    for (const Term one : store_.items(list)) all.push_back(in_its_letters(text_of(store_, one)));
    return all;
  }

  std::string in_its_letters(const std::string& name) const {
    for (const std::string& uav : knowledge_.team)
      if (same_name(uav, name)) return uav;
    if (same_name(knowledge_.uav, name)) return knowledge_.uav;
    for (const world::SensorModel& sensor : knowledge_.vehicle.sensors)
      if (same_name(sensor.device, name)) return sensor.device;
    return name;
  }

  const TermStore& store_;
  const Knowledge& knowledge_;
  MissionTime origin_;
};

/// Of the branches from the high-level task down to each step.
std::vector<std::vector<std::string>> methods_of(const htn::Plan& plan) {
  std::vector<std::vector<std::string>> all(plan.steps.size());
  for (const htn::TreeNode& node : plan.tree) {
    if (node.kind != htn::TreeNodeKind::kStep || node.step >= all.size()) continue;
    std::vector<std::string>& methods = all[node.step];
    for (htn::TreeIndex at = node.parent; at != htn::kNoParent; at = plan.tree[at].parent)
      if (!plan.tree[at].method.empty()) methods.push_back(plan.tree[at].method);
    std::reverse(methods.begin(), methods.end());
  }
  return all;
}

}  // namespace

Result<mission::ElementaryPlan, Failure> read_plan(const TermStore& store, const htn::Plan& plan,
                                                   const Knowledge& knowledge, MissionTime origin) {
  mission::ElementaryPlan made;
  made.origin = origin;
  Reader reader(store, knowledge, origin);
  const auto methods = methods_of(plan);
  std::string wrong;
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const htn::Step& step = plan.steps[i];
    made.cost += to_double(step.cost);
    if (step.internal) continue;
    const std::size_t before = made.tasks.size();
    const std::string why = reader.read(step.action, made);
    if (!why.empty()) {
      wrong += (wrong.empty() ? "" : "; ") + ("step " + store.to_text(step.action)) + ": " + why;
      continue;
    }
    if (made.tasks.size() == before) continue;
    ElementaryTask& task = made.tasks.back();
    task.methods = methods[i];
    task.cost = to_double(step.cost);
    made.energy += task.energy;
  }
  if (!wrong.empty()) return failure(std::move(wrong));
  return made;
}

}  // namespace skein::supervisor
