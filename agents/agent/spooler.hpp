#pragma once
#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "agents/agent/agent.hpp"
#include "agents/agent/chunks.hpp"
#include "agents/navigation/navigator.hpp"
#include "agents/navigation/run_refiner.hpp"
#include "core/protocol/messages.hpp"
#include "core/result.hpp"
#include "core/time.hpp"
#include "storage/spool.hpp"

namespace weft::agents {

struct SpoolerConfig {
  std::size_t batch_places = 5;                   ///< a batch is closed at this many places
  Duration batch_age = std::chrono::seconds(2);   ///< or when its first place is this old
  Duration retry = std::chrono::seconds(1);       ///< first repeat of a batch that is not acknowledged; doubles
  Duration retry_most = std::chrono::seconds(8);  ///< up to this
  std::size_t in_flight = 8;                      ///< most batches sent and not acknowledged
};

/// Ends the reason of a seal until the run is refined: it is read where this agent ended before, or its disk did not
/// take the refined run.
inline constexpr const char* kUnrefinedSeal = ", handed in before it was refined";

/// Takes what teaching keeps to the server. A batch is in the robot's own spool before it is sent, and is sent again
/// until the server has it on disk. The last batch of an experience that is not sealed stays in the spool even when
/// acknowledged, so that a restarted agent knows which experience it has to seal. A batch with an edge to a place of
/// another experience that is under way is spooled after it, and sent when the server has it. An experience may be
/// held back until it is refined: its batches are spooled as usual, and none is sent. On disk only the seal shows
/// this: it is spooled with the reason that will be true if this agent ends before the run is refined, so that a
/// restarted agent hands in the run as it is.
class Spooler {
 public:
  /// Reads what is pending; experiences that a crash left open are sealed. Errors of the spool are passed on.
  static Result<Spooler> open(storage::Spool& spool, const SpoolerConfig& config, RobotId self, SteadyTime now);

  void begin(ExperienceId experience, const std::string& name);
  /// Holds an experience back that has just begun.
  void hold(ExperienceId experience) { held_.emplace(experience, std::string()); }
  bool is_held(ExperienceId experience) const { return held_.contains(experience); }
  /// Holds it back no longer: it is handed in as it is.
  void release(ExperienceId experience) { held_.erase(experience); }
  /// Puts the refined run in the place of a held and sealed one, and releases it. conflict: it is not held, or not
  /// sealed. Other errors: of the amendments or the spool; it is released as it is in the spool.
  Result<void> hand_in(ExperienceId experience, RunAmendments amendments);
  /// Adds a kept place to its experience. conflict: that is not open. exhausted and other errors of the spool: that
  /// experience ends before this batch, and is sealed as soon as the spool takes that; the caller stops teaching.
  Result<void> add(const Kept& kept, SteadyTime now);
  /// Adds an edge to the experience of its second place, for its next batch; where that is not open it is dropped.
  void add(const Edge& edge);
  /// Hands in places of the map as they are known better, with their contents, at most kBatchPlaces: one batch, in
  /// the spool when this returns. All of them until the agent ends are of one experience without places of its own;
  /// `fresh` is its id when there is none yet. Errors of the spool: nothing of it is handed in.
  Result<void> learned(std::vector<Place> places, std::vector<Bytes> contents, ExperienceId fresh, SteadyTime now);
  /// Closes the batches under way, so that their places are in the spool when this returns.
  Result<void> flush(SteadyTime now);
  /// Closes every experience that is open. One without any place leaves no trace.
  Result<void> seal(const std::string& reason, SteadyTime now);

  struct Heard {
    bool refused = false;         ///< of an experience being taught: teaching is over
    bool learned_places = false;  ///< what was refused is what was learned of places, no place
    std::string reason;           ///< of any refusal
    std::vector<AckRecord> acknowledged;
  };
  Heard on_ack(const msg::BatchAck& ack, SteadyTime now);
  /// Queues (the rest of) a content that the server asks for.
  void on_request(const msg::ContentRequest& request, SteadyTime now);
  /// Sends again whatever was under way to the old server.
  void server_restarted(SteadyTime now);

  /// Closes an old batch, and gives the batches whose time to be sent has come.
  Result<std::vector<Batch>> due(SteadyTime now);
  Result<std::optional<msg::Chunk>> next_chunk(Budget& budget, SteadyTime now);
  bool has_chunks() const { return !chunks_.empty(); }
  std::optional<SteadyTime> next() const;

  /// Returns the newest place of that experience of this robot's that the server is known to have.
  std::optional<PlaceId> newest_durable(ExperienceId experience) const;
  /// Returns whether anything of the experience is still to be acknowledged.
  bool is_pending(ExperienceId experience) const;
  /// Returns how many batches are spooled and not acknowledged.
  std::size_t pending() const { return pending_.size(); }
  std::optional<std::uint64_t> free_bytes() const { return spool_->free_bytes(); }

 private:
  struct Open {
    Batch batch;  ///< under way
    std::vector<Bytes> contents;
    SteadyTime since;
    std::uint32_t places = 0;  ///< of the experience so far
  };
  struct Pending {
    Batch batch;
    SteadyTime send_at;
    Duration wait{};
    bool contents_queued = false;
  };

  Spooler(storage::Spool& spool, const SpoolerConfig& config, RobotId self);
  Result<void> seal_what_a_crash_left_open(SteadyTime now);
  Result<void> flush(Open& open, SteadyTime now);
  Result<void> flush_what_it_names(const Batch& batch, SteadyTime now);
  Result<void> spool(Open& open, SteadyTime now);
  bool waits(const Pending& pending) const;
  void give_up(ExperienceId experience, SteadyTime now);
  void seal_cut_short(SteadyTime now);
  void queue_contents(Pending& pending, SteadyTime now);
  void drop(ExperienceId experience, std::uint64_t through);

  storage::Spool* spool_;
  SpoolerConfig config_;
  RobotId self_;
  std::map<ExperienceId, Open> open_;
  std::optional<Open> learned_places_;  ///< the experience of what is learned
  std::deque<Pending> pending_;
  std::map<ExperienceId, std::string> held_;  ///< with the reason of the seal that each gets when it is refined
  /// Holds the seals of experiences that the spool would not take more of, which it has still to take.
  std::map<ExperienceId, Batch> cut_short_;
  SteadyTime seal_at_{};                            ///< then those are tried again
  std::map<ExperienceId, std::uint64_t> unsealed_;  ///< last sequence of experiences that may still grow
  ChunkQueue chunks_;
  std::map<ExperienceId, PlaceId> newest_durable_;  ///< of those that may still grow, or did last
};

}  // namespace weft::agents
