// SPDX-License-Identifier: Apache-2.0
#include "skein/geodesy/geodetic_frame.hpp"

#include <GeographicLib/LocalCartesian.hpp>
#include <cmath>

#include "skein/foundation/contract.hpp"

namespace skein::geodesy {
namespace {

using Frame = GeographicLib::LocalCartesian;

std::shared_ptr<const Frame> frame_at(const world::GeodeticOrigin& origin) {
  SKEIN_EXPECTS(std::abs(origin.latitude_degrees) <= 90 &&
                std::abs(origin.longitude_degrees) <= 180 && std::isfinite(origin.altitude));
  return std::make_shared<const Frame>(origin.latitude_degrees, origin.longitude_degrees,
                                       origin.altitude);
}

}  // namespace

GeodeticFrame::GeodeticFrame(const world::GeodeticOrigin& origin)
    : origin_(origin), frame_(frame_at(origin)) {}

world::Vector3 GeodeticFrame::to_local(const world::GeodeticPoint& point) const {
  world::Vector3 local;
  frame_->Forward(point.latitude_degrees, point.longitude_degrees, point.altitude, local.x(),
                  local.y(), local.z());
  return local;
}

world::GeodeticPoint GeodeticFrame::to_geodetic(const world::Vector3& local) const {
  world::GeodeticPoint point;
  frame_->Reverse(local.x(), local.y(), local.z(), point.latitude_degrees, point.longitude_degrees,
                  point.altitude);
  return point;
}

}  // namespace skein::geodesy
