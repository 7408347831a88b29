// SPDX-License-Identifier: Apache-2.0
// A decision node with the world around it: samples in, and what goes out as short words.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "skein/ddn/ddn_node.hpp"
#include "skein/translation/tasks.hpp"

namespace skein::ddn {
using decision_node::ContactPolicy;
}  // namespace skein::ddn

namespace skein::ddn::testing {

inline MissionTime at(double seconds) { return MissionTime::seconds(seconds); }

// ---- what comes in ----

inline executive::Task a_task(std::uint64_t id, const std::string& type) {
  executive::Task task;
  task.id = executive::TaskId(id);
  task.type = type;
  return task;
}

inline executive::Literal in_state(std::uint64_t id, executive::TaskState state) {
  return {executive::TaskInState{executive::TaskId(id), state}, false,
          executive::Modality::kMandatory};
}

inline wire::TaskRequest command(std::uint64_t number, const translation::Request& request) {
  wire::TaskRequest sample = translation::to_wire(request);
  sample.command = number;
  sample.header.incarnation = 1;
  return sample;
}

inline wire::TaskRequest start(std::uint64_t number, executive::Task task,
                               executive::InsertionMode mode = executive::InsertionMode::kSeq) {
  return command(number, executive::Start{std::move(task), mode});
}

inline wire::DegreeCommand degree(std::uint64_t number, int wanted) {
  wire::DegreeCommand sample;
  sample.header.incarnation = 1;
  sample.command = number;
  sample.degree = static_cast<std::uint8_t>(wanted);
  sample.resume = true;
  sample.asked_by = "operator";
  return sample;
}
inline wire::DegreeCommand interrupting(wire::DegreeCommand sample) {
  sample.interrupt = true;
  return sample;
}

inline wire::FunctionalRequest dispatch(std::uint64_t id, const std::string& type) {
  wire::FunctionalRequest request;
  request.uav = "marvin";
  request.id = id;
  request.type = type;
  return request;
}

inline wire::FunctionalStatus status(std::uint64_t id, wire::TaskState state,
                                     const std::string& reason = "") {
  wire::FunctionalStatus sample;
  sample.uav = "marvin";
  sample.id = id;
  sample.state = state;
  sample.reason = reason;
  return sample;
}

inline wire::Telemetry telemetry(bool airborne) {
  wire::Telemetry sample;
  sample.uav = "marvin";
  sample.airborne = airborne;
  return sample;
}

inline wire::SyncMessage sync(std::uint64_t id, const std::string& from, const std::string& to) {
  wire::SyncMessage message;
  message.id = id;
  message.from = from;
  message.to = to;
  return message;
}

inline executive::Task rendezvous(std::uint64_t id, std::uint64_t synchronisation) {
  executive::Task task = a_task(id, "synchronise");
  task.synchronisation =
      executive::Synchronisation{synchronisation, {"marvin", "heliv"}, {"marvin", "heliv"}, {}};
  return task;
}

// ---- what goes out ----

/// "reply 7 accepted", "dispatch 1 goto", "1 running", …
inline std::string say(const wire::RequestReply& it) {
  return "reply " + std::to_string(it.command) +
         (it.accepted ? " accepted" : " refused: " + it.why);
}
inline std::string say(const wire::TaskEvent& it) {
  return std::to_string(it.id) + " " + std::string(name_of(it.state));
}
inline std::string say(const wire::FunctionalRequest& it) {
  const bool dispatches = it.kind == wire::FunctionalRequestKind::kDispatch;
  return std::string(name_of(it.kind)) + " " + std::to_string(it.id) +
         (dispatches ? " " + it.type : "");
}
inline std::string say(const wire::FunctionalStatus& it) {
  return "status " + std::to_string(it.id) + " " + std::string(name_of(it.state));
}
inline std::string say(const wire::SyncMessage& it) {
  return "sync " + std::to_string(it.id) + " " + it.from + ">" + it.to;
}
inline std::string say(const wire::Telemetry&) { return "telemetry"; }
inline std::string say(const wire::PerceptionReport&) { return "perception"; }
inline std::string say(const wire::Sighting&) { return "sighting"; }
inline std::string say(const wire::AutonomyDegree& it) {
  return "degree " + std::to_string(it.degree);
}
/// "hand-over 2: 4 running, 5 scheduled, (100)"; in brackets what is only planned.
inline std::string say(const wire::HandOver& it) {
  std::string text = "hand-over " + std::to_string(it.degree) + ":";
  const char* separator = " ";
  for (const wire::HeldTask& held : it.tasks) {
    const std::string id = std::to_string(held.task.id);
    text += separator +
            (held.in_executive ? id + " " + std::string(name_of(held.state)) : "(" + id + ")");
    separator = ", ";
  }
  return text;
}
inline std::string say(const wire::MissionOutcome& it) {
  return "mission " + std::to_string(it.unit_mission) + (it.planned ? " planned" : " not planned");
}
template <class Other>
std::string say(const Other&) {
  return "?";
}

/// The node of "marvin" in a team with "heliv".
class Bench {
 public:
  explicit Bench(DdnConfig config)
      : roster_({"marvin", "heliv"}), node_(std::move(config), roster_) {}

