// SPDX-License-Identifier: Apache-2.0
#include "joint_story.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "line.hpp"
#include "text.hpp"

namespace skein::report {

namespace {

bool is_over(const std::string& phase) {
  return phase == "ended" || phase == "aborted" || phase == "not-loaded";
}

class Teller {
 public:
  Teller(const Chronology& story, JointTasks& told) : story_(story), told_(told) {}

  void see(const std::string& kind, const Line& line) {
    if (kind == "joint") see_joint(line);
    if (kind == "scm") see_scm(line);
    if (kind == "negotiation") see_negotiation(line);
    if (kind == "place") see_place(line);
  }

  void finish() {
    for (const auto& [key, index] : open_joints_) {
      told_.stories[index].segments.back().span.to = story_.time.to;
    }
    for (const auto& [key, index] : open_violations_) {
      told_.violations[index].span.to = story_.time.to;
    }
    std::stable_sort(told_.stories.begin(), told_.stories.end(),
                     [](const auto& a, const auto& b) { return a.uav < b.uav; });
    for (SessionStory& session : told_.sessions) add_messages(session);
  }

 private:
  void see_joint(const Line& line) {
    const std::string phase = line.text("phase");
    const std::pair key{line.text("uav"), line.text("joint")};
    end_violations(key, line.text("violated"), line.t);
    auto open = open_joints_.find(key);
    if (open == open_joints_.end() && is_over(phase)) return;
    if (open == open_joints_.end()) {
      open = open_joints_.emplace(key, told_.stories.size()).first;
      told_.stories.push_back({key.first, key.second, {}, "", ""});
    }
    JointStory& story = told_.stories[open->second];
    if (!story.segments.empty()) story.segments.back().span.to = line.t;
    if (is_over(phase)) {
      story.end = phase;
      story.why = line.text("why");
      open_joints_.erase(open);
      return;
    }
    JointSegment next{phase, line.text("role"), line.text("blocks"), {line.t, line.t}};
    if (!story.segments.empty()) {
      const JointSegment& last = story.segments.back();
      if (std::tie(last.phase, last.role, last.blocks) ==
          std::tie(next.phase, next.role, next.blocks)) {
        return;
      }
    }
    story.segments.push_back(std::move(next));
  }

  // What a joint task no longer names is not watched any more: its block is over, or the role has
  // changed.
  void end_violations(const std::pair<std::string, std::string>& joint, const std::string& violated,
                      double at) {
    std::istringstream words(violated);
    const std::set<std::string> named{std::istream_iterator<std::string>(words), {}};
    std::erase_if(open_violations_, [&](const auto& open) {
      const auto& [uav, task, scm] = open.first;
      if (std::tie(uav, task) != std::tie(joint.first, joint.second) || named.count(scm) > 0) {
        return false;
      }
      told_.violations[open.second].span.to = at;
      return true;
    });
  }

  void see_scm(const Line& line) {
    const std::tuple key{line.text("uav"), line.text("joint"), line.text("scm")};
    if (const auto open = open_violations_.find(key); open != open_violations_.end()) {
      told_.violations[open->second].span.to = line.t;
      open_violations_.erase(open);
    }
    if (line.text("state") != "violated") return;
    open_violations_[key] = told_.violations.size();
    told_.violations.push_back(
        {line.text("uav"),
         line.text("role"),
         line.text("scm"),
         "to " + line.text("place") + " " + short_number(line.number("measured"), 2) +
             ", required " + line.text("relation") + " " + short_number(line.number("required"), 2),
         {line.t, line.t}});
  }

  void see_place(const Line& line) {
    const auto at = line.keys.find("position");
    if (at == line.keys.end() || !at->is_array() || at->size() != 3) return;
    Position position;
    double* const figures[] = {&position.x, &position.y, &position.z};
    for (std::size_t i = 0; i < 3; ++i) {
      if (!(*at)[i].is_number()) return;
      *figures[i] = (*at)[i].get<double>();
    }
    told_.places.push_back({line.t, line.text("uav"), line.text("role"), line.text("parameter"),
                            line.text("by"), line.text("scms"), position});
  }

  // "heron 150 60 900 -40 …, wren …": a name and corners each. All members tell the same.
  void see_parts(const Line& line) {
    std::istringstream rows(line.text("rows"));
    for (std::string row; std::getline(rows, row, ',');) {
      std::istringstream words(row);
      PartStory part;
      part.t = line.t;
      words >> part.uav;
      for (GroundPoint corner; words >> corner.x >> corner.y;) part.corners.push_back(corner);
      if (part.corners.size() >= 3) told_.parts.push_back(std::move(part));
    }
  }

  void see_negotiation(const Line& line) {
    const std::tuple key{line.text("joint"), line.text("opener"), line.number("opened")};
    auto known = sessions_.find(key);
    if (known == sessions_.end()) {
      known = sessions_.emplace(key, told_.sessions.size()).first;
      told_.sessions.push_back({std::get<0>(key),
                                line.text("modality"),
                                std::get<1>(key),
                                std::get<2>(key),
                                {},
                                {},
                                {}});
    }
    SessionStory& session = told_.sessions[known->second];
    const bool shares = session.modality == "area-sharing" && line.text("state") == "agreed";
    if (shares && shared_.insert(key).second) see_parts(line);
    const std::string uav = line.text("uav"), rows = line.text("rows");
    auto& members = session.members;
    const auto place = std::lower_bound(members.begin(), members.end(), uav);
    if (place == members.end() || *place != uav) members.insert(place, uav);
    session.steps.push_back(
        {line.t, uav, line.text("state"), rows.empty() ? line.text("why") : rows});
  }

  // Messages are not told apart by session: those on their way while it lasted.
  void add_messages(SessionStory& session) const {
    const double until = session.steps.back().t;
    const auto is_member = [&](const std::string& name) {
      return std::binary_search(session.members.begin(), session.members.end(), name);
    };
    for (const Flight& flight : story_.messages) {
      if (flight.what != "NegotiationMessage" || !flight.sent) continue;
      if (*flight.sent < session.opened || *flight.sent > until) continue;
      if (is_member(flight.from) && is_member(flight.to)) session.messages.push_back(flight);
    }
  }

  const Chronology& story_;
  JointTasks& told_;
  std::map<std::pair<std::string, std::string>, std::size_t> open_joints_;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> open_violations_;
  std::map<std::tuple<std::string, std::string, double>, std::size_t> sessions_;
  std::set<std::tuple<std::string, std::string, double>> shared_;
};

}  // namespace

JointTasks tell_joint_tasks(const Journal& journal, const Chronology& story) {
  JointTasks told;
  Teller teller(story, told);
  for (const OtherRecord& record : journal.others) {
    static const std::set<std::string> kinds{"joint", "scm", "negotiation", "place"};
    if (!kinds.contains(record.kind)) continue;
    if (const auto line = line_of(record)) teller.see(record.kind, *line);
  }
  teller.finish();
  return told;
}

}  // namespace skein::report
