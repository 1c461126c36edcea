#include <fastcdr/Cdr.h>
#include <fastcdr/exceptions/Exception.h>

#include "idl/bus/link.hpp"
#include "idl/bus/topics.hpp"
#include "idl/convert/messages.hpp"

namespace weft::bus {
namespace {

using eprosima::fastcdr::Cdr;
using eprosima::fastcdr::FastBuffer;
constexpr std::size_t kEncapsulation = 4;

/// XCDR1, little-endian on every machine: the same message is the same bytes.
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

template <class Wire>
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
  auto value = convert::from_idl(wire);
  if (!value) return fail(std::move(value.error()));
  return msg::Message(std::move(*value));
}

/// Where a message of each type goes. Types that travel both ways are told apart by who sends.
struct Route {
  msg::Role sender;
  TopicId operator()(const msg::Hello&) const { return TopicId::hello; }
  TopicId operator()(const msg::RobotDescription&) const { return TopicId::robot_description; }
  TopicId operator()(const msg::RobotState&) const { return TopicId::robot_state; }
  TopicId operator()(const msg::ExperienceBatch&) const { return TopicId::experience_batch; }
  TopicId operator()(const msg::BatchAck&) const { return TopicId::batch_ack; }
  TopicId operator()(const msg::Chunk&) const {
    return sender == msg::Role::server ? TopicId::chunk_down : TopicId::chunk_up;
  }
  TopicId operator()(const msg::ContentRequest&) const {
    return sender == msg::Role::server ? TopicId::content_request_down : TopicId::content_request_up;
  }
  TopicId operator()(const msg::WindowRequest&) const { return TopicId::window_request; }
  TopicId operator()(const msg::WindowPatch&) const { return TopicId::window_patch; }
  TopicId operator()(const msg::Recognise&) const { return TopicId::recognise; }
  TopicId operator()(const msg::Recognised&) const { return TopicId::recognised; }
  TopicId operator()(const msg::RouteOrder&) const { return TopicId::route_order; }
  TopicId operator()(const msg::RouteProgress&) const { return TopicId::route_progress; }
  TopicId operator()(const msg::AgentCommand&) const { return TopicId::agent_command; }
  TopicId operator()(const msg::AgentReply&) const { return TopicId::agent_reply; }
  TopicId operator()(const msg::OperatorRequest&) const { return TopicId::operator_request; }
  TopicId operator()(const msg::OperatorReply&) const { return TopicId::operator_reply; }
  TopicId operator()(const msg::Query&) const { return TopicId::query; }
  TopicId operator()(const msg::QueryReply&) const { return TopicId::query_reply; }
  TopicId operator()(const msg::EventNote&) const { return TopicId::event_note; }
  TopicId operator()(const msg::ClockProbe&) const { return TopicId::clock_probe; }
  TopicId operator()(const msg::ClockReply&) const { return TopicId::clock_reply; }
};

template <class M>
PeerId addressee(const M& message) {
  if constexpr (requires { message.to; }) return message.to;
  return {};
}

}  // namespace

Result<Encoded> encode(const msg::Message& message, msg::Role sender) {
  Encoded encoded;
  encoded.topic = std::visit(Route{sender}, message);
  encoded.to = std::visit([](const auto& m) { return addressee(m); }, message);
  encoded.cdr = std::visit([](const auto& m) { return serialised(convert::to_idl(m)); }, message);
  if (Result<void> may = check_publish(topic(encoded.topic), sender, encoded.to, encoded.cdr); !may) {
    return fail(std::move(may.error()));
  }
  return encoded;
}

Result<msg::Message> decode(TopicId id, ByteView cdr) {
  const Topic& from = topic(id);
  if (cdr.size() > from.max_bytes) {
    return fail(ErrorCode::invalid,
                std::string(from.type) + " is larger than " + std::to_string(from.max_bytes) + " bytes");
  }
  switch (id) {
    case TopicId::hello:
      return decoded<idl::Hello>(from, cdr);
    case TopicId::robot_description:
      return decoded<idl::RobotDescription>(from, cdr);
    case TopicId::robot_state:
      return decoded<idl::RobotState>(from, cdr);
    case TopicId::experience_batch:
      return decoded<idl::ExperienceBatch>(from, cdr);
    case TopicId::batch_ack:
      return decoded<idl::BatchAck>(from, cdr);
    case TopicId::chunk_up:
    case TopicId::chunk_down:
      return decoded<idl::Chunk>(from, cdr);
    case TopicId::content_request_up:
    case TopicId::content_request_down:
      return decoded<idl::ContentRequest>(from, cdr);
    case TopicId::window_request:
      return decoded<idl::WindowRequest>(from, cdr);
    case TopicId::window_patch:
      return decoded<idl::WindowPatch>(from, cdr);
    case TopicId::recognise:
      return decoded<idl::Recognise>(from, cdr);
    case TopicId::recognised:
      return decoded<idl::Recognised>(from, cdr);
    case TopicId::route_order:
      return decoded<idl::RouteOrder>(from, cdr);
    case TopicId::route_progress:
      return decoded<idl::RouteProgress>(from, cdr);
    case TopicId::agent_command:
      return decoded<idl::AgentCommand>(from, cdr);
    case TopicId::agent_reply:
      return decoded<idl::AgentReply>(from, cdr);
    case TopicId::operator_request:
      return decoded<idl::OperatorRequest>(from, cdr);
    case TopicId::operator_reply:
      return decoded<idl::OperatorReply>(from, cdr);
    case TopicId::query:
      return decoded<idl::Query>(from, cdr);
    case TopicId::query_reply:
      return decoded<idl::QueryReply>(from, cdr);
    case TopicId::event_note:
      return decoded<idl::EventNote>(from, cdr);
    case TopicId::clock_probe:
      return decoded<idl::ClockProbe>(from, cdr);
    case TopicId::clock_reply:
      return decoded<idl::ClockReply>(from, cdr);
  }
  return fail(ErrorCode::invalid, "topic " + std::to_string(static_cast<unsigned>(id)) + " does not exist");
}

}  // namespace weft::bus
