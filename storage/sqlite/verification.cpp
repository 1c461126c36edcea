#include "storage/sqlite/verification.hpp"

#include <algorithm>
#include <system_error>

#include "storage/sqlite/directory_lock.hpp"
#include "storage/sqlite/loader.hpp"

namespace weft::storage::sqlite {
namespace {

constexpr const char* kScratchEnding = ".verifying";
constexpr std::uint64_t kLeftForOthers = 64U << 20U;  ///< bytes: the live store's next commits may need them

std::string mebibytes(std::uint64_t bytes) {
  return std::to_string((bytes + (1U << 20U) - 1) >> 20U) + " MiB";
}

/// Returns whether a verification has made the folder: nobody else's is touched.
bool is_scratch(const std::filesystem::path& folder) {
  std::error_code failed;
  if (folder.extension() != kScratchEnding || !std::filesystem::is_directory(folder, failed)) return false;
  for (std::filesystem::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    const std::string name = at->path().filename().string();
    if (name != "lock" && !name.starts_with("map.sqlite")) return false;
  }
  return !failed;
}

/// Removes what a killed process has left; one that is under way holds its lock.
void sweep(const std::filesystem::path& folder) {
  std::error_code failed;
  std::vector<std::filesystem::path> left;
  for (std::filesystem::directory_iterator at(folder, failed), end; !failed && at != end; at.increment(failed)) {
    if (is_scratch(at->path())) left.push_back(at->path());
  }
  for (const std::filesystem::path& scratch : left) {
    if (const auto lock = DirectoryLock::take(scratch); lock) std::filesystem::remove_all(scratch, failed);
  }
}

class Scratch {
 public:
  explicit Scratch(std::filesystem::path folder) : folder_(std::move(folder)) {}
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const std::filesystem::path& folder() const { return folder_; }

 private:
  std::filesystem::path folder_;
};

Result<void> check_room(const std::string& what, const std::filesystem::path& file) {
  std::error_code failed;
  const std::uint64_t size = std::filesystem::file_size(file, failed);
  if (failed) return fail(ErrorCode::unavailable, what + ": cannot read it: " + failed.message());
  const auto space = std::filesystem::space(file.parent_path(), failed);
  const std::uint64_t needed = size + kLeftForOthers;
  if (failed || space.available >= needed) return {};
  return fail(ErrorCode::exhausted, what + ": a second one to look at needs " + mebibytes(needed) + " beside it, " +
                                        mebibytes(space.available) +
                                        " are free; free space on its disk, or name a file on another one");
}

Result<Stored> load_restored(const std::filesystem::path& folder, const Restored& restored,
                             const RestoreOptions& options) {
  auto database = Database::open(folder / "map.sqlite", "");
  if (!database) return fail(database.error());
  if (options.stops) database->stop_when(options.stops);
  return load(*database, restored.epoch, restored.revision);
}

void compare(const MapDigest& restored, const MapDigest& live, std::vector<std::string>& findings) {
  if (restored == live) return;
  if (restored.revision != live.revision) {
    findings.push_back("it restores to revision " + std::to_string(restored.revision.value) + ", the map is at " +
                       std::to_string(live.revision.value));
  }
  const std::string has = to_text(restored);
  const std::string should = to_text(live);
  findings.push_back(has == should ? "it restores to as many things as the map has, " + has +
                                         ", but some are others: the digests differ"
                                   : "it restores to " + has + "; the map has " + should);
}

}  // namespace

Result<Verified> verify_snapshot(const std::filesystem::path& file, const Snapshot& live,
                                 const RestoreOptions& options) {
  const std::string what = "verification of snapshot " + file.string();
  sweep(file.parent_path());
  std::filesystem::path folder = file;
  folder += kScratchEnding;
  if (std::error_code ignored; std::filesystem::exists(folder, ignored)) {
    return fail(ErrorCode::conflict, what + ": it would restore into " + folder.string() +
                                         ", which is there; move that away, or name another file");
  }
  if (auto room = check_room(what, file); !room) return fail(room.error());
  const Scratch scratch(folder);
  RestoreOptions accepting = options;
  accepting.accept_damage = true;  // it is named, all of it
  const auto restored = restore(file, scratch.folder(), accepting);
  if (!restored) return fail(restored.error().code, what + ": " + restored.error().message);
  if (options.progress) options.progress({"load and compare", 0, 1, "map"});
  const auto stored = load_restored(scratch.folder(), *restored, options);
  if (!stored) return fail(stored.error().code, what + ": " + stored.error().message);
  Verified verified{digest_of(stored->snapshot), restored->findings};
  if (verified.findings.empty()) verified.findings = stored->quarantined;
  compare(verified.restored, digest_of(live), verified.findings);
  return verified;
}

}  // namespace weft::storage::sqlite
