// SPDX-License-Identifier: Apache-2.0
#include "hand.hpp"

#include <algorithm>

namespace skein::autopilot {

namespace {
constexpr Duration kChangeWithin = Duration::milliseconds(3'000);

bool has(const std::vector<CustomMode>& modes, CustomMode mode) {
  return std::find(modes.begin(), modes.end(), mode) != modes.end();
}
}  // namespace

void Hand::ask_for(std::vector<CustomMode> modes, Duration now) {
  if (modes == asked_) return;
  before_ = std::move(asked_);
  asked_ = std::move(modes);
  asked_at_ = now;
}

bool Hand::may_be_in(CustomMode mode, Duration now) const {
  return has(asked_, mode) || (has(before_, mode) && now - asked_at_ < kChangeWithin);
}

bool Hand::look_at(const Picture& picture, Duration now) {
  const CustomMode guided = guided_mode(picture.dialect());
  if (asked_.empty()) asked_ = {guided};
  const bool guides = picture.mode() == guided && !picture.has_manual_input();
  if (!picture.is_armed() || (taken_ && guides)) {
    if (taken_) asked_ = {guided};
    taken_.reset();
    return false;
  }
  const bool was_taken = taken_.has_value();
  if (!was_taken && may_be_in(picture.mode(), now) && !picture.has_manual_input()) return false;
  const std::string mode = name_of(picture.dialect(), picture.mode());
  taken_ = picture.is_critical() ? "the autopilot's failsafe took over: " + mode
                                 : "taken in hand by the pilot: " + mode;
  return !was_taken;
}

}  // namespace skein::autopilot
