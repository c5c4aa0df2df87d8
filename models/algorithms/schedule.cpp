#include "models/algorithms/schedule.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <vector>

#include "models/common/error.h"
#include "models/common/words.h"

namespace cuesta {

namespace {

constexpr const char* kYun = "Yun, Kwon, Nah, Manocha, Park 2013";

/// Published algorithms first, then parts.
const std::vector<Algorithm>& rows() {
  using Up = UpRule;
  using enum StartRule;
  using enum AlgorithmKind;
  static const std::vector<Algorithm> all = {
      {"dda",
       {kLeaf, 1, Up::kNever},
       kPublished,
       "Amanatides & Woo 1987, in closed form",
       "the plain walk from leaf to leaf, without the pyramid: baseline and oracle"},
      {"oh2006",
       {kRoot, 1, Up::kNever},
       kPublished,
       "Oh, Ki, Lee 2006; Ki & Oh 2007",
       "pyramidal displacement mapping: from the root, a crossing stays on its level"},
      {"drobot2009",
       {kRoot, 1, Up::kAlways},
       kPublished,
       "Drobot 2009",
       "quadtree displacement mapping: up one level after every crossing"},
      {"drobot2009-interval",
       {kRoot, 1, Up::kInterval},
       kPublished,
       "Drobot 2009",
       "quadtree displacement mapping: up after crossings on even levels only"},
      {"tevs2008",
       {kRoot, 1, Up::kEvenAxis},
       kPublished,
       "Tevs, Ihrke, Seidel 2008",
       "maximum mipmaps: up when the crossed axis has an even new index"},
      {"tevs2008-both-even",
       {kRoot, 1, Up::kBothEven},
       kPublished,
       "Tevs, Ihrke, Seidel 2008",
       "maximum mipmaps: up when both new indices are even, as public re-implementations do"},
      {"yun2013",
       {kSpan, 2, Up::kSelectiveEven},
       kPublished,
       kYun,
       "start-level decision, multi-level down, selective level-up: the hardware's choice"},
      {"yun2013-coherent",
       {kSpan, 2, Up::kCoherent},
       kPublished,
       kYun,
       "start-level decision, multi-level down, coherent level-up: the variant for programmable GPUs"},

      {"yun2013-start",
       {kSpan, 1, Up::kNever},
       kPart,
       kYun,
       "oh2006 with the start-level decision: from the smallest node that holds the ray's start and end"},
      {"yun2013-down",
       {kRoot, 2, Up::kNever},
       kPart,
       kYun,
       "oh2006 with multi-level down: two levels per descent until the first crossing"},
      {"yun2013-up",
       {kRoot, 1, Up::kSelectiveEven},
       kPart,
       kYun,
       "oh2006 with selective level-up: up when the neighbour would be skipped and the crossed axis is even"},
      {"yun2013-up-selective",
       {kRoot, 1, Up::kSelective},
       kPart,
       kYun,
       "oh2006 with selective level-up without the test of even indices: up when the neighbour would be "
       "skipped"},
      {"yun2013-coherent-up",
       {kRoot, 1, Up::kCoherent},
       kPart,
       kYun,
       "oh2006 with coherent level-up: up when two crossings in a row happen on one level"},
  };
  return all;
}

Algorithm algorithm_of(const Search& search) {
  const SearchRow& row = row_of(search);
  return {name_of(search),          {},    AlgorithmKind::kSearch, std::string(row.source),
          std::string(row.meaning), search};
}

const std::vector<Algorithm>& search_algorithms() {
  static const std::vector<Algorithm> all = [] {
    std::vector<Algorithm> list;
    for (const SearchRow& row : search_rows()) list.push_back(algorithm_of(row.search));
    return list;
  }();
  return all;
}

size_t published_rows() {
  static const auto count =
      static_cast<size_t>(std::count_if(rows().begin(), rows().end(), [](const Algorithm& row) {
        return row.kind == AlgorithmKind::kPublished;
      }));
  return count;
}

/// The row that makes the same three choices; nullptr when there is none.
const Algorithm* row_of(const Schedule& schedule) {
  for (const Algorithm& row : rows()) {
    if (row.schedule.start == schedule.start && row.schedule.down == schedule.down &&
        row.schedule.up == schedule.up) {
      return &row;
    }
  }
  return nullptr;
}

/// Reads one text; every fault names it.
class ScheduleReader {
 public:
  explicit ScheduleReader(std::string_view text) : text_(text), words_(split(text, ':')) {}

  Schedule read() {
    Schedule schedule;
    size_t next = 1;
    if (const Algorithm* named = find_algorithm(words_[0])) {
      schedule = named->schedule;
    } else if (words_.size() == 1) {
      const std::vector<std::string_view> ids = named_and({});
      throw usage_error("There is no algorithm `" + printable(text_) + "`; accepted are " + joined(ids) +
                        ", or a schedule START:DOWN:UP such as span:2:selective-even" +
                        ending(words_[0], ids));
    } else {
      schedule.start = static_cast<StartRule>(
          choice(words_[0], kStartNames, "a start (or a named algorithm)", named_and(kStartNames)));
      if (words_.size() < 3) {
        throw usage_error(found() + "it has no up rule; accepted is " + std::string(kScheduleSyntax) + ".");
      }
      schedule.down = kDownValues[choice(words_[1], kDownNames, "a down")];
      schedule.up = static_cast<UpRule>(choice(words_[2], kUpNames, "an up rule"));
      next = 3;
    }
    bool with_stop = false, with_fetch = false;
    for (; next < words_.size(); ++next) {
      const std::string_view word = words_[next];
      if (word.starts_with("stop=")) {
        once(with_stop, "the stop level");
        schedule.stop_level = stop_level(word.substr(5));
      } else {
        const size_t fetch = choice(word, kEndings, "an ending");
        if (fetch == kStopEnding) {
          throw usage_error(found() + "`stop` has no level; accepted is stop=N, N from 0 to " +
                            std::to_string(kMostStopLevel) + ".");
        }
        once(with_fetch, "what is fetched");
        schedule.fetch = static_cast<FetchRule>(fetch);
      }
    }
    return schedule;
  }

