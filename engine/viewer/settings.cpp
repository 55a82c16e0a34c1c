#include "engine/viewer/settings.h"

#include <fmt/format.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/picture/image.h"
#include "engine/scene/json_colour.h"
#include "recon/core/atomic_file.h"
#include "recon/core/error.h"
#include "recon/core/read_file.h"
#include "recon/input/json_schema.h"

namespace odontoscope {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t longest_tag = 35;
constexpr const char* format_name = "odontoscope.viewer-settings";
constexpr std::size_t most_bytes = 64 * 1024;

constexpr NameTable<Backdrop, 3> backdrops{
    {{"dark", Backdrop::dark}, {"light", Backdrop::light}, {"white", Backdrop::white}}};

/// What is written is what is read again: both keep to these. A window is as narrow as its user and the desktop like.
constexpr int smallest_window_side = 64, largest_window_side = 16384, least_picture_side = 16, most_samples_a_side = 4;
constexpr float smallest_text_scale = 0.7f, largest_text_scale = 2.5f;
constexpr double narrowest_view_deg = 40, widest_view_deg = 110, slowest_limit = 0.5, fastest_limit = 24;

/// NaN becomes the least.
template <class Number>
void keep_within(Number& value, Number least, Number most) {
  value = value >= least ? std::min(value, most) : least;
}

Settings within_limits(Settings settings) {
  keep_within(settings.window.width, smallest_window_side, largest_window_side);
  keep_within(settings.window.height, smallest_window_side, largest_window_side);
  keep_within(settings.text_scale, smallest_text_scale, largest_text_scale);
  keep_within(settings.picture.width, least_picture_side, most_picture_side);
  keep_within(settings.picture.height, least_picture_side, most_picture_side);
  keep_within(settings.picture.side, 1, most_samples_a_side);
  keep_within(settings.comfort.field_of_view_deg, narrowest_view_deg, widest_view_deg);
  keep_within(settings.comfort.speed_limit, slowest_limit, fastest_limit);
  for (RememberedLook& look : settings.looks) keep_within(look.opacity, 0.0f, 1.0f);
  return settings;
}

/// Sets what makes sense; the first thing that does not is the complaint.
class SettingsSchema {
 public:
  explicit SettingsSchema(Settings& settings) : settings_(settings) {
    const JsonRange window_side{smallest_window_side, largest_window_side},
        picture_side{least_picture_side, most_picture_side};
    PictureSettings& picture = settings.picture;
    Comfort& comfort = settings.comfort;
    schema_.document(
        format_name, {0, 0},
        {schema_.object("window", {schema_.number("width", settings.window.width, window_side),
                                   schema_.number("height", settings.window.height, window_side)}),
         schema_.flag("panel", settings.panel), schema_.flag("names", settings.names),
         schema_.flag("hints", settings.hints), schema_.flag("desktop_dialogs", settings.desktop_dialogs),
         text("save_folder", settings.save_folder, most_path_bytes), text("language", settings.language, longest_tag),
         schema_.number("text_scale", settings.text_scale, {smallest_text_scale, largest_text_scale}),
         schema_.word("back_faces", settings.back_faces, back_face_modes),
         schema_.word("projection", settings.projection, camera_projections),
         schema_.word("backdrop", settings.backdrop, backdrops),
         schema_.object("picture", {schema_.number("width", picture.width, picture_side),
                                    schema_.number("height", picture.height, picture_side),
                                    schema_.flag("as_seen", picture.as_seen),
                                    schema_.number("samples_a_side", picture.side, {1, most_samples_a_side}),
                                    schema_.flag("transparent", picture.transparent)}),
         schema_.object(
             "flight",
             {schema_.number("field_of_view_deg", comfort.field_of_view_deg, {narrowest_view_deg, widest_view_deg}),
              schema_.number("speed_limit", comfort.speed_limit, {slowest_limit, fastest_limit}),
              schema_.flag("vignette", comfort.vignette), schema_.flag("reduced_motion", comfort.reduced_motion),
              schema_.flag("wall_depth", comfort.wall_depth), schema_.flag("wall_thickness", comfort.wall_thickness)}),
         recent(), looks()});
  }
  /// What is to be complained of.
  std::string read(const std::string& text) {
    schema_.read(text, "settings");
    return schema_.complaint();
  }

