#include "idl/bus/cyclonedds/blob.hpp"

#include <dds/ddsi/ddsi_serdata.h>
#include <dds/ddsi/ddsi_sertype.h>

namespace weft::bus::cyclonedds {
namespace {

/// Holds a serialised sample without a type of its own: dds_writecdr makes one of the writer's type of its bytes.
struct Blob : ddsi_serdata {
  Bytes bytes;
};

constexpr ddsi_serdata_ops blob_ops() {
  ddsi_serdata_ops ops{};
  ops.get_size = [](const ddsi_serdata* sample) {
    return static_cast<std::uint32_t>(static_cast<const Blob*>(sample)->bytes.size());
  };
  ops.to_ser_ref = [](const ddsi_serdata* sample, std::size_t offset, std::size_t size, ddsrt_iovec_t* part) {
    auto* const blob = const_cast<Blob*>(static_cast<const Blob*>(sample));
    part->iov_base = blob->bytes.data() + offset;
    part->iov_len = size;
    return static_cast<ddsi_serdata*>(blob);
  };
  ops.to_ser_unref = [](ddsi_serdata*, const ddsrt_iovec_t*) {};
  ops.free = [](ddsi_serdata* sample) { delete static_cast<Blob*>(sample); };
  return ops;
}

constexpr ddsi_serdata_ops kBlobOps = blob_ops();
/// States a version, which is all that Cyclone DDS asks of a foreign type.
constexpr ddsi_sertype_ops kTypeOps = [] {
  ddsi_sertype_ops ops{};
  ops.version = ddsi_sertype_v0;
  return ops;
}();
constexpr ddsi_sertype kBlobType = [] {
  ddsi_sertype type{};
  type.ops = &kTypeOps;
  type.serdata_ops = &kBlobOps;
  return type;
}();

}  // namespace

dds_return_t write_bytes(dds_entity_t writer, ByteView padded) {
  auto* const blob = new Blob;
  ddsi_serdata_init(blob, &kBlobType, SDK_DATA);
  blob->bytes.assign(padded.begin(), padded.end());
  return dds_writecdr(writer, blob);  // takes the reference, whatever it returns
}

SerialisedSample::SerialisedSample(ddsi_serdata* sample) : sample_(sample) {
  ddsrt_iovec_t part{};
  held_ = ddsi_serdata_to_ser_ref(sample, 0, ddsi_serdata_size(sample), &part);
  bytes_ = {static_cast<const std::uint8_t*>(part.iov_base), part.iov_len};
}

SerialisedSample::~SerialisedSample() {
  const ddsrt_iovec_t part{const_cast<std::uint8_t*>(bytes_.data()), bytes_.size()};
  ddsi_serdata_to_ser_unref(held_, &part);
  ddsi_serdata_unref(sample_);
}

}  // namespace weft::bus::cyclonedds
