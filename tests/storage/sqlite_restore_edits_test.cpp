#include <gtest/gtest.h>

#include <functional>

#include "core/network/codec.hpp"
#include "storage/sqlite/database.hpp"
#include "storage/sqlite/restore.hpp"
#include "tests/storage/job_steps.hpp"
#include "tests/storage/random_history.hpp"
#include "tests/storage/sample_map.hpp"
#include "tests/storage/temporary_directory.hpp"

/// Tests that a snapshot restores, whatever was done to the map before it was taken.
namespace weft::storage {
namespace {

/// Arranges two runs that are stitched, a label, and an edit of some kind.
struct EditedStore {
  explicit EditedStore(const std::filesystem::path& directory) : store(open_sqlite(directory).value()) {
    EXPECT_TRUE(store->open());
    commit(sample::transaction(taught));
    auto joined = young.next(6);
    joined.batch.edges.push_back(stitch);
    commit(sample::transaction(joined));
    commit({{PutLabel{"dock", {old.experience(), 4}}}});
  }
  Revision commit(const Transaction& transaction) const {
    const auto committed = store->commit(transaction);
    EXPECT_TRUE(committed) << committed.error().message;
    return committed ? committed->revision : Revision{};
  }
  Removal places(std::uint32_t first, std::uint32_t last) const { return {{{old.experience(), first, last}}, {}}; }

  std::unique_ptr<MapStore> store;
  sample::Run old{0x11, 1};
  sample::Run young{0x22, 2};
  sample::Delivery taught = old.next(8);
  Edge stitch = sample::stitch({ExperienceId{0x11}, 2}, {ExperienceId{0x22}, 1});
  PutAwaitedLabel awaited{"gate", {ExperienceId{0x22}, 90}, sample::robot(2), sample::robot(7), 5, "anna"};
  Apart apart{{ExperienceId{0x11}, 4, 7}, {ExperienceId{0x22}, 3, 5}};
  Registration registration{"hall", {}, {{"dock", {ExperienceId{0x11}, 4}}}};
  Rule rule{.name = "shut",
            .spans = {{{ExperienceId{0x11}, 4}, {ExperienceId{0x11}, 7}}},
            .label = "dock",
            .area = Area{"hall", {}, {{0, 0}, {4, 0}, {4, 3}}}};
};

struct EditKind {
  const char* name;
  std::function<void(EditedStore&)> edit;
};

void learn_better(EditedStore& of) {
  const Bytes better(100, 0x41);
  const Place anew = sample::known_anew(of.taught.batch.places[1], better, sample::robot(2));
  of.commit({{PutContent{anew.content.hash, msg::ContentKind::content, better}, PutPlaces{{anew}}}});
}

void compact_behind(EditedStore& of) {
  const Revision kept = of.commit({{TakeOut{of.places(0, 1)}}});
  ASSERT_TRUE(finish(**of.store->compact(kept)));
}

const std::vector<EditKind>& edit_kinds() {
  static const std::vector<EditKind> kAll{
      {"Nothing", [](EditedStore&) {}},
      {"StitchOut",
       [](EditedStore& of) {
         of.commit({{TakeOut{{{}, {of.stitch.id}}}}});
       }},
      {"PlacesOut", [](EditedStore& of) { of.commit({{TakeOut{of.places(2, 5)}}}); }},
      {"ExperienceOut", [](EditedStore& of) { of.commit({{TakeOut{of.places(0, 7)}}}); }},
      {"PlacesAndStitchOut",
       [](EditedStore& of) {
         of.commit({{TakeOut{{{{of.old.experience(), 5, 6}}, {of.stitch.id}}}}});
       }},
      {"BackAgain",
       [](EditedStore& of) {
         of.commit({{TakeOut{of.places(2, 5)}}});
         of.commit({{BringBack{of.places(2, 5)}}});
       }},
      {"OutAndBackInOneRevision",
       [](EditedStore& of) {
         of.commit({{TakeOut{of.places(2, 5)}, BringBack{of.places(3, 4)}}});
       }},
      {"LabelMoved",
       [](EditedStore& of) {
         of.commit({{PutLabel{"dock", {of.young.experience(), 1}}}});
       }},
      {"LabelGone",
       [](EditedStore& of) {
         of.commit({{PutLabel{"dock", {}}}});
       }},
      {"LabelAwaited", [](EditedStore& of) { of.commit({{of.awaited}}); }},
      {"Apart", [](EditedStore& of) { of.commit({{PutApart{of.apart}}}); }},
      {"ApartNoLonger",
       [](EditedStore& of) {
         of.commit({{PutApart{of.apart}}});
         of.commit({{PutApart{of.apart, false}}});
       }},
      {"Ruled", [](EditedStore& of) { of.commit({{PutRule{of.rule}}}); }},
      {"RuledNoLonger",
       [](EditedStore& of) {
         of.commit({{PutRule{of.rule}}});
         of.commit({{PutRule{of.rule, false}}});
       }},
      {"Registered", [](EditedStore& of) { of.commit({{PutRegistration{of.registration}}}); }},
      {"RegisteredNoLonger",
       [](EditedStore& of) {
         of.commit({{PutRegistration{of.registration}}});
         of.commit({{PutRegistration{of.registration, false}}});
       }},
      {"Learned", learn_better},
      {"Sealed",
       [](EditedStore& of) {
         of.commit({{SealExperience{of.old.experience(), "done"}}});
       }},
      {"RolledBack",
       [](EditedStore& of) {
         of.commit({{TakeOut{of.places(2, 5)}}});
         of.commit({{RollBack{{2}}}});
       }},
      {"Compacted", compact_behind},
  };
  return kAll;
}

class SqliteRestoreEdits : public testing::TestWithParam<EditKind> {
 protected:
  /// Returns the map that is there after the snapshot has been restored.
  static std::vector<std::string> restored(const std::filesystem::path& snapshot) {
    const TemporaryDirectory to;
    const auto done = restore(snapshot, to.path());
    EXPECT_TRUE(done) << done.error().message;
    if (!done) return {};
    EXPECT_TRUE(done->findings.empty()) << done->findings.front();
    const auto store = open_sqlite(to.path());
    const auto stored = (*store)->open();
    EXPECT_TRUE(stored) << stored.error().message;
    return stored ? sample::describe(*stored) : std::vector<std::string>{};
  }

