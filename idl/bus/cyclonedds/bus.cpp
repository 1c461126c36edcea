#include <dds/ddsi/ddsi_serdata.h>
#include <dds/version.h>

#include <map>
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

/// Where a reader's samples go. Cyclone DDS's threads.
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

/// Cyclone DDS checks what comes in and says so in its log alone.
void on_log(void* inbox, const dds_log_data_t* entry) {
  const std::string_view text(entry->message, entry->size);
  if (text.find("deserialization") != std::string_view::npos) static_cast<Inbox*>(inbox)->count_refused_by_vendor();
}

class CycloneBus final : public Bus {
 public:
  CycloneBus(const BusConfig& config, TopicTable table)
      : role_(config.role), table_(table.begin(), table.end()), inbox_(config.inbox_messages), sinks_(table.size()) {}
  ~CycloneBus() override;
  CycloneBus(const CycloneBus&) = delete;
  CycloneBus& operator=(const CycloneBus&) = delete;

  Result<void> start(const BusConfig& config, const Addresses& addresses);

  Result<void> publish(TopicId id, const PeerId& to, ByteView cdr) override;
  std::optional<Delivery> take() override { return inbox_.take(); }
  bool wait(Duration at_most) override { return inbox_.wait(at_most); }
  void wake() override { inbox_.wake(); }
  std::string vendor() const override { return "cyclonedds"; }
  msg::Role role() const override { return role_; }
  BusCounters counters() const override { return inbox_.counters(); }
  void forget(const PeerId& peer) override;

 private:
  using Writers = std::map<TopicId, dds_entity_t>;
  /// The server's means to write to one peer.
  struct Peer {
    dds_entity_t publisher = 0;
    Writers writers;
  };

  Result<void> create_reader(const Topic& topic, dds_entity_t subscriber);
  Result<void> write(const Topic& topic, const PeerId& to, ByteView cdr);
  Result<dds_entity_t> writer_for(const Topic& topic, const PeerId& to);
  Result<dds_entity_t> writer_in(Writers& writers, dds_entity_t publisher, const Topic& topic);

  const msg::Role role_;
  const std::vector<Topic> table_;
  Inbox inbox_;  ///< outlives the readers
  std::vector<Sink> sinks_;
  dds_entity_t domain_ = 0;
  dds_entity_t participant_ = 0;
  std::map<TopicId, dds_entity_t> topics_;
  Writers writers_;
  std::map<PeerId, Peer> peers_;
};

CycloneBus::~CycloneBus() {
  if (domain_ <= 0) return;
  dds_delete(domain_);
  dds_set_log_sink(nullptr, nullptr);
}

Result<void> CycloneBus::start(const BusConfig& config, const Addresses& addresses) {
  const dds_entity_t domain = dds_create_domain(config.domain, domain_xml(config, addresses).c_str());
  if (domain == DDS_RETCODE_PRECONDITION_NOT_MET) {
    return fail(ErrorCode::unavailable, "this process is in DDS domain " + std::to_string(config.domain) +
                                            " already: Cyclone DDS takes one bus a domain and process");
  }
  if (domain < 0) return refused("the domain on " + addresses.listen, domain);
  domain_ = domain;
  dds_set_log_sink(on_log, &inbox_);
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

Result<void> CycloneBus::create_reader(const Topic& topic, dds_entity_t subscriber) {
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

Result<dds_entity_t> CycloneBus::writer_in(Writers& writers, dds_entity_t publisher, const Topic& topic) {
  const auto known = writers.find(topic.id);
  if (known != writers.end()) return known->second;
  const dds_entity_t writer = dds_create_writer(publisher, topics_.at(topic.id), writer_qos(topic).get(), nullptr);
  if (writer < 0) return refused("a writer of " + std::string(topic.name), writer);
  writers[topic.id] = writer;
  return writer;
}

Result<dds_entity_t> CycloneBus::writer_for(const Topic& topic, const PeerId& to) {
  if (!topic.addressed) return writer_in(writers_, participant_, topic);
  Peer& peer = peers_[to];
  if (peer.publisher == 0) {
    const dds_entity_t publisher = dds_create_publisher(participant_, partition_qos(to).get(), nullptr);
    if (publisher < 0) return refused("a publisher for peer " + to_string(to), publisher);
    peer.publisher = publisher;
  }
  return writer_in(peer.writers, peer.publisher, topic);
}

Result<void> CycloneBus::publish(TopicId id, const PeerId& to, ByteView cdr) {
  const Topic& topic = table_[static_cast<std::size_t>(id)];
  Result<void> done = check_publish(topic, role_, to, cdr);
  const bool oversized = cdr.size() > topic.max_bytes;
  if (done) done = write(topic, to, cdr);
  inbox_.count_publish(done, oversized);
  return done;
}

Result<void> CycloneBus::write(const Topic& topic, const PeerId& to, ByteView cdr) {
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

void CycloneBus::forget(const PeerId& id) {
  const auto found = peers_.find(id);
  if (found == peers_.end()) return;
  dds_delete(found->second.publisher);
  peers_.erase(found);
}

}  // namespace
}  // namespace cyclonedds

std::string cyclonedds_version() {
  return "Cyclone DDS " DDS_VERSION;
}

Result<std::unique_ptr<Bus>> open_cyclonedds(const BusConfig& config, TopicTable table) {
  Result<Addresses> addresses = look_up(config);
  if (!addresses) return fail(std::move(addresses.error()));
  auto bus = std::make_unique<cyclonedds::CycloneBus>(config, table);
  if (Result<void> started = bus->start(config, *addresses); !started) return fail(std::move(started.error()));
  return bus;
}

}  // namespace weft::bus
