// SPDX-License-Identifier: Apache-2.0
#include "story/chronology.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "story/links.hpp"

namespace skein::report {

namespace {

bool is_terminal(TaskState s) { return s == TaskState::kEnded || s == TaskState::kAborted; }

template <class Record>
void widen(std::optional<Span>& span, const std::vector<Record>& records) {
  if (records.empty()) return;
  const Span here{seconds(records.front().stamp), seconds(records.back().stamp)};
  if (!span) {
    span = here;
  } else {
    span = Span{std::min(span->from, here.from), std::max(span->to, here.to)};
  }
}

Span whole_time(const Journal& journal) {
  std::optional<Span> found;
  std::apply([&](const auto&... records) { (widen(found, records), ...); }, records_of(journal));
  Span span = found.value_or(Span{0.0, 1.0});
  span.from = std::min(span.from, 0.0);
  span.to = std::max(span.to, span.from + 1.0);
  return span;
}

class UavTable {
 public:
  explicit UavTable(std::vector<UavStory>& uavs) : uavs_(uavs) {}

  std::size_t index(const std::string& name) {
    const auto [it, added] = indices_.try_emplace(name, uavs_.size());
    if (added) {
      UavStory story;
      story.name = name;
      uavs_.push_back(std::move(story));
    }
    return it->second;
  }
  UavStory& operator[](const std::string& name) { return uavs_[index(name)]; }

 private:
  std::vector<UavStory>& uavs_;
  std::map<std::string, std::size_t> indices_;
};

void tell_uavs(const RunInfo& info, const Journal& journal, UavTable& table) {
  for (const UavInfo& uav : info.uavs) {
    UavStory& story = table[uav.name];
    story.model = uav.model;
    story.degree = uav.degree;
  }
  for (const TelemetryRecord& r : journal.telemetry) {
    std::vector<TrackPoint>& track = table[r.uav].track;
    const double t = seconds(r.stamp);
    if (!track.empty() && track.back().t >= t) track.pop_back();
    const double speed = std::hypot(r.velocity.x, r.velocity.y, r.velocity.z);
    track.push_back({t, r.position, speed, r.heading, r.energy, r.airborne});
  }
  for (const DegreeRecord& r : journal.degrees) {
    UavStory& story = table[r.uav];
    const int degree = static_cast<int>(std::clamp<std::int64_t>(r.degree, -1, 99));
    const int before =
        story.degrees.empty() ? story.degree.value_or(-1) : story.degrees.back().second;
    if (before != degree) story.degrees.emplace_back(seconds(r.stamp), degree);
  }
}

// Folds the records of tasks, in time order, into bars.
class BarBuilder {
 public:
  explicit BarBuilder(UavTable& uavs) : uavs_(uavs) {}

  void add(const TaskRecord& r) {
    const std::pair key{uavs_.index(r.uav), r.task};
    const auto it = alive_.find(key);
    const double t = seconds(r.stamp);
    if (it == alive_.end()) {
      if (ended_again(key, r)) return;
      begin(key, r, t);
    } else {
      advance(bars_[it->second], r, t);
    }
    if (is_terminal(r.state)) {
      last_[key] = r.state;
      alive_.erase(key);
    }
  }

  std::vector<TaskBar> finish(double end) {
    for (const auto& [key, index] : alive_) close_segment(bars_[index], end);
    std::stable_sort(bars_.begin(), bars_.end(), [](const TaskBar& a, const TaskBar& b) {
      return std::tie(a.uav, a.span.from) < std::tie(b.uav, b.span.from);
    });
    return std::move(bars_);
  }

 private:
  using Key = std::pair<std::size_t, std::uint64_t>;

  // Ground and UAV may both write the end of one task.
  bool ended_again(const Key& key, const TaskRecord& r) const {
    const auto it = last_.find(key);
    return it != last_.end() && it->second == r.state;
  }

  void begin(const Key& key, const TaskRecord& r, double t) {
    TaskBar bar;
    bar.uav = key.first;
    bar.id = r.task;
    bar.type = r.type;
    bar.span = {t, t};
    bar.reason = r.reason;
    if (is_terminal(r.state)) {
      bar.outcome = r.state;
    } else {
      bar.segments.push_back({r.state, {t, t}});
      alive_[key] = bars_.size();
    }
    bars_.push_back(std::move(bar));
  }

  static void advance(TaskBar& bar, const TaskRecord& r, double t) {
    if (!r.reason.empty()) bar.reason = r.reason;
    if (bar.segments.back().state == r.state) return;
    close_segment(bar, t);
    if (is_terminal(r.state)) {
      bar.outcome = r.state;
    } else {
      bar.segments.push_back({r.state, {t, t}});
    }
  }

  static void close_segment(TaskBar& bar, double t) {
    Span& last = bar.segments.back().span;
    last.to = std::max(last.from, t);
    bar.span.to = last.to;
  }

