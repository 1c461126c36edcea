#pragma once
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/network/change.hpp"
#include "core/network/window.hpp"
#include "core/protocol/peers.hpp"

/// Holds how experiences come to the server, and windows and contents to robots.
namespace weft::msg {

inline constexpr std::size_t kChunkBytes = 65'536;               ///< most data in one chunk
inline constexpr std::uint64_t kContentBytes = kLargestContent;  ///< largest content or cloud
inline constexpr std::size_t kPatchEntities = 500;               ///< most places + edges + removals in one patch part
inline constexpr std::size_t kSignatureNumbers = 1024;           ///< longest signature of what a robot sees
inline constexpr std::size_t kRecognisedPlaces = 200;            ///< most places that are proposed for one signature
inline constexpr std::size_t kRecognisedRank = 10'000;  ///< no place behind so many likelier ones is proposed

struct ExperienceBatch {
  Header header;
  Batch batch;
};

struct BatchAck {
  Header header;
  RobotId to;
  ExperienceId experience;
  std::uint64_t durable_through = 0;   ///< every batch up to this one is on disk with its contents
  std::vector<ContentHash> missing;    ///< of the next batch
  std::uint64_t refused_sequence = 0;  ///< 0: none
  std::string refusal;
};

enum class ContentKind : std::uint8_t { content = 1, cloud = 2 };

/// Tells how a content's bytes are coded in a store and on the wire (docs/formats/store.md). raw: as they are.
enum class Coding : std::uint8_t { raw = 0, zstd = 1, cloud = 2 };

/// Carries a piece of a content or cloud; pieces come in any order, any number of times. Agents send raw bytes, the
/// server those it keeps: who gets them expands them and verifies the hash, which is that of the content itself.
struct Chunk {
  Header header;
  PeerId to;
  ContentKind kind = ContentKind::content;
  Coding coding = Coding::raw;
  ContentHash hash;
  std::uint64_t total = 0;   ///< of the coded bytes
  std::uint64_t offset = 0;  ///< among the coded bytes
  Bytes data;
};

/// Asks for contents, each from an offset on, which counts the bytes as they travel (coded).
struct ContentRequest {
  struct Item {
    ContentHash hash;
    std::uint64_t offset = 0;
  };
  Header header;
  PeerId to;
  std::vector<Item> items;
};

struct WindowRequest {
  Header header;
  std::uint64_t definition_id = 0;  ///< the asker's number for this definition; patches carry it back
  WindowDefinition definition;
  Revision held;  ///< 0: nothing
  Digest held_digest;
};

/// Carries a patch of a window, or one of its parts: all parts of one patch share base, target and digest.
struct WindowPatch {
  Header header;
  PeerId to;
  std::uint64_t definition_id = 0;
  std::uint32_t part = 0;
  std::uint32_t parts = 1;
  Patch patch;
};

/// Asks which places of the whole network look like what a robot sees; it does not know where it is. Has a signature.
struct Recognise {
  Header header;
  std::uint64_t request = 0;  ///< the asker's number for it; the answer carries it back
  std::string method;         ///< that signed, and the format of the contents that it signs
  std::uint32_t content_format = 0;
  std::vector<float> seen;  ///< as Method::sign gives it; finite, at least one number
  std::uint32_t most = 0;   ///< places wanted, at least 1
  std::uint32_t after = 0;  ///< the so many likeliest are known already: the ones behind them
};

/// Proposes places to look at, the likeliest first and no two close together. Only those that are signed were
/// compared: a server that has just started, or just been given contents, has not signed all of them yet.
struct Recognised {
  Header header;
  RobotId to;
  std::uint64_t request = 0;
  Outcome outcome = Outcome::done;  ///< done or refused
  std::string message;              ///< why it is refused
  std::vector<PlaceId> places;
  std::uint64_t signed_places = 0;    ///< of the network, with the asker's method and format
  std::uint64_t unsigned_places = 0;  ///< the same, still to be signed
};

}  // namespace weft::msg
