// SPDX-License-Identifier: Apache-2.0
// From JSON to inputs of the engine.
#include "line.hpp"
#include "skein/trace_lines/json_node.hpp"

namespace skein::model_tool {

using interaction::Input;
using interaction::ScmReport;
using interaction::Status;
using trace_lines::Json;
using trace_lines::Node;
using trace_lines::WrongValue;

namespace {

void expect_true(const Node& node) {
  if (!node.flag()) node.wrong("expected true");
}

Input status(const Node& node) {
  node.expect_keys({"componel", "state"});
  return Status{
      node.at("componel").text(),
      static_cast<Status::Word>(node.at("state").one_of({"running", "ended", "aborted"}))};
}

Input input(const Node& node) {
  if (node.has("start")) {
    node.expect_keys({"at", "start"});
    expect_true(node.at("start"));
    return interaction::Start{};
  }
  if (node.has("abort")) {
    node.expect_keys({"at", "abort"});
    expect_true(node.at("abort"));
    return interaction::Abort{};
  }
  if (node.has("status")) {
    node.expect_keys({"at", "status"});
    return status(node.at("status"));
  }
  if (node.has("message")) {
    node.expect_keys({"at", "message"});
    return interaction::Message{node.at("message").text()};
  }
  if (!node.has("scm")) node.wrong("expected 'start', 'abort', 'status', 'message' or 'scm'");
  node.expect_keys({"at", "scm", "state"});
  return ScmReport{node.at("scm").text(), static_cast<ScmReport::Finding>(node.at("state").one_of(
                                              {"violated", "satisfied", "undetermined"}))};
}

}  // namespace

Result<TraceLine, Failure> read_line(std::string_view text) {
  return trace_lines::read_timed<TraceLine>(text, input);
}

}  // namespace skein::model_tool
