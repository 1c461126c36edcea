# What tests/run and .ci/run share: steps that are counted, and the closing line.
passed=0; failed=0; skipped=0; failures=()

# step NAME COMMAND...: one counted check; its output is shown. Its whole process group ends with it.
step() {
  local name=$1 began=$SECONDS; shift
  echo "--- $name"
  if "$@"; then
    passed=$((passed + 1)); echo "--- $name: passed, $((SECONDS - began)) s"
  else
    failed=$((failed + 1)); failures+=("$name"); echo "--- $name: FAILED, $((SECONDS - began)) s"; return 1
  fi
}

# step_in_time MINUTES NAME PROGRAM...: a step that is left out when fewer than MINUTES remain before WEFT_DEADLINE
# (seconds since 1970), and ended there when it takes longer than it should; both are said and counted as skipped, so that
# a slow machine tells what it got through. A program that is ended and knows of a failure by then exits with less than
# 130 (interrupted, or by a signal) and fails. Without a deadline the step always runs, to its end.
step_in_time() {
  local minutes=$1 name=$2 began=$SECONDS left status running; shift 2
  [ -n "${WEFT_DEADLINE:-}" ] || { step "$name" "$@"; return; }
  left=$((WEFT_DEADLINE - $(date +%s)))
  if [ "$left" -lt $((minutes * 60)) ] || [ "$left" -lt 1 ]; then
    skipped=$((skipped + 1)); echo "--- $name: SKIPPED, takes up to $minutes min and $((left / 60)) are left"; return
  fi
  echo "--- $name"
  # A group of its own, which an interrupt of the terminal does not reach: it is passed on.
  timeout --preserve-status --kill-after=10 "$left" env --default-signal=INT,QUIT "$@" & running=$!
  trap 'kill "$running"; wait "$running"; exit 130' INT TERM
  wait "$running"; status=$?
  trap - INT TERM
  if [ "$status" -eq 0 ]; then
    passed=$((passed + 1)); echo "--- $name: passed, $((SECONDS - began)) s"
  elif [ "$status" -ge 130 ] && [ $((SECONDS - began)) -ge $((left - 1)) ]; then  # interrupted, or by a signal
    skipped=$((skipped + 1)); echo "--- $name: SKIPPED, not done after $((left / 60)) min, all that were left"
  else
    failed=$((failed + 1)); failures+=("$name"); echo "--- $name: FAILED, $((SECONDS - began)) s"; return 1
  fi
}

# build_preset PRESET [TARGET...]: configures and builds, warnings are errors.
build_preset() {
  local preset=$1; shift
  cmake --preset "$preset" -DWEFT_WERROR=ON >build-configure.log 2>&1 || { cat build-configure.log; rm -f build-configure.log; return 1; }
  rm -f build-configure.log
  if [ -t 1 ]; then ninja -C "build/$preset" "$@"; else ninja --quiet -C "build/$preset" "$@"; fi
}

# run_ctest PRESET CTEST_ARGUMENTS...: adds the counts of ctest's own report to ours.
run_ctest() {
  local preset=$1 report count; shift
  report=$PWD/build/$preset/ctest-report.xml
  rm -f "$report"
  echo "--- tests ($preset $*)"
  LSAN_OPTIONS="suppressions=$PWD/tests/leaks.txt:print_suppressions=0" ctest --test-dir "build/$preset" -j 2 --output-on-failure --output-junit "$report" "$@" >"build/$preset/ctest.log" 2>&1
  grep -E 'Failed|Timeout|\*\*\*|Skipped|^[0-9]+% tests' "build/$preset/ctest.log" | grep -v '^ *$' | tail -n 60
  count() { head -n 12 "$report" | grep -oE "$1=\"[0-9]+\"" | head -n 1 | grep -oE '[0-9]+'; }
  if [ ! -s "$report" ] || [ "$(count tests)" -eq 0 ]; then
    echo "no test ran; the log is build/$preset/ctest.log"; failed=$((failed + 1)); failures+=("tests ($preset)"); return 1
  fi
  local bad=$(($(count failures))) out=$(($(count skipped) + $(count disabled)))
  passed=$((passed + $(count tests) - bad - out)); failed=$((failed + bad)); skipped=$((skipped + out))
  if [ "$bad" -gt 0 ]; then
    failures+=("$bad of the tests ($preset)")
    sed -n '/The following tests FAILED/,$p' "build/$preset/ctest.log"
    grep -E '^ *[0-9]+: .*(Failure|error|ERROR)|^ *Expected|Actual' "build/$preset/ctest.log" | head -n 80
    return 1
  fi
}

finish() {
  [ ${#failures[@]} -eq 0 ] || printf 'failed: %s\n' "${failures[@]}"
  echo "$passed passed, $failed failed, $skipped skipped"
  [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
  exit $?
}
