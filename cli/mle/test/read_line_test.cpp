// SPDX-License-Identifier: Apache-2.0
// What a line of a trace means, and what is said of one that is wrong.
#include <gtest/gtest.h>

#include <string>
#include <variant>

#include "line.hpp"

namespace skein::mle_tool {
namespace {

using executive::Abort;
using executive::Formula;
using executive::Literal;
using executive::MessageReceived;
using executive::Modality;
using executive::Start;
using executive::TaskId;
using executive::TaskInState;
using executive::TaskState;
using executive::TimeIs;
using executive::UpdateConditions;

std::string why(const std::string& text) {
  const Result<TraceLine, Failure> line = read_line(text);
  return line ? "accepted" : line.error().why;
}

std::string start_of(const std::string& task) {
  return R"({"at":6,"request":"START","mode":"SEQ","task":)" + task + "}";
}

std::string with_literal(const std::string& literal) {
  return start_of(R"({"id":2,"type":"goto","pre":[[)" + literal + "]]}");
}

template <class Input>
Input read(const std::string& text) {
  const Result<TraceLine, Failure> line = read_line(text);
  EXPECT_TRUE(line) << text << ": " << why(text);
  if (!line || !std::holds_alternative<Input>(line->input)) {
    ADD_FAILURE() << text;
    return Input();
  }
  return std::get<Input>(line->input);
}

struct Wrong {
  std::string text;
  std::string why;
};

void expect_all(const std::vector<Wrong>& table) {
  for (const Wrong& one : table) EXPECT_EQ(why(one.text), one.why) << one.text;
}

constexpr const char* kNoId = "id: expected an integer from 0 to 18446744073709551615";

// --- lines that mean something -------------------------------------------------------------------

TEST(ReadLine, ReadsEachKindOfLiteral) {
  const Start start = read<Start>(start_of(R"({"id":2,"type":"goto","pre":[
      [{"task":1,"state":"running"},{"message":"m","not":true}],
      [{"time":7.5,"is":"not-yet-passed","modality":"optional","not":false}]]})"));

  const Formula expected{
      {Literal{TaskInState{TaskId(1), TaskState::kRunning}}, Literal{MessageReceived{"m"}, true}},
      {Literal{TimeIs{MissionTime::seconds(7.5), false}, false, Modality::kOptional}}};
  EXPECT_EQ(start.task.preconditions, expected);
  EXPECT_TRUE(start.task.exit.empty());
}

TEST(ReadLine, TellsAnAbsentFormulaFromAnEmptyOne) {
  const auto update =
      read<UpdateConditions>(R"({"at":6,"request":"UPDATE-COND","id":1,"exit":[]})");

  EXPECT_FALSE(update.preconditions.has_value());
  ASSERT_TRUE(update.exit.has_value());
  EXPECT_TRUE(update.exit->empty());
}

TEST(ReadLine, ReadsTheLargestId) {
  const Abort abort = read<Abort>(R"({"at":6,"request":"ABORT","id":18446744073709551615})");

  EXPECT_EQ(abort.id.value(), 18446744073709551615U);
}

TEST(ReadLine, TakesParametersAsTextAndNumbers) {
  const Start start =
      read<Start>(start_of(R"({"id":2,"type":"goto",)"
                           R"("params":{"a":"x","b":2.5,"c":[1,-2],"d":[1,"x"],"e":{"f":null}}})"));
  const executive::Parameters& parameters = start.task.parameters;

  EXPECT_EQ(parameters.find("a")->text, "x");
  EXPECT_EQ(parameters.find("b")->numbers, (std::vector<double>{2.5}));
  EXPECT_EQ(parameters.find("c")->numbers, (std::vector<double>{1, -2}));
  EXPECT_TRUE(parameters.find("d")->numbers.empty());
  EXPECT_EQ(parameters.find("e")->text, R"({"f":null})");
}

TEST(ReadLine, RoundsInstantsToTheNanosecond) {
  const Result<TraceLine, Failure> line =
      read_line(R"({"at":-0.1234567894,"request":"ABORT","id":1})");

  ASSERT_TRUE(line);
  EXPECT_EQ(line->at, MissionTime::nanoseconds(-123456789));
}

TEST(ReadLine, TakesTextOfAMegabyte) {
  const std::string message(1U << 20U, 'm');

  const auto read_back = read<executive::ProcessMessage>(
      R"({"at":6,"request":"PROCESS-MSG","message":")" + message + "\"}");

