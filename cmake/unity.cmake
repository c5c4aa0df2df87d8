# Cold libraries, whose sources nearly all include the same headers, are compiled as unity builds: several sources in
# one translation unit, which reads the headers once. Names in their unnamed namespaces must therefore differ. Units,
# walks and the machine are compiled one by one, so that an edit there is quick. CUESTA_UNITY=OFF compiles all so.
option(CUESTA_UNITY "Compile several sources of a cold library in one translation unit" ON)

# cuesta_unity(BATCH target ...): so many sources of the target in one unit at the most; two or more units for a large
# target, since a machine has more than one processor.
function(cuesta_unity batch)
  if(CUESTA_UNITY)
    set_target_properties(${ARGN} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE ${batch})
  endif()
endfunction()

# cuesta_unity_by_folder(target): one unit for each folder; names may recur in another folder.
function(cuesta_unity_by_folder target)
  get_target_property(sources ${target} SOURCES)
  get_target_property(root ${target} SOURCE_DIR)
  foreach(source IN LISTS sources)
    cmake_path(GET source PARENT_PATH folder)
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY "${root}")
    set_source_files_properties("${source}" TARGET_DIRECTORY ${target} PROPERTIES UNITY_GROUP "${folder}")
  endforeach()
  if(CUESTA_UNITY)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
  endif()
endfunction()

# cuesta_cold(target ...): -O1 in the place of -O3. Pages and the command line take no time that a user would notice,
# but half of what the compiler took for them was optimising.
function(cuesta_cold)
  if(CMAKE_CXX_FLAGS_RELEASE MATCHES "-O3")
    foreach(target IN LISTS ARGN)
      target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
    endforeach()
  endif()
endfunction()

cuesta_unity(12 cuesta_reports cuesta_traces cuesta_image_read cuesta_cli cuesta_session cuesta_config cuesta_oracle
    cuesta_image_codec cuesta_strict_toml cuesta_lockstep cuesta_lockstep_files cuesta_verify cuesta_adversary
    cuesta_systemc_host)
cuesta_unity_by_folder(cuesta_study)
cuesta_cold(cuesta_reports cuesta_cli cuesta_study)
