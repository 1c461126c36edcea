#pragma once
#include <functional>
#include <ostream>
#include <set>
#include <string>

#include "core/protocol/messages.hpp"
#include "core/time.hpp"

namespace weft::cli {

/// Shows how far long work is, a line now and then, and what it has found as soon as that is known.
class ProgressLine {
 public:
  ProgressLine(std::ostream& out, std::function<SteadyTime()> now);

  void show(const msg::OperatorReply& reply);
  /// Shows the findings of the last reply that were not shown on the way.
  void rest(const msg::OperatorReply& reply);

 private:
  std::ostream& out_;
  std::function<SteadyTime()> now_;
  SteadyTime began_;
  SteadyTime said_;
  std::set<std::string> found_;
};

}  // namespace weft::cli
