// SPDX-License-Identifier: Apache-2.0
#include "story/joint_story.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "text.hpp"

namespace skein::report {

namespace {

namespace lines = journal::lines;

bool is_over(const std::string& phase) {
  return phase == "ended" || phase == "aborted" || phase == "not-loaded";
}

class Teller {
 public:
  Teller(const Chronology& story, JointTasks& told) : story_(story), told_(told) {}

  void see_joint(double t, const lines::Joint& line) {
    const std::string phase = line.phase;
    const std::pair<std::string, std::string> key{line.uav, line.joint};
    end_violations(key, is_over(phase) ? std::string() : std::string(line.violated), t);
    auto open = open_joints_.find(key);
    if (open == open_joints_.end() && is_over(phase)) return;
    if (open == open_joints_.end()) {
      open = open_joints_.emplace(key, told_.stories.size()).first;
      told_.stories.push_back({key.first, key.second, {}, "", ""});
    }
    JointStory& story = told_.stories[open->second];
    if (!story.segments.empty()) story.segments.back().span.to = t;
    if (is_over(phase)) {
      story.end = phase;
      story.why = line.why;
      open_joints_.erase(open);
      return;
    }
    JointSegment next{phase, line.role, line.blocks, {t, t}};
    if (!story.segments.empty()) {
      const JointSegment& last = story.segments.back();
      if (std::tie(last.phase, last.role, last.blocks) ==
          std::tie(next.phase, next.role, next.blocks)) {
        return;
      }
    }
    story.segments.push_back(std::move(next));
  }

  void see_scm(double t, const lines::Scm& line) {
    const std::tuple<std::string, std::string, std::string> key{line.uav, line.joint, line.scm};
    if (const auto open = open_violations_.find(key); open != open_violations_.end()) {
      told_.violations[open->second].span.to = t;
      open_violations_.erase(open);
    }
    if (line.state != "violated") return;
    open_violations_[key] = told_.violations.size();
    told_.violations.push_back(
        {line.uav,
         line.role,
         line.scm,
         "to " + line.place + " " + short_number(line.measured.value_or(0), 2) + ", required " +
             line.relation + " " + short_number(line.required.value_or(0), 2),
         {t, t}});
  }

  void see_place(double t, const lines::Place& line) {
    if (line.position.size() != 3) return;
    const Position position{line.position[0], line.position[1], line.position[2]};
    told_.places.push_back({t, line.uav, line.role, line.parameter, line.by, line.scms, position});
  }

  void see_negotiation(double t, const lines::Negotiation& line) {
    const SessionName key{line.joint, line.opener, line.opened};
    auto known = sessions_.find(key);
    if (known == sessions_.end()) {
      known = sessions_.emplace(key, told_.sessions.size()).first;
      told_.sessions.push_back({key, line.modality, {}, {}, {}});
    }
    SessionStory& session = told_.sessions[known->second];
    const bool shares = session.modality == "area-sharing" && line.state == "agreed";
    if (shares && shared_.insert(key).second) see_parts(t, line);
    const std::string uav = line.uav, rows = line.rows;
    add_member(session, uav);
    session.steps.push_back({t, uav, line.state, rows.empty() ? line.why : rows});
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
  // What a joint task no longer names is not watched any more: its block is over, or the role has
  // changed. When it is over nothing is.
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

  // "heron 150 60 900 -40 …, wren …": a name and corners each. All members tell the same.
  void see_parts(double t, const lines::Negotiation& line) {
    std::istringstream rows(line.rows);
    for (std::string row; std::getline(rows, row, ',');) {
      std::istringstream words(row);
      PartStory part;
      part.t = t;
      words >> part.uav;
      for (GroundPoint corner; words >> corner.x >> corner.y;) part.corners.push_back(corner);
      if (part.corners.size() >= 3) told_.parts.push_back(std::move(part));
    }
  }

  static void add_member(SessionStory& session, const std::string& uav) {
    auto& members = session.members;
    const auto place = std::lower_bound(members.begin(), members.end(), uav);
    if (place == members.end() || *place != uav) members.insert(place, uav);
  }

  // Of journals that do not say what a message is about: those on their way while it lasted.
  void add_messages(SessionStory& session) const {
    const std::vector<std::string> told_by = session.members;
    const double until = session.steps.back().t;
    const auto has_told = [&](const std::string& name) {
      return std::binary_search(told_by.begin(), told_by.end(), name);
    };
    for (const Flight& flight : story_.messages) {
      if (flight.what != "NegotiationMessage" || !flight.sent) continue;
      const bool meanwhile = *flight.sent >= session.name.opened && *flight.sent <= until &&
                             has_told(flight.from) && has_told(flight.to);
      if (flight.session ? *flight.session != session.name : !meanwhile) continue;
      add_member(session, flight.from);
      add_member(session, flight.to);
      session.messages.push_back(flight);
    }
  }

  const Chronology& story_;
  JointTasks& told_;
  std::map<std::pair<std::string, std::string>, std::size_t> open_joints_;
  std::map<std::tuple<std::string, std::string, std::string>, std::size_t> open_violations_;
  std::map<SessionName, std::size_t> sessions_;
  std::set<SessionName> shared_;
};

}  // namespace

JointTasks tell_joint_tasks(const Journal& journal, const Chronology& story) {
  JointTasks told;
  Teller teller(story, told);
  // What a joint task names as violated is told apart from what its constraints say: in the order
  // of the log.
  auto scm = journal.scms.begin();
  const auto see_scms = [&](const auto& before) {
    for (; scm != journal.scms.end() && before(scm->stamp); ++scm) {
      teller.see_scm(seconds(scm->stamp), scm->line);
    }
  };
  for (const auto& joint : journal.joints) {
    see_scms([&](const Stamp& other) {
      return std::tie(other.at, other.line) < std::tie(joint.stamp.at, joint.stamp.line);
    });
    teller.see_joint(seconds(joint.stamp), joint.line);
  }
  see_scms([](const Stamp&) { return true; });
  for (const auto& [stamp, line] : journal.places) teller.see_place(seconds(stamp), line);
  for (const auto& [stamp, line] : journal.negotiations) {
    teller.see_negotiation(seconds(stamp), line);
  }
  teller.finish();
  return told;
}

}  // namespace skein::report
