// SPDX-License-Identifier: Apache-2.0
// Writes a network with uncertainty in one expression.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>

#include "skein/temporal/network.hpp"

namespace skein::temporal::testing {

class StnuBuilder {
 public:
  /// Names separated by blanks; the first is the origin.
  explicit StnuBuilder(const std::string& names) {
    std::istringstream in(names);
    for (std::string name; in >> name;) out_.nodes.push_back(name);
  }

  StnuBuilder& arc(const std::string& from, const std::string& to, Ticks min, Ticks max) {
    out_.arcs.push_back({node(from), node(to), min, max});
    return *this;
  }
  StnuBuilder& contingent(const std::string& from, const std::string& to, Ticks min, Ticks max) {
    out_.contingent.push_back({node(from), node(to), min, max});
    return *this;
  }
  Stnu build() const { return out_; }

  NodeIndex node(const std::string& name) const {
    return static_cast<NodeIndex>(std::find(out_.nodes.begin(), out_.nodes.end(), name) -
                                  out_.nodes.begin());
  }

 private:
  Stnu out_;
};

}  // namespace skein::temporal::testing
