// SPDX-License-Identifier: Apache-2.0
#include "skein/ground_station/closed_air.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "testing/builders.hpp"

namespace skein::ground_station {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;
using ::testing::Key;

mission::ChangeWorld change(const std::string& volume, bool remove) {
  mission::ChangeWorld change;
  change.volume.name = volume;
  change.remove = remove;
  return change;
}

TEST(ClosedAir, IsWhatWasClosedAndNotOpenedAgain) {
  ClosedAir air;
  air.note(change("tower", false));
  air.note(change("mast", false));
  air.note(change("tower", false));
  EXPECT_THAT(air.volumes(), ElementsAre(Key("mast"), Key("tower")));

  air.note(change("tower", true));

  EXPECT_THAT(air.volumes(), ElementsAre(Key("mast")));
}

TEST(ClosedAir, AClosureOfTheSameNameTakesThePlaceOfTheFormer) {
  ClosedAir air;
  mission::ChangeWorld tower = change("tower", false);
  air.note(tower);
  tower.volume.ceiling = 77;

  air.note(tower);

  EXPECT_EQ(air.volumes().at("tower").ceiling, 77);
}

TEST(ClosedAir, RequestsAboutPlacesAndTasksAreNoVolumes) {
  ClosedAir air;
  mission::ChangeWorld place = change("camp", false);
  place.place = mission::KnownPlace{"camp"};

  air.note(place);
  air.note(testing::start_of(5));

  EXPECT_THAT(air.volumes(), IsEmpty());
}

}  // namespace
}  // namespace skein::ground_station
