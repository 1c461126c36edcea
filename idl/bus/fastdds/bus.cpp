#include <fastrtps/config.h>
#include <algorithm>
#include <fastdds/dds/domain/DomainParticipant.hpp>
#include <fastdds/dds/domain/DomainParticipantFactory.hpp>
#include <fastdds/dds/publisher/DataWriter.hpp>
#include <fastdds/dds/publisher/Publisher.hpp>
#include <fastdds/dds/subscriber/DataReader.hpp>
#include <fastdds/dds/subscriber/DataReaderListener.hpp>
#include <fastdds/dds/subscriber/SampleInfo.hpp>
#include <fastdds/dds/subscriber/Subscriber.hpp>
#include <map>
#include <optional>
#include <utility>
#include <vector>

#include "idl/bus/backends.hpp"
#include "idl/bus/fastdds/bytes_type.hpp"
#include "idl/bus/fastdds/diagnostics.hpp"
#include "idl/bus/fastdds/qos.hpp"
#include "idl/bus/inbox.hpp"
#include "idl/bus/padding.hpp"

namespace weft::bus {
namespace fastdds {
namespace {

namespace dds = eprosima::fastdds::dds;

/// Moves what came into the inbox, but for what the process itself wrote. Runs in Fast DDS's threads.
class Listener final : public dds::DataReaderListener {
 public:
  Listener(const Topic& topic, Inbox& inbox) : topic_(topic), inbox_(inbox) {}
  void on_data_available(dds::DataReader* reader) override {
    Sample sample;
    dds::SampleInfo info;
    while (reader->take_next_sample(&sample, &info) == ReturnCode_t::RETCODE_OK) {
      const bool is_own = info.sample_identity.writer_guid().guidPrefix == reader->guid().guidPrefix;
      if (info.valid_data && !is_own) inbox_.put(topic_, sample.bytes);
    }
  }

 private:
  const Topic& topic_;
  Inbox& inbox_;
};

class FastParticipant final : public Participant {
 public:
  FastParticipant(const BusConfig& config, TopicTable table, Addresses at, Inbox& inbox)
      : role_(config.role), at_(std::move(at)), table_(table.begin(), table.end()), inbox_(inbox) {}
  ~FastParticipant() override;
  FastParticipant(const FastParticipant&) = delete;
  FastParticipant& operator=(const FastParticipant&) = delete;

  Result<void> start(const BusConfig& config);

  Result<void> write(const Topic& topic, const PeerId& to, ByteView cdr) override;
  void forget(const PeerId& peer) override;
  void forget_readerless(SteadyTime now) override;
  /// Fast DDS leaves out an interface that has no carrier at that moment, and has no socket then.
  bool is_bound() const override { return bus::is_bound(at_); }
  std::size_t peers() const override { return peers_.size(); }

 private:
  using Writers = std::map<TopicId, dds::DataWriter*>;
  /// Holds the server's means to write to one peer.
  struct Peer {
    dds::Publisher* publisher = nullptr;
    Writers writers;
    Readers readers;
  };

  Result<void> create_reader(const Topic& topic, dds::Subscriber* subscriber);
  Result<dds::DataWriter*> writer_for(const Topic& topic, const PeerId& to);
  Result<dds::DataWriter*> writer_in(Writers& writers, dds::Publisher* publisher, const Topic& topic);
  void remove(const Peer& peer);
  void announce_anew();

