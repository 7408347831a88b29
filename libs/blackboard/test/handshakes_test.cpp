// SPDX-License-Identifier: Apache-2.0
#include "skein/blackboard/handshakes.hpp"

#include <gmock/gmock.h>

namespace skein::blackboard {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Duration at(double seconds) { return Duration::seconds(seconds); }

/// "marvin 3" for each, in seconds.
std::vector<std::string> texts(const Handshakes& handshakes, double seconds) {
  std::vector<std::string> found;
  for (const auto& [name, lasts] : handshakes.open(at(seconds)))
    found.push_back(name + " " + std::to_string(static_cast<int>(lasts.to_seconds())));
  return found;
}

TEST(Handshakes, LastUntilTheyEnd) {
  Handshakes handshakes;
  handshakes.begun("a", "marvin", at(1));
  EXPECT_THAT(texts(handshakes, 4), ElementsAre("marvin 3"));

  handshakes.ended("a");
  EXPECT_THAT(texts(handshakes, 5), IsEmpty());
}

TEST(Handshakes, TheOneThatLastsLongestComesFirst) {
  Handshakes handshakes;
  handshakes.begun("a", "marvin", at(3));
  handshakes.begun("b", "karma", at(1));

  EXPECT_THAT(texts(handshakes, 5), ElementsAre("karma 4", "marvin 2"));
}

TEST(Handshakes, WhoIsFoundAgainHasBeenThereSinceTheFirstTime) {
  Handshakes handshakes;
  handshakes.begun("a", "marvin", at(1));
  handshakes.begun("a", "marvin", at(3));

  EXPECT_THAT(texts(handshakes, 4), ElementsAre("marvin 3"));
}

TEST(Handshakes, WhoIsGoneIsWaitedForByNobody) {
  Handshakes handshakes;
  handshakes.begun("a", "marvin", at(1));
  handshakes.gone("a");

  EXPECT_THAT(texts(handshakes, 4), IsEmpty());
}

// The threads of the middleware may tell the two in either order.
TEST(Handshakes, OneThatEndedBeforeItWasToldOfDoesNotLast) {
  Handshakes handshakes;
  handshakes.ended("a");
  handshakes.begun("a", "marvin", at(1));

  EXPECT_THAT(texts(handshakes, 4), IsEmpty());
}

TEST(Handshakes, WhoComesBackBeginsAnew) {
  Handshakes handshakes;
  handshakes.begun("a", "marvin", at(1));
  handshakes.ended("a");
  handshakes.gone("a");
  handshakes.begun("a", "marvin", at(6));

  EXPECT_THAT(texts(handshakes, 8), ElementsAre("marvin 2"));
}

}  // namespace
}  // namespace skein::blackboard
