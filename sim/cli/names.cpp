#include "sim/cli/names.h"

#include <algorithm>

#include "models/common/error.h"
#include "models/common/words.h"

namespace cuesta {

std::vector<std::string> split_at_commas(const std::vector<std::string>& texts, const char* option) {
  std::vector<std::string> parts;
  for (const std::string& text : texts) {
    for (const std::string_view part : split(text, ',')) {
      if (part.empty()) {
        throw usage_error(std::string(option) + " " + printable(text, 200) +
                          (text.empty() ? " names nothing" : " names nothing before or behind a comma") +
                          "; accepted are names with one comma between each two.");
      }
      parts.emplace_back(part);
    }
  }
  return parts;
}

namespace {

constexpr std::string_view kGroups[] = {"all", "parts", "searches", "printed"};

bool is_group(std::string_view name) { return std::ranges::find(kGroups, name) != std::end(kGroups); }

std::span<const Algorithm> group_of(std::string_view name) {
  return name == kGroups[0]   ? algorithms()
         : name == kGroups[1] ? algorithm_parts()
         : name == kGroups[2] ? searches()
                              : printed_searches();
}

bool is_accepted(const std::string& algorithm) {
  try {
    parse_algorithm(algorithm);
    return true;
  } catch (const Error&) {
    return false;
  }
}

/// Where `name`, after a comma, is no algorithm but the rest of the one before it: a decimal comma, or a comma in the
/// place of a colon.
void refuse_comma_inside(const std::string& before, const std::string& name) {
  if (is_accepted(name)) return;
  const size_t equals = before.rfind('=');
  const bool number = equals != std::string::npos &&
                      before.find_first_not_of("0123456789", equals + 1) == std::string::npos &&
                      name[0] >= '0' && name[0] <= '9';
  const std::string joined = before + (number ? "." : ":") + name;
  if (!is_accepted(joined) && name.find('=') >= name.find(':')) return;
  throw usage_error("`" + printable(name) + "` stands after a comma, where the next algorithm begins; " +
                    (number ? "accepted is a decimal point, as in " : "accepted is ") +
                    printable(joined, 200) + (number ? "." : " for one with that ending."));
}

/// "root,common,never": where parts[k], no algorithm, becomes a schedule with what stands after the next commas.
void refuse_commas_for_colons(const std::vector<std::string>& parts, size_t k) {
  if (is_accepted(parts[k])) return;
  std::string schedule = parts[k], found = parts[k], longest, longest_found;
  for (size_t next = k + 1; next < parts.size(); ++next) {
    schedule += ":" + parts[next];
    found += "," + parts[next];
    if (!is_accepted(schedule)) continue;
    longest = schedule;
    longest_found = found;
  }
  if (longest.empty()) return;
  throw usage_error("`" + printable(longest_found, 200) +
                    "`: at a comma the next algorithm begins, and a schedule has colons; accepted is " +
                    printable(longest, 200) + ".");
}

/// Names that stand for several algorithms are known here alone: where one is meant, before parse_algorithm.
void refuse_groups_misspelt(const std::string& name) {
  const std::vector<std::string_view> words = split(name, '+');
  for (const std::string_view word : words) {
    if (words.size() == 1 || is_group(word)) continue;
    const std::string near = did_you_mean(word, kGroups);
    throw usage_error("`" + printable(word) + "` in `" + printable(name) +
                      "` is no group of algorithms; accepted between plus signs are " + joined(kGroups) +
                      (near.empty() ? ". Single algorithms are joined by commas." : near));
  }
  const std::string_view first = std::string_view(name).substr(0, name.find(':'));
  if (first.size() < name.size() && is_group(first)) {
    std::vector<std::string_view> ids;
    for (const Algorithm& algorithm : group_of(first)) ids.push_back(algorithm.id);
    throw usage_error("`" + printable(name) + "`: " + std::string(first) +
                      " are several algorithms, and an ending belongs to one; accepted are " + joined(ids) +
                      ", each with its own.");
  }
  if (is_accepted(name)) return;
  std::vector<std::string_view> names(std::begin(kGroups), std::end(kGroups));
  for (const std::span<const Algorithm> list :
       {algorithms(), algorithm_parts(), searches(), printed_searches()}) {
    for (const Algorithm& algorithm : list) names.push_back(algorithm.id);
  }
  if (!is_group(nearest_name(name, names))) return;
  throw usage_error(
      "There is no algorithm or group `" + printable(name) +
      "`; accepted are the groups all, parts, searches and printed, what `cuesta list algorithms` "
      "prints, and schedules" +
      did_you_mean(name, kGroups));
}

}  // namespace

std::vector<Algorithm> parse_algorithms(const std::vector<std::string>& names) {
  std::vector<std::string> parts = split_at_commas(names, "--algorithm");
  if (parts.empty()) parts.emplace_back("all");
  std::vector<Algorithm> found;
  const auto add = [&](const Algorithm& algorithm) {
    for (const Algorithm& earlier : found) {
      if (earlier.id == algorithm.id)
        throw usage_error("Algorithm " + algorithm.id + " is given twice; accepted is once.");
    }
    found.push_back(algorithm);
  };
  for (size_t k = 0; k < parts.size(); ++k) {
    // "all+parts+searches+printed": several groups, joined by plus signs
    const std::vector<std::string_view> groups = split(parts[k], '+');
    if (std::ranges::all_of(groups, is_group)) {
      for (const std::string_view group : groups) std::ranges::for_each(group_of(group), add);
      continue;
    }
    if (k > 0) refuse_comma_inside(parts[k - 1], parts[k]);
    refuse_commas_for_colons(parts, k);
    refuse_groups_misspelt(parts[k]);
    add(parse_algorithm(parts[k]));
  }
  return found;
}

std::vector<ResolvedArchitecture> parse_architectures(const std::vector<std::string>& names,
                                                      const std::vector<std::string>& settings,
                                                      Fidelity fidelity) {
  return resolve_machines(split_at_commas(names, "--arch"), settings, fidelity);
}

}  // namespace cuesta
