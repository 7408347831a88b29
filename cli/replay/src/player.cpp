// SPDX-License-Identifier: Apache-2.0
#include "player.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace skein::replay_tool {

namespace {

constexpr const char* kExpected =
    "a replay takes one action, playback, with playing (true or false), speed (0.1 to 1000) or at "
    "(seconds)";
constexpr double kLeastSpeed = 0.1, kMostSpeed = 1000;
constexpr double kMostSeconds = 1e8;

std::optional<double> number_in(const nlohmann::json& value, double least, double most) {
  if (!value.is_number()) return std::nullopt;
  const double number = value.get<double>();
  if (!(number >= least && number <= most)) return std::nullopt;
  return number;
}

}  // namespace

Result<Wish, Failure> wish_of(const std::string& actions) {
  const auto said = nlohmann::json::parse(actions, nullptr, false);
  if (!said.is_array() || said.size() != 1 || !said[0].is_object() || said[0].size() != 1 ||
      !said[0].contains("playback") || !said[0]["playback"].is_object())
    return failure(kExpected);
  Wish wish;
  for (const auto& [key, value] : said[0]["playback"].items()) {
    if (key == "playing" && value.is_boolean()) {
      wish.playing = value.get<bool>();
    } else if (key == "speed" && number_in(value, kLeastSpeed, kMostSpeed)) {
      wish.speed = value.get<double>();
    } else if (key == "at" && number_in(value, 0, kMostSeconds)) {
      wish.at = MissionTime::seconds(value.get<double>());
    } else {
      return failure(kExpected);
    }
  }
  return wish;
}

bool Player::carry_out(const Wish& wish) {
  if (wish.playing) playing_ = *wish.playing;
  if (wish.speed) speed_ = *wish.speed;
  if (!wish.at) return false;
  const MissionTime before = at_;
  at_ = std::min(*wish.at, until_);
  return at_ < before;
}

void Player::advance(Duration passed) {
  if (!playing_) return;
  at_ = std::min(at_ + Duration::seconds(passed.to_seconds() * speed_), until_);
  if (at_ == until_) playing_ = false;
}

}  // namespace skein::replay_tool
