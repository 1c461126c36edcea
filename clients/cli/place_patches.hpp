#pragma once
#include <map>
#include <string>
#include <vector>

#include "agents/perception/birds_eye.hpp"
#include "core/network/window.hpp"
#include "core/result.hpp"

namespace weft::cli {

/// Collects the patches of a network's places: which contents have one, and what they show once the contents are
/// there. The methods say so themselves (agents/methods/all.hpp).
class PlacePatches {
 public:
  explicit PlacePatches(const Window& network);

  /// Returns the contents of places that may have a patch. refused: no place was made by a method whose contents have
  /// one; names them.
  Result<std::vector<ContentRef>> wanted() const;

  /// Takes a content's patch. corrupt, newer: the content cannot be read.
  Result<void> take(const ContentHash& hash, ByteView bytes);

  /// Returns the patch of a place's content; null: it has none, or an empty one.
  const agents::PlanePatch* find(const Place& place) const;
  /// Returns how many places have a patch.
  std::size_t count() const;

 private:
  const Window& network_;
  std::map<ContentHash, std::string> method_of_;  ///< of contents that may have a patch
  std::map<ContentHash, agents::PlanePatch> patches_;
};

}  // namespace weft::cli
