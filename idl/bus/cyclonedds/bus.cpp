#include <dds/ddsi/ddsi_serdata.h>
#include <dds/version.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include "idl/bus/backends.hpp"
#include "idl/bus/cyclonedds/blob.hpp"
#include "idl/bus/cyclonedds/descriptors.hpp"
#include "idl/bus/cyclonedds/qos.hpp"
#include "idl/bus/inbox.hpp"
#include "idl/bus/padding.hpp"

namespace weft::bus {
namespace cyclonedds {
namespace {

tl::unexpected<Error> refused(std::string_view what, dds_return_t code) {
  return fail(ErrorCode::unavailable,
              "Cyclone DDS refused to create " + std::string(what) + ": " + dds_strretcode(code));
}

/// Puts a reader's samples into the inbox. Runs in Cyclone DDS's threads.
struct Sink {
  const Topic* topic = nullptr;
  Inbox* inbox = nullptr;

  static void on_data(dds_entity_t reader, void* self) {
    const Sink& sink = *static_cast<const Sink*>(self);
    constexpr std::uint32_t kAtOnce = 16;
    for (;;) {
      ddsi_serdata* samples[kAtOnce] = {};
      dds_sample_info_t infos[kAtOnce];
      const int count = dds_takecdr(reader, samples, kAtOnce, infos, DDS_ANY_STATE);
      if (count <= 0) return;
      for (int i = 0; i < count; ++i) {
        const SerialisedSample sample(samples[i]);
        if (infos[i].valid_data) sink.inbox->put(*sink.topic, sample.bytes());
      }
    }
  }
};

/// Counts messages that Cyclone DDS itself has refused: it checks what comes in and says so in its log alone.
void on_log(void* inbox, const dds_log_data_t* entry) {
  const std::string_view text(entry->message, entry->size);
  if (text.find("deserialization") != std::string_view::npos) static_cast<Inbox*>(inbox)->count_refused_by_vendor();
}

class CycloneParticipant final : public Participant {
 public:
  CycloneParticipant(const BusConfig& config, TopicTable table, Inbox& inbox)
      : role_(config.role), table_(table.begin(), table.end()), inbox_(inbox), sinks_(table.size()) {}
  ~CycloneParticipant() override;
  CycloneParticipant(const CycloneParticipant&) = delete;
  CycloneParticipant& operator=(const CycloneParticipant&) = delete;

  Result<void> start(const BusConfig& config, const Addresses& addresses);

  Result<void> write(const Topic& topic, const PeerId& to, ByteView cdr) override;
  void forget(const PeerId& peer) override;
  void forget_readerless(SteadyTime now) override;
  bool is_bound() const override { return true; }  // does not look at carriers
  std::size_t peers() const override { return peers_.size(); }

 private:
  using Writers = std::map<TopicId, dds_entity_t>;
  /// Holds the server's means to write to one peer.
  struct Peer {
    dds_entity_t publisher = 0;
    Writers writers;
    Readers readers;
  };

  Result<void> create_reader(const Topic& topic, dds_entity_t subscriber);
  Result<dds_entity_t> writer_for(const Topic& topic, const PeerId& to);
  Result<dds_entity_t> writer_in(Writers& writers, dds_entity_t publisher, const Topic& topic);

