#pragma once
#include <cstdint>
#include <map>

#include "core/protocol/messages.hpp"

namespace weft::cli {

/// Puts the parts of one answer together, by their number.
class AnswerParts {
 public:
  /// Adds a part. Returns true once all are there.
  bool add(const msg::QueryReply& part);
  /// Returns the whole answer; all parts are there.
  msg::QueryReply joined() const;

 private:
  std::uint32_t count_ = 0;
  std::map<std::uint32_t, msg::QueryReply> parts_;
};

}  // namespace weft::cli
