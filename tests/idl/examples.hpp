#pragma once
#include <string>
#include <vector>

#include "core/protocol/messages.hpp"

namespace weft::bus {

/// Holds one message of each type, every field filled with a value of its own, and who sends it.
struct Example {
  std::string name;  ///< of its golden file
  msg::Role sender = msg::Role::server;
  msg::Message message;
};
std::vector<Example> examples();

/// Returns the peer that addressed examples are for.
PeerId example_addressee();

}  // namespace weft::bus
