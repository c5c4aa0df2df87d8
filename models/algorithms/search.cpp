#include "models/algorithms/search.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <vector>

#include "models/common/error.h"
#include "models/common/words.h"

namespace cuesta {
namespace {

using enum SearchKind;

// Numbers that the papers at hand print, or that are known of them, are in `source`; "ours" where they are not.
constexpr auto kRows = std::to_array<SearchRow>({
    {"normal", {kNormal}, false, "ours", "normal mapping: the hit is where the ray enters, no parallax"},
    {"parallax",
     {kParallax},
     false,
     "Kaneko et al. 2001",
     "one sample where the ray enters, then straight to where the ray has that height"},
    {"parallax-limited",
     {kParallaxLimited},
     false,
     "Welsh 2004",
     "as parallax, without the division by the view's height: the offset is never longer than the depth"},
    {"steep",
     {kSteep, 64},
     false,
     "McGuire & McGuire 2005; number of steps ours",
     "linear search: the first sample under the surface"},
    {"pom-printed",
     {kPomPrinted, 64, 8},
     false,
     "Luna 2012, as printed; numbers of samples ours",
     "parallax occlusion mapping with its faults: the first sample is compared one step late, a miss has no "
     "offset"},
    {"pom",
     {kPom, 64, 8},
     false,
     "Luna 2012, repaired; numbers of samples ours",
     "parallax occlusion mapping: linear search with steps by view angle, then one secant"},
    {"pom-tatarchuk",
     {kPomTatarchuk, 50, 8},
     false,
     "Tatarchuk 2006, 8 to 50 samples",
     "parallax occlusion mapping: linear search with steps by view angle, then one secant"},
    {"relief",
     {kRelief, 100, 0, 7},
     true,
     "Policarpo, Oliveira, Comba 2005; 100 + 7 as Ki & Oh 2007 compare it",
     "linear search, then binary search between the last two samples"},
    {"interval",
     {kInterval, 32, 0, 4},
     true,
     "Risser et al. 2005, 1 to 4 secants; number of linear steps ours",
     "linear search, then secants between the last two samples"},
    {"cone",
     {kCone, 100},
     false,
     "Dummer 2006; 100 as Ki & Oh 2007 compare it",
     "from empty cone to empty cone above the surface"},
    {"relaxed-cone",
     {kRelaxedCone, 15, 0, 8},
     true,
     "Policarpo & Oliveira 2007, 15 + 8",
     "along cones that a ray pierces the surface in once at most, then binary search; unsafe"},
    {"distance",
     {kDistance, 16},
     false,
     "Donnelly 2005, 8 to 16 steps",
     "from sphere to sphere of a 3-D distance field of 16 layers"},
    {"safety-radius",
     {kSafetyRadius, 64, 0, 8},
     true,
     "Baboud & Decoret 2006; numbers of steps ours",
     "march by the radius in which a ray crosses the surface once at most, then binary search"},
    {"ki2007-printed",
     {.kind = kKi2007Printed, .steps = 1000, .delta = 500},
     false,
     "Ki & Oh 2007, listings, as printed; most steps ours",
     "pyramidal displacement mapping with its faults: 0 / 0, and an offset at every crossing"},
    {"drobot2009-printed",
     {.kind = kDrobot2009Printed, .steps = 1000, .delta = 500},
     false,
     "Drobot 2009, reconstructed from public copies of its talk's pseudo code and sample; most steps ours",
     "quadtree displacement mapping with its faults: as ki2007-printed, and up one level at every crossing"},
});

/// A number that a row may leave to the user.
struct Choice {
  std::string_view name;
  int Search::*member;
  int low, high;
};

std::vector<Choice> choices(const SearchRow& row) {
  std::vector<Choice> list;
  if (row.search.steps > 0) list.push_back({"steps", &Search::steps, 1, kMostSearchSteps});
  if (row.search.least_steps > 0) list.push_back({"least", &Search::least_steps, 1, kMostSearchSteps});
  if (row.refines) list.push_back({"refine", &Search::refinements, 0, kMostRefinements});
  return list;
}

/// A word that a row accepts.
struct Flag {
  std::string_view name;
  bool Search::*member;
};

std::vector<Flag> flags(const SearchRow& row) {
  if (!is_printed(row.search.kind)) return {};
  if (row.search.kind == kKi2007Printed) return {{"linear", &Search::linear}, {"slope", &Search::slope}};
  return {{"slope", &Search::slope}};
}

/// 500 -> "0.5"
std::string thousandths_text(int value) {
  std::string text = std::to_string(value / 1000);
  std::string digits = std::to_string(1000 + value % 1000).substr(1);
  while (!digits.empty() && digits.back() == '0') digits.pop_back();
  return digits.empty() ? text : text + "." + digits;
}

/// "0.5" -> 500; nothing for any other text than whole digits, a point and three digits at most.
std::optional<int> thousandths(std::string_view text) {
  const size_t point = std::min(text.find('.'), text.size());
  std::string digits(text.substr(0, point));
  const std::string_view after = text.substr(std::min(text.size(), point + 1));
  if (digits.empty() || after.size() > 3 || (point < text.size() && after.empty())) return std::nullopt;
  digits += after;
  digits.append(3 - after.size(), '0');
  int value = -1;
  const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (digits[0] == '-' || fault != std::errc{} || end != digits.data() + digits.size()) return std::nullopt;
  return value;
}

std::string accepted_endings(const SearchRow& row) {
  std::string text;
  for (const Choice& choice : choices(row)) {
    text += std::string(choice.name) + "=N (" + std::to_string(choice.low) + " to " +
            std::to_string(choice.high) + "), ";
  }
  if (!is_printed(row.search.kind)) return text + "bilinear";
  text += "delta=TEXELS (0 to " + thousandths_text(kMostDelta) + ", three places at most)";
  for (const Flag& flag : flags(row)) text += ", " + std::string(flag.name);
  return text;
}

/// Reads one text; every fault names it.
class SearchReader {
 public:
  explicit SearchReader(std::string_view text)
      : text_(text), words_(split(text, ':')), row_(find_search(words_[0])) {
    if (row_ == nullptr) throw usage_error("There is no search `" + printable(text) + "`.");
    search_ = row_->search;
  }

