#include "storage/spool/record.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "core/network/codec.hpp"

namespace weft::storage {
namespace {

constexpr std::array<std::uint8_t, 8> kMagic{'W', 'E', 'F', 'T', 'S', 'P', 'L', 1};  // the last byte is the version
constexpr std::size_t kHashBytes = 32;
constexpr std::size_t kLengthBytes = 8;
constexpr std::size_t kHeaderBytes = kMagic.size() + kLengthBytes + kHashBytes;

void append(Bytes& out, std::uint64_t number) {
  for (unsigned shift = 0; shift < 64; shift += 8) out.push_back(static_cast<std::uint8_t>(number >> shift));
}

void append(Bytes& out, ByteView bytes) {
  append(out, bytes.size());
  out.insert(out.end(), bytes.begin(), bytes.end());
}

/// Takes numbers and length-framed pieces from the front.
class Reader {
 public:
  explicit Reader(ByteView bytes) : left_(bytes) {}

  bool number(std::uint64_t& out) {
    if (left_.size() < kLengthBytes) return false;
    out = 0;
    for (std::size_t at = kLengthBytes; at-- > 0;) out = out << 8U | left_[at];
    left_ = left_.subspan(kLengthBytes);
    return true;
  }
  bool piece(ByteView& out) {
    std::uint64_t length = 0;
    if (!number(length) || length > left_.size()) return false;
    out = left_.first(length);
    left_ = left_.subspan(length);
    return true;
  }
  ByteView left() const { return left_; }

 private:
  ByteView left_;
};

Error short_at(const char* what, ByteView whole, ByteView left) {
  return {ErrorCode::corrupt,
          std::string(what) + " is cut off at payload byte " + std::to_string(whole.size() - left.size())};
}

Result<SpoolRecord> decode_payload(ByteView payload) {
  Reader reader(payload);
  ByteView batch_bytes;
  std::uint64_t count = 0;
  if (!reader.piece(batch_bytes)) return fail(short_at("batch", payload, reader.left()));
  auto batch = decode_batch(batch_bytes);
  if (!batch) return fail(batch.error());
  SpoolRecord record{std::move(*batch), {}};
  if (!reader.number(count)) return fail(short_at("content count", payload, reader.left()));
  for (std::uint64_t at = 0; at < count; ++at) {
    ByteView content;
    if (!reader.piece(content)) return fail(short_at("content", payload, reader.left()));
    record.contents.emplace(hash_bytes(content), std::make_shared<const Bytes>(content.begin(), content.end()));
  }
  if (!reader.left().empty()) {
    return fail(ErrorCode::corrupt, std::to_string(reader.left().size()) + " bytes after the last content");
  }
  return record;
}

}  // namespace

Result<SpoolRecord> make_record(const Batch& batch, const std::vector<Bytes>& contents,
                                const std::function<SharedBytes(const ContentHash&)>& held) {
  SpoolRecord record{batch, {}};
  for (const Bytes& content : contents) {
    record.contents.emplace(hash_bytes(content), std::make_shared<const Bytes>(content));
  }
  for (const Place& place : batch.places) {
    if (record.contents.contains(place.content.hash)) continue;
    SharedBytes earlier = held(place.content.hash);
    if (earlier == nullptr) {
      return fail(ErrorCode::invalid, "spool: batch " + std::to_string(batch.sequence) + " of experience " +
                                          to_string(batch.experience) + ": content " + to_string(place.content.hash) +
                                          " of place " + to_string(place.id) + " is neither given nor held");
    }
    record.contents.emplace(place.content.hash, std::move(earlier));
  }
  return record;
}

std::optional<Result<void>> compare(const Batch& pending, const Batch& batch) {
  if (pending.experience != batch.experience || pending.sequence != batch.sequence) return std::nullopt;
  if (hash(pending) == hash(batch)) return Result<void>{};
  return fail(ErrorCode::conflict, "spool: batch " + std::to_string(batch.sequence) + " of experience " +
                                       to_string(batch.experience) + " is pending with another hash");
}

Bytes encode(const SpoolRecord& record) {
  Bytes payload;
  append(payload, weft::encode(record.batch));
  append(payload, std::uint64_t{record.contents.size()});
  for (const auto& [hash, content] : record.contents) append(payload, *content);

  Bytes bytes(kMagic.begin(), kMagic.end());
  append(bytes, std::uint64_t{payload.size()});
  const ContentHash checksum = hash_bytes(payload);
  bytes.insert(bytes.end(), checksum.bytes.begin(), checksum.bytes.end());
  bytes.insert(bytes.end(), payload.begin(), payload.end());
  return bytes;
}

Result<SpoolRecord> decode_record(ByteView bytes) {
  if (bytes.size() < kHeaderBytes) {
    return fail(ErrorCode::corrupt, "torn: " + std::to_string(bytes.size()) + " bytes, the header alone has " +
                                        std::to_string(kHeaderBytes));
  }
  if (!std::equal(kMagic.begin(), kMagic.end() - 1, bytes.begin())) {
    return fail(ErrorCode::corrupt, "no spool record: it does not start with WEFTSPL");
  }
  const std::uint8_t version = bytes[kMagic.size() - 1];
  if (version != kMagic.back()) {
    return fail(
        version > kMagic.back() ? ErrorCode::newer : ErrorCode::corrupt,
        "spool format " + std::to_string(version) + ", this software reads format " + std::to_string(kMagic.back()));
  }
  std::uint64_t length = 0;
  Reader reader(bytes.subspan(kMagic.size()));
  reader.number(length);
  const ByteView payload = bytes.subspan(kHeaderBytes);
  if (payload.size() != length) {
    return fail(ErrorCode::corrupt, "torn: " + std::to_string(payload.size()) + " of " + std::to_string(length) +
                                        " payload bytes are there");
  }
  const ContentHash checksum = hash_bytes(payload);
  if (!std::equal(checksum.bytes.begin(), checksum.bytes.end(), bytes.begin() + kHeaderBytes - kHashBytes)) {
    return fail(ErrorCode::corrupt, "damaged: the payload has another SHA-256 than the header says");
  }
  return decode_payload(payload);
}

}  // namespace weft::storage
