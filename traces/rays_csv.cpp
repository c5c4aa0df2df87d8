#include "traces/rays_csv.h"

#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <new>

#include "models/common/error.h"
#include "models/files/strict_toml.h"
#include "traces/rays_csv_columns.h"

namespace cuesta {
namespace {

constexpr std::string_view kTitle = "# cuesta rays 1, width ";
constexpr std::string_view kTitleMiddle = ", height ";
constexpr uint64_t kRowsBetweenWatches = 4096;

/// A file's name until it is whole; what still has it at the end goes.
struct TemporaryName {
  explicit TemporaryName(const std::string& path) : name(path + ".partial-" + std::to_string(getpid())) {}
  ~TemporaryName() { std::remove(name.c_str()); }
  TemporaryName(const TemporaryName&) = delete;
  TemporaryName& operator=(const TemporaryName&) = delete;
  const std::string name;
};

class CsvReader {
 public:
  explicit CsvReader(const std::string& path) : path_(path), file_(path, std::ios::binary) {
    if (!std::filesystem::is_regular_file(path)) {
      throw input_error("Cannot read the ray trace " + path + ": there is no such file.");
    }
    if (!file_) throw input_error("Cannot read the ray trace " + path + ": the file cannot be opened.");
  }

  RayTrace read(const RayWatch& watch) {
    RayTrace trace;
    read_title(trace);
    read_column_names();
    std::vector<uint64_t> ids;
    while (next_line()) {
      trace.rays.push_back(read_ray());
      const std::string fault = fault_of(trace.rays.back(), trace.width, trace.height);
      if (!fault.empty()) fail("this ray is damaged: " + fault);
      ids.push_back(trace.rays.back().id);
      if (ids.size() % kRowsBetweenWatches == 0) keep_watch(watch, ids.size());
    }
    require_distinct_ids(std::move(ids), "Cannot read the ray trace " + path_);
    return trace;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const {
    throw input_error(path_ + ":" + std::to_string(line_number_) + ": " + what + ".");
  }

  [[noreturn]] void fail_in_column(size_t index, const std::string& what) const {
    fail("column " + std::to_string(index + 1) + " (" + std::string(columns_[index]->name) + ") " + what);
  }

  bool next_line() {
    ++line_number_;
    if (!std::getline(file_, line_)) return false;
    if (!line_.empty() && line_.back() == '\r') line_.pop_back();
    return true;
  }

  void read_title(RayTrace& trace) {
    uint64_t width = 0, height = 0;
    if (!next_line() || !read_title_numbers(width, height)) {
      fail("found `" + printable(line_) +
           "`, and the first line must read `# cuesta rays 1, width W, height H`");
    }
    const std::string fault = fault_of_grid(width, height);
    if (!fault.empty()) fail("it states " + fault);
    trace.width = static_cast<int>(width);
    trace.height = static_cast<int>(height);
  }

  bool read_title_numbers(uint64_t& width, uint64_t& height) const {
    if (!line_.starts_with(kTitle)) return false;
    const char* end = line_.data() + line_.size();
    const auto first = std::from_chars(line_.data() + kTitle.size(), end, width);
    const std::string_view rest(first.ptr, static_cast<size_t>(end - first.ptr));
    if (first.ec != std::errc() || !rest.starts_with(kTitleMiddle)) return false;
    const auto second = std::from_chars(first.ptr + kTitleMiddle.size(), end, height);
    return second.ec == std::errc() && second.ptr == end;
  }

  /// Calls use(index, text) for each field of the line; returns their number.
  template <typename Use>
  size_t split(const Use& use) const {
    std::string_view rest = line_;
    for (size_t index = 0;; ++index) {
      const size_t comma = rest.find(',');
      use(index, rest.substr(0, comma));
      if (comma == std::string_view::npos) return index + 1;
      rest.remove_prefix(comma + 1);
    }
  }

  void read_column_names() {
    if (!next_line()) fail("the file ends where the names of the columns are expected");
    std::vector<std::string_view> names;
    for (const RayColumn& column : ray_columns()) names.push_back(column.name);
    split([&](size_t index, std::string_view text) {
      const auto found = std::find(names.begin(), names.end(), text);
      if (found == names.end()) {
        fail("column " + std::to_string(index + 1) + " is named `" + printable(text) +
             "`; accepted names: " + joined(names) + did_you_mean(text, names));
      }
      const RayColumn* column = &ray_columns()[static_cast<size_t>(found - names.begin())];
      if (std::find(columns_.begin(), columns_.end(), column) != columns_.end()) {
        fail("column " + std::to_string(index + 1) + " is the second one named " + std::string(text));
      }
      columns_.push_back(column);
    });
    for (const RayColumn& column : ray_columns()) {
      if (column.required && std::find(columns_.begin(), columns_.end(), &column) == columns_.end()) {
        fail("there is no column " + std::string(column.name) + ", which every trace needs");
      }
    }
  }

  TracedRay read_ray() const {
    TracedRay ray;
    const size_t fields = split([&](size_t index, std::string_view text) {
      if (index >= columns_.size() || columns_[index]->parse(text, ray)) return;
      fail_in_column(index,
                     "holds `" + printable(text) + "`; accepted: " + std::string(columns_[index]->accepted));
    });
    if (fields != columns_.size()) {
      fail("the line has " + std::to_string(fields) + " fields, and line 2 names " +
           std::to_string(columns_.size()) + " columns");
    }
    return ray;
  }

  std::string path_;
  std::ifstream file_;
  std::string line_;
  uint64_t line_number_ = 0;
  std::vector<const RayColumn*> columns_;
};

}  // namespace

RayTrace read_rays_csv(const std::string& path, const RayWatch& watch) {
  try {
    return CsvReader(path).read(watch);
  } catch (const std::bad_alloc&) {
    throw Error(ExitCode::kResource, "Cannot read the ray trace " + path + ": memory does not suffice.");
  } catch (const std::filesystem::filesystem_error& error) {
    throw input_error("Cannot read the ray trace " + path + ": " + error.code().message() + ".");
  }
}

void write_rays_csv(const std::string& path, const RayTrace& trace, const RayWatch& watch) {
  const std::string grid_fault =
      fault_of_grid(static_cast<uint64_t>(trace.width), static_cast<uint64_t>(trace.height));
  if (!grid_fault.empty()) throw input_error("Cannot write " + path + ": " + grid_fault + ".");
  for (const TracedRay& ray : trace.rays) {
    const std::string fault = fault_of(ray, trace.width, trace.height);
    if (!fault.empty()) {
      throw input_error("Cannot write " + path + ": the ray with id " + std::to_string(ray.id) +
                        " is damaged: " + fault + ".");
    }
  }
  const TemporaryName temporary(path);
  std::ofstream file(temporary.name, std::ios::binary | std::ios::trunc);
  std::string text = std::string(kTitle) + std::to_string(trace.width) + std::string(kTitleMiddle) +
                     std::to_string(trace.height) + "\n";
  const char* separator = "";
  for (const RayColumn& column : ray_columns()) {
    text.append(separator).append(column.name);
    separator = ",";
  }
  text += '\n';
  for (const TracedRay& ray : trace.rays) {
    for (const RayColumn& column : ray_columns()) {
      column.append(ray, text);
      text += ',';
    }
    text.back() = '\n';
    if (text.size() < 1 << 16) continue;
    keep_watch(watch, static_cast<uint64_t>(&ray - trace.rays.data()));
    file << text;
    text.clear();
  }
  file << text;
  file.close();
  if (!file || std::rename(temporary.name.c_str(), path.c_str()) != 0) {
    throw Error(ExitCode::kResource, "Cannot write " + path +
                                         ": the file could not be created and completed; is "
                                         "the folder there and writable, the disk full?");
  }
}

}  // namespace cuesta
