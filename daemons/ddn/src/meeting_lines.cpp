// SPDX-License-Identifier: Apache-2.0
#include "meeting_lines.hpp"

#include "skein/journal/lines/deliberation.hpp"

namespace skein::ddn {

namespace {

/// Left out when there is no such bound.
std::optional<double> date_of(MissionTime date) {
  if (date == MissionTime::max()) return std::nullopt;
  return (date - MissionTime()).to_seconds();
}

}  // namespace

journal::Record line_of(const translation::Writer& writer,
                        const decision_node::MeetingNoted& noted) {
  journal::lines::Meeting line{
      .uav = writer.node, .id = noted.meeting, .known = noted.dates.has_value()};
  if (temporal::is_order(noted.meeting)) line.order = true;
  if (!noted.dates) return writer.record(std::move(line));
  const temporal::PartnerDates& dates = *noted.dates;
  if (!dates.last.empty()) {
    line.last = dates.last;
    line.there = dates.all_there;
    line.soonest = date_of(dates.soonest);
    line.slowest = date_of(dates.slowest);
  }
  if (dates.behind) line.behind = *dates.behind;
  if (dates.needed) {
    line.needed = date_of(*dates.needed);
    line.needed_by = dates.needed_by;
  }
  return writer.record(std::move(line));
}

}  // namespace skein::ddn
