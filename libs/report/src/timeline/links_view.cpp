// SPDX-License-Identifier: Apache-2.0
// One row per pair of nodes: what the radio really carried, and what the two believed.
#include <algorithm>

#include "story/links.hpp"
#include "timeline/timeline.hpp"

namespace skein::report {

namespace {

constexpr double kRow = 17.0;
constexpr std::size_t kManyLinks = 40;
constexpr std::size_t kMostRows = 60;

// Nothing to see: both directions up from first to last, and never believed otherwise.
bool is_steady(const LinkStory& link) {
  for (const std::size_t d : {0U, 1U}) {
    if (link.truth[d] && link.up[d].size() != 1) return false;
    if (link.belief[d] && link.believed[d].size() != 1) return false;
    if (!link.relayed[d].empty()) return false;
  }
  return true;
}

void draw_link(Sheet& sheet, const LinkStory& link) {
  const double top = sheet.y + 3;
  sheet.gutter(top + 9, shortened(link.first, 10) + " – " + shortened(link.second, 10), "link");
  sheet.plot.open("g", {{"class", "link"}});
  sheet.plot.title(link.first + " – " + link.second);
  const Span whole = sheet.run.story.time;
  for (const std::size_t d : {0U, 1U}) {
    const double half = top + 3.5 * static_cast<double>(d);
    if (link.truth[d]) sheet.bar(whole, half, 3.5, "down");
    for (const Span& s : link.up[d]) sheet.bar(s, half, 3.5, "up");
    const double line = top + 8.2 + 2.2 * static_cast<double>(d);
    if (link.belief[d]) sheet.bar(whole, line, 1.5, "unbelieved");
    for (const Span& s : link.believed[d]) sheet.bar(s, line, 1.5, "believed");
    for (const Span& s : link.relayed[d]) sheet.bar(s, line, 1.5, "relayed");
  }
  sheet.plot.close();
  sheet.y += kRow;
}

}  // namespace

void draw_links(Sheet& sheet) {
  const std::vector<LinkStory>& links = sheet.run.story.links;
  if (links.empty()) return;
  sheet.heading("Links");
  const bool many = links.size() > kManyLinks;
  std::size_t drawn = 0;
  for (const LinkStory& link : links) {
    if ((many && is_steady(link)) || drawn == kMostRows) continue;
    draw_link(sheet, link);
    ++drawn;
  }
  if (drawn == links.size()) return;
  sheet.plot.element("text", {{"class", "note"}, {"x", Sheet::kLeft + 6}, {"y", sheet.y + 11}},
                     "and " + counted(links.size() - drawn, "more link") + ", not drawn");
  sheet.y += kRow;
}

}  // namespace skein::report
