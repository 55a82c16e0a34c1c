#pragma once
// The paper's figures 1 to 18, made anew: "Qualitative analysis of two reconstruction techniques and their application
// in dentistry", Journal of Electronic Imaging 9(4), 2000. Each is a scene computed by the engines from contours;
// captions are ours.

#include <string>
#include <vector>

#include "engine/figures/figure.h"
#include "engine/figures/tooth_models.h"
#include "recon/core/progress.h"

namespace odontoscope::figures {

struct Entry {
  int number;
  const char* title;
  Figure (*make)(ToothModels& tooth);  // title and number are filled in by `make_figure`
};

/// By number, 1 to 18.
const std::vector<Entry>& paper_figures();

/// Throws UsageError for a number that there is none of, and what the engines throw.
Figure make_figure(int number, ToothModels& tooth);

}  // namespace odontoscope::figures
