// SPDX-License-Identifier: Apache-2.0
// External arcs, from the rail of who comes to the rail of who goes on then: what lies between is
// their slack. Source: M 2.2; spec 5.3.
#include "meetings/external_arcs.hpp"

#include <algorithm>
#include <map>
#include <tuple>
#include <utility>

#include "meetings/meeting_words.hpp"
#include "text.hpp"
#include "timeline/timeline.hpp"

namespace skein::report {

namespace {

constexpr std::size_t kMostArcs = 2000;
constexpr double kArcInset = 4.0;

void add_need(ExternalArc& arc, const MeetingRows& rows, std::uint64_t meeting) {
  const auto row = rows.find({arc.from, meeting});
  if (row == rows.end()) return;
  for (const MeetingWord& word : row->second) {
    if (word.t > arc.comes) break;
    arc.needed = word.needed;
    arc.needed_by = word.needed_by;
  }
}

/// Who receives goes on when the last of those who send is heard, and is there itself.
std::vector<ExternalArc> of_syncs(const Chronology& story, const MeetingRows& rows) {
  using Course = std::tuple<std::string, std::size_t, std::size_t>;
  std::map<Course, const Flight*> first;
  std::map<std::pair<std::string, std::size_t>, double> goes_on;
  const auto not_before = [&](const std::string& what, std::size_t uav, double t) {
    double& at = goes_on[{what, uav}];
    at = std::max(at, t);
  };
  for (const Flight& sync : story.syncs) {
    const auto from = story.uav_index(sync.from), to = story.uav_index(sync.to);
    if (!from || !to || !sync.received) continue;
    if (!first.emplace(Course(sync.what, *from, *to), &sync).second) continue;
    not_before(sync.what, *to, *sync.received);
    not_before(sync.what, *from, sync.sent.value_or(*sync.received));
  }
  std::vector<ExternalArc> arcs;
  for (const auto& [course, sync] : first) {
    const auto& [what, from, to] = course;
    const double comes = sync->sent.value_or(*sync->received);
    ExternalArc arc{"sync " + what, from, to, comes, goes_on[{what, to}], {}, ""};
    if (!what.empty() && what.find_first_not_of("0123456789") == std::string::npos &&
        what.size() < 18)
      add_need(arc, rows, std::stoll(what));
    arcs.push_back(std::move(arc));
  }
  return arcs;
}

/// All have come, and then the meeting is no longer one: it has begun, or the air is had.
std::vector<ExternalArc> of_words(const Chronology& story, const MeetingRows& rows) {
  std::vector<ExternalArc> arcs;
  for (const auto& [row, words] : rows) {
    const std::string what = std::to_string(row.second);
    const bool is_sync = std::any_of(story.syncs.begin(), story.syncs.end(),
                                     [&](const Flight& f) { return f.what == what; });
    for (std::size_t i = 0; !is_sync && i + 1 < words.size(); ++i) {
      const MeetingWord& word = words[i];
      const auto last = story.uav_index(word.last);
      if (!word.known || !word.there || !last || words[i + 1].known) continue;
      const double soonest = word.soonest.value_or(0);
      ExternalArc arc{word.air ? "air" : "joint task",   *last, row.first, soonest,
                      std::max(words[i + 1].t, soonest), {},    ""};
      add_need(arc, rows, row.second);
      arcs.push_back(std::move(arc));
    }
  }
  return arcs;
}

std::string arc_told(const ExternalArc& arc, const Chronology& story) {
  const std::string verb = arc.what == "air" ? " has left at " : " is there at ";
  std::string text = arc.what + ": " + story.uavs[arc.from].name + verb + clock_text(arc.comes) +
                     ", " + story.uavs[arc.to].name + " goes on at " + clock_text(arc.goes_on) +
                     ": " + short_number(arc.slack(), 1) + " s of slack";
  if (arc.needed)
    text += "\n" + arc.needed_by + " needed it there by " + clock_text(*arc.needed) + ": " +
            short_number(*arc.needed - arc.comes, 1) + " s";
  return text;
}

void draw_arc(Sheet& sheet, const ExternalArc& arc) {
  constexpr double kTight = 1;  // [s]
  const auto from = sheet.rails.find(sheet.run.story.uavs[arc.from].name);
  const auto to = sheet.rails.find(sheet.run.story.uavs[arc.to].name);
  if (from == sheet.rails.end() || to == sheet.rails.end()) return;
  const double down = to->second > from->second ? kArcInset : -kArcInset;
  const double y1 = from->second + down, y2 = to->second - down;
  const double x1 = sheet.x(arc.comes), x2 = sheet.x(arc.goes_on);
  const bool tight = arc.slack() < kTight;
  sheet.plot.open("g",
                  {{"class", (tight ? "external tight " : "external ") + colour_class(arc.from)}});
  sheet.plot.title(arc_told(arc, sheet.run.story));
  sheet.plot.leaf("line", {{"x1", x1}, {"y1", y1}, {"x2", x2}, {"y2", y2}});
  const std::string label = short_number(arc.slack(), 0) + " s";
  if (!tight && x2 - x1 > text_width(label, kBarFont))
    sheet.plot.element(
        "text", {{"x", (x1 + x2) / 2}, {"y", (y1 + y2) / 2}, {"text-anchor", "middle"}}, label);
  sheet.plot.close();
}

}  // namespace

std::vector<ExternalArc> external_arcs_of(const Journal& journal, const Chronology& story) {
  const MeetingRows rows = meeting_rows_of(journal, story);
  std::vector<ExternalArc> arcs = of_syncs(story, rows);
  std::vector<ExternalArc> others = of_words(story, rows);
  arcs.insert(arcs.end(), std::make_move_iterator(others.begin()),
              std::make_move_iterator(others.end()));
  std::stable_sort(arcs.begin(), arcs.end(), [](const ExternalArc& a, const ExternalArc& b) {
    return a.goes_on < b.goes_on;
  });
  return arcs;
}

void draw_external_arcs(Sheet& sheet) {
  const auto arcs = external_arcs_of(sheet.run.journal, sheet.run.story);
  if (arcs.empty()) return;
  const std::size_t stride = arcs.size() / kMostArcs + 1;
  sheet.plot.open("g", {{"class", "externals"}});
  for (std::size_t i = 0; i < arcs.size(); i += stride) draw_arc(sheet, arcs[i]);
  sheet.plot.close();
}

}  // namespace skein::report
