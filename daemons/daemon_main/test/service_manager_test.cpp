// SPDX-License-Identifier: Apache-2.0
#include "service_manager.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstdlib>
#include <cstring>

namespace skein::daemon_main {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using wire::ClockPhase;

/// The socket of a service manager, and the variables by which a service knows of it.
class Notified : public ::testing::Test {
 protected:
  Notified() : socket_(socket(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK, 0)) {
    const std::string name = "@skein-test-" + std::to_string(getpid());
    sockaddr_un address{};
    address.sun_family = AF_UNIX;
    std::memcpy(address.sun_path + 1, name.data() + 1, name.size() - 1);  // abstract: begins with 0
    const auto size = static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + name.size());
    EXPECT_EQ(bind(socket_, reinterpret_cast<const sockaddr*>(&address), size), 0);
    setenv("NOTIFY_SOCKET", name.c_str(), 1);
    unsetenv("WATCHDOG_USEC");
    unsetenv("WATCHDOG_PID");
  }
  ~Notified() override {
    unsetenv("NOTIFY_SOCKET");
    unsetenv("WATCHDOG_USEC");
    close(socket_);
  }
  std::vector<std::string> messages() const {
    std::vector<std::string> all;
    char text[512];
    for (ssize_t size = 0; (size = recv(socket_, text, sizeof text, 0)) > 0;)
      all.emplace_back(text, static_cast<std::size_t>(size));
    return all;
  }

 private:
  int socket_;
};

TEST_F(Notified, SaysThatItIsReadyAtItsFirstTurnAndWhatItDoesWhenThatChanges) {
  ServiceManager manager;
  EXPECT_THAT(messages(), IsEmpty());

  manager.turn(ClockPhase::kHolding, Duration::seconds(1));
  manager.turn(ClockPhase::kHolding, Duration::seconds(2));
  manager.turn(ClockPhase::kRunning, Duration::seconds(3));

  EXPECT_THAT(messages(), ElementsAre("READY=1\nSTATUS=waiting for the mission to start",
                                      "STATUS=mission running"));
}

TEST_F(Notified, GivesASignOfLifeTwiceInAWatchdogInterval) {
  setenv("WATCHDOG_USEC", "4000000", 1);
  ServiceManager manager;
  manager.turn(ClockPhase::kRunning, Duration::seconds(100));
  messages();

  int signs = 0;
  for (int tenths = 1; tenths <= 80; ++tenths) {
    manager.turn(ClockPhase::kRunning, Duration::seconds(100 + tenths / 10.0));
    for (const std::string& message : messages()) signs += message == "WATCHDOG=1";
  }

  EXPECT_EQ(signs, 4);  // in 8 s
}

TEST_F(Notified, AWatchdogOfAnotherProcessIsNotServed) {
  setenv("WATCHDOG_USEC", "1000", 1);
  setenv("WATCHDOG_PID", "1", 1);
  ServiceManager manager;
  manager.turn(ClockPhase::kRunning, Duration::seconds(1));
  manager.turn(ClockPhase::kRunning, Duration::seconds(2));

  EXPECT_THAT(messages(), ElementsAre("READY=1\nSTATUS=mission running"));
}

TEST_F(Notified, SaysThatItStops) {
  {
    ServiceManager manager;
    manager.turn(ClockPhase::kRunning, Duration::seconds(1));
    messages();
  }
  EXPECT_THAT(messages(), ElementsAre("STOPPING=1"));
}

// One that never took part, because of a wrong scenario for instance, has nothing to stop.
TEST_F(Notified, ADaemonThatNeverTurnedSaysNothing) {
  { const ServiceManager manager; }
  EXPECT_THAT(messages(), IsEmpty());
}

}  // namespace
}  // namespace skein::daemon_main
