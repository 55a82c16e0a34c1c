// Programs that nobody here wrote judge the DICOM files and label maps that we write: dicom3tools' dciodvfy (is every
// attribute there that the standard asks for?), pydicom (what do they say?), DCMTK and GDCM (can they be read?). Each
// also sees a file that is wrong.

#include <gtest/gtest.h>

#include <fstream>

#include "recon/segmentation/rasterise.h"
#include "recon/segmentation/write_label_map.h"
#include "recon/segmentation/write_rtstruct.h"
#include "recon/segmentation/write_seg.h"
#include "recon/volume/read_volume.h"
#include "recon/volume/volume_contours.h"
#include "tests/output/temporary_folder.h"
#include "tests/segmentation/made.h"
#include "tests/support/shell.h"

namespace odontoscope {
namespace {

using testing_support::run;
using testing_support::Said;

class DicomJudge : public ::testing::Test {
 protected:
  void need(const std::string& command) {
    if (run(command).exit_code != 0)
      GTEST_SKIP() << command
                   << " does not run; third_party/test_packages.debian lists what is needed under \"judges\"";
  }
  std::string put(const std::string& name, const std::string& bytes) const {
    std::ofstream(folder / name, std::ios::binary) << bytes;
    return (folder / name).string();
  }
  std::string said_by(const std::string& command) const {
    const Said said = run("cd '" + folder.path().string() + "' && " + command);
    EXPECT_EQ(said.exit_code, 0) << command << "\n" << said.words;
    return said.words;
  }

  /// Contours of a series, and what they refer to.
  void read_series() {
    made::Series{}.write(folder / "series");
    image = read_volume((folder / "series").string());
    VolumeContourOptions options;
    options.isos = {{50, "tooth"}};
    stack = contours_of_volume(image, options).stack;
  }

