#pragma once
#include "core/network/goal.hpp"
#include "core/network/network.hpp"
#include "core/protocol/messages.hpp"
#include "idl/convert/reading.hpp"
#include "wire/common.h"

/// Conversions of what several messages share. `from_idl` complains to `reading` about the first field out of bounds.
namespace weft::convert {

idl::Header to_idl(const msg::Header& header);
msg::Header from_idl(const idl::Header& header, Reading reading);

idl::PlaceId to_idl(const PlaceId& id);
/// May be none.
PlaceId from_idl(const idl::PlaceId& id);

idl::Relation to_idl(const Relation& relation);
Relation from_idl(const idl::Relation& relation, Reading reading);

idl::Place to_idl(const Place& place);
Place from_idl(const idl::Place& place, Reading reading);

idl::EdgeId to_idl(const EdgeId& id);
EdgeId from_idl(const idl::EdgeId& id, Reading reading);
idl::Edge to_idl(const Edge& edge);
Edge from_idl(const idl::Edge& edge, Reading reading);

idl::Stretch to_idl(const Stretch& stretch);
Stretch from_idl(const idl::Stretch& stretch, Reading reading);
idl::Apart to_idl(const Apart& apart);
Apart from_idl(const idl::Apart& apart, Reading reading);

idl::Route to_idl(const Route& route);
Route from_idl(const idl::Route& route, Reading reading);

std::vector<idl::SitePoint> to_idl(const std::vector<msg::AgentCommand::Point>& line);
std::vector<msg::AgentCommand::Point> from_idl(const std::vector<idl::SitePoint>& line, Reading reading);

idl::Diagnostic to_idl(const Diagnostic& diagnostic);
Diagnostic from_idl(const idl::Diagnostic& wire, Reading reading);
idl::TaughtStretch to_idl(const msg::TaughtStretch& stretch);
msg::TaughtStretch from_idl(const idl::TaughtStretch& wire, Reading reading);

/// Element by element.
template <class Wire, class T>
std::vector<Wire> list_to_idl(const std::vector<T>& values) {
  std::vector<Wire> list;
  list.reserve(values.size());
  for (const T& value : values) list.push_back(to_idl(value));
  return list;
}
template <class T, class Wire>
std::vector<T> list_from_idl(const std::vector<Wire>& values, Reading& reading, std::string_view field,
                             std::size_t most) {
  std::vector<T> list;
  if (values.size() > most) {
    reading.list(field, values, most);
    return list;
  }
  list.reserve(values.size());
  for (std::size_t i = 0; i < values.size() && reading.ok(); ++i) {
    list.push_back(from_idl(values[i], reading.in(field, i)));
  }
  return list;
}
std::vector<idl::Label> labels_to_idl(const std::map<std::string, PlaceId>& labels);
std::map<std::string, PlaceId> labels_from_idl(const std::vector<idl::Label>& wire, Reading reading);

/// Numbers with names for people.
using Counts = std::vector<std::pair<std::string, std::uint64_t>>;
std::vector<idl::NamedCount> counts_to_idl(const Counts& counts);
Counts counts_from_idl(const std::vector<idl::NamedCount>& counts, Reading& reading, std::string_view field);
std::vector<PlaceId> places_from_idl(const std::vector<idl::PlaceId>& ids, Reading& reading, std::string_view field,
                                     std::size_t most);

}  // namespace weft::convert
