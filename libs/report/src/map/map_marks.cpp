// SPDX-License-Identifier: Apache-2.0
#include "map/map_marks.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace skein::report {

namespace {

constexpr double kFont = 12.0;
constexpr double kSmallFont = 10.0;
constexpr double kFarFromTruth = 250.0;  // an alarm farther from any object [m] is about none
constexpr std::size_t kManyUavs = 6;
constexpr std::size_t kMostViewPoints = 300;

// What the marks share while they are drawn.
struct Scene {
  Markup& out;
  const Run& run;
  const MapFrame& frame;
  LabelPlacer placer;

  void label(Point at, double radius, std::string_view text, const char* style, double font) {
    const std::string shown = shortened(text, 32);
    const auto placed = placer.place(at, radius, shown, font);
    if (!placed) return;
    out.element(
        "text",
        {{"class", style}, {"x", placed->x}, {"y", placed->y}, {"text-anchor", placed->anchor}},
        shown);
  }
  void block(Point at, double radius) {
    placer.block({at.x - radius, at.y - radius, at.x + radius, at.y + radius});
  }
};

std::string moved_to(Point p) {
  return "translate(" + short_number(p.x) + " " + short_number(p.y) + ")";
}

void write_places(Scene& s) {
  for (const Place& place : s.run.info.places) s.block(s.frame(place.position), 6);
  for (const Place& place : s.run.info.places) {
    const Point p = s.frame(place.position);
    s.out.open("rect",
               {{"class", "place"}, {"x", p.x - 4}, {"y", p.y - 4}, {"width", 8}, {"height", 8}});
    s.out.title("place " + place.name).close();
    s.label(p, 6, place.name, "place-name", kFont);
  }
}

constexpr std::size_t kFronts = 6;  // of a fire that spreads, at equal intervals

bool spreads(const ObjectRecord& r) { return r.active && r.breadth && r.ignition; }

void write_front(Scene& s, const ObjectRecord& r, bool last) {
  const Point centre = s.frame(r.position), from = s.frame(*r.ignition);
  const double turn = std::atan2(centre.y - from.y, centre.x - from.x) * 180 / std::numbers::pi;
  s.out.open("ellipse",
             {{"class", last ? "front last" : "front"},
              {"rx", r.radius * s.frame.scale},
              {"ry", *r.breadth * s.frame.scale},
              {"transform", moved_to(centre) + " rotate(" + short_number(turn, 1) + ")"}});
  s.out.title("front of fire " + r.name + " at " + clock_text(seconds(r.stamp))).close();
}

/// Its fronts at equal intervals, the last one too. False: it does not spread.
bool write_fronts(Scene& s, const ObjectStory& object) {
  std::vector<const ObjectRecord*> fronts;
  for (const ObjectRecord& r : object.states)
    if (spreads(r)) fronts.push_back(&r);
  if (fronts.empty()) return false;
  const double from = seconds(fronts.front()->stamp), until = seconds(fronts.back()->stamp);
  double next = from;
  for (const ObjectRecord* r : fronts) {
    const bool last = r == fronts.back();
    if (!last && seconds(r->stamp) < next) continue;
    write_front(s, *r, last);
    next += (until - from) / kFronts;
  }
  return true;
}

/// Where the ground station said that an object was, as it was followed.
void write_followed(Scene& s) {
  std::map<std::string, std::vector<Point>> ways;
  for (const auto& [stamp, line] : s.run.journal.seen) {
    if (line.position.size() != 3) continue;
    ways[line.name].push_back(s.frame(Position{line.position[0], line.position[1], 0}));
  }
  for (auto& [name, way] : ways) {
    const Point last = way.back();
    way = simplified(way, 1.0, 500);
    if (way.size() > 1) s.out.leaf("path", {{"class", "followed"}, {"d", path_data(way)}});
    s.out.open("circle", {{"class", "followed"}, {"cx", last.x}, {"cy", last.y}, {"r", 4}});
    s.out.title(name + ", where it was seen last").close();
    s.label(last, 6, name, "place-name", kFont);
  }
}

// The way of a moving thing, then the thing where it was last active.
void write_objects(Scene& s) {
  for (const ObjectStory& object : s.run.story.objects) {
    const bool grows = write_fronts(s, object);
    std::vector<Point> way;
    for (const ObjectRecord& r : object.states) way.push_back(s.frame(r.position));
    way = simplified(way, 1.0, 500);
    if (way.size() > 1 && !grows)
      s.out.leaf("path", {{"class", "object-way"}, {"d", path_data(way)}});
    const auto last = std::find_if(object.states.rbegin(), object.states.rend(),
                                   [](const ObjectRecord& r) { return r.active; });
    const ObjectRecord& shown = last != object.states.rend() ? *last : object.states.back();
    const Point p = s.frame(shown.position);
    const bool fire = object.type == "fire";
    s.out.open("g", {{"class", fire ? "object fire" : "object"}, {"transform", moved_to(p)}});
    s.out.title(object.type + " " + object.name + (shown.active ? "" : " (never active)"));
    const double extent = grows ? 8.0 : std::clamp(shown.radius * s.frame.scale, 8.0, 1e4);
    s.out.leaf("circle", {{"class", "extent"}, {"r", extent}});
    s.out.leaf("path", {{"d", fire ? "M0 7C-6 6 -5 -1 -2 -4C-2 -2 0 -1 0 -8C4 -5 7 5 0 7Z"
                                   : "M0 -6L5 4H-5Z"}});
    s.out.close();
    s.block(p, 9);
  }
}

void write_alarms(Scene& s) {
  for (const AlarmStory& alarm : s.run.story.alarms) {
    const Point p = s.frame(alarm.position);
    const char* state = alarm.state == AlarmState::kConfirmed  ? "confirmed"
                        : alarm.state == AlarmState::kInfirmed ? "infirmed"
                                                               : "raised";
    const std::string name = "alarm " + std::to_string(alarm.id) + " " + state;
    // An alarm held for false is about nothing.
    const std::optional<NearestObject> truth =
        alarm.state == AlarmState::kInfirmed ? std::nullopt : nearest_object(s.run.story, alarm);
    std::string off;
    if (truth) {
      const Point t = s.frame(truth->position);
      s.out.leaf("line", {{"class", "error"}, {"x1", p.x}, {"y1", p.y}, {"x2", t.x}, {"y2", t.y}});
      off = " · " + short_number(truth->metres) + " m off";
    }
    s.out.open("g", {{"class", std::string("alarm ") + state}, {"transform", moved_to(p)}});
    s.out.title(name + ", belief " + short_number(alarm.belief, 2) + off);
    s.out.leaf("path", {{"d", "M0 -12L12 0L0 12L-12 0Z"}});
    if (alarm.state == AlarmState::kInfirmed) s.out.leaf("path", {{"d", "M-4 -4L4 4M-4 4L4 -4"}});
    s.out.close();
    s.block(p, 11);
    s.label(p, 12, name + off, "alarm-name", kFont);
  }
}

// Where a UAV was when a task that takes shots or perceives began to run, and which way it faced.
void write_view_points(Scene& s) {
  std::size_t count = 0;
  for (const TaskBar& bar : s.run.story.tasks) {
    const bool perceives = bar.type.find("shot") != std::string::npos;
    const std::optional<double> t = bar.first(TaskState::kRunning);
    if (!perceives || !t || ++count > kMostViewPoints) continue;
    const UavStory& uav = s.run.story.uavs[bar.uav];
    const std::optional<TrackPoint> p = at(uav.track, *t);
    if (!p) continue;
    s.block(s.frame(p->position), 4);
    const double degrees = -p->heading * 180.0 / M_PI;
    s.out.open("g", {{"class", "view " + colour_class(bar.uav)},
                     {"transform",
                      moved_to(s.frame(p->position)) + " rotate(" + short_number(degrees) + ")"}});
    s.out.title(uav.name + ": " + bar.type + " " + std::to_string(bar.id) + " at " +
                clock_text(*t));
    s.out.leaf("path", {{"class", "wedge"}, {"d", "M0 0L26 -11A28 28 0 0 1 26 11Z"}});
    s.out.leaf("circle", {{"r", 3}}).close();
  }
}

// Triangles where a UAV left or reached the ground.
void write_takeoffs(Scene& s) {
  for (std::size_t i = 0; i < s.run.story.uavs.size(); ++i) {
    const UavStory& uav = s.run.story.uavs[i];
    for (std::size_t k = 1; k < uav.track.size(); ++k) {
      const bool up = uav.track[k].airborne;
      if (up == uav.track[k - 1].airborne) continue;
      s.out.open("path", {{"class", (up ? "takeoff " : "landing ") + colour_class(i)},
                          {"transform", moved_to(s.frame(uav.track[k].position))},
                          {"d", up ? "M0 -7L6 4H-6Z" : "M0 7L6 -4H-6Z"}});
      s.out.title(uav.name + (up ? " takes off at " : " lands at ") + clock_text(uav.track[k].t));
      s.out.close();
    }
  }
}

// In the air, or driving.
bool is_on_its_way(const UavStory& uav, const TrackPoint& point) {
  constexpr double kStands = 0.2;  // [m/s]
  return point.airborne || (uav.keeps_to_ground() && point.speed > kStands);
}

// Dots at round times on the way; the time beside them where there is room.
void write_times(Scene& s) {
  const Span& time = s.run.story.time;
  const bool crowded = s.run.story.uavs.size() > kManyUavs;
  const double step = round_time_step((time.to - time.from) / (crowded ? 4.0 : 12.0));
  const std::vector<double> instants = ticks(time.from, time.to, step);
  for (std::size_t i = 0; i < s.run.story.uavs.size(); ++i) {
    std::optional<Point> last;
    for (const double t : instants) {
      const std::optional<TrackPoint> p = at(s.run.story.uavs[i].track, t);
      if (!p || !is_on_its_way(s.run.story.uavs[i], *p)) continue;
      const Point here = s.frame(p->position);
      if (last && std::hypot(here.x - last->x, here.y - last->y) < 14) continue;
      last = here;
      s.out.leaf(
          "circle",
          {{"class", "time " + colour_class(i)}, {"cx", here.x}, {"cy", here.y}, {"r", 2.6}});
      if (crowded) continue;
      s.label(here, 3, clock_text(t), ("time-text t" + colour_class(i)).c_str(), kSmallFont);
    }
  }
}

// The name of each UAV beside the middle of its way, wherever it is free.
void write_names(Scene& s) {
  for (std::size_t i = 0; i < s.run.story.uavs.size(); ++i) {
    const UavStory& uav = s.run.story.uavs[i];
    for (const double part : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8}) {
      if (uav.track.empty()) break;
      const auto index = static_cast<std::size_t>(part * static_cast<double>(uav.track.size() - 1));
      if (!is_on_its_way(uav, uav.track[index])) continue;
      const Point p = s.frame(uav.track[index].position);
      const std::string name = shortened(uav.name, 20);
      const auto placed = s.placer.place(p, 5, name, 13.0);
      if (!placed) continue;
      s.out.element("text",
                    {{"class", "uav-name t" + colour_class(i)},
                     {"x", placed->x},
                     {"y", placed->y},
                     {"text-anchor", placed->anchor}},
                    name);
      break;
    }
  }
}

