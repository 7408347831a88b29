// SPDX-License-Identifier: Apache-2.0
// The tables below the drawings.
#include <algorithm>

#include "page/table.hpp"
#include "page/views.hpp"
#include "story/links.hpp"

namespace skein::report {

namespace {

constexpr std::size_t kMostTableRows = 400;

void write_row(Markup& out, std::initializer_list<std::string> cells) {
  out.open("tr");
  write_cells(out, cells);
  out.close();
}

std::string degrees_text(const UavStory& uav) {
  std::string text = uav.degree ? std::to_string(*uav.degree) : "";
  for (const auto& [t, degree] : uav.degrees) {
    text += (text.empty() ? "" : " → ") + std::to_string(degree);
  }
  return text.empty() ? "–" : shortened(text, 30);
}

std::string share(double part, double whole) {
  return whole > 0 ? fixed_number(100.0 * part / whole, 1) + " %" : "–";
}

// For how long two sets of spans hold together, of the whole time.
void write_link_row(Markup& out, const LinkStory& link, std::size_t d, double whole) {
  const std::string& from = d == 0 ? link.first : link.second;
  const std::string& to = d == 0 ? link.second : link.first;
  const bool truth = link.truth[d], belief = link.belief[d];
  const std::size_t cuts = link.up[d].empty() ? 0 : link.up[d].size() - 1;
  write_row(out, {from + " → " + to, truth ? share(total(link.up[d]), whole) : "–",
                  truth ? std::to_string(cuts) : "–",
                  belief ? share(total(link.believed[d]), whole) : "–",
                  truth && belief ? span_text(disagreement(link.up[d], link.believed[d])) : "–"});
}

struct Event {
  double t;
  std::string who;
  std::string text;
  const char* style;
};

class EventList {
 public:
  template <class Record, class Text>
  void add(const std::vector<Record>& records, const char* style, Text text) {
    for (const Record& r : records) {
      std::string said = text(r);
      if (!said.empty()) {
        events_.push_back({seconds(r.stamp), r.stamp.node, std::move(said), style});
      }
    }
  }
  std::vector<Event> in_order() {
    std::stable_sort(events_.begin(), events_.end(),
                     [](const Event& a, const Event& b) { return a.t < b.t; });
    return std::move(events_);
  }

