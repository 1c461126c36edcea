# ease_memory [COMMAND]: looks five times, a second apart, at what the first touch of a page of memory costs (most machines:
# less than 1 us; a virtual one whose host is short of memory 4 to 450), and goes by the most. From 2 us on it keeps a sixth
# of the memory that is free, at most 4 GB, as huge pages and names the library that gives them to compilers in
# WEFT_HUGE_PAGES (huge_pages.c): they take a third of the time there. Needs root; without it, and wherever it fails,
# compilers are left as they are. When the shell ends that called it, the pages are given back and COMMAND runs. From
# 10 us on it sets WEFT_SLOW_MEMORY: what lives in real time fails there.
ease_memory() {
  local cost=0 look kept wanted_kb
  mkdir -p build/memory
  cc -O2 tests/memory/fault_cost.c -o build/memory/fault_cost || return 0
  for _ in 1 2 3 4 5; do
    look=$(build/memory/fault_cost) || return 0
    [ "$look" -le "$cost" ] || cost=$look
    sleep 1
  done
  echo "--- memory: the first touch of a page takes $cost us"
  [ "$cost" -lt 10 ] || export WEFT_SLOW_MEMORY=$cost
  [ "$cost" -ge 2 ] && [ "$(id -u)" -eq 0 ] && [ -w /proc/sys/vm/nr_hugepages ] || return 0
  cc -O2 -shared -fPIC tests/memory/huge_pages.c -o build/memory/huge_pages.so || return 0
  kept=$(cat /proc/sys/vm/nr_hugepages)
  wanted_kb=$(awk '/MemAvailable/ { kb = $2 / 6; print int(kb < 4194304 ? kb : 4194304) }' /proc/meminfo)
  echo $((wanted_kb / 2048)) 2>/dev/null >/proc/sys/vm/nr_hugepages || return 0
  trap "echo $kept >/proc/sys/vm/nr_hugepages; ${1:-:}" EXIT
  export WEFT_HUGE_PAGES=$PWD/build/memory/huge_pages.so
  echo "--- memory: $(cat /proc/sys/vm/nr_hugepages) huge pages are kept for compilers"
}
