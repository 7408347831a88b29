// SPDX-License-Identifier: Apache-2.0
#include "flown.hpp"
#include "skein/foundation/markup.hpp"
#include "skein/foundation/unix_time.hpp"

namespace skein::track_files {
namespace {

std::string at(const world::GeodeticPoint& point) {
  return " lat=\"" + degrees(point.latitude_degrees) + "\" lon=\"" +
         degrees(point.longitude_degrees) + "\"><ele>" + metres(point.altitude) + "</ele>";
}

std::string track_text(const Track& track) {
  if (track.fixes.empty()) return "";
  std::string text = "<trk><name>" + escaped_markup(track.uav) + "</name><desc>" +
                     escaped_markup(track.model) + "</desc><trkseg>\n";
  for (const Fix& fix : track.fixes)
    text += "<trkpt" + at(fix.point) + "<time>" + utc_text(fix.at) + "</time></trkpt>\n";
  return text + "</trkseg></trk>\n";
}

}  // namespace

std::string to_gpx(const report::RunInfo& info, const std::vector<journal::Record>& records,
                   const TrackOptions& options) {
  const Flown flown(info, records, options);
  std::string text =
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<gpx version=\"1.1\" creator=\"skein " +
      escaped_markup(info.version) + "\" xmlns=\"http://www.topografix.com/GPX/1/1\">\n<metadata>" +
      "<name>" + escaped_markup(info.scenario) + "</name><time>" + utc_text(epoch_of(info.epoch)) +
      "</time></metadata>\n";
  for (const Spot& spot : flown.spots())
    text += "<wpt" + at(spot.point) + "<name>" + escaped_markup(spot.name) + "</name><type>" +
            spot.kind + "</type></wpt>\n";
  for (const Track& track : flown.tracks()) text += track_text(track);
  return text + "</gpx>\n";
}

}  // namespace skein::track_files
