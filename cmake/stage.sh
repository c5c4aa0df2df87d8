# shellcheck shell=bash
# Sourced by setup, quickstart, check: stage TITLE COMMAND... says what runs, runs it, says how long it took.
stage_times=()

stage() {
  local title=$1 started=$EPOCHREALTIME status=0
  shift
  printf '\n== %s: %s\n' "$title" "$*"
  "$@" || status=$?
  local tenths=$(((${EPOCHREALTIME/./} - ${started/./}) / 100000))
  local took="$((tenths / 10)).$((tenths % 10)) s"
  if [ "$status" -ne 0 ]; then
    printf '== %s: failed with exit code %d after %s\n' "$title" "$status" "$took" >&2
    exit "$status"
  fi
  printf '== %s: %s\n' "$title" "$took"
  stage_times+=("$title $took")
}

# One line: every stage so far with its time.
print_stage_times() {
  local line
  printf -v line '%s, ' "${stage_times[@]}"
  printf '\nTimes: %s\n' "${line%, }"
}
