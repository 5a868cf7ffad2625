/// Takes lines, words and bytes from the front of a point cloud's file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace castaway::testbed {

/// Words of a line, between blanks.
class CloudWords {
 public:
  explicit CloudWords(std::string_view line) : rest_(line) {}
  /// The next word; empty at the end of the line.
  std::string_view next();

 private:
  std::string_view rest_;
};

/// A word for an error text: quoted, shortened, and without control characters.
std::string quote_word(std::string_view word);

/// The axis that a field of this name holds: 0, 1, 2 for x, y, z; -1 for others.
int axis_of(std::string_view name);

/// Untrusted bytes, which must outlive it. All errors are std::runtime_error.
class CloudInput {
 public:
  /// `name`: the file's name in errors.
  CloudInput(std::string_view bytes, std::string name);

  /// The next line that is not blank, without its LF. Throws at the end of the file.
  std::string_view line();
  /// The next `count` values of `size` > 0 bytes. Throws if fewer remain.
  std::string_view take(std::uint64_t count, std::uint64_t size);
  /// Throws if fewer than `count` values of `size` > 0 bytes remain.
  void require(std::uint64_t count, std::uint64_t size) const;
  /// Throws unless each of the axes 0, 1, 2 occurs once among those of the fields.
  void require_xyz(const std::vector<int>& axes) const;

  /// Throws an error that names the file.
  [[noreturn]] void fail(const std::string& what) const;
  /// Throws an error that names the file and the last line taken.
  [[noreturn]] void fail_in_line(const std::string& what) const;

 private:
  std::string_view rest_;
  std::string name_;
  std::size_t line_number_ = 0;
};

}  // namespace castaway::testbed
