#include "studies/runner/row_store.hpp"

#include "pfv/problem/error.hpp"
#include "pfv/problem/text.hpp"
#include "studies/runner/files.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <fcntl.h>
#include <sys/file.h>
#include <system_error>
#include <unistd.h>

namespace studies {

namespace {

struct StoredRows {
  std::vector<Row> rows;
  std::size_t complete_bytes = 0;
  std::vector<std::string> damage; // by record that cannot be read
};

StoredRows load(const std::filesystem::path& file) {
  if (!std::filesystem::exists(file))
    return {};
  const CsvText text = parse_csv(pfv::read_text(file));
  StoredRows stored{{}, text.complete_bytes, {}};
  if (text.records.empty())
    return stored;
  if (text.records.front() != row_columns())
    throw pfv::InputError(
        fmt::format("{}: its columns are those of another version; --fresh starts over", file.string()));
  for (std::size_t i = 1; i < text.records.size(); ++i) {
    try {
      stored.rows.push_back(row_from(text.records[i]));
    } catch (const pfv::InputError& error) {
      stored.damage.push_back(fmt::format("{}: record {}: {}", file.string(), i, error.what()));
    }
  }
  return stored;
}

void rewrite(const std::filesystem::path& file, StoredRows& stored) {
  std::string text = to_csv(row_columns());
  for (const Row& row : stored.rows)
    text += to_csv(to_record(row));
  std::filesystem::path damaged = file;
  damaged += ".damaged";
  std::filesystem::copy_file(file, damaged, std::filesystem::copy_options::overwrite_existing);
  write_file(file, text);
  stored.complete_bytes = text.size();
}

[[noreturn]] void cannot(const std::string& what, const std::filesystem::path& file) {
  throw std::system_error(errno, std::generic_category(), "cannot " + what + " " + file.string());
}

int open_or_throw(const std::filesystem::path& file, int flags) {
  const int descriptor = ::open(file.c_str(), flags | O_CREAT | O_CLOEXEC, 0644);
  if (descriptor < 0)
    cannot("open", file);
  return descriptor;
}

} // namespace

std::vector<Row> read_rows(const std::filesystem::path& file) {
  StoredRows stored = load(file);
  if (!stored.damage.empty())
    throw pfv::InputError(stored.damage.front());
  return std::move(stored.rows);
}

RowStore::RowStore(const std::filesystem::path& folder, bool fresh) : file_(folder / "rows.csv") {
  std::filesystem::create_directories(folder);
  lock_ = open_or_throw(folder / "lock", O_RDWR);
  if (::flock(lock_, LOCK_EX | LOCK_NB) != 0) {
    ::close(lock_);
    throw pfv::InputError(folder.string() + " is in use by another study run; wait for it or give another --work");
  }
  try {
    StoredRows stored = fresh ? StoredRows{} : load(file_);
    if (!stored.damage.empty()) {
      rewrite(file_, stored);
      repaired_ = fmt::format("{}; {} left out, kept in {}.damaged, and done again", stored.damage.front(),
                              stored.damage.size() == 1 ? "it was" : fmt::format("{} such were", stored.damage.size()),
                              file_.filename().string());
    }
    rows_ = std::move(stored.rows);
    rows_file_ = open_or_throw(file_, O_WRONLY | O_APPEND);
    if (::ftruncate(rows_file_, static_cast<off_t>(stored.complete_bytes)) != 0)
      cannot("cut", file_);
  } catch (...) {
    ::close(rows_file_);
    ::close(lock_);
    throw;
  }
}

RowStore::~RowStore() {
  ::close(rows_file_);
  ::close(lock_);
}

void RowStore::append(const Row& row) {
  // The header goes with the first row, in one write: there is never a moment with half of it.
  const bool first = ::lseek(rows_file_, 0, SEEK_END) == 0;
  const std::string text = (first ? to_csv(row_columns()) : "") + to_csv(to_record(row));
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::write(rows_file_, text.data() + done, text.size() - done);
    if (count < 0 && errno != EINTR)
      cannot("write", file_);
    done += count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  if (::fsync(rows_file_) != 0)
    cannot("write", file_);
  rows_.push_back(row);
}

} // namespace studies