  const msg::Role role_;
  const std::vector<Topic> table_;
  Inbox& inbox_;
  std::vector<Sink> sinks_;
  dds_entity_t domain_ = 0;
  dds_entity_t participant_ = 0;
  std::map<TopicId, dds_entity_t> topics_;
  Writers writers_;
  std::map<PeerId, Peer> peers_;
};

/// Makes a server known to this domain by a first participant, before the one that has the readers and writers
/// announces itself. Otherwise a Fast DDS server's word on its endpoints comes before the server is known here, is
/// lost, and is said again only a second later. The first one stays: a Fast DDS server that hears of its end may
/// forget the other.
Result<void> meet_server(dds_domainid_t domain) {
  const dds_entity_t scout = dds_create_participant(domain, nullptr, nullptr);
  if (scout < 0) return refused("a first participant", scout);
  const dds_entity_t reader = dds_create_reader(scout, DDS_BUILTIN_TOPIC_DCPSPARTICIPANT, nullptr, nullptr);
  if (reader < 0) return refused("a reader of participants", reader);
  constexpr int kKnown = 2;    // itself and the server
  constexpr int kLooks = 300;  // a millisecond each: then there is no server yet
  for (int count = 0, looks = 0; count < kKnown && looks < kLooks; ++looks) {
    dds_sleepfor(DDS_MSECS(1));
    void* samples[kKnown] = {};
    dds_sample_info_t infos[kKnown];
    count = dds_read(reader, samples, infos, kKnown, kKnown);
    if (count > 0) dds_return_loan(reader, samples, count);
  }
  dds_delete(reader);
  return {};
}

CycloneParticipant::~CycloneParticipant() {
  if (domain_ <= 0) return;
  dds_delete(domain_);
  dds_set_log_sink(nullptr, nullptr);
}

Result<void> CycloneParticipant::start(const BusConfig& config, const Addresses& addresses) {
  const dds_entity_t domain = dds_create_domain(config.domain, domain_xml(config, addresses).c_str());
  if (domain == DDS_RETCODE_PRECONDITION_NOT_MET) {
    return fail(ErrorCode::unavailable, "this process is in DDS domain " + std::to_string(config.domain) +
                                            " already: Cyclone DDS takes one bus a domain and process");
  }
  if (domain < 0) return refused("the domain on " + addresses.listen, domain);
  domain_ = domain;
  dds_set_log_sink(on_log, &inbox_);
  if (role_ != msg::Role::server) {
    if (const Result<void> met = meet_server(config.domain); !met) return met;
  }
  participant_ = dds_create_participant(config.domain, nullptr, nullptr);
  if (participant_ < 0) return refused("a participant on " + addresses.listen, participant_);
  const dds_entity_t addressed = dds_create_subscriber(participant_, partition_qos(config.self).get(), nullptr);
  if (addressed < 0) return refused("a subscriber", addressed);

  for (const Topic& topic : table_) {
    if (!topic.writers.has(role_) && !topic.readers.has(role_)) continue;
    const std::string name(topic.name);
    const dds_topic_descriptor_t* const type = descriptor(topic.type);
    if (type == nullptr) return fail(ErrorCode::internal, name + " is of a type without descriptor");
    const dds_entity_t created = dds_create_topic(participant_, type, name.c_str(), nullptr, nullptr);
    if (created < 0) return refused("topic " + name, created);
    topics_[topic.id] = created;
    if (topic.readers.has(role_)) {
      if (Result<void> reader = create_reader(topic, topic.addressed ? addressed : participant_); !reader)
        return reader;
    }
    if (topic.writers.has(role_) && !topic.addressed) {
      if (auto writer = writer_in(writers_, participant_, topic); !writer) return fail(std::move(writer.error()));
    }
  }
  return {};
}

Result<void> CycloneParticipant::create_reader(const Topic& topic, dds_entity_t subscriber) {
  Sink& sink = sinks_[static_cast<std::size_t>(topic.id)];
  sink = {&topic, &inbox_};
  const std::unique_ptr<dds_listener_t, decltype(&dds_delete_listener)> listener(dds_create_listener(&sink),
                                                                                 dds_delete_listener);
  dds_lset_data_available(listener.get(), Sink::on_data);
  const dds_entity_t reader =
      dds_create_reader(subscriber, topics_.at(topic.id), reader_qos(topic).get(), listener.get());
  if (reader < 0) return refused("a reader of " + std::string(topic.name), reader);
  return {};
}

Result<dds_entity_t> CycloneParticipant::writer_in(Writers& writers, dds_entity_t publisher, const Topic& topic) {
  const auto known = writers.find(topic.id);
  if (known != writers.end()) return known->second;
  const dds_entity_t writer = dds_create_writer(publisher, topics_.at(topic.id), writer_qos(topic).get(), nullptr);
  if (writer < 0) return refused("a writer of " + std::string(topic.name), writer);
  writers[topic.id] = writer;
  return writer;
}

Result<dds_entity_t> CycloneParticipant::writer_for(const Topic& topic, const PeerId& to) {
  if (!topic.addressed) return writer_in(writers_, participant_, topic);
  Peer& peer = peers_[to];
  if (peer.publisher == 0) {
    const dds_entity_t publisher = dds_create_publisher(participant_, partition_qos(to).get(), nullptr);
    if (publisher < 0) return refused("a publisher for peer " + to_string(to), publisher);
    peer.publisher = publisher;
  }
  return writer_in(peer.writers, peer.publisher, topic);
}

Result<void> CycloneParticipant::write(const Topic& topic, const PeerId& to, ByteView cdr) {
  Result<dds_entity_t> writer = writer_for(topic, to);
  if (!writer) return fail(std::move(writer.error()));
  const dds_return_t code = write_bytes(*writer, with_padding(cdr));
  if (code == DDS_RETCODE_OK) return {};
  const std::string name(topic.name);
  if (code == DDS_RETCODE_TIMEOUT) {
    return fail(ErrorCode::unavailable, name + ": Cyclone DDS's queue is full; try again later");
  }
  return fail(ErrorCode::invalid, name + ": Cyclone DDS refused the bytes as not of type " + std::string(topic.type) +
                                      " (" + dds_strretcode(code) + ")");
}

void CycloneParticipant::forget(const PeerId& id) {
  const auto found = peers_.find(id);
  if (found == peers_.end()) return;
  dds_delete(found->second.publisher);
  peers_.erase(found);
}

void CycloneParticipant::forget_readerless(SteadyTime now) {
  const auto has_reader = [](const Writers::value_type& entry) {
    dds_publication_matched_status_t status{};
    return dds_get_publication_matched_status(entry.second, &status) == DDS_RETCODE_OK && status.current_count > 0;
  };
  for (auto entry = peers_.begin(); entry != peers_.end();) {
    const Writers& writers = entry->second.writers;
    const bool is_gone = entry->second.readers.are_gone(now, std::any_of(writers.begin(), writers.end(), has_reader));
    if (is_gone) dds_delete(entry->second.publisher);
    entry = is_gone ? peers_.erase(entry) : std::next(entry);
  }
}

}  // namespace
}  // namespace cyclonedds

std::string cyclonedds_version() {
  return "Cyclone DDS " DDS_VERSION;
}

Result<std::unique_ptr<Participant>> join_cyclonedds(const BusConfig& config, TopicTable table, const Addresses& at,
                                                     Inbox& inbox) {
  auto participant = std::make_unique<cyclonedds::CycloneParticipant>(config, table, inbox);
  if (Result<void> started = participant->start(config, at); !started) return fail(std::move(started.error()));
  return participant;
}

}  // namespace weft::bus
