// Every file of the corpus: the good ones read and write back, the bad ones give their named error.
#include "tests/input/corpus.h"

#include <gtest/gtest.h>

#include "recon/input/links.h"
#include "recon/input/links_json.h"
#include "recon/input/stack_json.h"
#include "recon/input/validate.h"
#include "tests/input/same_stack.h"

namespace odontoscope {
namespace {

template <class Call>
void expect_cause(const std::filesystem::path& file, Call call) {
  SCOPED_TRACE(file.filename().string());
  try {
    call();
    ADD_FAILURE() << "was accepted";
  } catch (const InputError& error) {
    EXPECT_EQ(error.cause(), corpus::expected_cause(file)) << error.what();
    EXPECT_TRUE(std::string(error.what()).starts_with(file.string())) << error.what();
    for (const char c : std::string(error.what())) ASSERT_GE(static_cast<unsigned char>(c), 0x20) << error.what();
  }
}

TEST(Corpus, BadStacksGiveTheirCause) {
  const auto files = corpus::files("bad");
  EXPECT_GE(files.size(), 100u);
  for (const auto& file : files) {
    expect_cause(file, [&] { validate(read_stack(file.string())); });
    const std::string bytes = read_file(file.string());
    expect_cause(file, [&] { validate(parse_stack(bytes, file.string())); });
  }
}

TEST(Corpus, GoodStacksPassAndSurviveWriting) {
  const auto files = corpus::files("good");
  EXPECT_GE(files.size(), 20u);
  for (const auto& file : files) {
    SCOPED_TRACE(file.filename().string());
    ContourStack stack;
    ASSERT_NO_THROW(stack = read_stack(file.string()));
    ASSERT_NO_THROW(validate(stack));
    EXPECT_EQ(stack.source, file.string());
    const std::string text = to_json(stack);
    const ContourStack again = parse_stack(text, "again");
    EXPECT_EQ(to_json(again), text);
    ASSERT_NO_FATAL_FAILURE(test::expect_same_slices(again, stack));
    const OrderedStack sorted = ordered(stack);
    EXPECT_NO_THROW(validate(sorted.stack));
  }
}

TEST(Corpus, EveryUnitGivesTheSameStack) {
  std::string expected;
  int units = 0;
  for (const auto& file : corpus::files("good")) {
    if (!file.filename().string().starts_with("unit-")) continue;
    SCOPED_TRACE(file.filename().string());
    const std::string text = to_json(read_stack(file.string()));
    if (expected.empty()) expected = text;
    EXPECT_EQ(text, expected);
    ++units;
  }
  EXPECT_EQ(units, 6);
}

TEST(Corpus, LinksFilesGiveTheirCause) {
  const ContourStack stack = read_stack((corpus::folder() / "links_stack.json").string());
  validate(stack);
  const ContourStack sorted = ordered(stack).stack;
  const auto bad = corpus::files("bad_links");
  EXPECT_GE(bad.size(), 25u);
  for (const auto& file : bad) {
    expect_cause(file, [&] { validate_links(read_links(file.string()), sorted, file.string()); });
  }
  const auto good = corpus::files("good_links");
  EXPECT_GE(good.size(), 5u);
  for (const auto& file : good) {
    SCOPED_TRACE(file.filename().string());
    std::vector<Link> links;
    ASSERT_NO_THROW(links = read_links(file.string()));
    EXPECT_NO_THROW(validate_links(links, sorted, file.string()));
    std::vector<ReportedLink> reported;
    for (const Link& link : links) reported.push_back({link, "medial"});
    EXPECT_EQ(parse_links(links_to_json(reported), "again"), links);
  }
}

}  // namespace
}  // namespace odontoscope
