#include "tools/base/formats/hdf5_file.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

#include <fmt/format.h>
#include <hdf5.h>

#include "tools/base/files/file_error.hpp"

namespace castaway::testbed {

/// Owns a handle of the HDF5 library, of any kind.
class Hdf5Handle {
 public:
  Hdf5Handle() = default;
  explicit Hdf5Handle(hid_t id) : id_(id) {}
  ~Hdf5Handle() { close(); }
  Hdf5Handle(Hdf5Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
  Hdf5Handle& operator=(Hdf5Handle&& other) noexcept {
    if (this != &other) {
      close();
      id_ = std::exchange(other.id_, H5I_INVALID_HID);
    }
    return *this;
  }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;

  [[nodiscard]] hid_t get() const { return id_; }
  [[nodiscard]] bool valid() const { return id_ >= 0; }
  /// Closes the handle; false if the library fails to.
  bool close() {
    const hid_t id = std::exchange(id_, H5I_INVALID_HID);
    return id < 0 || H5Idec_ref(id) >= 0;
  }

 private:
  hid_t id_ = H5I_INVALID_HID;
};

namespace {

constexpr hsize_t kChunkBytes = 64 * 1024;  // Approximate size of a chunk before compression.
constexpr unsigned kDeflate = 4;

hid_t file_type(Hdf5Type type) {
  switch (type) {
    case Hdf5Type::kFloat32:
      return H5T_IEEE_F32LE;
    case Hdf5Type::kFloat64:
      return H5T_IEEE_F64LE;
    case Hdf5Type::kUint8:
      return H5T_STD_U8LE;
    case Hdf5Type::kInt32:
      return H5T_STD_I32LE;
    case Hdf5Type::kInt64:
      return H5T_STD_I64LE;
  }
  return H5I_INVALID_HID;
}

Hdf5Handle text_type(std::size_t size) {
  Hdf5Handle type(H5Tcopy(H5T_C_S1));
  H5Tset_size(type.get(), std::max<std::size_t>(size, 1));
  H5Tset_strpad(type.get(), H5T_STR_NULLPAD);
  return type;
}

/// Makes the library create missing groups.
Hdf5Handle link_properties() {
  Hdf5Handle properties(H5Pcreate(H5P_LINK_CREATE));
  H5Pset_create_intermediate_group(properties.get(), 1);
  return properties;
}

}  // namespace

struct Hdf5File::State {
  /// An open table and its number of rows.
  struct Open {
    Hdf5Handle set;
    hsize_t columns = 0;
    hsize_t rows = 0;
  };

  std::string name;
  Hdf5Handle file;
  std::vector<Open> tables;

  void check(bool good) const {
    if (good) return;
    throw FileError(fmt::format(
        "{}: cannot be written; check that its folder is writable and the disk not full", name));
  }
  void write_attribute(hid_t object, const std::string& key, const std::string& text) const;
  void append(int table, hid_t type, const void* values, std::size_t count);
};

void Hdf5File::State::write_attribute(hid_t object, const std::string& key,
                                      const std::string& text) const {
  const Hdf5Handle type = text_type(text.size());
  const Hdf5Handle space(H5Screate(H5S_SCALAR));
  const Hdf5Handle attribute(
      H5Acreate2(object, key.c_str(), type.get(), space.get(), H5P_DEFAULT, H5P_DEFAULT));
  check(attribute.valid() && H5Awrite(attribute.get(), type.get(), text.c_str()) >= 0);
}

void Hdf5File::State::append(int table, hid_t type, const void* values, std::size_t count) {
  Open& open = tables[static_cast<std::size_t>(table)];
  const hsize_t width = std::max<hsize_t>(open.columns, 1);
  assert(count % width == 0);
  if (count == 0) return;
  const int rank = open.columns == 0 ? 1 : 2;
  const std::array<hsize_t, 2> begin{open.rows, 0};
  const std::array<hsize_t, 2> block{count / width, width};
  open.rows += block[0];
  const std::array<hsize_t, 2> size{open.rows, width};
  check(H5Dset_extent(open.set.get(), size.data()) >= 0);
  const Hdf5Handle space(H5Dget_space(open.set.get()));
  const Hdf5Handle memory(H5Screate_simple(rank, block.data(), nullptr));
  check(H5Sselect_hyperslab(space.get(), H5S_SELECT_SET, begin.data(), nullptr, block.data(),
                            nullptr) >= 0);
  check(H5Dwrite(open.set.get(), type, memory.get(), space.get(), H5P_DEFAULT, values) >= 0);
}

Hdf5File::Hdf5File(const std::filesystem::path& path) : state_(std::make_unique<State>()) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);  // The library must not print; we report errors
                                                // ourselves.
  state_->name = path.string();
  const Hdf5Handle creation(H5Pcreate(H5P_FILE_CREATE));
  H5Pset_obj_track_times(creation.get(), false);
  state_->file = Hdf5Handle(H5Fcreate(path.c_str(), H5F_ACC_EXCL, creation.get(), H5P_DEFAULT));
  state_->check(state_->file.valid());
}

