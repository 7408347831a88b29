// SPDX-License-Identifier: Apache-2.0
// Options, exit codes and streams of `skein mle`.
#include "skein/mle_tool/mle.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace skein::mle_tool {
namespace {

using testing::HasSubstr;
using testing::Not;

struct Replayed {
  int code = 0;
  std::string out;
  std::string err;
};

Replayed replay(const std::string& trace, const MleOptions& options = {}) {
  std::istringstream in(trace);
  std::ostringstream out;
  std::ostringstream err;
  const int code = run_mle(options, in, out, err);
  return Replayed{code, out.str(), err.str()};
}

std::string start(double at, int id, const std::string& type, const std::string& mode = "SEQ",
                  const std::string& rest = "") {
  std::ostringstream line;
  line << "{\"at\":" << at << ",\"request\":\"START\",\"mode\":\"" << mode
       << "\",\"task\":{\"id\":" << id << ",\"type\":\"" << type << '"' << rest << "}}\n";
  return line.str();
}

constexpr const char* kAtTen = R"(,"pre":[[{"time":10,"is":"passed"}]])";

/// A file of the test's own, gone with it.
class File {
 public:
  explicit File(const std::string& content)
      : path_(testing::TempDir() + "mle_test_" +
              testing::UnitTest::GetInstance()->current_test_info()->name() + ".json") {
    std::ofstream(path_) << content;
  }
  ~File() { std::filesystem::remove(path_); }
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

// --- exit codes and streams ----------------------------------------------------------------------

TEST(Mle, GivesNothingForAnEmptyTrace) {
  const Replayed replayed = replay("");

  EXPECT_EQ(replayed.code, 0);
  EXPECT_EQ(replayed.out, "");
}

TEST(Mle, CountsARefusedRequestAsNoFault) {
  const Replayed replayed = replay("{\"at\":1,\"request\":\"ABORT\",\"id\":7}\n");

  EXPECT_EQ(replayed.code, 0);
  EXPECT_EQ(replayed.out,
            "{\"at\":1,\"refused\":\"ABORT\",\"id\":7,\"why\":\"task 7 is not in the plan\"}\n");
}

TEST(Mle, RefusesAWrongLineByItsNumberAndGoesOn) {
  MleOptions options;
  options.input_name = "trace.jsonl";

  const Replayed replayed = replay("\n{}\n" + start(2, 1, "goto"), options);

  EXPECT_EQ(replayed.code, 1);
  EXPECT_EQ(replayed.out,
            "{\"at\":0,\"refused\":\"line\",\"line\":2,\"why\":\"missing key 'at'\"}\n"
            "{\"at\":2,\"task\":1,\"state\":\"scheduled\"}\n"
            "{\"at\":2,\"task\":1,\"state\":\"started\"}\n"
            "{\"at\":2,\"dispatch\":1}\n");
  EXPECT_EQ(replayed.err, "trace.jsonl:2: missing key 'at'\n");
}

TEST(Mle, LeavesTimeWhereItWasOnAWrongLine) {
  const std::string trace = start(0, 1, "goto", "SEQ", kAtTen) +
                            "{\"at\":20,\"request\":\"ABORT\"}\n" +
                            "{\"at\":5,\"request\":\"ABORT\",\"id\":1}\n";

  const Replayed replayed = replay(trace);

  EXPECT_THAT(replayed.out, HasSubstr("{\"at\":5,\"task\":1,\"state\":\"aborted\"}"));
  EXPECT_THAT(replayed.out, Not(HasSubstr("dispatch")));
}

TEST(Mle, ReadsALastLineThatDoesNotEndAndLinesThatEndAsOnWindows) {
  std::string trace = start(0, 1, "goto") + start(1, 2, "takeshot");
  trace.pop_back();
  const std::size_t end = trace.find('\n');

  const Replayed plain = replay(trace);
  const Replayed windows = replay(trace.insert(end, "\r"));

  EXPECT_THAT(plain.out, HasSubstr("{\"at\":1,\"dispatch\":2}\n"));
  EXPECT_EQ(windows.out, plain.out);
}

TEST(Mle, RefusesALineThatIsTooLongAndGoesOn) {
  const std::string trace = std::string(3U << 20U, '[') + '\n' + start(0, 1, "goto");

  const Replayed replayed = replay(trace);

  EXPECT_EQ(replayed.code, 1);
  EXPECT_THAT(replayed.out, HasSubstr("\"line\":1,\"why\":\"longer than 1048576 bytes\""));
  EXPECT_THAT(replayed.out, HasSubstr("\"dispatch\":1"));
}

TEST(Mle, SaysOnTheErrorStreamOnlyWhatIsForTheLog) {
  const Replayed replayed =
      replay(start(0, 1, "goto") + "{\"at\":1,\"status\":{\"task\":9,\"state\":\"ended\"}}\n");

  EXPECT_EQ(replayed.code, 0);
  EXPECT_EQ(replayed.err, "at 1: status 'ended' of unknown task 9\n");
  EXPECT_THAT(replayed.out, Not(HasSubstr("unknown")));
}

TEST(Mle, FailsOnATraceThatCannotBeRead) {
  std::ifstream in(testing::TempDir());
  std::ostringstream out;
  std::ostringstream err;

  EXPECT_EQ(run_mle(MleOptions(), in, out, err), 2);

  EXPECT_EQ(err.str(), "standard input: cannot be read\n");
}

// --- options -------------------------------------------------------------------------------------

TEST(MleOptions, RunTimeOnOnlyWhenUntilIsGiven) {
  const std::string trace = start(0, 1, "goto", "SEQ", kAtTen);
  MleOptions early;
  early.until = MissionTime::seconds(9.999);
  MleOptions late;
  late.until = MissionTime::seconds(10);

  EXPECT_THAT(replay(trace).out, Not(HasSubstr("dispatch")));
  EXPECT_THAT(replay(trace, early).out, Not(HasSubstr("dispatch")));
  EXPECT_THAT(replay(trace, late).out, HasSubstr("{\"at\":10,\"dispatch\":1}"));
}

TEST(MleOptions, LeaveTimeOutAndBackgroundOffByDefault) {
  MleOptions options;
  options.until = MissionTime::seconds(1e6);

  const Replayed replayed =
      replay("{\"at\":0,\"airborne\":true}\n" + start(0, 1, "takeshot"), options);

  EXPECT_EQ(replayed.out,
            "{\"at\":0,\"task\":1,\"state\":\"scheduled\"}\n"
            "{\"at\":0,\"task\":1,\"state\":\"started\"}\n"
            "{\"at\":0,\"dispatch\":1}\n");
}

TEST(MleOptions, AbortWhatIsNotAnsweredWithinTheTimeOut) {
  MleOptions options;
  options.timeout = Duration::milliseconds(2500);
  options.until = MissionTime::seconds(60);

  EXPECT_THAT(replay(start(1, 1, "goto"), options).out,
              HasSubstr("{\"at\":3.5,\"task\":1,\"state\":\"aborted\"}"));
}

TEST(MleOptions, AreRefusedWhenTheTimeOutIsNotPositive) {
  MleOptions options;
  options.timeout = Duration::seconds(1e-12);

  const Replayed replayed = replay(start(0, 1, "goto"), options);

  EXPECT_EQ(replayed.code, 2);
  EXPECT_EQ(replayed.out, "");
  EXPECT_EQ(replayed.err, "--timeout: 0 s is not positive\n");
}

TEST(MleOptions, DispatchTheBackgroundRoutineInFlight) {
  MleOptions options;
  options.background = "wait";

  EXPECT_THAT(replay("{\"at\":3,\"airborne\":true}\n", options).out,
              HasSubstr("{\"at\":3,\"dispatch\":9000000000000000}"));
}

TEST(MleOptions, TellTheUavItsOwnName) {
  const std::string trace =
      start(0, 1, "synchronise", "SEQ",
            R"(,"params":{"id":5,"senders":["heliv"],"receivers":["karma"]})");
  MleOptions options;
  options.uav = "heliv";

  EXPECT_THAT(replay(trace, options).out,
              HasSubstr("{\"at\":0,\"sync\":{\"id\":5,\"to\":\"karma\"}}"));
  EXPECT_THAT(replay(trace).out, Not(HasSubstr("sync")));
}

// --- types file ----------------------------------------------------------------------------------

TEST(MleTypes, DeclareResourcesOverTheElementaryTypes) {
  const File types(R"({"hover": {"resources": ["motion"]}, "map": {"resources": ["$device"]}})");
  MleOptions options;
  options.types_file = types.path();
  const std::string trace = start(0, 1, "hover") + start(0, 2, "map") + start(1, 3, "goto", "VUT");

  EXPECT_THAT(replay(trace, options).out, HasSubstr("{\"at\":1,\"interrupt\":1}"));
  EXPECT_THAT(replay(trace, options).out, Not(HasSubstr("\"interrupt\":2")));
  EXPECT_THAT(replay(trace).out, Not(HasSubstr("interrupt")));
}

TEST(MleTypes, MayReplaceAnElementaryType) {
  const File types(R"({"wait": {"resources": []}})");
  MleOptions options;
  options.types_file = types.path();

  EXPECT_THAT(replay(start(0, 1, "wait") + start(1, 2, "goto", "VUT"), options).out,
              Not(HasSubstr("interrupt")));
}

TEST(MleTypes, AreRefusedWithWhatIsWrongInThem) {
  const std::pair<const char*, const char*> table[] = {
      {"", "not JSON, from column 1 on"},
      {"[]", "expected an object of types"},
      {R"({"map": 7})", "map: expected an object"},
      {R"({"map": {}})", "map: missing key 'resources'"},
      {R"({"map": {"resource": []}})", "map: unknown key 'resource'; did you mean 'resources'?"},
      {R"({"map": {"resources": "motion"}})", "map.resources: expected an array"},
      {R"({"map": {"resources": [""]}})", "map.resources[0]: expected a name"},
      {R"({"": {"resources": []}})", "a type has an empty name"},
      {R"({"map": {"resources": []}, "map": {"resources": []}})", "key 'map' comes twice"},
  };
  for (const auto& [text, why] : table) {
    const File types(text);
    MleOptions options;
    options.types_file = types.path();

    const Replayed replayed = replay(start(0, 1, "goto"), options);

    EXPECT_EQ(replayed.code, 2) << text;
    EXPECT_EQ(replayed.err, types.path() + ": " + why + "\n");
    EXPECT_EQ(replayed.out, "") << text;
  }
}

TEST(MleTypes, AreRefusedWhenTheirFileCannotBeRead) {
  for (const std::string& path : {testing::TempDir() + "no/such/file", testing::TempDir()}) {
    MleOptions options;
    options.types_file = path;

    const Replayed replayed = replay("", options);

    EXPECT_EQ(replayed.code, 2);
    EXPECT_EQ(replayed.err, path + ": cannot be read\n");
  }
}

}  // namespace
}  // namespace skein::mle_tool
