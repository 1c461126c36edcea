#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "idl/bus/addresses.hpp"

namespace weft::bus {

/// Asks where the servers are without waiting for the answer. A resolver that is not reached answers after many
/// seconds, so each question has a thread that nobody waits for: it shares nothing with us but the answer's place.
class ServerLookup {
 public:
  explicit ServerLookup(BusConfig config) : config_(std::move(config)) {}
  /// Begins to ask, unless the last question is still open.
  void ask();
  /// Returns the addresses, if the resolver has found them since the last call; none: no answer, or an error.
  std::optional<std::vector<ServerAddress>> answer();

 private:
  struct Question;
  BusConfig config_;
  std::shared_ptr<Question> open_;
};

}  // namespace weft::bus
