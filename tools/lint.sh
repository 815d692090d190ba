# shellcheck shell=bash
# How tools/test judges what is written: the format of all sources, those outside the tests with clang-tidy,
# and scripts with shellcheck. Sourced, not run.

# shellcheck source-path=SCRIPTDIR source=prepare.sh
source "$(dirname "${BASH_SOURCE[0]}")/prepare.sh"

# Each release of clang-format formats, and each of clang-tidy judges, in its own way.
clang_version=14

# Where clang-tidy judges; the macros of Catch2 leave it little use in the tests.
linted_folders=(firmware models sim tools)

# Whether a program of that release is there; says what is left out when it is not.
has_clang_program() {
  local program=$1-$clang_version what=$2
  command -v "$program" >/dev/null && return
  printf 'test: %s: this system has no %s\n' "$what" "$program" >&2
  return 1
}

check_format() {
  has_clang_program clang-format "formats are not checked" || return 0
  (cd "$root" && find "${linted_folders[@]}" tests \( -name '*.hpp' -o -name '*.cpp' \) -print0 |
    xargs -0 -r -n 16 -P "$(nproc)" "clang-format-$clang_version" --dry-run -Werror) ||
    fail "the sources named above are not as clang-format -i leaves them"
}

lint_scripts() {
  local scripts
  mapfile -t scripts < <(cd "$root" && grep -lE '^#!.*bash|shellcheck shell=bash' tools/* tests/*/* .ci/* 2>/dev/null)
  (cd "$root" && shellcheck -x "${scripts[@]}") || fail "shellcheck found faults"
}

# Prints the files that are not as they were at a revision, or all where none is given. What is written for
# the 68000 alone is judged by its compiler: clang-tidy knows no such machine.
changed_files() {
  local revision=$1
  cd "$root" || return
  if [[ -z $revision ]]; then
    find "${linted_folders[@]}" -type f
    return
  fi
  # The repository may belong to another user than the one who works in it.
  local git=(git -c safe.directory='*')
  "${git[@]}" diff --name-only --diff-filter=d "$revision" -- "${linted_folders[@]}" &&
    "${git[@]}" ls-files --others --exclude-standard -- "${linted_folders[@]}"
}

# Reads what ninja recorded when it built (ninja -t deps) and prints each source of the linted folders with
# itself and each header in them that it includes. Headers are seen through the mirrors of rooms.cmake; paths
# begin at the root, or at the build folder where a compiler cache made them so.
inclusions() {
  local folders=${linted_folders[*]}
  awk -v top="$root/" -v linted="^(${folders// /|})/" '
    function path_in_project(path) {
      if (index(path, top) == 1) path = substr(path, length(top) + 1)
      sub(/^(\.\.\/\.\.\/|(build\/[^\/]*\/)?rooms\/[^\/]*\/)/, "", path)
      return path
    }
    /^[^ ]/ { source = "" }
    sub(/^ +/, "") {
      path = path_in_project($0)
      if (source == "") source = path
      if (source ~ linted && path ~ linted) print source, path
    }' | LC_ALL=C sort -u
}

# Reads the files to judge and prints the sources to compile for it: themselves, and for a header that none
# of them includes the source of its name, or else the first one that does. Takes the inclusions as a file.
sources_to_compile() {
  awk '
    function choose(source) { chosen[source]; print source }
    function is_covered(header,  source) {
      for (source in chosen) if ((source, header) in includes) return 1
      return 0
    }
    FILENAME == ARGV[1] { includes[$1, $2]; if (!($2 in first)) first[$2] = $1; next }
    ($1, $1) in includes { choose($1); next }
    { others[++count] = $1 }
    END {
      for (i = 1; i <= count; ++i) {
        file = own = others[i]
        sub(/hpp$/, "cpp", own)
        if (is_covered(file)) continue
        if ((own, file) in includes) choose(own)
        else if (file in first) choose(first[file])
        else { printf "%s: the build compiles nothing with it\n", file >"/dev/stderr"; failed = 1 }
      }
      exit failed
    }' "$1" -
}

# Judges the C++ files that are not as they were at a revision by compiling at most so many sources; with
# neither, all of them.
lint_sources() {
  local build_folder=$1 revision=$2 at_most=$3 files chosen sources left_out
  has_clang_program clang-tidy "clang-tidy is left out" || return 0
  files=$(changed_files "$revision") || fail "git does not know what has changed since $revision"
  chosen=$(sed -n '\|^firmware/board/|d; /\.[ch]pp$/p' <<<"$files" | LC_ALL=C sort |
    sources_to_compile <(ninja -C "$build_folder" -t deps | inclusions)) ||
    fail "the files named above cannot be judged"
  mapfile -t sources < <(printf '%s' "$chosen")
  left_out=("${sources[@]:${at_most:=${#sources[@]}}}")
  sources=("${sources[@]:0:at_most}")
  printf 'test: clang-tidy judges %d sources\n' "${#sources[@]}" >&2
  ((${#left_out[@]} == 0)) || printf 'test: left out: %s\n' "${left_out[*]}" >&2
  ((${#sources[@]} == 0)) ||
    quietly "run-clang-tidy-$clang_version" -quiet -p "$build_folder" -j "$(nproc)" "${sources[@]/#//}" ||
    fail "clang-tidy found faults"
}
