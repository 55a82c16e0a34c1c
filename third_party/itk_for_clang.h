// Debian's ITK knows the features of g++ alone and refuses every other compiler. clang has all of them: for this one header, which tells them, it
// passes for the g++ whose library it uses.
#pragma push_macro("__clang__")
#pragma push_macro("__GNUC__")
#undef __clang__
#undef __GNUC__
#define __GNUC__ 12
#include <itk_compiler_detection.h>
#pragma pop_macro("__GNUC__")
#pragma pop_macro("__clang__")
