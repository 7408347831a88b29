// SPDX-License-Identifier: Apache-2.0
#include "role_tasks_told.hpp"

#include <map>

#include "chronology.hpp"
#include "explain_words.hpp"
#include "line.hpp"

namespace skein::report {

namespace {

RoleTaskStory role_task_of(const Line& line) {
  RoleTaskStory story;
  story.uav = line.text("uav");
  story.task = static_cast<std::uint64_t>(line.whole("task").value_or(0));
  story.type = line.text("type");
  story.of = line.whole("of");
  story.joint = line.text("joint");
  story.role = line.text("role");
  story.componel = line.text("componel");
  story.block = line.text("block");
  story.because = line.text("because");
  story.asked = line.t;
  return story;
}

void follow(RoleTaskStory& story, const TaskRecord& record) {
  const double t = seconds(record.stamp);
  const bool goes_on = record.state == TaskState::kStarted || record.state == TaskState::kRunning;
  if (goes_on && !story.started) story.started = t;
  const bool ended = record.state == TaskState::kEnded;
  if (story.over || (!ended && record.state != TaskState::kAborted)) return;
  story.over = t;
  story.outcome = ended ? "ended" : "aborted";
  story.reason = record.reason;
}

}  // namespace

std::vector<RoleTaskStory> tell_role_tasks(const Journal& journal) {
  std::vector<RoleTaskStory> stories;
  std::map<std::pair<std::string, std::uint64_t>, std::size_t> index;
  for (const OtherRecord& record : journal.others) {
    if (record.kind != "role-task") continue;
    const auto line = line_of(record);
    if (!line) continue;
    stories.push_back(role_task_of(*line));
    index[{stories.back().uav, stories.back().task}] = stories.size() - 1;
  }
  for (const TaskRecord& record : journal.tasks) {
    const auto found = index.find({record.uav, record.task});
    if (found != index.end()) follow(stories[found->second], record);
  }
  return stories;
}

void write_role_task(std::ostream& out, const RoleTaskStory& story) {
  out << "  " << story.task << " " << story.type << "\n";
  write_line(out, "for", (story.of ? std::to_string(*story.of) + " " : "") + story.joint);
  write_line(out, "role", story.role + ": " + story.componel + " of block " + story.block);
  write_line(out, "asked",
             "when " + (story.because.empty() ? "block " + story.block + " began" : story.because) +
                 ", " + instant_text(story.asked));
  write_line(out, "start", actual_text(story.started) + " actually");
  write_line(out, "end",
             actual_text(story.over) + " actually" +
                 (story.outcome.empty() ? "" : " (" + story.outcome + ")"));
  write_line(out, "because", story.reason);
}

}  // namespace skein::report
