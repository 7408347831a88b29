// SPDX-License-Identifier: Apache-2.0
// Linked with plan_heap.cpp: every new and delete of this program is the one under test.
#include <gmock/gmock.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <new>
#include <random>
#include <thread>
#include <vector>

namespace skein::cli {
namespace {

struct Block {
  std::byte* begin = nullptr;
  std::size_t size = 0;
  std::byte mark{};
};

std::size_t some_size(std::mt19937_64& random) {
  const std::size_t most = std::size_t{1} << std::uniform_int_distribution<>(0, 22)(random);
  return std::uniform_int_distribution<std::size_t>(0, most)(random);
}

Block taken(std::size_t size, std::byte mark) {
  Block block{static_cast<std::byte*>(::operator new(size)), size, mark};
  std::fill_n(block.begin, size, mark);
  return block;
}

bool untouched(const Block& block) {
  return std::all_of(block.begin, block.begin + block.size,
                     [&block](std::byte each) { return each == block.mark; });
}

// Takes and gives back blocks of all sizes in any order; false: one was changed by another.
bool keeps_what_is_written(std::uint64_t seed, int times) {
  std::mt19937_64 random(seed);
  std::vector<Block> blocks;
  bool kept = true;
  const auto give_back = [&](std::size_t at) {
    kept = kept && untouched(blocks[at]);
    ::operator delete(blocks[at].begin);
    blocks[at] = blocks.back();
    blocks.pop_back();
  };
  for (int time = 0; time < times; ++time) {
    if (blocks.size() > 60 || (!blocks.empty() && random() % 3 == 0)) {
      give_back(random() % blocks.size());
    } else {
      blocks.push_back(taken(some_size(random), static_cast<std::byte>(random())));
    }
  }
  while (!blocks.empty()) give_back(blocks.size() - 1);
  return kept;
}

std::size_t mapped_bytes() {
  std::size_t pages = 0;
  std::unique_ptr<FILE, int (*)(FILE*)> file(std::fopen("/proc/self/statm", "r"), std::fclose);
  EXPECT_EQ(std::fscanf(file.get(), "%zu", &pages), 1);
  return pages * 4096;
}

TEST(PlanHeap, GivesEachBlockPlaceOfItsOwn) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    EXPECT_TRUE(keeps_what_is_written(seed, 1500)) << seed;
  }
}

TEST(PlanHeap, GivesAlignedBlocksOfAnySize) {
  std::vector<std::byte*> blocks;
  for (std::size_t size = 0; size < 5'000'000; size += 1 + size / 7) {
    blocks.push_back(static_cast<std::byte*>(::operator new(size)));
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(blocks.back()) % 16, 0U) << size;
  }
  std::sort(blocks.begin(), blocks.end());
  EXPECT_EQ(std::adjacent_find(blocks.begin(), blocks.end()), blocks.end());
  for (std::byte* block : blocks) ::operator delete(block);
}

TEST(PlanHeap, TakesNoMoreAddressSpaceForWhatIsTakenAgain) {
  keeps_what_is_written(7, 1500);
  const std::size_t before = mapped_bytes();
  for (int again = 0; again < 20; ++again) keeps_what_is_written(7, 1500);
  EXPECT_LE(mapped_bytes(), before + (std::size_t{2} << 20U));
}

TEST(PlanHeap, ThrowsWhatIsThrownWithoutMemory) {
  for (const std::size_t size : {std::size_t{1} << 46U, SIZE_MAX / 2 + 1, SIZE_MAX - 8, SIZE_MAX}) {
    EXPECT_THROW(::operator delete(::operator new(size)), std::bad_alloc) << size;
  }
}

TEST(PlanHeap, ThrowsWhereAddressSpaceEnds) {
  rlimit given{};
  ASSERT_EQ(getrlimit(RLIMIT_AS, &given), 0);
  rlimit little = given;
  little.rlim_cur = mapped_bytes() + (std::size_t{64} << 20U);
  ASSERT_EQ(setrlimit(RLIMIT_AS, &little), 0);
  std::size_t taken_bytes = 0;
  std::vector<Block> blocks;
  blocks.reserve(4096);
  try {
    for (;; taken_bytes += 40'000) blocks.push_back(taken(40'000, std::byte{1}));
  } catch (const std::bad_alloc&) {
  }
  ASSERT_EQ(setrlimit(RLIMIT_AS, &given), 0);
  EXPECT_GT(taken_bytes, std::size_t{40} << 20U);
  EXPECT_TRUE(std::all_of(blocks.begin(), blocks.end(), untouched));
  for (const Block& block : blocks) ::operator delete(block.begin);
}

TEST(PlanHeap, ServesThreads) {
  std::vector<std::thread> threads;
  std::array<bool, 4> kept{};
  for (std::size_t at = 0; at < kept.size(); ++at) {
    threads.emplace_back([at, &kept] { kept[at] = keeps_what_is_written(100 + at, 3000); });
  }
  for (std::thread& thread : threads) thread.join();
  EXPECT_THAT(kept, testing::Each(true));
}

}  // namespace
}  // namespace skein::cli
