# GDCM's decoders of compressed pixels from Debian's sources, in a module of their own: what a damaged frame does to its memory, or dies of, is
# no harm to the engine. It is to the page what the child process is to the native program (recon/volume/decode_apart.h).
set(gdcm ${gdcm_source})
set(decoder_made ${PROJECT_BINARY_DIR}/gdcm)
set(GDCM_MAJOR_VERSION 3)
set(GDCM_USE_SYSTEM_OPENJPEG 1)
file(READ ${openjpeg2_source}/CMakeLists.txt openjpeg_words)
foreach(part MAJOR MINOR BUILD)
  string(REGEX MATCH "OPENJPEG_VERSION_${part} ([0-9]+)" found "${openjpeg_words}")
  set(OPENJPEG_VERSION_${part} ${CMAKE_MATCH_1})
endforeach()
foreach(there GDCM_USE_JPEGLS GDCM_SUPPORT_BROKEN_IMPLEMENTATION GDCM_HAVE_SYS_TIME_H GDCM_HAVE_STRCASECMP GDCM_HAVE_STRNCASECMP GDCM_HAVE_LROUND
              GDCM_HAVE_GETTIMEOFDAY GDCM_HAVE_BYTESWAP_H GDCM_CXX_HAS_FUNCTION OPJ_HAVE_STDINT_H OPJ_HAVE_INTTYPES_H OPJ_HAVE_FSEEKO OPJ_HAVE_POSIX_MEMALIGN HAVE_STDDEF_H
              HAVE_STDLIB_H JPEGSTATIC)
  set(${there} 1)
endforeach()
set(openjpeg ${openjpeg2_source}/src/lib/openjp2)
configure_file(${gdcm}/Source/Common/gdcmConfigure.h.in ${decoder_made}/gdcmConfigure.h)
configure_file(${openjpeg}/opj_config.h.cmake.in ${decoder_made}/opj_config.h)
configure_file(${openjpeg}/opj_config_private.h.cmake.in ${decoder_made}/opj_config_private.h)

# One source of libjpeg for samples of 8, 12 and 16 bits.
set(jpeg ${gdcm}/Utilities/gdcmjpeg)
set(jpeg_files
  jmemnobs jcomapi jutils jerror jmemmgr jdapimin jdapistd jdtrans jdmaster jdinput jdmarker jdhuff jdphuff jdmainct jdcoefct jdpostct jddctmgr jidctfst
  jidctflt jidctint jidctred jdsample jdcolor jquant1 jquant2 jdmerge jdatasrc jdlossls jdlossy jdlhuff jddiffct jdpred jdscale jdshuff
  jcapimin jcapistd jctrans jcparam jcinit jcmaster jcmarker jcmainct jcprepct jccoefct jccolor jcsample jchuff jcphuff jcdctmgr jfdctfst jfdctflt
  jdatadst jfdctint jclossy jclossls jcodec jcscale jcshuff jclhuff jcpred jcdiffct)
list(TRANSFORM jpeg_files REPLACE "(.+)" "${jpeg}/\\1.c")
set(decoder_libraries "")
foreach(bits 8 12 16)
  set(made ${decoder_made}/gdcmjpeg/${bits})
  set(CMAKE_BITS_IN_JSAMPLE ${bits})
  set(MANGLE_PREFIX gdcmjpeg${bits})
  configure_file(${jpeg}/jpegcmake.h.in ${made}/jpegcmake.h @ONLY)
  configure_file(${jpeg}/mangle_jpeg.h.in ${made}/mangle_jpeg${bits}bits.h @ONLY)
  foreach(header jmorecfg jconfig jpeglib jerror jinclude)
    configure_file(${jpeg}/${header}.h ${made}/${header}.h COPYONLY)
  endforeach()
  compiled(gdcmjpeg${bits} ${jpeg} ${jpeg_files})
  target_include_directories(gdcmjpeg${bits} BEFORE PRIVATE ${made})
  list(APPEND decoder_libraries gdcmjpeg${bits})
endforeach()

set(openjpeg_files thread bio cio dwt event ht_dec image invert j2k jp2 mct mqc openjpeg opj_clock pi t1 t2 tcd tgt function_list opj_malloc sparse_array)
list(TRANSFORM openjpeg_files REPLACE "(.+)" "${openjpeg}/\\1.c")
compiled(openjpeg ${openjpeg} ${openjpeg_files})
target_include_directories(openjpeg SYSTEM PUBLIC ${decoder_made})

