// SPDX-License-Identifier: Apache-2.0
#include "mission_item.hpp"

#include <cmath>
#include <cstdint>
#include <map>
#include <utility>

#include "readers.hpp"
#include "skein/mission_files/read.hpp"

namespace skein::mission_files {
namespace {

enum : std::int64_t {
  kWaypoint = 16,
  kLoiterUnlimited = 17,
  kLoiterTime = 19,
  kReturnToLaunch = 20,
  kLand = 21,
  kTakeoff = 22,
  kDelay = 93,
  kChangeSpeed = 178,
  kDigicamControl = 203,
  kTriggerDistance = 206,
  kStartCapture = 2000,
  kStopCapture = 2001,
};

const std::map<std::int64_t, const char*>& names() {
  static const std::map<std::int64_t, const char*> kNames{
      {16, "NAV_WAYPOINT"},
      {17, "NAV_LOITER_UNLIM"},
      {18, "NAV_LOITER_TURNS"},
      {19, "NAV_LOITER_TIME"},
      {20, "NAV_RETURN_TO_LAUNCH"},
      {21, "NAV_LAND"},
      {22, "NAV_TAKEOFF"},
      {30, "NAV_CONTINUE_AND_CHANGE_ALT"},
      {31, "NAV_LOITER_TO_ALT"},
      {80, "NAV_ROI"},
      {82, "NAV_SPLINE_WAYPOINT"},
      {84, "NAV_VTOL_TAKEOFF"},
      {85, "NAV_VTOL_LAND"},
      {92, "NAV_GUIDED_ENABLE"},
      {93, "NAV_DELAY"},
      {94, "NAV_PAYLOAD_PLACE"},
      {112, "CONDITION_DELAY"},
      {114, "CONDITION_DISTANCE"},
      {115, "CONDITION_YAW"},
      {177, "DO_JUMP"},
      {178, "DO_CHANGE_SPEED"},
      {179, "DO_SET_HOME"},
      {181, "DO_SET_RELAY"},
      {183, "DO_SET_SERVO"},
      {189, "DO_LAND_START"},
      {195, "DO_SET_ROI_LOCATION"},
      {197, "DO_SET_ROI_NONE"},
      {201, "DO_SET_ROI"},
      {203, "DO_DIGICAM_CONTROL"},
      {205, "DO_MOUNT_CONTROL"},
      {206, "DO_SET_CAM_TRIGG_DIST"},
      {207, "DO_FENCE_ENABLE"},
      {211, "DO_GRIPPER"},
      {214, "DO_SET_CAM_TRIGG_INTERVAL"},
      {530, "SET_CAMERA_MODE"},
      {1000, "DO_GIMBAL_MANAGER_PITCHYAW"},
      {2000, "IMAGE_START_CAPTURE"},
      {2001, "IMAGE_STOP_CAPTURE"},
      {2500, "VIDEO_START_CAPTURE"},
      {2501, "VIDEO_STOP_CAPTURE"},
      {3000, "DO_VTOL_TRANSITION"},
  };
  return kNames;
}

bool given(double value) { return std::isfinite(value) && value != 0; }

/// Absent for frames in which there is no place on Earth.
std::optional<HeightOver> height_of_frame(std::int64_t frame) {
  switch (frame) {
    case 0:
    case 5:
      return HeightOver::kSeaLevel;
    case 3:
    case 6:
      return HeightOver::kHome;
    case 10:
    case 11:
      return HeightOver::kGround;
    default:
      return std::nullopt;
  }
}

class ItemReader {
 public:
  ItemReader(const MissionItem& item, Contents& contents, Findings& findings)
      : item_(item), contents_(contents), findings_(findings) {}

  void read() {
    if (!item_.goes_on) leave_out("that the mission stops there (autocontinue 0)");
    switch (item_.command) {
      case kWaypoint:
        return fly_to(param(1), {{2, "the radius in which it counts as reached"},
                                 {3, "a radius to pass by"},
                                 {4, "a heading there"}});
      case kLoiterTime:
        return fly_to(param(1), {{2, "that it leaves by its heading"},
                                 {3, "the radius of a circle"},
                                 {4, "where it leaves the circle"}});
      case kLoiterUnlimited:
        return fly_to(0, {{3, "the radius of a circle"}, {4, "a heading there"}}, true);
      case kReturnToLaunch:
        return add(ReturnHome{});
      case kLand:
        return land();
      case kTakeoff:
        return take_off();
      case kDelay:
        return delay();
      case kChangeSpeed:
        return change_speed();
      default:
        return pictures();
    }
  }

