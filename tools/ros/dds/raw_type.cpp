#include "tools/ros/dds/raw_type.hpp"

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <utility>

#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>
#include <dds/ddsi/q_radmin.h>

namespace castaway::testbed {
namespace {

/// A sample within CycloneDDS. Its bytes are padded to a multiple of four, which the wire needs.
struct RawData : ddsi_serdata {
  RawData(const ddsi_sertype* its_type, ddsi_serdata_kind its_kind, std::string its_bytes)
      : ddsi_serdata{}, bytes(std::move(its_bytes)) {
    ddsi_serdata_init(this, its_type, its_kind);
    bytes.resize((bytes.size() + 3) / 4 * 4);
  }
  std::string bytes;
};

const std::string& bytes_of(const ddsi_serdata* data) {
  return static_cast<const RawData*>(data)->bytes;
}

// All samples are those of one instance: the type has no keys.
bool has_equal_key(const ddsi_serdata*, const ddsi_serdata*) { return true; }

std::uint32_t size_of(const ddsi_serdata* data) {
  return static_cast<std::uint32_t>(bytes_of(data).size());
}

ddsi_serdata* from_fragments(const ddsi_sertype* type, ddsi_serdata_kind kind,
                             const nn_rdata* fragment, std::size_t size) {
  std::string bytes(size, '\0');
  std::uint32_t done = 0;
  for (; fragment != nullptr; fragment = fragment->nextfrag) {
    if (fragment->maxp1 <= done) continue;  // Fragments may overlap.
    const unsigned char* payload =
        NN_RMSG_PAYLOADOFF(fragment->rmsg, NN_RDATA_PAYLOAD_OFF(fragment));
    std::memcpy(bytes.data() + done, payload + (done - fragment->min), fragment->maxp1 - done);
    done = fragment->maxp1;
  }
  return new RawData(type, kind, std::move(bytes));
}

ddsi_serdata* from_blocks(const ddsi_sertype* type, ddsi_serdata_kind kind,
                          ddsrt_msg_iovlen_t count, const ddsrt_iovec_t* blocks, std::size_t) {
  std::string bytes;
  for (ddsrt_msg_iovlen_t i = 0; i < count; ++i) {
    bytes.append(static_cast<const char*>(blocks[i].iov_base), blocks[i].iov_len);
  }
  return new RawData(type, kind, std::move(bytes));
}

ddsi_serdata* from_key(const ddsi_sertype* type, const ddsi_keyhash*) {
  return new RawData(type, SDK_KEY, {});
}

ddsi_serdata* from_sample(const ddsi_sertype* type, ddsi_serdata_kind kind, const void* sample) {
  return new RawData(type, kind, *static_cast<const std::string*>(sample));
}

void copy_bytes(const ddsi_serdata* data, std::size_t offset, std::size_t size, void* buffer) {
  std::memcpy(buffer, bytes_of(data).data() + offset, size);
}

ddsi_serdata* lend_bytes(const ddsi_serdata* data, std::size_t offset, std::size_t size,
                         ddsrt_iovec_t* block) {
  block->iov_base = const_cast<char*>(bytes_of(data).data() + offset);
  block->iov_len = static_cast<ddsrt_iov_len_t>(size);
  return ddsi_serdata_ref(data);
}

void take_back(ddsi_serdata* data, const ddsrt_iovec_t*) { ddsi_serdata_unref(data); }

bool to_sample(const ddsi_serdata* data, void* sample, void**, void*) {
  *static_cast<std::string*>(sample) = bytes_of(data);
  return true;
}

ddsi_serdata* to_untyped(const ddsi_serdata* data) {
  auto* untyped = new RawData(data->type, SDK_KEY, {});
  untyped->type = nullptr;
  return untyped;
}

bool untyped_to_sample(const ddsi_sertype*, const ddsi_serdata*, void*, void**, void*) {
  return true;
}

void free_data(ddsi_serdata* data) { delete static_cast<RawData*>(data); }

std::size_t print_data(const ddsi_sertype*, const ddsi_serdata*, char* text, std::size_t size) {
  if (size > 0) text[0] = '\0';
  return 0;
}

void no_key_hash(const ddsi_serdata*, ddsi_keyhash* hash, bool) {
  std::memset(hash, 0, sizeof(*hash));
}

constexpr ddsi_serdata_ops data_operations() {
  ddsi_serdata_ops operations{};
  operations.eqkey = has_equal_key;
  operations.get_size = size_of;
  operations.from_ser = from_fragments;
  operations.from_ser_iov = from_blocks;
  operations.from_keyhash = from_key;
  operations.from_sample = from_sample;
  operations.to_ser = copy_bytes;
  operations.to_ser_ref = lend_bytes;
  operations.to_ser_unref = take_back;
  operations.to_sample = to_sample;
  operations.to_untyped = to_untyped;
  operations.untyped_to_sample = untyped_to_sample;
  operations.free = free_data;
  operations.print = print_data;
  operations.get_keyhash = no_key_hash;
  return operations;
}

constexpr ddsi_serdata_ops kDataOperations = data_operations();

void free_type(ddsi_sertype* type) {
  ddsi_sertype_fini(type);
  delete type;
}

// Readers bring their own samples.
void zero_samples(const ddsi_sertype*, void*, std::size_t) {}
void allocate_samples(void**, const ddsi_sertype*, void*, std::size_t, std::size_t) {
  std::abort();
}
void free_samples(const ddsi_sertype*, void**, std::size_t, dds_free_op_t) {}

// Types of one name are equal.
bool has_equal_details(const ddsi_sertype*, const ddsi_sertype*) { return true; }
std::uint32_t no_hash(const ddsi_sertype*) { return 0; }

ddsi_sertype_ops type_operations() {
  ddsi_sertype_ops operations{};
  operations.version = ddsi_sertype_v0;
  operations.free = free_type;
  operations.zero_samples = zero_samples;
  operations.realloc_samples = allocate_samples;
  operations.free_samples = free_samples;
  operations.equal = has_equal_details;
  operations.hash = no_hash;
  return operations;
}

const ddsi_sertype_ops kTypeOperations = type_operations();

}  // namespace

ddsi_sertype* make_raw_type(const std::string& name) {
  auto type = std::make_unique<ddsi_sertype>();
  ddsi_sertype_init_flags(type.get(), name.c_str(), &kTypeOperations, &kDataOperations,
                          DDSI_SERTYPE_FLAG_TOPICKIND_NO_KEY);
  type->allowed_data_representation = DDS_DATA_REPRESENTATION_FLAG_XCDR1;
  return type.release();
}

}  // namespace castaway::testbed
