# shellcheck shell=bash
# The compiler for the 68000 that makes the program of a board, and names of functions. Sourced, not run.

top=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

# The program of a board is part of the machine: it is what these two versions give. Debian 12 and 13
# have them both; releases within GCC 12 have given the same.
gcc_version=12
glm_version=0.9.9.8
compiler=m68k-linux-gnu-g++-$gcc_version
# shellcheck disable=SC2034 # It is used by who sources this.
target_flags=(-std=c++17 -fno-inline-functions-called-once -m68000 -ffreestanding -fno-exceptions
  -fno-rtti -DNDEBUG -Wall -Wextra -Werror)

# Reads whether to make or to check; prints the usage otherwise.
check=false
read_arguments() {
  case ${1:-} in
    '') ;;
    --check) check=true ;;
    -h | --help) usage && exit ;;
    *) usage >&2 && exit 2 ;;
  esac
}

# Says why the program cannot be made here, and ends.
refuse() {
  if $check; then
    printf 'skipped: %s\n' "$*"
    exit 77
  fi
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}

glm_version_at_hand() {
  "$compiler" -ffreestanding -E -dM -include glm/detail/setup.hpp -x c++ /dev/null 2>/dev/null |
    awk '/#define GLM_VERSION_(MAJOR|MINOR|PATCH|REVISION) / { part[$2] = $3 }
      END { printf "%s.%s.%s.%s", part["GLM_VERSION_MAJOR"], part["GLM_VERSION_MINOR"],
                   part["GLM_VERSION_PATCH"], part["GLM_VERSION_REVISION"] }'
}

require_compiler() {
  command -v "$compiler" >/dev/null || refuse "$compiler is not installed"
  local found
  found=$(glm_version_at_hand)
  [[ $found == "$glm_version" ]] ||
    refuse "GLM is of version $found, the program of a board is made with $glm_version"
}

# Puts a product in its place, or compares it with what is there.
deliver() {
  local made=$1 product=$2
  if $check; then
    diff -u "$product" "$made" || {
      printf '%s makes another %s\n' "${0##*/}" "${product#"$top/"}" >&2
      exit 1
    }
  else
    cp "$made" "$product"
  fi
}

# awk: reduces a signature to the function's name: no parameters, no template arguments, no return type.
# shellcheck disable=SC2034 # It is used by who sources this.
name_of='
function name_of(signature) {
  gsub(/\(glm::qualifier\)/, "", signature)
  sub(/ \[(with|clone) .*/, "", signature)
  sub(/(\(anonymous namespace\)|\{anonymous\})::/, "", signature)
  while (gsub(/<[^<>]*>/, "", signature)) {}
  sub(/\(.*/, "", signature)
  sub(/.* /, "", signature)
  sub(/maquette::firmware::/, "", signature)
  return signature
}'
