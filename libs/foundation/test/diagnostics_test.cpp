// SPDX-License-Identifier: Apache-2.0
#include "skein/foundation/diagnostics.hpp"

#include <gtest/gtest.h>

namespace skein {
namespace {

TEST(Diagnostics, TextSaysWhereWhatAndWhatWasMeant) {
  const Diagnostic d{"a.yaml", 3, 7, "uavs.marvn", "unknown UAV 'marvn'", "a UAV of this scenario",
                     "marvin"};

  EXPECT_EQ(to_text(d),
            "a.yaml:3:7: uavs.marvn: unknown UAV 'marvn'; expected a UAV of this scenario; "
            "did you mean 'marvin'?");
}

TEST(Diagnostics, AbsentPartsAreLeftOut) {
  EXPECT_EQ(to_text(Diagnostic{"", 0, 0, "", "empty file", "", ""}), "empty file");
  EXPECT_EQ(to_text(Diagnostic{"", 4, 0, "", "bad", "", ""}), "line 4: bad");
}

TEST(Diagnostics, AllErrorsAreKeptInTheOrderFound) {
  Diagnostics first, second;
  first.add({"a", 1, 0, "", "one", "", ""});
  second.add({"b", 2, 0, "", "two", "", ""});

  first.append(second);

  EXPECT_EQ(to_text(first), "a:1: one\nb:2: two\n");
  EXPECT_EQ(first.size(), 2U);
}

TEST(DiagnosticText, HasNoControlCharactersOfTheInput) {
  Diagnostic one;
  one.file = "a\rb.yaml";
  one.message =
      "\x1b]0;mine\x07 \xC2\x9B"
      "31m and \x7F; é, 丁 and\ttab stay";

  EXPECT_EQ(to_text(one),
            "a\uFFFDb.yaml: \uFFFD]0;mine\uFFFD \uFFFD31m and \uFFFD; é, 丁 and\ttab stay");
}

}  // namespace
}  // namespace skein