  const msg::Role role_;
  const Addresses at_;
  const std::vector<Topic> table_;
  Inbox& inbox_;
  std::vector<std::unique_ptr<Listener>> listeners_;
  dds::DomainParticipant* participant_ = nullptr;
  dds::Publisher* publisher_ = nullptr;
  std::map<TopicId, dds::Topic*> topics_;
  Writers writers_;
  std::map<PeerId, Peer> peers_;
  std::size_t ended_writers_ = 0;  ///< since all others were announced anew
  std::uint8_t announced_ = 0;     ///< how often they were
};

tl::unexpected<Error> refused(std::string_view what) {
  return fail(ErrorCode::unavailable, "Fast DDS refused to create " + std::string(what));
}

FastParticipant::~FastParticipant() {
  if (participant_ == nullptr) return;
  participant_->delete_contained_entities();
  dds::DomainParticipantFactory::get_instance()->delete_participant(participant_);
}

Result<void> FastParticipant::start(const BusConfig& config) {
  auto* const factory = dds::DomainParticipantFactory::get_instance();
  participant_ =
      factory->create_participant(config.domain, participant_qos(config, at_), nullptr, dds::StatusMask::none());
  if (participant_ == nullptr) return refused("a participant on " + at_.listen);
  publisher_ = participant_->create_publisher(dds::PUBLISHER_QOS_DEFAULT);
  dds::SubscriberQos own_partition = dds::SUBSCRIBER_QOS_DEFAULT;
  own_partition.partition().push_back(to_string(config.self).c_str());
  dds::Subscriber* const addressed = participant_->create_subscriber(own_partition);
  dds::Subscriber* const plain = participant_->create_subscriber(dds::SUBSCRIBER_QOS_DEFAULT);
  if (publisher_ == nullptr || addressed == nullptr || plain == nullptr) return refused("publisher and subscribers");

  for (const Topic& topic : table_) {
    if (!topic.writers.has(role_) && !topic.readers.has(role_)) continue;
    const dds::TypeSupport type(new BytesType(topic, inbox_));
    const std::string type_name(topic.type);
    // Two topics of one type share the first one's: they differ in nothing that the type looks at but its bound.
    if (participant_->find_type(type_name).empty()) type.register_type(participant_);
    topics_[topic.id] = participant_->create_topic(std::string(topic.name), type_name, dds::TOPIC_QOS_DEFAULT);
    if (topics_[topic.id] == nullptr) return refused("topic " + std::string(topic.name));
    if (topic.readers.has(role_)) {
      if (Result<void> created = create_reader(topic, topic.addressed ? addressed : plain); !created) return created;
    }
    if (topic.writers.has(role_) && !topic.addressed) {
      if (auto created = writer_in(writers_, publisher_, topic); !created) return fail(std::move(created.error()));
    }
  }
  return {};
}

Result<void> FastParticipant::create_reader(const Topic& topic, dds::Subscriber* subscriber) {
  listeners_.push_back(std::make_unique<Listener>(topic, inbox_));
  if (subscriber->create_datareader(topics_.at(topic.id), reader_qos(topic), listeners_.back().get()) == nullptr) {
    return refused("a reader of " + std::string(topic.name));
  }
  return {};
}

Result<dds::DataWriter*> FastParticipant::writer_in(Writers& writers, dds::Publisher* publisher, const Topic& topic) {
  dds::DataWriter*& writer = writers[topic.id];
  if (writer == nullptr) writer = publisher->create_datawriter(topics_.at(topic.id), writer_qos(topic));
  if (writer == nullptr) return refused("a writer of " + std::string(topic.name));
  return writer;
}

Result<dds::DataWriter*> FastParticipant::writer_for(const Topic& topic, const PeerId& to) {
  if (!topic.addressed) return writer_in(writers_, publisher_, topic);
  Peer& peer = peers_[to];
  if (peer.publisher == nullptr) {
    dds::PublisherQos partition = dds::PUBLISHER_QOS_DEFAULT;
    partition.partition().push_back(to_string(to).c_str());
    peer.publisher = participant_->create_publisher(partition);
    if (peer.publisher == nullptr) return refused("a publisher for peer " + to_string(to));
  }
  return writer_in(peer.writers, peer.publisher, topic);
}

Result<void> FastParticipant::write(const Topic& topic, const PeerId& to, ByteView cdr) {
  Result<dds::DataWriter*> writer = writer_for(topic, to);
  if (!writer) return fail(std::move(writer.error()));
  Sample sample{{}, with_padding(cdr)};
  sample.view = sample.bytes;
  const ReturnCode_t code = (*writer)->write(&sample, dds::HANDLE_NIL);
  if (code == ReturnCode_t::RETCODE_OK) return {};
  return fail(ErrorCode::unavailable, std::string(topic.name) + ": Fast DDS's queue is full (code " +
                                          std::to_string(code()) + "); try again later");
}

void FastParticipant::remove(const Peer& peer) {
  for (const auto& [topic, writer] : peer.writers) peer.publisher->delete_datawriter(writer);
  participant_->delete_publisher(peer.publisher);
  ended_writers_ += peer.writers.size();
}

/// Says of every writer that is left that there is a change to it (a byte of user data). Discovery is a reliable
/// topic of its own that a newcomer reads from the oldest change still kept, 256 numbers a round trip, and the first
/// writers' changes would stay the oldest for good: each client that ended would lengthen the way of all later ones.
void FastParticipant::announce_anew() {
  ended_writers_ = 0;
  ++announced_;
  const auto announce = [this](const Writers& writers) {
    for (const auto& [topic, writer] : writers) {
      dds::DataWriterQos qos = writer->get_qos();
      qos.user_data().data_vec({announced_});
      writer->set_qos(qos);
    }
  };
  announce(writers_);
  for (const auto& [id, peer] : peers_) announce(peer.writers);
}

void FastParticipant::forget(const PeerId& id) {
  const auto found = peers_.find(id);
  if (found == peers_.end()) return;
  remove(found->second);
  peers_.erase(found);
}

void FastParticipant::forget_readerless(SteadyTime now) {
  const auto has_reader = [](const Writers::value_type& entry) {
    dds::PublicationMatchedStatus status;
    return entry.second->get_publication_matched_status(status) == ReturnCode_t::RETCODE_OK &&
           status.current_count > 0;
  };
  for (auto entry = peers_.begin(); entry != peers_.end();) {
    const Writers& writers = entry->second.writers;
    const bool is_gone = entry->second.readers.are_gone(now, std::any_of(writers.begin(), writers.end(), has_reader));
    if (is_gone) remove(entry->second);
    entry = is_gone ? peers_.erase(entry) : std::next(entry);
  }
  // The more there are to announce, the rarer it is done: each ended writer pays for at most one.
  constexpr std::size_t few = 64;
  std::size_t all = writers_.size();
  for (const auto& [id, peer] : peers_) all += peer.writers.size();
  if (ended_writers_ >= std::max(few, all)) announce_anew();
}

}  // namespace
}  // namespace fastdds

std::string fastdds_version() {
  return "Fast DDS " FASTRTPS_VERSION_STR;
}

Result<std::unique_ptr<Participant>> join_fastdds(const BusConfig& config, TopicTable table, const Addresses& at,
                                                  Inbox& inbox) {
  fastdds::write_diagnostics_to_stderr();
  auto participant = std::make_unique<fastdds::FastParticipant>(config, table, at, inbox);
  if (Result<void> started = participant->start(config); !started) return fail(std::move(started.error()));
  return participant;
}

}  // namespace weft::bus
