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

# build_preset PRESET [TARGET...]: configures and builds, warnings are errors. Where nobody looks on, every 20th step is told.
build_preset() {
  local preset=$1 huge=() status; shift
  [ -z "${WEFT_HUGE_PAGES:-}" ] || huge=(env "LD_PRELOAD=$WEFT_HUGE_PAGES" GLIBC_TUNABLES=glibc.malloc.hugetlb=2)
  cmake --preset "$preset" -DWEFT_WERROR=ON -DWEFT_SLOW_START="${WEFT_SLOW_MEMORY:+ON}" >build-configure.log 2>&1 || { cat build-configure.log; rm -f build-configure.log; return 1; }
  rm -f build-configure.log
  if [ -t 1 ]; then "${huge[@]}" ninja -C "build/$preset" "$@"; return; fi
  NINJA_STATUS='[%f/%t, %e s] ' "${huge[@]}" ninja -C "build/$preset" "$@" |
    grep --line-buffered -vE '^\[([0-9]*[13579][0-9]|[0-9]*[1-9])/|^(Loading templates|Processing the file|Generating |Adding project)'
  status=${PIPESTATUS[0]}
  return "$status"
}

# run_ctest PRESET CTEST_ARGUMENTS...: adds the counts of ctest's own report to ours. Ends at WEFT_DEADLINE, where there is
# one: what has not begun by then, or is cut off there, is counted as skipped.
run_ctest() {
  local preset=$1 report count log stop=() cut=0 all; shift
  report=$PWD/build/$preset/ctest-report.xml log=build/$preset/ctest.log
  rm -f "$report"
  echo "--- tests ($preset $*)"
  if [ -n "${WEFT_DEADLINE:-}" ]; then
    if [ $((WEFT_DEADLINE - $(date +%s))) -lt 120 ]; then skipped=$((skipped + 1)); echo "--- tests ($preset): SKIPPED, no time is left"; return; fi
    stop=(--stop-time "$(date -d "@$WEFT_DEADLINE" +%H:%M:%S)")
  fi
  LSAN_OPTIONS="suppressions=$PWD/tests/leaks.txt:print_suppressions=0" ctest --test-dir "build/$preset" -j 2 --timeout 3600 --output-on-failure --output-junit "$report" "${stop[@]}" "$@" >"$log" 2>&1
  grep -E 'Failed|Timeout|\*\*\*|Skipped|^[0-9]+% tests' "$log" | grep -v '^ *$' | tail -n 60
  count() { head -n 12 "$report" | grep -oE "$1=\"[0-9]+\"" | head -n 1 | grep -oE '[0-9]+'; }
  if [ ! -s "$report" ] || [ "$(count tests)" -eq 0 ]; then
    if grep -q 'The stop time has been passed' "$log"; then skipped=$((skipped + 1)); echo "--- tests ($preset $*): SKIPPED, no time was left"; return; fi
    echo "no test ran; the log is $log"; failed=$((failed + 1)); failures+=("tests ($preset)"); return 1
  fi
  if grep -q 'The stop time has been passed' "$log"; then
    # A test's own limit is 1200 s and more: one that ran into "Timeout" before was cut off.
    cut=$(grep -E '\*\*\*Timeout +[0-9.]+ sec' "$log" | awk '$(NF - 1) < 1190' | wc -l)
    all=$(ctest --test-dir "build/$preset" -N "$@" | grep -oE 'Total Tests: [0-9]+' | grep -oE '[0-9]+')
    skipped=$((skipped + all - $(count tests) + cut))
    echo "--- tests ($preset): $((all - $(count tests) + cut)) of $all SKIPPED, no time was left"
  fi
  local bad=$(($(count failures) - cut)) out=$(($(count skipped) + $(count disabled)))
  passed=$((passed + $(count tests) - bad - cut - out)); failed=$((failed + bad)); skipped=$((skipped + out))
  if [ "$bad" -gt 0 ]; then
    failures+=("$bad of the tests ($preset)")
    sed -n '/The following tests FAILED/,$p' "$log"
    grep -E '^ *[0-9]+: .*(Failure|error|ERROR)|^ *Expected|Actual' "$log" | head -n 80
    return 1
  fi
}

finish() {
  [ ${#failures[@]} -eq 0 ] || printf 'failed: %s\n' "${failures[@]}"
  echo "$passed passed, $failed failed, $skipped skipped"
  [ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
  exit $?
}
