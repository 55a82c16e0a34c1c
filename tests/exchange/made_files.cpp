#include "tests/exchange/made_files.h"

#include <sstream>

#include "tests/volume/dicom_bytes.h"

namespace odontoscope::made {
namespace {

using test::dicom_element;

std::string long_element(std::uint16_t group, std::uint16_t element, const std::string& vr, const std::string& value) {
  std::string bytes;
  for (const std::uint32_t half : {std::uint32_t{group}, std::uint32_t{element}}) {
    bytes += static_cast<char>(half & 0xff);
    bytes += static_cast<char>(half >> 8);
  }
  bytes += vr + std::string(2, '\0');
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value.size() >> shift & 0xff);
  return bytes + value;
}

std::string item(const std::string& value) {
  std::string bytes("\xfe\xff\x00\xe0", 4);
  for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value.size() >> shift & 0xff);
  return bytes + value;
}

}  // namespace

std::string series(const std::string& units, const std::string& more) {
  return "<?xml version=\"1.0\"?>\n<!DOCTYPE Series SYSTEM \"series.dtd\">\n\n<Series index=\"1\" units=\"" + units +
         "\" defaultThickness=\"0.5\" " + more + ">\n<Contour name=\"a$+\" points=\"1 1,\"/>\n</Series>\n";
}

std::string section(const Section& what) {
  std::ostringstream text;
  text << "<?xml version=\"1.0\"?>\n<!DOCTYPE Section SYSTEM \"section.dtd\">\n<Section index=\"" << what.index
       << "\" thickness=\"" << what.thickness << "\" alignLocked=\"false\">\n"
       << "<Transform dim=\"0\" xcoef=\" 0 1 0 0 0 0\" ycoef=\" 0 0 1 0 0 0\">\n<Image mag=\"1\" src=\"x.jpg\"/>\n"
       << "<Contour name=\"domain1\" closed=\"true\" points=\"0 0, 9 0, 9 9, \"/>\n</Transform>\n"
       << "<Transform dim=\"" << what.dimension << "\"\n xcoef=\"" << what.xcoef << "\"\n ycoef=\"" << what.ycoef
       << "\">\n"
       << "<Contour name=\"" << what.name << "\" hidden=\"false\" closed=\"" << what.closed
       << "\" mode=\"13\"\n points=\"" << what.points << ",\n\t\"/>\n</Transform>\n</Section>\n";
  return text.str();
}

std::string csl() {
  return "CSLC\n2 2\n\n1 4 1 0.0 0.0 1.0 -1\n\n0 0 1\n8 0 1\n8 8 1\n0 8 1\n\n4 1 0 1 2 3\n\n"
         "2 8 2 0 0 2 -6\n\n0 0 3\n8 0 3\n8 8 3\n0 8 3\n2 2 3\n2 4 3\n4 4 3\n4 2 3\n\n4 1 0 1 2 3\n4h0 2 4 5 6 7\n";
}

std::string square(double x, double y, double z, double side) {
  std::ostringstream text;
  text << x << '\\' << y << '\\' << z << '\\' << x + side << '\\' << y << '\\' << z << '\\' << x + side << '\\'
       << y + side << '\\' << z << '\\' << x << '\\' << y + side << '\\' << z;
  return text.str();
}

std::string rtstruct(const std::vector<RoiOfSet>& rois) {
  const std::string structure_set = "1.2.840.10008.5.1.4.1.1.481.3";
  std::string meta = dicom_element(2, 2, "UI", structure_set) + dicom_element(2, 3, "UI", "1.2.3.4") +
                     dicom_element(2, 0x10, "UI", "1.2.840.10008.1.2.1");
  std::string names, all_contours;
  for (std::size_t r = 0; r < rois.size(); ++r) {
    const std::string number = std::to_string(r + 1);
    names += item(dicom_element(0x3006, 0x22, "IS", number) + dicom_element(0x3006, 0x26, "LO", rois[r].name));
    std::string contours;
    for (const RoiContour& contour : rois[r].contours) {
      contours +=
          item(dicom_element(0x3006, 0x42, "CS", contour.type) + dicom_element(0x3006, 0x46, "IS", contour.count) +
               dicom_element(0x3006, 0x50, "DS", contour.data));
    }
    all_contours += item(long_element(0x3006, 0x40, "SQ", contours) + dicom_element(0x3006, 0x84, "IS", number));
  }
  return std::string(128, '\0') + "DICM" + meta + dicom_element(8, 0x16, "UI", structure_set) +
         dicom_element(8, 0x60, "CS", "RTSTRUCT") + long_element(0x3006, 0x20, "SQ", names) +
         long_element(0x3006, 0x39, "SQ", all_contours);
}

}  // namespace odontoscope::made
