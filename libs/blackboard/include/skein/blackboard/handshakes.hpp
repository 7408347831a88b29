// SPDX-License-Identifier: Apache-2.0
// The authentication handshakes with participants of a secured DDS domain.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "skein/foundation/time.hpp"

namespace skein::blackboard {

/// The participants that were discovered and are not authenticated yet. A participant is known by
/// its GUID and by the name that it gives itself, which is unproved until the handshake has ended.
/// Thread rule: any thread.
class Handshakes {
 public:
  Handshakes();
  ~Handshakes();

  /// The participant was discovered at this steady time. No effect if its handshake has ended.
  void begun(const std::string& guid, const std::string& name, Duration steady);
  void ended(const std::string& guid);
  void gone(const std::string& guid);

  struct Open {
    std::string name;
    Duration lasts;
  };
  /// The handshakes that have not ended, the oldest first.
  std::vector<Open> open(Duration steady) const;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace skein::blackboard
