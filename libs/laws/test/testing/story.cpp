// SPDX-License-Identifier: Apache-2.0
#include "testing/story.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "skein/journal/lines/deliberation.hpp"
#include "skein/journal/lines/execution.hpp"
#include "skein/journal/lines/joint.hpp"
#include "skein/journal/lines/mission.hpp"
#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/team.hpp"
#include "skein/journal/lines/truth.hpp"

namespace skein::laws::testing {

namespace lines = journal::lines;

namespace {

std::vector<double> numbers(const world::Vector3& place) {
  return {place.x(), place.y(), place.z()};
}

constexpr const char* kHead = R"(scenario: story
epoch: 2005-05-19T09:00:00Z
duration_limit: 2000
world:
  origin: {latitude: 40.1, longitude: -8.2, altitude: 200}
  terrain: {west: -300, south: -300, east: 1200, north: 900, cell: 20}
  zones:
    Z: [[100, 10], [200, 10], [200, 110], [100, 110]]
  places: {P1: [150, 60, 0], A1: [150, 60, 50], A2: [250, 60, 50]}
)";
constexpr const char* kFoot = R"(planning: {domain: ../domains/comets.lisp}
ground:
  position: [0, 0, 8]
)";

std::string member(const std::string& name, const std::string& more) {
  return "  " + name + ": {model: ../comets/models/" + name + ".yaml, start: [0, 0], degree: 4" +
         more + "}\n";
}

}  // namespace

Story::Story(const std::string& more, const std::string& script, const std::string& uav_more) {
  const std::string text =
      kHead + more + "uavs:\n" + member("marvin", uav_more) + member("heliv", "") +
      member("karma", "") + kFoot + "  script:\n" +
      (script.empty() ? "    - {step: end, when: {time: 1999}, do: [{finish: true}]}\n" : script);
  auto scenario =
      scenario::read_scenario_text(text, SKEIN_SOURCE_DIR "/scenarios/comets/story.yaml");
  if (!scenario) {
    std::fputs(to_text(scenario.error()).c_str(), stderr);
    std::abort();
  }
  scenario_ = std::move(*scenario);
}

Story& Story::flies(const std::string& uav, double from, double until, world::Vector3 a,
                    world::Vector3 b, double energy) {
  const world::Vector3 velocity = (b - a) / std::max(1.0, until - from);
  const double heading = velocity.norm() > 0 ? std::atan2(velocity.y(), velocity.x()) : 0;
  const world::Terrain ground = terrain();
  for (double t = from; t <= until; t += 1) {
    const world::Vector3 p = a + (t - from) * velocity;
    add(t, "sim",
        lines::Telemetry{.uav = uav,
                         .position = numbers(p),
                         .velocity = numbers(velocity),
                         .heading = heading,
                         .energy = energy,
                         .airborne = p.z() > ground.elevation(p.x(), p.y()) + 0.5});
  }
  return *this;
}

Story& Story::stands(const std::string& uav, double from, double until, world::Vector3 at) {
  return flies(uav, from, until, at, at);
}

Story& Story::does(const std::string& uav, const Doing& what) {
  const auto task = static_cast<std::uint64_t>(what.task);
  if (what.goal != 0)
    add(what.from, uav,
        lines::Planned{.uav = uav, .task = task, .goal = static_cast<std::uint64_t>(what.goal)});
  const auto truth = [&](double at, const std::string& state) {
    if (what.type == "synchronise") return;
    add(at, "sim",
        lines::Functional{.uav = uav,
                          .task = task,
                          .type = what.type,
                          .state = state,
                          .device = what.device,
                          .target = what.target,
                          .reason = state == what.end ? what.reason : ""});
  };
  add(what.from, uav, lines::Task{.uav = uav, .task = task, .type = what.type, .state = "started"});
  if (what.until > what.from) truth(std::max(what.begins, what.from), "running");
  truth(what.until, what.end);
  return add(what.until, uav,
             lines::Task{.uav = uav, .task = task, .type = what.type, .state = what.end});
}

Story& Story::starts_unheard(const std::string& uav, double at, int task, const std::string& type,
                             const std::string& state) {
  return add(
      at, "ground",
      lines::Task{
          .uav = uav, .task = static_cast<std::uint64_t>(task), .type = type, .state = state});
}

Story& Story::goal(const std::string& uav, int id, const std::string& statement,
                   const std::string& state, double at, const std::string& why) {
  return add(at, uav,
             lines::Goal{.uav = uav,
                         .goal = static_cast<std::uint64_t>(id),
                         .statement = statement,
                         .state = state,
                         .why = why});
}

Story& Story::says(const std::string& uav, double at, const std::string& text) {
  return add(at, uav, lines::Notice{.uav = uav, .text = text});
}

Story& Story::leaves(const std::string& uav, double at, const std::string& why) {
  return add(at, uav, lines::Joint{.uav = uav, .phase = "leaving", .why = why});
}

Story& Story::decides(const std::string& uav, double at, const std::string& applied,
                      const std::string& cause, const std::string& outcome) {
  return add(at, uav,
             lines::Decision{.uav = uav, .operator_ = applied, .cause = cause, .outcome = outcome});
}

