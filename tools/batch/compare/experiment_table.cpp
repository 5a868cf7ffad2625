#include "tools/batch/compare/experiment_table.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/base/formats/figure_text.hpp"

namespace castaway::testbed {
namespace {

using Json = nlohmann::ordered_json;
/// Formats a localizer's cell from its figures and its name.
using Cell = std::function<std::string(const Json& figures, const std::string& name)>;

std::string with_interval(const Json& figures, const char* key, const char* format) {
  return figure_text(figures.at(key), format) +
         interval_text(figures.at(fmt::format("{}_interval", key)), format);
}

/// Adds rows and pads them to the length of the head.
class Builder {
 public:
  Builder(const Experiment& experiment, const Json& summary)
      : experiment_(experiment), localizers_(summary.at("localizers")) {
    table_.head = {"", "paper: MH-AMCL", "paper: AMCL"};
    for (const auto& [name, figures] : localizers_.items()) table_.head.push_back(name);
  }

  void row(const std::string& label, const Cell& cell) {
    std::vector<std::string> cells{label, "", ""};
    for (const PaperFigure& figure : experiment_.paper) {
      if (figure.label == label) cells = {label, figure.mh_amcl, figure.amcl};
    }
    for (const auto& [name, figures] : localizers_.items()) cells.push_back(cell(figures, name));
    table_.rows.push_back(std::move(cells));
  }

  TextTable take() { return std::move(table_); }

 private:
  const Experiment& experiment_;
  const Json& localizers_;
  TextTable table_;
};

void add_tracking(const Json& timing, Builder& builder) {
  builder.row("error, mean +- sd [m]", [](const Json& figures, const std::string&) {
    const Json& error = figures.at("error_m");
    return figure_text(error.at("mean"), "{:.4f}") + " +- " + figure_text(error.at("sd"), "{:.4f}");
  });
  builder.row("error, median [m]", [](const Json& figures, const std::string&) {
    return figure_text(figures.at("/error_m/median"_json_pointer), "{:.4f}");
  });
  builder.row("error, mean, 95 % over runs [m]", [](const Json& figures, const std::string&) {
    return with_interval(figures.at("error_m"), "mean", "{:.4f}");
  });
  builder.row("CPU per update [ms]", [&timing](const Json&, const std::string& name) {
    const Json& localizers = timing.at("localizers");
    return localizers.contains(name)
               ? figure_text(localizers.at(name).at("update_ms").at("mean"), "{:.2f}")
               : "-";
  });
  builder.row("hypotheses, mean (most)", [](const Json& figures, const std::string&) {
    const Json& hypotheses = figures.at("hypotheses");
    return figure_text(hypotheses.at("mean"), "{:.2f}") +
           figure_text(hypotheses.at("max"), " ({:.0f})");
  });
  builder.row("quality, mean", [](const Json& figures, const std::string&) {
    return figure_text(figures.at("/quality/mean"_json_pointer), "{:.3f}");
  });
  builder.row("uncertainty, mean [m]", [](const Json& figures, const std::string&) {
    return figure_text(figures.at("/sigma_m/mean"_json_pointer), "{:.4f}");
  });
}

void add_recovery(Builder& builder) {
  builder.row("recovery time, mean [s]", [](const Json& figures, const std::string&) {
    return with_interval(figures.at("/recovery/time_s"_json_pointer), "mean", "{:.3f}");
  });
  builder.row("success", [](const Json& figures, const std::string&) {
    const Json& recovery = figures.at("recovery");
    return figure_text(recovery.at("success"), "{:.2f} %", 100.0) +
           interval_text(recovery.at("success_interval"), "{:.1f}", 100.0);
  });
  builder.row("starts", [](const Json& figures, const std::string&) {
    return figure_text(figures.at("/recovery/events"_json_pointer), "{:.0f}");
  });
  builder.row("slowest [s]", [](const Json& figures, const std::string&) {
    return figure_text(figures.at("/recovery/time_s/max"_json_pointer), "{:.2f}");
  });
  for (const char* score : {"quality", "probability", "covariance"}) {
    builder.row(fmt::format("ROC area of the {}", score), [score](const Json& figures,
                                                                  const std::string&) {
      return figure_text(figures.at("discrimination").at(fmt::format("{}_auc", score)), "{:.3f}");
    });
  }
  for (const char* score : {"quality", "sigma"}) {
    builder.row(fmt::format("correlation of {} and error", score), [score](const Json& figures,
                                                                           const std::string&) {
      return figure_text(figures.at("correlation").at(fmt::format("{}_error", score)), "{:.2f}");
    });
  }
}

/// Mean over the runs, with the range if there are several.
std::string over_runs(const Json& runs, const char* key, const char* format) {
  std::vector<double> values;
  for (const Json& run : runs) {
    if (run.at(key).is_number()) values.push_back(run.at(key).get<double>());
  }
  if (values.empty()) return "-";
  double sum = 0.0;
  for (const double value : values) sum += value;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  std::string text = fmt::format(fmt::runtime(format), sum / static_cast<double>(values.size()));
  if (values.size() == 1) return text;
  return fmt::format("{} ({} to {})", text, fmt::format(fmt::runtime(format), *low),
                     fmt::format(fmt::runtime(format), *high));
}

void add_driving(const Json& summary, Builder& builder) {
  const auto row = [&](const char* label, const char* key, const char* format) {
    builder.row(label, [&summary, key, format](const Json&, const std::string&) {
      return over_runs(summary.at("driving"), key, format);
    });
  };
  row("distance [m]", "distance_m", "{:.0f}");
  row("time [h]", "time_h", "{:.2f}");
  row("recovery behaviours", "recoveries", "{:.0f}");
  row("collisions", "collisions", "{:.0f}");
  row("emergency stops", "emergency_stops", "{:.0f}");
  builder.row("error, mean +- sd [m]", [](const Json& figures, const std::string&) {
    const Json& error = figures.at("error_m");
    return figure_text(error.at("mean"), "{:.4f}") + " +- " + figure_text(error.at("sd"), "{:.4f}");
  });
}

}  // namespace

TextTable experiment_table(const Experiment& experiment, const Json& summary, const Json& timing) {
  Builder builder(experiment, summary);
  if (experiment.number == 1) add_tracking(timing, builder);
  if (experiment.number == 2) add_recovery(builder);
  if (experiment.number == 3) add_driving(summary, builder);
  return builder.take();
}

}  // namespace castaway::testbed
