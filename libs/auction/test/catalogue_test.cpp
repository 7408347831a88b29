// SPDX-License-Identifier: Apache-2.0
#include "skein/auction/catalogue.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/road_team.hpp"

namespace skein::auction {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

TEST(Catalogue, FindsTasksByNumberWhateverTheirOrder) {
  const Catalogue lot({{a_task(9).at(90), a_task(4).at(40)}, {}});

  EXPECT_EQ(lot.size(), 2U);
  EXPECT_EQ(lot.index(TaskNumber(9)), 0U);
  EXPECT_EQ(lot.task(TaskNumber(4)).at.x, 40);
  EXPECT_TRUE(lot.has(TaskNumber(4)));
  EXPECT_FALSE(lot.has(TaskNumber(5)));
}

TEST(Catalogue, KnowsWhatComesBeforeAndAfterEachTask) {
  const Catalogue lot({{a_task(1), a_task(2), a_task(3)},
                       {{TaskNumber(1), TaskNumber(3)}, {TaskNumber(2), TaskNumber(3)}}});

  EXPECT_THAT(lot.before(2), ElementsAre(0, 1));
  EXPECT_THAT(lot.after(0), ElementsAre(2));
  EXPECT_THAT(lot.before(0), IsEmpty());
  EXPECT_THAT(lot.after(2), IsEmpty());
}

TEST(Catalogue, LeavesOutPrecedencesOfWhatItDoesNotHave) {
  const Catalogue lot(
      {{a_task(1)}, {{TaskNumber(1), TaskNumber(8)}, {TaskNumber(8), TaskNumber(1)}}});

  EXPECT_THAT(lot.before(0), IsEmpty());
  EXPECT_THAT(lot.after(0), IsEmpty());
  EXPECT_FALSE(lot.coupled());
}

TEST(Catalogue, IsCoupledByAPrecedenceAPartnerOrASecondAbility) {
  const auto coupled = [](Task second, std::vector<Precedence> order) {
    return Catalogue({{a_task(1), std::move(second)}, std::move(order)}).coupled();
  };

  EXPECT_FALSE(coupled(a_task(2), {}));
  EXPECT_FALSE(coupled(a_task(2).needing(0b100), {}));
  EXPECT_FALSE(coupled(a_task(2).of_each(0b110), {}));
  EXPECT_TRUE(coupled(a_task(2).needing(0b110), {}));
  EXPECT_TRUE(coupled(a_task(2).members(2), {}));
  EXPECT_TRUE(coupled(a_task(2), {{TaskNumber(1), TaskNumber(2)}}));
}

TEST(CatalogueDeathTest, IsNotAskedForATaskThatItDoesNotHave) {
  const Catalogue lot({{a_task(1)}, {}});

  EXPECT_DEATH(lot.index(TaskNumber(2)), "");
}

}  // namespace
}  // namespace skein::auction
