// SPDX-License-Identifier: Apache-2.0
#include "meeting_lines.hpp"

namespace skein::ddn {

journal::Record line_of(const translation::Writer& writer,
                        const decision_node::MeetingNoted& noted) {
  journal::Record line(writer.at, writer.node, "meeting");
  line.with("uav", writer.node).with("id", noted.meeting).with("known", noted.dates.has_value());
  if (temporal::is_order(noted.meeting)) line.with("order", true);
  if (!noted.dates) return line;
  const temporal::PartnerDates& dates = *noted.dates;
  const auto with_date = [&](const char* name, MissionTime date) {
    if (date != MissionTime::max()) line.with(name, (date - MissionTime()).to_seconds());
  };
  if (!dates.last.empty()) {
    line.with("last", dates.last).with("there", dates.all_there);
    with_date("soonest", dates.soonest);
    with_date("slowest", dates.slowest);
  }
  if (dates.behind) line.with("behind", *dates.behind);
  if (dates.needed) {
    with_date("needed", *dates.needed);
    line.with("needed_by", dates.needed_by);
  }
  return line;
}

}  // namespace skein::ddn
