// SPDX-License-Identifier: Apache-2.0
#include "skein/mavlink_node/link.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <map>
#include <optional>

namespace skein::mavlink_node {

namespace {

constexpr std::size_t kMost = 65'536;
constexpr int kUsualBaud = 57'600;

class UdpLink final : public Link {
 public:
  UdpLink(int descriptor, std::optional<sockaddr_in> peer, bool follows)
      : Link(descriptor), peer_(peer), follows_(follows) {}

  std::vector<std::uint8_t> receive() override {
    std::vector<std::uint8_t> all;
    std::array<std::uint8_t, 2048> datagram;
    while (all.size() + datagram.size() <= kMost) {
      sockaddr_in from{};
      socklen_t size = sizeof from;
      const auto count = recvfrom(descriptor(), datagram.data(), datagram.size(), MSG_DONTWAIT,
                                  reinterpret_cast<sockaddr*>(&from), &size);
      if (count < 0) break;
      if (follows_) peer_ = from;
      all.insert(all.end(), datagram.begin(), datagram.begin() + count);
    }
    return all;
  }

  void send(std::span<const std::uint8_t> bytes) override {
    if (!peer_) return;
    (void)sendto(descriptor(), bytes.data(), bytes.size(), MSG_DONTWAIT | MSG_NOSIGNAL,
                 reinterpret_cast<const sockaddr*>(&*peer_), sizeof *peer_);
  }

 private:
  std::optional<sockaddr_in> peer_;
  bool follows_;
};

class SerialLink final : public Link {
 public:
  explicit SerialLink(int descriptor) : Link(descriptor) {}

  std::vector<std::uint8_t> receive() override {
    std::vector<std::uint8_t> bytes(4096);
    const auto count = read(descriptor(), bytes.data(), bytes.size());
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }
  void send(std::span<const std::uint8_t> bytes) override {
    // What the line does not take at once is lost: a receiver looks on behind half a frame.
    if (write(descriptor(), bytes.data(), bytes.size()) < 0) return;
  }
};

using Opened = Result<std::unique_ptr<Link>, Failure>;

std::string why() { return std::strerror(errno); }

/// "ADDRESS:PORT" or "PORT".
std::optional<sockaddr_in> read_endpoint(std::string_view text, const char* usual) {
  const std::size_t colon = text.rfind(':');
  const bool only_port = colon == std::string_view::npos;
  const std::string address(only_port ? usual : text.substr(0, colon));
  const std::string_view port = only_port ? text : text.substr(colon + 1);
  std::uint16_t number = 0;
  const auto [end, error] = std::from_chars(port.begin(), port.end(), number);
  sockaddr_in endpoint{};
  endpoint.sin_family = AF_INET;
  endpoint.sin_port = htons(number);
  const bool sound = error == std::errc() && end == port.end() && !port.empty() &&
                     inet_pton(AF_INET, address.c_str(), &endpoint.sin_addr) == 1;
  return sound ? std::optional(endpoint) : std::nullopt;
}

Opened open_udp(const std::string& address, std::string_view rest, bool listens) {
  const auto endpoint = read_endpoint(rest, "127.0.0.1");
  const bool named = listens || rest.find(':') != std::string_view::npos;
  if (!endpoint || !named || (!listens && endpoint->sin_port == 0))
    return failure("'" + address + "': expected " +
                   (listens ? "udpin:PORT or udpin:ADDRESS:PORT" : "udp:ADDRESS:PORT") +
                   ", with an IPv4 address");
  const int descriptor = socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
  if (descriptor < 0) return failure("'" + address + "': " + why());
  auto link = std::make_unique<UdpLink>(descriptor,
                                        listens ? std::nullopt : std::optional(*endpoint), listens);
  if (listens &&
      bind(descriptor, reinterpret_cast<const sockaddr*>(&*endpoint), sizeof *endpoint) != 0)
    return failure("'" + address + "': " + why());
  return link;
}

std::optional<speed_t> speed_of(int baud) {
  static const std::map<int, speed_t> speeds = {
      {9600, B9600},     {38400, B38400},   {57600, B57600},   {115200, B115200},
      {230400, B230400}, {460800, B460800}, {921600, B921600}, {1500000, B1500000}};
  const auto found = speeds.find(baud);
  return found == speeds.end() ? std::nullopt : std::optional(found->second);
}

Opened open_serial(const std::string& address, std::string_view rest) {
  const std::size_t colon = rest.rfind(':');
  const std::string device(rest.substr(0, colon));
  int baud = kUsualBaud;
  if (colon != std::string_view::npos) {
    const std::string_view figure = rest.substr(colon + 1);
    const auto [end, error] = std::from_chars(figure.begin(), figure.end(), baud);
    if (error != std::errc() || end != figure.end()) baud = 0;
  }
  const auto speed = speed_of(baud);
  if (device.empty() || !speed)
    return failure("'" + address +
                   "': expected serial:DEVICE or serial:DEVICE:BAUD, with 9600, 38400, 57600, "
                   "115200, 230400, 460800, 921600 or 1500000 baud");
  const int descriptor = ::open(device.c_str(), O_RDWR | O_NOCTTY | O_NONBLOCK | O_CLOEXEC);
  if (descriptor < 0) return failure("'" + device + "': " + why());
  auto link = std::make_unique<SerialLink>(descriptor);
  termios line{};
  if (tcgetattr(descriptor, &line) != 0) return failure("'" + device + "': " + why());
  cfmakeraw(&line);
  line.c_cflag |= CLOCAL | CREAD;
  if (cfsetspeed(&line, *speed) != 0 || tcsetattr(descriptor, TCSANOW, &line) != 0)
    return failure("'" + device + "': " + why());
  return link;
}

}  // namespace

Link::~Link() { close(descriptor_); }

Result<std::unique_ptr<Link>, Failure> Link::open(const std::string& address) {
  const std::size_t colon = address.find(':');
  const std::string kind = address.substr(0, colon);
  const std::string_view rest =
      colon == std::string::npos ? std::string_view() : std::string_view(address).substr(colon + 1);
  if (kind == "udp") return open_udp(address, rest, false);
  if (kind == "udpin") return open_udp(address, rest, true);
  if (kind == "serial") return open_serial(address, rest);
  return failure("'" + address + "': expected udpin:…, udp:… or serial:…");
}

}  // namespace skein::mavlink_node
