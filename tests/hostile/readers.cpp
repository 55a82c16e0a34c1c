#include "tests/hostile/readers.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "engine/app/sniff.h"
#include "engine/comparison/artefact_lesson.h"
#include "engine/navigate/notes.h"
#include "engine/picture/png.h"
#include "engine/scene/scene_json.h"
#include "engine/viewer/settings.h"
#include "recon/core/read_file.h"
#include "recon/exchange/read_csl.h"
#include "recon/exchange/read_jser.h"
#include "recon/exchange/read_rtstruct.h"
#include "recon/exchange/read_series.h"
#include "recon/formats/read_mesh.h"
#include "recon/input/links_json.h"
#include "recon/input/stack_json.h"
#include "recon/volume/read_volume.h"
#include "tests/hostile/volume_name.h"
#include "tests/output/temporary_folder.h"

namespace odontoscope::hostile {
namespace {

using testing_support::put;
using testing_support::TemporaryFolder;

void finite(std::initializer_list<double> numbers) {
  for (const double number : numbers) {
    if (!std::isfinite(number)) throw Unsound("a number that is not finite was read");
  }
}

void sound(const std::vector<Contour>& contours) {
  for (const Contour& contour : contours) {
    for (const Point2& p : contour.points) finite({p.x, p.y});
  }
}

void sound(const ContourStack& stack) {
  for (const Slice& slice : stack.slices) {
    finite({slice.z});
    sound(slice.contours);
  }
}

void sound(const std::vector<NamedMesh>& meshes) {
  for (const NamedMesh& mesh : meshes) {
    for (const Point3& p : mesh.surface.points) finite({p.x, p.y, p.z});
    for (const Triangle& triangle : mesh.surface.triangles) {
      for (const PointIndex corner : triangle) {
        if (corner >= mesh.surface.points.size()) throw Unsound("a triangle names a point that is not there");
      }
    }
  }
}

void sound(const Camera& camera) {
  for (int axis = 0; axis < 3; ++axis) finite({camera.position[axis], camera.target[axis], camera.up[axis]});
  finite({camera.field_of_view_deg, camera.height_mm, camera.near_mm});
}

void sound(const Scene& scene) {
  sound(scene.camera);
  for (const Look& look : scene.looks) finite({look.opacity});
  if (scene.section) finite({scene.section->point_mm.x, scene.section->normal.x});
  finite({scene.occlusion.strength, scene.occlusion.reach, scene.overlays.shrink});
}

void sound(const Settings& settings) {
  finite({settings.text_scale, settings.comfort.field_of_view_deg, settings.comfort.speed_limit});
  if (settings.window.width < 1 || settings.picture.width < 1) throw Unsound("a picture without width");
}

/// One for all files: to make and remove a folder for each takes longer than to read it.
const TemporaryFolder& folder_of_files() {
  static const TemporaryFolder folder;
  return folder;
}

/// For readers that want a file. It is alone in its folder, since readers of volumes look at what lies beside.
template <class Read>
auto from_file(const std::string& bytes, const std::string& name, Read read) {
  const std::filesystem::path file = folder_of_files() / name;
  struct Removed {
    const std::filesystem::path& path;
    ~Removed() { std::filesystem::remove(path); }
  } const removed{file};
  put(file, bytes);
  return read(file.string());
}

void read_links_text(const std::string& bytes) { parse_links(bytes, "file"); }
void read_artefact_lesson(const std::string& bytes) {
  for (const ArtefactLessonStep& step : parse_artefact_lesson(bytes, "file").steps) sound(step.scene_over(Scene{}));
}
void read_lesson_text(const std::string& bytes) {
  for (const LessonNote& note : parse_lesson(bytes, "file").notes) sound(note.camera);
}
void read_picture(const std::string& bytes) {
  from_file(bytes, "file", [](const std::string& file) { return read_png(file); });
}
void read_any_volume(const std::string& bytes) {
  for (const float value :
       from_file(bytes, volume_name(bytes), [](const std::string& file) { return read_volume(file); }).values)
    finite({value});
}
void sniffed(const std::string& bytes) {
  const app::FileKind kind = app::kind_of(bytes);
  if (const auto meshes = app::meshes_in(kind, bytes, "file")) sound(*meshes);
}

}  // namespace

const std::vector<Reader>& readers() {
  folder_of_files();  // made here, in the process that will remove it, before others are forked from it
  static const std::vector<Reader> all{
      {"stack", {"good", "bad"}, true, [](const std::string& bytes) { sound(parse_stack(bytes, "file")); }},
      {"stack file",
       {"good"},
       true,
       [](const std::string& bytes) {
         sound(from_file(bytes, "file", [](const std::string& file) { return read_stack(file); }));
       }},
      {"links", {"good_links", "bad_links"}, true, read_links_text},
      {"csl", {"exchange/csl"}, true, [](const std::string& bytes) { sound(parse_csl(bytes, "file").stack); }},
      {"series",
       {"exchange/series"},
       true,
       [](const std::string& bytes) {
         const SeriesHeader header = parse_series_header(bytes, "file");
         finite({header.millimetres, header.default_thickness});
       }},
      {"section",
       {"exchange/series"},
       true,
       [](const std::string& bytes) {
         const SeriesSection section = parse_series_section(bytes, "file");
         finite({section.thickness});
         sound(section.contours);
       }},
      {"jser", {"exchange/jser"}, true, [](const std::string& bytes) { sound(parse_jser(bytes, "file").stack); }},
      {"rtstruct",
       {"exchange/rtstruct"},
       false,
       [](const std::string& bytes) { sound(parse_rtstruct(bytes, "file").stack); }},
      {"stl", {"fuzz/stl"}, false, [](const std::string& bytes) { sound(parse_stl(bytes, "file")); }},
      {"ply", {"fuzz/ply"}, false, [](const std::string& bytes) { sound(parse_ply(bytes, "file")); }},
      {"obj", {"fuzz/obj"}, true, [](const std::string& bytes) { sound(parse_obj(bytes, "file")); }},
      {"glb", {"fuzz/glb"}, false, [](const std::string& bytes) { sound(parse_glb(bytes, "file")); }},
      {"gltf",
       {"fuzz/gltf"},
       true,
       [](const std::string& bytes) { sound(parse_gltf(bytes, "no-such-folder/file.gltf")); }},
      {"sniff", {"fuzz/sniff", "fuzz/stl", "fuzz/obj"}, false, sniffed},
      {"volume", {"fuzz/volume"}, false, read_any_volume},
      {"scene", {"fuzz/scene"}, true, [](const std::string& bytes) { sound(scene_from_json(bytes, Scene{}, "file")); }},
      {"notes", {"fuzz/notes"}, true, read_lesson_text},
      {"lesson", {"fuzz/lesson"}, true, read_artefact_lesson},
      {"settings",
       {"fuzz/settings"},
       true,
       [](const std::string& bytes) { sound(settings_from_json(bytes).settings); }},
      {"png", {"fuzz/png"}, false, read_picture},
  };
  return all;
}

const Reader& reader(const std::string& name) {
  const auto found =
      std::find_if(readers().begin(), readers().end(), [&](const Reader& one) { return one.name == name; });
  if (found == readers().end()) throw std::logic_error("there is no reader " + name);
  return *found;
}

std::vector<Seed> seeds_of(const Reader& reader) {
  std::vector<Seed> seeds;
  for (const std::string& folder : reader.seeds) {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(std::filesystem::path(ODONTOSCOPE_CORPUS) / folder))
      files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const auto& file : files) seeds.push_back({file.filename().string(), read_file(file.string())});
  }
  return seeds;
}

}  // namespace odontoscope::hostile