  Search read() {
    for (size_t k = 1; k < words_.size(); ++k) {
      const std::string_view name = words_[k].substr(0, words_[k].find('='));
      for (size_t earlier = 1; earlier < k; ++earlier) {
        if (words_[earlier].substr(0, words_[earlier].find('=')) == name)
          throw usage_error(found() + "`" + printable(name) + "` is given twice; accepted is once.");
      }
      if (!read_flag(words_[k], name) && !read_number(words_[k], name)) refuse(words_[k], name);
    }
    if (search_.least_steps > search_.steps) {
      throw usage_error(found() + "least=" + std::to_string(search_.least_steps) + " is above steps=" +
                        std::to_string(search_.steps) + "; accepted is at most as many.");
    }
    return search_;
  }

 private:
  std::string found() const { return "Search `" + printable(text_) + "`: "; }

  /// False: no flag has that name.
  bool read_flag(std::string_view word, std::string_view name) {
    const bool bilinear = name == kBilinear && !is_printed(search_.kind);
    const std::vector<Flag> all = flags(*row_);
    const auto flag = std::ranges::find(all, name, &Flag::name);
    if (!bilinear && flag == all.end()) return false;
    if (word != name) {
      throw usage_error(found() + "`" + printable(word) + "` has a value, which `" + std::string(name) +
                        "` does not take; accepted is `" + std::string(name) + "` alone.");
    }
    if (bilinear)
      search_.filter = SearchFilter::kBilinear;
    else
      search_.*(flag->member) = true;
    return true;
  }

  /// False: no number has that name.
  bool read_number(std::string_view word, std::string_view name) {
    const std::string_view digits = word.substr(std::min(word.size(), name.size() + 1));
    if (is_printed(search_.kind) && name == kDelta) {
      const std::optional<int> delta = thousandths(digits);
      if (!delta || *delta > kMostDelta) {
        refuse_value(word, name,
                     "a number of texels from 0 to " + thousandths_text(kMostDelta) +
                         " with a decimal point and three places at most, as in delta=0.5");
      }
      search_.delta = *delta;
      return true;
    }
    const std::vector<Choice> all = choices(*row_);
    const auto choice = std::ranges::find(all, name, &Choice::name);
    if (choice == all.end()) return false;
    int value = -1;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (fault != std::errc{} || end != digits.data() + digits.size() || value < choice->low ||
        value > choice->high) {
      refuse_value(word, name,
                   "a whole number from " + std::to_string(choice->low) + " to " +
                       std::to_string(choice->high) + ", as in " + std::string(name) + "=" +
                       std::to_string(std::max(choice->low, row_->search.*choice->member)));
    }
    search_.*choice->member = value;
    return true;
  }

  [[noreturn]] void refuse_value(std::string_view word, std::string_view name,
                                 const std::string& accepted) const {
    const std::string value =
        word == name ? "` has no value" : "` is `" + printable(word.substr(name.size() + 1)) + "`";
    throw usage_error(found() + "`" + std::string(name) + value + "; accepted is " + accepted + ".");
  }

  [[noreturn]] void refuse(std::string_view word, std::string_view name) const {
    std::vector<std::string_view> names;
    for (const Choice& choice : choices(*row_)) names.push_back(choice.name);
    for (const Flag& flag : flags(*row_)) names.push_back(flag.name);
    names.push_back(is_printed(search_.kind) ? kDelta : kBilinear);
    const std::string near = did_you_mean(name, names);
    throw usage_error(found() + "`" + printable(word) + "` is not an ending of " + std::string(row_->id) +
                      "; accepted are " + accepted_endings(*row_) + (near.empty() ? "." : near));
  }

  static constexpr std::string_view kBilinear = "bilinear", kDelta = "delta";
  std::string_view text_;
  std::vector<std::string_view> words_;
  const SearchRow* row_;
  Search search_;
};

}  // namespace

std::span<const SearchRow> search_rows() { return kRows; }

const SearchRow& row_of(const Search& search) { return kRows[static_cast<size_t>(search.kind)]; }

const SearchRow* find_search(std::string_view id) {
  for (const SearchRow& row : kRows) {
    if (row.id == id) return &row;
  }
  return nullptr;
}

std::string name_of(const Search& search) {
  const SearchRow& row = row_of(search);
  std::string name(row.id);
  for (const Choice& choice : choices(row)) {
    const int value = search.*choice.member;
    if (value != row.search.*choice.member)
      name += ":" + std::string(choice.name) + "=" + std::to_string(value);
  }
  if (search.filter == SearchFilter::kBilinear) name += ":bilinear";
  if (search.delta != row.search.delta) name += ":delta=" + thousandths_text(search.delta);
  for (const Flag& flag : flags(row)) {
    if (search.*flag.member) name += ":" + std::string(flag.name);
  }
  return name;
}

Search parse_search(std::string_view text) { return SearchReader(text).read(); }

}  // namespace cuesta
