// SPDX-License-Identifier: Apache-2.0
// From JSON to inputs of the executive.
#include "line.hpp"
#include "skein/trace_lines/json_node.hpp"

namespace skein::mle_tool {

using executive::Abort;
using executive::Clause;
using executive::Condition;
using executive::Flight;
using executive::Formula;
using executive::FunctionalStatus;
using executive::Input;
using executive::InsertionMode;
using executive::Literal;
using executive::MessageReceived;
using executive::Modality;
using executive::Parameter;
using executive::Parameters;
using executive::PeerReachable;
using executive::ProcessMessage;
using executive::RequestKind;
using executive::Start;
using executive::Suppress;
using executive::Synchronisation;
using executive::SyncReceived;
using executive::SyncWord;
using executive::Task;
using executive::TaskId;
using executive::TaskInState;
using executive::TaskState;
using executive::TimeIs;
using executive::TypeTable;
using executive::UpdateConditions;
using trace_lines::Json;
using trace_lines::Node;
using trace_lines::WrongValue;

namespace {

TaskId task_id(const Node& node) { return TaskId(node.id()); }

TaskState state(const Node& node) {
  return static_cast<TaskState>(
      node.one_of({"scheduled", "started", "running", "aborting", "ended", "aborted"}));
}

// --- conditions ----------------------------------------------------------------------------------

Condition condition(const Node& node) {
  if (node.has("task")) {
    node.expect_keys({"task", "state", "not", "modality"});
    return TaskInState{task_id(node.at("task")), state(node.at("state"))};
  }
  if (node.has("message")) {
    node.expect_keys({"message", "not", "modality"});
    return MessageReceived{node.at("message").text()};
  }
  node.expect_keys({"time", "is", "not", "modality"});
  if (!node.has("time")) node.wrong("expected a literal with 'task', 'message' or 'time'");
  return TimeIs{node.at("time").instant(), node.at("is").one_of({"passed", "not-yet-passed"}) == 0};
}

Literal literal(const Node& node) {
  Literal result{condition(node)};
  if (node.has("not")) result.negated = node.at("not").flag();
  if (node.has("modality")) {
    result.modality = static_cast<Modality>(node.at("modality").one_of({"mandatory", "optional"}));
  }
  return result;
}

Formula formula(const Node& node) {
  Formula result;
  for (const Node& clause : node.items()) {
    Clause& literals = result.emplace_back();
    for (const Node& one : clause.items()) literals.push_back(literal(one));
  }
  return result;
}

std::optional<Formula> optional_formula(const Node& node, std::string_view key) {
  if (!node.has(key)) return std::nullopt;
  return formula(node.at(key));
}

// --- tasks ---------------------------------------------------------------------------------------

Synchronisation synchronisation(const Node& node) {
  node.expect_keys({"id", "senders", "receivers", "deadline"});
  Synchronisation result;
  result.id = node.at("id").id();
  result.senders = node.at("senders").names();
  result.receivers = node.at("receivers").names();
  if (node.has("deadline")) result.deadline = node.at("deadline").instant();
  return result;
}

// Any JSON value: its text, and its numbers if it is a number or an array of numbers.
Parameter parameter(const std::string& name, const Json& value) {
  Parameter result{name, value.is_string() ? value.get<std::string>() : value.dump(), {}};
  if (value.is_number()) result.numbers.push_back(value.get<double>());
  if (!value.is_array()) return result;
  for (const Json& one : value) {
    if (!one.is_number()) {
      result.numbers.clear();
      break;
    }
    result.numbers.push_back(one.get<double>());
  }
  return result;
}

Parameters parameters(const Node& node) {
  if (!node.json().is_object()) node.wrong("expected an object");
  Parameters result;
  for (const auto& [name, value] : node.json().items()) result.add(parameter(name, value));
  return result;
}

Task task(const Node& node) {
  node.expect_keys({"id", "type", "params", "pre", "exit"});
  Task result;
  result.id = task_id(node.at("id"));
  result.type = node.at("type").text();
  if (result.type.empty()) node.at("type").wrong("expected a name");
  if (functional::TaskTypes::shipped().of(result.type).synchronises()) {
    result.synchronisation = synchronisation(node.at("params"));
  } else if (node.has("params")) {
    result.parameters = parameters(node.at("params"));
  }
  result.preconditions = optional_formula(node, "pre").value_or(Formula());
  result.exit = optional_formula(node, "exit").value_or(Formula());
  return result;
}

// --- lines ---------------------------------------------------------------------------------------

Input request(const Node& node) {
  const std::size_t kind =
      node.at("request").one_of({"START", "ABORT", "PROCESS-MSG", "UPDATE-COND", "SUPPRESS"});
  switch (static_cast<RequestKind>(kind)) {
    case RequestKind::kStart: {
      node.expect_keys({"at", "request", "mode", "task"});
      const std::size_t mode = node.at("mode").one_of({"SEQ", "VUT", "DEP", "NUT"});
      return Start{task(node.at("task")), static_cast<InsertionMode>(mode)};
    }
    case RequestKind::kAbort:
      node.expect_keys({"at", "request", "id"});
      return Abort{task_id(node.at("id"))};
    case RequestKind::kProcessMessage:
      node.expect_keys({"at", "request", "message"});
      return ProcessMessage{node.at("message").text()};
    case RequestKind::kUpdateConditions:
      node.expect_keys({"at", "request", "id", "pre", "exit"});
      return UpdateConditions{task_id(node.at("id")), optional_formula(node, "pre"),
                              optional_formula(node, "exit")};
    case RequestKind::kSuppress:
      break;
  }
  node.expect_keys({"at", "request", "id"});
  return Suppress{task_id(node.at("id"))};
}

Input status(const Node& node) {
  node.expect_keys({"task", "state", "reason"});
  return FunctionalStatus{task_id(node.at("task")), state(node.at("state")),
                          node.has("reason") ? node.at("reason").text() : ""};
}

Input sync(const Node& node) {
  node.expect_keys({"id", "from", "word", "said"});
  SyncReceived message{node.at("id").id(), node.at("from").text()};
  if (node.has("word")) {
    message.word = static_cast<SyncWord>(node.at("word").one_of({"there", "done", "withdrawn"}));
  }
  if (node.has("said")) message.said = node.at("said").instant();
  return message;
}

Input input(const Node& node) {
  if (node.has("request")) return request(node);
  if (node.has("status")) {
    node.expect_keys({"at", "status"});
    return status(node.at("status"));
  }
  if (node.has("sync")) {
    node.expect_keys({"at", "sync"});
    return sync(node.at("sync"));
  }
  if (node.has("reachable")) {
    node.expect_keys({"at", "reachable"});
    return PeerReachable{node.at("reachable").text()};
  }
  node.expect_keys({"at", "request", "status", "sync", "reachable", "airborne"});
  if (!node.has("airborne"))
    node.wrong("expected 'request', 'status', 'sync', 'reachable' or 'airborne'");
  return Flight{node.at("airborne").flag()};
}

}  // namespace

Result<TraceLine, Failure> read_line(std::string_view text) {
  return trace_lines::read_timed<TraceLine>(text, input);
}

Result<TypeTable, Failure> read_types(std::string_view text) {
  const Result<Json, Failure> json = trace_lines::parse(text);
  if (!json) return tl::unexpected<Failure>(json.error());
  try {
    const Node node(*json, "");
    if (!json->is_object()) node.wrong("expected an object of types");
    TypeTable table = TypeTable::elementary();
    for (const auto& [type, value] : json->items()) {
      if (type.empty()) node.wrong("a type has an empty name");
      const Node declaration = node.at(type);
      declaration.expect_keys({"resources"});
      table.declare(type, declaration.at("resources").names());
    }
    return table;
  } catch (const WrongValue& wrong) {
    return failure(wrong.why);
  } catch (const Json::exception& error) {
    return failure(error.what());
  }
}

}  // namespace skein::mle_tool
