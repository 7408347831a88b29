// SPDX-License-Identifier: Apache-2.0
#include "skein/functional/parameters.hpp"

#include <gtest/gtest.h>

namespace skein::functional {
namespace {

TEST(Parameters, KeepTheirOrderAndKinds) {
  const Parameters p = Parameters()
                           .add("device", "ir")
                           .add("target", {1, 2, 3})
                           .add("shots", 4)
                           .add("none", std::vector<double>());

  ASSERT_EQ(p.all().size(), 4u);
  EXPECT_EQ(p.all()[0], (Parameter{"device", "ir", {}}));
  EXPECT_EQ(p.all()[1], (Parameter{"target", "", {1, 2, 3}}));
  EXPECT_EQ(p.all()[2], (Parameter{"shots", "", {4}}));
}

TEST(Parameters, AreFoundByName) {
  const Parameters p = Parameters().add("speed", 3).add("speed", 5);

  ASSERT_NE(p.find("speed"), nullptr);
  EXPECT_EQ(p.find("speed")->numbers, std::vector<double>{3}) << "the first";
  EXPECT_EQ(p.find("spede"), nullptr);
}

}  // namespace
}  // namespace skein::functional
