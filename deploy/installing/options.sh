# shellcheck shell=bash disable=SC2154,SC2034  # variables are shared by the files of this folder
# The flags of deploy/install: what they may be, and what follows from them.
listen="" domain="" dds="" name="" keep="" method="" body="" calibration="" instance="" packages="" root="" mode=act replace=false
servers=()

# parse_options FLAG...: fills in the variables above.
parse_options() {
  while [ $# -gt 0 ]; do
    case "$1" in
      -h | --help) help; exit 0 ;;
      --replace) replace=true; shift; continue ;;
      --dry-run) mode=tell; shift; continue ;;
      --check) mode=check; shift; continue ;;
      --listen | --domain | --dds | --name | --keep | --method | --body | --calibration | --instance | --packages | --root | --server) ;;
      *) usage "unknown argument '$1'" ;;
    esac
    [ -n "${2:-}" ] || usage "$1 wants a value"
    case "$1" in
      --server) servers+=("$2") ;;
      *) printf -v "${1#--}" '%s' "$2" ;;
    esac
    shift 2
  done
}

# refuse_foreign FLAG VALUE ROLE...: a flag that only those roles have.
refuse_foreign() {
  local flag=$1 value=$2 owner; shift 2
  [ -n "$value" ] || return 0
  for owner in "$@"; do [ "$owner" != "$role" ] || return 0; done
  usage "$flag is for $(printf '%s, ' "$@" | sed 's/, $//'), not for $role"
}

check_options() {
  refuse_foreign --keep "$keep" server
  refuse_foreign --name "$name" server robot
  refuse_foreign --server "${servers[*]}" robot operator
  local flag
  for flag in method body calibration instance; do refuse_foreign "--$flag" "${!flag}" robot; done

  local host='^[A-Za-z0-9]([A-Za-z0-9._:-]{0,62}[A-Za-z0-9])?$' server
  [[ -z $listen || $listen =~ $host ]] || usage "--listen '$listen' is no address and no name of an interface"
  for server in "${servers[@]}"; do
    [[ $server =~ $host ]] || usage "--server '$server' is no address and no name of a machine"
  done
  [[ -z $domain || $domain =~ ^([0-9]|[1-9][0-9]|1[0-9][0-9]|200)$ ]] || usage "--domain '$domain' is not a number from 0 to 200"
  [[ $dds =~ ^(fastdds|cyclonedds)?$ ]] || usage "--dds '$dds' is neither fastdds nor cyclonedds"
  [[ -z $keep || $keep =~ ^([1-9][0-9]{0,2}|1000)$ ]] || usage "--keep '$keep' is not a number from 1 to 1000"
  [[ -z $method || $method =~ ^[a-z]+(,[a-z]+)*$ ]] || usage "--method '$method' is no list of methods with commas between"
  [[ -z $body || $body =~ ^[a-z0-9]+$ ]] || usage "--body '$body' is no body"
  [ -z "$calibration" ] || [ -f "$calibration" ] || usage "--calibration: there is no file $calibration"
  [ -z "$packages" ] || [ -d "$packages" ] || usage "--packages: there is no folder $packages"
  [ -z "$root" ] || [ -d "$root" ] || usage "--root: there is no folder $root"
  [ -z "$name" ] || check_name
  [ "$role" != robot ] || check_robot
}

check_name() {
  # The program judges letters of other scripts; here, whatever would break out of a line of settings is refused.
  local bytes; bytes=$(printf %s "$name" | wc -c)
  [ "$bytes" -le 64 ] || usage "--name '$name' has $bytes bytes; 64 are allowed"
  [[ ! $name =~ [[:space:][:cntrl:]\"\\/\'] && ! $name =~ ^[._-] ]] ||
    usage "--name '$name': letters and digits of any script, '_', '.' and '-', with a letter or a digit first"
}

check_robot() {
  local word='^[A-Za-z0-9][A-Za-z0-9._-]{0,63}$'
  [ -n "$name" ] || usage "--name NAME is missing: what people call this robot"
  [ ${#servers[@]} -gt 0 ] || usage "--server HOST is missing: where weft-server runs"
  [ -z "$instance" ] || [[ $instance =~ $word ]] || usage "--instance '$instance': ASCII letters, digits, '_', '.', '-'"
  [ -n "$instance" ] || [[ $name =~ $word ]] ||
    usage "--name '$name' cannot be the name of a service; give one of ASCII letters with --instance"
  instance=${instance:-$name}
}
