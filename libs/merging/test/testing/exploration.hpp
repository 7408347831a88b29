// SPDX-License-Identifier: Apache-2.0
// All that may happen to members and a witness within some steps.
#pragma once

#include <string>

#include "testing/trio.hpp"

namespace skein::merging::testing {

/// All that may happen from here within so many steps: any message that is under way is heard, or
/// time passes in which members ask again, or one that has air leaves it and wants other air; one
/// that has something kept for it loses contact with all, and wants that, or has it again.
/// Deliveries to different nodes one after the other are looked at in one order only.
class Exploration {
 public:
  explicit Exploration(double other) : other_(other) {}
  Exploration(double other, std::string loses, Volume kept)
      : other_(other), loses_(std::move(loses)), kept_(kept) {}

  /// True: somewhere two had the same.
  bool finds_two(const Trio& trio, int steps, std::size_t before = 0,
                 const std::string& last = "") {
    ++states_;
    if (trio.two_have_the_same()) return true;
    if (steps == 0) return false;
    const auto& packets = trio.under_way();
    for (std::size_t i = 0; i < packets.size(); ++i) {
      if (i < before && packets[i].to < last) continue;
      Trio next = trio;
      const std::string to = packets[i].to;
      const std::size_t known = packets.size() - 1;
      next.deliver(i);
      if (finds_two(next, steps - 1, known, to)) return true;
    }
    if (finds_two_where_one_leaves(trio, steps)) return true;
    if (!loses_.empty() && finds_two_where_contact_changes(trio, steps)) return true;
    Trio later = trio;
    later.pass(2.5);
    return finds_two(later, steps - 1);
  }
  long states() const { return states_; }
  /// Of these, in so many what was kept was had.
  long taken() const { return taken_; }

 private:
  bool finds_two_where_one_leaves(const Trio& trio, int steps) {
    for (const std::string& name : trio.names()) {
      if (trio.member(name).held().empty() || trio.granted(name) > 1) continue;
      Trio next = trio;
      next.give(name, Hold{{}});
      next.give(name, Want{{{street(other_, other_ + 10)}}});
      if (finds_two(next, steps - 1)) return true;
    }
    return false;
  }

  bool finds_two_where_contact_changes(const Trio& trio, int steps) {
    Trio next = trio;
    const bool alone = trio.is_alone_now(loses_);
    next.is_alone(loses_, !alone);
    if (!alone) next.give(loses_, Want{{{kept_}}});
    if (!next.member(loses_).held().empty()) ++taken_;
    return finds_two(next, steps - 1);
  }

  double other_;
  std::string loses_;
  Volume kept_;
  long states_ = 0, taken_ = 0;
};

}  // namespace skein::merging::testing
