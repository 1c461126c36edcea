#pragma once
#include "core/bytes.hpp"
#include "core/network/change.hpp"
#include "core/network/goal.hpp"
#include "core/network/network.hpp"
#include "core/network/passes.hpp"
#include "core/network/registration.hpp"
#include "core/network/rule.hpp"

namespace weft {

/// Return the canonical bytes, which are hashed and stored: little-endian, fixed order (docs/formats/canonical.md).
Bytes encode(const Place& place);
Bytes encode(const Edge& edge);
Bytes encode(const Relation& relation);
Bytes encode(const Batch& batch);
Bytes encode(const Goal& goal);
Bytes encode(const Route& route);
Bytes encode(const Rule& rule);
Bytes encode(const Registration& registration);
Bytes encode(const std::vector<Pass>& passes);

/// Read canonical bytes. corrupt: short, trailing, or impossible values; the message names the field and the offset.
Result<Place> decode_place(ByteView bytes);
Result<Edge> decode_edge(ByteView bytes);
Result<Relation> decode_relation(ByteView bytes);
Result<Batch> decode_batch(ByteView bytes);
Result<Goal> decode_goal(ByteView bytes);
Result<Route> decode_route(ByteView bytes);
Result<Rule> decode_rule(ByteView bytes);
Result<Registration> decode_registration(ByteView bytes);
Result<std::vector<Pass>> decode_passes(ByteView bytes);

/// Returns the SHA-256 of the bytes.
ContentHash hash_bytes(ByteView bytes);

}  // namespace weft
