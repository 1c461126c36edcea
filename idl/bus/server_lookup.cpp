#include "idl/bus/server_lookup.hpp"

#include <atomic>
#include <thread>
#include <utility>

namespace weft::bus {

struct ServerLookup::Question {
  std::optional<std::vector<ServerAddress>> servers;  ///< the thread's until `is_over`
  std::atomic<bool> is_over = false;
};

void ServerLookup::ask() {
  if (open_ != nullptr) return;
  open_ = std::make_shared<Question>();
  std::thread([question = open_, config = config_] {
    if (auto found = server_addresses(config)) question->servers = std::move(*found);
    question->is_over = true;
  }).detach();
}

std::optional<std::vector<ServerAddress>> ServerLookup::answer() {
  if (open_ == nullptr || !open_->is_over) return std::nullopt;
  return std::exchange(open_, nullptr)->servers;
}

}  // namespace weft::bus
