// SPDX-License-Identifier: Apache-2.0
// A type with all that it is made of, and nothing else.
#include "idl_text.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "skein/blackboard/wire.hpp"

namespace skein::spy_tool {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kSmall = R"(
// struct Comment { };
module m {
enum Kind {
  A, B
};
@final
struct Leaf { double x; };
@final
struct Other { long y; };
@final
struct Top {
  Leaf leaf;  // not Other
  Kind kind;
};
};
)";

TEST(IdlOf, HasWhatATypeIsMadeOfBeforeIt) {
  const std::string text = idl_of("Top", kSmall);

  EXPECT_LT(text.find("struct Leaf"), text.find("struct Top"));
  EXPECT_LT(text.find("enum Kind"), text.find("struct Top"));
  EXPECT_THAT(text, Not(HasSubstr("Other")));
  EXPECT_THAT(text, HasSubstr("module skein {"));
}

TEST(IdlOf, AnUnknownTypeIsNothing) {
  EXPECT_EQ(idl_of("Comment", kSmall), "");
  EXPECT_EQ(idl_of("", kSmall), "");
  EXPECT_EQ(idl_of("Top", ""), "");
}

TEST(IdlOf, EverySlotHasAText) {
  for (std::size_t i = 0; i < wire::kSlotCount; ++i) {
    const std::string slot(wire::slot_name(static_cast<wire::Slot>(i)));
    const std::string text = idl_of(slot);
    EXPECT_THAT(text, HasSubstr("struct " + slot)) << slot;
    EXPECT_THAT(text, HasSubstr("struct SampleHeader")) << slot;
  }
}

}  // namespace
}  // namespace skein::spy_tool
