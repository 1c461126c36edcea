#pragma once
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/bytes.hpp"
#include "core/network/change.hpp"
#include "core/result.hpp"

namespace weft::storage {

/// Tells why a robot must not go on by itself: a person has to say first that it may.
struct Stops {
  bool by_operator = false;
  bool by_emergency_stop = false;
  bool operator==(const Stops&) const = default;
};

/// Keeps a robot's own copy of what the server has not yet acknowledged, and why it stands; survives its crash.
class Spool {
 public:
  virtual ~Spool() = default;
  /// Appends a batch: durable when it returns. `contents`: the bytes of the places' contents; those that the spool
  /// holds already may be left out. The same batch again is harmless. exhausted: disk full; nothing of it is there.
  /// conflict: another batch with this sequence is pending. invalid: a place's content is neither given nor held.
  virtual Result<void> append(const Batch& batch, const std::vector<Bytes>& contents) = 0;
  /// Puts these batches in the place of all pending ones of the experience, as a whole or not at all, and durable
  /// when it returns. `contents` as for `append`. not_found: none is pending. invalid: no batch, one of another
  /// experience, two of one sequence, or a content that is neither given nor held. exhausted: the pending ones
  /// are as they were. unavailable: they are, or these are pending already and get their files at the next start;
  /// `pending` tells which.
  virtual Result<void> replace(ExperienceId experience, const std::vector<Batch>& batches,
                               const std::vector<Bytes>& contents) = 0;
  /// Returns the batches that are still to be acknowledged, oldest first; read at start.
  virtual Result<std::vector<Batch>> pending() const = 0;
  /// Returns a content's bytes. not_found; corrupt: its bytes have changed on the disk.
  virtual Result<Bytes> content(const ContentHash& hash) const = 0;
  /// Forgets batches of the experience up to `through` and contents that no other batch needs.
  virtual Result<void> acknowledged(ExperienceId experience, std::uint64_t through) = 0;
  /// Keeps why the robot must not go on by itself: durable when it returns. exhausted, unavailable: what was kept
  /// before is kept still.
  virtual Result<void> keep(const Stops& stops) = 0;
  /// Returns what was kept last; at first nothing. Damaged: both, so that a person looks.
  virtual Stops stops() const = 0;
  /// Tries whether so many bytes can be written now, durably; nothing of them stays. exhausted: disk full;
  /// unavailable.
  virtual Result<void> try_room(std::uint64_t bytes) = 0;
  /// Returns what was found torn or damaged at opening and is not among the pending, each named with its file.
  virtual std::vector<std::string> skipped() const { return {}; }
  /// Returns how many bytes its disk has left; none: not known.
  virtual std::optional<std::uint64_t> free_bytes() const = 0;
};

}  // namespace weft::storage
