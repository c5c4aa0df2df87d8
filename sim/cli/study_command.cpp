#include <chrono>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "models/common/words.h"
#include "reports/result_folder.h"
#include "reports/result_json.h"
#include "reports/study/study_readme.h"
#include "sim/cli/options.h"
#include "sim/cli/progress.h"
#include "sim/cli/standard_output.h"
#include "sim/cli/verbs.h"
#include "sim/explore/study/study_runner.h"
#include "sim/session/manifest.h"

namespace cuesta {
namespace {

/// Regenerates a published study: data, page and the note beside them. Time, host and versions are in the manifest
/// alone, so that everything else has the same bytes each time.
class StudyCommand : public Command {
 public:
  void declare(Options& options) override {
    options.add("name", name_, "Which study: " + names_of_studies([](const Study&) { return true; }))
        .required();
    options.add("-o,--output", folder_,
                "Folder; default: reports/published/NAME, with --quick results/NAME-quick");
    options.add("--resume", resume_,
                "Take finished cases over from the data.json of an earlier, stopped one");
    options.add_flag("--force,--overwrite", force_, "Replace an older folder of that name");
    options.add_flag("--quick", quick_, "A small part of the matrix: seconds instead of minutes");
    options.add_flag("--times", times_,
                     "Measure wall times on this host too, after the cases: times.json, and on the page");
    options.add("--workers", workers_, "Threads, 1 to 64; the data do not depend on it").with_default();
  }

  ExitCode run(const Session& session) override {
    const auto start = std::chrono::steady_clock::now();
    const Study& study = find_study(name_);
    if (folder_.empty()) folder_ = quick_ ? "results/" + name_ + "-quick" : "reports/published/" + name_;
    if (times_ && study.times == nullptr) {
      throw usage_error("Study " + name_ + " measures no wall times; --times is accepted with " +
                        names_of_studies([](const Study& one) { return one.times != nullptr; }) + ".");
    }
    Result manifest = begin_result("study", session.command_line);
    manifest.manifest.seeds.emplace_back("maps", "1");
    ResultFolder folder = ResultFolder::create(folder_, force_);
    StudyData data = measured(study, session);
    if (data.cases.empty()) {
      throw Error(ExitCode::kIncomplete, "Stopped before the first case was finished; nothing is kept.");
    }

    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    char wall[32];
    std::snprintf(wall, sizeof wall, "%.1f", seconds.count());
    manifest.manifest.environment.emplace_back("wall_seconds", wall);
    manifest.manifest.environment.emplace_back("workers", std::to_string(workers_));
    if (study.pictures != nullptr) data.pictures = study.pictures(quick_);
    for (const StudyPicture& picture : data.pictures)
      folder.write("pictures/" + picture.name + ".png", picture.png);
    const std::string headline = study.headline(data);
    folder.write("data.json", study_json(data));
    folder.write("data.csv", study_csv(data));
    if (times_) {
      ProgressBar bar(session, "wall times", "runs", 0);
      const StudyTimes times =
          study.times(quick_, [&](uint64_t finished, uint64_t) { return bar.update(finished); });
      folder.write("times.json", times_json(times));
      folder.write("report.html", study.timed_page(data, times));
    } else {
      folder.write("report.html", study.page(data));
    }
    folder.write("README.md", study_readme(data, headline, times_));
    folder.write("manifest.json", manifest_json(manifest));
    folder.commit(!data.partial());

    std::printf("%s\nReport: %s\n", headline.c_str(), (folder.final_path() / "report.html").c_str());
    flush_standard_output();
    if (!data.partial()) return ExitCode::kOk;
    std::fprintf(stderr, "cuesta: stopped; %zu of %llu cases are finished and kept.\n", data.cases.size(),
                 static_cast<unsigned long long>(data.planned));
    return ExitCode::kIncomplete;
  }

 private:
  static std::string names_of_studies(bool (*wanted)(const Study& study)) {
    std::vector<std::string_view> names;
    for (const Study& study : studies()) {
      if (wanted(study)) names.push_back(study.name);
    }
    return joined(names);
  }

  StudyData measured(const Study& study, const Session& session) const {
    const uint64_t all = planned_places(study, study.plan(quick_)).size();
    ProgressBar bar(session, name_, "cases", all);
    const auto progress = [&](uint64_t finished, uint64_t) { return bar.update(finished); };
    if (resume_.empty()) return run_study(study, quick_, workers_, progress);
    const StudyData earlier = parse_study_json(whole_file(resume_), resume_);
    return run_study(study, quick_, workers_, progress, &earlier);
  }

  static std::string whole_file(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file || std::filesystem::is_directory(path))
      throw input_error(path + " cannot be read; accepted is the data.json of a study.");
    return {std::istreambuf_iterator<char>(file), {}};
  }

  std::string name_, folder_, resume_;
  bool force_ = false, quick_ = false, times_ = false;
  int workers_ = 2;
};

}  // namespace

std::unique_ptr<Command> make_study_command() { return make_command<StudyCommand>(); }

}  // namespace cuesta
