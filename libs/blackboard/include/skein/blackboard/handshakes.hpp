// SPDX-License-Identifier: Apache-2.0
// Which participants of a secured domain have been found and have not yet proved who they are.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"

namespace skein::blackboard {

/// A participant is known by its identity (GUID) and by the name that it gives itself, which until
/// the handshake has ended is proved by nothing. Thread rule: any thread.
class Handshakes {
 public:
  Handshakes();
  ~Handshakes();

  /// Found, at this steady time. What has ended before counts as ended.
  void begun(const std::string& guid, const std::string& name, Duration steady);
  void ended(const std::string& guid);
  void gone(const std::string& guid);

  struct Open {
    std::string name;
    Duration lasts;
  };
  /// Those that have not ended, the one that lasts longest first.
  std::vector<Open> open(Duration steady) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard
