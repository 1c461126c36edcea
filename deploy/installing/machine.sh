# shellcheck shell=bash disable=SC2154,SC2034  # variables are shared by the files of this folder
# Installs packages, and enables services where systemd runs.

# wanted_packages: of the role.
wanted_packages() {
  case $role in
    server) echo weft-server weft-cli weft-health ;;
    robot) echo weft-agent weft-health ;;
    operator) echo weft-cli ;;
  esac
}

# find_packages: sets `packages` to the folder that has them; builds them where there is none and this is the repository.
find_packages() {
  if [ -z "$packages" ] && [ -d "$here/packages" ] && ls "$here"/packages/weft-*.deb >/dev/null 2>&1; then packages=$here/packages; fi
  if [ -z "$packages" ] && [ -x "$here/package" ]; then
    packages=$here/../build/packages
    if ! ls "$packages"/weft-*.deb >/dev/null 2>&1; then
      say "build the packages into build/packages, which takes about ten minutes"
      [ "$mode" != act ] || "$here/package" || fail 1 "the packages could not be built"
    fi
  fi
  [ -n "$packages" ] || fail 1 "there are no weft-*.deb in $here/packages; give their folder with --packages"
}

# package_file PACKAGE: its file; of several, the latest version.
package_file() { find "$packages" -maxdepth 1 -type f -name "$1_*.deb" | sort -V | tail -n 1; }

check_sums() {
  local sums; sums=$(dirname "$packages")/SHA256SUMS
  [ -f "$sums" ] || return 0
  (cd "$(dirname "$sums")" && sha256sum --quiet --check SHA256SUMS >/dev/null 2>&1) ||
    fail 1 "what is in $(dirname "$sums") is not what its SHA256SUMS say; copy the archive again"
}

install_packages() {
  command -v dpkg-query >/dev/null || fail 1 "dpkg is missing: this machine is no Debian; use the programs of build/release/bin"
  find_packages
  check_sums
  local package file files=()
  for package in $(wanted_packages); do
    file=$(package_file "$package")
    if [ -z "$file" ]; then
      [ "$mode" = act ] && fail 1 "$packages has no ${package}_*.deb"
      say "install $package"; continue
    fi
    if [ "$(dpkg-query -W -f '${db:Status-Status} ${Version}' "$package" 2>/dev/null || true)" = "installed $(dpkg-deb -f "$file" Version)" ]; then
      echo "install: $package is installed"
    else
      say "install $file"
      files+=("$(realpath "$file")")
    fi
  done
  if [ "$mode" = act ] && [ ${#files[@]} -gt 0 ]; then apt_install "${files[@]}"; fi
}

# apt_install FILE...: with what they depend on, from the folder's own index if it has one (deploy/bundle --with-dependencies).
apt_install() {
  local log made="" index=()
  log=$(mktemp)
  if [ -f "$packages/Packages" ]; then
    made=$(mktemp -d)
    mkdir -p "$made/lists/partial" "$made/none"
    echo "deb [trusted=yes] file:$(realpath "$packages") ./" >"$made/weft.list"
    index=(-o "Dir::Etc::sourcelist=$made/weft.list" -o "Dir::Etc::sourceparts=$made/none" -o "Dir::State::lists=$made/lists"
      -o APT::Sandbox::User=root)
    apt-get "${index[@]}" update >>"$log" 2>&1 || fail 1 "apt-get cannot read $packages/Packages (all it said is in $log)"
  fi
  if ! DEBIAN_FRONTEND=noninteractive apt-get "${index[@]}" -o Dpkg::Options::=--force-confold install -y \
    --no-install-recommends "$@" >>"$log" 2>&1; then
    fail 1 "apt-get failed: $(grep -m 1 '^E:' "$log" || tail -n 1 "$log") (all it said is in $log)"
  fi
  rm -rf "$log" ${made:+"$made"}
}

# units: of the role; none for an operator.
units() {
  case $role in
    server) echo weft-server.service weft-backup.timer ;;
    robot) echo "weft-agent@$instance.service" ;;
  esac
}

start_services() {
  local unit
  if [ ! -d "/run/systemd/system" ]; then
    [ "$role" = operator ] || echo "install: systemd does not run here. Start it with: $(by_hand)"
    return
  fi
  for unit in $(units); do
    if systemctl --quiet is-enabled "$unit" 2>/dev/null && systemctl --quiet is-active "$unit" 2>/dev/null && ! $settings_changed; then
      echo "install: $unit is enabled and runs"
    else
      say "enable and restart $unit"
      [ "$mode" != act ] || { systemctl --quiet enable "$unit" && systemctl --no-block restart "$unit"; } ||
        fail 1 "systemctl cannot start $unit; \`systemctl status $unit\` says why"
    fi
  done
}

# by_hand: what a unit would start.
by_hand() {
  case $role in
    server) echo "setpriv --reuid weft --regid weft --clear-groups weft-server --config /etc/weft/server.toml --store /var/lib/weft/map" ;;
    robot) echo "setpriv --reuid weft --regid weft --clear-groups weft-agent --config /etc/weft/agents/$instance.toml --state /var/lib/weft/agents/$instance" ;;
  esac
}
