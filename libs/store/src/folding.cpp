// SPDX-License-Identifier: Apache-2.0
#include "folding.hpp"

#include <zstd.h>

#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>

namespace skein::store {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int kFoldingLevel = 3;
/// Who folds stops long before; a frame that says so is none of ours.
constexpr unsigned long long kLongestFold = 1ULL << 30;

// ---- numbers of 7 bits a byte, the lowest first; signs in the lowest bit ----

void put(Bytes& out, std::uint64_t value) {
  for (; value > 0x7f; value >>= 7) out.push_back(static_cast<std::uint8_t>(value | 0x80));
  out.push_back(static_cast<std::uint8_t>(value));
}

/// The difference modulo 2^64, small whichever its sign is.
void put_change(Bytes& out, std::int64_t from, std::int64_t to) {
  const std::uint64_t change = static_cast<std::uint64_t>(to) - static_cast<std::uint64_t>(from);
  put(out, (change << 1) ^ (0 - (change >> 63)));
}

void put(Bytes& out, const std::string& text) {
  put(out, text.size());
  out.insert(out.end(), text.begin(), text.end());
}

class Reader {
 public:
  explicit Reader(const Bytes& bytes) : at_(bytes.data()), end_(at_ + bytes.size()) {}

  std::uint64_t number() {
    std::uint64_t value = 0;
    for (unsigned shift = 0; shift < 64; shift += 7) {
      const std::uint8_t byte = *take(1);
      value |= static_cast<std::uint64_t>(byte & 0x7f) << shift;
      if ((byte & 0x80) == 0) return value;
    }
    throw std::runtime_error("folded inputs: a number without an end");
  }
  std::int64_t changed(std::int64_t from) {
    const std::uint64_t read = number();
    const std::uint64_t change = (read >> 1) ^ (0 - (read & 1));
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(from) + change);
  }
  /// So many of what takes a byte each at least.
  std::size_t count() {
    const std::uint64_t value = number();
    if (value > left()) throw std::runtime_error("folded inputs: they end too early");
    return value;
  }
  const std::uint8_t* take(std::size_t bytes) {
    if (bytes > left()) throw std::runtime_error("folded inputs: they end too early");
    const std::uint8_t* taken = at_;
    at_ += bytes;
    return taken;
  }
  std::string text() {
    const std::size_t size = count();
    const std::uint8_t* bytes = take(size);
    return {bytes, bytes + size};
  }
  std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

 private:
  const std::uint8_t* at_;
  const std::uint8_t* end_;
};

// ---- rows of one heading: kind, peer and slot ----

using Heading = std::tuple<std::string, std::int64_t, std::string>;
using Headings = std::map<Heading, std::size_t>;  ///< in the order of their names, not numbers

Headings headings_of(const std::vector<Row>& rows) {
  Headings headings;
  for (const Row& row : rows) headings.try_emplace({row.kind, row.peer, row.slot}, headings.size());
  return headings;
}

void put_headings(Bytes& out, const Headings& headings) {
  std::vector<const Heading*> ordered(headings.size());
  for (const auto& [heading, number] : headings) ordered[number] = &heading;
  put(out, ordered.size());
  for (const Heading* heading : ordered) {
    put(out, std::get<0>(*heading));
    put_change(out, 0, std::get<1>(*heading));
    put(out, std::get<2>(*heading));
  }
}

std::vector<Heading> read_headings(Reader& reader) {
  std::vector<Heading> headings(reader.count());
  for (auto& [kind, peer, slot] : headings) {
    kind = reader.text();
    peer = reader.changed(0);
    slot = reader.text();
  }
  return headings;
}

// ---- columns ----

void put_instants(Bytes& out, const std::vector<Row>& rows) {
  std::int64_t last = 0, step = 0;
  for (const Row& row : rows) {
    const auto to = static_cast<std::int64_t>(static_cast<std::uint64_t>(row.at) -
                                              static_cast<std::uint64_t>(last));
    put_change(out, step, to);
    step = to;
    last = row.at;
  }
}

void read_instants(Reader& reader, std::vector<Row>& rows) {
  std::int64_t last = 0, step = 0;
  for (Row& row : rows) {
    step = reader.changed(step);
    row.at = static_cast<std::int64_t>(static_cast<std::uint64_t>(last) +
                                       static_cast<std::uint64_t>(step));
    last = row.at;
  }
}

