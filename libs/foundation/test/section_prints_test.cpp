// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/section_prints.hpp"

#include <gtest/gtest.h>

#include "skein/foundation/fingerprint.hpp"

namespace skein {
namespace {

SectionPrints prints(const std::string& zones, const std::string& places) {
  SectionPrints prints;
  prints.add("zones", Fingerprint().put(zones).value());
  prints.add("places", Fingerprint().put(places).value());
  return prints;
}

using Sections = std::vector<std::string>;

TEST(SectionPrints, NameTheSectionsThatDiffer) {
  const SectionPrints own = prints("a", "b");
  EXPECT_EQ(own.differing(prints("a", "b").text()), Sections{});
  EXPECT_EQ(own.differing(prints("x", "b").text()), Sections{"zones"});
  EXPECT_EQ(own.differing(prints("a", "x").text()), Sections{"places"});
  EXPECT_EQ(own.differing(prints("x", "y").text()), (Sections{"zones", "places"}));
}

TEST(SectionPrints, AreWrittenInThatForm) {
  SectionPrints some;
  some.add("zones", 0x0000000100000002ULL);
  some.add("places", 0xffffffffULL);
  EXPECT_EQ(some.text(), "100000003ffffffff");
}

TEST(SectionPrints, AreReadBackFromTheirText) {
  const SectionPrints own = prints("a", "b");
  EXPECT_EQ(SectionPrints::read({"zones", "places"}, own.text()), own);
}

TEST(SectionPrints, CannotBeComparedWithOtherForms) {
  const SectionPrints own = prints("a", "b");
  const std::string text = own.text();
  for (const std::string& other :
       {std::string(), text + "0", text.substr(0, 9), "2" + text.substr(1), text + "01234567",
        text.substr(0, 10) + "x" + text.substr(11)})
    EXPECT_EQ(own.differing(other), std::nullopt) << other;
}

}  // namespace
}  // namespace skein
