#include <zstd.h>

#include <algorithm>
#include <string>

#include "core/network/codec.hpp"
#include "storage/clouds/cloud.hpp"
#include "storage/clouds/gaps.hpp"
#include "storage/clouds/head.hpp"

namespace weft::clouds {
namespace {

constexpr int kLevel = 1;
constexpr std::size_t kChecksumBytes = sizeof(ContentHash::bytes);

Result<Bytes> shrink(ByteView bytes) {
  Bytes frame(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(frame.data(), frame.size(), bytes.data(), bytes.size(), kLevel);
  if (ZSTD_isError(size) != 0) {
    return fail(ErrorCode::internal, std::string("cloud: zstd: ") + ZSTD_getErrorName(size));
  }
  frame.resize(size);
  return frame;
}

/// Decompresses a zstd frame into exactly `size` bytes, which bounds what it can become. corrupt: another size.
Result<Bytes> grow(ByteView frame, std::size_t size, const char* what) {
  Bytes bytes(size);
  const std::size_t got = ZSTD_decompress(bytes.data(), bytes.size(), frame.data(), frame.size());
  if (ZSTD_isError(got) != 0) return corrupt_cloud(std::string(what) + ": zstd: " + ZSTD_getErrorName(got));
  if (got != size) {
    return corrupt_cloud(std::string(what) + " are " + std::to_string(got) + " bytes, not " + std::to_string(size));
  }
  return bytes;
}

/// Compresses a part that is left out where there is nothing to say.
Result<Bytes> shrink_if_any(ByteView bytes, std::size_t size) {
  return size == 0 ? Result<Bytes>(Bytes()) : shrink(bytes);
}

Result<Bytes> grow_if_any(ByteView frame, std::size_t size, const char* what) {
  return size == 0 && frame.empty() ? Result<Bytes>(Bytes()) : grow(frame, size, what);
}

std::size_t value_size(const Head& head) {
  return std::size_t{head.count} * head.value_bytes;
}

/// Returns all low bytes, then all high ones.
Bytes planes_from_values(ByteView values, std::size_t value_bytes) {
  Bytes planes(values.size());
  std::size_t to = 0;
  for (std::size_t plane = 0; plane < value_bytes; ++plane) {
    for (std::size_t at = plane; at < values.size(); at += value_bytes) planes[to++] = values[at];
  }
  return planes;
}

void values_from_planes(ByteView planes, std::size_t value_bytes, std::uint8_t* out) {
  const std::size_t count = value_bytes == 0 ? 0 : planes.size() / value_bytes;
  for (std::size_t plane = 0; plane < value_bytes; ++plane) {
    for (std::size_t at = 0; at < count; ++at) out[at * value_bytes + plane] = planes[plane * count + at];
  }
}

/// Writes a part of the bytes, behind its length.
void write_part(ByteWriter& out, ByteView part) {
  out.count(part.size());
  out.raw(part);
}

ByteView bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

Bytes with_checksum(ByteView payload) {
  ByteWriter out;
  out.reserve(kMagicBytes + kChecksumBytes + payload.size());
  write_magic(out, kCompressedMagic);
  out.id(hash_bytes(payload));
  out.raw(payload);
  return out.take();
}

/// Returns the payload that the checksum vouches for. corrupt: its SHA-256 is another than the checksum.
Result<ByteView> checked_payload(ByteView compressed) {
  if (auto magic = check_magic(compressed, kCompressedMagic); !magic) return fail(magic.error());
  ByteReader in(compressed.subspan(kMagicBytes));
  const auto checksum = in.id<ContentHash>("checksum");
  if (!in.ok()) return fail(in.finish("cloud").error());
  const ByteView payload = compressed.subspan(kMagicBytes + kChecksumBytes);
  if (hash_bytes(payload) != checksum) return corrupt_cloud("damaged: its SHA-256 is another than it says");
  return payload;
}

/// Holds the payload's head and the parts behind it, as they stand.
struct Parts {
  Head head;
  std::string tokens;
  std::string tails;
  std::string values;
  std::string attached;
};

Result<Parts> split_payload(ByteView payload) {
  ByteReader in(payload);
  Parts parts;
  parts.head = read_head(in);
  parts.tokens = in.text("size of the tokens");
  parts.tails = in.text("size of the tails");
  parts.values = in.text("size of the values");
  parts.attached = in.text("size of the attachment");
  if (auto end = in.finish("cloud"); !end) return fail(end.error());
  return parts;
}

}  // namespace

Result<Bytes> compress_cloud(ByteView canonical) {
  if (auto magic = check_magic(canonical, kCanonicalMagic); !magic) return fail(magic.error());
  ByteReader in(canonical.subspan(kMagicBytes));
  const Head head = read_head(in);
  if (!in.ok()) return fail(in.finish("cloud").error());
  if (canonical.size() != head.canonical_size()) return wrong_size(head, canonical.size());
  const ByteView body = canonical.subspan(kMagicBytes + kHeadBytes);
  const ByteView codes = body.first(head.count * sizeof(std::uint64_t));
  const ByteView stated = body.subspan(codes.size(), value_size(head));
  const auto gaps = gaps_from_codes(codes);
  if (!gaps) return fail(gaps.error());
  const auto tokens = shrink(gaps->tokens);
  const auto values = shrink_if_any(planes_from_values(stated, head.value_bytes), head.value_bytes);
  const auto attached = shrink_if_any(body.last(head.attached), head.attached);
  if (!tokens) return fail(tokens.error());
  if (!values) return fail(values.error());
  if (!attached) return fail(attached.error());
  ByteWriter payload;
  payload.reserve(kHeadBytes + 16 + tokens->size() + gaps->tails.size() + values->size() + attached->size());
  write_head(payload, head);
  for (const ByteView part : {ByteView(*tokens), ByteView(gaps->tails), ByteView(*values), ByteView(*attached)}) {
    write_part(payload, part);
  }
  return with_checksum(payload.view());
}

Result<std::uint64_t> expanded_size(ByteView compressed) {
  if (auto magic = check_magic(compressed, kCompressedMagic); !magic) return fail(magic.error());
  ByteReader in(compressed.subspan(kMagicBytes));
  in.id<ContentHash>("checksum");
  const Head head = read_head(in);
  if (!in.ok()) return fail(in.finish("cloud").error());
  return head.canonical_size();
}

Result<Bytes> expand_cloud(ByteView compressed) {
  const auto payload = checked_payload(compressed);
  if (!payload) return fail(payload.error());
  const auto parts = split_payload(*payload);
  if (!parts) return fail(parts.error());
  const Head& head = parts->head;
  const auto tokens = grow(bytes_of(parts->tokens), head.count, "tokens");
  if (!tokens) return fail(tokens.error());
  const auto planes = grow_if_any(bytes_of(parts->values), value_size(head), "values");
  if (!planes) return fail(planes.error());
  const auto attached = grow_if_any(bytes_of(parts->attached), head.attached, "attached bytes");
  if (!attached) return fail(attached.error());
  Bytes canonical = with_head(head);
  std::uint8_t* codes = canonical.data() + kMagicBytes + kHeadBytes;
  if (auto done = codes_from_gaps(*tokens, bytes_of(parts->tails), codes); !done) return fail(done.error());
  values_from_planes(*planes, head.value_bytes, codes + head.count * sizeof(std::uint64_t));
  std::copy(attached->begin(), attached->end(), canonical.end() - head.attached);
  return canonical;
}

}  // namespace weft::clouds
