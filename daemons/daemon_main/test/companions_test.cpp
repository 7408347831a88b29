// SPDX-License-Identifier: Apache-2.0
#include "companions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::daemon_main {
namespace {

using ::testing::ElementsAre;

/// Notes what it is told, and says one request when it is asked.
class Noting final : public node::Companion {
 public:
  Noting(std::string name, std::vector<std::string>& notes)
      : name_(std::move(name)), notes_(notes) {}
  void attach(std::function<void()> wake) override {
    note("attached");
    wake();
  }
  void detach() override { note("detached"); }
  std::string speaks_as() const override { return name_; }
  std::vector<wire::Sample> take() override {
    wire::OperatorRequest request;
    request.who = name_;
    return {request};
  }
  void sees(const wire::Sample&) override { note("sample"); }
  void sees(const journal::Record& record) override { note(record.kind()); }
  void turn(const node::DaemonState&) override { note("turn"); }

 private:
  void note(const std::string& what) { notes_.push_back(name_ + " " + what); }
  std::string name_;
  std::vector<std::string>& notes_;
};

TEST(Companions, AllSeeEverythingAndWhatTheySayIsSaidInTheNameOfTheFirst) {
  std::vector<std::string> notes;
  Companions companions;
  companions.add(std::make_unique<Noting>("a", notes));
  companions.add(nullptr);
  companions.add(std::make_unique<Noting>("b", notes));
  int woken = 0;

  companions.attach([&] { ++woken; });
  companions.sees(wire::Sample(wire::Telemetry()));
  companions.sees(journal::Record({}, "ground", "alarm"));
  companions.turn({});
  companions.detach();

  EXPECT_EQ(woken, 2);
  EXPECT_THAT(notes, ElementsAre("a attached", "b attached", "a sample", "b sample", "a alarm",
                                 "b alarm", "a turn", "b turn", "a detached", "b detached"));
  EXPECT_EQ(companions.speaks_as(), "a");
  const auto said = companions.take();
  ASSERT_EQ(said.size(), 2U);
  EXPECT_EQ(std::get<wire::OperatorRequest>(said[1]).who, "b");
}

TEST(Companions, OfNobodyAreEmpty) {
  Companions companions;
  companions.add(nullptr);

  EXPECT_TRUE(companions.empty());
}

}  // namespace
}  // namespace skein::daemon_main