Story& Story::answer(const std::string& uav, double at, const Answered& what) {
  lines::Answer line{
      .uav = uav, .mission = static_cast<std::uint64_t>(what.mission), .planned = what.planned};
  if (what.evaluated) {
    line.evaluated = true;
    line.energy = what.energy;
    line.earliest_end = what.earliest_end;
    line.latest_end = what.latest_end;
  }
  return add(at, uav, std::move(line));
}

Story& Story::degree(const std::string& uav, double at, int degree) {
  return add(at, uav, lines::Degree{.uav = uav, .degree = degree});
}

Story& Story::contact(const std::string& uav, double at, const std::string& policy) {
  return add(at, uav, lines::Contact{.uav = uav, .policy = policy});
}

Story& Story::step(double at, const std::string& name, const std::string& told, bool by_operator) {
  if (by_operator) add(at, "ground", lines::Operator{.does = name});
  if (!by_operator) add(at, "ground", lines::Step{.name = name});
  return add(
      at + 0.02, told,
      lines::Message{.slot = "WorldChange", .from = "ground", .to = told, .direction = "received"});
}

Story& Story::dates_by_ground() {
  scenario_.planning->consistency = temporal::Algorithm::kCip;
  return *this;
}

Story& Story::alarm(double at, int id, world::Vector3 where) {
  return add(
      at, "ground",
      lines::Alarm{
          .alarm = static_cast<std::uint64_t>(id), .state = "raised", .position = numbers(where)});
}

Story& Story::burns(double at, world::Vector2 from, double length, double breadth) {
  const double middle = from.x() + std::sqrt(length * length - breadth * breadth);
  return add(at, "sim",
             lines::Object{.name = "blaze",
                           .type = "fire",
                           .position = {middle, from.y(), 0},
                           .radius = length,
                           .active = true,
                           .breadth = breadth,
                           .ignition = std::vector<double>{from.x(), from.y()}});
}

Story& Story::object_seen(double told, double seen, world::Vector3 where, double spread) {
  return add(told, "ground",
             lines::Seen{.name = "fire-front",
                         .type = "fire",
                         .position = numbers(where),
                         .spread = spread,
                         .when = seen});
}

Story& Story::owner(double at, int task, const std::string& stage, int sale,
                    const std::string& owners, const std::string& why) {
  return add(at, "ground",
             lines::Owner{.task = static_cast<std::uint64_t>(task),
                          .stage = stage,
                          .sale = static_cast<std::uint64_t>(sale),
                          .owners = owners,
                          .why = why});
}

Story& Story::team(const std::string& uav, double at, int task, int sale, const std::string& state,
                   const std::string& why) {
  return add(at, uav,
             lines::TeamTask{.uav = uav,
                             .task = static_cast<std::uint64_t>(task),
                             .sale = static_cast<std::uint64_t>(sale),
                             .state = state,
                             .goal = static_cast<std::uint64_t>(task),
                             .why = why});
}

Story& Story::plans(const std::string& uav, double at, int goal, double latest) {
  return add(at, uav,
             lines::Planned{.uav = uav,
                            .revision = static_cast<std::uint64_t>(at),
                            .goal = static_cast<std::uint64_t>(goal),
                            .latest_end = latest});
}

Story& Story::foretold(const std::string& uav, double at, int meeting, const std::string& last,
                       std::optional<double> soonest) {
  return add(at, uav,
             lines::Meeting{.uav = uav,
                            .id = static_cast<std::uint64_t>(meeting),
                            .known = true,
                            .last = last,
                            .soonest = soonest});
}

Story& Story::plan_word(const std::string& from, const std::string& to, double at,
                        std::optional<double> heard, std::uint64_t arcs) {
  add(at, from, lines::Frontier{.uav = from, .direction = "sent", .to = to, .arcs = arcs});
  if (heard) add(*heard, to, lines::Frontier{.uav = to, .direction = "received", .from = from});
  return *this;
}

Story& Story::air(const std::string& uav, double at, const std::string& state,
                  const std::string& waits_for) {
  return add(at, uav,
             lines::Air{.uav = uav, .task = 7, .type = "goto", .state = state, .for_ = waits_for});
}

Story& Story::link(double at, const std::string& from, const std::string& to, bool up) {
  return add(at, "sim", lines::Link{.from = from, .to = to, .up = up});
}

Story& Story::hears(const std::string& uav, double at, int meeting, const std::string& from,
                    const std::string& word) {
  return add(at, uav,
             lines::Sync{.id = static_cast<std::uint64_t>(meeting),
                         .from = from,
                         .to = uav,
                         .direction = "received",
                         .word = word});
}

Story& Story::fault(double at, const std::string& what, const std::string& uav) {
  return add(at, "sim", lines::Fault{.what = what, .target = uav});
}

Story& Story::line(journal::Record record) {
  records_.push_back(std::move(record));
  return *this;
}

std::vector<journal::Record> Story::ordered() const {
  std::vector<journal::Record> ordered = records_;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const auto& a, const auto& b) { return a.at() < b.at(); });
  return ordered;
}

std::vector<std::string> Story::broken(const std::string& law) const {
  std::vector<std::string> sentences;
  for (const Violation& one : broken_laws(scenario_, ordered(), {law}))
    sentences.push_back(to_text(one));
  return sentences;
}

std::vector<std::string> Story::too_near() const {
  std::vector<std::string> sentences;
  for (const Violation& one : laws::too_near(scenario_, ordered()))
    sentences.push_back(one.sentence);
  return sentences;
}

}  // namespace skein::laws::testing
