#pragma once
#include <cstddef>
#include <optional>

#include "agents/methods/method.hpp"
#include "agents/methods/recognition/index.hpp"
#include "agents/navigation/navigator.hpp"
#include "clients/evaluate/taught_map.hpp"
#include "core/result.hpp"

namespace weft::evaluate {

/// Proposes places to navigators in the server's stead, at once, by the signatures of a network's places.
class SignedPlaces {
 public:
  /// Signs all places of the map, as the server does. corrupt: a content that the method cannot read.
  template <agents::Method M>
  Result<void> learn(const M& method, const TaughtMap& map) {
    known_ = {};
    for (const auto& [id, place] : map.view().window.places) {
      const auto content = method.decode(*map.find(place.content.hash));
      if (!content) return fail(content.error());
      if (const std::optional<agents::Signature> signature = method.sign(*content)) known_.put(id, *signature);
    }
    return {};
  }

  /// Answers what the navigator asks, if it does.
  void answer(agents::Navigator& navigator, const TaughtMap& map) const {
    constexpr std::size_t most = 64;
    const agents::Question* const open = navigator.question();
    if (open == nullptr || !known_.fits(open->seen)) return;
    navigator.propose(open->number,
                      agents::likeliest(known_, map.snapshot(), open->seen, {.most = most, .after = open->after}));
  }

 private:
  agents::RecognitionIndex known_;
};

}  // namespace weft::evaluate
