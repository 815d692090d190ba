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

# Prints the packages of the list: those for the program, and those for the purposes given.
wanted_packages() {
  awk -v purposes=" $* " '{ sub(/#.*/, "") }
    NF == 1 { print $1 }
    { for (i = 2; i <= NF; ++i) if (index(purposes, " " $i " ")) { print $1; next } }' "$root/tools/packages.txt" |
    LC_ALL=C sort
}

is_optional() {
  grep -qE "^$1[[:space:]].*optional" "$root/tools/packages.txt"
}

installed_packages() {
  local packages
  mapfile -t packages < <(wanted_packages "$@")
  # Fails when it does not know one of the names, and still answers for the others.
  dpkg-query --show --showformat='${db:Status-Status} ${Package}\n' "${packages[@]}" 2>/dev/null |
    sed -n 's/^installed //p' | LC_ALL=C sort -u || true
}

# Prints the packages for these purposes that are not installed; optional ones where there are any.
missing_packages() {
  local package
  LC_ALL=C comm -23 <(wanted_packages "$@") <(installed_packages "$@") |
    while read -r package; do
      if ! is_optional "${package//+/\\+}" || apt-cache show "$package" >/dev/null 2>&1; then
        printf '%s\n' "$package"
      fi
    done
}

# Installs what is missing to build the program, and for the purposes given besides: test, package,
# fuzz, ci.
install_packages() {
  local missing administrator=()
  command -v dpkg-query >/dev/null ||
    fail "this is not a Debian system; install by other means what tools/packages.txt names"
  mapfile -t missing < <(missing_packages "$@")
  ((${#missing[@]})) || return 0

  if ((EUID != 0)); then
    command -v sudo >/dev/null ||
      fail "missing packages, and neither root nor sudo to install them: ${missing[*]}"
    administrator=(sudo)
  fi
  local install=("${administrator[@]}" env DEBIAN_FRONTEND=noninteractive
    apt-get install --yes --no-install-recommends)
  printf '%s: installing %s\n' "${0##*/}" "${missing[*]}" >&2
  "${install[@]}" "${missing[@]}" >/dev/null 2>&1 && return
  # The package index may be missing or too old; a new one may know more of the optional packages.
  quietly "${administrator[@]}" apt-get update
  mapfile -t missing < <(missing_packages "$@")
  quietly "${install[@]}" "${missing[@]}" || fail "apt-get could not install: ${missing[*]}"
}

# Configures a preset when that has not been done, or the presets have changed since. The tests are
# left out until they are asked for.
configure() {
  local preset=$1 testing=$2
  local folder=$root/build/$preset
  if [[ -f $folder/build.ninja && ! $root/CMakePresets.json -nt $folder/build.ninja ]]; then
    [[ $testing == OFF ]] || grep -q '^BUILD_TESTING:BOOL=ON' "$folder/CMakeCache.txt" && return
  elif [[ ! -f $folder/build.ninja ]]; then
    printf '%s: preparing %s, which takes some minutes the first time\n' \
      "${0##*/}" "build/$preset" >&2
  fi
  (cd "$root" && quietly cmake --preset "$preset" "-DBUILD_TESTING=$testing") ||
    fail "cmake --preset $preset failed"
  touch "$folder/build.ninja"
}

# Builds targets of a preset, or all of it with its tests; commands given at the same time wait for one
# another.
build() {
  local preset=$1
  shift
  build_as "$preset" "$( (($#)) && echo OFF || echo ON)" "$@"
}

# The same with the tests among the targets.
build_with_tests() {
  local preset=$1
  shift
  build_as "$preset" ON "$@"
}

build_as() {
  local preset=$1 testing=$2
  shift 2
  mkdir -p "$root/build"
  (
    flock 9
    configure "$preset" "$testing"
    quietly ninja --quiet -C "$root/build/$preset" -j "$(nproc)" "$@" ||
      fail "the build of $preset failed"
  ) 9>"$root/build/$preset.lock"
}