  testing_support::TemporaryFolder folder;
  Volume image;
  ContourStack stack;
};

VoxelGrid grid_of(const Volume& volume) { return {volume.size, volume.spacing, volume.origin}; }

/// The first of `what` replaced by as many other bytes.
std::string with(std::string bytes, const std::string& what, const std::string& other) {
  const std::size_t at = bytes.find(what);
  EXPECT_NE(at, bytes.npos);
  EXPECT_EQ(what.size(), other.size());
  return bytes.replace(at, what.size(), other);
}

class Dciodvfy : public DicomJudge {
 protected:
  void SetUp() override { need("command -v dciodvfy"); }
  /// Lines that begin with "Error".
  std::string errors_in(const std::string& bytes) {
    const std::string file = put("judged.dcm", bytes);
    std::istringstream said(run("dciodvfy '" + file + "'").words);
    std::string errors;
    bool any = false;
    for (std::string line; std::getline(said, line); any = true) {
      if (line.starts_with("Error")) errors += line + "\n";
    }
    EXPECT_TRUE(any) << "it said nothing";
    return errors;
  }
};

TEST_F(Dciodvfy, FindsNoFaultInStructureSets) {
  EXPECT_EQ(errors_in(rtstruct_bytes(made::tooth(), {})), "");
  read_series();
  EXPECT_EQ(errors_in(rtstruct_bytes(stack, image.patient)), "");
}

TEST_F(Dciodvfy, FindsNoFaultInSegmentations) {
  EXPECT_EQ(errors_in(seg_bytes(rasterised(made::tooth(), grid_of_slices(made::tooth(), 0.2, 0.2)), {})), "");
  read_series();
  EXPECT_EQ(errors_in(seg_bytes(rasterised(stack, grid_of(image)), image.patient)), "");
}

TEST_F(Dciodvfy, FindsWhatIsMissing) {
  // Identifications of regions under a tag that is none, and a segmentation of a kind that there is none of.
  EXPECT_NE(errors_in(with(rtstruct_bytes(made::tooth(), {}), std::string("\x06\x30\x80\x00", 4),
                           std::string("\x06\x30\x82\x70", 4))),
            "");
  EXPECT_NE(errors_in(with(seg_bytes(rasterised(made::tooth(), grid_of_slices(made::tooth(), 0.2, 0.2)), {}), "BINARY",
                           "BINERY")),
            "");
}

class Pydicom : public DicomJudge {
 protected:
  void SetUp() override { need("/usr/bin/python3 -c 'import pydicom, numpy'"); }
  std::string told(const std::string& script, const std::string& bytes) {
    put("judge.py", script);
    put("judged.dcm", bytes);
    return said_by("/usr/bin/python3 judge.py");
  }
};

/// Areas by Gauss's formula: a keyhole's are its outline's less its holes'.
constexpr const char* areas_script = R"(
import pydicom
data = pydicom.dcmread("judged.dcm")
names = {int(r.ROINumber): r.ROIName for r in data.StructureSetROISequence}
for roi in data.ROIContourSequence:
    areas = {}
    for contour in roi.ContourSequence:
        assert contour.ContourGeometricType == "CLOSED_PLANAR"
        numbers = [float(x) for x in contour.ContourData]
        points = list(zip(numbers[0::3], numbers[1::3], numbers[2::3]))
        assert len(points) == contour.NumberOfContourPoints
        twice = sum(a[0] * b[1] - a[1] * b[0] for a, b in zip(points, points[1:] + points[:1]))
        z = points[0][2]
        areas[z] = areas.get(z, 0) + twice / 2
    print(names[int(roi.ReferencedROINumber)], " ".join("%.9f" % areas[z] for z in sorted(areas)))
)";

TEST_F(Pydicom, MeasuresTheSameAreas) {
  const ContourStack tooth = made::tooth();
  std::string wanted;
  for (const std::string name : {"enamel", "dentine", "pulp"}) {
    wanted += name;
    for (const Slice& slice : tooth.slices) {
      char number[40];
      std::snprintf(number, sizeof(number), " %.9f", made::area(slice, name));
      wanted += number;
    }
    wanted += "\n";
  }
  EXPECT_EQ(told(areas_script, rtstruct_bytes(tooth, {})), wanted);
  ContourStack other = tooth;
  other.slices[1].contours.pop_back();  // a canal of the pulp
  EXPECT_NE(told(areas_script, rtstruct_bytes(other, {})), wanted);
}

constexpr const char* references_script = R"(
import pydicom
data = pydicom.dcmread("judged.dcm")
slices = {s.SOPInstanceUID: s for s in (pydicom.dcmread("series/%d.dcm" % (n + 1)) for n in range(4))}
one = next(iter(slices.values()))
assert data.PatientName == one.PatientName and data.PatientID == one.PatientID and data.AccessionNumber == one.AccessionNumber
assert data.StudyInstanceUID == one.StudyInstanceUID and data.FrameOfReferenceUID == one.FrameOfReferenceUID
assert data.SeriesInstanceUID != one.SeriesInstanceUID and data.SOPInstanceUID not in slices
count = 0
if data.Modality == "RTSTRUCT":
    frame = data.ReferencedFrameOfReferenceSequence[0]
    series = frame.RTReferencedStudySequence[0].RTReferencedSeriesSequence[0]
    assert series.SeriesInstanceUID == one.SeriesInstanceUID
    assert {i.ReferencedSOPInstanceUID for i in series.ContourImageSequence} == set(slices)
    for contour in data.ROIContourSequence[0].ContourSequence:
        image = slices[contour.ContourImageSequence[0].ReferencedSOPInstanceUID]
        assert abs(float(image.ImagePositionPatient[2]) - float(contour.ContourData[2])) < 1e-6
        count += 1
else:
    series = data.ReferencedSeriesSequence[0]
    assert series.SeriesInstanceUID == one.SeriesInstanceUID
    assert {i.ReferencedSOPInstanceUID for i in series.ReferencedInstanceSequence} == set(slices)
    shared = data.SharedFunctionalGroupsSequence[0]
    assert list(shared.PixelMeasuresSequence[0].PixelSpacing) == list(one.PixelSpacing)
    assert list(shared.PlaneOrientationSequence[0].ImageOrientationPatient) == list(one.ImageOrientationPatient)
    for group, frame in zip(data.PerFrameFunctionalGroupsSequence, data.pixel_array):
        image = slices[group.DerivationImageSequence[0].SourceImageSequence[0].ReferencedSOPInstanceUID]
        assert list(group.PlanePositionSequence[0].ImagePositionPatient) == list(image.ImagePositionPatient)
        assert ((image.pixel_array >= 50) == (frame != 0)).all()
        count += 1
print(count)
)";

TEST_F(Pydicom, FindsThePatientTheStudyAndTheImageOfEachSlice) {
  read_series();
  EXPECT_EQ(told(references_script, rtstruct_bytes(stack, image.patient)), "4\n");  // an outline with a keyhole each
  EXPECT_EQ(told(references_script, seg_bytes(rasterised(stack, grid_of(image)), image.patient)), "4\n");
  // Seen from the next image, the contours would lie on the wrong one.
  put("judge.py", references_script);
  put("judged.dcm", with(rtstruct_bytes(stack, image.patient), "\\20\\", "\\21\\"));
  EXPECT_NE(run("cd '" + folder.path().string() + "' && /usr/bin/python3 judge.py").exit_code, 0);
}

