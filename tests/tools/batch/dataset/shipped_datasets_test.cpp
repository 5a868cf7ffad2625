// Every specification in datasets/ gives valid scenarios.
#include <gtest/gtest.h>

#include "tools/scenario/dataset_sample.hpp"
#include "tools/scenario/files/data_paths.hpp"

namespace castaway::testbed {
namespace {

TEST(ShippedDatasets, AllSequencesCanBe) {
  int specs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(data_root() / "datasets")) {
    if (entry.path().extension() != ".yaml") continue;
    SCOPED_TRACE(entry.path().string());
    const DatasetSpec spec = load_dataset_spec(entry.path());
    EXPECT_FALSE(spec.license.empty());
    EXPECT_FALSE(spec.description.empty());
    for (int i = 0; i < 50; ++i) EXPECT_NO_THROW(sample_sequence(spec, i)) << i;
    ++specs;
  }
  EXPECT_GE(specs, 3);
}

}  // namespace
}  // namespace castaway::testbed
