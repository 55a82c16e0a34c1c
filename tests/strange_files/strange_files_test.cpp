// Strange stacks as files: a stack of each kind is read, reconstructed and written by the program, which must end as
// the library does.

#include <sstream>

#include "recon/core/error.h"
#include "recon/delaunay/reconstruct.h"
#include "tests/app/program.h"
#include "tests/support/stack_text.h"
#include "tests/support/strange_stacks.h"

namespace odontoscope::testing_support {
namespace {

constexpr const char* formats[] = {"out.ply", "out.glb", "out.vtu", "out.obj", "out.msh"};

struct Asked {
  Correspondence correspondence;
  Between between;
};

class StrangeFiles : public ProgramTest {
 protected:
  /// Empty, or the cause for which the library refuses.
  static std::string refusal_of(const test::StrangeStack& strange, const Asked& asked) {
    try {
      reconstruct(strange.stack,
                  {.correspondence = asked.correspondence, .between = asked.between, .links = strange.links});
      return {};
    } catch (const InputError& refusal) {
      return refusal.cause();
    }
  }

  Ending program_on(const test::StrangeStack& strange, const Asked& asked, const std::string& output) {
    given("in.json", test::to_text(strange.stack));
    std::vector<std::string> words{"reconstruct",
                                   "in.json",
                                   "-o",
                                   output,
                                   "--report",
                                   "report.json",
                                   "--correspondence",
                                   name(asked.correspondence),
                                   "--between",
                                   asked.between == Between::blended ? "blended" : "delaunay"};
    if (!strange.links.empty()) {
      given("links.json", test::to_text(strange.links));
      words.insert(words.end(), {"--links", "links.json"});
    }
    return odontoscope(words);
  }

  void judge(std::uint64_t seed) {
    const test::StrangeStack strange = test::strange_stack(seed, test::StrangeSize::cheap);
    constexpr Correspondence criteria[] = {Correspondence::tracked, Correspondence::overlap, Correspondence::medial};
    const Asked asked{criteria[seed % 3], seed % 2 == 0 ? Between::blended : Between::delaunay};
    const std::string output = formats[seed % std::size(formats)], refusal = refusal_of(strange, asked);
    const Ending ending = program_on(strange, asked, output);
    std::ostringstream what;
    what << "seed " << seed << ", " << strange.kind << ", exit " << ending.exit_code << ", signal " << ending.signal
         << "\n"
         << ending.err;
    EXPECT_EQ(ending.exit_code, refusal.empty() ? 0 : 3) << what.str();
    EXPECT_EQ(exists(output), refusal.empty()) << what.str();
    EXPECT_EQ(exists("report.json"), refusal.empty()) << what.str();
    EXPECT_TRUE(refusal.empty() || ending.complains("[" + refusal + "]")) << what.str();
    for (const char* file : {output.c_str(), "report.json"}) std::filesystem::remove(folder / file);
  }
};

TEST_F(StrangeFiles, EndAsTheLibraryDoes) {
  const std::uint64_t kinds = test::strange_kinds().size();
  for (std::uint64_t kind = 0; kind < kinds; ++kind) judge(kind + kinds * (kind % 7));
}

}  // namespace
}  // namespace odontoscope::testing_support
