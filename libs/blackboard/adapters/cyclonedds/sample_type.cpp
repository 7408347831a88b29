// SPDX-License-Identifier: Apache-2.0
// How Cyclone DDS sees the type of a slot. Source: ddsi_sertype.h and ddsi_serdata.h of Cyclone DDS
// 0.10.2, which say what each operation must do.
#include "sample_type.hpp"

#include <dds/ddsi/ddsi_typelib.h>
#include <dds/ddsi/q_radmin.h>
#include <dds/ddsrt/heap.h>
#include <dds/ddsrt/md5.h>
#include <dds/ddsrt/mh3.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>

#include "skein/blackboard/cdr.hpp"
#include "skein/blackboard/dds_type.hpp"
#include "type_description.hpp"

namespace skein::blackboard::cyclonedds {
namespace {

constexpr std::size_t kEncapsulation = 4;
constexpr std::size_t kKeyBytes = 12;

struct SampleType : ddsi_sertype {
  wire::Slot slot = wire::Slot::kHeartbeat;
};

/// Bytes and key of one sample; only the key where that is all there is.
struct Data : ddsi_serdata {
  Key key{};
  std::size_t size = 0;             ///< of the CDR; `bytes` is filled up to a multiple of four
  std::vector<std::uint8_t> bytes;  ///< that the protocol may read beyond the end
};

Data* as_data(ddsi_serdata* data) { return static_cast<Data*>(data); }
const Data* as_data(const ddsi_serdata* data) { return static_cast<const Data*>(data); }

constexpr std::size_t padded(std::size_t size) { return (size + 3) / 4 * 4; }

/// The header begins with the key, in the byte order that the encapsulation says. A sample too
/// short for one has the key zero: it will be found malformed when it is read.
Key key_in(std::span<const std::uint8_t> cdr) {
  Key key{};
  if (cdr.size() < kEncapsulation + kKeyBytes) return key;
  const bool little = cdr[1] % 2 == 1;
  for (std::size_t i = 0; i < kKeyBytes; ++i) {
    const std::size_t within = i % 4;
    key[i] = cdr[kEncapsulation + i - within + (little ? 3 - within : within)];
  }
  return key;
}

Data* make_data(const ddsi_sertype* type, ddsi_serdata_kind kind, std::size_t size) {
  auto* const data = new Data;
  ddsi_serdata_init(data, type, kind);
  data->size = size;
  data->bytes.resize(padded(size));
  return data;
}

Data* with_key(Data* data, const Key& key) {
  data->key = key;
  data->hash = ddsrt_mh3(key.data(), key.size(), 0);
  return data;
}

Data* with_key_in_bytes(Data* data) {
  return with_key(data, key_in({data->bytes.data(), data->size}));
}

bool same_key(const ddsi_serdata* a, const ddsi_serdata* b) {
  return as_data(a)->key == as_data(b)->key;
}

std::uint32_t size_of(const ddsi_serdata* data) {
  return static_cast<std::uint32_t>(as_data(data)->size);
}

ddsi_serdata* from_fragments(const ddsi_sertype* type, ddsi_serdata_kind kind,
                             const nn_rdata* fragment, std::size_t size) {
  Data* const data = make_data(type, kind, size);
  std::size_t done = 0;
  for (; fragment != nullptr; fragment = fragment->nextfrag) {
    if (fragment->maxp1 <= done) continue;  // all of it was there before
    const unsigned char* const payload =
        NN_RMSG_PAYLOADOFF(fragment->rmsg, NN_RDATA_PAYLOAD_OFF(fragment));
    const std::size_t end = std::min<std::size_t>(fragment->maxp1, size);
    std::copy(payload + (done - fragment->min), payload + (end - fragment->min),
              data->bytes.begin() + static_cast<std::ptrdiff_t>(done));
    done = end;
  }
  return with_key_in_bytes(data);
}

ddsi_serdata* from_pieces(const ddsi_sertype* type, ddsi_serdata_kind kind,
                          ddsrt_msg_iovlen_t count, const ddsrt_iovec_t* pieces, std::size_t size) {
  Data* const data = make_data(type, kind, size);
  std::size_t done = 0;
  for (ddsrt_msg_iovlen_t i = 0; i < count && done < size; ++i) {
    const std::size_t length = std::min<std::size_t>(pieces[i].iov_len, size - done);
    std::memcpy(data->bytes.data() + done, pieces[i].iov_base, length);
    done += length;
  }
  return with_key_in_bytes(data);
}

ddsi_serdata* from_keyhash(const ddsi_sertype* type, const ddsi_keyhash* keyhash) {
  Key key{};
  std::copy_n(keyhash->value, kKeyBytes, key.begin());
  return with_key(make_data(type, SDK_KEY, 0), key);
}

ddsi_serdata* from_sample(const ddsi_sertype* type, ddsi_serdata_kind kind, const void* sample) {
  const auto& value = *static_cast<const wire::Sample*>(sample);
  const bool whole = kind == SDK_DATA;
  Data* const data = make_data(type, kind, whole ? encoded_size(value) : 0);
  if (whole) encode(value, {data->bytes.data(), data->size});
  return with_key(data, key_of(wire::header_of(value)));
}

void to_ser(const ddsi_serdata* data, std::size_t offset, std::size_t size, void* out) {
  std::memcpy(out, as_data(data)->bytes.data() + offset, size);
}

ddsi_serdata* to_ser_ref(const ddsi_serdata* data, std::size_t offset, std::size_t size,
                         ddsrt_iovec_t* ref) {
  ref->iov_base = const_cast<std::uint8_t*>(as_data(data)->bytes.data()) + offset;
  ref->iov_len = static_cast<ddsrt_iov_len_t>(size);
  return ddsi_serdata_ref(data);
}

void to_ser_unref(ddsi_serdata* data, const ddsrt_iovec_t*) { ddsi_serdata_unref(data); }

/// Nobody asks for C++ values: samples are taken as bytes (dds_takecdr).
bool to_sample(const ddsi_serdata*, void*, void**, void*) { return false; }
bool untyped_to_sample(const ddsi_sertype*, const ddsi_serdata*, void*, void**, void*) {
  return false;
}

ddsi_serdata* to_untyped(const ddsi_serdata* data) {
  Data* const untyped = with_key(make_data(data->type, SDK_KEY, 0), as_data(data)->key);
  untyped->type = nullptr;
  return untyped;
}

void free_data(ddsi_serdata* data) { delete as_data(data); }

std::size_t print(const ddsi_sertype*, const ddsi_serdata* data, char* out, std::size_t size) {
  const int length = std::snprintf(out, size, "%zu bytes", as_data(data)->size);
  return length < 0 ? 0 : static_cast<std::size_t>(length);
}

void get_keyhash(const ddsi_serdata* data, ddsi_keyhash* out, bool force_md5) {
  const Key& key = as_data(data)->key;
  if (!force_md5) {
    std::ranges::copy(key, out->value);
    return;
  }
  ddsrt_md5_state_t digest;
  ddsrt_md5_init(&digest);
  ddsrt_md5_append(&digest, key.data(), kKeyBytes);
  ddsrt_md5_finish(&digest, out->value);
}

void free_type(ddsi_sertype* type) {
  ddsi_sertype_fini(type);
  delete static_cast<SampleType*>(type);
}

bool same_type(const ddsi_sertype* a, const ddsi_sertype* b) {
  return static_cast<const SampleType*>(a)->slot == static_cast<const SampleType*>(b)->slot;
}

std::uint32_t hash_of_type(const ddsi_sertype* type) {
  return static_cast<std::uint32_t>(static_cast<const SampleType*>(type)->slot);
}

// Of samples in memory, which are never lent or asked for.
void zero_samples(const ddsi_sertype*, void*, std::size_t) {}
void realloc_samples(void**, const ddsi_sertype*, void*, std::size_t, std::size_t) {}
void free_samples(const ddsi_sertype*, void**, std::size_t, dds_free_op_t) {}

TypeDescription description_of(const ddsi_sertype* type) {
  return describe(static_cast<const SampleType*>(type)->slot);
}

ddsi_sertype_cdr_data serialised(std::span<const std::uint8_t> bytes) {
  return {static_cast<std::uint32_t>(bytes.size()), const_cast<std::uint8_t*>(bytes.data())};
}

// Copies that Cyclone frees.
ddsi_typeinfo_t* type_information(const ddsi_sertype* type) {
  const ddsi_sertype_cdr_data bytes = serialised(description_of(type).information);
  return ddsi_typeinfo_deser(&bytes);
}

ddsi_typemap_t* type_mapping(const ddsi_sertype* type) {
  const ddsi_sertype_cdr_data bytes = serialised(description_of(type).mapping);
  return ddsi_typemap_deser(&bytes);
}

ddsi_typeid_t* type_identifier(const ddsi_sertype* type, ddsi_typeid_kind_t kind) {
  ddsi_typeinfo_t* const information = type_information(type);
  ddsi_typeid_t* const identifier = ddsi_typeinfo_typeid(information, kind);
  ddsi_typeinfo_fini(information);
  ddsrt_free(information);
  return identifier;
}

const ddsi_serdata_ops& data_operations() {
  static const ddsi_serdata_ops kOperations = [] {
    ddsi_serdata_ops all{};
    all.eqkey = same_key;
    all.get_size = size_of;
    all.from_ser = from_fragments;
    all.from_ser_iov = from_pieces;
    all.from_keyhash = from_keyhash;
    all.from_sample = from_sample;
    all.to_ser = to_ser;
    all.to_ser_ref = to_ser_ref;
    all.to_ser_unref = to_ser_unref;
    all.to_sample = to_sample;
    all.to_untyped = to_untyped;
    all.untyped_to_sample = untyped_to_sample;
    all.free = free_data;
    all.print = print;
    all.get_keyhash = get_keyhash;
    return all;
  }();
  return kOperations;
}

const ddsi_sertype_ops& type_operations() {
  static const ddsi_sertype_ops kOperations = [] {
    ddsi_sertype_ops all{};
    all.version = ddsi_sertype_v0;
    all.free = free_type;
    all.zero_samples = zero_samples;
    all.realloc_samples = realloc_samples;
    all.free_samples = free_samples;
    all.equal = same_type;
    all.hash = hash_of_type;
    return all;
  }();
  return kOperations;
}

const ddsi_sertype_ops& described_type_operations() {
  static const ddsi_sertype_ops kOperations = [] {
    ddsi_sertype_ops all = type_operations();
    all.type_id = type_identifier;
    all.type_map = type_mapping;
    all.type_info = type_information;
    return all;
  }();
  return kOperations;
}

ddsi_sertype* make_type(wire::Slot slot, const ddsi_sertype_ops& operations) {
  auto* const type = new SampleType;
  const std::string name = blackboard::dds_type_of(slot);
  ddsi_sertype_init(type, name.c_str(), &operations, &data_operations(), false);
  type->allowed_data_representation = DDS_DATA_REPRESENTATION_FLAG_XCDR1;
  type->slot = slot;
  return type;
}

}  // namespace

ddsi_sertype* make_sample_type(wire::Slot slot) { return make_type(slot, type_operations()); }

ddsi_sertype* make_described_type(wire::Slot slot) {
  return make_type(slot, described_type_operations());
}

ddsi_serdata* make_outgoing(const ddsi_sertype& type, const wire::Sample& sample) {
  return from_sample(&type, SDK_DATA, &sample);
}

std::span<const std::uint8_t> bytes_of(const ddsi_serdata& data) {
  const Data& own = *as_data(&data);
  return {own.bytes.data(), own.size};
}

Key key_of(const wire::SampleHeader& header) {
  Key key{};
  std::size_t at = 0;
  for (const std::uint32_t part : {header.origin, header.instance, header.destination}) {
    for (int shift = 24; shift >= 0; shift -= 8) {
      key[at++] = static_cast<std::uint8_t>(part >> shift);
    }
  }
  return key;
}

}  // namespace skein::blackboard::cyclonedds
