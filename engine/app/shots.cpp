#include "engine/app/shots.h"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <vector>

#include "engine/app/child_run.h"
#include "engine/app/piped_process.h"
#include "engine/picture/png.h"
#include "recon/core/error.h"
#include "recon/core/lower_case.h"
#include "recon/core/read_file.h"

namespace odontoscope::app {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_scene = 16u << 20;       // bytes
constexpr std::size_t unbounded_megabytes = 1u << 24;  // of address space, of which software that draws takes a lot
constexpr int usual_width = 1200, usual_height = 900;

bool is_scene(const fs::path& file) {
  std::error_code error;
  if (fs::file_size(file, error) > largest_scene || error) return false;
  const auto json = nlohmann::json::parse(read_file(file.string(), largest_scene), nullptr, false);
  return json.is_object() && json.contains("format") && json["format"] == "odontoscope.scene";
}

/// Where the file belongs in a source; null: nowhere.
std::string ShotSource::*part_of(const fs::path& file) {
  const std::string ending = lower_case(file.extension().string());
  if (ending == ".html") return &ShotSource::page;
  if (ending == ".glb") return &ShotSource::glb;
  return ending == ".json" && is_scene(file) ? &ShotSource::scene : nullptr;
}

std::string picture_name(fs::path file) { return file.replace_extension(".png").generic_string(); }

/// What the program said, without its own name.
std::string plain(const std::string& said) {
  constexpr std::string_view name = "odontoscope: ";
  const std::size_t at = said.rfind(name);
  std::string words = at == said.npos ? said : said.substr(at + name.size());
  words.erase(std::min(words.find('\n'), words.size()));
  while (!words.empty() && (words.back() == '.' || words.back() == ' ')) words.pop_back();
  return words;
}

}  // namespace

void Shots::add(const std::string& name, const std::string& file) {
  std::string ShotSource::*part = part_of(file);
  if (part == nullptr) return;
  sources_[name].*part = file;
}

void Shots::check() const {
  for (const auto& [name, source] : sources_) {
    if (!source.page.empty() && !(source.glb.empty() && source.scene.empty()))
      throw UsageError(fmt::format("{} and {} are both the picture {}", source.page,
                                   source.glb.empty() ? source.scene : source.glb, name),
                       "Keep one, or call one otherwise");
    if (source.page.empty() && source.glb.empty() && words_.model.empty())
      throw UsageError(fmt::format("{} is a scene, and nothing says of what", source.scene),
                       "Give --model FILE, or put a GLB of its name beside it");
  }
}

void Shots::find(const std::string& folder, const std::vector<std::string>& besides) {
  std::set<fs::path> left_out;
  for (const std::string& file : besides) left_out.insert(fs::weakly_canonical(file));
  std::error_code error;
  for (fs::recursive_directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code gone;
    if (!entry->is_regular_file(gone) || left_out.contains(fs::weakly_canonical(entry->path(), gone))) continue;
    add(picture_name(entry->path().lexically_relative(folder)), entry->path().string());
  }
  if (error) throw FileError(folder, "cannot be listed: " + error.message(), "Check its permissions");
  const std::set<std::string> there = pictures_below(folder);
  for (const auto& [name, source] : sources_) {
    if (!there.contains(name)) continue;
    const std::string& other = !source.page.empty() ? source.page : !source.glb.empty() ? source.glb : source.scene;
    throw UsageError(fmt::format("{} and {} are both the picture {}", (fs::path(folder) / name).string(), other, name),
                     "Keep one, or call one otherwise");
  }
  check();
}

bool Shots::take(const std::string& file) {
  add(picture_name(fs::path(file).filename()), file);
  check();
  return !sources_.empty();
}

PicturesToDraw Shots::pictures() {
  PicturesToDraw pictures;
  for (const auto& [name, source] : sources_) pictures.names.insert(name);
  pictures.draw = [this](const std::string& name, int width, int height) { return draw(name, width, height); };
  return pictures;
}

Image Shots::draw(const std::string& name, int width, int height) {
  const ShotSource& source = sources_.at(name);
  if (source.page.empty()) return draw_model(source, width, height);
  if (!browser_)
    browser_ = std::make_unique<PageShots>(browser_program(words_.browser), words_.timeout_s, session_.progress());
  return browser_->shoot(source.page, width > 0 ? width : usual_width, height > 0 ? height : usual_height);
}

/// As somebody would type it: what goes wrong in it stays there.
Image Shots::draw_model(const ShotSource& source, int width, int height) {
  const OwnFolder folder;
  const std::string made = (fs::path(folder.path()) / "shot.png").string();
  std::vector<std::string> words{"--quiet",
                                 "--threads",
                                 std::to_string(session_.threads),
                                 "render",
                                 source.glb.empty() ? words_.model : source.glb,
                                 "-o",
                                 made};
  if (session_.threads == 0) words.erase(words.begin() + 1, words.begin() + 3);
  if (!source.scene.empty()) words.insert(words.end(), {"--scene", source.scene});
  if (width > 0) words.insert(words.end(), {"--size", fmt::format("{}x{}", width, height)});
  const ChildEnding ending = run_again(words, {words_.timeout_s, unbounded_megabytes}, session_.progress().stop);
  if (ending.exit_code == 0) return read_png(made);
  Place place;
  place.file = source.scene.empty() ? source.glb : source.scene;
  const std::string why = plain(ending.err);
  throw InputError("cannot-be-shot", place,
                   ending.late   ? fmt::format("it is not drawn within {:g} s", words_.timeout_s)
                   : why.empty() ? "drawing it ended with " + ending.in_words()
                                 : why,
                   "Try it with odontoscope render");
}

}  // namespace odontoscope::app
