// SPDX-License-Identifier: Apache-2.0
// Tasks, conditions, requests and their answers: wire to domain and back.
#pragma once

#include <variant>

#include "skein/blackboard/wire.hpp"
#include "skein/executive/effect.hpp"
#include "skein/executive/input.hpp"
#include "skein/executive/task.hpp"
#include "skein/functional/port.hpp"

namespace skein::translation {

/// The five requests of spec 2.3.
using Request = std::variant<executive::Start, executive::Abort, executive::ProcessMessage,
                             executive::UpdateConditions, executive::Suppress>;

wire::TaskState to_wire(executive::TaskState state);
executive::TaskState from_wire(wire::TaskState state);
wire::RequestKind to_wire(executive::RequestKind kind);

std::vector<wire::Clause> to_wire(const executive::Formula& formula);
executive::Formula from_wire(const std::vector<wire::Clause>& clauses);

std::vector<wire::Parameter> to_wire(const functional::Parameters& parameters);
functional::Parameters from_wire(const std::vector<wire::Parameter>& parameters);

wire::FunctionalRequest to_wire(const std::string& uav, const functional::Request& request);
functional::Request from_wire(const wire::FunctionalRequest& request);
wire::FunctionalStatus to_wire(const std::string& uav, const functional::Status& status);
functional::Status from_wire(const wire::FunctionalStatus& status);

wire::TaskSpec to_wire(const executive::Task& task);
executive::Task from_wire(const wire::TaskSpec& spec);

/// Without its command number.
wire::TaskRequest to_wire(const Request& request);
Request from_wire(const wire::TaskRequest& request);

/// The request as the executive's input.
executive::Input to_input(const Request& request);

executive::TaskEvent from_wire(const wire::TaskEvent& event);

wire::SyncMessage to_wire(const executive::SendSync& message, const std::string& from,
                          MissionTime said);
executive::SyncReceived from_wire(const wire::SyncMessage& message);

wire::TaskEvent to_wire(const std::string& uav, const executive::TaskEvent& event, MissionTime at);

}  // namespace skein::translation
