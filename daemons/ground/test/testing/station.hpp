// SPDX-License-Identifier: Apache-2.0
// A ground node of two UAVs, its inputs and what it sends and logs.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "skein/ground/ground_node.hpp"

namespace skein::ground::testing {

namespace gs = ground_station;

inline MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

inline world::Terrain flat() { return world::Terrain({-1000, -1000, 1000, 1000, 100, 0, {}, {}}); }

inline gs::PlannedTask planned(std::uint64_t id, const std::string& type) {
  gs::PlannedTask planned;
  planned.task.id = executive::TaskId(id);
  planned.task.type = type;
  return planned;
}

inline gs::Step step(const std::string& name, gs::Trigger when, std::vector<gs::Action> actions) {
  return {name, "", std::move(when), Duration(), std::move(actions), true};
}

/// The ground station of "marvin" and "heliv".
class Station {
 public:
  explicit Station(gs::Script script = {}, int degree = 3, GroundNode::ReadRequest reader = {})
      : node_(config(std::move(script), degree), flat(), roster_, std::move(reader)) {}
  /// That follows objects, and tells alarms again after so long.
  Station(std::vector<gs::ObjectSpec> objects, Duration tell_again)
      : node_(following(std::move(objects), tell_again), flat(), roster_) {}

  /// Effects of an input now, kept for the questions below.
  void give(const node::Input& input, double seconds) {
    effects_ = node_.handle(input, at(seconds));
  }
  void from(const std::string& node, wire::Sample sample, double seconds) {
    give(node::Received{roster_.find(node)->number, std::move(sample)}, seconds);
  }
  void from_stranger(wire::Sample sample, double seconds) {
    give(node::Received{node::NodeNumber(77), std::move(sample)}, seconds);
  }

  /// What was sent, with to whom.
  template <class Sample>
  std::vector<std::pair<std::string, Sample>> sent() const {
    std::vector<std::pair<std::string, Sample>> sent;
    for (const node::Effect& effect : effects_) {
      const auto* send = std::get_if<node::Send>(&effect);
      if (send == nullptr) continue;
      if (const auto* sample = std::get_if<Sample>(&send->sample)) {
        sent.emplace_back(roster_.name_of(send->to), *sample);
      }
    }
    return sent;
  }
  template <class Kind>
  std::vector<Kind> all() const {
    std::vector<Kind> found;
    for (const node::Effect& effect : effects_) {
      if (const auto* one = std::get_if<Kind>(&effect)) found.push_back(*one);
    }
    return found;
  }
  std::vector<journal::Record> records(const std::string& kind) const {
    std::vector<journal::Record> found;
    for (const node::Log& log : all<node::Log>()) {
      if (log.record.kind() == kind) found.push_back(log.record);
    }
    return found;
  }
  /// What was published of one slot.
  template <class Sample>
  std::vector<Sample> published() const {
    std::vector<Sample> published;
    for (const node::Publish& one : all<node::Publish>()) {
      if (const auto* sample = std::get_if<Sample>(&one.sample)) published.push_back(*sample);
    }
    return published;
  }
  /// The boards of operators apart.
  bool sends_nothing() const {
    return all<node::Send>().empty() && published<wire::MissionState>().empty();
  }
  GroundNode& node() { return node_; }
  const node::Roster& roster() const { return roster_; }

 private:
  static gs::GroundConfig config(gs::Script script, int degree) {
    gs::GroundConfig config;
    config.uavs = {{"marvin", degree, {}}, {"heliv", degree, {}}};
    config.script = std::move(script);
    return config;
  }

  static gs::GroundConfig following(std::vector<gs::ObjectSpec> objects, Duration tell_again) {
    gs::GroundConfig all = config({}, 3);
    all.objects = std::move(objects);
    all.pps.tell_again = tell_again;
    return all;
  }

  node::Roster roster_{{"marvin", "heliv"}};
  GroundNode node_;
  node::Effects effects_;
};

}  // namespace skein::ground::testing
