#pragma once
// What VTK's XML formats have in common. For the .cpp files of this room only.

#include <string>
#include <string_view>
#include <vector>

namespace odontoscope {

struct VtkArray {
  std::string_view type, name;
  int components = 1;
};

/// Appends a DataArray in base64; `bytes` are the numbers themselves, least significant byte first.
void add_vtk_array(std::string& xml, const VtkArray& array, const std::string& bytes);

/// FieldData: one field "structure NAME" a structure, holding its number from 1 (not every reader knows VTK's strings),
/// and "certified", 1 or 0.
std::string vtk_field_data(const std::vector<std::string_view>& structures, bool certified);

/// What every file of the family begins with, up to its grid's own element.
std::string vtk_opening(std::string_view type, std::string_view certificate);

}  // namespace odontoscope
