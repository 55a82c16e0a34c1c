// Every reader of anything from outside: cut short anywhere, numbers that are none, counts that lie. Each runs with
// bounded memory and time.

#include <gtest/gtest.h>

#include <cctype>

#include "recon/core/error.h"
#include "tests/hostile/bounded.h"
#include "tests/hostile/readers.h"

namespace odontoscope::hostile {
namespace {

class Hostile : public ::testing::TestWithParam<Reader> {};

/// Accepted or refused; anything else that is thrown names what was read.
bool is_accepted(const Reader& reader, const std::string& bytes, const std::string& what) {
  try {
    reader.read(bytes);
    return true;
  } catch (const InputError& error) {
    if (error.place().file.empty()) throw std::logic_error(what + ": the error names no file");
    return false;
  } catch (const FileError&) {
    return false;
  } catch (const std::exception& error) {
    throw std::logic_error(what + ": " + error.what());
  }
}

TEST_P(Hostile, CutShortAnywhere) {
  const Reader& reader = GetParam();
  for (const Seed& seed : seeds_of(reader)) {
    const std::size_t step = seed.bytes.size() > 20'000 ? 1024 : 1;
    const std::string outcome = outcome_within({}, [&] {
      std::size_t refused = 0, tried = 0;
      for (std::size_t n = 0; n < seed.bytes.size(); n += step, ++tried) {
        if (!is_accepted(reader, seed.bytes.substr(0, n), "cut to " + std::to_string(n))) ++refused;
      }
      // Settings are never refused, and some formats may end anywhere behind their first triangle.
      if (refused < tried / 10 && reader.name != "settings" && reader.name != "sniff")
        throw std::logic_error("hardly anything was refused");
    });
    EXPECT_EQ(outcome, "accepted") << seed.name;
  }
}

/// Where numbers stand in a text, as first byte and length.
std::vector<std::pair<std::size_t, std::size_t>> numbers_in(const std::string& text) {
  std::vector<std::pair<std::size_t, std::size_t>> found;
  const auto part = [&](std::size_t at) {
    return at < text.size() &&
           (std::isdigit(static_cast<unsigned char>(text[at])) || text[at] == '.' || text[at] == '-');
  };
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (part(end)) ++end;
    if (end > at) found.emplace_back(at, end - at);
    at = std::max(end, at + 1);
  }
  return found;
}

/// Reads each seed with each of `words` in place of each number of a text, or written over each byte of another file.
void with_replaced(const Reader& reader, const std::vector<std::string>& text_words,
                   const std::vector<std::string>& binary_words) {
  for (const Seed& seed : seeds_of(reader)) {
    if (seed.bytes.size() > 20'000) continue;
    const std::string outcome = outcome_within({.seconds = 60}, [&] {
      if (reader.text) {
        for (const auto& [at, length] : numbers_in(seed.bytes)) {
          for (const std::string& word : text_words) {
            is_accepted(reader, std::string(seed.bytes).replace(at, length, word),
                        word + " at byte " + std::to_string(at));
          }
        }
        return;
      }
      const std::size_t step = 1 + seed.bytes.size() / 4'000;
      for (std::size_t at = 0; at < seed.bytes.size(); at += step) {
        for (const std::string& word : binary_words) {
          is_accepted(reader, std::string(seed.bytes).replace(at, word.size(), word),
                      "changed from byte " + std::to_string(at));
        }
      }
    });
    EXPECT_EQ(outcome, "accepted") << seed.name;
  }
}

std::string four(unsigned a, unsigned b, unsigned c, unsigned d) {
  return {static_cast<char>(a), static_cast<char>(b), static_cast<char>(c), static_cast<char>(d)};
}

TEST_P(Hostile, NumbersThatAreNone) {
  const std::string nan = four(0, 0, 0xc0, 0x7f), infinity = four(0, 0, 0x80, 0xff),
                    double_nan = four(0, 0, 0, 0) + four(0, 0, 0xf8, 0x7f);
  with_replaced(GetParam(), {"nan", "-inf", "Infinity", "1e999", "-1e308", "1e-320"}, {nan, infinity, double_nan});
}

TEST_P(Hostile, CountsThatLie) {
  with_replaced(GetParam(), {"0", "-1", "1000", "100000000", "4294967295", "18446744073709551615", "1e15"},
                {four(0, 0, 0, 0), four(0xff, 0xff, 0xff, 0xff), four(0xff, 0xff, 0xff, 0x7f), four(0, 0, 0, 1)});
}

std::string name_of(const ::testing::TestParamInfo<Reader>& info) {
  std::string name = info.param.name;
  name.erase(std::remove(name.begin(), name.end(), ' '), name.end());
  return name;
}

INSTANTIATE_TEST_SUITE_P(Readers, Hostile, ::testing::ValuesIn(readers()), name_of);

// --- the bounds themselves -------------------------------------------------------------------------------------------

TEST(Bounds, StopWhatTakesTooMuch) {
  EXPECT_EQ(outcome_within({.seconds = 1},
                           [] {
                             for (volatile bool endless = true; endless;) {
                             }
                           }),
            "out of time");
  EXPECT_EQ(outcome_within({}, [] { std::abort(); }), "ended by signal 6");
  EXPECT_EQ(outcome_within({}, [] { throw std::logic_error("x"); }), "threw x");
#if !defined(__SANITIZE_ADDRESS__)
#if !defined(__has_feature)
  EXPECT_EQ(outcome_within({.megabytes = 64}, [] { std::vector<char>(80u << 20).at(1) = 1; }), "out of memory");
  EXPECT_EQ(outcome_within({.megabytes = 128}, [] { std::vector<char>(80u << 20).at(1) = 1; }), "accepted");
#endif
#endif
}

}  // namespace
}  // namespace odontoscope::hostile
