#pragma once
// The input format of Abaqus and CalculiX: the tetrahedra as C3D4 elements, with the sets that a load case needs.
//
// Millimetres (with newtons, then, stresses are MPa). Coordinates have 13 or more digits: CalculiX reads 20 characters
// of a number. Names are in letters, digits and "_", a comment tells what each stands for:
//   element sets   each structure; CROWN and ROOT where there is enamel (see solid_walls.h), by the elements' centres
//   node sets      each wall ("TOOTH_CAVITY" is the pulp's); NAME_LOWEST and NAME_HIGHEST, the nodes of a structure's
//   first and
//                  last slice; CROWN_NODES and ROOT_NODES
//   surfaces       each wall, by faces of elements, for loads and contact ("TOOTH_CAVITY_WALL")
// There is no material, no section and no step. Structures do not share nodes: tie or merge them where they meet. Those
// of a partition do; its node sets and surfaces are then the borders of two materials and the outside of each
// ("ENAMEL_DENTINE_JUNCTION", "PULP_WALL", "DENTINE_OUTSIDE", and the same with "_FACES"; see complex_groups.h).

#include <string>

#include "recon/delaunay/reconstruct.h"

namespace odontoscope {

std::string inp_text(const Reconstruction& reconstruction);

}  // namespace odontoscope
