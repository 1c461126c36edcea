#pragma once
#include "agents/bodies/body.hpp"
#include "agents/navigation/navigator.hpp"

namespace weft::evaluate {

/// Tells the body how the navigator wishes the next images to be exposed, as an agent does; a body that cannot be
/// told goes on as it likes.
inline void expose(agents::Body& body, const agents::Navigated& navigated) {
  if (navigated.exposes) static_cast<void>(body.expose(navigated.exposes->sensor, navigated.exposes->exposure));
}

}  // namespace weft::evaluate
