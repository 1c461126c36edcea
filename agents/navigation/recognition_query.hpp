#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "agents/methods/method.hpp"
#include "agents/navigation/navigator.hpp"
#include "core/geometry/pose2.hpp"

namespace weft::agents {

/// Keeps the question that a robot that looks for itself has open, if any. A value, pure.
class RecognitionQuery {
 public:
  void advance(const Step& step);
  /// Forgets what was asked before; numbers go on.
  void forget();

  /// Returns whether what is seen now is to be signed and asked about: nothing has been asked, the robot stands
  /// elsewhere by now and is not about to be answered, or it has stood for long with nothing to try.
  bool is_due(bool has_places_to_try) const;
  void ask(Signature seen, std::string_view method, std::uint32_t content_format);
  /// Asks on, as what was proposed was in vain: the same signature again, for the places behind those.
  void ask_on();
  /// Takes note of an answer. Returns false when that question is not open.
  bool answered(std::uint64_t number, std::size_t places);

  /// Returns whether the answer had places, so that there may be more.
  bool may_go_on() const { return asked_ && !is_open_ && last_answer_ > 0; }
  /// Returns whether the answer came some time ago, so that places of it which have not arrived never will.
  bool is_stale() const;
  const Question* open() const { return asked_ && is_open_ ? &*asked_ : nullptr; }

 private:
  std::uint64_t number_ = 0;
  std::optional<Question> asked_;
  bool is_open_ = false;
  std::size_t last_answer_ = 0;  // places
  Pose2 asked_from_robot_;
  std::uint32_t samples_ = 0;  // since it was asked, or answered
};

}  // namespace weft::agents
