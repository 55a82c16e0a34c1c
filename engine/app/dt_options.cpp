#include "engine/app/dt_options.h"

#include <fmt/format.h>

#include "engine/app/options.h"
#include "recon/core/error.h"
#include "recon/core/limits.h"
#include "recon/core/read_file.h"
#include "recon/input/links_json.h"
#include "recon/input/validate.h"
#include "recon/partition/reconstruct_structures.h"

namespace odontoscope::app {
namespace {

/// The links file, checked here so that messages name it.
std::vector<Link> links_for(const ValidStack& stack, const DtWords& words, const Session& session) {
  std::vector<Link> links = links_from(words.link_words);
  if (words.links.empty()) return links;
  const std::vector<Link> in_file =
      parse_links(read_file(words.links, limits::file_bytes, session.progress().stop), words.links);
  validate_links(in_file, ordered(stack).stack, words.links);
  links.insert(links.end(), in_file.begin(), in_file.end());
  return links;
}

}  // namespace

void add_dt_options(CLI::App& parser, DtWords& words) {
  const std::string group = "DT method";
  add_choice(parser, "--correspondence", words.correspondence, correspondences,
             "When regions connect: tracked (default), reverse, medial or overlap")
      ->type_name("NAME")
      ->group(group);
  add_choice(parser, "--between", words.between, ways_between,
             "Between slices: blended (default) where walls lean far, or delaunay alone")
      ->type_name("NAME")
      ->group(group);
  parser.add_option("--links", words.links, "Your own choices of what connects; they win")
      ->type_name("FILE.json")
      ->group(group);
  repeatable(parser.add_option("--link", words.link_words.connect,
                               "One such choice: contour B of slice N connects to U of N + 1"))
      ->type_name("NAME:N:B-U")
      ->group(group);
  repeatable(parser.add_option("--unlink", words.link_words.apart, "One such choice: the two are kept apart"))
      ->type_name("NAME:N:B-U")
      ->group(group);
}

void refuse_senseless(const DtWords& words) {
  links_from(words.link_words);
  refuse_senseless(words.partition);
  if (words.partition.wanted && (words.correspondence || !words.links.empty() || words.link_words.any()))
    throw UsageError("--correspondence, --links, --link and --unlink do not work with --partition yet",
                     "Leave them out, or leave out --partition");
}

Reconstruction reconstructed(const ValidStack& stack, const DtWords& words, Session& session) {
  if (words.partition.wanted) {
    PartitionOptions options;
    if (!words.partition.priority.empty()) options.priority = names_in(words.partition.priority, "--priority");
    options.gap = words.partition.gap.value_or(0);
    options.between = words.between.value_or(Between::blended);
    options.threads = session.threads;
    return reconstruct_partition(stack, options, session.progress());
  }
  const ReconstructOptions options = understood(words, stack, session);
  if (words.partition.independent || words.correspondence || !words.links.empty() || words.link_words.any())
    return reconstruct(stack, options, session.progress());
  MadeOfStructures made = reconstruct_structures(stack, options, session.progress());
  if (made.reconstruction.complex)
    session.console.say(
        "Structures share walls or overlap: they became one partition. --independent makes each by itself.");
  if (!made.no_partition.empty())
    session.console.complain(
        fmt::format("warning: no partition came of it, so each structure was made by itself, and neighbours may gape "
                    "or overlap. {}",
                    made.no_partition));
  return std::move(made.reconstruction);
}

void refuse_for_mesh(const DtWords& words, const std::string& file) {
  if (words.partition.wanted)
    throw UsageError(fmt::format("{} is a mesh, and --partition is about what is made from contours", file),
                     "Leave it out, or give what the mesh was made from");
  if (!words.any()) return;
  throw UsageError(fmt::format("{} is a mesh, and --correspondence, --between, --links, --link and --unlink are about "
                               "what is made from contours",
                               file),
                   "Leave them out, or give what the mesh was made from");
}

ReconstructOptions understood(const DtWords& words, const ValidStack& stack, const Session& session) {
  ReconstructOptions options;
  if (words.correspondence) options.correspondence = *words.correspondence;
  if (words.between) options.between = *words.between;
  options.links = links_for(stack, words, session);
  options.threads = session.threads;
  return options;
}

}  // namespace odontoscope::app
