#include "models/traversal/schedule.h"

#include <array>

namespace cuesta {

namespace {

constexpr std::array<Algorithm, 8> kAlgorithms = {{
    {"dda",
     {StartRule::kLeaf, 1, UpRule::kNever, 0},
     "Amanatides & Woo 1987, in closed form",
     "the plain walk from leaf to leaf, without the pyramid: baseline and oracle"},
    {"oh2006",
     {StartRule::kRoot, 1, UpRule::kNever, 0},
     "Oh, Ki, Lee 2006; Ki & Oh 2007",
     "pyramidal displacement mapping: from the root, a crossing stays on its level"},
    {"drobot2009",
     {StartRule::kRoot, 1, UpRule::kAlways, 0},
     "Drobot 2009",
     "quadtree displacement mapping: up one level after every crossing"},
    {"drobot2009-interval",
     {StartRule::kRoot, 1, UpRule::kInterval, 0},
     "Drobot 2009",
     "quadtree displacement mapping: up after crossings on even levels only"},
    {"tevs2008",
     {StartRule::kRoot, 1, UpRule::kEvenAxis, 0},
     "Tevs, Ihrke, Seidel 2008",
     "maximum mipmaps: up when the crossed axis has an even new index"},
    {"tevs2008-both-even",
     {StartRule::kRoot, 1, UpRule::kBothEven, 0},
     "Tevs, Ihrke, Seidel 2008",
     "maximum mipmaps: up when both new indices are even, as public re-implementations do"},
    {"yun2013",
     {StartRule::kSpan, 2, UpRule::kSelectiveEven, 0},
     "Yun, Kwon, Nah, Manocha, Park 2013",
     "start-level decision, multi-level down, selective level-up: the hardware's choice"},
    {"yun2013-coherent",
     {StartRule::kSpan, 2, UpRule::kCoherent, 0},
     "Yun, Kwon, Nah, Manocha, Park 2013",
     "start-level decision, multi-level down, coherent level-up: the variant for programmable GPUs"},
}};

}  // namespace

std::span<const Algorithm> algorithms() { return kAlgorithms; }

const Algorithm* find_algorithm(std::string_view id) {
  for (const Algorithm& algorithm : kAlgorithms) {
    if (algorithm.id == id) return &algorithm;
  }
  return nullptr;
}

std::string_view name_of(StartRule rule) {
  switch (rule) {
    case StartRule::kRoot:
      return "root";
    case StartRule::kLeaf:
      return "leaf";
    case StartRule::kSpan:
      return "span";
  }
  return "?";
}

std::string_view name_of(UpRule rule) {
  switch (rule) {
    case UpRule::kNever:
      return "never";
    case UpRule::kAlways:
      return "always";
    case UpRule::kInterval:
      return "interval";
    case UpRule::kEvenAxis:
      return "even-axis";
    case UpRule::kBothEven:
      return "both-even";
    case UpRule::kSelective:
      return "selective";
    case UpRule::kSelectiveEven:
      return "selective-even";
    case UpRule::kCoherent:
      return "coherent";
  }
  return "?";
}

}  // namespace cuesta