set(charls ${gdcm}/Utilities/gdcmcharls)
compiled(charls ${charls} ${charls}/interface.cpp ${charls}/jpegls.cpp ${charls}/jpegmarkersegment.cpp ${charls}/jpegstreamreader.cpp ${charls}/jpegstreamwriter.cpp)
target_compile_definitions(charls PUBLIC CHARLS_STATIC)

set(gdcm_files
  Common/gdcmByteSwap Common/gdcmException Common/gdcmFilename Common/gdcmObject Common/gdcmSubject Common/gdcmEvent Common/gdcmCommand Common/gdcmString
  Common/gdcmSwapCode Common/gdcmSystem Common/gdcmTrace Common/gdcmUnpacker12Bits Common/gdcmProgressEvent
  DataStructureAndEncodingDefinition/gdcmByteValue DataStructureAndEncodingDefinition/gdcmDataElement DataStructureAndEncodingDefinition/gdcmDataSet
  DataStructureAndEncodingDefinition/gdcmFragment DataStructureAndEncodingDefinition/gdcmSequenceOfFragments
  DataStructureAndEncodingDefinition/gdcmSequenceOfItems DataStructureAndEncodingDefinition/gdcmItem DataStructureAndEncodingDefinition/gdcmTag
  DataStructureAndEncodingDefinition/gdcmTransferSyntax DataStructureAndEncodingDefinition/gdcmVR DataStructureAndEncodingDefinition/gdcmVM
  DataStructureAndEncodingDefinition/gdcmValue DataStructureAndEncodingDefinition/gdcmParseException DataStructureAndEncodingDefinition/gdcmPrivateTag
  MediaStorageAndFileFormat/gdcmBitmap MediaStorageAndFileFormat/gdcmImage MediaStorageAndFileFormat/gdcmPixmap MediaStorageAndFileFormat/gdcmImageCodec
  MediaStorageAndFileFormat/gdcmJPEG12Codec MediaStorageAndFileFormat/gdcmJPEG16Codec MediaStorageAndFileFormat/gdcmJPEG2000Codec
  MediaStorageAndFileFormat/gdcmJPEG8Codec MediaStorageAndFileFormat/gdcmJPEGCodec MediaStorageAndFileFormat/gdcmJPEGLSCodec
  MediaStorageAndFileFormat/gdcmKAKADUCodec MediaStorageAndFileFormat/gdcmLookupTable MediaStorageAndFileFormat/gdcmOverlay
  MediaStorageAndFileFormat/gdcmCurve MediaStorageAndFileFormat/gdcmIconImage MediaStorageAndFileFormat/gdcmPhotometricInterpretation
  MediaStorageAndFileFormat/gdcmPixelFormat MediaStorageAndFileFormat/gdcmPNMCodec MediaStorageAndFileFormat/gdcmPVRGCodec
  MediaStorageAndFileFormat/gdcmRAWCodec MediaStorageAndFileFormat/gdcmRLECodec MediaStorageAndFileFormat/gdcmSegmentedPaletteColorLookupTable)
list(TRANSFORM gdcm_files REPLACE "(.+)" "${gdcm}/Source/\\1.cxx")
compiled(gdcm_decoders ${gdcm}/Source/MediaStorageAndFileFormat ${gdcm_files} ${gdcm}/Utilities/gdcmrle/rle.cxx ${gdcm}/Utilities/gdcmrle/info.cxx ${gdcm}/Utilities/gdcmrle/io.cxx)
target_include_directories(gdcm_decoders SYSTEM PUBLIC ${decoder_made} ${gdcm}/Source/Common ${gdcm}/Source/DataStructureAndEncodingDefinition
  ${gdcm}/Source/DataDictionary ${gdcm}/Utilities)
target_link_libraries(gdcm_decoders PUBLIC ${decoder_libraries} openjpeg charls)
target_compile_options(gdcm_decoders PRIVATE -fwasm-exceptions -sSUPPORT_LONGJMP=wasm)   # libjpeg jumps out of what is damaged
target_compile_options(charls PRIVATE -fwasm-exceptions)
