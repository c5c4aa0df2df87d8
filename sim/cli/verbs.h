#pragma once

#include <span>

#include "sim/cli/command.h"

namespace cuesta {

/// Every verb there is, in the order of `cuesta --help`.
std::span<const Verb> verbs();

/// What the groups of verbs ("heightmap", "rays", "verify") are about. Empty for any other name.
std::string_view group_sentence(std::string_view group);

// One maker per verb; each is defined in the verb's own file.
std::unique_ptr<Command> make_run_command();
std::unique_ptr<Command> make_compare_command();
std::unique_ptr<Command> make_trace_command();
std::unique_ptr<Command> make_rays_make_command();
std::unique_ptr<Command> make_rays_info_command();
std::unique_ptr<Command> make_rays_convert_command();
std::unique_ptr<Command> make_rays_check_command();
std::unique_ptr<Command> make_heightmap_make_command();
std::unique_ptr<Command> make_heightmap_info_command();
std::unique_ptr<Command> make_study_command();
std::unique_ptr<Command> make_list_command();
std::unique_ptr<Command> make_verify_oracle_command();
std::unique_ptr<Command> make_verify_rtl_command();
std::unique_ptr<Command> make_verify_laws_command();
std::unique_ptr<Command> make_adversary_command();

}  // namespace cuesta
