#include "storage/spool/file_spool.hpp"

#include <algorithm>
#include <map>
#include <string_view>
#include <system_error>

#include "core/network/codec.hpp"
#include "storage/spool/durable_file.hpp"
#include "storage/spool/file_names.hpp"
#include "storage/spool/record.hpp"
#include "storage/spool/replacement.hpp"
#include "storage/spool/stops_file.hpp"

namespace weft::storage {
namespace {

constexpr std::string_view kStops = "stops";
constexpr std::string_view kTrial = "trial.tmp";  ///< of room; recovery removes what ends so

class FileSpool final : public Spool {
 public:
  explicit FileSpool(std::filesystem::path directory) : directory_(std::move(directory)) {}

  /// Reads what is there; removes what an interrupted append left.
  Result<void> recover() {
    std::error_code failed;
    std::filesystem::create_directories(directory_, failed);
    if (failed) return fail(ErrorCode::unavailable, directory_.string() + ": cannot make it: " + failed.message());
    if (auto done = finish_replacement(); !done) return done;
    std::vector<std::uint64_t> orders;
    for (const auto& entry : std::filesystem::directory_iterator(directory_, failed)) {
      const std::string name = entry.path().filename().string();
      if (name.ends_with(".tmp") || number_of(name, kStagedEnding)) {
        if (auto done = remove_durably(entry.path()); !done) return done;
      } else if (const auto order = number_of(name, kBatchEnding)) {
        orders.push_back(*order);
      }
    }
    if (failed) return fail(ErrorCode::unavailable, directory_.string() + ": cannot read it: " + failed.message());
    std::sort(orders.begin(), orders.end());
    for (const std::uint64_t order : orders) {
      if (auto done = recover_file(order); !done) return done;
      next_ = order + 1;
    }
    return recover_stops();
  }

  Result<void> append(const Batch& batch, const std::vector<Bytes>& contents) override {
    for (const auto& [order, kept] : kept_) {
      if (auto repeat = compare(kept.batch, batch)) return *repeat;
    }
    auto record = make_record(batch, contents, [&](const ContentHash& hash) { return held(hash); });
    if (!record) return fail(record.error());
    const std::uint64_t order = next_++;  // also after a failure: a name is used once
    if (auto done = write_durably(path_of(order), encode(*record)); !done) return done;
    keep(order, *record);
    return {};
  }

  Result<void> replace(ExperienceId experience, const std::vector<Batch>& batches,
                       const std::vector<Bytes>& contents) override {
    if (auto done = finish_replacement(); !done) return done;  // one that the disk has kept from its end
    Replacement replacement;
    for (const auto& [order, kept] : kept_)
      if (kept.batch.experience == experience) replacement.removed.push_back(order);
    if (replacement.removed.empty()) return none_pending(experience);
    auto records = make_records(experience, batches, contents, [&](const ContentHash& hash) { return held(hash); });
    if (!records) return fail(records.error());
    for (std::size_t i = 0; i < records->size(); ++i) replacement.added.push_back(next_++);
    if (auto staged = stage(replacement, *records); !staged) {
      for (const std::uint64_t order : replacement.added)
        (void)remove_durably(directory_ / numbered(order, kStagedEnding));  // else at the next start
      return staged;
    }
    // It is decided: whatever comes between, the next start goes on with it.
    for (const std::uint64_t order : replacement.removed) kept_.erase(order);
    for (std::size_t i = 0; i < records->size(); ++i) keep(replacement.added[i], (*records)[i]);
    return carry_out(directory_, replacement);
  }

  Result<std::vector<Batch>> pending() const override {
    std::vector<Batch> batches;
    batches.reserve(kept_.size());
    for (const auto& [order, kept] : kept_) batches.push_back(kept.batch);
    return batches;
  }

  Result<Bytes> content(const ContentHash& hash) const override {
    const auto holder = std::find_if(kept_.begin(), kept_.end(), [&](const auto& entry) {
      return std::binary_search(entry.second.contents.begin(), entry.second.contents.end(), hash);
    });
    if (holder == kept_.end())
      return fail(ErrorCode::not_found, "spool: content " + to_string(hash) + " is not held");
    auto bytes = read_batch(holder->first);
    if (!bytes) return fail(bytes.error());
    auto record = decode_record(*bytes);
    if (!record) return fail(ErrorCode::corrupt, path_of(holder->first).string() + ": " + record.error().message);
    const auto found = record->contents.find(hash);
    if (found == record->contents.end()) {
      return fail(ErrorCode::corrupt, path_of(holder->first).string() + ": content " + to_string(hash) + " is gone");
    }
    return *found->second;
  }

  Result<void> acknowledged(ExperienceId experience, std::uint64_t through) override {
    for (auto at = kept_.begin(); at != kept_.end();) {
      const Batch& batch = at->second.batch;
      if (batch.experience == experience && batch.sequence <= through) {
        if (auto done = remove_durably(path_of(at->first)); !done) return done;
        at = kept_.erase(at);
      } else {
        ++at;
      }
    }
    return {};
  }

