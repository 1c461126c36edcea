#pragma once
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/bytes.hpp"
#include "core/network/change.hpp"
#include "core/result.hpp"

namespace weft::storage {

using SharedBytes = std::shared_ptr<const Bytes>;

/// Holds a batch and every content that it cannot be delivered without.
struct SpoolRecord {
  Batch batch;
  std::map<ContentHash, SharedBytes> contents;
};

/// Makes the record of a batch: contents that are given, and those that an earlier record holds (`held` gives none
/// when it has not). invalid: a place's content is in neither.
Result<SpoolRecord> make_record(const Batch& batch, const std::vector<Bytes>& contents,
                                const std::function<SharedBytes(const ContentHash&)>& held);

/// Makes the records of batches that are to take the place of all others of the experience, as `Spool::replace` says;
/// each is given of `contents` what it needs.
Result<std::vector<SpoolRecord>> make_records(ExperienceId experience, const std::vector<Batch>& batches,
                                              const std::vector<Bytes>& contents,
                                              const std::function<SharedBytes(const ContentHash&)>& held);

/// Compares `batch`, about to be appended, with a pending one: none when they have different keys, success when it is
/// a repeat, conflict when the same sequence holds something else.
std::optional<Result<void>> compare(const Batch& pending, const Batch& batch);

/// Returns that nothing of the experience is pending.
tl::unexpected<Error> none_pending(ExperienceId experience);

/// Returns the record's bytes on disk, docs/formats/spool.md.
Bytes encode(const SpoolRecord& record);
/// Reads a record's bytes. newer: another format version. corrupt: torn, damaged or trailing; says at which offset.
Result<SpoolRecord> decode_record(ByteView bytes);

}  // namespace weft::storage
