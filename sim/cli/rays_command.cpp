#include <cstdio>
#include <filesystem>

#include "models/common/words.h"
#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/verbs.h"
#include "sim/session/output_file.h"
#include "traces/ray_files.h"
#include "traces/rays_reader.h"

namespace cuesta {
namespace {

RaySummary summary_of(const std::string& path) {
  if (!is_csv_name(path)) return check_rays(path);
  RaySummary summary = summarise(read_ray_file(path));
  summary.file_bytes = std::filesystem::file_size(path);
  return summary;
}

using Number = unsigned long long;

void print_summary(const std::string& path, const RaySummary& summary) {
  std::printf("%s\n", path.c_str());
  if (summary.chunks > 0 || !is_csv_name(path)) {
    std::printf("  format        .rays, version 1, %llu chunks\n", static_cast<Number>(summary.chunks));
  } else {
    std::printf("  format        text (CSV)\n");
  }
  std::printf("  bytes         %llu", static_cast<Number>(summary.file_bytes));
  if (summary.rays > 0) {
    std::printf(" (%.1f per ray)",
                static_cast<double>(summary.file_bytes) / static_cast<double>(summary.rays));
  }
  std::printf("\n  frame         %d x %d pixels, %llu of them with rays\n", summary.width, summary.height,
              static_cast<Number>(summary.pixels));
  std::printf("  rays          %llu\n", static_cast<Number>(summary.rays));
  for (int kind = 0; kind < 4; ++kind) {
    std::printf("    %-12s%llu\n", std::string(name_of(static_cast<RayKind>(kind))).c_str(),
                static_cast<Number>(summary.of_kind[kind]));
  }
  std::printf("  directions    %llu descending, %llu horizontal, %llu rising\n",
              static_cast<Number>(summary.descending), static_cast<Number>(summary.horizontal),
              static_cast<Number>(summary.rising));
  for (int k = 0; k < kSlopeClasses; ++k) {
    if (summary.of_slope[k] == 0) continue;
    std::printf("    slope %-14s%llu\n", std::string(name_of_slope_class(k)).c_str(),
                static_cast<Number>(summary.of_slope[k]));
  }
  for (int axis = 0; summary.rays > 0 && axis < 3; ++axis) {
    std::printf("  origin %c      %s to %s\n", "uvz"[axis], shortest_text(summary.low[axis]).c_str(),
                shortest_text(summary.high[axis]).c_str());
  }
}

class RaysInfoCommand : public Command {
 public:
  void declare(Options& options) override { options.add("file", file_, "A .rays or .csv file").required(); }
  ExitCode run(const Session&) override {
    print_summary(file_, summary_of(file_));
    return ExitCode::kOk;
  }

 private:
  std::string file_;
};

class CheckCommand : public Command {
 public:
  void declare(Options& options) override {
    options.add("file", files_, "A .rays or .csv file, or several").required();
  }
  ExitCode run(const Session& session) override {
    for (const std::string& file : files_) {
      const RaySummary summary = summary_of(file);
      if (session.quiet) continue;
      std::printf("%s: in order, %llu rays.\n", file.c_str(), static_cast<Number>(summary.rays));
    }
    return ExitCode::kOk;
  }

 private:
  std::vector<std::string> files_;
};

class ConvertCommand : public Command {
 public:
  void declare(Options& options) override {
    options.add("from", from_, "File to read: text if its name ends in .csv, else .rays").required();
    to_option_ = options.add(
        "to", to_,
        "File to write: .rays, or .csv for text; named here or with -o; exactly one of them is needed");
    output_option_ = options.add("-o,--output", output_,
                                 "The file to write, in the place of the name after the first one");
    options.add_flag("--force", force_, "Replace a file of that name");
  }
  ExitCode run(const Session& session) override {
    const bool by_place = to_option_.count() > 0, by_name = output_option_.count() > 0;
    if (by_place && by_name) {
      throw usage_error("Two files to write are given, " + printable(to_, 200) + " and -o " +
                        printable(output_, 200) + "; accepted is one of the two.");
    }
    if (!by_place && !by_name) {
      throw usage_error(
          "No file to write is given; accepted is its name after that of the file to read, or -o NAME.");
    }
    if (by_name) to_ = output_;
    check_ray_file_name(to_);
    refuse_existing(to_, force_);
    const RayTrace trace = read_ray_file(from_, watched(session, "reading", 0));
    write_ray_file(to_, trace, watched(session, "writing", trace.rays.size()));
    if (!session.quiet) std::fprintf(stderr, "%s: %zu rays.\n", to_.c_str(), trace.rays.size());
    return ExitCode::kOk;
  }

 private:
  std::string from_, to_, output_;
  Option to_option_, output_option_;
  bool force_ = false;
};

}  // namespace

std::unique_ptr<Command> make_rays_info_command() { return make_command<RaysInfoCommand>(); }
std::unique_ptr<Command> make_rays_check_command() { return make_command<CheckCommand>(); }
std::unique_ptr<Command> make_rays_convert_command() { return make_command<ConvertCommand>(); }

}  // namespace cuesta
