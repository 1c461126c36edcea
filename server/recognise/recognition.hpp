#pragma once
#include <cstdint>
#include <deque>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "agents/methods/recognition/index.hpp"
#include "core/protocol/messages.hpp"
#include "server/base/context.hpp"
#include "server/base/signers.hpp"

namespace weft::server {

/// Tells a robot that does not know where it is which places of the whole network look like what it sees. What the
/// network's contents look like is worked out of them after each start, and as they come, a few at a time between
/// messages; searches are worked through in pieces too (docs/decisions/048-recognised-anywhere.md).
class Recognition {
 public:
  explicit Recognition(Context& context) : context_(context) {}

  void on_question(const msg::Recognise& asked, SteadyTime now);
  /// Does one bounded piece of work of each kind, if it is due.
  void tick(Now now);
  std::optional<SteadyTime> next() const;

  /// Returns how many questions wait for their answer.
  std::size_t waiting() const { return searches_.size(); }

 private:
  using Key = std::pair<std::string, std::uint32_t>;  ///< method and content format
  /// Holds how far an experience has been signed.
  struct Progress {
    std::shared_ptr<const Experience> experience;  ///< as it was looked at last
    std::uint32_t walked = 0;                      ///< of its places, from the first on
    PlaceId last_walked;
    std::uint64_t is_signed = 0;  ///< of those
  };
  struct Search {
    msg::Recognise asked;
    agents::RecognitionSearch search;
  };

  void look_for_work();
  void note_experience(const std::shared_ptr<const Experience>& experience);
  bool can_sign(const std::string& method) const;
  void sign_piece();
  /// Returns whether it has a signature now.
  bool sign(const Place& place);
  void search_piece();
  void answer(const msg::Recognise& asked, msg::Recognised answer);
  void refuse(const msg::Recognise& asked, std::string why);
  void show();

  Context& context_;
  std::map<Key, agents::RecognitionIndex> indexes_;
  std::map<ExperienceId, Progress> progress_;
  std::deque<ExperienceId> to_sign_;
  Revision looked_at_;
  std::deque<Search> searches_;  ///< the first one is worked on
  SteadyTime next_piece_;        ///< of signing
  SteadyTime asked_at_;
};

}  // namespace weft::server
