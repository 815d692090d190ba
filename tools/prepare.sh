# shellcheck shell=bash
# What tools/maquette and tools/test share: packages, configuration, build. Sourced, not run.

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

fail() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}

# Runs a command and shows what it printed (on standard error) only when it fails.
quietly() {
  local output
  if ! output=$("$@" 2>&1); then
    printf '%s\n' "$output" >&2
    return 1
  fi
}

wanted_packages() {
  sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$root/tools/packages.txt" | sort
}

installed_packages() {
  local packages
  mapfile -t packages < <(wanted_packages)
  # Fails when it does not know one of the names, and still answers for the others.
  dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null |
    sed -n 's/^installed //p' | sort -u || true
}

# Prints the packages of the list that are not installed.
missing_packages() {
  comm -23 <(wanted_packages) <(installed_packages)
}

install_packages() {
  local missing administrator=()
  command -v dpkg-query >/dev/null ||
    fail "this is not a Debian system; install by other means what tools/packages.txt names"
  mapfile -t missing < <(missing_packages)
  ((${#missing[@]})) || return 0

  if ((EUID != 0)); then
    command -v sudo >/dev/null ||
      fail "missing packages, and neither root nor sudo to install them: ${missing[*]}"
    administrator=(sudo)
  fi
  local install=("${administrator[@]}" env DEBIAN_FRONTEND=noninteractive
    apt-get install --yes --no-install-recommends "${missing[@]}")
  printf '%s: installing %s\n' "${0##*/}" "${missing[*]}" >&2
  # The package index may be missing or too old: refresh it only then.
  "${install[@]}" >/dev/null 2>&1 || {
    quietly "${administrator[@]}" apt-get update && quietly "${install[@]}"
  } || fail "apt-get could not install: ${missing[*]}"
}

# Configures a preset when that has not been done, or the presets have changed since.
configure() {
  local preset=$1
  local ninja_file=$root/build/$preset/build.ninja
  [[ -f $ninja_file && ! $root/CMakePresets.json -nt $ninja_file ]] && return
  printf '%s: preparing %s, which takes some minutes the first time\n' \
    "${0##*/}" "build/$preset" >&2
  (cd "$root" && quietly cmake --preset "$preset") || fail "cmake --preset $preset failed"
  touch "$ninja_file"
}

# Builds targets of a preset; commands given at the same time wait for one another.
build() {
  local preset=$1
  shift
  mkdir -p "$root/build"
  (
    flock 9
    configure "$preset"
    quietly ninja --quiet -C "$root/build/$preset" -j "$(nproc)" "$@" ||
      fail "the build of $preset failed"
  ) 9>"$root/build/$preset.lock"
}
