# Run by every build (cmake -P): writes OUTPUT from TEMPLATE with the commit that is checked out now; the file's
# time changes only when its text does, so nothing is compiled or linked again for the same commit.
find_program(GIT git)
set(CUESTA_COMMIT "unknown")
if(GIT)
  # safe.directory: the clone may belong to somebody else, as it does under sudo and in containers.
  execute_process(
      COMMAND "${GIT}" -c "safe.directory=${SOURCE_DIR}" describe --always --dirty --abbrev=12 --exclude=*
      WORKING_DIRECTORY "${SOURCE_DIR}" OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE
      RESULT_VARIABLE failed ERROR_QUIET)
  if(NOT failed AND EXISTS "${SOURCE_DIR}/.git")
    set(CUESTA_COMMIT "${described}")
  endif()
endif()
configure_file("${TEMPLATE}" "${OUTPUT}" @ONLY)
