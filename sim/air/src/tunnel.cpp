// SPDX-License-Identifier: Apache-2.0
#include "tunnel.hpp"

#include <fcntl.h>
#include <linux/if_tun.h>
#include <net/if.h>
#include <sched.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace skein::air {
namespace {

constexpr std::size_t kLargest = 65'536;

/// An open file, closed with it.
class File {
 public:
  explicit File(const std::string& path, int flags)
      : number_(::open(path.c_str(), flags | O_CLOEXEC)) {}
  File(const File&) = delete;
  File& operator=(const File&) = delete;
  ~File() {
    if (number_ >= 0) close(number_);
  }
  int number() const { return number_; }
  int release() { return std::exchange(number_, -1); }

 private:
  int number_;
};

tl::unexpected<Failure> refused(const std::string& what) {
  return failure(what + ": " + std::strerror(errno));
}

}  // namespace

Result<Tunnel, Failure> Tunnel::open(const std::string& space, const std::string& name) {
  const File own("/proc/self/ns/net", O_RDONLY), there(space, O_RDONLY);
  if (there.number() < 0) return refused(space);
  if (setns(there.number(), CLONE_NEWNET) != 0) return refused(space + " cannot be entered");
  File device("/dev/net/tun", O_RDWR | O_NONBLOCK);
  ifreq request{};
  request.ifr_flags = IFF_TUN | IFF_NO_PI;
  std::strncpy(request.ifr_name, name.c_str(), IFNAMSIZ - 1);
  const bool good = device.number() >= 0 && ioctl(device.number(), TUNSETIFF, &request) == 0;
  const int why = errno;
  if (setns(own.number(), CLONE_NEWNET) != 0) return refused("no way back from " + space);
  errno = why;
  if (!good) return refused("no TUN device in " + space);
  return Tunnel(device.release());
}

Tunnel::Tunnel(Tunnel&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

Tunnel& Tunnel::operator=(Tunnel&& other) noexcept {
  std::swap(descriptor_, other.descriptor_);
  return *this;
}

Tunnel::~Tunnel() {
  if (descriptor_ >= 0) close(descriptor_);
}

std::vector<std::uint8_t> Tunnel::read() {
  std::vector<std::uint8_t> packet(kLargest);
  const ssize_t length = ::read(descriptor_, packet.data(), packet.size());
  packet.resize(length > 0 ? static_cast<std::size_t>(length) : 0);
  return packet;
}

bool Tunnel::write(std::span<const std::uint8_t> packet) {
  return ::write(descriptor_, packet.data(), packet.size()) == static_cast<ssize_t>(packet.size());
}

}  // namespace skein::air
