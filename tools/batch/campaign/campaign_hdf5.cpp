#include "tools/batch/campaign/campaign_hdf5.hpp"

#include <algorithm>
#include <limits>

#include "tools/base/formats/hdf5_file.hpp"
#include "tools/batch/campaign/campaign_cell.hpp"
#include "tools/batch/campaign/campaign_tables.hpp"

namespace castaway::testbed {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();

/// Numbers texts in the order in which they are first met.
class Numbering {
 public:
  std::int32_t number(const std::string& text) {
    const auto found = std::find(texts_.begin(), texts_.end(), text);
    if (found == texts_.end()) {
      texts_.push_back(text);
      return static_cast<std::int32_t>(texts_.size()) - 1;
    }
    return static_cast<std::int32_t>(found - texts_.begin());
  }
  [[nodiscard]] const std::vector<std::string>& texts() const { return texts_; }

 private:
  std::vector<std::string> texts_;
};

/// A table whose values are written many at a time.
class BufferedTable {
 public:
  BufferedTable(Hdf5File& file, const Hdf5Table& table) : file_(&file), id_(file.add(table)) {}

  void add(double value) { values_.push_back(value); }
  /// Writes what was added; only whole rows may be there.
  void flush(std::size_t at_least) {
    if (values_.empty() || values_.size() < at_least) return;
    file_->append(id_, values_);
    values_.clear();
  }

 private:
  Hdf5File* file_;
  int id_;
  std::vector<double> values_;
};

/// Columns of one length.
class BufferedTables {
 public:
  explicit BufferedTables(Hdf5File& file) : file_(&file) {}

  BufferedTable& add(const Hdf5Table& table) {
    return *tables_.emplace_back(std::make_unique<BufferedTable>(*file_, table));
  }
  void end_row() {
    constexpr std::size_t kAtOnce = 4096;
    for (const auto& table : tables_) table->flush(kAtOnce);
  }
  void finish() {
    for (const auto& table : tables_) table->flush(1);
  }

 private:
  Hdf5File* file_;
  std::vector<std::unique_ptr<BufferedTable>> tables_;
};

void write_combinations(const CampaignSpec& spec, Hdf5File& file) {
  for (std::size_t key = 0; key < spec.grid.size(); ++key) {
    std::vector<std::string> texts;
    for (int k = 0; k < spec.combinations(); ++k) {
      texts.push_back(combination_values(spec, k)[key].second);
    }
    file.write_texts("/combinations/" + spec.grid[key].path, texts);
  }
}

/// A table with a column for each name, unless there is none.
BufferedTable* add_wide(BufferedTables& tables, const std::string& path,
                        const std::vector<std::string>& names) {
  if (names.empty()) return nullptr;
  return &tables.add({.path = path, .columns = static_cast<int>(names.size())});
}

void write_cells(const CampaignSpec& spec, CellRows& rows, Hdf5File& file) {
  const std::vector<std::string> metrics = metric_names(rows);
  std::vector<std::string> drawn;
  for (const DrawnKey& key : spec.drawn) drawn.push_back(key.path);
  if (!metrics.empty()) file.write_texts("/cells/metric_names", metrics);
  if (!drawn.empty()) file.write_texts("/cells/drawn_keys", drawn);
  BufferedTables tables(file);
  BufferedTable& cell = tables.add({.path = "/cells/cell", .type = Hdf5Type::kInt32});
  BufferedTable& combination = tables.add({.path = "/cells/combination", .type = Hdf5Type::kInt32});
  BufferedTable& seed = tables.add({.path = "/cells/seed", .type = Hdf5Type::kInt64});
  BufferedTable& state = tables.add(
      {.path = "/cells/state", .type = Hdf5Type::kUint8, .meaning = "0 done, 1 void, 2 failed"});
  BufferedTable* values = add_wide(tables, "/cells/drawn", drawn);
  BufferedTable* figures = add_wide(tables, "/cells/metrics", metrics);
  for (const int index : rows.jobs()) {
    const CellRow row = rows.row(index);
    cell.add(index);
    const int combination_of_cell = index / spec.samples();
    combination.add(combination_of_cell);
    seed.add(static_cast<double>(row.seed));
    state.add(static_cast<double>(row.state));
    for (std::size_t k = 0; k < drawn.size(); ++k) {
      values->add(number_of(row.values[spec.grid.size() + k].second).value_or(kNothing));
    }
    for (const std::string& name : metrics) {
      const auto found = row.metrics.find(name);
      figures->add(found == row.metrics.end() ? kNothing : found->second.value_or(kNothing));
    }
    tables.end_row();
  }
  tables.finish();
}

void write_kidnaps_of(CellRows& rows, Hdf5File& file) {
  Numbering localizers;
  Numbering kinds;
  BufferedTables tables(file);
  const auto column = [&](const char* name, Hdf5Type type, const char* unit) -> BufferedTable& {
    return tables.add({.path = std::string("/kidnaps/") + name, .type = type, .unit = unit});
  };
  BufferedTable& cell = column("cell", Hdf5Type::kInt32, "");
  BufferedTable& localizer = column("localizer", Hdf5Type::kInt32, "");
  BufferedTable& kind = column("kind", Hdf5Type::kInt32, "");
  BufferedTable& at = column("at_s", Hdf5Type::kFloat64, "s");
  BufferedTable& to = tables.add({.path = "/kidnaps/to", .columns = 3, .unit = "m, m, rad"});
  BufferedTable& scored = column("scored", Hdf5Type::kUint8, "");
  BufferedTable& recovered = column("recovered", Hdf5Type::kUint8, "");
  BufferedTable& time = column("time_s", Hdf5Type::kFloat64, "s");
  for (const int index : rows.jobs()) {
    for (const CellKidnap& kidnap : rows.row(index).kidnaps) {
      cell.add(index);
      localizer.add(localizers.number(kidnap.localizer));
      kind.add(kinds.number(kidnap.kind));
      at.add(kidnap.at_s);
      const auto pose = kidnap.T_map_to;
      for (const double value :
           {pose ? pose->x : kNothing, pose ? pose->y : kNothing, pose ? pose->yaw : kNothing}) {
        to.add(value);
      }
      scored.add(kidnap.scored ? 1.0 : 0.0);
      recovered.add(kidnap.recovered ? 1.0 : 0.0);
      time.add(kidnap.time_s.value_or(kNothing));
    }
    tables.end_row();
  }
  tables.finish();
  if (localizers.texts().empty()) return;
  file.write_texts("/kidnaps/localizers", localizers.texts());
  file.write_texts("/kidnaps/kinds", kinds.texts());
}

}  // namespace

void write_hdf5(const CampaignSpec& spec, CellRows& rows, const std::filesystem::path& file) {
  Hdf5File hdf5(file);
  hdf5.set_attribute("/", "castaway", CASTAWAY_VERSION);
  hdf5.set_attribute("/", "name", spec.name);
  write_combinations(spec, hdf5);
  write_cells(spec, rows, hdf5);
  write_kidnaps_of(rows, hdf5);
  hdf5.close();
}

}  // namespace castaway::testbed