Hdf5File::~Hdf5File() = default;

int Hdf5File::add(const Hdf5Table& table) {
  const auto columns = static_cast<hsize_t>(table.columns);
  const int rank = columns == 0 ? 1 : 2;
  const hid_t type = file_type(table.type);
  const hsize_t row_bytes = std::max<hsize_t>(columns, 1) * H5Tget_size(type);
  const std::array<hsize_t, 2> none{0, columns};
  const std::array<hsize_t, 2> most{H5S_UNLIMITED, columns};
  const std::array<hsize_t, 2> chunk{std::clamp<hsize_t>(kChunkBytes / row_bytes, 1, 4096),
                                     columns};
  const Hdf5Handle space(H5Screate_simple(rank, none.data(), most.data()));
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_chunk(creation.get(), rank, chunk.data());
  H5Pset_shuffle(creation.get());
  H5Pset_deflate(creation.get(), kDeflate);
  H5Pset_obj_track_times(creation.get(), false);
  State::Open open;
  open.columns = columns;
  open.set = Hdf5Handle(H5Dcreate2(state_->file.get(), table.path.c_str(), type, space.get(),
                                   link_properties().get(), creation.get(), H5P_DEFAULT));
  state_->check(open.set.valid());
  if (!table.unit.empty()) state_->write_attribute(open.set.get(), "unit", table.unit);
  if (!table.meaning.empty()) state_->write_attribute(open.set.get(), "meaning", table.meaning);
  state_->tables.push_back(std::move(open));
  return static_cast<int>(state_->tables.size()) - 1;
}

void Hdf5File::append(int table, const std::vector<double>& values) {
  state_->append(table, H5T_NATIVE_DOUBLE, values.data(), values.size());
}

void Hdf5File::append(int table, const std::vector<float>& values) {
  state_->append(table, H5T_NATIVE_FLOAT, values.data(), values.size());
}

void Hdf5File::append(int table, const std::vector<std::uint8_t>& values) {
  state_->append(table, H5T_NATIVE_UINT8, values.data(), values.size());
}

void Hdf5File::append(int table, const std::vector<std::int32_t>& values) {
  state_->append(table, H5T_NATIVE_INT32, values.data(), values.size());
}

void Hdf5File::write_texts(const std::string& path, const std::vector<std::string>& texts) {
  std::size_t longest = 1;
  for (const std::string& text : texts) longest = std::max(longest, text.size());
  std::string bytes;
  for (std::string text : texts) {
    text.resize(longest);
    bytes += text;
  }
  const Hdf5Handle type = text_type(longest);
  const hsize_t count = texts.size();
  const Hdf5Handle space(H5Screate_simple(1, &count, nullptr));
  const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE));
  H5Pset_obj_track_times(creation.get(), false);
  const Hdf5Handle set(H5Dcreate2(state_->file.get(), path.c_str(), type.get(), space.get(),
                                  link_properties().get(), creation.get(), H5P_DEFAULT));
  state_->check(set.valid());
  if (count == 0) return;
  state_->check(H5Dwrite(set.get(), type.get(), H5S_ALL, H5S_ALL, H5P_DEFAULT, bytes.data()) >= 0);
}

void Hdf5File::set_attribute(const std::string& path, const std::string& name,
                             const std::string& text) {
  const Hdf5Handle object(H5Oopen(state_->file.get(), path.c_str(), H5P_DEFAULT));
  state_->check(object.valid());
  state_->write_attribute(object.get(), name, text);
}

void Hdf5File::set_attribute(const std::string& path, const std::string& name, double value) {
  const Hdf5Handle object(H5Oopen(state_->file.get(), path.c_str(), H5P_DEFAULT));
  const Hdf5Handle space(H5Screate(H5S_SCALAR));
  const Hdf5Handle attribute(H5Acreate2(object.get(), name.c_str(), H5T_IEEE_F64LE, space.get(),
                                        H5P_DEFAULT, H5P_DEFAULT));
  state_->check(attribute.valid() && H5Awrite(attribute.get(), H5T_NATIVE_DOUBLE, &value) >= 0);
}

void Hdf5File::close() {
  bool good = true;
  for (State::Open& open : state_->tables) good = open.set.close() && good;
  state_->tables.clear();
  good = state_->file.valid() && H5Fflush(state_->file.get(), H5F_SCOPE_GLOBAL) >= 0 && good;
  state_->check(state_->file.close() && good);
}

}  // namespace castaway::testbed
