// SPDX-License-Identifier: Apache-2.0
#include "skein/mavlink_node/link.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>

namespace skein::mavlink_node {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

using Bytes = std::vector<std::uint8_t>;

/// A UDP socket of the test's own.
class Socket {
 public:
  Socket() {
    sockaddr_in any{};
    any.sin_family = AF_INET;
    any.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(bind(descriptor_, reinterpret_cast<sockaddr*>(&any), sizeof any), 0);
    socklen_t size = sizeof address_;
    getsockname(descriptor_, reinterpret_cast<sockaddr*>(&address_), &size);
  }
  Socket(const Socket&) = delete;
  Socket& operator=(const Socket&) = delete;
  ~Socket() { close(descriptor_); }

  int port() const { return ntohs(address_.sin_port); }
  void send(const Bytes& bytes, int port) {
    sockaddr_in to = address_;
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    sendto(descriptor_, bytes.data(), bytes.size(), 0, reinterpret_cast<sockaddr*>(&to), sizeof to);
  }
  Bytes receive() {
    Bytes bytes(100);
    const auto count = recv(descriptor_, bytes.data(), bytes.size(), 0);
    bytes.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return bytes;
  }

 private:
  int descriptor_ = socket(AF_INET, SOCK_DGRAM, 0);
  sockaddr_in address_{};
};

Bytes wait_for(Link& link) {
  pollfd file{link.descriptor(), POLLIN, 0};
  poll(&file, 1, 5000);
  return link.receive();
}

std::string why_not(const std::string& address) {
  const auto link = Link::open(address);
  return link ? "" : link.error().why;
}

TEST(Link, SpeaksToTheVehicleThatItIsTold) {
  Socket vehicle;
  auto link = Link::open("udp:127.0.0.1:" + std::to_string(vehicle.port()));
  ASSERT_TRUE(link.has_value()) << link.error().why;
  EXPECT_THAT((*link)->receive(), IsEmpty()) << "it does not block";

  (*link)->send(Bytes{1, 2, 3});
  EXPECT_THAT(vehicle.receive(), ElementsAre(1, 2, 3));
}

TEST(Link, WaitsForAVehicleAndAnswersIt) {
  int port = 0;
  { port = Socket().port(); }
  auto link = Link::open("udpin:" + std::to_string(port));
  ASSERT_TRUE(link.has_value()) << link.error().why;
  (*link)->send(Bytes{9});  // to nobody yet
  Socket vehicle;
  vehicle.send({4, 5}, port);

  EXPECT_THAT(wait_for(**link), ElementsAre(4, 5));
  (*link)->send(Bytes{6});
  EXPECT_THAT(vehicle.receive(), ElementsAre(6));
}

TEST(Link, ReadsAndWritesASerialLine) {
  const int line = posix_openpt(O_RDWR | O_NOCTTY);
  ASSERT_GE(line, 0);
  grantpt(line);
  unlockpt(line);
  std::array<char, 100> name{};
  ASSERT_EQ(ptsname_r(line, name.data(), name.size()), 0);
  auto link = Link::open(std::string("serial:") + name.data() + ":115200");
  ASSERT_TRUE(link.has_value()) << link.error().why;

  // Bytes that a terminal would take for line ends and interrupts come as they are.
  const Bytes raw{0x03, 0x0d, 0x0a, 0xfd, 0x00};
  ASSERT_EQ(write(line, raw.data(), raw.size()), 5);
  EXPECT_EQ(wait_for(**link), raw);
  (*link)->send(raw);
  Bytes back(5);
  ASSERT_EQ(read(line, back.data(), back.size()), 5);
  EXPECT_EQ(back, raw);
  close(line);
}

TEST(Link, SaysWhatIsWrongWithAnAddress) {
  EXPECT_THAT(why_not(""), HasSubstr("expected udpin:…, udp:… or serial:…"));
  EXPECT_THAT(why_not("tcp:1.2.3.4:5"), HasSubstr("expected udpin:…"));
  EXPECT_THAT(why_not("udp:14550"), HasSubstr("expected udp:ADDRESS:PORT"));
  EXPECT_THAT(why_not("udp:autopilot:14550"), HasSubstr("IPv4"));
  EXPECT_THAT(why_not("udpin:99999"), HasSubstr("expected udpin:PORT"));
  EXPECT_THAT(why_not("serial:/dev/null:115200"), HasSubstr("/dev/null"));
  EXPECT_THAT(why_not("serial:/dev/ttyUSB0:12"), HasSubstr("baud"));
  EXPECT_THAT(why_not("serial:/no/such/device"), HasSubstr("No such file"));
}

TEST(Link, APortThatIsTakenIsSaid) {
  Socket taken;
  EXPECT_THAT(why_not("udpin:" + std::to_string(taken.port())), HasSubstr("in use"));
}

}  // namespace
}  // namespace skein::mavlink_node
