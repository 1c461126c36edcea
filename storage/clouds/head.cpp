#include "storage/clouds/head.hpp"

#include <algorithm>
#include <string>

#include "core/network/change.hpp"
#include "storage/clouds/cloud.hpp"

namespace weft::clouds {
namespace {

constexpr std::uint8_t kFormat = 2;

std::int32_t read_origin(ByteReader& in) {
  const std::size_t at = in.offset();
  const auto value = static_cast<std::int32_t>(in.number<std::uint32_t>("origin"));
  if (value <= -kLatticeBound || value >= kLatticeBound) {
    in.corrupt("origin", at, "is " + std::to_string(value) + ", must lie within 2^23");
    return 0;
  }
  return value;
}

}  // namespace

tl::unexpected<Error> corrupt_cloud(const std::string& what) {
  return fail(ErrorCode::corrupt, "cloud: " + what);
}

tl::unexpected<Error> wrong_size(const Head& head, std::size_t size) {
  return corrupt_cloud(std::to_string(head.count) + " points and " + std::to_string(head.attached) +
                       " attached bytes need " + std::to_string(head.canonical_size()) + " bytes, " +
                       std::to_string(size) + " are there");
}

void write_magic(ByteWriter& out, const Magic& magic) {
  out.raw(magic);
  out.number(kFormat);
}

Result<void> check_magic(ByteView bytes, const Magic& magic) {
  if (bytes.size() < kMagicBytes || !std::equal(magic.begin(), magic.end(), bytes.begin())) {
    return fail(ErrorCode::corrupt, "no cloud: it does not start with " + std::string(magic.begin(), magic.end()));
  }
  const std::uint8_t format = bytes[magic.size()];
  if (format == kFormat) return {};
  return fail(
      format > kFormat ? ErrorCode::newer : ErrorCode::corrupt,
      "cloud of format " + std::to_string(format) + ", this software reads format " + std::to_string(kFormat));
}

void write_head(ByteWriter& out, const Head& head) {
  out.number(head.quantum_um);
  for (const std::int32_t origin : head.origin) out.number(static_cast<std::uint32_t>(origin));
  out.number(head.value_bytes);
  out.number(head.count);
  out.number(head.attached);
}

Head read_head(ByteReader& in) {
  Head head;
  head.quantum_um = in.ranged<std::uint32_t>("quantum", 1, kLargestQuantum_um);
  for (std::int32_t& origin : head.origin) origin = read_origin(in);
  head.value_bytes = in.ranged<std::uint8_t>("value bytes", 0, 2);
  const std::size_t at = in.offset();
  head.count = in.number<std::uint32_t>("count");
  head.attached = in.number<std::uint32_t>("attached");
  if (head.canonical_size() > kLargestContent) {
    in.corrupt("count", at,
               "is " + std::to_string(head.count) + ", with " + std::to_string(head.attached) +
                   " bytes attached, more than the largest content holds");
    head.count = 0;
    head.attached = 0;
  }
  return head;
}

Bytes with_head(const Head& head) {
  ByteWriter out;
  out.reserve(head.canonical_size());
  write_magic(out, kCanonicalMagic);
  write_head(out, head);
  Bytes bytes = out.take();
  bytes.resize(head.canonical_size());
  return bytes;
}

bool is_cloud(ByteView content) {
  return content.size() >= kMagicBytes && std::equal(kCanonicalMagic.begin(), kCanonicalMagic.end(), content.begin());
}

}  // namespace weft::clouds
