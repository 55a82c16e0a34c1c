#include "recon/input/json_source.h"

#include <fmt/format.h>

#include <algorithm>
#include <cerrno>
#include <cstring>

#include "recon/core/limits.h"
#include "recon/core/patient_read.h"

namespace odontoscope {

JsonSource JsonSource::from_file(const std::string& file, std::stop_token stop) {
  JsonSource source;
  source.name_ = file;
  source.stop_ = std::move(stop);
  source.file_ = system::open_to_read(file);
  if (!source.file_.is_open()) {
    throw FileError(file, fmt::format("cannot be read: {}", std::strerror(errno)),
                    "Check its name and your rights to it");
  }
  source.buffer_.resize(limits::read_piece);
  return source;
}

JsonSource JsonSource::from_bytes(std::string_view bytes, std::string name) {
  JsonSource source;
  source.name_ = std::move(name);
  source.piece_ = bytes;
  return source;
}

bool JsonSource::fetch() {
  if (!file_.is_open()) {
    ended_ = true;
    return false;
  }
  if (offset() - marked_ > limits::json_token) {
    throw InputError("too-large", place(),
                     fmt::format("a single text, number or gap of more than {} bytes", limits::json_token),
                     "Check that this is the file you mean");
  }
  const Place end = place();
  const std::size_t column_of_end = column() - 1;
  taken_before_ = offset();
  lines_before_ = *end.line - 1;
  line_start_ = taken_before_ - column_of_end;
  position_ = counted_ = counted_ends_ = 0;
  piece_ = {};
  const std::ptrdiff_t read = read_some(file_, buffer_.data(), buffer_.size(), stop_);
  const auto got = static_cast<std::size_t>(std::max<std::ptrdiff_t>(read, 0));
  if (read < 0) {
    throw FileError(name_, fmt::format("cannot be read: {}", std::strerror(errno)), "Check that it is a file");
  }
  if (taken_before_ + got > limits::file_bytes) {
    throw InputError("file-too-large", end, fmt::format("the file holds more than {} bytes", limits::file_bytes),
                     "Split it, or check that it is the file you mean");
  }
  piece_ = {buffer_.data(), got};
  ended_ = got == 0;
  return got > 0;
}

Place JsonSource::place() const {
  Place place;
  place.file = name_;
  const std::string_view more = piece_.substr(counted_, position_ - counted_);
  counted_ends_ += static_cast<std::size_t>(std::count(more.begin(), more.end(), '\n'));
  counted_ = position_;
  place.line = lines_before_ + counted_ends_ + 1;
  return place;
}

std::size_t JsonSource::column() const {
  const std::size_t last_end = piece_.substr(0, position_).rfind('\n');
  const std::size_t start = last_end == std::string_view::npos ? line_start_ : taken_before_ + last_end + 1;
  return offset() - start + 1;
}

}  // namespace odontoscope
