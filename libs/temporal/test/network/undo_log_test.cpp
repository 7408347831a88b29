// SPDX-License-Identifier: Apache-2.0
#include "network/undo_log.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace skein::temporal {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

Undo write_of(std::uint32_t id) { return {.write = Undo::Write::kStale, .id = id}; }

std::vector<std::uint32_t> undone(UndoLog& log) {
  std::vector<std::uint32_t> ids;
  log.undo_to_mark([&](const Undo& undo) {
    ids.push_back(undo.id);
    log.add(undo);
  });
  return ids;
}

TEST(UndoLog, TheLastWriteIsUndoneFirst) {
  UndoLog log;
  log.mark();
  log.add(write_of(1));
  log.add(write_of(2));

  EXPECT_THAT(undone(log), ElementsAre(2, 1));
}

TEST(UndoLog, WhatIsUndoneIsUndoneOnceAndTheMarkStays) {
  UndoLog log;
  log.mark();
  log.add(write_of(1));
  undone(log);
  EXPECT_THAT(undone(log), IsEmpty());

  log.add(write_of(2));
  EXPECT_THAT(undone(log), ElementsAre(2));
}

TEST(UndoLog, WithoutAMarkNothingIsKept) {
  UndoLog log;
  log.add(write_of(1));
  log.mark();

  EXPECT_THAT(undone(log), IsEmpty());
}

TEST(UndoLog, WritesAfterADroppedMarkBelongToTheOneBefore) {
  UndoLog log;
  log.mark();
  log.add(write_of(1));
  log.mark();
  log.add(write_of(2));
  log.drop_mark();
  log.add(write_of(3));

  EXPECT_THAT(undone(log), ElementsAre(3, 2, 1));
}

TEST(UndoLog, OnlyWhatFollowsTheLastMarkIsUndone) {
  UndoLog log;
  log.mark();
  log.add(write_of(1));
  log.mark();
  log.add(write_of(2));

  EXPECT_THAT(undone(log), ElementsAre(2));
  log.drop_mark();
  EXPECT_THAT(undone(log), ElementsAre(1));
}

TEST(UndoLog, WhenNoMarkIsLeftAllIsForgotten) {
  UndoLog log;
  for (std::uint32_t id = 0; id < 1'000; ++id) {
    log.mark();
    log.add(write_of(id));
    log.drop_mark();
  }
  log.mark();

  EXPECT_THAT(undone(log), IsEmpty());
  EXPECT_LE(log.memory_bytes(), 10 * sizeof(Undo));
}

}  // namespace
}  // namespace skein::temporal
