#pragma once
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

#include "core/bytes.hpp"
#include "core/ids.hpp"
#include "core/result.hpp"

struct sqlite3;
struct sqlite3_backup;
struct sqlite3_stmt;

/// Wraps and owns what SQLite's C API gives. Errors: exhausted for a full disk, unavailable for I/O errors and locks,
/// corrupt for a damaged file, conflict for a broken constraint.
namespace weft::storage::sqlite {

/// Holds a statement, compiled once, run through `Query`.
class Statement {
 public:
  Statement() = default;

 private:
  friend class Database;
  friend class Query;
  struct Finalise {
    void operator()(sqlite3_stmt* statement) const;
  };
  explicit Statement(sqlite3_stmt* statement) : statement_(statement) {}
  std::unique_ptr<sqlite3_stmt, Finalise> statement_;
};

/// Holds a column's value of any type, for keys that are read and bound again.
using Value = std::variant<std::uint64_t, std::string, Bytes>;

/// Runs a statement once: bind in order, step, read columns. What is bound must outlive the query; what is read is
/// valid until the next step. Resets the statement when it goes.
class Query {
 public:
  explicit Query(const Statement& statement) : statement_(statement.statement_.get()) {}
  ~Query();
  Query(const Query&) = delete;
  Query& operator=(const Query&) = delete;

  Query& operator<<(std::uint64_t value);  ///< stored as the signed number of the same bits
  Query& operator<<(std::string_view text);
  Query& operator<<(ByteView blob);
  Query& operator<<(const Value& value);
  template <class Tag, std::size_t N>
  Query& operator<<(const ByteId<Tag, N>& id) {
    return *this << ByteView(id.bytes);
  }

  /// Goes on to the next row. Returns true when there is one, false when done.
  Result<bool> step();
  /// Runs a statement that returns no rows.
  Result<void> run();

  bool is_null(int column) const;
  std::uint64_t number(int column) const;
  std::string text(int column) const;
  ByteView blob(int column) const;
  Value value(int column) const;
  /// Reads an id; zero when the column's size is not that of ids.
  template <class Id>
  Id id(int column) const {
    Id id;
    const ByteView bytes = blob(column);
    if (bytes.size() == id.bytes.size()) std::copy(bytes.begin(), bytes.end(), id.bytes.begin());
    return id;
  }

 private:
  sqlite3_stmt* statement_;
  int next_ = 1;
};

class Database {
 public:
  /// Opens, or makes, the file; `vfs` names SQLite's file layer, empty for the system's.
  static Result<Database> open(const std::filesystem::path& file, const std::string& vfs);

  Result<Statement> prepare(std::string_view sql) const;
  /// Runs one or more statements without parameters or rows of interest.
  Result<void> run(const std::string& sql) const;
  /// Returns the single number of a one-row query, such as a pragma.
  Result<std::uint64_t> number(std::string_view sql) const;
  bool in_transaction() const;

  /// Calls `watch` after each commit with how many pages the log has. From now on the log is emptied only when that
  /// returns true, and when somebody calls `empty_log`.
  void watch_log(std::function<bool(std::uint64_t pages)> watch);
  /// Asks `stops` again and again while a statement runs, on the thread that runs it. When it returns true, the
  /// statement ends as unavailable.
  void stop_when(std::function<bool()> stops);
  /// Moves what the log has into the file, as far as nobody reads it; waits for nobody.
  Result<void> empty_log() const;

 private:
  friend class Backup;
  using LogWatch = std::function<bool(std::uint64_t pages)>;
  struct Close {
    void operator()(sqlite3* database) const;
  };
  std::unique_ptr<LogWatch> watch_;               ///< SQLite knows its address
  std::unique_ptr<std::function<bool()>> stops_;  ///< and its
  std::unique_ptr<sqlite3, Close> database_;
};

/// Makes SQLite's online backup. What the source's own connection commits between the steps is carried along.
class Backup {
 public:
  /// Begins a backup. Both outlive it; nobody else uses `to` meanwhile.
  static Result<Backup> begin(const Database& to, const Database& from);
  /// Copies up to `pages` pages. True: all are there.
  Result<bool> step(int pages);
  std::uint64_t pages() const;  ///< as of the last step
  std::uint64_t remaining() const;

 private:
  struct Finish {
    void operator()(sqlite3_backup* backup) const;
  };
  Backup(sqlite3_backup* backup, const Database& to) : backup_(backup), to_(&to) {}
  std::unique_ptr<sqlite3_backup, Finish> backup_;
  const Database* to_;
};

/// Makes many reads see one state: without it each takes and gives back the file's locks, which costs more than a
/// lookup. Ends before anything is written.
class ReadTransaction {
 public:
  static Result<ReadTransaction> begin(const Database& database);
  ~ReadTransaction();
  ReadTransaction(ReadTransaction&& other) noexcept : database_(std::exchange(other.database_, nullptr)) {}
  ReadTransaction& operator=(ReadTransaction&&) = delete;

 private:
  explicit ReadTransaction(const Database& database) : database_(&database) {}
  const Database* database_;
};

/// Makes a write transaction, which is rolled back when this goes without `commit`.
class WriteTransaction {
 public:
  static Result<WriteTransaction> begin(const Database& database);
  ~WriteTransaction();
  WriteTransaction(WriteTransaction&& other) noexcept : database_(std::exchange(other.database_, nullptr)) {}
  WriteTransaction& operator=(WriteTransaction&&) = delete;
  Result<void> commit();

 private:
  explicit WriteTransaction(const Database& database) : database_(&database) {}
  const Database* database_;
};

}  // namespace weft::storage::sqlite
