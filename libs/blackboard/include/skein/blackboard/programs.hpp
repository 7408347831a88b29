// SPDX-License-Identifier: Apache-2.0
// The programs that take part in a domain, as they describe themselves.
#pragma once

#include <memory>
#include <optional>
#include <string>

namespace skein::blackboard {

/// A participant is known by its GUID and by the name of its node. That of a program is known
/// before anything that it writes arrives. What it says of itself first counts: it does not change.
/// Thread rule: any thread.
class Programs {
 public:
  Programs();
  ~Programs();

  /// The participant was discovered. `proved`: with keys, false until it is authenticated, and not
  /// counted so long.
  void found(const std::string& guid, std::string name, std::string description,
             bool proved = true);
  /// It was authenticated. No effect on one that was not found.
  void proved(const std::string& guid);
  void gone(const std::string& guid);

  /// The description of the node's program; of several participants with its name (one that died is
  /// known until its lease ends) that of the one discovered last. Nothing: there is none.
  std::optional<std::string> description_of(const std::string& name) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard
