// SPDX-License-Identifier: Apache-2.0
#include "explain/role_tasks_told.hpp"

#include <map>

#include "explain/explain_words.hpp"
#include "story/chronology.hpp"

namespace skein::report {

namespace {

RoleTaskStory role_task_of(const Told<journal::lines::RoleTask>& told) {
  const journal::lines::RoleTask& line = told.line;
  RoleTaskStory story;
  story.uav = line.uav;
  story.task = line.task;
  story.type = line.type;
  story.of = line.of;
  story.joint = line.joint;
  story.role = line.role;
  story.componel = line.componel;
  story.block = line.block;
  story.because = line.because;
  story.asked = seconds(told.stamp);
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
  for (const auto& told : journal.role_tasks) {
    stories.push_back(role_task_of(told));
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
  write_line(out, "for", std::to_string(story.of) + " " + story.joint);
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
