#include "sim/cli/command_line.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "models/common/build_info.h"
#include "models/common/words.h"
#include "sim/cli/options.h"
#include "sim/cli/standard_output.h"
#include "sim/cli/verbs.h"

namespace cuesta {
namespace {

constexpr const char* kExitCodes =
    "Exit codes: 0 ok, 1 internal error, 2 usage or configuration, 3 input data, 4 no forward progress,\n"
    "5 verification mismatch, 6 resource limit, 7 incomplete, 75 try again.\n";

constexpr const char* kQuiet = "No progress and no remarks";

struct Leaf {
  CLI::App* app;
  std::unique_ptr<Command> command;
};

/// `found` empty: the verb is missing.
[[noreturn]] void refuse_unknown_verb(const CLI::App& app, const std::string& found) {
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands({})) names.push_back(verb->get_name());
  const std::vector<std::string_view> views(names.begin(), names.end());
  if (found.empty()) throw usage_error("No verb is given; accepted are " + joined(views) + ".");
  const std::string near = did_you_mean(found, views);
  throw usage_error("There is no verb `" + printable(found) + "`; accepted are " + joined(views) +
                    (near.empty() ? "." : near));
}

[[noreturn]] void refuse_extra(const CLI::App& app, const std::string& verb, const std::string& found) {
  if (!found.starts_with("-")) {
    throw usage_error("`cuesta " + verb + "` does not know what to do with `" + printable(found) +
                      "`; `cuesta " + verb + " --help` says what it accepts.");
  }
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    for (const std::string& name : option->get_snames()) names.push_back("-" + name);
  }
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::string near = did_you_mean(found.substr(0, found.find('=')), views);
  throw usage_error("`cuesta " + verb + "` has no option `" + printable(found) + "`; accepted are " +
                    joined(views) + (near.empty() ? "." : near));
}

/// What no option took, but for the `--` before which options end.
std::vector<std::string> extras_of(const CLI::App& app) {
  std::vector<std::string> extras = app.remaining();
  const auto mark = std::find(extras.begin(), extras.end(), "--");
  if (mark != extras.end()) extras.erase(mark);
  return extras;
}

void check_given_once(const CLI::App& app, const std::string& verb) {
  for (const CLI::Option* option : app.get_options()) {
    const std::vector<std::string>& given = option->results();
    if (static_cast<int>(given.size()) <= std::max(option->get_items_expected_max(), 1)) continue;
    const std::vector<std::string_view> values(given.begin(), given.end());
    throw usage_error("`cuesta " + verb + "`: " + option->get_name() + " is given " +
                      std::to_string(given.size()) + " times (" + printable(joined(values), 200) +
                      "); accepted is one.");
  }
}

/// The words of the command line that are no options: the verb, perhaps misspelt. Gives what the options are of.
CLI::App& check_verb(CLI::App& program, int count, const char* const* arguments) {
  CLI::App* app = &program;
  for (int k = 1; k < count && !app->get_subcommands({}).empty(); ++k) {
    const std::string word = arguments[k];
    if (word == "-q" || word == "--quiet") continue;
    if (word.starts_with("-")) return *app;
    CLI::App* next = nullptr;
    for (CLI::App* verb : app->get_subcommands({})) {
      if (verb->get_name() == word) next = verb;
    }
    if (!next) refuse_unknown_verb(*app, word);
    app = next;
  }
  if (!app->get_subcommands({}).empty()) refuse_unknown_verb(*app, "");
  return *app;
}

/// CLI11 takes the next word for the value of `--name=`, and `=x` for that of `-o=x`.
void check_equals_signs(const CLI::App& app, int count, const char* const* arguments) {
  for (int k = 1; k < count; ++k) {
    const std::string word = arguments[k];
    if (word == "--") return;
    const size_t equals = word.find('=');
    if (!word.starts_with("-") || equals == std::string::npos) continue;
    const std::string name = word.substr(0, equals);
    const bool is_long = name.starts_with("--");
    if (!is_long && name.size() != 2) continue;
    const CLI::Option* option = app.get_option_no_throw(name);
    if (!option) continue;
    const bool flag = option->get_items_expected_max() == 0;
    if (!is_long) {
      const std::string value = word.substr(equals + 1);
      throw usage_error("`" + printable(word) + "`: an equals sign stands only behind a long name; write `" +
                        name + (flag ? "" : " " + (value.empty() ? "VALUE" : printable(value))) + "`.");
    }
    if (equals + 1 < word.size()) continue;
    throw usage_error("`" + printable(word) + "` has no value; accepted is " +
                      (flag ? "" : "one right behind the equals sign, or to leave ") + "`" + name + "`" +
                      (flag ? " alone." : " out."));
  }
}

