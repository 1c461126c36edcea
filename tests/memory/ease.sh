# ease_memory: on a machine where the first touch of a page of memory takes 2 us and more (most take less than 1; a
# virtual one whose host is short of memory 4 to 450), keeps a sixth of the memory that is free, at most 4 GB, as huge
# pages, and names the library that gives them to compilers in WEFT_HUGE_PAGES (huge_pages.c): they take a third of the
# time there. Needs root; without it, and wherever it fails, nothing changes. Ends with the shell that called it.
ease_memory() {
  local cost kept wanted_kb
  mkdir -p build/memory
  cc -O2 tests/memory/fault_cost.c -o build/memory/fault_cost && cost=$(build/memory/fault_cost) || return 0
  echo "--- memory: the first touch of a page takes $cost us"
  [ "$cost" -ge 2 ] && [ "$(id -u)" -eq 0 ] && [ -w /proc/sys/vm/nr_hugepages ] || return 0
  cc -O2 -shared -fPIC tests/memory/huge_pages.c -o build/memory/huge_pages.so || return 0
  kept=$(cat /proc/sys/vm/nr_hugepages)
  wanted_kb=$(awk '/MemAvailable/ { kb = $2 / 6; print int(kb < 4194304 ? kb : 4194304) }' /proc/meminfo)
  echo $((wanted_kb / 2048)) 2>/dev/null >/proc/sys/vm/nr_hugepages || return 0
  trap "echo $kept >/proc/sys/vm/nr_hugepages; ${1:-:}" EXIT
  export WEFT_HUGE_PAGES=$PWD/build/memory/huge_pages.so
  echo "--- memory: $(cat /proc/sys/vm/nr_hugepages) huge pages are kept for compilers"
}
