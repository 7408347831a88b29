// SPDX-License-Identifier: Apache-2.0
#include "planning/problem.hpp"

#include <cmath>
#include <initializer_list>
#include <span>

#include "flight/flight_times.hpp"
#include "skein/foundation/overloaded.hpp"
#include "skein/mission/duration_range.hpp"

namespace skein::supervisor {

namespace {

using htn::Term;

class ProblemTerms {
 public:
  ProblemTerms(const PlanningRequest& request, htn::TermStore& store)
      : request_(request), situation_(request.situation), store_(store) {}

  htn::Problem problem() {
    htn::Problem problem;
    problem.name = "request";
    std::vector<Term>& facts = problem.facts;
    facts.push_back(list({word("current-plan"), word("main")}));
    facts.push_back(list({word("takeoffloc"), word("home")}));
    facts.push_back(
        list({word("landloc"), situation_.land_at ? location(*situation_.land_at) : word("home")}));
    facts.push_back(whereabouts());
    const std::vector<Term> motion{word("uavloc")};
    facts.push_back(time("my-write-time", motion, situation_.motion));
    facts.push_back(time("my-read-time", motion, {}));
    for (const Timeline& rider : situation_.riders)
      facts.push_back(time("my-read-time", motion, rider));
    for (const world::SensorModel& sensor : request_.knowledge->vehicle.sensors)
      add_device(sensor, facts);
    for (const mission::HighLevelTask& task : request_.tasks) {
      const auto done = situation_.done.find(task.id);
      if (done != situation_.done.end()) facts.push_back(progress(task.id, done->second));
    }
    facts.push_back(list({word("task-id"), count(situation_.next_id.value())}));
    for (const mission::HighLevelTask& task : request_.tasks)
      problem.tasks.children.push_back(goal(task));
    return problem;
  }

 private:
  Term word(const char* text) { return store_.symbol(text); }
  Term symbol(const std::string& name) { return store_.symbol(name); }
  Term list(std::initializer_list<Term> items) {
    return store_.list(std::span(items.begin(), items.size()));
  }
  Term list(const std::vector<Term>& items) { return store_.list(items); }

  Term count(std::uint64_t value) { return store_.integer(static_cast<std::int64_t>(value)); }
  /// A whole number is an integer.
  Term figure(double value) {
    const bool whole = std::abs(value) < 1e15 && value == std::floor(value);
    return whole ? store_.integer(static_cast<std::int64_t>(value)) : real(value);
  }
  /// There is no negative zero.
  Term real(double value) { return store_.number(htn::real(value + 0.0)); }
  Term seconds(Duration duration) {
    return duration == Duration::max() ? word("unlimited") : figure(duration.to_seconds());
  }
  Term location(const world::Vector3& at) {
    return list({word("loc"), real(at.x()), real(at.y()), real(at.z())});
  }

  Term argument(const mission::Argument& value) {
    return std::visit(Overloaded{[this](const std::string& name) { return symbol(name); },
                                 [this](double number) { return figure(number); },
                                 [this](const world::Vector3& at) { return location(at); },
                                 [this](const std::vector<std::string>& names) {
                                   std::vector<Term> items;
                                   for (const std::string& name : names)
                                     items.push_back(symbol(name));
                                   return list(items);
                                 }},
                      value);
  }

  /// (NAME RESOURCE… ((num LEAST) (num MOST)) EVENT [TASK]): when a resource is free, after what.
  Term time(const char* name, const std::vector<Term>& resource, const Timeline& line) {
    std::vector<Term> items{word(name)};
    items.insert(items.end(), resource.begin(), resource.end());
    items.push_back(list({list({word("num"), seconds(line.free.least)}),
                          list({word("num"), seconds(line.free.most)})}));
    if (!line.after) {
      items.insert(items.end(), {word("end"), word("none")});
      return list(items);
    }
    const char* kind = "end";
    if (line.after->kind == mission::DependenceKind::kOver) kind = "over";
    if (line.after->kind == mission::DependenceKind::kRunning) kind = "running";
    items.insert(items.end(), {word(kind), count(line.after->task.value())});
    return list(items);
  }

