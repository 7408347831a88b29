// SPDX-License-Identifier: Apache-2.0
// operator new and delete of `skein`: blocks by size, cut from pieces of two megabytes that the
// kernel may give as one page each. A plan of a millisecond makes some thousand small blocks in
// hundreds of pages, and both cost it a tenth of its time with the general allocator. A freed block
// is kept for others of its size: the process ends soon.
#include <sys/mman.h>
#include <sys/single_threaded.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <mutex>
#include <new>

namespace skein::cli {

namespace {

constexpr std::size_t kUnit = 16;                     // [bytes] sizes and places are multiples
constexpr std::size_t kHeader = 8;                    // [bytes] before each block
constexpr std::size_t kFineUnits = 32;                // up to here each size has its class
constexpr std::size_t kMostUnits = 8192;              // of blocks in pieces
constexpr std::size_t kPage = std::size_t{2} << 20U;  // [bytes]
constexpr std::size_t kFirstPiece = std::size_t{32} << 10U;  // [bytes] for what plans nothing

// In the header of a block that is not from a piece; a block of pages of its own has their bytes.
constexpr std::uint64_t kGeneral = 0;

struct SizeClass {
  std::uint64_t index;  ///< from 1
  std::size_t units;    ///< of each of its blocks, with the header
};

// Above kFineUnits four for each doubling.
SizeClass class_of(std::size_t units) {
  if (units <= kFineUnits) return {units, units};
  const auto doubling = static_cast<std::size_t>(std::bit_width(units - 1));
  const std::size_t step = std::size_t{1} << (doubling - 3);
  const std::size_t steps = (units + step - 1) / step;  // 5 to 8
  return {kFineUnits + (doubling - 6) * 4 + (steps - 4), steps * step};
}
constexpr std::size_t kClasses = kFineUnits + 4 * 8 + 1;

// Begin at a multiple of kPage; null: there is no room.
std::byte* map_pages(std::size_t bytes) noexcept {
  void* const mapped =
      mmap(nullptr, bytes + kPage, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (mapped == MAP_FAILED) return nullptr;
  auto* const begin = static_cast<std::byte*>(mapped);
  const std::size_t before = (kPage - reinterpret_cast<std::uintptr_t>(mapped) % kPage) % kPage;
  if (before > 0) munmap(begin, before);
  munmap(begin + before + bytes, kPage - before);
  madvise(begin + before, bytes, MADV_HUGEPAGE);  // refused: pages of the usual size
  return begin + before;
}

alignas(kUnit) std::array<std::byte, kFirstPiece> first_piece;

class Heap {
 public:
  /// Null: there is no memory.
  void* take(std::size_t bytes) noexcept {
    if (bytes > kMostUnits * kUnit - kHeader) return large(bytes);
    const SizeClass wanted = class_of((bytes + kHeader + kUnit - 1) / kUnit);
    Kept*& kept = kept_[wanted.index];
    if (kept == nullptr) return cut(wanted, bytes);
    Kept* const block = kept;
    kept = block->next;
    return block;
  }

  void give_back(void* block) noexcept {
    const std::uint64_t header = header_of(block);
    if (header == kGeneral) {
      std::free(static_cast<std::byte*>(block) - kUnit);
    } else if (header >= kPage) {
      munmap(static_cast<std::byte*>(block) - kUnit, header);
    } else {
      kept_[header] = new (block) Kept{kept_[header]};
    }
  }

 private:
  struct Kept {
    Kept* next;
  };

  static std::uint64_t& header_of(void* block) {
    return *reinterpret_cast<std::uint64_t*>(static_cast<std::byte*>(block) - kHeader);
  }

  // A block behind its header.
  static void* headed(void* whole, std::uint64_t header) noexcept {
    if (whole == nullptr) return nullptr;
    void* const block = static_cast<std::byte*>(whole) + kUnit;
    header_of(block) = header;
    return block;
  }

  static void* large(std::size_t bytes) noexcept {
    if (bytes > PTRDIFF_MAX - kPage) return nullptr;
    if (bytes >= kPage) {
      const std::size_t size = (bytes + kUnit + kPage - 1) / kPage * kPage;
      if (std::byte* const pages = map_pages(size)) return headed(pages, size);
    }
    return headed(std::malloc(bytes + kUnit), kGeneral);
  }

  void* cut(const SizeClass& wanted, std::size_t bytes) noexcept {
    const std::size_t size = wanted.units * kUnit;
    while (static_cast<std::size_t>(end_ - begin_) < size + kUnit) {
      if (!next_piece()) return headed(std::malloc(bytes + kUnit), kGeneral);
    }
    std::byte* const before = begin_;
    begin_ += size;
    return headed(before, wanted.index);
  }

  bool next_piece() noexcept {
    const bool first = begin_ == nullptr;
    std::byte* const piece = first ? first_piece.data() : map_pages(kPage);
    if (piece == nullptr) return false;
    begin_ = piece;
    end_ = piece + (first ? first_piece.size() : kPage);
    return true;
  }

  std::byte* begin_ = nullptr;  ///< of what is left of the piece
  std::byte* end_ = nullptr;
  std::array<Kept*, kClasses> kept_{};
};

constinit Heap heap;
constinit std::mutex mutex;

template <typename Action>
auto alone(Action action) {
  if (__libc_single_threaded != 0) return action();
  const std::lock_guard lock(mutex);
  return action();
}

}  // namespace

}  // namespace skein::cli

void* operator new(std::size_t bytes) {
  for (;;) {
    void* const block = skein::cli::alone([bytes] { return skein::cli::heap.take(bytes); });
    if (block != nullptr) return block;
    const std::new_handler handler = std::get_new_handler();
    if (handler == nullptr) throw std::bad_alloc();
    handler();
  }
}

void operator delete(void* block) noexcept {
  if (block == nullptr) return;
  skein::cli::alone([block] { skein::cli::heap.give_back(block); });
}

void operator delete(void* block, std::size_t /*bytes*/) noexcept { operator delete(block); }
