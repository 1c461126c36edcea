#pragma once
#include <cstdint>
#include <optional>

#include "agents/agent/budget.hpp"
#include "agents/agent/outbox.hpp"
#include "agents/agent/spooler.hpp"
#include "core/result.hpp"
#include "core/time.hpp"

namespace weft::agents {

/// Sends what is spooled: batches at once, their contents within a budget.
class Upload {
 public:
  Upload(Spooler& spooler, std::uint64_t bytes_per_second, SteadyTime now);

  /// Sends the batches whose time has come. Errors of the spool: some of what was taught will never arrive.
  Result<void> send_batches(Outbox& outbox, SteadyTime now);
  /// Sends chunks of contents as far as the budget goes.
  void send_chunks(Outbox& outbox, SteadyTime now);
  std::optional<SteadyTime> next() const;

 private:
  Spooler& spooler_;
  Budget budget_;
};

}  // namespace weft::agents