 private:
  std::vector<Event> events_;
};

std::string because(const std::string& why) { return why.empty() ? "" : ": " + why; }

void add_mission_events(EventList& list, const Journal& j) {
  list.add(j.missions, "", [](const MissionRecord& r) { return "mission " + r.state; });
  list.add(j.phases, "phase", [](const PhaseRecord& r) { return "phase " + r.name; });
  list.add(j.operators, "operator", [](const OperatorRecord& r) { return "operator: " + r.does; });
  list.add(j.alarms, "alarm", [](const AlarmRecord& r) {
    const char* names[] = {"raised", "confirmed", "infirmed"};
    return "alarm " + std::to_string(r.alarm) + " " + names[static_cast<std::size_t>(r.state)] +
           ", belief " + short_number(r.belief, 2);
  });
  list.add(j.degrees, "", [](const DegreeRecord& r) {
    return r.uav + " at autonomy degree " + std::to_string(r.degree);
  });
}

void add_trouble_events(EventList& list, const Journal& j) {
  list.add(j.tasks, "trouble", [](const TaskRecord& r) {
    if (r.state != TaskState::kAborted) return std::string();
    return r.uav + ": " + r.type + " " + std::to_string(r.task) + " aborted" + because(r.reason);
  });
  list.add(j.requests, "trouble", [](const RequestRecord& r) {
    return r.accepted ? std::string() : r.uav + " refused " + r.request + because(r.why);
  });
  list.add(j.commands, "trouble", [](const CommandRecord& r) {
    const bool bad = r.state == CommandState::kRefused || r.state == CommandState::kExpired;
    const char* what = r.state == CommandState::kRefused ? " refused" : " expired";
    return bad ? r.uav + ": command " + r.what + what + because(r.why) : std::string();
  });
  list.add(j.faults, "fault",
           [](const FaultRecord& r) { return "fault: " + r.what + " " + r.target; });
  list.add(j.processes, "fault", [](const ProcessRecord& r) {
    const bool usual = r.state == "started" || r.state == "ready";
    return usual ? std::string() : r.name + " " + r.state + because(r.why);
  });
  list.add(j.links, "fault", [](const LinkRecord& r) {
    const bool news = r.stamp.at > MissionTime();
    return news ? "link " + r.from + " → " + r.to + (r.up ? " up" : " down") : std::string();
  });
  list.add(j.dropped, "trouble", [](const DroppedRecord& r) {
    return r.slot + " from " + r.origin + " dropped, " + r.field + because(r.why);
  });
}

}  // namespace

void write_live_table(Markup& out, const Run& run) {
  out.open("section", {{"class", "card live-card needs-script"}});
  out.open("h2").text("At ").element("span", {{"id", "live-time"}}, "0:00").text(" ");
  out.element("span", {{"id", "live-phase"}}, "").close();
  out.open("table", {{"id", "live-table"}}).open("tbody");
  for (std::size_t i = 0; i < std::min(run.story.uavs.size(), std::size_t{24}); ++i) {
    out.open("tr", {{"data-uav", i}});
    write_uav_name(out, i, shortened(run.story.uavs[i].name, 16));
    for (const char* cell : {"task", "altitude", "speed", "energy"}) {
      out.element("td", {{"class", cell}}, "");
    }
    out.close();
  }
  out.close().close().close().line_break();
}

void write_uav_table(Markup& out, const Run& run) {
  if (run.story.uavs.empty()) return;
  open_table(out, "UAVs",
             {"UAV", "model", "degree", "distance", "in the air", "highest", "fastest",
              "energy used", "tasks", "ended", "aborted"});
  for (std::size_t i = 0; i < run.story.uavs.size(); ++i) {
    const UavStory& uav = run.story.uavs[i];
    const UavFigures& f = run.figures.uavs[i];
    out.open("tr");
    write_uav_name(out, i, uav.name);
    for (const std::string& cell :
         {uav.model.empty() ? "–" : uav.model, degrees_text(uav), length_text(f.distance),
          clock_text(f.airborne), f.max_altitude ? length_text(*f.max_altitude) : "–",
          short_number(f.max_speed) + " m/s",
          f.energy_used ? fixed_number(*f.energy_used * 100.0, 1) + " %" : "–",
          std::to_string(f.tasks), std::to_string(f.ended), std::to_string(f.aborted)}) {
      out.element("td", {}, cell);
    }
    out.close();
  }
  close_table(out);
}

void write_message_table(Markup& out, const Run& run) {
  if (run.figures.channels.empty()) return;
  open_table(
      out, "Event messages by slot and channel",
      {"slot", "channel", "sent", "received", "lost", "expired", "median latency", "95 % within"});
  std::size_t rows = 0;
  for (const auto& [key, f] : run.figures.channels) {
    if (++rows > kMostTableRows) break;
    const auto& [slot, from, to] = key;
    const bool timed = !f.latencies.empty();
    write_row(out, {slot, from + " → " + to, grouped(f.sent), grouped(f.received), grouped(f.lost),
                    grouped(f.expired), timed ? span_text(quantile(f.latencies, 0.5)) : "–",
                    timed ? span_text(quantile(f.latencies, 0.95)) : "–"});
  }
  close_table(out);
}

void write_link_table(Markup& out, const Run& run) {
  if (run.story.links.empty()) return;
  open_table(out, "Links: truth and belief",
             {"from → to", "up", "cuts", "believed reachable", "belief wrong for"});
  const double whole = run.story.time.to - run.story.time.from;
  std::size_t rows = 0;
  for (const LinkStory& link : run.story.links) {
    for (const std::size_t d : {0U, 1U}) {
      const bool known = link.truth[d] || link.belief[d];
      if (known && ++rows <= kMostTableRows) write_link_row(out, link, d, whole);
    }
  }
  close_table(out);
}

void write_event_list(Markup& out, const Run& run) {
  EventList list;
  add_mission_events(list, run.journal);
  add_trouble_events(list, run.journal);
  const std::vector<Event> events = list.in_order();
  if (events.empty()) return;
  out.open("section", {{"class", "card chronicle-card"}}).element("h2", {}, "Chronicle");
  out.open("div", {{"class", "scroll"}});
  out.open("table", {{"class", "chronicle"}}).open("tbody");
  for (std::size_t i = 0; i < std::min(events.size(), kMostTableRows); ++i) {
    const Event& e = events[i];
    out.open("tr", {{"class", e.style}, {"data-t", e.t}});
    out.element("td", {}, clock_text(e.t)).element("td", {}, e.who).element("td", {}, e.text);
    out.close();
  }
  out.close().close();
  if (events.size() > kMostTableRows) {
    out.element("p", {{"class", "empty"}},
                "and " + counted(events.size() - kMostTableRows, "more event"));
  }
  out.close().close().line_break();
}

}  // namespace skein::report
