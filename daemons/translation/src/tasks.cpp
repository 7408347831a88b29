// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/tasks.hpp"

#include "skein/foundation/overloaded.hpp"

namespace skein::translation {

namespace {

// The enumerations of both sides list the same values in the same order.
static_assert(static_cast<int>(wire::TaskState::kAborted) ==
              static_cast<int>(executive::TaskState::kAborted));
static_assert(static_cast<int>(wire::AbortCause::kNoAir) ==
              static_cast<int>(functional::AbortCause::kNoAir));
static_assert(static_cast<int>(wire::RequestKind::kSuppress) ==
              static_cast<int>(executive::RequestKind::kSuppress));
static_assert(static_cast<int>(wire::InsertionMode::kNut) ==
              static_cast<int>(executive::InsertionMode::kNut));
static_assert(static_cast<int>(wire::SyncWord::kWithdrawn) ==
              static_cast<int>(executive::SyncWord::kWithdrawn));

wire::Literal to_wire(const executive::Literal& literal) {
  wire::Literal result;
  std::visit(Overloaded{[&](const executive::TaskInState& c) {
                          result.kind = wire::LiteralKind::kTaskState;
                          result.task = c.task.value();
                          result.state = translation::to_wire(c.state);
                        },
                        [&](const executive::MessageReceived& c) {
                          result.kind = wire::LiteralKind::kMessage;
                          result.message = c.message;
                        },
                        [&](const executive::TimeIs& c) {
                          result.kind = wire::LiteralKind::kTime;
                          result.instant = c.instant.count();
                          result.passed = c.passed;
                        }},
             literal.condition);
  result.negated = literal.negated;
  result.is_optional = literal.modality == executive::Modality::kOptional;
  return result;
}

executive::Condition condition_of(const wire::Literal& literal) {
  switch (literal.kind) {
    case wire::LiteralKind::kMessage:
      return executive::MessageReceived{literal.message};
    case wire::LiteralKind::kTime:
      return executive::TimeIs{MissionTime::nanoseconds(literal.instant), literal.passed};
    default:
      break;
  }
  return executive::TaskInState{executive::TaskId(literal.task), from_wire(literal.state)};
}

executive::Literal from_wire(const wire::Literal& literal) {
  return {condition_of(literal), literal.negated,
          literal.is_optional ? executive::Modality::kOptional : executive::Modality::kMandatory};
}

}  // namespace

wire::TaskState to_wire(executive::TaskState state) { return static_cast<wire::TaskState>(state); }

executive::TaskState from_wire(wire::TaskState state) {
  return static_cast<executive::TaskState>(state);
}

wire::RequestKind to_wire(executive::RequestKind kind) {
  return static_cast<wire::RequestKind>(kind);
}

std::vector<wire::Clause> to_wire(const executive::Formula& formula) {
  std::vector<wire::Clause> clauses;
  for (const executive::Clause& clause : formula) {
    wire::Clause& result = clauses.emplace_back();
    for (const executive::Literal& literal : clause) result.literals.push_back(to_wire(literal));
  }
  return clauses;
}

executive::Formula from_wire(const std::vector<wire::Clause>& clauses) {
  executive::Formula formula;
  for (const wire::Clause& clause : clauses) {
    executive::Clause& result = formula.emplace_back();
    for (const wire::Literal& literal : clause.literals) result.push_back(from_wire(literal));
  }
  return formula;
}

std::vector<wire::Parameter> to_wire(const functional::Parameters& parameters) {
  std::vector<wire::Parameter> result;
  for (const functional::Parameter& one : parameters.all()) {
    result.push_back({one.name, one.text, one.numbers});
  }
  return result;
}

functional::Parameters from_wire(const std::vector<wire::Parameter>& parameters) {
  std::vector<functional::Parameter> result;
  for (const wire::Parameter& one : parameters) result.push_back({one.name, one.text, one.numbers});
  return functional::Parameters(std::move(result));
}

// ---- the port to the vehicle ----

wire::FunctionalRequest to_wire(const std::string& uav, const functional::Request& request) {
  wire::FunctionalRequest sample;
  sample.uav = uav;
  sample.kind = request.verb == functional::Verb::kDispatch
                    ? wire::FunctionalRequestKind::kDispatch
                    : wire::FunctionalRequestKind::kInterrupt;
  sample.id = request.id.value();
  sample.type = request.type;
  sample.parameters = to_wire(request.parameters);
  return sample;
}

functional::Request from_wire(const wire::FunctionalRequest& sample) {
  const bool dispatches = sample.kind == wire::FunctionalRequestKind::kDispatch;
  return {dispatches ? functional::Verb::kDispatch : functional::Verb::kInterrupt,
          functional::TaskId(sample.id), sample.type, from_wire(sample.parameters)};
}

wire::FunctionalStatus to_wire(const std::string& uav, const functional::Status& status) {
  wire::FunctionalStatus sample;
  sample.uav = uav;
  sample.id = status.id.value();
  sample.state = to_wire(status.state);
  sample.reason = status.reason;
  sample.cause = static_cast<wire::AbortCause>(status.cause);
  return sample;
}

functional::Status from_wire(const wire::FunctionalStatus& sample) {
  return {functional::TaskId(sample.id), from_wire(sample.state), sample.reason,
          static_cast<functional::AbortCause>(sample.cause)};
}

wire::TaskSpec to_wire(const executive::Task& task) {
  wire::TaskSpec spec;
  spec.id = task.id.value();
  spec.type = task.type;
  spec.parameters = to_wire(task.parameters);
  spec.preconditions = to_wire(task.preconditions);
  spec.exit_conditions = to_wire(task.exit);
  if (const auto& sync = task.synchronisation) {
    spec.has_synchronisation = true;
    spec.synchronisation = sync->id;
    spec.senders = sync->senders;
    spec.receivers = sync->receivers;
    spec.has_deadline = sync->deadline.has_value();
    spec.deadline = sync->deadline.value_or(MissionTime()).count();
  }
  return spec;
}

executive::Task from_wire(const wire::TaskSpec& spec) {
  executive::Task task;
  task.id = executive::TaskId(spec.id);
  task.type = spec.type;
  task.parameters = from_wire(spec.parameters);
  task.preconditions = from_wire(spec.preconditions);
  task.exit = from_wire(spec.exit_conditions);
  if (spec.has_synchronisation) {
    executive::Synchronisation sync{spec.synchronisation, spec.senders, spec.receivers, {}};
    if (spec.has_deadline) sync.deadline = MissionTime::nanoseconds(spec.deadline);
    task.synchronisation = std::move(sync);
  }
  return task;
}

wire::TaskRequest to_wire(const Request& request) {
  wire::TaskRequest result;
  std::visit(Overloaded{[&](const executive::Start& r) {
                          result.kind = wire::RequestKind::kStart;
                          result.mode = static_cast<wire::InsertionMode>(r.mode);
                          result.task = to_wire(r.task);
                        },
                        [&](const executive::Abort& r) {
                          result.kind = wire::RequestKind::kAbort;
                          result.id = r.id.value();
                        },
                        [&](const executive::ProcessMessage& r) {
                          result.kind = wire::RequestKind::kProcessMessage;
                          result.message = r.message;
                        },
                        [&](const executive::UpdateConditions& r) {
                          result.kind = wire::RequestKind::kUpdateConditions;
                          result.id = r.id.value();
                          result.has_preconditions = r.preconditions.has_value();
                          result.has_exit_conditions = r.exit.has_value();
                          if (r.preconditions) result.preconditions = to_wire(*r.preconditions);
                          if (r.exit) result.exit_conditions = to_wire(*r.exit);
                        },
                        [&](const executive::Suppress& r) {
                          result.kind = wire::RequestKind::kSuppress;
                          result.id = r.id.value();
                        }},
             request);
  return result;
}

Request from_wire(const wire::TaskRequest& request) {
  const executive::TaskId id(request.id);
  switch (request.kind) {
    case wire::RequestKind::kStart:
      return executive::Start{from_wire(request.task),
                              static_cast<executive::InsertionMode>(request.mode)};
    case wire::RequestKind::kAbort:
      return executive::Abort{id};
    case wire::RequestKind::kProcessMessage:
      return executive::ProcessMessage{request.message};
    case wire::RequestKind::kUpdateConditions: {
      executive::UpdateConditions update{id, std::nullopt, std::nullopt};
      if (request.has_preconditions) update.preconditions = from_wire(request.preconditions);
      if (request.has_exit_conditions) update.exit = from_wire(request.exit_conditions);
      return update;
    }
    default:
      break;
  }
  return executive::Suppress{id};
}

executive::Input to_input(const Request& request) {
  return std::visit([](const auto& one) { return executive::Input(one); }, request);
}

wire::TaskEvent to_wire(const std::string& uav, const executive::TaskEvent& event, MissionTime at) {
  wire::TaskEvent result;
  result.uav = uav;
  result.id = event.id.value();
  result.type = event.type;
  result.state = to_wire(event.state);
  result.reason = event.reason;
  result.cause = static_cast<wire::AbortCause>(event.cause);
  result.at = at.count();
  return result;
}

executive::TaskEvent from_wire(const wire::TaskEvent& event) {
  return {executive::TaskId(event.id), event.type, from_wire(event.state), event.reason,
          static_cast<functional::AbortCause>(event.cause)};
}

wire::SyncMessage to_wire(const executive::SendSync& message, const std::string& from,
                          MissionTime said) {
  wire::SyncMessage result;
  result.id = message.id;
  result.from = from;
  result.to = message.to;
  result.word = static_cast<wire::SyncWord>(message.word);
  result.said = said.count();
  return result;
}

executive::SyncReceived from_wire(const wire::SyncMessage& message) {
  return {message.id, message.from, static_cast<executive::SyncWord>(message.word),
          MissionTime::nanoseconds(message.said)};
}

}  // namespace skein::translation
