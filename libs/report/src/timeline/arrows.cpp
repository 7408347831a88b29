// SPDX-License-Identifier: Apache-2.0
// Synchronisations and messages, drawn from rail to rail.
#include <cmath>
#include <map>
#include <set>
#include <tuple>

#include "timeline/timeline.hpp"

namespace skein::report {

namespace {

constexpr std::size_t kMostMessageLines = 3000;
constexpr std::size_t kMostMessagesShown = 400;
constexpr double kInset = 3.0;  // arrows stop short of the rails' middle

void draw_flight(Sheet& sheet, Markup& out, const Flight& flight, const std::string& kind,
                 bool again = false) {
  const auto from = sheet.rails.find(flight.from), to = sheet.rails.find(flight.to);
  if (from == sheet.rails.end() || to == sheet.rails.end() || from == to) return;
  const double down = to->second > from->second ? 1.0 : -1.0;
  const bool whole = flight.sent && flight.received;
  const double start = flight.sent.value_or(flight.received.value_or(0.0));
  const double end = flight.received.value_or(start);
  out.open("g", {{"class", kind + (whole ? "" : " cut") + (again ? " again" : "")}});
  out.title(clock_text(start) + " " + flight.what + ", " + flight.from + " to " + flight.to +
            (!flight.received ? ": not received"
             : flight.sent    ? ", after " + span_text(end - start)
                              : ""));
  const double y1 = from->second + down * kInset, y2 = to->second - down * kInset;
  // What never arrived is drawn half-way.
  const double y_end = flight.received ? y2 : (y1 + y2) / 2.0;
  if (whole || !flight.received) {
    out.leaf("line", {{"x1", sheet.x(start)},
                      {"y1", y1},
                      {"x2", sheet.x(end)},
                      {"y2", y_end},
                      {"marker-end", "url(#" + kind + "-head)"}});
  }
  out.close();
  if (kind != "sync" || again) return;
  sheet.open_mark(start, from->second, "sync-dot");
  sheet.plot.leaf("circle", {{"r", 3.2}}).close();
}

// For each synchronisation message, whether its receiver had been told before: who is waited for
// says it again until it is answered.
std::vector<bool> said_before(const std::vector<Flight>& syncs) {
  std::set<std::tuple<std::string, std::string, std::string>> heard;
  std::vector<bool> before(syncs.size());
  for (std::size_t i = 0; i < syncs.size(); ++i) {
    const std::tuple about{syncs[i].what, syncs[i].from, syncs[i].to};
    before[i] = heard.count(about) > 0;
    if (syncs[i].received) heard.insert(about);
  }
  return before;
}

// The names of synchronisations, where they leave; those too close to the last one are left out.
void draw_sync_names(Sheet& sheet, const std::vector<bool>& again) {
  std::map<std::string, double> ends;
  for (std::size_t i = 0; i < again.size(); ++i) {
    const Flight& flight = sheet.run.story.syncs[i];
    if (again[i]) continue;
    const auto rail = sheet.rails.find(flight.from);
    if (rail == sheet.rails.end()) continue;
    const double x = sheet.x(flight.sent.value_or(flight.received.value_or(0.0)));
    const auto [last, first] = ends.try_emplace(flight.from, -1e9);
    if (!first && x < last->second) continue;
    const std::string name = "sync " + shortened(flight.what, 14);
    last->second = x + text_width(name, kBarFont) + 12;
    sheet.plot.element(
        "text", {{"class", "sync-name"}, {"x", x}, {"dx", 6}, {"y", rail->second + 3.5}}, name);
  }
}

}  // namespace

bool hides_messages(const Chronology& story) { return story.messages.size() > kMostMessagesShown; }

void draw_arrows(Sheet& sheet) {
  const std::vector<Flight>& messages = sheet.run.story.messages;
  const std::size_t stride = messages.size() / kMostMessageLines + 1;
  sheet.under.open("g", {{"class", "messages"}});
  for (std::size_t i = 0; i < messages.size(); i += stride) {
    draw_flight(sheet, sheet.under, messages[i], "message");
  }
  sheet.under.close();
  sheet.plot.open("g", {{"class", "syncs"}});
  const std::vector<Flight>& syncs = sheet.run.story.syncs;
  const std::vector<bool> again = said_before(syncs);
  for (std::size_t i = 0; i < syncs.size(); ++i) {
    draw_flight(sheet, sheet.plot, syncs[i], "sync", again[i]);
  }
  draw_sync_names(sheet, again);
  sheet.plot.close();
}

}  // namespace skein::report
