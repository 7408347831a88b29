// SPDX-License-Identifier: Apache-2.0
// Who comes back with what it knew is told so before it hears anything.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/node/virtual_runtime.hpp"
#include "testing/fake_node.hpp"

namespace skein::node {
namespace {

using testing::at;
using ::testing::ElementsAre;

/// Writes what it is given.
class Listener final : public Node {
 public:
  Effects handle(const Input& input, MissionTime now) override {
    if (std::holds_alternative<Started>(input)) return {line(now, "started")};
    if (std::holds_alternative<Restarted>(input)) return {line(now, "restarted")};
    if (std::holds_alternative<Received>(input)) return {line(now, "received")};
    return {};
  }
  std::optional<MissionTime> next_wakeup() const override { return std::nullopt; }

 private:
  static Log line(MissionTime now, const std::string& text) {
    return {journal::Record(now, "uav", "line").with("text", text)};
  }
};

/// Sends the UAV an event at each of these instants [s].
class Sender final : public Node {
 public:
  explicit Sender(std::vector<double> instants) : instants_(std::move(instants)) {}

  Effects handle(const Input& input, MissionTime) override {
    if (!std::holds_alternative<Wakeup>(input)) return {};
    return {Send{NodeNumber(10), testing::abort_request(++next_), MissionTime::max()}};
  }
  std::optional<MissionTime> next_wakeup() const override {
    if (next_ >= instants_.size()) return std::nullopt;
    return at(instants_[next_]);
  }

 private:
  std::vector<double> instants_;
  std::size_t next_ = 0;
};

/// What the UAV was given that dies at 5 s and is back at 10 s, and again from 30 to 40 s.
std::vector<std::string> given(bool with_memory) {
  VirtualConfig config;
  config.time_limit = at(60);
  config.crashes = {{at(5), "uav", at(10), with_memory}, {at(30), "uav", at(40), with_memory}};
  std::vector<std::string> lines;
  run_virtual(
      Roster({"uav"}),
      [&](const std::string& name) -> std::unique_ptr<Node> {
        if (name == "uav") return std::make_unique<Listener>();
        return std::make_unique<Sender>(std::vector<double>{1, 6, 7, 50});
      },
      config,
      [&](const journal::Record& record) {
        if (record.kind() == "line") lines.emplace_back(record.text("text"));
      });
  return lines;
}

TEST(Restarted, ComesBeforeWhatCameMeanwhile) {
  EXPECT_THAT(given(true), ElementsAre("started", "received", "restarted", "received", "received",
                                       "restarted", "received"));
}

TEST(Restarted, IsNotForWhoForgot) {
  const auto lines = given(false);
  EXPECT_EQ(std::ranges::count(lines, "restarted"), 0);
  EXPECT_EQ(std::ranges::count(lines, "started"), 3);
}

}  // namespace
}  // namespace skein::node
