#pragma once

#include "studies/runner/row.hpp"

#include <filesystem>
#include <vector>

namespace studies {

/// The rows of a file, oldest first; none when there is no file. A last line torn off by a kill is left out.
/// Throws pfv::InputError with file and record when the columns are not those of this version or a value cannot be
/// read (RowStore repairs that).
std::vector<Row> read_rows(const std::filesystem::path& file);

/// The rows of a work folder, open for appending. Only one process at a time holds a folder.
class RowStore {
public:
  /// Makes the folder, cuts off a torn last line of its rows.csv and reads the rest. When a record of it cannot be
  /// read, the file is kept as rows.csv.damaged and replaced by one of the records that can.
  /// `fresh` forgets the rows there are. Throws pfv::InputError when another process holds the folder,
  /// std::system_error when it cannot be written.
  explicit RowStore(const std::filesystem::path& folder, bool fresh = false);
  ~RowStore();
  RowStore(const RowStore&) = delete;
  RowStore& operator=(const RowStore&) = delete;

  /// On return the row is on the disk, whole: one write at the end of the file, then fsync. Not thread-safe.
  void append(const Row& row);
  const std::vector<Row>& rows() const { return rows_; }
  /// What was wrong with the file and what became of it, in a line; empty when it was sound.
  const std::string& repaired() const { return repaired_; }

private:
  std::filesystem::path file_;
  int lock_ = -1;
  int rows_file_ = -1;
  std::vector<Row> rows_;
  std::string repaired_;
};

} // namespace studies
