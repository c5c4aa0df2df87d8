# The parameter sets of the hardware: rows of rtl/sets.csv.
set(CUESTA_RTL_NAMED tiny mobile desktop CACHE STRING "Sets of rtl/sets.csv that are always compiled")
set(CUESTA_RTL_SETS large CACHE STRING
    "Sets of rtl/sets.csv to compile beside tiny, mobile and desktop: names, separated by semicolons, or `all`")

# cuesta_rtl_sets(NAMES): the names of the rows to compile, in the file's order. For each, SET_<name>_VALUES and
# SET_<name>_PARAMETERS (Name=value ...) are set.
function(cuesta_rtl_sets names_out)
  set(table "${PROJECT_SOURCE_DIR}/rtl/sets.csv")
  set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS "${table}")
  file(STRINGS "${table}" rows)
  list(POP_FRONT rows header)
  string(REPLACE "," ";" columns "${header}")
  list(POP_FRONT columns)
  set(known)
  set(names)
  foreach(row IN LISTS rows)
    string(REPLACE "," ";" values "${row}")
    list(POP_FRONT values name)
    list(APPEND known ${name})
    if(NOT name IN_LIST CUESTA_RTL_NAMED AND NOT "all" IN_LIST CUESTA_RTL_SETS
        AND NOT name IN_LIST CUESTA_RTL_SETS)
      continue()
    endif()
    list(APPEND names ${name})
    set(parameters)
    foreach(column value IN ZIP_LISTS columns values)
      list(APPEND parameters "${column}=${value}")
    endforeach()
    set(SET_${name}_VALUES "${values}" PARENT_SCOPE)
    set(SET_${name}_PARAMETERS "${parameters}" PARENT_SCOPE)
  endforeach()
  foreach(name IN LISTS CUESTA_RTL_SETS)
    if(NOT name IN_LIST known AND NOT name STREQUAL "all")
      message(FATAL_ERROR "CUESTA_RTL_SETS names ${name}; accepted are rows of rtl/sets.csv: ${known}")
    endif()
  endforeach()
  set(${names_out} "${names}" PARENT_SCOPE)
endfunction()

# cuesta_rtl_set(NAME PARAMETERS Name=value ... VALUES value ... [ASSERT]): the library cuesta_rtl_NAME with hmt_top and
# traverse compiled for the parameters, as kRtlSet_NAME. VALUES: in the order of the columns. ASSERT: with assertions.
function(cuesta_rtl_set NAME)
  cmake_parse_arguments(ARG "ASSERT" "" "PARAMETERS;VALUES" ${ARGN})
  cuesta_no_leftovers(cuesta_rtl_set ${NAME})
  set(assert)
  if(ARG_ASSERT)
    set(assert ASSERT)
  endif()
  cuesta_verilated(hmt_top_${NAME} TOP hmt_top PREFIX Vhmt_top_${NAME} WAVES ${assert}
      SOURCES ${CUESTA_HMT_TOP_SOURCES} PARAMETERS ${ARG_PARAMETERS})
  set(of_traverse ${ARG_PARAMETERS})
  list(FILTER of_traverse EXCLUDE REGEX "^(Setup.*|SizeBytes|LineBytes|Ways|Mshrs)=")
  cuesta_verilated(traverse_${NAME} TOP traverse PREFIX Vtraverse_${NAME} WAVES ${assert}
      SOURCES "${CUESTA_TRAVERSE_SV}" PARAMETERS ${of_traverse} AddressBits=32)
  # Constants alone: what set_${NAME}.cpp holds the model's widths against.
  set(of_widths ${ARG_PARAMETERS})
  list(FILTER of_widths INCLUDE REGEX "^(MaxLevel|HeightBits|FractionBits|DirectionBits|MantissaBits|TileBits)=")
  list(TRANSFORM of_widths PREPEND "-G")
  set(widths_folder "${CMAKE_CURRENT_BINARY_DIR}/hmt_widths_${NAME}")
  set(widths_header "${widths_folder}/Vhmt_widths_${NAME}_hmt_widths.h")
  add_custom_command(OUTPUT "${widths_header}"
      COMMAND "${VERILATOR_BIN}" --cc -Wno-fatal -Wno-UNUSED "-I${PROJECT_SOURCE_DIR}/rtl" ${of_widths}
          --prefix Vhmt_widths_${NAME} --Mdir "${widths_folder}" "${PROJECT_SOURCE_DIR}/rtl/common/hmt_widths.sv"
      DEPENDS "${PROJECT_SOURCE_DIR}/rtl/common/hmt_widths.sv" "${PROJECT_SOURCE_DIR}/rtl/common/ray_widths.svh"
      COMMENT "Widths of the set ${NAME}" VERBATIM)
  list(JOIN ARG_VALUES ", " VALUES)
  configure_file("${PROJECT_SOURCE_DIR}/sim/hardware/set.cpp.in" "set_${NAME}.cpp" @ONLY)
  cuesta_library(cuesta_rtl_${NAME} SOURCES "${CMAKE_CURRENT_BINARY_DIR}/set_${NAME}.cpp" "${widths_header}"
      PRIVATE_DEPENDS hmt_top_${NAME} traverse_${NAME})
  target_include_directories(cuesta_rtl_${NAME} PRIVATE "${widths_folder}")
  set_target_properties(cuesta_rtl_${NAME} PROPERTIES POSITION_INDEPENDENT_CODE ON CXX_VISIBILITY_PRESET hidden)
  target_compile_definitions(cuesta_rtl_${NAME} PRIVATE CUESTA_RTL_WAVES $<$<BOOL:${CUESTA_RTL_COVERAGE}>:CUESTA_RTL_COVERAGE>)
endfunction()

# cuesta_rtl_sets_source(FILE name ...): writes FILE, a source in which rtl_sets() are the named sets.
function(cuesta_rtl_sets_source FILE)
  list(LENGTH ARGN COUNT)
  list(TRANSFORM ARGN PREPEND kRtlSet_ OUTPUT_VARIABLE ENTRIES)
  list(JOIN ENTRIES ", " ENTRIES)
  set(DECLARATIONS "")
  foreach(name IN LISTS ARGN)
    string(APPEND DECLARATIONS "extern const RtlSet kRtlSet_${name};\n")
  endforeach()
  configure_file("${PROJECT_SOURCE_DIR}/sim/hardware/sets.cpp.in" "${FILE}" @ONLY)
endfunction()
