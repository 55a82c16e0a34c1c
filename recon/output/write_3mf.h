#pragma once
// 3MF (3D Manufacturing Format, core specification 1.3; ISO/IEC 25422): for printers of several materials.
//
// Millimetres, coordinates in full: where structures share faces (a partition), theirs are equal to the bit. One object
// a structure, named after it, with its shells, cavities facing inwards, and a base material of its name and colour.
// The objects are the components of one object, which is the only thing to be built, so that slicing programs keep them
// together. Coordinates stay as they are, negative ones too: slicing programs lay the model down themselves. A surface
// that is no closed manifold is an object of type "surface", since "model" promises one. Title, certificate and program
// stand in the metadata.

#include <string>

#include "recon/formats/written_model.h"

namespace odontoscope {

/// The bytes of the package, a ZIP archive. The same model gives the same bytes. FileError if the archive cannot be
/// made.
std::string threemf_bytes(const WrittenModel& model);

}  // namespace odontoscope
