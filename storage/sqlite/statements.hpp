#pragma once
#include "core/result.hpp"
#include "storage/sqlite/database.hpp"

namespace weft::storage::sqlite {

/// Holds the statements of commits and reads, compiled once.
struct Statements {
  Statement read_store, write_store;
  Statement find_experience, find_batch, find_content, read_content;
  Statement find_edge, find_deleted;
  Statement put_content, put_experience, put_batch, put_place, put_place_anew, put_edge, put_label, put_apart,
      put_rule, put_registration, seal;
  Statement put_revision, move_places, move_stitch;
  Statement put_goal, put_route, put_occupancy, free_occupancy, put_robot, put_hold, free_hold, put_event, put_passes;
  Statement put_awaited_label, drop_awaited_label;
  Statement put_preparation, read_preparation;
  Statement quarantine;

  static Result<Statements> prepare(const Database& database);
};

}  // namespace weft::storage::sqlite
