#include "idl/bus/topics.hpp"
#include "idl/convert/limits.hpp"

namespace weft::bus {
namespace {

std::string names(const Roles& roles) {
  std::string text;
  const auto add = [&](msg::Role role, std::string_view name) {
    if (roles.has(role)) text += (text.empty() ? "" : ", ") + std::string(name);
  };
  add(msg::Role::server, "server");
  add(msg::Role::agent, "agent");
  add(msg::Role::client, "client");
  return text;
}

std::string size(std::uint32_t bytes) {
  constexpr std::uint32_t kKiB = 1024;
  if (bytes % (kKiB * kKiB) == 0) return std::to_string(bytes / (kKiB * kKiB)) + " MiB";
  return std::to_string(bytes / kKiB) + " KiB";
}

std::string qos(const Topic& topic) {
  const std::string depth = std::to_string(topic.depth);
  switch (topic.delivering) {
    case Delivering::state:
      return "reliable, transient local, last " + depth + " a key";
    case Delivering::ordered:
      return "reliable, all, at most " + depth + " unacknowledged";
    case Delivering::once:
      return "best effort";
    case Delivering::prompt:
      break;
  }
  std::string text = "reliable, last " + depth;
  if (topic.lifespan > Duration{}) {
    text += ", waits " + std::to_string(std::chrono::duration_cast<std::chrono::seconds>(topic.lifespan).count()) +
            " s for its reader";
  }
  return text;
}

std::string row(const Topic& topic) {
  return "| `" + std::string(topic.name) + "` | `" + std::string(topic.type) + "` | " + names(topic.writers) + " | " +
         names(topic.readers) + " | " + (topic.keyed ? "16 bytes" : "-") + " | " +
         (topic.addressed ? "one peer" : "all") + " | " + qos(topic) + " | " + std::string(topic.rate) + " | " +
         size(topic.max_bytes) + " |\n";
}

constexpr std::string_view kHead = R"(# The wire

Made by `weft-wire-doc` from idl/bus/message_list.hpp and the bounds in core/protocol and
idl/convert/limits.hpp. Change those, then run `weft-wire-doc > docs/wire.md`; a test compares.

Agents and clients (peers) talk to the server alone. The types are in idl/messages; a message is its type in XCDR1,
little-endian, with the 4 bytes of encapsulation header. All types are `@final` and cannot grow: a change is a new major
version in the topic names, except `weft/hello`, which is frozen for ever so that every version can say what it speaks.
Two sides use the highest version that both speak (core/protocol/version.hpp).

A message is held to its bounds by the sender (size) and by the reader (size and every field, `from_idl`). What breaks
one is refused, named and counted, and never reaches deciding code. A key is the 16 bytes that a keyed type
begins with. An addressed topic goes to one peer: the peer's readers and the server's writers for it meet in the DDS
partition that is named by the peer's id in hex. Everything else is in the default partition.

A server that is heard in an epoch higher than the present one, or at first contact, is believed once it has shown that it
lives: the peer's hello has a random `challenge`, and the server's next hello has that among its `answers`. Until then
nothing that it says counts; a claim that is not answered for within 3 s is dropped, said and counted.

Reliable means between two live processes only. A message can be lost when either side restarts, when the network is
away for longer than a participant's lease, or when a reader is not there yet; it can come twice, and late. Whoever
needs an answer asks again. `unavailable` from publish means that the queue of an "all" topic is full: nothing was sent.

Contents are handed in raw (`coding` 0) and lent as the server's store keeps them (formats/store.md, column `coding`): `total`
and `offset` count those bytes. The reader knows the content's size and hash from its place; it refuses compressed bytes
that are not fewer than that, expands them and verifies the hash. When a chunk comes with another coding or total than
those before it, the store was another: it begins anew.

## Discovery

No multicast. The server's DDS participant has a fixed index (`server_index`, default 0), so its UDP ports on the
address that it listens on are known: 7400 + 250 * domain + 10 + 2 * index for discovery and one more for data. Agents
and clients are given `HOST` or `HOST:INDEX` of the server, take any free ports and announce themselves there once a
second. A participant that is silent for 5 s is forgotten.

A Cyclone DDS peer is two participants: the first makes the server known to it before the second, which has all readers
and writers, announces itself. Datagrams hold at most 1,392 bytes, so that one lost frame loses no more than itself; between
addresses on loopback 65,500. When a peer hears nothing for 3 s it asks again where its server's name leads, and joins anew
when that has changed; after 8 s of silence, then 16, 32 and every 60 s, it joins anew in any case, under a new GUID. So does a client
(`weft`) that hears the server and to which nothing is answered, after 10 s and then at doubled intervals (`Session::converse`): what it knows of the
server may be of where that was. What
is sent on topics of the last state of a key is told anew then. The server drops the writers for a peer that has had no
reader for 10 s.

## Topics

| topic | type | written by | read by | key | to | delivery | expected | largest |
|---|---|---|---|---|---|---|---|---|
)";

std::string bounds() {
  std::string text = "\n## Bounds\n\n| what | at most |\n|---|---|\n";
  for (const convert::Bound& bound : convert::kBounds) {
    text += "| " + std::string(bound.what) + " | " + std::to_string(bound.most) + " |\n";
  }
  return text;
}

}  // namespace

std::string wire_document() {
  std::string text(kHead);
  for (const Topic& topic : topics()) text += row(topic);
  return text + bounds();
}

}  // namespace weft::bus