  Result<void> keep(const Stops& stops) override {
    if (stops == stops_ && !are_stops_damaged_) return {};
    const std::filesystem::path path = directory_ / kStops;
    auto done = stops == Stops{} ? remove_durably(path) : write_durably(path, encode(stops));
    if (!done) return done;
    stops_ = stops;
    are_stops_damaged_ = false;
    return {};
  }

  Stops stops() const override { return stops_; }

  Result<void> try_room(std::uint64_t bytes) override {
    const std::filesystem::path path = directory_ / kTrial;
    const Result<void> written = write_durably(path, Bytes(bytes));
    const Result<void> removed = remove_durably(path);
    return written ? removed : written;
  }

  std::vector<std::string> skipped() const override { return skipped_; }

  std::optional<std::uint64_t> free_bytes() const override {
    std::error_code unknown;
    const auto space = std::filesystem::space(directory_, unknown);
    return unknown ? std::nullopt : std::optional<std::uint64_t>(space.available);
  }

 private:
  struct Kept {
    Batch batch;
    std::vector<ContentHash> contents;  ///< sorted; their bytes stay in the file
  };

  std::filesystem::path path_of(std::uint64_t order) const { return directory_ / numbered(order, kBatchEnding); }

  /// Reads the file of a batch, which still has its staged name where a replacement was decided and not carried out.
  Result<Bytes> read_batch(std::uint64_t order) const {
    const std::filesystem::path staged = directory_ / numbered(order, kStagedEnding);
    std::error_code failed;
    return read_whole(std::filesystem::exists(staged, failed) ? staged : path_of(order));
  }

  SharedBytes held(const ContentHash& hash) const {
    Result<Bytes> bytes = content(hash);
    return bytes ? std::make_shared<const Bytes>(std::move(*bytes)) : nullptr;
  }

  /// Writes the files that are to be added beside the others, then the one that decides for them.
  Result<void> stage(const Replacement& replacement, const std::vector<SpoolRecord>& records) {
    std::vector<std::filesystem::path> staged;
    for (std::size_t i = 0; i < records.size(); ++i) {
      staged.push_back(directory_ / numbered(replacement.added[i], kStagedEnding));
      if (auto done = write_for_now(staged.back(), encode(records[i])); !done) return done;
    }
    if (auto done = make_durable(directory_, staged); !done) return done;
    return write_durably(directory_ / kReplacementFile, encode(replacement));
  }

  /// Carries out a replacement that was decided and interrupted.
  Result<void> finish_replacement() {
    const std::filesystem::path path = directory_ / kReplacementFile;
    if (std::error_code failed; !std::filesystem::exists(path, failed) && !failed) return {};
    auto bytes = read_whole(path);
    if (!bytes) return fail(bytes.error());
    const auto replacement = decode_replacement(*bytes);
    if (!replacement) {
      return fail(replacement.error().code, path.string() + ": " + replacement.error().message +
                                                "; remove it to keep the run as it was before it was refined");
    }
    return carry_out(directory_, *replacement);
  }

  void keep(std::uint64_t order, const SpoolRecord& record) {
    Kept kept{record.batch, {}};
    kept.contents.reserve(record.contents.size());
    for (const auto& [hash, bytes] : record.contents) kept.contents.push_back(hash);
    kept_.emplace(order, std::move(kept));
  }

  Result<void> recover_file(std::uint64_t order) {
    const std::filesystem::path path = path_of(order);
    auto bytes = read_whole(path);
    if (!bytes) return fail(bytes.error());
    auto record = decode_record(*bytes);
    if (record) {
      keep(order, *record);
    } else if (record.error().code == ErrorCode::newer) {
      return fail(ErrorCode::newer,
                  path.string() + ": " + record.error().message + "; start a newer weft-agent on it");
    } else {
      skipped_.push_back(path.string() + ": " + record.error().message);
    }
    return {};
  }

  Result<void> recover_stops() {
    const std::filesystem::path path = directory_ / kStops;
    if (std::error_code failed; !std::filesystem::exists(path, failed) && !failed) return {};
    auto bytes = read_whole(path);
    if (!bytes) return fail(bytes.error());
    if (const auto stops = decode_stops(*bytes)) {
      stops_ = *stops;
      return {};
    } else {
      skipped_.push_back(path.string() + ": " + stops.error().message + "; the robot stands until it is resumed");
    }
    stops_ = {.by_operator = true, .by_emergency_stop = true};
    are_stops_damaged_ = true;
    return {};
  }

  std::filesystem::path directory_;
  Stops stops_;
  bool are_stops_damaged_ = false;
  std::map<std::uint64_t, Kept> kept_;  ///< by order of appending
  std::uint64_t next_ = 1;
  std::vector<std::string> skipped_;
};

}  // namespace

Result<std::unique_ptr<Spool>> open_file_spool(const std::filesystem::path& directory) {
  auto spool = std::make_unique<FileSpool>(directory);
  if (auto done = spool->recover(); !done) return fail(done.error());
  return spool;
}

}  // namespace weft::storage
