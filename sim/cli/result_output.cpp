#include "sim/cli/result_output.h"

#include <cstdio>

#include "models/files/image_codec.h"
#include "reports/result_json.h"
#include "reports/table.h"
#include "sim/cli/standard_output.h"

namespace cuesta {

ResultFolder open_folder(const RunOptions& options, const std::string& stem) {
  image_codec();
  return open_result_folder(options.folder, stem, options.force);
}

ExitCode print_result(const Result& result, const Completion& done, const ResultFolder& folder, bool json) {
  std::fputs((json ? result_json(result) : print_table(result)).c_str(), stdout);
  const std::filesystem::path report = folder.final_path() / "report.html";
  std::fprintf(json ? stderr : stdout, "Report: %s\n", report.c_str());
  flush_standard_output();
  if (done.complete()) return ExitCode::kOk;
  std::fprintf(stderr, "cuesta: stopped; %zu of %zu runs are whole, the rest is partial or missing.\n",
               done.whole, done.planned);
  return ExitCode::kIncomplete;
}

}  // namespace cuesta