using Number = std::int64_t Row::*;
constexpr Number kNumbers[] = {&Row::value, &Row::extra, &Row::flags};

/// The rows' places, those of the first heading first.
std::vector<std::size_t> by_heading(const std::vector<std::size_t>& heading_of,
                                    std::size_t headings) {
  std::vector<std::vector<std::size_t>> groups(headings);
  for (std::size_t i = 0; i < heading_of.size(); ++i) groups[heading_of[i]].push_back(i);
  std::vector<std::size_t> order;
  for (const auto& group : groups) order.insert(order.end(), group.begin(), group.end());
  return order;
}

void put_rest(Bytes& out, const std::vector<Row>& rows, const std::vector<std::size_t>& order) {
  for (const Number number : kNumbers) {
    std::int64_t last = 0;
    for (const std::size_t i : order) {
      put_change(out, last, rows[i].*number);
      last = rows[i].*number;
    }
  }
  for (const std::size_t i : order) put(out, rows[i].body.size());
  for (const std::size_t i : order) out.insert(out.end(), rows[i].body.begin(), rows[i].body.end());
}

void read_rest(Reader& reader, std::vector<Row>& rows, const std::vector<std::size_t>& order) {
  for (const Number number : kNumbers) {
    std::int64_t last = 0;
    for (const std::size_t i : order) last = rows[i].*number = reader.changed(last);
  }
  std::vector<std::size_t> sizes;
  for (std::size_t i = 0; i < order.size(); ++i) sizes.push_back(reader.count());
  for (std::size_t i = 0; i < order.size(); ++i) {
    const std::uint8_t* bytes = reader.take(sizes[i]);
    rows[order[i]].body.assign(bytes, bytes + sizes[i]);
  }
}

// ---- the frame ----

Bytes compressed(const Bytes& plain) {
  const std::unique_ptr<ZSTD_CCtx, decltype(&ZSTD_freeCCtx)> context(ZSTD_createCCtx(),
                                                                     &ZSTD_freeCCtx);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kFoldingLevel);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  Bytes packed(ZSTD_compressBound(plain.size()));
  const std::size_t size =
      ZSTD_compress2(context.get(), packed.data(), packed.size(), plain.data(), plain.size());
  if (ZSTD_isError(size) != 0) throw std::runtime_error(ZSTD_getErrorName(size));
  packed.resize(size);
  packed.shrink_to_fit();
  return packed;
}

Bytes decompressed(const Bytes& packed) {
  const unsigned long long size = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (size > kLongestFold) throw std::runtime_error("folded inputs that are not as they say");
  Bytes plain(size);
  const std::size_t read =
      ZSTD_decompress(plain.data(), plain.size(), packed.data(), packed.size());
  if (ZSTD_isError(read) != 0 || read != size)
    throw std::runtime_error(std::string("folded inputs: ") + ZSTD_getErrorName(read));
  return plain;
}

}  // namespace

Bytes fold(const std::vector<Row>& rows) {
  const Headings headings = headings_of(rows);
  std::vector<std::size_t> heading_of;
  for (const Row& row : rows) heading_of.push_back(headings.at({row.kind, row.peer, row.slot}));
  Bytes plain;
  put(plain, rows.size());
  put_headings(plain, headings);
  for (const std::size_t heading : heading_of) put(plain, heading);
  put_instants(plain, rows);
  put_rest(plain, rows, by_heading(heading_of, headings.size()));
  return compressed(plain);
}

std::vector<Row> unfold(const Bytes& folded) {
  const Bytes plain = decompressed(folded);
  Reader reader(plain);
  std::vector<Row> rows(reader.count());
  const std::vector<Heading> headings = read_headings(reader);
  std::vector<std::size_t> heading_of;
  for (Row& row : rows) {
    const std::uint64_t heading = heading_of.emplace_back(reader.number());
    if (heading >= headings.size()) throw std::runtime_error("folded inputs: of no kind");
    std::tie(row.kind, row.peer, row.slot) = headings[heading];
  }
  read_instants(reader, rows);
  read_rest(reader, rows, by_heading(heading_of, headings.size()));
  if (reader.left() > 0) throw std::runtime_error("folded inputs: more than they say");
  return rows;
}

}  // namespace skein::store
