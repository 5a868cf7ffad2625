// Fuzzes meshes through the separate process in which the program reads them, so that crashes of
// assimp stay there. The first byte selects the format.

#include <array>
#include <chrono>
#include <stdexcept>

#include "tests/fuzz/fuzz_input.hpp"
#include "tools/build/isolated_meshes.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace castaway;
  constexpr std::array<const char*, 6> kEndings{".stl", ".obj", ".ply", ".dae", ".gltf", ".glb"};
  if (size == 0) return 0;
  const auto path = testbed::as_file(data + 1, size - 1, kEndings[data[0] % kEndings.size()]);
  testbed::isolate_meshes({std::chrono::milliseconds(2000), std::size_t{256} << 20U});
  try {
    (void)sim::load_mesh(path.string(), Eigen::Vector3d::Ones());
  } catch (const std::runtime_error&) {
  } catch (const std::length_error&) {
  }
  return 0;
}