// Labels keep off the trajectories: a point every few pixels along each.
void avoid_tracks(Scene& s) {
  constexpr double kStep = 5.0;
  constexpr std::size_t kMost = 8000;
  std::size_t count = 0;
  for (const UavStory& uav : s.run.story.uavs) {
    Point last{-1e9, -1e9};
    for (const TrackPoint& t : uav.track) {
      const Point p = s.frame(t.position);
      if (std::hypot(p.x - last.x, p.y - last.y) < kStep) continue;
      if (++count > kMost) return;
      s.placer.avoid(p);
      last = p;
    }
  }
}

struct LegendEntry {
  const char* icon;
  const char* text;
};

void write_legend_entry(Markup& out, std::string_view icon, std::string_view text) {
  out.open("span", {{"class", "key"}});
  out.open("svg",
           {{"viewBox", "-12 -10 24 20"}, {"width", 24}, {"height", 20}, {"aria-hidden", "true"}});
  out.raw(icon).close();
  out.text(text).close();
}

/// Of joint tasks: what there is of them.
void write_joint_legend(Markup& out, const Run& run) {
  const auto& journal = run.journal;
  if (!journal.scms.empty())
    write_legend_entry(out, "<path class='violated-stretch' d='M-9 0H9'/>", "constraint violated");
  if (!journal.places.empty())
    write_legend_entry(out, "<path class='role-place u0' d='M0 -6L6 0L0 6L-6 0Z'/>",
                       "place of a role");
  const auto shares = [](const auto& one) { return one.line.modality == "area-sharing"; };
  if (std::any_of(journal.negotiations.begin(), journal.negotiations.end(), shares))
    write_legend_entry(out, "<path class='part u0' d='M-10 5L-6 -6L9 -4L10 6Z'/>",
                       "part of a shared area");
}

}  // namespace

