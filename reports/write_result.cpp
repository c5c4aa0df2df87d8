#include "reports/write_result.h"

#include <map>

#include "reports/heat_map.h"
#include "reports/html/html_page.h"
#include "reports/result_csv.h"
#include "reports/result_json.h"

namespace cuesta {
namespace {

void write_heat_maps(const Result& result, ResultFolder& folder) {
  std::map<std::string, HeatScale> scales;
  for (size_t i = 0; i < result.runs.size(); ++i) {
    const RunEntry& run = result.runs[i];
    for (const Plane& plane : run.measurements.planes) {
      if (!scales.contains(plane.name)) scales[plane.name] = make_heat_scale(result, plane.name);
      const std::string title = plane.name.substr(plane.name.find('.') + 1);
      const std::string subtitle = label_of(result, run) + ", " + run.scene;
      const Picture picture = heat_map(plane, run.measurements.plane_width, run.measurements.plane_height,
                                       scales[plane.name], title, subtitle);
      folder.write("heatmaps/" + file_stem_of(result, i) + "." + title + ".png", encode_png(picture));
    }
  }
}

}  // namespace

void write_result(const Result& result, ResultFolder& folder) {
  folder.write("result.json", result_json(result));
  folder.write("result.csv", result_csv(result));
  folder.write("summary.csv", summary_csv(result));
  write_heat_maps(result, folder);
  folder.write("report.html", html_page(result));
  folder.write("manifest.json", manifest_json(result));
}

}  // namespace cuesta
