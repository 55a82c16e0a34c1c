#include "recon/partition/reconstruct_structures.h"

#include "recon/core/arena.h"
#include "recon/core/error.h"
#include "recon/partition/structures_meet.h"

namespace odontoscope {

MadeOfStructures reconstruct_structures(const ContourStack& stack, const ReconstructOptions& options,
                                        const Progress& progress) {
  const auto limit = allow_threads(options.threads);
  return reconstruct_structures(validate(stack, progress), options, progress);
}

MadeOfStructures reconstruct_structures(const ValidStack& stack, const ReconstructOptions& options,
                                        const Progress& progress) {
  std::string no_partition;
  if (structures_meet(stack)) {
    try {
      PartitionOptions together;
      together.between = options.between;
      together.threads = options.threads;
      return {reconstruct_partition(stack, together, progress), {}};
    } catch (const InternalError& error) {
      no_partition = error.what();
    } catch (const InputError& error) {
      if (error.cause() != "slices-too-close" && error.cause() != "too-many-structures") throw;
      no_partition = error.what();
    }
  }
  return {reconstruct(stack, options, progress), std::move(no_partition)};
}

}  // namespace odontoscope
