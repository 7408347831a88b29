// SPDX-License-Identifier: Apache-2.0
#include "skein/journal/log_line.hpp"

#include <functional>
#include <map>

#include "skein/foundation/shortest_text.hpp"

namespace skein::journal {

namespace {

std::string text(const Record& record, std::string_view key) {
  return std::string(record.text(key));
}

/// With all its digits: a great id is text in the record.
std::string number(const Record& record, std::string_view key) {
  const Value* value = record.find(key);
  if (value == nullptr) return "0";
  if (const auto* whole = std::get_if<std::int64_t>(value)) return std::to_string(*whole);
  if (const auto* broken = std::get_if<double>(value)) return shortest_text(*broken);
  const auto* great = std::get_if<std::string>(value);
  return great == nullptr ? "0" : *great;
}

/// ": why", if it says why.
std::string why(const Record& record, std::string_view key = "why") {
  const std::string said = text(record, key);
  return said.empty() ? "" : ": " + said;
}

using Line = std::optional<LogLine>;

Line decision(const Record& r) {
  return LogLine{Level::kInfo, "decides " + text(r, "operator") + " because of " +
                                   text(r, "cause") + ": " + text(r, "outcome")};
}

Line request(const Record& r) {
  if (r.truth("accepted")) return std::nullopt;
  return LogLine{Level::kWarning, "refuses " + text(r, "request") + why(r)};
}

Line command(const Record& r) {
  if (r.text("state") != "refused" && r.text("state") != "expired") return std::nullopt;
  return LogLine{Level::kWarning, "command to " + text(r, "uav") + " " + text(r, "state") + ": " +
                                      text(r, "what") + why(r)};
}

Line answer(const Record& r) {
  if (r.truth("planned") || r.truth("evaluated")) return std::nullopt;
  return LogLine{Level::kWarning, "cannot plan mission " + number(r, "mission") + why(r)};
}

Line goal(const Record& r) {
  const Level level = r.text("state") == "failed" ? Level::kWarning : Level::kInfo;
  return LogLine{level, "goal " + number(r, "goal") + " " + text(r, "statement") + " is " +
                            text(r, "state") + why(r)};
}

Line task(const Record& r) {
  if (r.text("state") != "aborted") return std::nullopt;
  return LogLine{Level::kWarning, "task " + number(r, "task") + " " + text(r, "type") + " aborted" +
                                      why(r, "reason")};
}

Line alarm(const Record& r) {
  return LogLine{Level::kWarning, "alarm " + number(r, "alarm") + " " + text(r, "state")};
}

Line expectation(const Record& r) {
  return LogLine{r.truth("passed") ? Level::kInfo : Level::kError,
                 text(r, "name") + ": " + (r.truth("passed") ? "met" : "not met: ") +
                     (r.truth("passed") ? "" : text(r, "seen"))};
}

Line process(const Record& r) {
  if (r.text("state") != "crashed") return std::nullopt;
  return LogLine{Level::kError, text(r, "name") + " crashed" + why(r)};
}

const std::map<std::string, Line (*)(const Record&), std::less<>>& tellers() {
  static const std::map<std::string, Line (*)(const Record&), std::less<>> all = {
      {"decision", decision},
      {"request", request},
      {"command", command},
      {"answer", answer},
      {"goal", goal},
      {"task", task},
      {"alarm", alarm},
      {"expectation", expectation},
      {"process", process},
      {"degree",
       [](const Record& r) -> Line {
         return LogLine{Level::kInfo, text(r, "uav") + " is at degree " + number(r, "degree")};
       }},
      {"phase",
       [](const Record& r) -> Line {
         return LogLine{Level::kInfo, "phase " + text(r, "name")};
       }},
      {"mission",
       [](const Record& r) -> Line {
         return LogLine{Level::kInfo, "mission " + text(r, "state")};
       }},
      {"operator",
       [](const Record& r) -> Line {
         return LogLine{Level::kInfo, "operator: " + text(r, "does")};
       }},
      {"fault",
       [](const Record& r) -> Line {
         return LogLine{Level::kError, "fault: " + text(r, "what") + " of " + text(r, "target")};
       }},
      {"notice",
       [](const Record& r) -> Line {
         return LogLine{Level::kInfo, text(r, "text")};
       }},
      {"contact",
       [](const Record& r) -> Line {
         return LogLine{Level::kWarning, "contact lost: " + text(r, "policy") + why(r)};
       }},
      {"owner", [](const Record& r) -> Line {
         const std::string owners = text(r, "owners");
         return LogLine{Level::kInfo, "team task " + number(r, "task") + " " + text(r, "stage") +
                                          (owners.empty() ? "" : " by ") + owners + why(r)};
       }}};
  return all;
}

}  // namespace

std::optional<LogLine> log_line_of(const Record& record) {
  const auto teller = tellers().find(record.kind());
  return teller == tellers().end() ? std::nullopt : teller->second(record);
}

}  // namespace skein::journal
