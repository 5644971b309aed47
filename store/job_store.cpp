#include "store/job_store.h"

#include "store/database.h"
#include "store/statements.h"

namespace dini::store {
namespace {

/// The columns that `record_in` takes.
const std::string columns =
    "j.id, j.kind, j.state, j.created, j.started, j.finished, j.format, j.total, j.errors, "
    "(SELECT count(*) FROM job_lines l WHERE l.job = j.number), "
    "(SELECT count(*) FROM job_lines l WHERE l.job = j.number AND l.failed) ";
/// States that a job never leaves by itself.
const std::string ended = "('succeeded', 'failed', 'canceled')";

JobRecord record_in(SQLite::Statement& row) {
  return {.id = row.getColumn(0).getString(),
          .kind = row.getColumn(1).getString(),
          .state = row.getColumn(2).getString(),
          .created = row.getColumn(3).getInt64(),
          .started = row.getColumn(4).getInt64(),
          .finished = row.getColumn(5).getInt64(),
          .format = row.getColumn(6).getString(),
          .total = row.getColumn(7).getInt64(),
          .done = row.getColumn(9).getInt64(),
          .failed = row.getColumn(10).getInt64(),
          .errors = row.getColumn(8).getString()};
}

std::optional<JobRecord> record_of(SQLite::Database& database, std::string_view id) {
  SQLite::Statement select(database, "SELECT " + columns + "FROM jobs j WHERE j.id = ?");
  bind_text(select, 1, id);
  if (!select.executeStep()) return std::nullopt;
  return record_in(select);
}

std::optional<AddedJob> job_with_key(SQLite::Database& database, const NewJob& job, const Digest& digest) {
  if (job.idempotency_key.empty()) return std::nullopt;
  SQLite::Statement select(database, "SELECT " + columns + ", j.digest FROM jobs j WHERE j.idempotency_key = ?");
  bind_text(select, 1, job.idempotency_key);
  if (!select.executeStep()) return std::nullopt;
  JobRecord known = record_in(select);
  const bool same = digest_in(select.getColumn(11)) == digest && known.kind == job.kind && known.format == job.format;
  return AddedJob{same ? AddedJob::Outcome::known : AddedJob::Outcome::conflict, std::move(known)};
}

void insert_job(SQLite::Database& database, const NewJob& job, const Digest& digest) {
  SQLite::Statement insert(database,
                           "INSERT INTO jobs (id, kind, state, created, idempotency_key, digest, body, format, total) "
                           "VALUES (?, ?, 'queued', ?, nullif(?, ''), ?, ?, ?, ?)");
  bind_text(insert, 1, job.id);
  bind_text(insert, 2, job.kind);
  insert.bind(3, now_milliseconds());
  bind_text(insert, 4, job.idempotency_key);
  bind_digest(insert, 5, digest);
  bind_bytes(insert, 6, job.body);
  bind_text(insert, 7, job.format);
  insert.bind(8, job.total);
  insert.exec();
}

void keep_file(SQLite::Database& database, std::string_view id, const File& file) {
  SQLite::Statement insert(database,
                           "INSERT OR IGNORE INTO files (sha256, media_type, extension, bytes) VALUES (?, ?, ?, ?)");
  bind_digest(insert, 1, file.sha256);
  bind_text(insert, 2, file.media_type);
  bind_text(insert, 3, file.extension);
  bind_bytes(insert, 4, *file.bytes);
  insert.exec();
  SQLite::Statement link(database,
                         "INSERT OR IGNORE INTO job_files (job, sha256) SELECT number, ? FROM jobs WHERE id = ?");
  bind_digest(link, 1, file.sha256);
  bind_text(link, 2, id);
  link.exec();
}

/// The file in a row of sha256, media_type, extension, bytes.
SharedFile file_in(SQLite::Statement& row) {
  auto file = std::make_shared<File>();
  file->sha256 = digest_in(row.getColumn(0));
  file->media_type = row.getColumn(1).getString();
  file->extension = row.getColumn(2).getString();
  file->bytes = share(row.getColumn(3).getString());
  return file;
}

}  // namespace

JobStore::JobStore(std::shared_ptr<Database> database) : database_(std::move(database)) {}

Result<std::optional<AddedJob>> JobStore::add(const NewJob& job, std::size_t most_waiting) {
  const Digest digest = sha256(job.body);
  return database_->write([&](SQLite::Database& database) -> Result<std::optional<AddedJob>> {
    if (auto known = job_with_key(database, job, digest)) return known;
    const auto waiting = database.execAndGet("SELECT count(*) FROM jobs WHERE state = 'queued'").getInt64();
    if (static_cast<std::size_t>(waiting) >= most_waiting) return std::optional<AddedJob>();
    insert_job(database, job, digest);
    return std::optional(AddedJob{AddedJob::Outcome::added, *record_of(database, job.id)});
  });
}

Result<std::optional<JobRecord>> JobStore::find(std::string_view id) const {
  return database_->read(
      [&](SQLite::Database& database) -> Result<std::optional<JobRecord>> { return record_of(database, id); });
}

Result<std::vector<std::string>> JobStore::unfinished() const {
  return database_->read([](SQLite::Database& database) -> Result<std::vector<std::string>> {
    SQLite::Statement select(
        database, "SELECT id FROM jobs WHERE state IN ('queued', 'running') ORDER BY state = 'queued', number");
    std::vector<std::string> ids;
    while (select.executeStep()) ids.push_back(select.getColumn(0).getString());
    return ids;
  });
}

Result<std::string> JobStore::body(std::string_view id) const {
  return database_->read([&](SQLite::Database& database) -> Result<std::string> {
    SQLite::Statement select(database, "SELECT body FROM jobs WHERE id = ?");
    bind_text(select, 1, id);
    return select.executeStep() ? select.getColumn(0).getString() : std::string();
  });
}

Result<bool> JobStore::begin(std::string_view id) {
  return database_->write([&](SQLite::Database& database) -> Result<bool> {
    SQLite::Statement update(
        database, "UPDATE jobs SET state = 'running', started = ? WHERE id = ? AND state IN ('queued', 'running')");
    update.bind(1, now_milliseconds());
    bind_text(update, 2, id);
    return update.exec() > 0;
  });
}

Result<bool> JobStore::add_lines(std::string_view id, const std::vector<JobLine>& lines) {
  return database_->write([&](SQLite::Database& database) -> Result<bool> {
    for (const JobLine& line : lines) {
      SQLite::Statement insert(database,
                               "INSERT OR REPLACE INTO job_lines (job, line, failed, text) "
                               "SELECT number, ?, ?, ? FROM jobs WHERE id = ?");
      insert.bind(1, static_cast<std::int64_t>(line.index));
      insert.bind(2, line.failed ? 1 : 0);
      bind_text(insert, 3, line.text);
      bind_text(insert, 4, id);
      insert.exec();
      for (const SharedFile& file : line.files) keep_file(database, id, *file);
    }
    return true;
  });
}

Result<bool> JobStore::finish(std::string_view id, std::string_view state, const std::string& errors,
                              const JobResult& result) {
  return database_->write([&](SQLite::Database& database) -> Result<bool> {
    SQLite::Statement update(database,
                             "UPDATE jobs SET state = ?, finished = ?, errors = ?, report = ? "
                             "WHERE id = ? AND state NOT IN " +
                                 ended);
    bind_text(update, 1, state);
    update.bind(2, now_milliseconds());
    bind_text(update, 3, errors);
    bind_text(update, 4, result.report);
    bind_text(update, 5, id);
    if (update.exec() == 0) return false;
    if (result.file) keep_file(database, id, *result.file);
    return true;
  });
}

Result<JobResult> JobStore::result(std::string_view id) const {
  return database_->read([&](SQLite::Database& database) -> Result<JobResult> {
    JobResult result;
    SQLite::Statement report(database, "SELECT report FROM jobs WHERE id = ?");
    bind_text(report, 1, id);
    if (report.executeStep()) result.report = report.getColumn(0).getString();
    SQLite::Statement file(database,
                           "SELECT f.sha256, f.media_type, f.extension, f.bytes FROM jobs j "
                           "JOIN job_files o ON o.job = j.number JOIN files f ON f.sha256 = o.sha256 WHERE j.id = ?");
    bind_text(file, 1, id);
    if (file.executeStep()) result.file = file_in(file);
    return result;
  });
}

Result<std::string> JobStore::lines(std::string_view id) const {
  return database_->read([&](SQLite::Database& database) -> Result<std::string> {
    SQLite::Statement select(
        database, "SELECT l.text FROM jobs j JOIN job_lines l ON l.job = j.number WHERE j.id = ? ORDER BY l.line");
    bind_text(select, 1, id);
    std::string lines;
    while (select.executeStep()) lines += select.getColumn(0).getString() + "\n";
    return lines;
  });
}

Result<SharedFile> JobStore::file(const Digest& sha256) const {
  return database_->read([&](SQLite::Database& database) -> Result<SharedFile> {
    SQLite::Statement select(database, "SELECT sha256, media_type, extension, bytes FROM files WHERE sha256 = ?");
    bind_digest(select, 1, sha256);
    return select.executeStep() ? file_in(select) : SharedFile();
  });
}

Result<bool> JobStore::expire(std::chrono::milliseconds result_time) {
  return database_->write([&](SQLite::Database& database) -> Result<bool> {
    const std::int64_t expired = now_milliseconds() - result_time.count();
    const auto change = [&](const std::string& statement, std::int64_t before) {
      SQLite::Statement changing(database, statement);
      changing.bind(1, before);
      return changing.exec();
    };
    const std::string old = "finished > 0 AND finished < ?";
    int changed = change("DELETE FROM jobs WHERE " + old, expired - result_time.count());
    for (const std::string table : {"job_lines", "job_files"}) {
      changed += change("DELETE FROM " + table + " WHERE job IN (SELECT number FROM jobs WHERE " + old + ")", expired);
    }
    changed += change(
        "UPDATE jobs SET state = 'expired', report = '', body = x'' WHERE " + old + " AND state IN " + ended, expired);
    if (changed > 0) database.exec("DELETE FROM files WHERE sha256 NOT IN (SELECT sha256 FROM job_files)");
    return changed > 0;
  });
}

}  // namespace dini::store