  void add_device(const world::SensorModel& sensor, std::vector<Term>& facts) {
    const Term device = symbol(sensor.device);
    const Term quoted = list({word("quote"), device});
    const Term kind = word("perception-device");
    if (situation_.broken.contains(sensor.device)) {
      facts.push_back(list({kind, word("broken"), quoted}));
      return;
    }
    for (const std::string& use : sensor.serves)
      facts.push_back(list({word("device-serves"), device, symbol(use)}));
    facts.push_back(list({kind, word("free"), quoted}));
    const auto line = situation_.devices.find(sensor.device);
    facts.push_back(time("my-write-time", {kind, quoted},
                         line == situation_.devices.end() ? Timeline{} : line->second));
    facts.push_back(time("my-read-time", {kind, quoted}, {}));
  }

  Term whereabouts() {
    const Term at = location(situation_.position);
    if (request_.knowledge->vehicle.ground) return list({word("uavloc"), word("driving"), at});
    if (situation_.airborne) return list({word("uavloc"), word("flying"), at});
    const world::Vector3 offset = situation_.position - request_.knowledge->home;
    const double near = 2 + arrival_distance(request_.knowledge->vehicle, request_.world->wind);
    const bool home = offset.head<2>().norm() <= near;
    return list({word("uavloc"), word("grounded"), home ? word("home") : at});
  }

  Term constraints(const mission::TimeConstraints& time) {
    if (!time.any()) return htn::kNil;
    std::vector<Term> items;
    for (const auto& bound : {time.start_before, time.start_after, time.end_before, time.end_after})
      items.push_back(bound ? figure((*bound - situation_.origin).to_seconds()) : htn::kNil);
    return list(items);
  }

  bool is_duration(const std::string& task, std::size_t position) const {
    const auto& known = request_.knowledge->vocabulary.tasks;
    const auto signature = known.find(task);
    return signature != known.end() && position < signature->second.parameters.size() &&
           signature->second.parameters[position] == mission::ParameterKind::kDuration;
  }

  /// A duration that may be shorter is planned as long as may be.
  htn::TaskNetwork goal(const mission::HighLevelTask& task) {
    std::vector<Term> items{symbol(task.name)};
    for (std::size_t i = 0; i < task.arguments.size(); ++i) {
      const auto range = mission::duration_range_of(task.arguments[i]);
      const bool longest = range && is_duration(task.name, i);
      items.push_back(longest ? figure(range->most) : argument(task.arguments[i]));
    }
    items.push_back(constraints(task.time));
    items.push_back(count(task.id.value()));
    htn::TaskNetwork leaf;
    leaf.kind = htn::NetworkKind::kTask;
    leaf.task = list(items);
    return leaf;
  }

  /// (progress 702 ((looked visible (loc …) 290) (reached (loc …)) …))
  Term progress(mission::GoalId goal, const mission::Progress& done) {
    std::vector<Term> items;
    for (const mission::Progress::Look& look : done.looks)
      items.push_back(
          list({word("looked"), symbol(look.device), location(look.at), seconds(look.lasted)}));
    for (const world::Vector3& at : done.reached)
      items.push_back(list({word("reached"), location(at)}));
    if (done.waited > Duration()) items.push_back(list({word("waited"), seconds(done.waited)}));
    for (const std::uint64_t id : done.synchronised)
      items.push_back(list({word("synchronised"), count(id)}));
    if (done.rest) {
      std::vector<Term> rest{word("rest"), symbol(done.rest->device)};
      for (const world::Vector3& point : done.rest->way) rest.push_back(location(point));
      items.push_back(list(rest));
    }
    return list({word("progress"), count(goal.value()), list(items)});
  }

  const PlanningRequest& request_;
  const Situation& situation_;
  htn::TermStore& store_;
};

}  // namespace

htn::Problem problem_of(const PlanningRequest& request, htn::TermStore& store) {
  return ProblemTerms(request, store).problem();
}

}  // namespace skein::supervisor
