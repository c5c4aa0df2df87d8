#include "models/work/walker.h"

namespace cuesta {

std::unique_ptr<Walker> make_walker(const Workload& work) {
  if (work.search) return make_search_walker(work);
  if (work.map.surface == Surface::kBilinear) return make_patch_walker(work);
  return make_texel_walker(work);
}

}  // namespace cuesta
