#include <fastcdr/Cdr.h>
#include <fastcdr/exceptions/Exception.h>

#include <algorithm>
#include <array>

#include "idl/bus/link.hpp"
#include "idl/bus/topics.hpp"
#include "idl/convert/answers.hpp"
#include "idl/convert/driving.hpp"
#include "idl/convert/network.hpp"
#include "idl/convert/requests.hpp"
#include "idl/convert/session.hpp"

namespace weft::bus {
namespace {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;
constexpr std::size_t kEncapsulation = 4;

/// Returns the message as XCDR1, little-endian on every machine: the same message is the same bytes.
template <class Wire>
Bytes serialised(const Wire& wire) {
  Bytes bytes(kEncapsulation + Wire::getCdrSerializedSize(wire));
  FastBuffer buffer(reinterpret_cast<char*>(bytes.data()), bytes.size());
  Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
  cdr.serialize_encapsulation();
  wire.serialize(cdr);
  bytes.resize(cdr.getSerializedDataLength());
  return bytes;
}

template <class M, class Wire>
Result<msg::Message> decoded(const Topic& topic, ByteView bytes) {
  Wire wire;
  try {
    // Fast CDR takes no const buffer; deserialising does not write.
    FastBuffer buffer(reinterpret_cast<char*>(const_cast<std::uint8_t*>(bytes.data())), bytes.size());
    Cdr cdr(buffer, Cdr::LITTLE_ENDIANNESS, Cdr::DDS_CDR);
    cdr.read_encapsulation();
    wire.deserialize(cdr);
    const std::size_t used = cdr.getSerializedDataLength();
    if (used != bytes.size()) {
      return fail(ErrorCode::invalid, std::string(topic.type) + " has bytes after its end");
    }
  } catch (const std::exception&) {  // Fast CDR's, or bad_alloc and length_error on absurd lengths
    return fail(ErrorCode::invalid, std::string(topic.type) + " is not well-formed CDR");
  }
  constexpr std::string_view kNamespace = "weft::idl::";
  auto value = convert::from_idl<M>(wire, topic.type.substr(kNamespace.size()));
  if (!value) return fail(std::move(value.error()));
  return msg::Message(std::move(*value));
}

/// Turns the messages of a topic into bytes and back.
struct Codec {
  std::size_t type;  ///< index among the alternatives of msg::Message
  Bytes (*encode)(const msg::Message& message);
  Result<msg::Message> (*decode)(const Topic& topic, ByteView cdr);
};

template <class M, class... Ms>
constexpr std::size_t index_of(const std::variant<Ms...>* /*of*/) {
  std::size_t index = 0;
  static_cast<void>(((std::is_same_v<M, Ms> || (++index, false)) || ...));
  return index;
}

template <class M, class Wire>
constexpr Codec codec() {
  return {index_of<M>(static_cast<const msg::Message*>(nullptr)),
          [](const msg::Message& message) { return serialised(convert::to_idl<Wire>(std::get<M>(message))); },
          decoded<M, Wire>};
}

constexpr std::array<Codec, kTopics> kCodecs = {{
#define WEFT_TOPIC(Id, Name, ...) codec<msg::Name, idl::Name>(),
#include "idl/bus/message_list.hpp"
}};

constexpr bool has_topic(std::size_t type) {
  return std::any_of(kCodecs.begin(), kCodecs.end(), [&](const Codec& codec) { return codec.type == type; });
}
constexpr bool all_have_topics() {
  for (std::size_t type = 0; type < std::variant_size_v<msg::Message>; ++type) {
    if (!has_topic(type)) return false;
  }
  return true;
}
static_assert(all_have_topics(), "each message of core/protocol/messages.hpp has a row in idl/bus/message_list.hpp");

/// Returns the topic that a message goes to. Types that travel both ways are told apart by who sends. A sender that
/// may write to none of a type's topics gets the first one, which check_publish then refuses.
const Topic& topic_for(const msg::Message& message, msg::Role sender) {
  const Topic* first = nullptr;
  for (const Topic& candidate : topics()) {
    if (kCodecs[static_cast<std::size_t>(candidate.id)].type != message.index()) continue;
    if (candidate.writers.has(sender)) return candidate;
    if (first == nullptr) first = &candidate;
  }
  return *first;
}

template <class M>
PeerId addressee(const M& message) {
  if constexpr (requires { message.to; }) return message.to;
  return {};
}

}  // namespace

Result<Encoded> encode(const msg::Message& message, msg::Role sender) {
  const Topic& to = topic_for(message, sender);
  Encoded encoded;
  encoded.topic = to.id;
  encoded.to = std::visit([](const auto& m) { return addressee(m); }, message);
  encoded.cdr = kCodecs[static_cast<std::size_t>(to.id)].encode(message);
  if (Result<void> may = check_publish(to, sender, encoded.to, encoded.cdr); !may) {
    return fail(std::move(may.error()));
  }
  return encoded;
}

Result<msg::Message> decode(TopicId id, ByteView cdr) {
  const auto index = static_cast<std::size_t>(id);
  if (index >= kTopics) return fail(ErrorCode::invalid, "topic " + std::to_string(index) + " does not exist");
  const Topic& from = topic(id);
  if (cdr.size() > from.max_bytes) {
    return fail(ErrorCode::invalid,
                std::string(from.type) + " is larger than " + std::to_string(from.max_bytes) + " bytes");
  }
  return kCodecs[index].decode(from, cdr);
}

}  // namespace weft::bus
