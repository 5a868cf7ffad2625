#include "tools/batch/compare/error_rows.hpp"

#include <algorithm>

#include "tools/base/formats/csv.hpp"

namespace castaway::testbed {
namespace {

/// Column indices in errors.csv.
struct Columns {
  std::size_t stamp, localizer, error, quality, sigma, probability, populations;

  explicit Columns(const CsvTable& table)
      : stamp(table.column("stamp_s")),
        localizer(table.column("localizer")),
        error(table.column("position_error_m")),
        quality(table.column("quality")),
        sigma(table.column("sigma_m")),
        probability(table.column("probability")),
        populations(table.column("populations")) {}
};

ErrorRow row_of(const std::vector<std::string>& cells, const Columns& at) {
  const auto number = [&](std::size_t column) { return csv_number(cells[column]).value_or(0.0); };
  return {number(at.stamp), csv_number(cells[at.error]), number(at.quality),
          number(at.sigma), number(at.probability),      number(at.populations)};
}

}  // namespace

std::vector<LocalizerRows> read_error_rows(const std::filesystem::path& run_folder) {
  const CsvTable table = read_csv(run_folder / "errors.csv");
  const Columns at(table);
  std::vector<LocalizerRows> result;
  for (const std::vector<std::string>& cells : table.rows) {
    const std::string& name = cells[at.localizer];
    auto found = std::find_if(result.begin(), result.end(),
                              [&](const LocalizerRows& rows) { return rows.localizer == name; });
    if (found == result.end()) found = result.insert(result.end(), LocalizerRows{name, {}});
    found->rows.push_back(row_of(cells, at));
  }
  return result;
}

}  // namespace castaway::testbed
