#pragma once
// Dear ImGui as a value: its context, letters and colours, fed with our events.

#include <functional>
#include <memory>
#include <string>
#include <unordered_map>
#include <vector>

#include "engine/language/language.h"
#include "engine/view/input.h"

struct ImDrawData;
struct ImFont;
struct ImFontAtlas;
struct ImGuiContext;

namespace odontoscope {

/// Texts that others copied, and ours for them. Empty functions: a clipboard of our own.
struct Clipboard {
  std::function<std::string()> get;
  std::function<void(const std::string&)> set;
};

class Interface {
 public:
  explicit Interface(Clipboard clipboard = {});
  ~Interface();
  Interface(const Interface&) = delete;
  Interface& operator=(const Interface&) = delete;

  void feed(const Event& event);
  /// Between the two, ImGui's functions draw into this interface. The letters are made anew when the scale changes.
  void begin(const FrameInput& input);
  ImDrawData* end();

  /// From the next frame on; its letters are made if they are not there yet.
  void speak(Language language);
  const Language& language() const { return language_; }
  /// English words as a person reads them: Language::said.
  std::string say(const std::string& words) const;

  /// Counts up whenever the letters were made anew.
  int font_version() const { return fonts_.version; }
  ImFontAtlas& font_atlas() const;

  /// Does a panel lie over this place of the picture, as far as the last frame knows?
  bool covers(double x, double y) const;
  /// A text field has the keyboard.
  bool wants_text() const;
  Pointer pointer() const;

  /// The keyboard is in the panels: arrows, space, enter and escape are theirs.
  bool by_keys() const { return by_keys_; }
  /// Puts the keyboard on the next control, or the one before (`by` is negative), or the first; `panel` may be left
  /// out, behind a dialog. Between frames.
  void step(int by, bool panel);
  void leave_keys();
  /// Of a control that was made just now: is the keyboard on it?
  bool on_control(unsigned id) const;
  /// Once: a step led to this text field, which begins to take letters.
  bool takes_letters(unsigned id);
  /// A list or palette that came up over a panel.
  bool popup_open() const;

  /// Where the controls of the last frame were, by ImGui's id, in their order: for the keyboard, and for whoever drives
  /// the interface by script.
  struct Place {
    unsigned id = 0;
    float left = 0, top = 0, right = 0, bottom = 0;
    unsigned window = 0;
    bool text = false;
  };
  std::vector<Place> places;
  /// Words of the last frame that had less room than they need.
  std::vector<std::string> cut_off;

  ImFont* regular = nullptr;
  ImFont* bold = nullptr;
  ImFont* small = nullptr;
  ImFont* large = nullptr;

 private:
  void make_letters(float scale);

  Clipboard clipboard_;
  Language language_;
  mutable std::unordered_map<std::string, std::string> said_;  // what is said in each frame is looked for once
  std::string copied_;
  ImGuiContext* context_ = nullptr;
  struct {
    float scale = 0;
    int version = 0;
    std::vector<unsigned short> ranges;  // of letters, as ImGui wants them; they outlive the atlas
  } fonts_;
  struct {
    bool down[3] = {}, pressed[3] = {};
    std::vector<bool> keys_down, keys_pressed;  // by Key
  } held_;
  bool by_keys_ = false;
  unsigned text_goes_to_ = 0;
};

}  // namespace odontoscope
