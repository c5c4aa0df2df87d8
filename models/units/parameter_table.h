#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <type_traits>

namespace cuesta {

/// What a run must compute for a parameter to matter to it.
enum class ParameterUse : uint8_t { kHits, kTime };

/// A parameter as one statement, of the parameter struct `Section`. Beside each unit a table of these is what files,
/// `--set`, the resolved configuration, `cuesta list parameters` and the documentation are made from
/// (sim/config/parameters.h).
template <class Section>
struct ParameterRow {
  std::string_view path;                    ///< "height_l1.ways": section and key of an architecture file
  int64_t low, high;                        ///< accepted, both ends included; for a name: index into `names`
  std::span<const std::string_view> names;  ///< empty for a number
  bool power_of_two;                        ///< 0 is accepted beside them where the range holds it
  ParameterUse use;
  std::string_view unit;     ///< "cycles", "bytes" ...; empty for a name or a plain number
  std::string_view meaning;  ///< one sentence
  std::string_view source;   ///< where range and default come from; "ours": our choice
  int64_t (*get)(const Section&);
  void (*set)(Section&, int64_t);
  std::string_view inert =
      {};  ///< why it changes no count, histogram or digest; empty: in some setting it does
};

// What the tables of rows are written with, and where they stand.
namespace parameter {

inline constexpr auto kHits = ParameterUse::kHits;
inline constexpr auto kTime = ParameterUse::kTime;
inline constexpr std::string_view kOurs = "ours";

/// A member of a parameter struct, read and written as a whole number.
template <auto Member>
struct BoundMember;
template <class Section, class Value, Value Section::*Member>
struct BoundMember<Member> {
  using Of = Section;
  static int64_t get(const Section& section) { return static_cast<int64_t>(section.*Member); }
  static void set(Section& section, int64_t value) { section.*Member = static_cast<Value>(value); }
};

template <auto Member>
constexpr ParameterRow<typename BoundMember<Member>::Of> number(std::string_view path, int64_t low,
                                                                int64_t high, ParameterUse use,
                                                                std::string_view unit,
                                                                std::string_view meaning,
                                                                std::string_view source) {
  using B = BoundMember<Member>;
  return {path, low, high, {}, false, use, unit, meaning, source, B::get, B::set};
}

template <auto Member>
constexpr ParameterRow<typename BoundMember<Member>::Of> power(std::string_view path, int64_t low,
                                                               int64_t high, std::string_view unit,
                                                               std::string_view meaning,
                                                               std::string_view source) {
  using B = BoundMember<Member>;
  return {path, low, high, {}, true, kTime, unit, meaning, source, B::get, B::set};
}

template <auto Member>
constexpr ParameterRow<typename BoundMember<Member>::Of> name(std::string_view path,
                                                              std::span<const std::string_view> names,
                                                              ParameterUse use, std::string_view meaning,
                                                              std::string_view source) {
  using B = BoundMember<Member>;
  return {path,   0,     static_cast<int64_t>(names.size()) - 1, names, false, use, "", meaning, source,
          B::get, B::set};
}

/// A choice that the algorithm makes where nothing is set: an optional member, whose first name stands for none.
template <auto Member, int (*ValueOf)(int)>
struct BoundChoice;
template <class Section, class Optional, Optional Section::*Member, int (*ValueOf)(int)>
struct BoundChoice<Member, ValueOf> {
  using Of = Section;
  using Value = typename Optional::value_type;
  static int64_t get(const Section& section) {
    const Optional& value = section.*Member;
    int index = 0;
    while (value && static_cast<Value>(ValueOf(index)) != *value) ++index;
    return value ? index + 1 : 0;
  }
  static void set(Section& section, int64_t index) {
    Optional& value = section.*Member;
    value.reset();
    if (index > 0) value = static_cast<Value>(ValueOf(static_cast<int>(index) - 1));
  }
};

constexpr int same_value(int index) { return index; }

template <auto Member, int (*ValueOf)(int) = same_value>
constexpr ParameterRow<typename BoundChoice<Member, ValueOf>::Of> choice(
    std::string_view path, std::span<const std::string_view> names, std::string_view meaning) {
  using C = BoundChoice<Member, ValueOf>;
  return {path,   0,     static_cast<int64_t>(names.size()) - 1, names, false, kHits, "", meaning, kOurs,
          C::get, C::set};
}

template <class Section>
constexpr ParameterRow<Section> inert(ParameterRow<Section> row, std::string_view reason) {
  row.inert = reason;
  return row;
}

/// The names of an enumeration with "algorithm" before them: what the algorithm itself has.
template <size_t N>
constexpr std::array<std::string_view, N + 1> with_algorithm_first(const std::string_view (&names)[N]) {
  std::array<std::string_view, N + 1> all{"algorithm"};
  for (size_t k = 0; k < N; ++k) all[k + 1] = names[k];
  return all;
}

}  // namespace parameter

}  // namespace cuesta