 private:
  static constexpr std::string_view kEndings[] = {"texel", "quad", "stop=N"};  // the first two: FetchRule
  static constexpr size_t kStopEnding = 2;

  /// Every algorithm's name, and these.
  static std::vector<std::string_view> named_and(std::span<const std::string_view> others) {
    std::vector<std::string_view> ids;
    for (const Algorithm& row : rows()) ids.push_back(row.id);
    for (const SearchRow& row : search_rows()) ids.push_back(row.id);
    ids.insert(ids.end(), others.begin(), others.end());
    return ids;
  }

  static std::string ending(std::string_view word, std::span<const std::string_view> names) {
    const std::string near = did_you_mean(word, names);
    return near.empty() ? "." : near;
  }

  std::string found() const { return "Schedule `" + printable(text_) + "`: "; }

  /// `near`: names that may be meant; empty: `names`.
  size_t choice(std::string_view word, std::span<const std::string_view> names, const char* what,
                std::span<const std::string_view> near = {}) const {
    const auto at = std::find(names.begin(), names.end(), word);
    if (at != names.end()) return static_cast<size_t>(at - names.begin());
    throw usage_error(found() + "`" + printable(word) + "` is not " + what + "; accepted are " +
                      joined(names) + ending(word, near.empty() ? names : near));
  }

  int stop_level(std::string_view digits) const {
    int level = -1;
    const auto [end, fault] = std::from_chars(digits.data(), digits.data() + digits.size(), level);
    if (fault != std::errc{} || end != digits.data() + digits.size() || level < 0 || level > kMostStopLevel) {
      throw usage_error(found() + "stop level `" + printable(digits) +
                        "`; accepted is a whole number from 0 to " + std::to_string(kMostStopLevel) + ".");
    }
    return level;
  }

  void once(bool& given, const char* what) const {
    if (given) throw usage_error(found() + what + " is given twice; accepted is once.");
    given = true;
  }

  std::string_view text_;
  std::vector<std::string_view> words_;
};

}  // namespace

std::span<const Algorithm> algorithms() { return std::span(rows()).first(published_rows()); }
std::span<const Algorithm> algorithm_parts() { return std::span(rows()).subspan(published_rows()); }

std::span<const Algorithm> searches() {
  const std::span<const Algorithm> all = search_algorithms();
  return all.first(static_cast<size_t>(SearchKind::kKi2007Printed));
}
std::span<const Algorithm> printed_searches() {
  const std::span<const Algorithm> all = search_algorithms();
  return all.subspan(static_cast<size_t>(SearchKind::kKi2007Printed));
}

const Algorithm* find_algorithm(std::string_view id) {
  for (const std::vector<Algorithm>* list : {&rows(), &search_algorithms()}) {
    for (const Algorithm& row : *list) {
      if (row.id == id) return &row;
    }
  }
  return nullptr;
}

std::string name_of(const Schedule& schedule) {
  const Algorithm* row = row_of(schedule);
  std::string name;
  if (row != nullptr) {
    name = row->id;
  } else {
    name = std::string(name_of(schedule.start)) + ":" + std::string(name_of_down(schedule.down)) + ":" +
           std::string(name_of(schedule.up));
  }
  if (schedule.stop_level > 0) name += ":stop=" + std::to_string(schedule.stop_level);
  if (schedule.fetch == FetchRule::kQuad) name += ":quad";
  return name;
}

Algorithm parse_algorithm(std::string_view text) {
  if (find_search(text.substr(0, text.find(':'))) != nullptr) return algorithm_of(parse_search(text));
  Schedule schedule = ScheduleReader(text).read();
  if (schedule.start == StartRule::kLeaf)
    schedule.down = 1;  // a descent before the first crossing never happens
  const std::string id = name_of(schedule);
  if (const Algorithm* named = find_algorithm(id)) return *named;
  const Algorithm* row = row_of(schedule);
  return {id, schedule, AlgorithmKind::kComposed, row != nullptr ? row->source : "composed",
          row != nullptr ? row->meaning : "the choices that its name states"};
}

std::string_view name_of(StartRule rule) { return kStartNames[static_cast<size_t>(rule)]; }
std::string_view name_of(UpRule rule) { return kUpNames[static_cast<size_t>(rule)]; }
std::string_view name_of(FetchRule rule) { return kFetchNames[static_cast<size_t>(rule)]; }
std::string_view name_of_down(int down) { return down == kDownCommon ? kDownNames[3] : kDownNames[down - 1]; }

}  // namespace cuesta
