// SPDX-License-Identifier: Apache-2.0
// Joint tasks as bands under the rows of the UAVs, with their roles and blocks, and what violated
// their constraints; negotiations as sequence diagrams. Source: T V, spec 8.7.
#include <algorithm>

#include "story/joint_story.hpp"
#include "timeline/timeline.hpp"

namespace skein::report {

namespace {

constexpr double kJointBand = 15.0, kStrip = 6.0, kJointGap = 4.0;

// Where the text has room in the span, as the page's script has it when it zooms.
void label(Sheet& sheet, const Span& span, double base_line, const std::string& style,
           const std::string& text) {
  const double from = sheet.x(span.from), to = sheet.x(span.to), need = text_width(text, 10) + 6;
  sheet.plot.element("text",
                     {{"class", need < to - from ? style : style + " off"},
                      {"x", from},
                      {"dx", 4},
                      {"y", base_line},
                      {"data-from", from},
                      {"data-to", to},
                      {"data-need", need}},
                     text);
}

std::string title_of(const JointStory& story, const JointSegment& segment) {
  std::string text = story.uav + ": " + segment.phase + " " + story.joint;
  if (!segment.role.empty()) text += "\nrole " + segment.role;
  if (!segment.blocks.empty()) text += "\nblocks " + segment.blocks;
  return text + "\n" + clock_text(segment.span.from) + " to " + clock_text(segment.span.to);
}

// One band for as long as a role is held, whatever its blocks.
void draw_roles(Sheet& sheet, const JointStory& story, double top) {
  for (std::size_t i = 0; i < story.segments.size();) {
    std::size_t last = i;
    const auto goes_on = [&](const JointSegment& next) {
      return next.phase == story.segments[i].phase && next.role == story.segments[i].role;
    };
    while (last + 1 < story.segments.size() && goes_on(story.segments[last + 1])) ++last;
    JointSegment whole = story.segments[i];
    whole.blocks.clear();
    whole.span.to = story.segments[last].span.to;
    sheet.plot.open("g");
    sheet.plot.title(title_of(story, whole));
    sheet.bar(whole.span, top, kJointBand - 2, "joint-" + whole.phase);
    label(sheet, whole.span, top + kJointBand - 5, "inside",
          whole.phase == "running" ? whole.role : whole.phase);
    sheet.plot.close();
    i = last + 1;
  }
}

void draw_blocks(Sheet& sheet, const JointStory& story, double top) {
  bool even = false;
  for (const JointSegment& segment : story.segments) {
    if (segment.blocks.empty()) continue;
    even = !even;
    sheet.plot.open("g");
    sheet.plot.title(title_of(story, segment));
    sheet.bar(segment.span, top, kJointBand - 2, even ? "joint-block" : "joint-block odd");
    label(sheet, segment.span, top + kJointBand - 5, "outside", segment.blocks);
    sheet.plot.close();
  }
}

void draw_end(Sheet& sheet, const JointStory& story, double top) {
  if (story.end.empty() || story.segments.empty()) return;
  sheet.open_mark(story.segments.back().span.to, top + kJointBand / 2, "joint-end");
  sheet.plot.title(story.uav + ": " + story.end + (story.why.empty() ? "" : ": " + story.why));
  if (story.end == "ended") {
    sheet.plot.leaf("rect", {{"class", "cap"}, {"x", -1}, {"y", -7}, {"width", 2}, {"height", 14}});
  } else {
    sheet.plot.leaf("path", {{"class", "cross"}, {"d", "M-4 -4L4 4M-4 4L4 -4"}});
  }
  sheet.plot.close();
}

std::vector<std::string> scms_of(const JointTasks& told, const std::string& uav) {
  std::vector<std::string> names;
  for (const ViolationStory& one : told.violations) {
    if (one.uav == uav) names.push_back(one.scm);
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

void draw_violations(Sheet& sheet, const JointTasks& told, const std::string& uav) {
  for (const std::string& scm : scms_of(told, uav)) {
    sheet.gutter(sheet.y + kStrip + 1, scm, "value");
    for (const ViolationStory& one : told.violations) {
      if (one.uav != uav || one.scm != scm) continue;
      sheet.plot.open("g");
      sheet.plot.title(uav + ", " + one.role + ": " + scm + " violated, " + one.what + "\n" +
                       clock_text(one.span.from) + " to " + clock_text(one.span.to));
      sheet.bar(one.span, sheet.y + 1, kStrip, "violated");
      sheet.plot.close();
    }
    sheet.y += kStrip + kJointGap;
  }
}

void draw_joint_rows_of(Sheet& sheet, const JointTasks& told, std::size_t index) {
  const std::string& uav = sheet.run.story.uavs[index].name;
  const auto of_uav = [&](const JointStory& one) { return one.uav == uav; };
  if (std::none_of(told.stories.begin(), told.stories.end(), of_uav)) return;
  sheet.labels.element("text", {{"class", "row"}, {"x", 10}, {"y", sheet.y + 12}},
                       shortened(uav, 15));
  sheet.labels.element("text", {{"class", "under"}, {"x", 10}, {"y", sheet.y + 25}},
                       "role, blocks");
  sheet.plot.open("g", {{"class", "joint " + colour_class(index)}});
  for (const JointStory& story : told.stories) {
    if (!of_uav(story)) continue;
    draw_roles(sheet, story, sheet.y);
    draw_blocks(sheet, story, sheet.y + kJointBand);
    draw_end(sheet, story, sheet.y);
  }
  sheet.y += 2 * kJointBand + kJointGap;
  draw_violations(sheet, told, uav);
  sheet.plot.close();
}

}  // namespace

void draw_joint_rows(Sheet& sheet) {
  const JointTasks told = tell_joint_tasks(sheet.run.journal, sheet.run.story);
  if (told.stories.empty()) return;
  sheet.heading("Joint tasks");
  for (std::size_t i = 0; i < sheet.run.story.uavs.size(); ++i) draw_joint_rows_of(sheet, told, i);
}

// ---- negotiations ----

namespace {

constexpr std::size_t kMostSessions = 40, kMostRows = 60;
constexpr double kColumn = 300.0, kFirst = 190.0, kRow = 17.0, kHead = 22.0;

/// One row of a sequence diagram: a message, or what a member came to.
struct Row {
  double t = 0.0;
  const SessionStep* step = nullptr;
  const Flight* flight = nullptr;
};

std::vector<Row> rows_of(const SessionStory& session) {
  std::vector<Row> rows;
  for (const SessionStep& step : session.steps) rows.push_back({step.t, &step, nullptr});
  for (const Flight& flight : session.messages) rows.push_back({*flight.sent, nullptr, &flight});
  std::stable_sort(rows.begin(), rows.end(), [](const Row& a, const Row& b) { return a.t < b.t; });
  if (rows.size() > kMostRows) rows.resize(kMostRows);
  return rows;
}

double column(const SessionStory& session, const std::string& uav) {
  const auto place = std::lower_bound(session.members.begin(), session.members.end(), uav);
  return kFirst + kColumn * static_cast<double>(place - session.members.begin());
}

// Lost on its way: it ends half-way, in a cross.
void draw_message(Markup& out, const SessionStory& session, const Flight& flight, double y) {
  const double from = column(session, flight.from), to = column(session, flight.to);
  const double end = flight.received ? to : (from + to) / 2;
  out.open("g", {{"class", flight.received ? "message" : "message cut"}});
  out.title(
      flight.from + " to " + flight.to + ", sent " + fixed_number(*flight.sent, 3) + " s" +
      (flight.received ? ", received " + fixed_number(*flight.received, 3) + " s" : ", lost"));
  out.leaf("line", {{"x1", from},
                    {"x2", end},
                    {"y1", y},
                    {"y2", y + kRow / 2},
                    {"marker-end", flight.received ? "url(#message-head)" : ""}});
  if (!flight.received) {
    out.leaf("path", {{"class", "cross"},
                      {"transform",
                       "translate(" + short_number(end) + " " + short_number(y + kRow / 2) + ")"},
                      {"d", "M-3 -3L3 3M-3 3L3 -3"}});
  }
  out.close();
}

void draw_step(Markup& out, const SessionStory& session, const SessionStep& step, double y) {
  const double x = column(session, step.uav);
  const std::string text = step.state + (step.what.empty() ? "" : ": " + step.what);
  out.open("g", {{"class", "session-step"}});
  out.title(step.uav + ": " + text);
  out.leaf("circle", {{"cx", x}, {"cy", y}, {"r", 3}});
  out.element("text", {{"x", x + 8}, {"y", y + 4}}, shortened(text, 46));
  out.close();
}

void write_diagram(Markup& out, const SessionStory& session) {
  const std::vector<Row> rows = rows_of(session);
  const double height = kHead + kRow * static_cast<double>(rows.size()) + 8;
  const double width = kFirst + kColumn * static_cast<double>(session.members.size());
  out.open("svg", {{"class", "sequence"},
                   {"viewBox", "0 0 " + short_number(width) + " " + short_number(height)},
                   {"style", "width:" + short_number(width) + "px"},
                   {"role", "img"},
                   {"aria-label", "Messages of a negotiation from above downwards"}});
  for (const std::string& uav : session.members) {
    const double x = column(session, uav);
    out.element("text", {{"class", "member"}, {"x", x}, {"y", 12}, {"text-anchor", "middle"}}, uav);
    out.leaf("line", {{"class", "life"}, {"x1", x}, {"x2", x}, {"y1", kHead - 4}, {"y2", height}});
  }
  double y = kHead + 6;
  for (const Row& row : rows) {
    out.element("text", {{"class", "when"}, {"x", 4}, {"y", y + 4}}, fixed_number(row.t, 3) + " s");
    if (row.flight != nullptr) draw_message(out, session, *row.flight, y);
    if (row.step != nullptr) draw_step(out, session, *row.step, y);
    y += kRow;
  }
  out.close();
}

}  // namespace

void write_negotiations(Markup& out, const Run& run) {
  const JointTasks told = tell_joint_tasks(run.journal, run.story);
  if (told.sessions.empty()) return;
  out.open("section", {{"class", "card negotiations"}});
  out.element("h2", {}, "Negotiations");
  std::size_t shown = 0;
  for (const SessionStory& session : told.sessions) {
    if (++shown > kMostSessions) break;
    out.open("details");
    out.element("summary", {},
                clock_text(session.name.opened) + " " + session.name.subject + ": " +
                    session.modality + ", opened by " + session.name.opener + ", " +
                    session.steps.back().state + " after " +
                    span_text(session.steps.back().t - session.name.opened) + ", " +
                    counted(session.messages.size(), "message"));
    write_diagram(out, session);
    out.close();
  }
  if (told.sessions.size() > kMostSessions) {
    out.element("p", {}, counted(told.sessions.size() - kMostSessions, "more negotiation"));
  }
  out.close().line_break();
}

}  // namespace skein::report