  EXPECT_EQ(read_back.message, message);
}

// --- lines that are wrong ------------------------------------------------------------------------

TEST(ReadLine, RefusesWhatIsNotJson) {
  expect_all({
      {"", "not JSON, from column 1 on"},
      {"{", "not JSON, from column 2 on"},
      {"at 5 ABORT 1", "not JSON, from column 1 on"},
      {R"({"at":6,"request":"ABORT","id":1},)", "not JSON, from column 34 on"},
      {R"({"at":NaN,"request":"ABORT","id":1})", "not JSON, from column 7 on"},
      {R"({"at":1e999,"request":"ABORT","id":1})", "not JSON: a number out of range"},
      {"{\"at\":6,\"request\":\"PROCESS-MSG\",\"message\":\"\xff\"}",
       "not JSON, from column 44 on"},
      {std::string("\0\0", 2), "not JSON, from column 1 on"},
      {"\"\\ud800\"", "not JSON, from column 8 on"},
  });
}

TEST(ReadLine, RefusesWhatIsNoTraceLine) {
  expect_all({
      {"[]", "expected an object"},
      {"null", "expected an object"},
      {"-1", "expected an object"},
      {"{}", "missing key 'at'"},
      {R"({"at":6})", "expected 'request', 'status', 'sync', 'reachable' or 'airborne'"},
      {R"({"at":6,"stats":{}})", "unknown key 'stats'; did you mean 'status'?"},
      {R"({"at":6,"at":7,"request":"ABORT","id":1})", "key 'at' comes twice"},
      {R"({"at":6,"sync":{"id":1,"from":"a"},"request":"ABORT","id":1})", "unknown key 'sync'"},
      {R"({"at":6,"airborne":"yes"})", "airborne: expected true or false"},
      {R"({"at":6,"reachable":true})", "reachable: expected a string"},
  });
}

TEST(ReadLine, RefusesInstantsOutOfRange) {
  const std::string rest = R"(,"request":"ABORT","id":1})";
  expect_all({
      {"{\"at\":null" + rest, "at: expected a number of seconds"},
      {"{\"at\":\"6\"" + rest, "at: expected a number of seconds"},
      {"{\"at\":9.3e9" + rest, "at: not an instant of mission time"},
      {"{\"at\":-1e308" + rest, "at: not an instant of mission time"},
      {"{\"at\":18446744073709551615" + rest, "at: not an instant of mission time"},
      {with_literal(R"({"time":1e300,"is":"passed"})"),
       "task.pre[0][0].time: not an instant of mission time"},
  });
}

TEST(ReadLine, RefusesIdsThatAreNoUnsignedInteger) {
  for (const char* id : {"-1", "1.0", "1e3", "18446744073709551616", "\"1\"", "null", "[1]"}) {
    EXPECT_EQ(why(R"({"at":6,"request":"ABORT","id":)" + std::string(id) + "}"), kNoId) << id;
  }
}

TEST(ReadLine, RefusesWrongRequests) {
  expect_all({
      {R"({"at":6,"request":"STOP","id":1})",
       "request: unknown word; expected one of START, ABORT, PROCESS-MSG, UPDATE-COND, SUPPRESS"},
      {R"({"at":6,"request":"abort","id":1})",
       "request: unknown word; expected one of START, ABORT, PROCESS-MSG, UPDATE-COND, SUPPRESS; "
       "did you mean 'ABORT'?"},
      {R"({"at":6,"request":"ABORT"})", "missing key 'id'"},
      {R"({"at":6,"request":"ABORT","id":1,"task":1})", "unknown key 'task'"},
      {R"({"at":6,"request":"PROCESS-MSG"})", "missing key 'message'"},
      {R"({"at":6,"request":"PROCESS-MSG","message":["m"]})", "message: expected a string"},
      {R"({"at":6,"request":"UPDATE-COND","id":1,"exits":[]})",
       "unknown key 'exits'; did you mean 'exit'?"},
      {R"({"at":6,"request":"UPDATE-COND","id":1,"pre":null})", "pre: expected an array"},
      {R"({"at":6,"request":"START","task":{"id":1,"type":"goto"}})", "missing key 'mode'"},
      {R"({"at":6,"request":"START","mode":"SEQ"})", "missing key 'task'"},
  });
}

