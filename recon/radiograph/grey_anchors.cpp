#include "recon/radiograph/grey_anchors.h"

#include "recon/core/error.h"
#include "recon/volume/thresholds.h"

namespace odontoscope {

namespace {

double median(const Histogram& histogram, double parting, bool above) {
  std::uint64_t all = 0, seen = 0;
  const auto count = [&](std::size_t bin) {
    return (histogram.value(bin) >= parting) == above ? histogram.counts[bin] : 0;
  };
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin) all += count(bin);
  for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin)
    if (count(bin) > 0 && (seen += count(bin)) * 2 >= all) return histogram.value(bin);
  return parting;
}

}  // namespace

GreyAnchors grey_anchors(const Volume& volume) {
  const Histogram histogram = histogram_of(volume, validate_volume(volume));
  const std::vector<double> thresholds = otsu_thresholds(histogram, 2);
  const GreyAnchors anchors =
      thresholds.empty() ? GreyAnchors{0, 0}
                         : GreyAnchors{median(histogram, thresholds[0], false), median(histogram, thresholds[0], true)};
  if (anchors.air < anchors.dentine) return anchors;
  Place place;
  place.file = volume.source;
  throw InputError("nothing-crosses-iso", place, "all its values are equal, or nearly",
                   "Say with --grey AIR,DENTINE what they mean, or give another volume");
}

}  // namespace odontoscope