  UavTable& uavs_;
  std::vector<TaskBar> bars_;
  std::map<Key, std::size_t> alive_;
  std::map<Key, TaskState> last_;
};

std::vector<TaskBar> tell_tasks(const Journal& journal, UavTable& uavs, double end) {
  BarBuilder builder(uavs);
  for (const TaskRecord& r : journal.tasks) builder.add(r);
  std::vector<TaskBar> bars = builder.finish(end);
  std::map<std::pair<std::size_t, std::uint64_t>, std::string> componels;
  for (const auto& told : journal.role_tasks)
    componels[{uavs.index(told.line.uav), told.line.task}] = told.line.componel;
  for (TaskBar& bar : bars) {
    const auto found = componels.find({bar.uav, bar.id});
    if (found != componels.end()) bar.componel = found->second;
  }
  return bars;
}

std::vector<NamedSpan> tell_phases(const Journal& journal, double end) {
  std::vector<NamedSpan> phases;
  for (const PhaseRecord& r : journal.phases) {
    if (!phases.empty() && phases.back().name == r.name) continue;
    if (!phases.empty()) phases.back().span.to = seconds(r.stamp);
    phases.push_back({r.name, {seconds(r.stamp), end}});
  }
  return phases;
}

std::vector<AlarmStory> tell_alarms(const Journal& journal) {
  std::vector<AlarmStory> alarms;
  std::map<std::uint64_t, std::size_t> indices;
  for (const AlarmRecord& r : journal.alarms) {
    const auto [it, added] = indices.try_emplace(r.alarm, alarms.size());
    if (added) alarms.emplace_back();
    AlarmStory& story = alarms[it->second];
    story.id = r.alarm;
    story.position = r.position;
    story.belief = r.belief;
    story.state = r.state;
    if (story.steps.empty() || story.steps.back().second != r.state) {
      story.steps.emplace_back(seconds(r.stamp), r.state);
    }
  }
  return alarms;
}

std::vector<ObjectStory> tell_objects(const Journal& journal) {
  std::vector<ObjectStory> objects;
  std::map<std::string, std::size_t> indices;
  for (const ObjectRecord& r : journal.objects) {
    const auto [it, added] = indices.try_emplace(r.name, objects.size());
    if (added) objects.push_back({r.name, r.type, {}});
    objects[it->second].states.push_back(r);
  }
  return objects;
}

}  // namespace

double seconds(const Stamp& stamp) { return static_cast<double>(stamp.at.count()) / 1e9; }

bool UavStory::keeps_to_ground() const {
  return std::none_of(track.begin(), track.end(), [](const TrackPoint& p) { return p.airborne; });
}

std::optional<Span> TaskBar::active() const {
  for (const TaskSegment& s : segments) {
    if (s.state != TaskState::kScheduled) return Span{s.span.from, span.to};
  }
  return std::nullopt;
}

std::optional<double> TaskBar::first(TaskState state) const {
  for (const TaskSegment& s : segments) {
    if (s.state == state) return s.span.from;
  }
  return std::nullopt;
}

std::optional<std::size_t> Chronology::uav_index(const std::string& name) const {
  const auto it =
      std::find_if(uavs.begin(), uavs.end(), [&](const UavStory& u) { return u.name == name; });
  if (it == uavs.end()) return std::nullopt;
  return static_cast<std::size_t>(it - uavs.begin());
}

Chronology tell(const RunInfo& info, const Journal& journal) {
  Chronology c;
  c.time = whole_time(journal);
  UavTable table(c.uavs);
  tell_uavs(info, journal, table);
  c.tasks = tell_tasks(journal, table, c.time.to);
  c.phases = tell_phases(journal, c.time.to);
  c.syncs = pair_syncs(journal.syncs);
  c.messages = pair_messages(journal.messages);
  c.links = tell_links(journal, c.time.to);
  c.alarms = tell_alarms(journal);
  c.objects = tell_objects(journal);
  return c;
}

std::optional<TrackPoint> between(const TrackPoint& a, const TrackPoint& b, double t) {
  if (t < a.t || t > b.t) return std::nullopt;
  if (t == b.t) return b;
  TrackPoint p = a;
  const double part = (t - a.t) / (b.t - a.t);
  const auto mix = [part](double from, double to) { return from + (to - from) * part; };
  p.position = {mix(a.position.x, b.position.x), mix(a.position.y, b.position.y),
                mix(a.position.z, b.position.z)};
  p.speed = mix(a.speed, b.speed);
  p.energy = mix(a.energy, b.energy);
  p.heading += std::remainder(b.heading - a.heading, 2.0 * M_PI) * part;
  p.t = t;
  return p;
}

std::optional<TrackPoint> at(const std::vector<TrackPoint>& track, double t) {
  if (track.empty() || t < track.front().t || t > track.back().t) return std::nullopt;
  const auto after = std::lower_bound(track.begin(), track.end(), t,
                                      [](const TrackPoint& p, double time) { return p.t < time; });
  return after == track.begin() ? *after : between(*(after - 1), *after, t);
}

}  // namespace skein::report
