// Mutated files: whatever the bytes, reading succeeds or throws InputError, and what was read goes through `validate`
// with the same two outcomes. Seeded; the fuzzers of tests/fuzz go further.
#include <gtest/gtest.h>

#include <random>

#include "recon/input/links.h"
#include "recon/input/links_json.h"
#include "recon/input/stack_json.h"
#include "recon/input/validate.h"
#include "tests/input/corpus.h"

namespace odontoscope {
namespace {

using namespace std::string_view_literals;

struct Tally {
  int accepted = 0, refused = 0;
};

void try_stack(const std::string& bytes, Tally& tally) {
  try {
    const ContourStack stack = parse_stack(bytes, "fuzz");
    validate(stack);
    ordered(stack);
    ++tally.accepted;
  } catch (const InputError&) {
    ++tally.refused;
  }
}

void try_links(const std::string& bytes, const ContourStack& ordered_stack, Tally& tally) {
  try {
    validate_links(parse_links(bytes, "fuzz"), ordered_stack, "fuzz");
    ++tally.accepted;
  } catch (const InputError&) {
    ++tally.refused;
  }
}

std::vector<std::string> seeds(std::initializer_list<const char*> subfolders) {
  std::vector<std::string> texts;
  for (const char* subfolder : subfolders) {
    for (const auto& file : corpus::files(subfolder)) texts.push_back(read_file(file.string()));
  }
  return texts;
}

/// One of: a bit flipped, a byte replaced by one that means something, a stretch removed, doubled, or spliced in from
/// another.
std::string mutated(std::string text, const std::vector<std::string>& others, std::mt19937& random) {
  const auto below = [&random](std::size_t n) { return n == 0 ? 0 : random() % n; };
  static constexpr std::string_view meaningful = "{}[]\",:0123456789.eE+-ntfaN \n\\\0\xff"sv;
  for (std::size_t times = 1 + below(3); times > 0; --times) {
    const std::size_t at = below(text.size()), length = below(40);
    switch (below(5)) {
      case 0:
        if (!text.empty()) text[at] = static_cast<char>(text[at] ^ (1 << below(8)));
        break;
      case 1:
        if (!text.empty()) text[at] = meaningful[below(meaningful.size())];
        break;
      case 2:
        text.erase(at, length);
        break;
      case 3:
        text.insert(at, text.substr(at, length));
        break;
      case 4: {
        const std::string& other = others[below(others.size())];
        text.insert(at, other.substr(below(other.size()), length));
        break;
      }
      default:
        break;
    }
  }
  return text;
}

TEST(Mutation, StacksAreReadOrRefused) {
  const std::vector<std::string> texts = seeds({"good", "bad"});
  std::mt19937 random(3);
  Tally tally;
  for (int round = 0; round < 40'000; ++round) try_stack(mutated(texts[random() % texts.size()], texts, random), tally);
  EXPECT_GT(tally.accepted, 100);
  EXPECT_GT(tally.refused, 1000);
}

TEST(Mutation, LinksAreReadOrRefused) {
  const ContourStack stack = ordered(read_stack((corpus::folder() / "links_stack.json").string())).stack;
  const std::vector<std::string> texts = seeds({"good_links", "bad_links"});
  std::mt19937 random(4);
  Tally tally;
  for (int round = 0; round < 40'000; ++round) {
    try_links(mutated(texts[random() % texts.size()], texts, random), stack, tally);
  }
  EXPECT_GT(tally.accepted, 100);
  EXPECT_GT(tally.refused, 1000);
}

TEST(Mutation, EveryTruncationIsRefused) {
  for (const char* name : {"good/plain.json", "good/names-of-every-script.json", "good/keys-in-another-order.json"}) {
    const std::string text = read_file((corpus::folder() / name).string());
    const std::size_t last_bracket = text.find_last_of('}');
    for (std::size_t length = 0; length <= last_bracket; ++length) {
      try {
        parse_stack(text.substr(0, length), "fuzz");
        FAIL() << name << " cut to " << length;
      } catch (const InputError& error) {
        ASSERT_EQ(error.cause(), "unparsable") << name << " cut to " << length << ": " << error.what();
      }
    }
  }
}

}  // namespace
}  // namespace odontoscope
