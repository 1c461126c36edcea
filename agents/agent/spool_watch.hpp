#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/time.hpp"
#include "storage/spool.hpp"

namespace weft::agents {

/// Passes everything on to a spool, and knows whether its disk takes what it is given. Once it does not, a trial of
/// room shows when it does again: nobody has to teach for that.
class SpoolWatch final : public storage::Spool {
 public:
  /// Watches a spool that outlives this.
  explicit SpoolWatch(storage::Spool& spool) : spool_(spool) {}

  /// Returns why the disk has refused the last write; empty: it took it, or has room for it by now.
  const std::string& refuses() const { return refuses_; }
  /// Tries again whether there is room for what was refused, when it is time.
  void tick(SteadyTime now);
  /// Returns when the next trial is due; none: the spool works.
  std::optional<SteadyTime> next() const { return try_at_; }

  Result<void> append(const Batch& batch, const std::vector<Bytes>& contents) override;
  Result<void> replace(ExperienceId experience, const std::vector<Batch>& batches,
                       const std::vector<Bytes>& contents) override;
  Result<void> acknowledged(ExperienceId experience, std::uint64_t through) override;
  Result<void> keep(const storage::Stops& stops) override;
  Result<void> try_room(std::uint64_t bytes) override { return noted(spool_.try_room(bytes), bytes); }
  Result<std::vector<Batch>> pending() const override { return spool_.pending(); }
  Result<Bytes> content(const ContentHash& hash) const override { return spool_.content(hash); }
  storage::Stops stops() const override { return spool_.stops(); }
  std::vector<std::string> skipped() const override { return spool_.skipped(); }
  std::optional<std::uint64_t> free_bytes() const override { return spool_.free_bytes(); }

 private:
  /// Takes note of a write of about so many bytes, and gives its result back.
  Result<void> noted(Result<void> done, std::uint64_t bytes);

  storage::Spool& spool_;
  std::string refuses_;
  std::uint64_t needs_ = 0;  // bytes of the largest write that was refused
  std::optional<SteadyTime> try_at_;
};

}  // namespace weft::agents