  TemporaryDirectory directory_;
  TemporaryDirectory elsewhere_;
};

TEST_P(SqliteRestoreEdits, ASnapshotRestoresAfterTheEdit) {
  std::vector<std::string> whole;
  const auto file = elsewhere_.path() / "snapshot";
  {
    EditedStore edited(directory_.path());
    GetParam().edit(edited);
    ASSERT_TRUE(finish(**edited.store->snapshot_to(file)));
    whole = sample::describe(edited.store->open().value());
  }
  EXPECT_EQ(restored(file), whole);
}

INSTANTIATE_TEST_SUITE_P(Kinds, SqliteRestoreEdits, testing::ValuesIn(edit_kinds()),
                         [](const testing::TestParamInfo<EditKind>& kind) { return kind.param.name; });

/// Makes many edits of every kind one after another; the map of each revision is restored with them.
TEST_F(SqliteRestoreEdits, ASnapshotOfALongHistoryRestoresWithItsPast) {
  const auto file = elsewhere_.path() / "snapshot";
  const auto store = open_sqlite(directory_.path()).value();
  Snapshot now = store->open()->snapshot;
  sample::RandomHistory history(17);
  for (int step = 0; step < 80; ++step) {
    const auto drawn = history.draw(now);
    if (!drawn) continue;
    const auto committed = store->commit(drawn->transaction);
    ASSERT_TRUE(committed) << committed.error().message;
    now = store->snapshot_at(committed->revision, {}).value();
  }
  ASSERT_TRUE(finish(**store->snapshot_to(file)));
  const TemporaryDirectory to;
  const auto done = restore(file, to.path());
  ASSERT_TRUE(done) << done.error().message;
  const auto again = open_sqlite(to.path()).value();
  EXPECT_EQ(sample::describe(again->open()->snapshot), sample::describe(now));
  for (std::uint64_t at = 1; at <= now.revision().value; ++at) {
    ASSERT_EQ(sample::describe(again->snapshot_at({at}, {}).value()),
              sample::describe(store->snapshot_at({at}, {}).value()))
        << at;
  }
}

/// Tests a snapshot as schema 5 made it: its columns stood in another order.
TEST_F(SqliteRestoreEdits, AnEditedSnapshotOfAnOlderSchemaIsBroughtUpToDateAndRestores) {
  std::vector<std::string> whole;
  const auto file = elsewhere_.path() / "snapshot";
  {
    const EditedStore edited(directory_.path());
    edited.commit({{TakeOut{edited.places(2, 5)}}});
    ASSERT_TRUE(finish(**edited.store->snapshot_to(file)));
    whole = sample::describe(edited.store->open().value());
  }
  {
    const auto older = sqlite::Database::open(file, "").value();
    ASSERT_TRUE(
        older.run("CREATE TABLE older (revision INTEGER NOT NULL, experience INTEGER NOT NULL,"
                  " first_place INTEGER NOT NULL, last_place INTEGER NOT NULL, is_back INTEGER NOT NULL,"
                  " PRIMARY KEY (revision, experience, first_place, is_back)) WITHOUT ROWID;"
                  "INSERT INTO older (revision, experience, first_place, is_back, last_place)"
                  " SELECT revision, experience, first_place, is_back, last_place FROM moved_places;"
                  "DROP TABLE moved_places; ALTER TABLE older RENAME TO moved_places;"
                  "DROP TABLE registration; DROP TABLE rule; DROP TABLE hold; DROP TABLE awaited_label; DROP TABLE "
                  "passes; DROP TABLE apart; "
                  "PRAGMA user_version = 5"));
  }
  EXPECT_EQ(restored(file), whole);
}

}  // namespace
}  // namespace weft::storage
