#pragma once
// Everything that reads bytes from outside, in one list, so that no reader is forgotten when all are treated badly.

#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

namespace odontoscope::hostile {

/// A reader accepted what it should not have.
struct Unsound : std::logic_error {
  using std::logic_error::logic_error;
};

struct Reader {
  std::string name;
  /// Folders of tests/corpus with files that it is meant for, good and bad.
  std::vector<std::string> seeds;
  /// Text formats have their numbers replaced by what is none; of others, any four bytes.
  bool text = true;
  /// Throws what the reader throws, and Unsound if the result holds a number that is not finite or an index that leads
  /// nowhere.
  void (*read)(const std::string& bytes) = nullptr;
  friend void PrintTo(const Reader& reader, std::ostream* out) { *out << reader.name; }
};

const std::vector<Reader>& readers();
const Reader& reader(const std::string& name);

/// Content of the seeds, with their names, in a fixed order.
struct Seed {
  std::string name, bytes;
};
std::vector<Seed> seeds_of(const Reader& reader);

}  // namespace odontoscope::hostile
