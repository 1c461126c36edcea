# shellcheck shell=bash disable=SC2154,SC2034  # variables are shared by the files of this folder
# Writes the settings. A file of ours begins with the checksum of what follows, so that edits of people are seen.
differs=0              # with --check: something is not as it is wanted
settings_changed=false  # services have to read them anew

# say TEXT: what is done, would be done, or is not as it should be.
say() {
  case $mode in
    act) echo "install: $1" ;;
    tell) echo "install: would: $1" ;;
    check) echo "install: not so yet: $1"; differs=1 ;;
  esac
}

seal() { printf '# Written by deploy/install; edits are kept. Checksum: %s\n%s\n' "$(printf '%s\n' "$1" | sha256sum | cut -c 1-16)" "$1"; }

# is_edited FILE: it has settings, and they are not as deploy/install wrote them.
is_edited() {
  grep -qE '^[^#[:space:]]' "$1" || return 1
  [ "$(head -n 1 "$1")" != "$(seal "$(tail -n +2 "$1")" | head -n 1)" ]
}

# write FILE TEXT: unless it is there so.
write() {
  local file=$root$1 text
  text=$(seal "$2")
  if [ -e "$file" ]; then
    if [ "$(cat "$file")" = "$text" ]; then echo "install: $file is as it should be"; return; fi
    if is_edited "$file" && ! $replace && [ "$mode" = act ]; then
      fail 1 "$file has been edited: change it there, or give --replace, which keeps it as $file.old"
    fi
  fi
  say "write $file"
  if [ "$mode" = tell ]; then printf '%s\n' "$text" | sed 's/^/    /'; fi
  [ "$mode" = act ] || return 0
  mkdir -p "$(dirname "$file")"
  if [ -e "$file" ] && is_edited "$file"; then cp -p "$file" "$file.old"; fi
  printf '%s\n' "$text" >"$file.new"
  mv "$file.new" "$file"
  settings_changed=true
}

# toml KEY VALUE: a line, when there is a value. quoted WORD...: an array of texts.
toml() { [ -z "$2" ] || printf '%s = %s\n' "$1" "$2"; }
quoted() { local words; words=$(printf '"%s", ' "$@"); printf '%s' "[${words%, }]"; }

# shared_settings: what server and robots have both.
shared_settings() {
  toml name "${name:+\"$name\"}"
  toml listen "${listen:+\"$listen\"}"
  toml domain "$domain"
  toml dds "${dds:+\"$dds\"}"
}

# environment PREFIX SERVER: how weft reaches the server, as variables.
environment() {
  printf '%sWEFT_SERVER=%s\n' "$1" "$2"
  [ -z "$listen" ] || printf '%sWEFT_LISTEN=%s\n' "$1" "$listen"
  [ -z "$domain" ] || printf '%sWEFT_DOMAIN=%s\n' "$1" "$domain"
}

write_server_settings() {
  if [ -z "$listen" ]; then echo "install: without --listen the server is heard on this machine alone" >&2; fi
  write /etc/weft/server.toml "$(shared_settings)"
  write /etc/weft/backup.conf "$(environment "" "$(own_address)"; echo "WEFT_BACKUP_KEEP=${keep:-14}")"
}

# own_address: of --listen, for the backup on the same machine; an interface is looked up when this runs.
own_address() {
  local address=$listen
  if [ -n "$listen" ] && [ -d "/sys/class/net/$listen" ]; then
    address=$(ip -4 -o address show dev "$listen" 2>/dev/null | awk '{ sub("/.*", "", $4); print $4; exit }')
    if [ -z "$address" ]; then
      echo "install: interface $listen has no address yet: put the server's into /etc/weft/backup.conf when it has" >&2
    fi
  fi
  printf '%s' "${address:-127.0.0.1}"
}

write_robot_settings() {
  local folder=/etc/weft/agents camera=""
  if [ -n "$calibration" ]; then
    camera=$folder/$instance.camera.yaml
    copy_calibration "$root$camera"
  fi
  write "$folder/$instance.toml" "$(
    shared_settings
    toml server "$(quoted "${servers[@]}")"
    toml method "${method:+\"$method\"}"
    toml body "${body:+\"$body\"}"
    toml calibration "${camera:+\"$camera\"}"
  )"
}

copy_calibration() {
  if cmp -s "$calibration" "$1"; then echo "install: $1 is as it should be"; return; fi
  say "copy $calibration to $1"
  [ "$mode" = act ] || return 0
  install -D -m 644 "$calibration" "$1"
  settings_changed=true
}

write_operator_settings() {
  local hosts
  hosts=$(IFS=,; printf '%s' "${servers[*]:-127.0.0.1}")
  write /etc/profile.d/weft.sh "$(environment "export " "$hosts"; [ -z "$dds" ] || echo "export WEFT_DDS=$dds")"
}