/// Of the help of what has verbs.
std::string closing_sentence(const std::string& words) {
  return "`" + words + " VERB --help` says more, with an example.\n" + kExitCodes;
}

CLI::App* app_of(CLI::App& program, const Verb& verb, std::map<std::string, CLI::App*>& groups, bool& quiet) {
  const std::string name(verb.name);
  const size_t space = name.find(' ');
  if (space == std::string::npos) return program.add_subcommand(name, std::string(verb.sentence));
  const std::string group = name.substr(0, space);
  CLI::App*& parent = groups[group];
  if (!parent) {
    parent = program.add_subcommand(group, std::string(group_sentence(group)));
    parent->require_subcommand(1);
    parent->failure_message(CLI::FailureMessage::simple);
    parent->add_flag("-q,--quiet", quiet, kQuiet);
    parent->footer(closing_sentence("cuesta " + group));
  }
  return parent->add_subcommand(name.substr(space + 1), std::string(verb.sentence));
}

}  // namespace

int run_command_line(int count, const char* const* arguments) {
  const BuildInfo& build = build_info();
  CLI::App program("Cuesta: heightmap traversal hardware, modelled to the cycle.", "cuesta");
  program.require_subcommand(1);
  program.set_version_flag("--version",
                           "cuesta " + std::string(build.version) + " (" + std::string(build.commit) + ")");
  program.footer(closing_sentence("cuesta"));

  Session session;
  program.add_flag("-q,--quiet", session.quiet, "No progress and no remarks; also after the verb");
  session.command_line = "cuesta";
  for (int k = 1; k < count; ++k) session.command_line += std::string(" ") + arguments[k];
  std::vector<Leaf> leaves;
  std::map<std::string, CLI::App*> groups;
  for (const Verb& verb : verbs()) {
    CLI::App* app = app_of(program, verb, groups, session.quiet);
    app->footer("Example:\n  " + std::string(verb.example) + "\n");
    app->allow_extras();
    app->add_flag("-q,--quiet", session.quiet, kQuiet);
    leaves.push_back({app, verb.make()});
    Options options(*app);
    leaves.back().command->declare(options);
  }

  check_equals_signs(check_verb(program, count, arguments), count, arguments);
  try {
    program.parse(count, arguments);
  } catch (const CLI::Success& success) {  // --help, --version
    return program.exit(success, std::cout, std::cerr);
  } catch (const CLI::ParseError& error) {
    std::string where;
    for (size_t k = 0; k < leaves.size(); ++k) {
      if (!leaves[k].app->parsed()) continue;
      where = "cuesta " + std::string(verbs()[k].name);
      // A misspelt option often shows as something else that is missing.
      for (const std::string& extra : extras_of(*leaves[k].app)) {
        if (extra.starts_with("-")) refuse_extra(*leaves[k].app, std::string(verbs()[k].name), extra);
      }
      check_given_once(*leaves[k].app, std::string(verbs()[k].name));
    }
    if (where.empty()) refuse_unknown_verb(program, "");
    throw usage_error("`" + where + "`: " + error.what() + "; `" + where + " --help` says what is accepted.");
  }
  for (size_t k = 0; k < leaves.size(); ++k) {
    if (!leaves[k].app->parsed()) continue;
    const std::vector<std::string> extras = extras_of(*leaves[k].app);
    if (!extras.empty()) refuse_extra(*leaves[k].app, std::string(verbs()[k].name), extras.front());
    for (const CLI::Option* option : leaves[k].app->get_options()) {
      if (option->get_positional()) continue;
      for (const std::string& value : option->results()) {
        if (!value.empty()) continue;
        throw usage_error("`cuesta " + std::string(verbs()[k].name) + "`: " + option->get_name() +
                          " is given without a value; accepted is one, or to leave " + option->get_name() +
                          " out.");
      }
    }
    const ExitCode code = leaves[k].command->run(session);
    flush_standard_output();
    return static_cast<int>(code);
  }
  refuse_unknown_verb(program, "");
}

}  // namespace cuesta