  static DdnConfig at_degree(int degree) {
    DdnConfig config;
    config.uav = "marvin";
    config.degree = degree;
    return config;
  }
  static DdnConfig with_policy(int degree, ContactPolicy policy) {
    DdnConfig config = at_degree(degree);
    config.contact_policy = policy;
    config.contact_after = Duration::seconds(30);
    config.home = {1, 2, 50};
    return config;
  }

  /// Gives the input now; what goes out, but for plans, decisions and the log, as "to: word".
  std::vector<std::string> give(const node::Input& input) {
    effects_ = node_.handle(input, now_);
    std::vector<std::string> words;
    for (const node::Effect& effect : effects_) {
      const auto* send = std::get_if<node::Send>(&effect);
      if (send == nullptr || is_report(send->sample)) continue;
      words.push_back(roster_.name_of(send->to) + ": " +
                      std::visit([](const auto& it) { return say(it); }, send->sample));
    }
    return words;
  }
  std::vector<std::string> from_ground(wire::Sample sample) {
    return give(node::Received{roster_.ground(), std::move(sample)});
  }
  std::vector<std::string> from_sim(wire::Sample sample) {
    return give(node::Received{roster_.sim(), std::move(sample)});
  }
  std::vector<std::string> from_heliv(wire::Sample sample) {
    return give(node::Received{heliv(), std::move(sample)});
  }
  std::vector<std::string> hear(node::NodeNumber peer, bool reachable) {
    return give(node::Reachability{peer, reachable, false});
  }
  std::vector<std::string> hear_ground(bool reachable) { return hear(roster_.ground(), reachable); }
  std::vector<std::string> wake_at(double seconds) {
    now_ = at(seconds);
    return give(node::Wakeup{});
  }

  void set_time(double seconds) { now_ = at(seconds); }
  node::NodeNumber heliv() const { return roster_.find("heliv")->number; }
  const node::Roster& roster() const { return roster_; }
  DdnNode& node() { return node_; }

  /// Of the last input.
  const node::Effects& effects() const { return effects_; }
  std::vector<wire::PlanBoard> boards() const {
    std::vector<wire::PlanBoard> boards;
    for (const node::Effect& effect : effects_) {
      const auto* send = std::get_if<node::Send>(&effect);
      if (send == nullptr) continue;
      if (const auto* board = std::get_if<wire::PlanBoard>(&send->sample)) boards.push_back(*board);
    }
    return boards;
  }
  std::vector<journal::Record> records(const std::string& kind) const {
    std::vector<journal::Record> records;
    for (const node::Effect& effect : effects_) {
      const auto* log = std::get_if<node::Log>(&effect);
      if (log != nullptr && log->record.kind() == kind) records.push_back(log->record);
    }
    return records;
  }
  template <class Sample>
  const Sample* sent() const {
    for (const node::Effect& effect : effects_) {
      const auto* send = std::get_if<node::Send>(&effect);
      if (send == nullptr) continue;
      if (const auto* sample = std::get_if<Sample>(&send->sample)) return sample;
    }
    return nullptr;
  }

  std::vector<node::StartJob> jobs() const {
    std::vector<node::StartJob> jobs;
    for (const node::Effect& effect : effects_) {
      if (const auto* job = std::get_if<node::StartJob>(&effect)) jobs.push_back(*job);
    }
    return jobs;
  }

 private:
  static bool is_report(const wire::Sample& sample) {
    return std::holds_alternative<wire::PlanBoard>(sample) ||
           std::holds_alternative<wire::MissionPlan>(sample) ||
           std::holds_alternative<wire::Decision>(sample);
  }

  node::Roster roster_;
  DdnNode node_;
  MissionTime now_;
  node::Effects effects_;
};

}  // namespace skein::ddn::testing
