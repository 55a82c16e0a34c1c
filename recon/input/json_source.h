#pragma once
// The bytes of a JSON text, handed to the parser one by one: from memory, or from a file in small pieces so that a
// large file never lies in memory as a whole.

#include <cstddef>
#include <iterator>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "recon/core/error.h"
#include "recon/core/system_files.h"

namespace odontoscope {

class JsonSource {
 public:
  /// Opens `file`; FileError if that fails. Pipes can be read too, and given up by `stop`: Cancelled.
  static JsonSource from_file(const std::string& file, std::stop_token stop = {});
  /// `bytes` must outlive the source; `name` stands for the file in messages.
  static JsonSource from_bytes(std::string_view bytes, std::string name);

  /// True once there is nothing more to take. Fetches the next piece where one is needed: FileError if the file cannot
  /// be read; InputError file-too-large beyond limits::file_bytes, too-large for a single token beyond
  /// limits::json_token.
  bool at_end() { return position_ == piece_.size() && !fetch(); }
  /// The byte at hand. Precondition: !at_end().
  char peek() const { return piece_[position_]; }
  void take() { ++position_; }
  /// Tells that everything taken so far was understood: a new token starts.
  void mark() { marked_ = offset(); }

  /// Bytes taken so far.
  std::size_t offset() const { return taken_before_ + position_; }
  /// Whether the end has been met.
  bool ended() const { return ended_; }
  /// The next bytes, up to `count`, as far as they are at hand.
  std::string_view upcoming(std::size_t count) const { return piece_.substr(position_, count); }
  /// File and line, from 1, of the last byte taken. Asked again and again, it counts every byte once.
  Place place() const;
  /// Column in that line, from 1.
  std::size_t column() const;
  const std::string& name() const { return name_; }

  /// What the parser iterates over.
  class Iterator {
   public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = char;

    Iterator() = default;
    explicit Iterator(JsonSource* source) : source_(source) {}
    char operator*() const { return source_->peek(); }
    Iterator& operator++() {
      source_->take();
      return *this;
    }
    Iterator operator++(int) {
      const Iterator before = *this;
      ++*this;
      return before;
    }
    /// Only the question "at the end?" makes sense.
    friend bool operator==(const Iterator& a, const Iterator& b) { return a.done() == b.done(); }

   private:
    bool done() const { return source_ == nullptr || source_->at_end(); }
    JsonSource* source_ = nullptr;
  };
  Iterator begin() { return Iterator(this); }
  Iterator end() { return {}; }

 private:
  bool fetch();

  std::string name_;
  system::Descriptor file_;
  std::stop_token stop_;
  std::vector<char> buffer_;
  std::string_view piece_;
  std::size_t position_ = 0;
  std::size_t taken_before_ = 0;  // bytes of the pieces before this one
  std::size_t lines_before_ = 0;  // ends of line in them
  std::size_t line_start_ = 0;    // offset of the first byte of the line that this piece starts in
  std::size_t marked_ = 0;
  mutable std::size_t counted_ = 0;       // bytes of this piece in which ends of line were counted
  mutable std::size_t counted_ends_ = 0;  // and how many those were
  bool ended_ = false;
};

}  // namespace odontoscope
