// SPDX-License-Identifier: Apache-2.0
#include "result_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <ostream>

#include "result_json.hpp"
#include "skein/foundation/overloaded.hpp"

namespace skein::refine_tool {
namespace {

using world::Vector3;

/// Longer ways are for --json.
constexpr std::size_t kMostPoints = 40;

std::string seconds(Duration duration) {
  if (duration == Duration::max()) return "never";
  const double s = duration.to_seconds();
  if (s < 600) return fmt::format("{:.1f} s", s);
  const auto whole = static_cast<long long>(std::llround(s));
  return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
}

std::string at(const Vector3& p) {
  return fmt::format("({:9.1f}, {:9.1f}, {:7.1f})", p.x(), p.y(), p.z());
}

double degrees(double radians) { return radians * 180 / M_PI; }

/// Lines of "name  value", all names in one column.
class Sheet {
 public:
  Sheet(std::ostream& out, bool colour) : out_(out), colour_(colour) {}

  void line(std::string_view name, const std::string& value) {
    out_ << fmt::format("  {}{:<22}{} {}\n", dim(), name, plain(), value);
  }
  void way(std::string_view name, const refiners::Way& way) {
    if (way.empty()) return;
    line(name, fmt::format("{} points", way.size()));
    for (std::size_t i = 0; i < way.size() && i < kMostPoints; ++i)
      out_ << fmt::format("    {:>4}  {}\n", i + 1, at(way[i]));
    if (way.size() > kMostPoints)
      out_ << fmt::format("          … {} more: --json\n", way.size() - kMostPoints);
  }
  void title(const std::string& text, bool good) {
    const char* paint = good ? "\033[1;32m" : "\033[1;31m";
    out_ << (colour_ ? paint : "") << text << plain() << '\n';
  }

 private:
  const char* dim() const { return colour_ ? "\033[2m" : ""; }
  const char* plain() const { return colour_ ? "\033[0m" : ""; }

