// The only file that knows GDCM. What it is given was checked: nothing of the user's file comes here but the frame's
// compressed bytes.

#include <gdcmDataElement.h>
#include <gdcmFragment.h>
#include <gdcmImage.h>
#include <gdcmSequenceOfFragments.h>
#include <gdcmSmartPointer.h>
#include <gdcmTrace.h>
#include <gdcmTransferSyntax.h>

#include <cstring>

#include "recon/volume/decode_apart.h"

namespace odontoscope {

bool is_decodable(const std::string& syntax) {
  const gdcm::TransferSyntax::TSType type = gdcm::TransferSyntax::GetTSType(syntax.c_str());
  return type != gdcm::TransferSyntax::TS_END && gdcm::TransferSyntax(type).IsEncapsulated();
}

bool decode_here(const CompressedFrame& frame, char* to) {
  gdcm::Trace::WarningOff();
  gdcm::Trace::ErrorOff();
  gdcm::Image image;
  image.SetNumberOfDimensions(2);
  image.SetDimension(0, frame.columns);
  image.SetDimension(1, frame.rows);
  image.SetTransferSyntax(gdcm::TransferSyntax(gdcm::TransferSyntax::GetTSType(frame.syntax.c_str())));
  const auto half = [](unsigned bits) { return static_cast<unsigned short>(bits); };
  image.SetPixelFormat(gdcm::PixelFormat(1, half(frame.bits_allocated), half(frame.bits_stored), half(frame.high_bit),
                                         half(frame.is_signed ? 1 : 0)));
  const bool dark_is_high = frame.photometric == "MONOCHROME1";
  image.SetPhotometricInterpretation(dark_is_high ? gdcm::PhotometricInterpretation::MONOCHROME1
                                                  : gdcm::PhotometricInterpretation::MONOCHROME2);

  const gdcm::SmartPointer<gdcm::SequenceOfFragments> pieces = new gdcm::SequenceOfFragments;
  gdcm::Fragment piece;
  piece.SetByteValue(frame.bytes.data(), gdcm::VL(static_cast<std::uint32_t>(frame.bytes.size())));
  pieces->AddFragment(piece);
  gdcm::DataElement pixels(gdcm::Tag(0x7fe0, 0x0010));
  pixels.SetVR(gdcm::VR::OB);
  pixels.SetValue(*pieces);
  image.SetDataElement(pixels);

  const std::size_t wanted = frame.decoded_bytes();
  if (image.GetBufferLength() != wanted) return false;
  std::vector<char> buffer(2 * wanted + 64);  // some decoders correct the number of bits on their way
  if (!image.GetBuffer(buffer.data())) return false;
  if (image.GetPixelFormat().GetBitsAllocated() != frame.bits_allocated ||
      image.GetPixelFormat().GetSamplesPerPixel() != 1)
    return false;
  std::memcpy(to, buffer.data(), wanted);
  return true;
}

}  // namespace odontoscope
