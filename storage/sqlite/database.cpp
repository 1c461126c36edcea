#include "storage/sqlite/database.hpp"

#include <sqlite3.h>

#include <bit>
#include <utility>

namespace weft::storage::sqlite {
namespace {

ErrorCode code_from_sqlite(int extended) {
  switch (extended & 0xff) {
    case SQLITE_FULL:
    case SQLITE_NOMEM:
      return ErrorCode::exhausted;
    case SQLITE_IOERR:
    case SQLITE_BUSY:
    case SQLITE_LOCKED:
    case SQLITE_CANTOPEN:
    case SQLITE_PERM:
    case SQLITE_READONLY:
    case SQLITE_PROTOCOL:
    case SQLITE_INTERRUPT:
      return ErrorCode::unavailable;
    case SQLITE_CORRUPT:
    case SQLITE_NOTADB:
      return ErrorCode::corrupt;
    case SQLITE_CONSTRAINT:
      return ErrorCode::conflict;
    case SQLITE_TOOBIG:
      return ErrorCode::invalid;
    default:
      return ErrorCode::internal;
  }
}

const char* advice_for(ErrorCode code) {
  switch (code) {
    case ErrorCode::exhausted:
      return "free space on its disk; nothing was written";
    case ErrorCode::unavailable:
      return "check its disk and permissions, then try again";
    case ErrorCode::corrupt:
      return "move the store away and restore a backup";
    default:
      return "nothing was written";
  }
}

Error error_from_sqlite(sqlite3* database, int extended, const char* message) {
  const ErrorCode code = code_from_sqlite(extended);
  const char* const file = sqlite3_db_filename(database, "main");
  return {code, std::string("map store ") + (file == nullptr ? "" : file) + ": " + message + " (SQLite " +
                    std::to_string(extended) + "); " + advice_for(code)};
}

Error error_from_sqlite(sqlite3* database) {
  return error_from_sqlite(database, sqlite3_extended_errcode(database), sqlite3_errmsg(database));
}

}  // namespace

void Statement::Finalise::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

Query::~Query() {
  sqlite3_reset(statement_);
  sqlite3_clear_bindings(statement_);
}

Query& Query::operator<<(std::uint64_t value) {
  sqlite3_bind_int64(statement_, next_++, std::bit_cast<std::int64_t>(value));
  return *this;
}

Query& Query::operator<<(std::string_view text) {
  const char* const data = text.data() == nullptr ? "" : text.data();  // a null pointer would bind NULL
  sqlite3_bind_text64(statement_, next_++, data, text.size(), SQLITE_STATIC, SQLITE_UTF8);
  return *this;
}

Query& Query::operator<<(ByteView blob) {
  if (blob.empty()) {
    sqlite3_bind_zeroblob(statement_, next_++, 0);
  } else {
    sqlite3_bind_blob64(statement_, next_++, blob.data(), blob.size(), SQLITE_STATIC);
  }
  return *this;
}

Query& Query::operator<<(const Value& value) {
  if (const auto* const number = std::get_if<std::uint64_t>(&value)) return *this << *number;
  if (const auto* const text = std::get_if<std::string>(&value)) return *this << std::string_view(*text);
  return *this << ByteView(std::get<Bytes>(value));
}

Result<bool> Query::step() {
  switch (sqlite3_step(statement_)) {
    case SQLITE_ROW:
      return true;
    case SQLITE_DONE:
      return false;
    default:
      return fail(error_from_sqlite(sqlite3_db_handle(statement_)));
  }
}

Result<void> Query::run() {
  const Result<bool> stepped = step();
  if (!stepped) return fail(stepped.error());
  return {};
}

bool Query::is_null(int column) const {
  return sqlite3_column_type(statement_, column) == SQLITE_NULL;
}

std::uint64_t Query::number(int column) const {
  return std::bit_cast<std::uint64_t>(std::int64_t{sqlite3_column_int64(statement_, column)});
}

std::string Query::text(int column) const {
  const ByteView bytes = blob(column);
  return {bytes.begin(), bytes.end()};
}

ByteView Query::blob(int column) const {
  const void* const data = sqlite3_column_blob(statement_, column);
  const int size = sqlite3_column_bytes(statement_, column);
  if (data == nullptr) return {};
  return {static_cast<const std::uint8_t*>(data), static_cast<std::size_t>(size)};
}

Value Query::value(int column) const {
  switch (sqlite3_column_type(statement_, column)) {
    case SQLITE_INTEGER:
      return number(column);
    case SQLITE_TEXT:
      return text(column);
    default: {
      const ByteView bytes = blob(column);
      return Bytes(bytes.begin(), bytes.end());
    }
  }
}

void Database::Close::operator()(sqlite3* database) const {
  sqlite3_close_v2(database);  // waits for statements that are still held
}

Result<Database> Database::open(const std::filesystem::path& file, const std::string& vfs) {
  sqlite3* raw = nullptr;
  const int flags = SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_EXRESCODE;
  const int code = sqlite3_open_v2(file.c_str(), &raw, flags, vfs.empty() ? nullptr : vfs.c_str());
  Database database;
  database.database_.reset(raw);
  if (code != SQLITE_OK) return fail(error_from_sqlite(raw));
  sqlite3_busy_timeout(raw, 2000);
  return database;
}

Result<Statement> Database::prepare(std::string_view sql) const {
  sqlite3_stmt* raw = nullptr;
  const int code = sqlite3_prepare_v3(database_.get(), sql.data(), static_cast<int>(sql.size()),
                                      SQLITE_PREPARE_PERSISTENT, &raw, nullptr);
  if (code != SQLITE_OK) return fail(error_from_sqlite(database_.get()));
  return Statement(raw);
}

Result<void> Database::run(const std::string& sql) const {
  if (sqlite3_exec(database_.get(), sql.c_str(), nullptr, nullptr, nullptr) != SQLITE_OK) {
    return fail(error_from_sqlite(database_.get()));
  }
  return {};
}

Result<std::uint64_t> Database::number(std::string_view sql) const {
  const Result<Statement> statement = prepare(sql);
  if (!statement) return fail(statement.error());
  Query query(*statement);
  const Result<bool> row = query.step();
  if (!row) return fail(row.error());
  if (!*row) return fail(ErrorCode::corrupt, "map store: no row for " + std::string(sql));
  return query.number(0);
}

bool Database::in_transaction() const {
  return sqlite3_get_autocommit(database_.get()) == 0;
}

void Database::watch_log(LogWatch watch) {
  watch_ = std::make_unique<LogWatch>(std::move(watch));
  const auto after_commit = [](void* watching, sqlite3* database, const char* name, int pages) {
    const bool is_too_long = (*static_cast<LogWatch*>(watching))(static_cast<std::uint64_t>(pages));
    // Its failure is none of the commit's.
    if (is_too_long) sqlite3_wal_checkpoint_v2(database, name, SQLITE_CHECKPOINT_PASSIVE, nullptr, nullptr);
    return SQLITE_OK;
  };
  sqlite3_wal_hook(database_.get(), after_commit, watch_.get());
}

void Database::stop_when(std::function<bool()> stops) {
  constexpr int kStepsBetweenQuestions = 10'000;
  stops_ = std::make_unique<std::function<bool()>>(std::move(stops));
  const auto ask = [](void* asked) { return (*static_cast<std::function<bool()>*>(asked))() ? 1 : 0; };
  sqlite3_progress_handler(database_.get(), kStepsBetweenQuestions, ask, stops_.get());
}

Result<void> Database::empty_log() const {
  const int code = sqlite3_wal_checkpoint_v2(database_.get(), "main", SQLITE_CHECKPOINT_PASSIVE, nullptr, nullptr);
  if (code != SQLITE_OK) return fail(error_from_sqlite(database_.get()));
  return {};
}

void Backup::Finish::operator()(sqlite3_backup* backup) const {
  sqlite3_backup_finish(backup);
}

Result<Backup> Backup::begin(const Database& to, const Database& from) {
  sqlite3_backup* const backup = sqlite3_backup_init(to.database_.get(), "main", from.database_.get(), "main");
  if (backup == nullptr) return fail(error_from_sqlite(to.database_.get()));
  return Backup(backup, to);
}

Result<bool> Backup::step(int pages) {
  const int code = sqlite3_backup_step(backup_.get(), pages);
  if (code == SQLITE_DONE) return true;
  if (code == SQLITE_OK) return false;
  return fail(error_from_sqlite(to_->database_.get(), code, sqlite3_errstr(code)));
}

std::uint64_t Backup::pages() const {
  return static_cast<std::uint64_t>(sqlite3_backup_pagecount(backup_.get()));
}

std::uint64_t Backup::remaining() const {
  return static_cast<std::uint64_t>(sqlite3_backup_remaining(backup_.get()));
}

Result<ReadTransaction> ReadTransaction::begin(const Database& database) {
  const Result<void> begun = database.run("BEGIN");
  if (!begun) return fail(begun.error());
  return ReadTransaction(database);
}

ReadTransaction::~ReadTransaction() {
  if (database_ != nullptr && database_->in_transaction()) (void)database_->run("COMMIT");
}

Result<WriteTransaction> WriteTransaction::begin(const Database& database) {
  const Result<void> begun = database.run("BEGIN IMMEDIATE");
  if (!begun) return fail(begun.error());
  return WriteTransaction(database);
}

WriteTransaction::~WriteTransaction() {
  // SQLite has rolled back by itself after some errors. A rollback that fails leaves the journal to recovery.
  if (database_ != nullptr && database_->in_transaction()) (void)database_->run("ROLLBACK");
}

Result<void> WriteTransaction::commit() {
  return database_->run("COMMIT");
}

}  // namespace weft::storage::sqlite
