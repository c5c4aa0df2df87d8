#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "reports/heat_map.h"
#include "reports/html/html_sections.h"
#include "reports/html/html_text.h"
#include "reports/numbers.h"
#include "reports/quantities.h"

namespace cuesta::html {
namespace {

constexpr double kPixelBudget = 10e6;  // over all pictures of the page: a phone must hold it

std::string colour_text(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", colour.r, colour.g, colour.b);
}

/// All planes' names, in the order in which the first run has them.
std::vector<std::string> plane_names(const Result& result) {
  std::vector<std::string> names;
  for (const RunEntry& run : result.runs) {
    for (const Plane& plane : run.measurements.planes) {
      if (std::find(names.begin(), names.end(), plane.name) == names.end()) names.push_back(plane.name);
    }
  }
  return names;
}

int picture_limit(const Result& result) {
  double pictures = 0;
  for (const RunEntry& run : result.runs) pictures += static_cast<double>(run.measurements.planes.size());
  int limit = 512;
  while (limit > 64 && pictures * limit * limit > kPixelBudget) limit /= 2;
  return limit;
}

std::string colour_bar(const HeatScale& scale) {
  std::string bar =
      "<div class=\"colour-bar\"><div class=\"ramp\" style=\"background:linear-gradient(to right";
  for (int k = 0; k <= 16; ++k) bar += "," + colour_text(viridis(k / 16.0));
  bar += ")\"></div><div class=\"ticks\">";
  for (int64_t tick : scale.ticks()) {
    const double place = scale.place_of(tick);
    bar += fmt::format("<span style=\"left:{:.2f}%\"{}>{}</span>", 100 * place,
                       place < 0.02   ? " class=\"first\""
                       : place > 0.98 ? " class=\"last\""
                                      : "",
                       grouped(tick));
  }
  return bar + fmt::format("</div><p>{}{}, the same scale for every picture</p></div>", escape(scale.unit),
                           scale.logarithmic ? ", logarithmic" : "");
}

std::string scale_for_script(const HeatScale& scale) {
  nlohmann::ordered_json data = {{"first", scale.first}, {"maximum", scale.maximum}, {"unit", scale.unit}};
  data["colours"] = nlohmann::ordered_json::array();
  for (const Colour& colour : palette_of(scale)) data["colours"].push_back(colour_text(colour));
  return "<script type=\"application/json\">" + safe_json(data.dump()) + "</script>";
}

std::string one_picture(const Result& result, const RunEntry& run, const Plane& plane, const HeatScale& scale,
                        int limit) {
  const Measurements& measurements = run.measurements;
  const PlanePicture picture =
      plane_picture(plane, measurements.plane_width, measurements.plane_height, scale, limit);
  const std::string label = label_of(result, run);
  int64_t sum = plane.nobody;
  for (uint32_t value : plane.values) sum += value;
  const std::string below =
      plane.adds_up ? fmt::format("pixels {} + nobody {}", grouped(sum - plane.nobody), grouped(plane.nobody))
                    : std::string("does not add up to a total");
  return fmt::format(
      "<figure class=\"map\" data-scene=\"{}\" data-reduction=\"{}\"><figcaption>{}<output>point to "
      "read</output></figcaption>"
      "<div class=\"canvas\" tabindex=\"0\" role=\"img\" aria-label=\"{} of {}; arrow keys read "
      "pixels\"><img alt=\"\" width=\"{}\" "
      "height=\"{}\" src=\"data:image/png;base64,{}\"></div><small>{}{}</small></figure>",
      escape(run.scene), picture.reduction, escape(label), escape(plane.name), escape(label),
      picture.picture.width, picture.picture.height, base64(encode_png(picture.picture)), below,
      picture.reduction > 1 ? fmt::format("; a point: the mean of {0} x {0} pixels", picture.reduction) : "");
}

/// The pictures of one plane, the scenes one after the other.
std::string pictures(const Result& result, const std::string& name, const HeatScale& scale, int limit) {
  const std::vector<RunGroup> groups = group_by_scene(result);
  std::string html;
  for (const RunGroup& group : groups) {
    if (groups.size() > 1) html += "<h3>" + escape(group.scene) + "</h3>";
    html += group.runs.size() > 2 ? "<div class=\"grid pictures\">" : "<div class=\"grid pictures few\">";
    for (size_t index : group.runs) {
      for (const Plane& plane : result.runs[index].measurements.planes) {
        if (plane.name == name) html += one_picture(result, result.runs[index], plane, scale, limit);
      }
    }
    html += "</div>";
  }
  return html;
}

}  // namespace

std::string heat_map_section(const Result& result, ShownNames& shown) {
  const std::vector<std::string> names = plane_names(result);
  if (names.empty()) return "";
  const int limit = picture_limit(result);
  std::string tabs = "<div class=\"tabs\" role=\"tablist\">", panels;
  for (size_t k = 0; k < names.size(); ++k) {
    const HeatScale scale = make_heat_scale(result, names[k]);
    const std::string id = fmt::format("maps-{}", k);
    std::string title = names[k].substr(names[k].find('.') + 1);
    std::replace(title.begin(), title.end(), '_', ' ');
    tabs += fmt::format("<button role=\"tab\" aria-controls=\"{}\" aria-selected=\"{}\">{}</button>", id,
                        k == 0, escape(title));
    shown.insert(names[k]);
    panels += fmt::format("<div class=\"maps\" role=\"tabpanel\" id=\"{}\"><p>{}</p>", id,
                          defined(names[k], names[k], shown) + ": " + escape(definition_sentence(names[k])));
    panels +=
        colour_bar(scale) + scale_for_script(scale) + pictures(result, names[k], scale, limit) + "</div>";
  }
  return tabs + "</div>" + panels;
}

}  // namespace cuesta::html
