#include "recon/delaunay/verdict.h"

#include <fmt/format.h>

#include <algorithm>

#include "recon/core/grouped.h"

namespace odontoscope {
namespace {

bool plain(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
         c == '+' || c == '.' || c == ':';
}

std::string quoted_for_shell(const std::string& word) {
  if (std::all_of(word.begin(), word.end(), plain)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

struct Sum {
  std::size_t slabs = 0, count = 0;
  double volume = 0;
};

std::string slabs_in_words(std::size_t slabs) { return slabs == 1 ? "1 slab" : grouped(slabs) + " slabs"; }

}  // namespace

const char* name(AttentionKind kind) {
  switch (kind) {
    case AttentionKind::choice:
      return "choice";
    case AttentionKind::gap:
      return "gap";
    case AttentionKind::void_gap:
      return "void-gap";
    case AttentionKind::topology:
      return "topology";
    case AttentionKind::loose_piece:
      return "loose-piece";
  }
  return "unknown";
}

const char* name(SlabChange::Kind kind) {
  switch (kind) {
    case SlabChange::Kind::trimmed:
      return "trimmed";
    case SlabChange::Kind::raised:
      return "raised";
    case SlabChange::Kind::interpolated:
      return "interpolated";
  }
  return "unknown";
}

const char* name(Verdict verdict) {
  switch (verdict) {
    case Verdict::green:
      return "green";
    case Verdict::amber:
      return "amber";
    case Verdict::red:
      return "red";
  }
  return "unknown";
}

Verdict verdict_of(const Reconstruction& made) {
  const bool sound = std::all_of(made.solids.begin(), made.solids.end(),
                                 [](const Solid& solid) { return solid.report.closed_oriented_manifold(); });
  if (!made.certified || !sound) return Verdict::red;
  const bool as_implied = std::all_of(made.topology.begin(), made.topology.end(),
                                      [](const SlabTopology& slab) { return slab.as_implied(); });
  return as_implied && made.attention.empty() ? Verdict::green : Verdict::amber;
}

std::string headline(const Reconstruction& made) {
  switch (verdict_of(made)) {
    case Verdict::green:
      return "Green: certified, and every slab has the pieces, handles and bubbles that contours and links imply";
    case Verdict::amber:
      return fmt::format("Amber: certified, but look at {}",
                         made.attention.size() == 1 ? "1 place" : grouped(made.attention.size()) + " places");
    case Verdict::red:
      break;
  }
  return "Red: not certified";
}

std::string in_words(const Attention& item) {
  const bool one_slice = item.slice == item.last_slice;
  const std::string slices = one_slice ? fmt::format("slice {} (z {:.6g} mm)", item.slice, item.z_lower)
                                       : fmt::format("slices {} {} {} (z {:.6g} to {:.6g} mm)", item.slice,
                                                     item.last_slice == item.slice + 1 ? "and" : "to", item.last_slice,
                                                     item.z_lower, item.z_upper);
  std::string words = fmt::format("{}, {}, near ({:.2f}, {:.2f}, {:.2f}): {}", item.structure, slices, item.place.x,
                                  item.place.y, item.place.z, item.seen);
  if (!(item.expected == item.found))
    words += fmt::format(" Euler characteristic expected {}, found {}.", item.expected.euler(), item.found.euler());
  if (!item.remedy.empty()) words += " " + item.remedy;
  return words;
}

std::string option_for(const Link& link) {
  return fmt::format("{} {}", link.connect ? "--link" : "--unlink",
                     quoted_for_shell(fmt::format("{}:{}:{}-{}", link.structure, link.slice, link.lower, link.upper)));
}

std::string in_words(const std::vector<SlabChange>& changes) {
  if (changes.empty()) return {};
  Sum trimmed, raised, interpolated;
  for (const SlabChange& change : changes) {
    Sum& sum = change.kind == SlabChange::Kind::trimmed  ? trimmed
               : change.kind == SlabChange::Kind::raised ? raised
                                                         : interpolated;
    ++sum.slabs;
    sum.count += change.count;
    sum.volume += change.volume;
  }
  std::string words;
  const auto add = [&words](const std::string& more) { words += (words.empty() ? "" : "; ") + more; };
  if (trimmed.slabs > 0)
    add(fmt::format("overhangs trimmed in {} ({:.3g} mm^3)", slabs_in_words(trimmed.slabs), trimmed.volume));
  if (raised.slabs > 0) add(fmt::format("{} raised ({:.3g} mm^3)", slabs_in_words(raised.slabs), raised.volume));
  if (interpolated.slabs > 0)
    add(fmt::format(
        "{} through {} ({:.3g} mm^3)", slabs_in_words(interpolated.slabs),
        interpolated.count == 1 ? "1 interpolated slice" : grouped(interpolated.count) + " interpolated slices",
        interpolated.volume));
  return "Changed between slices: " + words;
}

}  // namespace odontoscope