 private:
  void complain(std::string_view wrong) { schema_.fault("bad-value", wrong, ""); }

  JsonField text(std::string_view key, std::string& value, std::size_t longest) {
    return schema_.field(key, JsonNode::Shape::text, {.text = [this, key, &value, longest](const std::string& read) {
                           if (read.size() <= longest) return void(value = read);
                           complain(fmt::format("\"{}\" is longer than {} bytes", key, longest));
                         }});
  }
  JsonField recent() {
    return schema_.texts("recent", "a file", {.most = most_recent_files}, [this](const std::string& file) {
      if (!file.empty() && file.size() <= most_path_bytes) return settings_.recent.push_back(file);
      complain("\"recent\" has a file that is none");
    });
  }
  JsonField looks() {
    return schema_.map("looks", "a look", [this](const std::string& name) { name_ = name; },
                       {json_colour(
                            schema_, "colour", [this]() -> auto& { return colour_; }),
                        schema_.number("opacity", opacity_, {0, 1})},
                       {.opened =
                            [this] {
                              colour_.reset();
                              opacity_.reset();
                            },
                        .closed = [this] { take_look(); }});
  }
  void take_look() {
    if (name_.empty() || name_.size() > most_structure_bytes) return complain("\"looks\" has a structure that is none");
    if (!colour_ || !opacity_) return complain("\"looks\" has a structure without a colour or an opacity");
    forget(settings_, name_);
    if (settings_.looks.size() == most_remembered_looks)
      return complain(fmt::format("\"looks\" has more than {} structures", most_remembered_looks));
    settings_.looks.push_back({name_, *colour_, *opacity_});
  }

  Settings& settings_;
  std::string name_;  // of the look that is read
  std::optional<Colour> colour_;
  std::optional<float> opacity_;
  JsonSchema schema_{"the settings", JsonReading::forgiving};
};

}  // namespace

void remember_file(Settings& settings, const std::string& file) {
  std::error_code error;
  const std::string whole = std::filesystem::absolute(file, error).lexically_normal().string();
  if (error || whole.empty() || whole.size() > most_path_bytes) return;
  std::erase(settings.recent, whole);
  settings.recent.insert(settings.recent.begin(), whole);
  if (settings.recent.size() > most_recent_files) settings.recent.resize(most_recent_files);
}

Background background_of(Backdrop backdrop) {
  switch (backdrop) {
    case Backdrop::light:
      return {};
    case Backdrop::white:
      return {Background::Kind::plain, {1, 1, 1}, {1, 1, 1}};
    case Backdrop::dark:
      break;
  }
  return {Background::Kind::gradient, colour_of(0x3d4854), colour_of(0x14181c)};
}

void remember(Settings& settings, const Look& look) {
  if (look.structure.empty() || look.structure.size() > most_structure_bytes) return;
  forget(settings, look.structure);
  settings.looks.push_back({look.structure, look.colour, look.opacity});
  if (settings.looks.size() > most_remembered_looks) settings.looks.erase(settings.looks.begin());
}

void forget(Settings& settings, const std::string& structure) {
  std::erase_if(settings.looks, [&](const RememberedLook& known) { return known.structure == structure; });
}

void apply_remembered(const Settings& settings, Scene& scene) {
  for (const RememberedLook& known : settings.looks)
    if (Look* look = scene.look_of(known.structure)) {
      look->colour = known.colour;
      look->opacity = known.opacity;
    }
}