 private:
  /// Counted from 1, as MAVLink does.
  double param(std::size_t number) const { return item_.params.at(number - 1); }
  void add(Step step) { contents_.items.push_back({std::move(step), item_.mark}); }
  void leave_out(const std::string& what) {
    findings_.leave_out(item_.mark, command_text(item_.command) + ": " + what);
  }
  void wrong(const std::string& what, std::string expected = "") {
    findings_.wrong(item_.mark, command_text(item_.command) + ": " + what, std::move(expected));
  }
  using Meanings = std::initializer_list<std::pair<std::size_t, const char*>>;
  void leave_out_given(Meanings meanings) {
    for (const auto& [number, meaning] : meanings)
      if (given(param(number)))
        leave_out(std::string(meaning) + " (parameter " + std::to_string(number) + ")");
  }

  std::optional<Height> height() {
    const auto over = height_of_frame(item_.frame);
    if (!over) {
      wrong("frame " + std::to_string(item_.frame) + " says no place on Earth",
            "0, 3 or 10 (5, 6, 11): over sea level, home, the ground");
      return std::nullopt;
    }
    if (!std::isfinite(param(7)) || std::abs(param(7)) > 20'000) {
      wrong("no height", "parameter 7 in metres");
      return std::nullopt;
    }
    return Height{param(7), *over};
  }
  bool is_somewhere() const { return given(param(5)) || given(param(6)); }
  LatLon place() const { return {param(5), param(6)}; }

  void fly_to(double hold, Meanings left_out, bool stays = false) {
    leave_out_given(left_out);
    const auto over = height();
    if (!is_somewhere()) return wrong("no place", "latitude and longitude as parameters 5 and 6");
    const bool on_earth = check(place(), item_.mark, findings_);
    if (!(std::isnan(hold) || (hold >= 0 && hold <= 1e6)))
      return wrong("a hold of " + std::to_string(hold) + " s", "0 to 1000000 s");
    if (over && on_earth) add(FlyTo{{place(), over}, std::isnan(hold) ? 0 : hold, stays});
  }

  void take_off() {
    leave_out_given({{4, "a heading"}});  // parameter 1, a pitch, is of aeroplanes
    if (const auto over = height()) add(TakeOff{*over});
  }

  void land() {
    leave_out_given({{1, "a height to give up at"}, {2, "a way of landing"}, {4, "a heading"}});
    if (!is_somewhere()) return add(Land{});
    if (check(place(), item_.mark, findings_)) add(Land{place()});
  }

  void delay() {
    if (!(param(1) > 0 && param(1) <= 1e6))
      return leave_out("a delay until an hour of the day, or none (parameter 1)");
    add(Delay{param(1)});
  }

  void change_speed() {
    if (param(1) > 1) return leave_out("a speed of climb or descent (parameter 1)");
    if (param(3) >= 0 && given(param(3))) leave_out("a throttle (parameter 3)");
    if (param(2) == -1 || param(2) == -2) return leave_out("a speed of no change or the default's");
    if (!(param(2) > 0 && param(2) <= 1000)) return wrong("no speed", "metres per second");
    add(ChangeSpeed{param(2)});
  }

  void pictures() {
    switch (item_.command) {
      case kDigicamControl:
        if (param(5) != 1) return leave_out("it takes no picture (parameter 5)");
        return add(TakePictures{1});
      case kTriggerDistance:
        if (!(param(1) > 0)) return add(StopPictures{});
        leave_out_given({{2, "how long the shutter is open"}});
        return add(TakePictures{0});
      case kStartCapture:
        if (!(param(3) >= 0 && param(3) <= 1e6)) return wrong("no number of pictures");
        return add(TakePictures{static_cast<int>(param(3))});
      case kStopCapture:
        return add(StopPictures{});
      default:
        return findings_.leave_out(item_.mark, command_text(item_.command));
    }
  }

  const MissionItem& item_;
  Contents& contents_;
  Findings& findings_;
};

}  // namespace

void take(const MissionItem& item, Contents& contents, Findings& findings) {
  if (contents.items.size() == kMostParts)
    return findings.wrong(item.mark, "more than " + std::to_string(kMostParts) + " items");
  if (contents.items.size() < kMostParts) ItemReader(item, contents, findings).read();
}

std::string command_text(std::int64_t command) {
  const auto found = names().find(command);
  const std::string number = std::to_string(command);
  return found == names().end() ? "command " + number
                                : std::string(found->second) + " (" + number + ")";
}

}  // namespace skein::mission_files
