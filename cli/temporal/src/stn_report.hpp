// SPDX-License-Identifier: Apache-2.0
// Results as text for people and as JSON.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "skein/temporal_files/network_text.hpp"
#include "stn_analysis.hpp"

namespace skein::temporal_tool {

/// Colours of a terminal, or nothing.
class Paint {
 public:
  explicit Paint(bool on) : on_(on) {}
  std::string good(const std::string& text) const { return painted("\033[1;32m", text); }
  std::string bad(const std::string& text) const { return painted("\033[1;31m", text); }
  std::string quiet(const std::string& text) const { return painted("\033[2m", text); }

 private:
  std::string painted(const char* code, const std::string& text) const;
  bool on_;
};

/// Rows with their columns lined up, two blanks between them; `indent` before each row.
std::string table_text(const std::vector<std::vector<std::string>>& rows,
                       const std::string& indent);

/// "STNU, 11 nodes, 9 requirements, 5 contingent links (json)".
std::string summary_text(const temporal::ReadNetwork& read);

/// One line for each part: link, bound, the interval it belongs to.
std::string conflict_text(const temporal::Stnu& network, const std::vector<ConflictPart>& conflict,
                          const Paint& paint);

/// One line for each link.
std::string links_text(const temporal::Stnu& network, const std::vector<temporal::LinkRef>& links);
std::string links_json(const temporal::Stnu& network, const std::vector<temporal::LinkRef>& links);

/// "[{"from": …, "bound": "min"}, …]".
std::string conflict_json(const temporal::Stnu& network, const std::vector<ConflictPart>& conflict);

/// "1.24 ms" of seconds.
std::string duration_text(double seconds);

/// The object that spec 5.5 gives; `controllable` absent: not asked, null. Without a line end.
struct Verdict {
  bool consistent = false;
  std::optional<bool> controllable;
  std::vector<ConflictPart> conflict;
  double seconds = 0;
};
std::string verdict_json(const temporal::Stnu& network, const Verdict& verdict);

std::string json_text(const std::string& text);
/// Seconds, or null for an infinite date.
std::string json_seconds(temporal::Ticks ticks);
/// Seconds, or ∞, for people.
std::string seconds_or_infinite(temporal::Ticks ticks);

}  // namespace skein::temporal_tool
