// SPDX-License-Identifier: Apache-2.0
// A name that only one holder on this machine has at a time.
#pragma once

#include <optional>
#include <string>

namespace skein::blackboard::rtps {

/// Holds the name until destroyed, or until the process ends however it ends; leaves no file. It is
/// the name of an abstract Unix socket, so each network namespace has its own.
class NamedLock {
 public:
  /// Nothing if somebody holds it. At most 100 characters.
  static std::optional<NamedLock> take(const std::string& name);

  NamedLock(NamedLock&& other) noexcept;
  NamedLock& operator=(NamedLock&& other) noexcept;
  ~NamedLock();

 private:
  explicit NamedLock(int socket) : socket_(socket) {}
  int socket_;
};

}  // namespace skein::blackboard::rtps
