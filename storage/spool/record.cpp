#include "storage/spool/record.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>

#include "core/byte_reader.hpp"
#include "core/byte_writer.hpp"
#include "core/network/codec.hpp"

namespace weft::storage {
namespace {

constexpr std::array<std::uint8_t, 7> kMagic{'W', 'E', 'F', 'T', 'S', 'P', 'L'};
constexpr std::uint8_t kFormat = 1;
constexpr std::size_t kHeaderBytes = kMagic.size() + 1 + 8 + sizeof(ContentHash::bytes);

ByteView bytes_of(const std::string& text) {
  return {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()};
}

Result<SpoolRecord> decode_payload(ByteView payload) {
  ByteReader in(payload);
  const std::string batch_bytes = in.text("batch");
  std::map<ContentHash, SharedBytes> contents;
  for (std::size_t left = in.count("contents", 4); left > 0; --left) {
    const std::string content = in.text("content");
    contents.emplace(hash_bytes(bytes_of(content)), std::make_shared<const Bytes>(content.begin(), content.end()));
  }
  if (auto end = in.finish("spool record"); !end) return fail(end.error());
  auto batch = decode_batch(bytes_of(batch_bytes));
  if (!batch) return fail(batch.error());
  return SpoolRecord{std::move(*batch), std::move(contents)};
}

}  // namespace

Result<SpoolRecord> make_record(const Batch& batch, const std::vector<Bytes>& contents,
                                const std::function<SharedBytes(const ContentHash&)>& held) {
  SpoolRecord record{batch, {}};
  for (const Bytes& content : contents) {
    record.contents.emplace(hash_bytes(content), std::make_shared<const Bytes>(content));
  }
  const Place* missing = nullptr;
  for_each_place(batch, [&](const Place& place) {
    if (record.contents.contains(place.content.hash)) return;
    if (SharedBytes earlier = held(place.content.hash)) {
      record.contents.emplace(place.content.hash, std::move(earlier));
    } else {
      missing = &place;
    }
  });
  if (missing == nullptr) return record;
  return fail(ErrorCode::invalid, "spool: batch " + std::to_string(batch.sequence) + " of experience " +
                                      to_string(batch.experience) + ": content " + to_string(missing->content.hash) +
                                      " of place " + to_string(missing->id) + " is neither given nor held");
}

Result<std::vector<SpoolRecord>> make_records(ExperienceId experience, const std::vector<Batch>& batches,
                                              const std::vector<Bytes>& contents,
                                              const std::function<SharedBytes(const ContentHash&)>& held) {
  const std::string of = "spool: to replace experience " + to_string(experience) + ": ";
  if (batches.empty()) return fail(ErrorCode::invalid, of + "no batch is given");
  std::map<ContentHash, SharedBytes> given;
  for (const Bytes& content : contents) given.emplace(hash_bytes(content), std::make_shared<const Bytes>(content));
  const auto find = [&](const ContentHash& hash) {
    const auto found = given.find(hash);
    return found == given.end() ? held(hash) : found->second;
  };
  std::set<std::uint64_t> sequences;
  std::vector<SpoolRecord> records;
  for (const Batch& batch : batches) {
    if (batch.experience != experience)
      return fail(ErrorCode::invalid, of + "a batch is of experience " + to_string(batch.experience));
    if (!sequences.insert(batch.sequence).second)
      return fail(ErrorCode::invalid, of + "two batches have the sequence " + std::to_string(batch.sequence));
    auto record = make_record(batch, {}, find);
    if (!record) return fail(record.error());
    records.push_back(*std::move(record));
  }
  return records;
}

std::optional<Result<void>> compare(const Batch& pending, const Batch& batch) {
  if (pending.experience != batch.experience || pending.sequence != batch.sequence) return std::nullopt;
  if (hash(pending) == hash(batch)) return Result<void>{};
  return fail(ErrorCode::conflict, "spool: batch " + std::to_string(batch.sequence) + " of experience " +
                                       to_string(batch.experience) + " is pending with another hash");
}

tl::unexpected<Error> none_pending(ExperienceId experience) {
  return fail(ErrorCode::not_found, "spool: no batch of experience " + to_string(experience) + " is pending");
}

Bytes encode(const SpoolRecord& record) {
  const Bytes batch = weft::encode(record.batch);
  ByteWriter payload;
  payload.count(batch.size());
  payload.raw(batch);
  payload.count(record.contents.size());
  for (const auto& [hash, content] : record.contents) {
    payload.count(content->size());
    payload.raw(*content);
  }
  ByteWriter out;
  out.raw(kMagic);
  out.number(kFormat);
  out.number(std::uint64_t{payload.view().size()});
  out.id(hash_bytes(payload.view()));
  out.raw(payload.view());
  return out.take();
}

Result<SpoolRecord> decode_record(ByteView bytes) {
  if (bytes.size() < kHeaderBytes) {
    return fail(ErrorCode::corrupt, "torn: " + std::to_string(bytes.size()) + " bytes, the header alone has " +
                                        std::to_string(kHeaderBytes));
  }
  if (!std::equal(kMagic.begin(), kMagic.end(), bytes.begin())) {
    return fail(ErrorCode::corrupt, "no spool record: it does not start with WEFTSPL");
  }
  ByteReader in(bytes.subspan(kMagic.size()));
  const auto format = in.number<std::uint8_t>("format");
  if (format != kFormat) {
    return fail(format > kFormat ? ErrorCode::newer : ErrorCode::corrupt,
                "spool format " + std::to_string(format) + ", this software reads format " + std::to_string(kFormat));
  }
  const auto length = in.number<std::uint64_t>("length");
  const auto checksum = in.id<ContentHash>("checksum");
  const ByteView payload = bytes.subspan(kHeaderBytes);
  if (payload.size() != length) {
    return fail(ErrorCode::corrupt, "torn: " + std::to_string(payload.size()) + " of " + std::to_string(length) +
                                        " payload bytes are there");
  }
  if (hash_bytes(payload) != checksum) {
    return fail(ErrorCode::corrupt, "damaged: the payload has another SHA-256 than the header says");
  }
  return decode_payload(payload);
}

}  // namespace weft::storage
