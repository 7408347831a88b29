// SPDX-License-Identifier: Apache-2.0
#include "testing/story.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace skein::laws::testing {

namespace {

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

journal::Record& Story::add(double at, const std::string& node, const std::string& kind) {
  return records_.emplace_back(MissionTime::seconds(at), node, kind);
}

Story& Story::flies(const std::string& uav, double from, double until, world::Vector3 a,
                    world::Vector3 b, double energy) {
  const world::Vector3 velocity = (b - a) / std::max(1.0, until - from);
  const double heading = velocity.norm() > 0 ? std::atan2(velocity.y(), velocity.x()) : 0;
  for (double t = from; t <= until; t += 1) {
    const world::Vector3 p = a + (t - from) * velocity;
    add(t, "sim", "telemetry")
        .with("uav", uav)
        .with("position", std::vector<double>{p.x(), p.y(), p.z()})
        .with("velocity", std::vector<double>{velocity.x(), velocity.y(), velocity.z()})
        .with("heading", heading)
        .with("energy", energy)
        .with("airborne", p.z() > 0.5);
  }
  return *this;
}

Story& Story::stands(const std::string& uav, double from, double until, world::Vector3 at) {
  return flies(uav, from, until, at, at);
}

Story& Story::does(const std::string& uav, const Doing& what) {
  if (what.goal != 0) {
    add(what.from, uav, "planned").with("uav", uav).with("task", what.task).with("goal", what.goal);
  }
  const auto line = [&](double at, const std::string& node, const std::string& kind,
                        const std::string& state) -> journal::Record& {
    return add(at, node, kind)
        .with("uav", uav)
        .with("task", what.task)
        .with("type", what.type)
        .with("state", state);
  };
  const auto truth = [&](double at, const std::string& state) {
    if (what.type == "synchronise") return;
    journal::Record& one = line(at, "sim", "functional", state);
    if (!what.device.empty()) one.with("device", what.device);
    if (!what.target.empty()) one.with("target", what.target);
    if (!what.reason.empty() && state == what.end) one.with("reason", what.reason);
  };
  line(what.from, uav, "task", "started");
  if (what.until > what.from) truth(std::max(what.begins, what.from), "running");
  truth(what.until, what.end);
  line(what.until, uav, "task", what.end);
  return *this;
}

Story& Story::starts_unheard(const std::string& uav, double at, int task, const std::string& type) {
  add(at, "ground", "task")
      .with("uav", uav)
      .with("task", task)
      .with("type", type)
      .with("state", "started");
  return *this;
}

Story& Story::goal(const std::string& uav, int id, const std::string& statement,
                   const std::string& state, double at, const std::string& why) {
  auto& line = add(at, uav, "goal")
                   .with("uav", uav)
                   .with("goal", id)
                   .with("statement", statement)
                   .with("state", state);
  if (!why.empty()) line.with("why", why);
  return *this;
}

Story& Story::says(const std::string& uav, double at, const std::string& text) {
  add(at, uav, "notice").with("uav", uav).with("text", text);
  return *this;
}

Story& Story::decides(const std::string& uav, double at, const std::string& applied,
                      const std::string& cause, const std::string& outcome) {
  add(at, uav, "decision")
      .with("uav", uav)
      .with("operator", applied)
      .with("cause", cause)
      .with("outcome", outcome);
  return *this;
}

Story& Story::answer(const std::string& uav, double at, const Answered& what) {
  journal::Record& line = add(at, uav, "answer")
                              .with("uav", uav)
                              .with("mission", what.mission)
                              .with("planned", what.planned);
  if (what.evaluated) {
    line.with("evaluated", true)
        .with("energy", what.energy)
        .with("earliest_end", what.earliest_end)
        .with("latest_end", what.latest_end);
  }
  return *this;
}

Story& Story::degree(const std::string& uav, double at, int degree) {
  add(at, uav, "degree").with("uav", uav).with("degree", degree);
  return *this;
}

Story& Story::step(double at, const std::string& name, const std::string& told) {
  add(at, "ground", "step").with("name", name);
  add(at + 0.02, told, "message")
      .with("slot", "WorldChange")
      .with("from", "ground")
      .with("to", told)
      .with("direction", "received");
  return *this;
}

Story& Story::dates_by_ground() {
  scenario_.planning->consistency = temporal::Algorithm::kCip;
  return *this;
}

Story& Story::alarm(double at, int id, world::Vector3 where) {
  add(at, "ground", "alarm")
      .with("alarm", id)
      .with("state", "raised")
      .with("position", std::vector<double>{where.x(), where.y(), where.z()});
  return *this;
}

Story& Story::burns(double at, world::Vector2 from, double length, double breadth) {
  const double middle = from.x() + std::sqrt(length * length - breadth * breadth);
  add(at, "sim", "object")
      .with("name", "blaze")
      .with("type", "fire")
      .with("position", std::vector<double>{middle, from.y(), 0})
      .with("radius", length)
      .with("active", true)
      .with("breadth", breadth)
      .with("ignition", std::vector<double>{from.x(), from.y()});
  return *this;
}

Story& Story::object_seen(double told, double seen, world::Vector3 where, double spread) {
  add(told, "ground", "seen")
      .with("name", "fire-front")
      .with("type", "fire")
      .with("position", std::vector<double>{where.x(), where.y(), where.z()})
      .with("spread", spread)
      .with("when", seen);
  return *this;
}

Story& Story::owner(double at, int task, const std::string& stage, int sale,
                    const std::string& owners, const std::string& why) {
  add(at, "ground", "owner")
      .with("task", task)
      .with("stage", stage)
      .with("sale", sale)
      .with("owners", owners)
      .with("why", why);
  return *this;
}

Story& Story::team(const std::string& uav, double at, int task, int sale, const std::string& state,
                   const std::string& why) {
  add(at, uav, "team-task")
      .with("uav", uav)
      .with("task", task)
      .with("sale", sale)
      .with("state", state)
      .with("why", why);
  return *this;
}

Story& Story::foretold(const std::string& uav, double at, int meeting, const std::string& last,
                       std::optional<double> soonest) {
  journal::Record& record = add(at, uav, "meeting");
  record.with("uav", uav).with("id", meeting).with("known", true).with("last", last);
  if (soonest) record.with("soonest", *soonest);
  return *this;
}

Story& Story::plan_word(const std::string& from, const std::string& to, double at,
                        std::optional<double> heard) {
  add(at, from, "frontier").with("uav", from).with("direction", "sent").with("to", to);
  if (heard)
    add(*heard, to, "frontier").with("uav", to).with("direction", "received").with("from", from);
  return *this;
}

Story& Story::air(const std::string& uav, double at, const std::string& state,
                  const std::string& waits_for) {
  journal::Record& record = add(at, uav, "air");
  record.with("uav", uav).with("task", 7).with("type", "goto").with("state", state);
  if (!waits_for.empty()) record.with("for", waits_for);
  return *this;
}

Story& Story::link(double at, const std::string& from, const std::string& to, bool up) {
  add(at, "sim", "link").with("from", from).with("to", to).with("up", up);
  return *this;
}

Story& Story::hears(const std::string& uav, double at, int meeting, const std::string& from,
                    const std::string& word) {
  journal::Record& record = add(at, uav, "sync");
  record.with("id", meeting).with("from", from).with("to", uav).with("direction", "received");
  if (!word.empty()) record.with("word", word);
  return *this;
}

Story& Story::fault(double at, const std::string& what, const std::string& uav) {
  add(at, "sim", "fault").with("what", what).with("target", uav);
  return *this;
}

std::vector<std::string> Story::broken(const std::string& law) const {
  std::vector<journal::Record> ordered = records_;
  std::stable_sort(ordered.begin(), ordered.end(),
                   [](const auto& a, const auto& b) { return a.at() < b.at(); });
  std::vector<std::string> sentences;
  for (const Violation& one : broken_laws(scenario_, ordered, {law}))
    sentences.push_back(to_text(one));
  return sentences;
}

}  // namespace skein::laws::testing
