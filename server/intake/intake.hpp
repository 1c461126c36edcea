#pragma once
#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "core/protocol/assembly.hpp"
#include "core/protocol/messages.hpp"
#include "server/base/context.hpp"

namespace weft::server {

/// Takes experiences in. A batch waits in bounded memory until its contents have come, then both are made durable in
/// one transaction, and only then it is acknowledged. Repeats are answered like the first time.
class Intake {
 public:
  Intake(Context& context, const std::map<ExperienceId, std::uint64_t>& durable_through);

  /// Returns the batches that joined the network by this message, in order; usually none or one. `who` hands in what
  /// no robot of the fleet has seen; empty: the batch's robot does.
  std::vector<Batch> on_batch(const msg::ExperienceBatch& message, const std::string& who, Now now);
  std::vector<Batch> on_chunk(const msg::Chunk& chunk, Now now);
  /// Tries again what the store could not take.
  std::vector<Batch> tick(Now now);
  std::optional<SteadyTime> next() const { return retry_at_; }

  /// Returns what was refused for good since this was called last.
  std::vector<std::pair<Batch, Error>> take_refused() { return std::exchange(refused_batches_, {}); }

  std::uint64_t acknowledged() const { return acknowledged_; }
  std::uint64_t refused() const { return refused_; }
  std::uint64_t waiting_bytes() const { return bytes_; }

 private:
  struct Waiting {
    Batch batch;
    ContentHash hash;
    std::map<ContentHash, std::uint64_t> needs;  ///< contents that are not in the store, and their sizes
    std::uint64_t incarnation = 0;
    std::string who = {};     ///< empty: its robot
    bool is_checked = false;  ///< it would have joined when it became the next one
  };
  /// Holds a content on its way.
  struct Incoming {
    std::uint64_t size = 0;
    Assembly assembly;
    std::optional<Bytes> done = std::nullopt;
    int wanted_by = 0;
  };
  /// Holds where one experience's batches stand.
  struct ExperienceStream {
    RobotId robot;
    std::uint64_t durable_through = 0;
    std::uint64_t incarnation = 0;  ///< of the sender of the last durable batch; 0: before this start
    std::map<std::uint64_t, Waiting> waiting;
    std::optional<Error> refusal;  ///< for the next acknowledgement
    std::uint64_t refusal_of = 0;
    ContentHash last_refused;  ///< a repeat of it is refused again, and not counted again
  };

  Result<void> accept(ExperienceStream& stream, const msg::ExperienceBatch& message, const std::string& who,
                      const ContentHash& hash);
  Result<void> make_room(const std::map<ContentHash, std::uint64_t>& needs);
  std::map<ContentHash, std::uint64_t> contents_needed(const Batch& batch) const;
  void expect(const ContentHash& content, std::uint64_t size);
  bool expect_missing(Waiting& waiting);
  bool is_ready(const Waiting& waiting) const;
  std::vector<Batch> advance(ExperienceId experience, Now now);
  void drop_late_learning(Batch& batch);
  Result<void> commit(ExperienceStream& stream, const Waiting& waiting, Now now);
  void seal_abandoned(const Waiting& waiting, Now now);
  void refuse(ExperienceStream& stream, const Batch& batch, const ContentHash& hash, const Error& why, Now now);
  void refuse_waiting(ExperienceStream& stream, std::uint64_t sequence, const Error& why, Now now);
  void forget(ExperienceStream& stream, std::uint64_t sequence);
  void answer(ExperienceId experience, ExperienceStream& stream);
  std::vector<Batch> advance_and_answer(ExperienceId experience, ExperienceStream& stream, Now now);

  Context& context_;
  std::map<ExperienceId, ExperienceStream> streams_;
  std::map<ContentHash, Incoming> incoming_;
  std::uint64_t bytes_ = 0;  ///< reserved for incoming contents
  std::uint64_t acknowledged_ = 0;
  std::uint64_t refused_ = 0;
  std::vector<std::pair<Batch, Error>> refused_batches_;
  std::optional<SteadyTime> retry_at_;
};

}  // namespace weft::server
