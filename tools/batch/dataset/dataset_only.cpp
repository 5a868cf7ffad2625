#include "tools/batch/dataset/dataset_only.hpp"

#include <fmt/format.h>

#include "tools/base/output/exit_code.hpp"
#include "tools/base/output/output_folder.hpp"
#include "tools/base/output/say.hpp"
#include "tools/batch/dataset/dataset_sequence.hpp"

namespace castaway::testbed {

int make_only(const DatasetRequest& request, int index) {
  const DatasetSpec spec = load_dataset_spec(request.spec, request.overrides);
  const SampledSequence sequence = sample_sequence(spec, index);
  std::error_code none;
  if (std::filesystem::exists(request.batch.out, none) &&
      !std::filesystem::is_empty(request.batch.out, none)) {
    throw std::runtime_error(request.batch.out.string() + ": is not empty; choose another --out");
  }
  OutputFolder output({request.batch.out, "dataset --only", {}, {request.spec}, false, false});
  DatasetWorlds worlds(spec.base);
  worlds.check(sequence.loaded.scenario);
  worlds.request_scores(sequence.loaded.scenario);
  try {
    worlds.compute_scores(1);
    PartsOfSequences parts{request.report};
    make_sequence(spec, worlds, sequence, output.folder(), parts);
    output.commit();
  } catch (const std::exception& error) {
    throw_if_interrupted();
    say(error.what());
    return kRunFailed;
  }
  print_out("Sequence {} of {}: {}\n", index, spec.name, request.batch.out.string());
  return kDone;
}

}  // namespace castaway::testbed
