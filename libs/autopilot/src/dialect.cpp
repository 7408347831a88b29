// SPDX-License-Identifier: Apache-2.0
#include "skein/autopilot/dialect.hpp"

#include <map>

#include "mav.hpp"

namespace skein::autopilot {

namespace {

constexpr CustomMode px4(unsigned main, unsigned sub = 0) { return (main << 16U) | (sub << 24U); }

const std::map<CustomMode, std::string_view>& names_of(Dialect dialect) {
  static const std::map<CustomMode, std::string_view> px4_names = {{px4(1), "Manual"},
                                                                   {px4(2), "Altitude"},
                                                                   {px4(3), "Position"},
                                                                   {px4(4, 1), "Ready"},
                                                                   {px4(4, 2), "Takeoff"},
                                                                   {px4(4, 3), "Hold"},
                                                                   {px4(4, 4), "Mission"},
                                                                   {px4(4, 5), "Return"},
                                                                   {px4(4, 6), "Land"},
                                                                   {px4(4, 8), "Follow"},
                                                                   {px4(4, 9), "Precision landing"},
                                                                   {px4(5), "Acro"},
                                                                   {px4(6), "Offboard"},
                                                                   {px4(7), "Stabilized"},
                                                                   {px4(8), "Rattitude"}};
  static const std::map<CustomMode, std::string_view> copter_names = {
      {0, "STABILIZE"}, {1, "ACRO"},        {2, "ALT_HOLD"},      {3, "AUTO"},      {4, "GUIDED"},
      {5, "LOITER"},    {6, "RTL"},         {7, "CIRCLE"},        {9, "LAND"},      {11, "DRIFT"},
      {13, "SPORT"},    {14, "FLIP"},       {15, "AUTOTUNE"},     {16, "POSHOLD"},  {17, "BRAKE"},
      {18, "THROW"},    {19, "AVOID_ADSB"}, {20, "GUIDED_NOGPS"}, {21, "SMART_RTL"}};
  return dialect == Dialect::kPx4 ? px4_names : copter_names;
}

}  // namespace

std::string_view to_text(Dialect dialect) { return dialect == Dialect::kPx4 ? "px4" : "ardupilot"; }

std::optional<Dialect> dialect_from(std::string_view text) {
  for (const Dialect one : {Dialect::kPx4, Dialect::kArdupilot}) {
    if (text == to_text(one)) return one;
  }
  return std::nullopt;
}

std::optional<Dialect> dialect_of(std::uint8_t autopilot) {
  if (autopilot == mav::kPx4) return Dialect::kPx4;
  if (autopilot == mav::kArdupilot) return Dialect::kArdupilot;
  return std::nullopt;
}

CustomMode guided_mode(Dialect dialect) { return dialect == Dialect::kPx4 ? px4(4, 3) : 4; }

CustomMode land_mode(Dialect dialect) { return dialect == Dialect::kPx4 ? px4(4, 6) : 9; }

std::optional<CustomMode> takeoff_mode(Dialect dialect) {
  if (dialect == Dialect::kPx4) return px4(4, 2);
  return std::nullopt;
}

std::string name_of(Dialect dialect, CustomMode mode) {
  const auto found = names_of(dialect).find(mode);
  if (found != names_of(dialect).end()) return std::string(found->second);
  return "mode " + std::to_string(mode);
}

bool tells_manual_input(Dialect dialect) { return dialect == Dialect::kPx4; }

}  // namespace skein::autopilot
