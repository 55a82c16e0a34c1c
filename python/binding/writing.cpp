#include "python/binding/writing.h"

#include <algorithm>
#include <filesystem>

#include "python/binding/session.h"
#include "python/binding/watched.h"
#include "recon/core/atomic_file.h"
#include "recon/core/lower_case.h"
#include "recon/output/model_file.h"

namespace odontoscope::python {
namespace {

struct WriteWords {
  GlbOptions glb;  // tours and hotspots in it by whoever knows the way through the model
  app::VoxelWords voxels;
};

WriteWords write_words(const py::dict& given, const GlbOptions& within) {
  WriteWords words{within, {given["voxels"].cast<std::string>(), given["voxel_origin"].cast<std::string>()}};
  words.glb.compressed = given["compress"].cast<bool>();
  words.glb.see_through = given["see_through"].cast<bool>();
  words.glb.variants = given["variants"].cast<bool>();
  return words;
}

bool is_gltf(const std::string& file) {
  const std::string ending = lower_case(std::filesystem::path(file).extension().string());
  return ending == ".glb" || ending == ".gltf";
}

void refuse_senseless(const Model& model, const std::vector<std::string>& files, const WriteWords& words) {
  const bool of_gltf = words.glb.compressed || words.glb.see_through || words.glb.variants ||
                       !words.glb.paths.empty() || !words.glb.hotspots.empty();
  if (of_gltf && std::none_of(files.begin(), files.end(), is_gltf))
    throw UsageError("tours, see_through, variants, hotspots and compress are about .glb and .gltf",
                     "Write one of these too");
  app::refuse_senseless(words.voxels, files, model.origin && model.origin->whence.grid);
  if (model.origin && model.origin->reshaped) app::refuse_reshaped(files);
  const bool moved = model.origin && model.origin->facts && model.origin->facts->as_given;
  for (const std::string& file : files) {
    if (model.db && app::is_structures_file(file))
      throw UsageError(file + ": surfaces of the DB method may be open, and have no inside", "Use method=\"dt\"");
    if (moved && lower_case(file).ends_with(".inp"))
      throw UsageError(file + ": .inp names the nodes of the first and last slice, which would lie aslant",
                       "Leave out as_given: the report's matrix tells the turn");
  }
}

FileContent content_of(const Model& model, const std::string& file, const WriteWords& words, app::Session& session) {
  if (!app::is_structures_file(file))
    return model.dt ? model_file(model.dt->reconstruction, file, words.glb)
                    : model_file(model.db->reconstruction, file, words.glb);
  const DtModel& exact = model.exact ? *model.exact : *model.dt;
  return app::structures_file(exact.reconstruction, *model.contours, file, words.voxels,
                              model.origin ? model.origin->whence : app::Whence{}, session);
}

}  // namespace

void write(const Model& model, const std::vector<std::string>& files, const py::dict& given, const GlbOptions& within,
           const py::object& listener) {
  const WriteWords words = write_words(given, within);
  refuse_senseless(model, files, words);
  QuietSession session;
  run_watched(listener, [&](const Progress& progress) {
    std::vector<FileContent> contents;
    for (const std::string& file : files)
      contents.push_back(content_of(model, file, words, session.watched_by(progress)));
    progress.check();
    write_files(contents);
  });
  session.warn();
}

void write_texts(const std::vector<std::pair<std::string, std::string>>& texts) {
  std::vector<FileContent> contents;
  for (const auto& [file, text] : texts) contents.push_back({file, text});
  const py::gil_scoped_release unlocked;
  write_files(contents);
}

}  // namespace odontoscope::python
