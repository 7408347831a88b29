// SPDX-License-Identifier: Apache-2.0
#include "progress.hpp"

#include <ostream>
#include <utility>

namespace skein::run_tool {

namespace {

constexpr const char* kBold = "\033[1m";
constexpr const char* kDim = "\033[2m";
constexpr const char* kPlain = "\033[0m";
constexpr const char* kClearLine = "\r\033[K";

}  // namespace

Progress::Progress(std::ostream& out, Style style, std::vector<std::string> uavs)
    : out_(out), style_(style), uavs_(std::move(uavs)) {}

/// Once for each reason: the task is called again every minute.
void Progress::see_owner(const journal::Record& record) {
  const auto task = static_cast<std::int64_t>(record.number("task"));
  if (record.text("stage") == "owned" || record.text("stage") == "granted") unsold_.erase(task);
  if (record.text("stage") != "unsold") return;
  const std::string why(record.text("why"));
  if (why.empty() || std::exchange(unsold_[task], why) == why) return;
  say(to_clock_text(record.at()) + "  task " + std::to_string(task) + " (" +
      std::string(record.text("statement")) + ") has no owner: " + why);
}

void Progress::see(const journal::Record& record) {
  if (record.kind() == "phase") {
    phase_ = record.text("name");
    changed_ = true;
  }
  if (record.kind() == "global-mission" && record.text("state") == "refused") {
    say(to_clock_text(record.at()) + "  global mission " +
        std::to_string(static_cast<std::int64_t>(record.number("mission"))) +
        " is refused: " + std::string(record.text("why")));
  }
  if (record.kind() == "owner") see_owner(record);
  if (record.kind() != "task") return;
  const std::string uav(record.text("uav"));
  const auto id = static_cast<std::int64_t>(record.number("task"));
  const std::string_view state = record.text("state");
  auto& running = current_[uav].running;
  if (state == "started" || state == "running" || state == "aborting") {
    running[id] = record.text("type");
  } else {
    running.erase(id);
  }
  changed_ = true;
}

void Progress::show(MissionTime now) {
  if (style_ == Style::kNone || (style_ == Style::kLines && !changed_)) return;
  changed_ = false;
  const std::string text = line(now);
  if (style_ == Style::kTerminal) {
    out_ << kClearLine << text << std::flush;
  } else if (text != shown_) {
    out_ << text << '\n' << std::flush;
  }
  shown_ = text;
}

void Progress::say(const std::string& text) {
  if (style_ == Style::kNone) return;
  out_ << (style_ == Style::kTerminal ? kClearLine : "") << text << '\n' << std::flush;
}

void Progress::finish() {
  if (style_ == Style::kTerminal) out_ << kClearLine << std::flush;
}

std::string Progress::line(MissionTime now) const {
  const bool colours = style_ == Style::kTerminal;
  const auto styled = [&](const char* style, const std::string& text) {
    return colours ? style + text + kPlain : text;
  };
  std::string text = styled(kBold, to_clock_text(now)) + "  " + (phase_.empty() ? "-" : phase_);
  for (const std::string& uav : uavs_) {
    text += "  | " + styled(kBold, uav) + " ";
    const auto found = current_.find(uav);
    if (found == current_.end() || found->second.running.empty()) {
      text += styled(kDim, "idle");
      continue;
    }
    bool first = true;
    for (const auto& [id, type] : found->second.running) {
      text += (first ? "" : " + ") + type + " " + std::to_string(id);
      first = false;
    }
  }
  return text;
}

}  // namespace skein::run_tool