TEST(ReadLine, RefusesWrongTasks) {
  expect_all({
      {start_of("7"), "task: expected an object"},
      {start_of(R"({"type":"goto"})"), "task: missing key 'id'"},
      {start_of(R"({"id":-2,"type":"goto"})"), "task." + std::string(kNoId)},
      {start_of(R"({"id":2,"type":7})"), "task.type: expected a string"},
      {start_of(R"({"id":2,"type":""})"), "task.type: expected a name"},
      {start_of(R"({"id":2,"type":"goto","params":null})"), "task.params: expected an object"},
      {start_of(R"({"id":2,"type":"goto","exit":{}})"), "task.exit: expected an array"},
      {start_of(R"({"id":2,"type":"goto","exit":[{}]})"), "task.exit[0]: expected an array"},
      {start_of(R"({"id":2,"type":"synchronise","params":{"id":1,"senders":["a"]}})"),
       "task.params: missing key 'receivers'"},
      {start_of(R"({"id":2,"type":"synchronise","params":{"id":1,"senders":"a","receivers":[]}})"),
       "task.params.senders: expected an array"},
      {start_of(R"({"id":2,"type":"synchronise",)"
                R"("params":{"id":1,"senders":[],"receivers":[],"deadline":"10"}})"),
       "task.params.deadline: expected a number of seconds"},
  });
}

TEST(ReadLine, RefusesWrongLiterals) {
  const std::string place = "task.pre[0][0]";
  expect_all({
      {with_literal("null"), place + ": expected an object"},
      {with_literal("{}"), place + ": expected a literal with 'task', 'message' or 'time'"},
      {with_literal(R"({"task":1})"), place + ": missing key 'state'"},
      {with_literal(R"({"task":1,"state":3})"), place + ".state: expected a string"},
      {with_literal(R"({"task":-1,"state":"ended"})"),
       place + ".task" + std::string(kNoId).substr(2)},
      {with_literal(R"({"message":7})"), place + ".message: expected a string"},
      {with_literal(R"({"message":"m","state":"ended"})"), place + ": unknown key 'state'"},
      {with_literal(R"({"time":7})"), place + ": missing key 'is'"},
      {with_literal(R"({"message":"m","not":null})"), place + ".not: expected true or false"},
      {with_literal(R"({"message":"m","modality":"optionel"})"),
       place + ".modality: unknown word; expected one of mandatory, optional; did you mean "
               "'optional'?"},
  });
}

TEST(ReadLine, RefusesDeepNestingWithoutRunningOutOfStack) {
  const std::string open(10'000, '[');
  const std::string close(10'000, ']');
  std::string objects;
  for (int i = 0; i < 10'000; ++i) objects += "{\"a\":";

  EXPECT_EQ(why(open + close), "nested more than 32 deep");
  EXPECT_EQ(why(open), "not JSON, from column 10001 on");
  EXPECT_EQ(why(objects + "1" + std::string(10'000, '}')), "nested more than 32 deep");
  EXPECT_EQ(why(start_of(R"({"id":2,"type":"goto","params":{"a":)" + open + close + "}}")),
            "nested more than 32 deep");
}

TEST(ReadLine, KeepsItsComplaintShortHoweverLongTheWord) {
  const std::string word(1U << 20U, 'x');

  EXPECT_LT(why(R"({"at":6,"request":")" + word + "\"}").size(), 200U);
  EXPECT_LT(why("{\"at\":6,\"request\":\"ABORT\",\"id\":1,\"" + word + "\":1}").size(), 200U);
  EXPECT_LT(why("{\"" + word + "\":1,\"" + word + "\":1}").size(), 200U);
}

}  // namespace
}  // namespace skein::mle_tool
