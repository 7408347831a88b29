// SPDX-License-Identifier: Apache-2.0
#include <cmath>
#include <limits>

#include "flight.hpp"
#include "mav.hpp"
#include "skein/world/steering.hpp"

namespace skein::autopilot {

using world::Vector3;

namespace {
constexpr float kUnchanged = std::numeric_limits<float>::quiet_NaN();
constexpr double kOwnSpeed = -1;
}  // namespace

mavlink::CommandLong Pilotage::command(std::uint16_t number) const {
  mavlink::CommandLong command;
  command.command = number;
  command.target_system = system_;
  command.target_component = mav::kAutopilotComponent;
  return command;
}

mavlink::CommandLong Pilotage::set_mode(CustomMode mode) const {
  mavlink::CommandLong set = command(mav::kDoSetMode);
  set.param1 = mav::kCustomModeFlag;
  const bool is_px4 = picture_.dialect() == Dialect::kPx4;
  set.param2 = static_cast<float>(is_px4 ? (mode >> 16U) & 0xffU : mode);
  set.param3 = static_cast<float>(is_px4 ? mode >> 24U : 0);
  return set;
}

mavlink::CommandInt Pilotage::reposition(const Vector3& at, double speed) const {
  const Place place = picture_.place_of(at);
  mavlink::CommandInt go;
  go.command = mav::kDoReposition;
  go.target_system = system_;
  go.target_component = mav::kAutopilotComponent;
  go.frame = mav::kFrameGlobal;
  go.param1 = static_cast<float>(speed);
  go.param2 = mav::kChangeMode;
  go.param4 = kUnchanged;
  go.x = place.latitude;
  go.y = place.longitude;
  go.z = static_cast<float>(place.height);
  return go;
}

std::deque<Step> Pilotage::take_off(double height) const {
  const Dialect dialect = picture_.dialect();
  const CustomMode guided = guided_mode(dialect);
  const Vector3& from = picture_.state().position;
  const double sea = picture_.place_of({from.x(), from.y(), height}).height;
  mavlink::CommandLong arm = command(mav::kComponentArmDisarm);
  arm.param1 = 1;
  mavlink::CommandLong rise = command(mav::kNavTakeoff);
  // PX4 counts from mean sea level, ArduCopter from home.
  rise.param7 = static_cast<float>(dialect == Dialect::kPx4 ? sea : sea - picture_.home_height());
  if (dialect == Dialect::kPx4) rise.param4 = rise.param5 = rise.param6 = kUnchanged;
  std::vector<CustomMode> rising{guided};
  if (const auto own = takeoff_mode(dialect)) rising.push_back(*own);
  return {Step{set_mode(guided), InMode{guided}, {guided}}, Step{arm, Armed{}},
          Step{rise, AtHeight{height}, rising, true, false, "takeoff"}};
}

std::deque<Step> Pilotage::fly(const std::vector<Vector3>& way, double speed) const {
  const CustomMode guided = guided_mode(picture_.dialect());
  std::deque<Step> steps;
  if (picture_.dialect() == Dialect::kArdupilot) {
    mavlink::CommandLong change = command(mav::kDoChangeSpeed);
    change.param1 = 1;  // over the ground
    change.param2 = static_cast<float>(speed);
    change.param3 = static_cast<float>(kOwnSpeed);
    steps.push_back({change, Answered{}, {}, false, true});
  }
  for (std::size_t i = 0; i < way.size(); ++i) {
    const std::string activity = "goto " + std::to_string(i + 1) + "/" + std::to_string(way.size());
    steps.push_back({reposition(way[i], speed),
                     Near{way[i], i + 1 == way.size()},
                     {guided},
                     true,
                     false,
                     activity});
  }
  return steps;
}

std::deque<Step> Pilotage::land() const {
  const CustomMode mode = land_mode(picture_.dialect());
  return {Step{set_mode(mode), OnGround{}, {mode}, true, false, "landing"}};
}

std::deque<Step> Pilotage::come_to_rest() const {
  const world::VehicleState& state = picture_.state();
  const double speed = state.velocity.norm();
  const double way = world::braking_distance(config_.model, speed);
  const Vector3 at =
      speed > 0 ? Vector3(state.position + state.velocity * (way / speed)) : state.position;
  return {Step{reposition(at, kOwnSpeed),
               AtRest{},
               {guided_mode(picture_.dialect())},
               true,
               !state.airborne,
               "brake"}};
}

}  // namespace skein::autopilot
