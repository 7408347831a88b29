// SPDX-License-Identifier: Apache-2.0
#include "packing.hpp"

#include <zstd.h>

#include <stdexcept>

namespace skein::store {

namespace {

constexpr int kLevel = 1;
/// No sample is longer (the wire's own limits are far below); a frame that says so is none of ours.
constexpr unsigned long long kLongest = 64ULL << 20;

}  // namespace

struct Packing::Contexts {
  std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> in{ZSTD_createCCtx(), &ZSTD_freeCCtx};
  std::unique_ptr<ZSTD_DCtx, decltype(&ZSTD_freeDCtx)> out{ZSTD_createDCtx(), &ZSTD_freeDCtx};
};

Packing::Packing() : contexts_(std::make_unique<Contexts>()) {
  ZSTD_CCtx_setParameter(contexts_->in.get(), ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(contexts_->in.get(), ZSTD_c_checksumFlag, 1);
}
Packing::Packing(Packing&& other) noexcept = default;
Packing& Packing::operator=(Packing&& other) noexcept = default;
Packing::~Packing() = default;

void Packing::pack(Row& row) {
  if (row.body.empty()) return;
  const auto [known, first] = last_.try_emplace({row.peer, row.slot});
  Bytes body = std::move(row.body);
  Bytes packed(ZSTD_compressBound(body.size()));
  ZSTD_CCtx_refPrefix(contexts_->in.get(), known->second.data(), known->second.size());
  const std::size_t size =
      ZSTD_compress2(contexts_->in.get(), packed.data(), packed.size(), body.data(), body.size());
  const bool shorter = ZSTD_isError(size) == 0 && size < body.size();
  if (shorter) {
    packed.resize(size);
    row.body = std::move(packed);
    row.flags |= kPacked;
  } else {
    row.body = body;
  }
  known->second = std::move(body);
}

void Packing::unpack(Row& row) {
  if (row.body.empty()) return;
  Bytes& last = last_[{row.peer, row.slot}];
  if ((row.flags & kPacked) == 0) {
    last = row.body;
    return;
  }
  const unsigned long long size = ZSTD_getFrameContentSize(row.body.data(), row.body.size());
  if (size > kLongest) throw std::runtime_error("a body that is not packed as it says");
  Bytes body(size);
  ZSTD_DCtx_refPrefix(contexts_->out.get(), last.data(), last.size());
  const std::size_t read = ZSTD_decompressDCtx(contexts_->out.get(), body.data(), body.size(),
                                               row.body.data(), row.body.size());
  if (ZSTD_isError(read) != 0 || read != size)
    throw std::runtime_error(std::string("a packed body: ") + ZSTD_getErrorName(read));
  row.flags &= ~kPacked;
  row.body = body;
  last = std::move(body);
}

}  // namespace skein::store
