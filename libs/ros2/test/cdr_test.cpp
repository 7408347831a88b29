// SPDX-License-Identifier: Apache-2.0
#include "skein/ros2/cdr.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "testing/random_message.hpp"

namespace skein::ros2 {
namespace {

TEST(Cdr, ATextIsItsLengthWithTheZeroItsBytesAndTheZero) {
  EXPECT_EQ(to_cdr(String{"hi"}), (Bytes{0, 1, 0, 0, 3, 0, 0, 0, 'h', 'i', 0}));
}

TEST(Cdr, NumbersStandAtMultiplesOfTheirSize) {
  NavSatFix fix;
  fix.header.frame_id = "m";  // 8 bytes of time, 4 of length, 2 of text: status at 14
  fix.status = {-1, 0x0203};
  fix.latitude = 2;

  const Bytes bytes = to_cdr(fix);

  EXPECT_EQ(bytes[4 + 14], 0xff);
  EXPECT_EQ(bytes[4 + 16], 0x03);
  EXPECT_EQ(bytes[4 + 17], 0x02);
  EXPECT_EQ(bytes[4 + 24 + 7], 0x40);  // 2.0, at the next multiple of 8
  EXPECT_EQ(bytes.size(), 4U + 24 + 3 * 8 + 9 * 8 + 1);
}

TEST(Cdr, ReadsATextOfEitherByteOrder) {
  EXPECT_EQ(text_of(Bytes{0, 0, 0, 0, 0, 0, 0, 3, 'h', 'i', 0}), "hi");
  EXPECT_EQ(text_of(Bytes{0, 1, 0, 0, 0, 0, 0, 0}), "");
}

struct Wrong {
  const char* name;
  Bytes bytes;
  const char* why;
};

class WrongText : public ::testing::TestWithParam<Wrong> {};

TEST_P(WrongText, IsRefusedWithTheReason) {
  const auto text = text_of(GetParam().bytes);

  ASSERT_FALSE(text.has_value());
  EXPECT_EQ(text.error().why, GetParam().why);
}

INSTANTIATE_TEST_SUITE_P(
    Cdr, WrongText,
    ::testing::Values(Wrong{"Nothing", {}, "not CDR version 1"},
                      Wrong{"OtherVersion", {0, 7, 0, 0, 0, 0, 0, 0}, "not CDR version 1"},
                      Wrong{"CutShort", {0, 1, 0, 0, 9, 0, 0, 0, 'h', 0}, "cut short"},
                      Wrong{"Endless", {0, 1, 0, 0, 255, 255, 255, 255, 'h', 0}, "too long"},
                      Wrong{"NotTerminated", {0, 1, 0, 0, 2, 0, 0, 0, 'h', 'i'}, "not terminated"}),
    [](const auto& one) { return one.param.name; });

RC_GTEST_PROP(CdrLaw, ATextComesBackAsItWasSaid, (const std::string& text)) {
  const auto read = text_of(to_cdr(String{text}));

  RC_ASSERT(read.has_value());
  RC_ASSERT(*read == text);
}

RC_GTEST_PROP(CdrLaw, WhateverTheBytesNothingBreaks, (const Bytes& bytes)) {
  const auto read = text_of(bytes);

  RC_ASSERT(!read || read->size() <= bytes.size());
}

}  // namespace
}  // namespace skein::ros2
