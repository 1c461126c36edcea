#pragma once
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/protocol/messages.hpp"
#include "idl/bus/bus.hpp"

namespace weft::bus {

/// Names the topics, one for each message and direction. The order is of no meaning on the wire.
enum class TopicId : std::uint8_t {
#define WEFT_TOPIC(Id, ...) Id,
#include "idl/bus/message_list.hpp"
};
inline constexpr std::array kTopicIds = {
#define WEFT_TOPIC(Id, ...) TopicId::Id,
#include "idl/bus/message_list.hpp"
};
inline constexpr std::size_t kTopics = kTopicIds.size();

/// Says which kinds of processes are meant: a set of msg::Role.
class Roles {
 public:
  constexpr Roles() = default;
  constexpr Roles(msg::Role role) : bits_(static_cast<std::uint8_t>(1U << static_cast<unsigned>(role))) {}
  constexpr bool has(msg::Role role) const { return (bits_ & (1U << static_cast<unsigned>(role))) != 0; }
  friend constexpr Roles operator|(Roles a, Roles b) {
    Roles both;
    both.bits_ = static_cast<std::uint8_t>(a.bits_ | b.bits_);
    return both;
  }

 private:
  std::uint8_t bits_ = 0;
};

/// Tells how a topic treats its messages, for both vendors in the same words.
enum class Delivering : std::uint8_t {
  state,    ///< reliable; late joiners get the last one of each key (transient local, keep last 1)
  prompt,   ///< reliable; keeps the last `depth`; writers never wait for readers
  once,     ///< best effort: what is lost on the way stays lost
  ordered,  ///< reliable; keeps all up to `depth` unacknowledged ones, then publish says `unavailable`
};

struct Topic {
  TopicId id{};
  std::string_view type;  ///< IDL name
  std::string_view name{};
  Roles writers{};
  Roles readers{};
  bool keyed = false;      ///< by the octet[16] that it begins with
  bool addressed = false;  ///< to one peer: its own DDS partition, named by the peer's id in hex
  bool bulk = false;       ///< small and urgent ones never wait behind it
  Delivering delivering = Delivering::prompt;
  std::uint32_t depth = 64;  ///< messages kept by a writer
  Duration lifespan{};  ///< how long an addressed message waits for a reader that is not there yet; 0: not at all
  std::uint32_t max_bytes = 0;  ///< of a serialised message with its encapsulation header; larger is refused
  std::string_view rate{};      ///< expected, for people
};

/// Returns every topic that Weft speaks, in the order of TopicId, as message_list.hpp lists them.
std::span<const Topic, kTopics> topics();
const Topic& topic(TopicId id);

/// Checks a message before any bus sends it. invalid: the role does not write the topic, an addressee is missing, the
/// message is no CDR (shorter than its encapsulation header and key) or larger than the topic's bound.
Result<void> check_publish(const Topic& topic, msg::Role role, const PeerId& to, ByteView cdr);

/// Returns the text of docs/wire.md.
std::string wire_document();

}  // namespace weft::bus