std::optional<NearestObject> nearest_object(const Chronology& story, const AlarmStory& alarm) {
  std::optional<NearestObject> best;
  const double t = alarm.steps.empty() ? story.time.to : alarm.steps.front().first;
  for (const ObjectStory& object : story.objects) {
    const ObjectRecord* now = nullptr;
    for (const ObjectRecord& r : object.states) {
      if (seconds(r.stamp) <= t) now = &r;
    }
    if (now == nullptr || !now->active) continue;
    const double metres =
        std::hypot(now->position.x - alarm.position.x, now->position.y - alarm.position.y);
    if (metres > kFarFromTruth || (best && best->metres <= metres)) continue;
    best = NearestObject{object.name, now->position, metres};
  }
  return best;
}

void write_map_marks(Markup& out, const Run& run, const MapFrame& frame) {
  Scene scene{out, run, frame, LabelPlacer({4, 4, frame.width - 4, frame.height - 4})};
  scene.placer.block({frame.width - 48, 0, frame.width, 48});                             // north
  scene.placer.block({frame.width - 170, frame.height - 40, frame.width, frame.height});  // scale
  for (const Zone& zone : run.info.zones) {
    for (const GroundPoint& p : zone.polygon) scene.block(frame(p.x, p.y), 8);
  }
  avoid_tracks(scene);
  write_objects(scene);
  write_followed(scene);
  write_view_points(scene);
  write_takeoffs(scene);
  write_alarms(scene);
  write_places(scene);
  write_names(scene);
  write_times(scene);
}

