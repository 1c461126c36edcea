#pragma once
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>

#include "core/network/apart.hpp"
#include "core/network/network.hpp"
#include "core/network/passes.hpp"
#include "core/result.hpp"
#include "storage/map_store.hpp"
#include "storage/sqlite/database.hpp"
#include "storage/sqlite/rows.hpp"

namespace weft::storage::sqlite {

/// Calls `visit(const Query&)` for each row; `bound` are the statement's parameters in order.
template <class Visit, class... Bound>
Result<void> for_each_row(const Database& database, std::string_view sql, Visit&& visit, const Bound&... bound) {
  const auto statement = database.prepare(sql);
  if (!statement) return fail(statement.error());
  Query query(*statement);
  (static_cast<void>(query << bound), ...);
  for (;;) {
    const Result<bool> row = query.step();
    if (!row) return fail(row.error());
    if (!*row) return {};
    visit(query);
  }
}

/// Decodes a row, or says why it is not one. corrupt: its checksum differs, or as `decode` says.
template <class Decode>
auto decode_guarded(ByteView row, Decode&& decode) -> decltype(decode(row)) {
  const auto canonical = unguard_row(row);
  if (!canonical) return fail(ErrorCode::corrupt, "its checksum differs");
  return decode(*canonical);
}

inline PlaceId place_id(const Query& query, int column) {
  return {{query.number(column)}, static_cast<std::uint32_t>(query.number(column + 1))};
}

inline Stretch stretch(const Query& query, int column) {
  const PlaceId first = place_id(query, column);
  return {first.experience, first.index, static_cast<std::uint32_t>(query.number(column + 2))};
}

inline constexpr const char* kApartColumns =
    "one_experience, one_first, one_last, other_experience, other_first, other_last";
/// Reads an apart from a row that begins with kApartColumns.
inline Apart apart(const Query& query) {
  return {stretch(query, 0), stretch(query, 3)};
}

/// Lists the columns of an awaited label behind its key, the label.
inline constexpr const char* kAwaitedLabelColumns = "experience, place, robot, asker, request, who";
/// Reads an awaited label from a row of its key and kAwaitedLabelColumns. corrupt: it names no place, or an id has
/// another length. Whether the place is stored is not looked at: it is not yet.
inline Result<PutAwaitedLabel> awaited_label(const Query& query) {
  const bool has_place = query.number(1) != 0 && query.number(2) <= std::numeric_limits<std::uint32_t>::max();
  if (query.text(0).empty() || !has_place) return fail(ErrorCode::corrupt, "it names no label or no place");
  for (const int column : {3, 4}) {
    if (query.blob(column).size() == sizeof(PeerId::bytes)) continue;
    return fail(ErrorCode::corrupt, "the id of its robot or of who asked for it is damaged");
  }
  return PutAwaitedLabel{.label = query.text(0),
                         .place = place_id(query, 1),
                         .robot = query.id<RobotId>(3),
                         .asker = query.id<PeerId>(4),
                         .request = query.number(5),
                         .who = query.text(6)};
}

/// Reads the key of a row of passes.
inline RunPiece run_piece(const Query& query, int column) {
  const PlaceId piece = place_id(query, column);
  return {piece.experience, piece.index, query.number(column + 2) != 0};
}

/// Names a row of passes for people.
inline std::string passes_of(const RunPiece& piece) {
  return "passes of piece " + std::to_string(piece.number) + " of experience " + to_string(piece.experience) +
         (piece.is_onward ? ", onward" : ", backward");
}

}  // namespace weft::storage::sqlite