  std::ostream& out_;
  bool colour_;
};

std::string share(double fraction) { return fmt::format("{:.1f} %", 100 * fraction); }
std::string metres(double length) { return fmt::format("{:.1f} m", length); }

void write(Sheet& sheet, const refiners::Path& path, const Query&) {
  sheet.line("length", metres(path.length));
  if (path.graph_cost > 0)
    sheet.line("cost on the graph", fmt::format("{:.1f} m × crossing cost", path.graph_cost));
  sheet.line("energy", share(path.energy));
  sheet.way("way", path.way);
}

void write(Sheet& sheet, const refiners::Tour& tour, const Query& query) {
  const auto& stops = std::get<TourWithAreas>(query.question).tour.stops;
  sheet.line("order", tour.exact ? "the best there is" : "the best found");
  sheet.line("length between stops", metres(tour.length));
  sheet.line("energy", share(tour.energy));
  for (std::size_t i = 0; i < tour.visits.size(); ++i) {
    const refiners::Stop& stop = stops[tour.visits[i].stop];
    const refiners::Gate& gate = stop.gates[tour.visits[i].gate];
    const std::string through = gate.entry == gate.exit ? "" : " to " + at(gate.exit);
    sheet.line(fmt::format("{}. {}", i + 1, stop.name), at(gate.entry) + through);
  }
  if (!tour.last.empty()) sheet.line("end", at(tour.last.back()));
}

void write(Sheet& sheet, const refiners::Coverage& coverage, const Query&) {
  sheet.line("lanes", fmt::format("{} along {:.1f}° from east, {} turns", coverage.lanes.size(),
                                  degrees(coverage.direction), coverage.turns));
  if (coverage.headland > 0)
    sheet.line("headland", fmt::format("{:.1f} m; {} of the area is not swept", coverage.headland,
                                       share(coverage.left_out)));
  if (coverage.parts > 1) sheet.line("cut into", fmt::format("{} parts", coverage.parts));
  sheet.line("length", metres(coverage.length));
  sheet.line("energy", share(coverage.energy));
  sheet.way("way", coverage.way);
}

void write(Sheet& sheet, const refiners::Partition& partition, const Query&) {
  sheet.line("spread of finishes", share(partition.spread));
  if (!partition.apart)
    sheet.line("not apart", "the time was up before sweeps that meet had other heights");
  for (const refiners::Part& part : partition.parts)
    sheet.line(part.uav,
               fmt::format("{} of the area, {} lanes {:.0f} m over the ground, done after {}",
                           share(part.share), part.coverage.lanes.size(), part.altitude,
                           seconds(part.duration.expected)));
}

void write(Sheet& sheet, const refiners::Patrol& patrol, const Query&) {
  const refiners::PatrolFigures& p = patrol.predicted;
  const auto bound = [](double value, double least) {
    return fmt::format("{:.0f} s (no patrol so long can do better than {:.0f} s)", value, least);
  };
  sheet.line("cells", fmt::format("{}; {} can never be perceived; {} not seen in the time", p.cells,
                                  p.hidden, p.unseen));
  sheet.line("worst idleness", bound(p.worst_idleness, p.worst_idleness_bound));
  sheet.line("worst risk × idleness", bound(p.worst_risk_idleness, p.worst_risk_idleness_bound));
  sheet.line("mean by risk", bound(p.mean_idleness, p.mean_idleness_bound));
  sheet.line("energy", share(patrol.energy));
  sheet.way("way", patrol.way);
}

void write(Sheet& sheet, const refiners::Viewpoints& viewpoints, const Query&) {
  for (std::size_t i = 0; i < viewpoints.points.size(); ++i) {
    const refiners::ViewPoint& point = viewpoints.points[i];
    sheet.line(
        fmt::format("{}.", i + 1),
        fmt::format("{}  looking {:.0f}° from east, {:.0f}° up; quality {:.2f}, utility {:.2f}",
                    at(point.position), degrees(point.heading), degrees(point.pitch), point.quality,
                    point.utility));
  }
  sheet.line("sight checks", std::to_string(viewpoints.sight_checks));
}

void write(Sheet& sheet, const refiners::Viewshed& view, const Query&) {
  const double cell = view.grid.cell;
  sheet.line("seen", fmt::format("{} of {} cells of {:.0f} m: {:.0f} m2", view.seen, view.asked,
                                 cell, static_cast<double>(view.seen) * cell * cell));
}

void write(Sheet& sheet, const refiners::Relay& relay, const Query&) {
  sheet.line("margin", fmt::format("{:.1f} dB on the weakest link", relay.margin));
  for (std::size_t i = 0; i < relay.positions.size(); ++i)
    sheet.line(fmt::format("relay {}", i + 1), at(relay.positions[i]));
  if (relay.positions.empty()) sheet.line("relays", "none is needed");
}

void write(Sheet& sheet, const refiners::Evaluation& evaluation, const Query&) {
  sheet.line("length", metres(evaluation.length));
  sheet.line("climbs", metres(evaluation.climb));
  sheet.line("energy", share(evaluation.energy));
  sheet.line("least height", metres(evaluation.least_height) + " over the ground");
  for (const refiners::Obstruction& one : evaluation.obstructions)
    sheet.line("closed", fmt::format("leg {} by {} at {}", one.leg + 1, one.by, at(one.at)));
  for (const std::string& limit : evaluation.limits) sheet.line("beyond the vehicle", limit);
}

void write(Sheet& sheet, const refiners::Insertion& insertion, const Query&) {
  sheet.line("position", fmt::format("{} of {}", insertion.position + 1, insertion.added.size()));
  for (std::size_t i = 0; i < insertion.added.size(); ++i)
    sheet.line(fmt::format("at {}", i + 1), std::isfinite(insertion.added[i])
                                                ? fmt::format("{:+.1f} s", insertion.added[i])
                                                : "no way there");
  sheet.way("way there", insertion.to);
  sheet.way("way on", insertion.from);
}

std::string ended_by(const Query& query) {
  const std::string more = "ended the search: more time may do better";
  if (!query.by_default) return "the time budget " + more;
  return fmt::format("the default budget of {:.0f} s {} (--seconds S, --no-budget)", *query.seconds,
                     more);
}

template <class Task>
void write_solution(Sheet& sheet, const refiners::Refined<Task>& refined, const Query& query,
                    const char* unit) {
  sheet.title(query.service + ": feasible", true);
  sheet.line("cost", fmt::format("{:.3f} {}", refined.cost, unit));
  const refiners::DurationInterval& duration = refined.duration;
  sheet.line("duration", fmt::format("{} ({} to {})", seconds(duration.expected),
                                     seconds(duration.least), seconds(duration.most)));
  if (refined.effort.cut_short) sheet.line("cut short", ended_by(query));
  write(sheet, refined.task, query);
}

}  // namespace

void write_text(std::ostream& out, const Query& query, const Answer& answer, bool colour) {
  Sheet sheet(out, colour);
  if (!answer) {
    const refiners::Refusal& refusal = answer.error();
    sheet.title(fmt::format("{}: no solution ({})", query.service, to_text(refusal.kind)), false);
    sheet.line(refusal.field.empty() ? "why" : refusal.field, refusal.why);
    for (const std::string& note : query.notes) sheet.line("note", note);
    return;
  }
  const char* unit = cost_unit(*answer);
  std::visit([&](const auto& refined) { write_solution(sheet, refined, query, unit); }, *answer);
  for (const std::string& note : query.notes) sheet.line("note", note);
}

}  // namespace skein::refine_tool
