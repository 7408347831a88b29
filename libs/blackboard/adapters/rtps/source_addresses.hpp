// SPDX-License-Identifier: Apache-2.0
// From which of its addresses this machine speaks to another.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace skein::blackboard::rtps {

/// IPv4, the first octet highest.
using Address = std::uint32_t;
std::string to_text(Address address);
/// Of four numbers with points between them.
std::optional<Address> parse_ipv4(const std::string& text);

/// A machine with several addresses that says a thing to another machine from each of them says it
/// several times over the same way. The one to say it from is that which the system's routes
/// choose. What they say is asked anew after kAskedAgain, since routes change. Cost: a look-up, and
/// some system calls when it is asked. Thread rule: one thread at a time.
class SourceAddresses {
 public:
  using Clock = std::chrono::steady_clock;
  /// The source that the system would choose for a destination; none: there is no way to it.
  using Ask = std::function<std::optional<Address>(Address destination)>;
  static constexpr std::chrono::seconds kAskedAgain{2};

  /// `own`: those to choose among.
  explicit SourceAddresses(std::vector<Address> own, Ask ask);
  /// Asks the system.
  explicit SourceAddresses(std::vector<Address> own);

  /// Whether what goes to `destination` is to be said from `source`. Where the system would choose
  /// none of the own ones, from each.
  bool is_for(Address source, Address destination, Clock::time_point now);

 private:
  struct Answer {
    std::optional<Address> source;  ///< none: each
    Clock::time_point asked;
  };
  std::optional<Address> source_for(Address destination) const;

  std::vector<Address> own_;
  Ask ask_;
  std::map<Address, Answer> answers_;
};

}  // namespace skein::blackboard::rtps
