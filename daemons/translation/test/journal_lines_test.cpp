// SPDX-License-Identifier: Apache-2.0
#include "skein/translation/journal_lines.hpp"

#include <gtest/gtest.h>

namespace skein::translation {
namespace {

const Writer kWriter{MissionTime::seconds(2), "karma"};

TEST(JournalLines, ATaskHasItsReasonOnlyWhenThereIsOne) {
  executive::TaskEvent event{executive::TaskId(7), "goto", executive::TaskState::kRunning, ""};
  const std::string running = journal::to_json(task_line(kWriter, "heliv", event, {}));
  event.state = executive::TaskState::kAborted;
  event.reason = "no way";
  const std::string aborted = journal::to_json(task_line(kWriter, "heliv", event, {}));

  EXPECT_EQ(running, R"({"at":2,"node":"karma","kind":"task","uav":"heliv","task":7,"type":"goto",)"
                     R"("state":"running"})");
  EXPECT_EQ(aborted, R"({"at":2,"node":"karma","kind":"task","uav":"heliv","task":7,"type":"goto",)"
                     R"("state":"aborted","reason":"no way"})");
}

TEST(JournalLines, ATaskSaysItsDeviceAndItsTarget) {
  const executive::TaskEvent event{executive::TaskId(8), "takeshot", executive::TaskState::kEnded,
                                   ""};
  const executive::Parameters parameters{
      {"device", "camera", {}}, {"target", "", {1, 2.5, 3}}, {"duration", "", {60}}};

  EXPECT_EQ(journal::to_json(task_line(kWriter, "heliv", event, parameters)),
            R"({"at":2,"node":"karma","kind":"task","uav":"heliv","task":8,"type":"takeshot",)"
            R"("state":"ended","device":"camera","target":[1,2.5,3]})");
}

TEST(JournalLines, ARequestHasAModeOnlyIfItIsAStartAndAReasonOnlyIfRefused) {
  const executive::Reply start{executive::RequestKind::kStart, executive::TaskId(7), true, ""};
  const executive::Reply message{executive::RequestKind::kProcessMessage, std::nullopt, false,
                                 "no"};

  EXPECT_EQ(journal::to_json(request_line(kWriter, "heliv", start, executive::InsertionMode::kVut)),
            R"({"at":2,"node":"karma","kind":"request","uav":"heliv","request":"START",)"
            R"("mode":"VUT","task":7,"accepted":true})");
  EXPECT_EQ(
      journal::to_json(request_line(kWriter, "heliv", message, executive::InsertionMode::kVut)),
      R"({"at":2,"node":"karma","kind":"request","uav":"heliv","request":"PROCESS-MSG",)"
      R"("accepted":false,"why":"no"})");
}

TEST(JournalLines, ASynchronisationHasItsDirection) {
  EXPECT_EQ(sync_line(kWriter, {551, "karma", "heliv", true, {}}).text("direction"), "sent");
  EXPECT_EQ(sync_line(kWriter, {551, "heliv", "karma", false, {}}).text("direction"), "received");
  EXPECT_EQ(sync_line(kWriter, {551, "heliv", "karma", false, {}}).find("word"), nullptr);
  const SyncTraffic withdrawal{551, "karma", "heliv", true, executive::SyncWord::kWithdrawn};
  EXPECT_EQ(sync_line(kWriter, withdrawal).text("word"), "withdrawn");
}

}  // namespace
}  // namespace skein::translation
