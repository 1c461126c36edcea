#pragma once
#include <cstddef>
#include <map>
#include <set>
#include <vector>

#include "core/protocol/messages.hpp"
#include "core/time.hpp"

namespace weft::cli {

/// Hands experiences to the server's intake as an agent does: a few batches at a time, contents when they are asked
/// for, everything again until it is acknowledged. One experience after the other, because later ones may join
/// earlier ones. Pure: it is told the time and says what to send.
class Uploader {
 public:
  /// Makes an uploader. Batches stand in the order of their experiences, each experience's in order of sequence;
  /// chunks of contents have up to msg::kChunkBytes each.
  Uploader(const std::vector<Batch>& batches, const std::map<ContentHash, Bytes>& contents);

  /// Returns what is to be sent now; headers are the caller's.
  std::vector<msg::Message> due(SteadyTime now);
  /// Takes an acknowledgement. refused: the server will not have a batch; the message has its words.
  Result<void> hear(const msg::BatchAck& ack);
  bool done() const { return next_ == batches_.size(); }
  std::size_t acknowledged() const { return next_; }

 private:
  std::size_t end_of_experience() const;

  const std::vector<Batch>& batches_;
  const std::map<ContentHash, Bytes>& contents_;
  std::size_t next_ = 0;  ///< the first batch that is not acknowledged
  std::size_t sent_ = 0;  ///< the first one that was not sent since the last repeat
  SteadyTime repeat_at_{};
  bool progressed_ = false;
  std::vector<ContentHash> wanted_;
  std::set<ContentHash> answered_;  ///< wanted contents that went out since the last repeat
};

}  // namespace weft::cli
