#include "storage/spool/memory_spool.hpp"

#include <algorithm>
#include <iterator>

namespace weft::storage {
namespace {

SharedBytes find_content(const SpoolDisk& disk, const ContentHash& hash) {
  for (const SpoolRecord& record : disk.records) {
    const auto found = record.contents.find(hash);
    if (found != record.contents.end()) return found->second;
  }
  return nullptr;
}

class MemorySpool final : public Spool {
 public:
  explicit MemorySpool(std::shared_ptr<SpoolDisk> disk) : disk_(std::move(disk)) {}

  Result<void> append(const Batch& batch, const std::vector<Bytes>& contents) override {
    for (const SpoolRecord& record : disk_->records) {
      if (auto repeat = compare(record.batch, batch)) return *repeat;
    }
    auto record = make_record(batch, contents, [&](const ContentHash& hash) { return find_content(*disk_, hash); });
    if (!record) return fail(record.error());
    if (auto error = disk_->faults.strike("memory spool")) return fail(std::move(*error));
    disk_->records.push_back(std::move(*record));
    return {};
  }

  Result<void> replace(ExperienceId experience, const std::vector<Batch>& batches,
                       const std::vector<Bytes>& contents) override {
    const auto is_of_it = [&](const SpoolRecord& record) { return record.batch.experience == experience; };
    if (std::ranges::none_of(disk_->records, is_of_it)) return none_pending(experience);
    auto records = make_records(experience, batches, contents,
                                [&](const ContentHash& hash) { return find_content(*disk_, hash); });
    if (!records) return fail(records.error());
    if (auto error = disk_->faults.strike("memory spool")) return fail(std::move(*error));
    std::erase_if(disk_->records, is_of_it);
    std::ranges::move(*records, std::back_inserter(disk_->records));
    return {};
  }

  Result<std::vector<Batch>> pending() const override {
    std::vector<Batch> batches;
    batches.reserve(disk_->records.size());
    for (const SpoolRecord& record : disk_->records) batches.push_back(record.batch);
    return batches;
  }

  Result<Bytes> content(const ContentHash& hash) const override {
    const SharedBytes found = find_content(*disk_, hash);
    if (found == nullptr) return fail(ErrorCode::not_found, "spool: content " + to_string(hash) + " is not held");
    return *found;
  }

  Result<void> acknowledged(ExperienceId experience, std::uint64_t through) override {
    std::erase_if(disk_->records, [&](const SpoolRecord& record) {
      return record.batch.experience == experience && record.batch.sequence <= through;
    });
    return {};
  }

  Result<void> keep(const Stops& stops) override {
    if (auto error = disk_->faults.strike("memory spool")) return fail(std::move(*error));
    disk_->stops = stops;
    return {};
  }
  Stops stops() const override { return disk_->stops; }
  Result<void> try_room(std::uint64_t /*bytes*/) override {
    if (auto error = disk_->faults.strike("memory spool")) return fail(std::move(*error));
    return {};
  }
  std::optional<std::uint64_t> free_bytes() const override { return std::nullopt; }

 private:
  std::shared_ptr<SpoolDisk> disk_;
};

}  // namespace

std::unique_ptr<Spool> make_memory_spool(std::shared_ptr<SpoolDisk> disk) {
  return std::make_unique<MemorySpool>(std::move(disk));
}

}  // namespace weft::storage
