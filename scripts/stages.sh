# shellcheck shell=bash
# Sourced by scripts that do several things one after the other: all of them run, also after one has
# failed, and the last lines say what came of each.
report=()
failed=0

# processor_seconds: of all that this shell has started and seen end.
processor_seconds() {
  local fields
  read -r -a fields <"/proc/$$/stat"
  echo $(((fields[15] + fields[16]) / $(getconf CLK_TCK)))
}

# stage NAME COMMAND...: runs it and keeps its outcome, and what it puts into details, for the end.
stage() {
  local name=$1 start=$SECONDS status=0 processors
  processors=$(processor_seconds)
  shift
  say "$name"
  details=()
  "$@" || failed=1 status=1
  report+=("$(printf '%-44s %-6s %5d s, %5d s of processors' "$name" \
    "$( ((status)) && echo FAILED || echo passed)" $((SECONDS - start)) \
    $(($(processor_seconds) - processors)))" "${details[@]}")
  return "$status"
}

# end_stages: what came of them; ends the script.
end_stages() {
  say "summary"
  printf '%s\n' "${report[@]}"
  if ((failed)); then fail "at least one stage FAILED"; fi
  exit 0
}