std::string to_json(const Settings& wanted) {
  const Settings settings = within_limits(wanted);
  Json json{{"format", format_name},
            {"window", {{"width", settings.window.width}, {"height", settings.window.height}}},
            {"panel", settings.panel},
            {"names", settings.names},
            {"hints", settings.hints},
            {"desktop_dialogs", settings.desktop_dialogs},
            {"text_scale", std::stod(fmt::format("{}", settings.text_scale))},
            {"back_faces", word_of(back_face_modes, settings.back_faces)},
            {"projection", word_of(camera_projections, settings.projection)},
            {"backdrop", word_of(backdrops, settings.backdrop)},
            {"picture",
             {{"width", settings.picture.width},
              {"height", settings.picture.height},
              {"as_seen", settings.picture.as_seen},
              {"samples_a_side", settings.picture.side},
              {"transparent", settings.picture.transparent}}},
            {"flight",
             {{"field_of_view_deg", settings.comfort.field_of_view_deg},
              {"speed_limit", settings.comfort.speed_limit},
              {"vignette", settings.comfort.vignette},
              {"reduced_motion", settings.comfort.reduced_motion},
              {"wall_depth", settings.comfort.wall_depth},
              {"wall_thickness", settings.comfort.wall_thickness}}}};
  Json looks = Json::object();
  for (const RememberedLook& look : settings.looks)
    looks[look.structure] = {{"colour", hex(look.colour)}, {"opacity", std::stod(fmt::format("{}", look.opacity))}};
  json["looks"] = looks;
  json["recent"] = settings.recent;
  if (!settings.save_folder.empty()) json["save_folder"] = settings.save_folder;
  if (!settings.language.empty()) json["language"] = settings.language;
  // Names come from files of all kinds: what is no text is replaced, and so forgotten.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

ReadSettings settings_from_json(const std::string& text) {
  ReadSettings read;
  if (text.size() > most_bytes) return {{}, "it is larger than settings can be"};
  try {
    read.complaint = SettingsSchema(read.settings).read(text);
  } catch (const Error&) {
    return {{}, "it is no settings file of this viewer"};
  }
  return read;
}

std::filesystem::path settings_file() {
  const auto folder = [](const char* variable) {
    const char* value = std::getenv(variable);
    const std::filesystem::path path = value ? value : "";
    return path.is_absolute() ? path : std::filesystem::path();  // the XDG rule: a relative one counts as not set
  };
  if (const auto config = folder("XDG_CONFIG_HOME"); !config.empty()) return config / "odontoscope" / "viewer.json";
  if (const auto home = folder("HOME"); !home.empty()) return home / ".config" / "odontoscope" / "viewer.json";
  return {};
}

ReadSettings read_settings(const std::filesystem::path& file) {
  std::error_code error;
  if (file.empty() || !std::filesystem::exists(file, error)) return {};
  if (!std::filesystem::is_regular_file(file, error))
    return {{}, fmt::format("The settings are left aside: {} is no ordinary file.", file.string())};
  std::string text;
  try {
    text = read_file(file.string(), most_bytes);
  } catch (const Error& wrong) {
    return {{}, fmt::format("The settings are left aside: {}", wrong.what())};
  }
  ReadSettings read = settings_from_json(text);
  if (!read.complaint.empty())
    read.complaint = fmt::format("{}: {}. What makes no sense is left at its default.", file.string(), read.complaint);
  return read;
}

void write_settings(const Settings& settings, const std::filesystem::path& file) {
  if (file.empty()) return;
  std::error_code error;
  std::filesystem::create_directories(file.parent_path(), error);
  if (error)
    throw FileError(file.parent_path().string(), fmt::format("the folder cannot be made ({})", error.message()),
                    "The settings are not remembered.");
  remove_leftovers(file.parent_path());
  AtomicFile written(file);
  written.write(to_json(settings));
  written.commit();
}

}  // namespace odontoscope
