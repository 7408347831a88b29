// SPDX-License-Identifier: Apache-2.0
#include "skein/laws/contact.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/journal/lines/radio.hpp"
#include "skein/journal/lines/truth.hpp"

namespace skein::laws {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

/// An event log of the UAVs a, b and c and the ground station.
class ContactLog {
 public:
  ContactLog() {
    for (const char* name : {"a", "b", "c"}) {
      scenario::UavSpec uav;
      uav.name = name;
      scenario_.uavs.push_back(uav);
    }
  }
  ContactLog& relay(const std::string& name) {
    scenario_.radio.relays.push_back(name);
    return *this;
  }
  ContactLog& capacity(double bits_per_second) {
    scenario_.radio.model.capacity = bits_per_second;
    return *this;
  }
  ContactLog& link(double at, const std::string& from, const std::string& to, bool up) {
    return add(at, "sim", journal::lines::Link{.from = from, .to = to, .up = up});
  }
  ContactLog& contact(double at, const std::string& node, const std::string& peer) {
    return add(at, node, journal::lines::Reach{.peer = peer, .reachable = true});
  }
  ContactLog& kill(double at, const std::string& node) {
    return add(at, "runner", journal::lines::Fault{.what = "kill", .target = node});
  }
  std::vector<std::string> breaches() const { return broken_contacts(scenario_, records_); }

 private:
  template <class Line>
  ContactLog& add(double at, const std::string& node, Line line) {
    records_.push_back(journal::record_of(MissionTime::seconds(at), node, std::move(line)));
    return *this;
  }
  scenario::Scenario scenario_;
  std::vector<journal::Record> records_;
};

TEST(Contacts, AreWhereTheRadioConnects) {
  EXPECT_THAT(ContactLog().link(0, "a", "b", true).contact(0, "b", "a").breaches(), IsEmpty());
  EXPECT_THAT(ContactLog().contact(0, "b", "a").breaches(), IsEmpty()) << "nobody tells the truth";
  EXPECT_THAT(ContactLog().link(0, "a", "b", false).contact(0, "b", "sim").breaches(), IsEmpty());
}

TEST(Contacts, WithOneThatWasNeverConnectedAreNone) {
  EXPECT_THAT(ContactLog().link(0, "a", "b", false).contact(0, "b", "a").breaches(),
              ElementsAre(HasSubstr("0 s: b is in contact with a")));
  EXPECT_THAT(
      ContactLog().link(0, "b", "a", true).link(0, "a", "b", false).contact(3, "b", "a").breaches(),
      ElementsAre(HasSubstr("b is in contact with a")))
      << "the other direction";
}

TEST(Contacts, MayBeginWithWhatWasUnderWay) {
  ContactLog log;
  log.link(0, "a", "b", true).link(9, "a", "b", false);

  EXPECT_THAT(ContactLog(log).contact(9.4, "b", "a").breaches(), IsEmpty());
  EXPECT_THAT(ContactLog(log).contact(9.6, "b", "a").breaches(), ElementsAre(HasSubstr("9.6 s")));
  EXPECT_THAT(ContactLog(log).link(20, "a", "b", true).contact(20, "b", "a").breaches(), IsEmpty());
}

// Found by random missions: a heartbeat waited at a relay of 9,600 bit/s until others had gone.
TEST(Contacts, MayBeginLaterWhereTheRadioIsNarrow) {
  ContactLog log;
  log.capacity(9'600).link(0, "a", "b", true).link(9, "a", "b", false);

  EXPECT_THAT(ContactLog(log).contact(10.9, "b", "a").breaches(), IsEmpty());
  EXPECT_THAT(ContactLog(log).contact(11.1, "b", "a").breaches(), ElementsAre(HasSubstr("11.1 s")));
}

TEST(Contacts, OfLinksThatAreToldAllAtOnceAreNoneWhereNoOtherLineSaysSo) {
  ContactLog log;
  log.link(0, "*", "*", false).link(0, "a", "b", true);

  EXPECT_THAT(ContactLog(log).contact(0, "b", "a").breaches(), IsEmpty());
  EXPECT_THAT(ContactLog(log).contact(1, "b", "c").breaches(), ElementsAre(HasSubstr("with c")));
  EXPECT_THAT(ContactLog(log).contact(1, "ground", "a").breaches(),
              ElementsAre(HasSubstr("with a")));
  EXPECT_THAT(ContactLog(log).link(5, "c", "b", true).contact(4, "b", "c").breaches(),
              ElementsAre(HasSubstr("with c")))
      << "it came up later";
}

TEST(Contacts, MayBePastRelays) {
  ContactLog log;
  log.link(0, "*", "*", false).link(0, "a", "c", true).link(0, "c", "b", true);
  log.contact(2, "b", "a");

  EXPECT_THAT(ContactLog(log).relay("c").breaches(), IsEmpty());
  EXPECT_THAT(log.breaches(), ElementsAre(HasSubstr("with a")));
}

TEST(Contacts, AreNotJudgedWhereTheSimulatorDied) {
  EXPECT_THAT(ContactLog().link(0, "a", "b", false).kill(1, "sim").contact(2, "b", "a").breaches(),
              IsEmpty());
}

}  // namespace
}  // namespace skein::laws