constexpr const char* voxels_script = R"(
import pydicom
data = pydicom.dcmread("judged.dcm")
names = {s.SegmentNumber: s for s in data.SegmentSequence}
counts = {}
frames = data.pixel_array
assert len(frames) == data.NumberOfFrames == len(data.PerFrameFunctionalGroupsSequence)
for group, frame in zip(data.PerFrameFunctionalGroupsSequence, frames):
    number = group.SegmentIdentificationSequence[0].ReferencedSegmentNumber
    assert group.FrameContentSequence[0].DimensionIndexValues[0] == number
    counts[number] = counts.get(number, 0) + int(frame.sum())
for number, segment in names.items():
    code = segment.SegmentedPropertyTypeCodeSequence[0]
    print(segment.SegmentLabel, counts[number], code.CodingSchemeDesignator, code.CodeMeaning, *segment.RecommendedDisplayCIELabValue)
)";

TEST_F(Pydicom, CountsTheSameVoxels) {
  const Segmentation voxels = rasterised(made::tooth(), grid_of_slices(made::tooth(), 0.2, 0.23));
  const std::string said = told(voxels_script, seg_bytes(voxels, {}));
  for (const Segment& segment : voxels.segments)
    EXPECT_NE(said.find(segment.name + " " + std::to_string(segment.voxels.count()) + " 99ODONTO"), said.npos) << said;
}

TEST_F(DicomJudge, DcmtkReadsAll) {
  need("command -v dcm2json");
  need("command -v dcmdump");
  read_series();
  put("set.dcm", rtstruct_bytes(stack, image.patient));
  put("seg.dcm", seg_bytes(rasterised(stack, grid_of(image)), image.patient));
  EXPECT_NE(said_by("dcm2json set.dcm").find("\"CLOSED_PLANAR\""), std::string::npos);
  EXPECT_NE(said_by("dcmdump +P SegmentLabel seg.dcm").find("[tooth]"), std::string::npos);
  put("cut.dcm", rtstruct_bytes(stack, image.patient).substr(0, 3000));
  EXPECT_NE(run("dcm2json '" + (folder / "cut.dcm").string() + "'").exit_code, 0);
}

TEST_F(DicomJudge, GdcmReadsAll) {
  need("command -v gdcminfo");
  read_series();
  put("seg.dcm", seg_bytes(rasterised(stack, grid_of(image)), image.patient));
  const std::string said = said_by("gdcminfo seg.dcm");
  EXPECT_NE(said.find("Dimensions: (12,10,4)"), said.npos) << said;
  EXPECT_NE(said.find("BitsAllocated      :1"), said.npos) << said;
  put("set.dcm", rtstruct_bytes(stack, image.patient));
  EXPECT_NE(said_by("gdcmdump set.dcm").find("CLOSED_PLANAR"), std::string::npos);
}

/// The header as anybody's reader of NRRD splits it.
constexpr const char* nrrd_script = R"(
import gzip, numpy
head, pixels = open("judged.nrrd", "rb").read().split(b"\n\n", 1)
lines = head.decode("utf-8").split("\n")
assert lines[0].startswith("NRRD000")
fields = dict(line.split(": ", 1) for line in lines[1:] if ":=" not in line)
keys = dict(line.split(":=", 1) for line in lines[1:] if ":=" in line)
sizes = [int(n) for n in fields["sizes"].split()]
voxels = numpy.frombuffer(gzip.decompress(pixels), dtype=numpy.uint8).reshape(sizes[::-1])
for n in range(3):
    low_x, high_x, low_y, high_y, low_z, high_z = (int(x) for x in keys["Segment%d_Extent" % n].split())
    mine = voxels == int(keys["Segment%d_LabelValue" % n])
    box = mine[low_z:high_z + 1, low_y:high_y + 1, low_x:high_x + 1]
    assert box.sum() == mine.sum()
    for axis in range(3):
        sides = box.any(axis=tuple(a for a in range(3) if a != axis))
        assert sides[0] and sides[-1]
    assert all(0 <= float(c) <= 1 for c in keys["Segment%d_Color" % n].split())
    print(keys["Segment%d_Name" % n], mine.sum())
)";

TEST_F(Pydicom, NumpyFindsSegmentsWithinTheirExtents) {
  const Segmentation voxels = rasterised(made::tooth(), grid_of_slices(made::tooth(), 0.2, 0.23));
  put("judge.py", nrrd_script);
  put("judged.nrrd", label_map_bytes(voxels, {}));
  std::string wanted;
  for (const Segment& segment : voxels.segments)
    wanted += segment.name + " " + std::to_string(segment.voxels.count()) + "\n";
  EXPECT_EQ(said_by("/usr/bin/python3 judge.py"), wanted);
}

}  // namespace
}  // namespace odontoscope
