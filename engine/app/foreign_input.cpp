#include "engine/app/foreign_input.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <utility>

#include "engine/app/options.h"
#include "engine/app/plain_input.h"
#include "engine/app/sniff.h"
#include "engine/app/words.h"
#include "recon/core/error.h"
#include "recon/core/read_file.h"
#include "recon/exchange/contour_file.h"
#include "recon/exchange/cut_surfaces.h"
#include "recon/exchange/repair_contours.h"
#include "recon/input/stack_json.h"
#include "recon/input/validate.h"
#include "recon/volume/dicom_file.h"

namespace odontoscope::app {
namespace {

void tell_changes(const std::vector<ContourChange>& changes, Console& console) {
  if (changes.empty()) {
    console.say("  nothing had to be repaired");
    return;
  }
  constexpr std::size_t most_lines = 40;
  console.say(fmt::format("  repaired in {}:", counted(changes.size(), "place")));
  for (std::size_t i = 0; i < std::min(changes.size(), most_lines); ++i) console.say("    " + in_words(changes[i]));
  if (changes.size() > most_lines) console.say(fmt::format("    and {} more", changes.size() - most_lines));
}

std::string structure_of(const NamedMesh& mesh) { return mesh.name.empty() ? "tooth" : structure_of_mesh(mesh.name); }

std::vector<NamedMesh> surfaces_of(std::vector<NamedMesh> meshes, const ForeignWords& words, const std::string& file) {
  std::vector<NamedMesh> surfaces;
  for (NamedMesh& mesh : meshes) surfaces.push_back({structure_of(mesh), std::move(mesh.surface)});
  if (words.structures.empty()) return surfaces;
  // As a stack of their names, so that unknown ones are said as everywhere.
  ContourStack names{{{0, {}}}, file};
  for (const NamedMesh& surface : surfaces) names.slices.front().contours.push_back({surface.name, {}});
  keep_structures(names, words.structures);
  std::erase_if(surfaces, [&](const NamedMesh& surface) {
    return std::find(words.structures.begin(), words.structures.end(), surface.name) == words.structures.end();
  });
  return surfaces;
}

ValidStack cut_told(std::vector<NamedMesh> meshes, const std::string& file, const ForeignWords& words,
                    Session& session) {
  if (!words.spacing_z && words.heights.empty()) {
    throw UsageError(fmt::format("{} is a mesh, and nothing says where to cut it", file),
                     "Give --spacing-z D, or --at Z for each plane");
  }
  std::vector<std::string> remarks;
  for (const NamedMesh& mesh : meshes) remarks.insert(remarks.end(), mesh.remarks.begin(), mesh.remarks.end());
  const std::vector<NamedMesh> surfaces = surfaces_of(std::move(meshes), words, file);
  std::vector<double> heights = words.spacing_z ? heights_at(surfaces, *words.spacing_z) : words.heights;
  std::sort(heights.begin(), heights.end());
  CutOptions options;
  options.repair = words.repair;
  options.widest_gap = words.widest_gap.value_or(options.widest_gap);
  CutContours cut = cut_surfaces(surfaces, heights, file, options, session.progress());
  session.console.say(fmt::format("{}: cut by {}", file, counted(heights.size(), "plane")));
  for (const std::string& remark : remarks) session.console.say("  " + remark);
  if (words.repair) tell_changes(cut.changes, session.console);
  return cut.stack;
}

/// The first bytes of a plain file; of anything else none.
std::string head_of(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  constexpr std::size_t looked_at = 1 << 16;
  std::string head(looked_at, '\0');
  std::ifstream in(file, std::ios::binary);
  in.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return head;
}

[[noreturn]] void refuse_unknown(const std::string& file, std::string_view bytes) {
  refuse_empty(file);
  Place place;
  place.file = file;
  if (bytes.substr(0, 4096).find("<Section") != bytes.npos) {
    throw InputError("unknown-format", std::move(place), "this is one section of a Reconstruct series",
                     "Give the .ser beside it");
  }
  throw InputError("unknown-format", std::move(place), "this is no volume, mesh or contour file that is known here",
                   "The formats are listed by contours --help");
}

void refuse_planes(const std::string& file, const ForeignWords& words) {
  if (!words.spacing_z && words.heights.empty() && !words.widest_gap) return;
  throw UsageError(fmt::format("{} holds contours, and --spacing-z, --at and --widest-gap are about meshes", file),
                   "Leave them out");
}

/// What validate found can be mended here: says so.
[[noreturn]] void offer_repair(const InputError& error) {
  std::string told = error.what();
  told.resize(told.rfind(" ["));
  if (told.ends_with('.')) told.pop_back();
  throw InputError(error.cause(), {}, told, "Or give --repair, which tells what it changes");
}

bool can_be_repaired(const std::string& cause) {
  for (const char* known :
       {"too-few-points", "repeated-point", "zero-area", "self-crossing", "contours-cross", "contours-touch"}) {
    if (cause == known) return true;
  }
  return false;
}

ValidStack checked(ContourStack stack, const ForeignWords& words, Session& session) {
  if (words.repair) {
    RepairedContours repaired = repair_contours(stack, {}, session.progress());
    tell_changes(repaired.changes, session.console);
    stack = std::move(repaired.stack);
  }
  try {
    return validate(std::move(stack), session.progress());
  } catch (const InputError& error) {
    if (words.repair || !can_be_repaired(error.cause())) throw;
    offer_repair(error);
  }
}

}  // namespace

void add_foreign_options(CLI::App& parser, ForeignWords& words) {
  const std::string group = "Meshes and other programs' contours";
  parser.add_option("--spacing-z", words.spacing_z, "Cut a mesh every D mm, from D/2 above its lowest point on")
      ->type_name("D")
      ->group(group);
  repeatable(parser.add_option("--at", words.heights, "Cut a mesh at height Z, mm; repeatable"))
      ->type_name("Z")
      ->group(group);
  repeatable(parser.add_option("--structure", words.structures, "Keep this structure alone; repeatable"))
      ->type_name("NAME")
      ->group(group);
  parser.add_flag("--repair", words.repair, "Mend what breaks the rules, and tell what was changed")->group(group);
  parser
      .add_option("--widest-gap", words.widest_gap,
                  "With --repair: widest gap of a mesh that is closed, mm (default: 0.5)")
      ->type_name("G")
      ->check(at_least_zero())
      ->group(group);
}

void refuse_senseless(const ForeignWords& words, bool of_volume) {
  if (of_volume && words.any()) {
    throw UsageError(
        "--spacing-z, --at, --structure, --repair and --widest-gap are about meshes and contour files, not volumes",
        "Leave them out");
  }
  for (const double height : words.heights) {
    if (!std::isfinite(height)) throw UsageError("--at wants a height in mm");
  }
  if (words.spacing_z && !words.heights.empty())
    throw UsageError("--spacing-z and --at both say where to cut", "Give one of them");
  if (words.widest_gap && !words.repair)
    throw UsageError("--widest-gap is about --repair", "Add --repair, or leave it out");
}

bool is_contour_file(const std::string& file) { return contour_file_kind(head_of(file)).has_value(); }

bool begins_like_a_volume(const std::string& file) {
  const std::string head = head_of(file);
  if (head.empty() || contour_file_kind(head)) return false;
  const FileKind kind = kind_of(head, file);
  return kind == FileKind::volume || (kind == FileKind::unknown && looks_like_dicom(file));
}

bool needs_conversion(const std::string& file, const ForeignWords& words) {
  const std::string head = head_of(file);
  if (words.any() || head.empty()) return words.any();
  if (contour_file_kind(head)) return true;
  const FileKind kind = kind_of(head, file);
  if (kind == FileKind::contour_stack || kind == FileKind::volume) return false;
  // Binary STL is told by its whole size.
  return kind != FileKind::unknown || kind_of(read_file(file), file) == FileKind::stl;
}

ValidStack converted_told(const std::string& file, const ForeignWords& words, Session& session, Whence* whence) {
  const std::string bytes = read_file(file, limits::file_bytes, session.progress().stop);
  const auto contour_kind = contour_file_kind(bytes);
  if (contour_kind || kind_of(bytes, file) == FileKind::contour_stack) refuse_planes(file, words);
  if (contour_kind) {
    FileContours read = read_contour_file(*contour_kind, bytes, file, words.structures);
    session.console.say(fmt::format("{}: {}", file, stack_in_words(read.stack)));
    for (const std::string& remark : read.remarks) session.console.say("  " + remark);
    if (whence) *whence = {read.patient, std::nullopt};
    return checked(std::move(read.stack), words, session);
  }
  const FileKind kind = kind_of(bytes, file);
  if (auto meshes = meshes_in(kind, bytes, file)) return cut_told(std::move(*meshes), file, words, session);
  if (kind == FileKind::volume) {
    throw UsageError(fmt::format("{} is a volume, and nothing says where in it the surface lies", file),
                     "Give --iso T (or --iso auto) for an image, --label N for a label map");
  }
  if (kind == FileKind::unknown) refuse_unknown(file, bytes);
  ContourStack stack = parse_stack(bytes, file);
  keep_structures(stack, words.structures);
  return checked(std::move(stack), words, session);
}

ValidStack meshes_told(const std::vector<std::string>& files, const ForeignWords& words, Session& session) {
  std::vector<NamedMesh> all;
  std::map<std::string, std::string> file_of;  // of each structure
  for (const std::string& file : files) {
    const std::string bytes = read_file(file, limits::file_bytes, session.progress().stop);
    std::optional<std::vector<NamedMesh>> meshes = meshes_in(kind_of(bytes, file), bytes, file);
    if (!meshes)
      throw UsageError(fmt::format("{} is no mesh, and only meshes are read several at a time", file),
                       "Give it by itself");
    if (meshes->size() == 1) meshes->front().name = std::filesystem::path(file).stem().string();
    for (NamedMesh& mesh : *meshes) {
      const std::string structure = structure_of(mesh);
      const auto [known, fresh] = file_of.try_emplace(structure, file);
      if (known->second != file)
        throw UsageError(fmt::format("both {} and {} have a structure called \"{}\"", known->second, file, structure),
                         "Rename one of the files");
      all.push_back(std::move(mesh));
    }
  }
  return cut_told(std::move(all), fmt::format("{}", fmt::join(files, ", ")), words, session);
}

}  // namespace odontoscope::app
