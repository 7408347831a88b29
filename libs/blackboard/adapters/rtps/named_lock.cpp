// SPDX-License-Identifier: Apache-2.0
// A name that only one holder on this machine has at a time.
#include "named_lock.hpp"

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstddef>
#include <cstring>
#include <utility>

#include "skein/foundation/contract.hpp"

namespace skein::blackboard::rtps {

std::optional<NamedLock> NamedLock::take(const std::string& name) {
  sockaddr_un address{};
  SKEIN_EXPECTS(name.size() + 1 < sizeof(address.sun_path));
  const int descriptor = socket(AF_UNIX, SOCK_DGRAM | SOCK_CLOEXEC, 0);
  if (descriptor < 0) return std::nullopt;
  NamedLock lock(descriptor);
  address.sun_family = AF_UNIX;
  std::memcpy(address.sun_path + 1, name.data(), name.size());
  const auto length = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size());
  if (bind(descriptor, reinterpret_cast<const sockaddr*>(&address), length) != 0) {
    return std::nullopt;
  }
  return lock;
}

NamedLock::NamedLock(NamedLock&& other) noexcept : socket_(std::exchange(other.socket_, -1)) {}

NamedLock& NamedLock::operator=(NamedLock&& other) noexcept {
  std::swap(socket_, other.socket_);
  return *this;
}

NamedLock::~NamedLock() {
  if (socket_ >= 0) close(socket_);
}

}  // namespace skein::blackboard::rtps
