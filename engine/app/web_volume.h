#pragma once
// The grey values that a web page carries.

#include <memory>
#include <string>
#include <vector>

#include "engine/app/shown_values.h"
#include "engine/app/volume_look_words.h"
#include "engine/app/volume_options.h"
#include "engine/scene/value_grid.h"
#include "engine/web/page.h"
#include "recon/output/report_json.h"

namespace odontoscope::app {

/// What a page keeps of a volume: 16 million values, which a phone can hold.
inline constexpr ValueGridLimits page_values{.most_values = 16u << 20, .longest_side = 512};

/// In eight bits: whole numbers that lie within 256 as they are, others from half a dentine's contrast below air to
/// three and a half above it; what lies beyond becomes the nearest of these. `look` shows the volume.
WebVolume web_volume(const ValueGrid& grid, const GreyAnchors& greys, const VolumeLook& look);

/// Its size, and what was left out.
void tell_web_volume(const WebVolume& volume, const ValueGrid& grid, Session& session);

/// What a page carries of the volume that its model was made from.
struct PageGreys {
  std::shared_ptr<const ValueGrid> values;
  GreyAnchors anchors;
  std::vector<WebIso> isos;
};

/// Around the contours, which were made of it. Throws as grey_anchors does.
PageGreys page_greys(const Volume& volume, const ContourStack& stack, const ReportVolume& facts);

/// Into the page and its looks, which stand in `scene`; tells what was left out.
void add_greys(const PageGreys& greys, const VolumeLookWords& look, const std::string& grey, Scene& scene,
               WebPage& page, Session& session);

/// A page of nothing but a volume's grey values; what stands for a model is the box of what is dense. Precondition:
/// they are no more than page_values.
WebPage page_of_voxels(const VoxelsAlone& voxels, const VolumeLookWords& look, const std::string& grey,
                       Session& session);

}  // namespace odontoscope::app
