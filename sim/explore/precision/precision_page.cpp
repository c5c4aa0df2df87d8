#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

#include "reports/html/html_text.h"
#include "reports/html/svg_line_plot.h"
#include "reports/numbers.h"
#include "reports/study/literature.h"
#include "reports/study/study_parts.h"
#include "sim/explore/precision/precision.h"

namespace cuesta {
namespace html {
namespace {

using namespace precision;

constexpr int kWidestF = 12, kWidestM = 8, kWidestD = 32;
constexpr double kBounds[] = {0.5, 0.1, 0.05};

const std::string kDefault = default_format();

/// Takes the largest of a counter over the cases, scaled; nullopt: no case.
std::optional<double> largest(const StudyTable& table, const Where& where, std::string_view counter) {
  std::optional<double> most;
  for (const StudyPlace& place : places_where(table, where)) {
    const auto value = value_of(table, place, {counter, "", 1.0 / kParts});
    if (value) most = std::max(most.value_or(0), *value);
  }
  return most;
}

/// Gives a counter in per cent of all rays of the cases; 0 where there are none.
double share(const StudyTable& table, const Where& where, const std::string& counter) {
  return share_of_rays(table, places_where(table, where), {counter}).value_or(0);
}

std::string percent(double value) { return (value == 0 ? "0" : significant(value, 2)) + " %"; }
std::string number_text(const std::optional<double>& value) {
  return !value ? "-" : *value == 0 ? "0" : significant(*value, 2);
}

Where at(const std::string& size, const std::string& bits, const std::string& format) {
  return {{"size", size}, {"bits", bits}, {"format", format}};
}

/// Sums up what one format does: heights, places, cells.
std::string summary(const StudyTable& table, const Where& where) {
  return fmt::format(
      "{} LSB<br>{} texels<br>{} other cell<br>{} strayed", number_text(largest(table, where, "top_max")),
      number_text(largest(table, where, "wall_max")), percent(100 - share(table, where, "same_cell")),
      percent(share(table, where, "strayed")));
}

std::string formats_section(const StudyTable& table) {
  const std::pair<std::string, std::string> kShown[] = {
      {"double", "double"},
      {"float", "float"},
      {kDefault, "fixed, f = 8, M = B + 4, D = 32 (default)"},
      {fixed_format(8, 2, 32), "fixed, M = B + 2"},
      {fixed_format(8, 8, 32), "fixed, M = B + 8"},
      {std::string("double") + kHalf, "double, half heights"},
      {kDefault + kHalf, "fixed, default, half heights"}};
  std::vector<std::pair<std::string, std::string>> panels;
  for (const std::string& bits : table.axis("bits").values) {
    std::vector<std::string> head{"format"};
    for (const std::string& size : table.axis("size").values) head.push_back(size + " texels");
    std::vector<std::vector<std::string>> rows;
    for (const auto& [format, name] : kShown) {
      if (places_where(table, {{"format", format}}).empty()) continue;
      rows.push_back({escape(name)});
      for (const std::string& size : table.axis("size").values)
        rows.back().push_back(summary(table, at(size, bits, format)));
    }
    panels.emplace_back(bits + "-bit heights", with_firm_spaces(plain_table(head, rows)));
  }
  return study_section(
      "Formats",
      "Over all angles: the largest error of a hit on a texel's top (height LSBs) and on its wall (texels "
      "along the plane), in the true cell; rays that hit another cell; rays among them that strayed, by more "
      "than a "
      "height LSB and a texel.",
      choice("formats", panels));
}

/// Finds the set of widths of least M + f + D whose largest error over all angles is within `bound`, of
/// equals the one of least M; "none" where there is none.
std::string narrowest(const StudyTable& table, const std::string& size, const std::string& bits,
                      std::string_view counter, double bound) {
  int n = 0, heights = 0;
  std::from_chars(bits.data(), bits.data() + bits.size(), heights);
  int side = 0;
  std::from_chars(size.data(), size.data() + size.size(), side);
  while (1 << n < side) ++n;
  int least = std::numeric_limits<int>::max();
  std::string best;
  for (const int m : kMantissaBits) {
    for (const int f : kFractionBits) {
      for (const int d : kDirectionBits) {
        const auto found = largest(table, at(size, bits, fixed_format(f, m, d)), counter);
        if (!found || *found > bound || heights + m + f + d >= least) continue;
        least = heights + m + f + d;
        best = fmt::format("M=B+{}<br>f={} D={}<br>T={}", m, f, d,
                           std::max(n + kTileBits, heights) + f + heights + m);
      }
    }
  }
  return best.empty() ? "none" : best;
}

/// Counts the sets that `narrowest` looks for in the data.
size_t sets_of_widths(const StudyTable& table) {
  const std::vector<std::string>& formats = table.axis("format").values;
  return static_cast<size_t>(std::ranges::count_if(formats, [](const std::string& format) {
    return format.starts_with("f") && format.find("/M+") != std::string::npos && !format.ends_with(kHalf);
  }));
}

std::string widths_section(const StudyTable& table) {
  std::vector<std::string> head{"map"};
  for (const double bound : kBounds) head.push_back(fmt::format("tops within {} LSB", bound));
  for (const double bound : kBounds) head.push_back(fmt::format("walls within {} texels", bound));
  std::vector<std::vector<std::string>> rows;
  for (const std::string& bits : table.axis("bits").values) {
    for (const std::string& size : table.axis("size").values) {
      rows.push_back({fmt::format("{}&nbsp;texels, {}&nbsp;bits", size, bits)});
      for (const char* counter : {"top_max", "wall_max"}) {
        for (const double bound : kBounds)
          rows.back().push_back(narrowest(table, size, bits, counter, bound));
      }
    }
  }
  const size_t sets = sets_of_widths(table);
  constexpr size_t kAll = std::size(kFractionBits) * std::size(kMantissaBits) * std::size(kDirectionBits);
  const std::string of =
      sets == kAll
          ? fmt::format(
                "Of the {} sets of f = {} to {}, M = B to B + {} and D = {} to {} the one of "
                "fewest ",
                sets, *std::begin(kFractionBits), *std::rbegin(kFractionBits), *std::rbegin(kMantissaBits),
                *std::begin(kDirectionBits), *std::rbegin(kDirectionBits))
          : fmt::format("Of the {} sets of widths in these data the one of fewest ", sets);
  return study_section(
      "The smallest widths for an error",
      of + fmt::format("bits in all whose largest error over all angles and rays in the true cell is within "
                       "the bound; none: not even the widest. T is what a time takes, with w2 = {}.",
                       kTileBits),
      plain_table(head, rows));
}

/// Draws a line per size: a counter's largest over all angles against one width.
std::string width_plot(const StudyTable& table, const std::string& bits, std::string_view counter,
                       const std::string& title, const std::string& remark, const std::string& unit,
                       std::span<const int> widths, const std::string& label,
                       std::string (*name)(int width)) {
  LinePlot plot;
  plot.title = title;
  plot.remark = remark;
  plot.y_unit = unit;
  plot.points = true;
  plot.logarithmic = true;
  for (size_t k = 0; k < widths.size(); ++k) {
    plot.places.push_back(0.05 + 0.9 * static_cast<double>(k) / static_cast<double>(widths.size() - 1));
    plot.place_texts.push_back(label + std::to_string(widths[k]));
    plot.x_ticks.emplace_back(plot.places.back(), plot.place_texts.back());
  }
  size_t series = 0;
  for (const std::string& size : table.axis("size").values) {
    Line line{size + " texels", series_class(series++), {}, {}};
    bool some = false;
    for (const int width : widths) {
      const auto value = largest(table, at(size, bits, name(width)), counter);
      const bool shown = value && *value > 0;
      some = some || shown;
      line.values.push_back(shown ? *value : std::numeric_limits<double>::quiet_NaN());
      line.texts.push_back(value ? significant(*value, 2) + " " + unit : "-");
    }
    if (some) plot.lines.push_back(std::move(line));
  }
  return plot.lines.empty() ? "" : svg_line_plot(plot);
}

std::string plots_section(const StudyTable& table) {
  std::vector<std::pair<std::string, std::string>> panels;
  const auto of_m = [](int width) { return fixed_format(kWidestF, width, kWidestD); };
  const auto of_f = [](int width) { return fixed_format(width, kWidestM, kWidestD); };
  const auto of_d = [](int width) { return fixed_format(kWidestF, kWidestM, width); };
  for (const std::string& bits : table.axis("bits").values) {
    const std::string plots = width_plot(table, bits, "top_max", "Heights against M", "tops; f = 12, D = 32",
                                         "LSB", kMantissaBits, "B+", of_m) +
                              width_plot(table, bits, "top_max", "Heights against D",
                                         "tops; f = 12, M = B + 8", "LSB", kDirectionBits, "D=", of_d) +
                              width_plot(table, bits, "wall_max", "Places against M", "walls; f = 12, D = 32",
                                         "texels", kMantissaBits, "B+", of_m) +
                              width_plot(table, bits, "wall_max", "Places against f",
                                         "walls; M = B + 8, D = 32", "texels", kFractionBits, "f=", of_f);
    if (!plots.empty())
      panels.emplace_back(bits + "-bit heights", "<div class=\"grid wide\">" + plots + "</div>");
  }
  if (panels.empty()) return "";  // the quick matrix has none of these sets
  return study_section(
      "Error against each width",
      "The largest over all angles, the other widths at their widest; logarithmic. M is what "
      "a reciprocal is rounded to: two bits more, a quarter of the error.",
      choice("widths", panels));
}

std::string angles_section(const StudyTable& table) {
  std::vector<std::pair<std::string, std::string>> panels;
  for (const std::string& bits : table.axis("bits").values) {
    std::vector<std::string> head{"side"};
    for (const std::string& angle : table.axis("angle").values) head.push_back(angle + "°");
    std::vector<std::vector<std::string>> rows;
    for (const std::string& size : table.axis("size").values) {
      rows.push_back({size + "&nbsp;texels"});
      for (const std::string& angle : table.axis("angle").values) {
        Where where = at(size, bits, kDefault);
        where.emplace_back("angle", angle);
        rows.back().push_back(fmt::format("{} LSB<br>{} texels<br>{} other cell",
                                          number_text(largest(table, where, "height_p99")),
                                          number_text(largest(table, where, "texel_p99")),
                                          percent(100 - share(table, where, "same_cell"))));
      }
    }
    panels.emplace_back(bits + "-bit heights", with_firm_spaces(plain_table(head, rows)));
  }
  return study_section(
      "By angle",
      "Default format, all rays that hit, in whatever cell: the 99th percentile of the error along the "
      "ray, as a difference in height and in the plane. Seen steeply, a wall's height is "
      "passed within a fraction of a texel: a small error of place is a large one of height.",
      choice("angles", panels));
}

std::string of_mantissa(const StudyTable& table, int mantissa) {
  std::string text;
  for (const std::string& bits : table.axis("bits").values) {
    double least = std::numeric_limits<double>::infinity(), most = 0;
    for (const std::string& size : table.axis("size").values) {
      const auto value =
          largest(table, at(size, bits, fixed_format(kWidestF, mantissa, kWidestD)), "top_max");
      if (!value) continue;
      least = std::min(least, *value);
      most = std::max(most, *value);
    }
    if (most == 0) continue;
    text += fmt::format("{}{} bits: ", text.empty() ? "" : "; ", bits);
    const std::string low = significant(least, 2), high = significant(most, 2);
    text += low != high ? fmt::format("{} to {} LSB by size", low, high) : high + " LSB";
  }
  return text.empty() ? "not in these data" : text;
}

std::string other_cells(const StudyTable& table) {
  std::string text;
  for (const std::string& format : {std::string("float"), kDefault}) {
    text += fmt::format("{}{}: {}", text.empty() ? "" : "; ", format == kDefault ? "the default" : format,
                        percent(100 - share(table, {{"format", format}}, "same_cell")));
  }
  return text + " of all rays.";
}

std::string times(const StudyTable& table) {
  const std::vector<std::string>&sizes = table.axis("size").values, &bits = table.axis("bits").values;
  const auto one = [&](const std::string& size, const std::string& height) {
    return fmt::format("{} texels, {} bits: {}", size, height,
                       narrowest(table, size, height, "top_max", 0.1));
  };
  const std::string least = one(sizes.front(), bits.front());
  if (sizes.size() == 1 && bits.size() == 1) return least;
  return least + "; " + one(sizes.back(), bits.back());
}

std::string statements_section(const StudyTable& table) {
  static const std::vector<Statement> kStatements = {
      {"the design's figures", "prototype",
       "A floating reciprocal needs a mantissa of B + 2 bits for 0.2 LSB, whatever the map's size.",
       [](const StudyTable& t) { return of_mantissa(t, 2); },
       "Tops, largest over all angles, f = 12, D = 32."},
      {"the design's figures", "prototype", "B + 4 bits for 0.05 LSB.",
       [](const StudyTable& t) { return of_mantissa(t, 4); },
       "The same. What grows with the size is the error of places, not of heights: see the walls."},
      {"the design's figures", "prototype",
       "The hit cell differs from the exact one: float 2 of 16,000 rays, a 16-bit fixed reciprocal 1,001.",
       other_cells,
       "Other maps, angles and rays; the machine's reciprocal floats. A relief in ever finer texels has ever "
       "more "
       "cells to miss."},
      {"the design's figures", "prototype",
       "Time needs 25 to 29 bits for 256 x 8 bit, 39 to 43 for 16384 x 16 bit.", times,
       "Tops within 0.1 LSB; w2 = 4 is in T."}};
  return study_section("Beside the figures of the plan",
                       "What a prototype found before the machine was built, and what these data say.",
                       statements(kStatements, table));
}

}  // namespace
}  // namespace html

std::string precision_headline(const StudyData& data) {
  using namespace html;
  const StudyTable table(data);
  const auto top = largest(table, {{"format", kDefault}}, "top_p99");
  if (!top) return kEndedTooEarly;
  const std::vector<std::string>&sizes = table.axis("size").values, &bits = table.axis("bits").values;
  const auto walls = [&](const std::string& size) {
    return number_text(largest(table, at(size, bits.front(), kDefault), "wall_max"));
  };
  const std::string double_half = std::string("double") + kHalf;
  const std::string half =
      number_text(largest(table, {{"format", double_half}, {"bits", bits.back()}}, "top_max"));
  const std::string single = number_text(largest(table, {{"format", "float"}}, "top_max"));
  if (sizes.size() == 1) {
    return fmt::format(
        "On a map of {} texels a side a reciprocal of M = B + 4 bits puts a hit within {} height LSB on a "
        "texel's "
        "top (99 % of a case, worst case), and at {} bits within {} texels on a wall. Half-precision heights "
        "of {} "
        "bits cost {}; float costs {} LSB at most.",
        sizes.front(), significant(*top, 2), bits.front(), walls(sizes.front()), bits.back(),
        half == "0" ? "nothing" : "up to " + half + " LSB", single);
  }
  return fmt::format(
      "The height of a hit needs a reciprocal of M = B + 4 bits whatever the map's size: within {} height "
      "LSB on a "
      "texel's top (99 % of a case, worst case). Its place needs more bits the finer the map: at {} bits M = "
      "B + 4 puts "
      "hits on walls within {} texels at {} texels a side and within {} at {}. Half-precision heights cost "
      "up to {} LSB "
      "at {} bits and nothing to 11 bits; float costs {} LSB at most.",
      significant(*top, 2), bits.front(), walls(sizes.front()), sizes.front(), walls(sizes.back()),
      sizes.back(), half, bits.back(), single);
}

std::string precision_page(const StudyData& data) {
  using namespace html;
  const StudyTable table(data);
  return study_shell(data, precision_headline(data),
                     formats_section(table) + widths_section(table) + plots_section(table) +
                         angles_section(table) + statements_section(table) + study_method(data));
}

}  // namespace cuesta