void write_map_legend(Markup& out, const Run& run) {
  out.open("div", {{"class", "legend"}});
  const std::size_t shown = std::min(run.story.uavs.size(), std::size_t{24});
  for (std::size_t i = 0; i < shown; ++i) {
    write_legend_entry(out,
                       "<path class='" + colour_class(i) + (i >= kUavColours ? " dashed" : "") +
                           "' style='fill:none;stroke:var(--c);stroke-width:3' d='M-11 0H11'/>",
                       run.story.uavs[i].name);
  }
  const LegendEntry entries[] = {
      {"<path class='planned u0' d='M-11 0H11'/>", "way planned"},
      {"<path class='takeoff u0' d='M0 -7L6 4H-6Z'/>", "take-off"},
      {"<path class='landing u0' d='M0 7L6 -4H-6Z'/>", "landing"},
      {"<g class='view u0' transform='translate(-10)'><path class='wedge' d='M0 0L20 -8V8Z'/>"
       "<circle r='3'/></g>",
       "shot taken from"},
      {"<g class='object fire'><path d='M0 7C-6 6 -5 -1 -2 -4C-2 -2 0 -1 0 -8C4 -5 7 5 0 7Z'/></g>",
       "fire (truth)"},
      {"<g class='alarm raised'><path d='M0 -8L8 0L0 8L-8 0Z'/></g>", "alarm raised"},
      {"<g class='alarm confirmed'><path d='M0 -8L8 0L0 8L-8 0Z'/></g>", "confirmed"},
      {"<g class='alarm infirmed'><path d='M0 -8L8 0L0 8L-8 0Z'/><path d='M-4 -4L4 4M-4 4L4 -4'/>"
       "</g>",
       "infirmed"},
      {"<rect class='place' x='-4' y='-4' width='8' height='8'/>", "place"},
      {"<rect class='zone' x='-10' y='-6' width='20' height='12'/>", "zone"},
      {"<circle class='time u0' r='3'/>", "time along the way"}};
  const auto& objects = run.journal.objects;
  if (std::any_of(objects.begin(), objects.end(), spreads)) {
    write_legend_entry(out, "<ellipse class='front last' rx='10' ry='6'/>", "fire front (truth)");
  }
  if (!run.journal.seen.empty()) {
    write_legend_entry(
        out, "<path class='followed' d='M-11 0H6'/><circle class='followed' cx='8' r='4'/>",
        "object as followed");
  }
  write_joint_legend(out, run);
  if (!run.journal.air.empty()) {
    write_legend_entry(out,
                       "<g class='reserved now u0'><line x1='-4' x2='4' stroke-width='14'/></g>",
                       "air reserved (at the cursor)");
  }
  for (const LegendEntry& e : entries) write_legend_entry(out, e.icon, e.text);
  out.close().line_break();
}

}  // namespace skein::report
