#include "tests/crashes/producer.hpp"

#include "tests/crashes/deliveries.hpp"
#include "tests/crashes/wire.hpp"

namespace weft::crashes {

void produce(std::uint64_t seed, std::uint32_t producer, std::uint64_t first, int keeper, int watcher) {
  for (std::uint64_t sequence = first;; ++sequence) {
    Answer answer;
    if (!send_delivery(keeper, delivery_of(seed, producer, sequence)) || !receive(keeper, answer)) return;
    if (answer.sequence < sequence) return;
    if (!send(watcher, Report{Report::Kind::acknowledged, producer, sequence, answer.revision})) return;
  }
}

}  // namespace weft::crashes
