# shellcheck shell=bash
# Shared by ./run and ./test: the packages that are missing, then a configured build folder. Bash alone; it must work
# before anything else is installed. Messages go to stderr, so that the output of the program itself stays clean.
#
#   install_packages LIST ...   what these lists of third_party/ name and the machine lacks
#   build PRESET FOLDER TARGET ...  configures FOLDER by the preset unless it is, then builds TARGETs

newly_installed=no
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)

say() { printf '%s\n' "$*" >&2; }
fail() { say "$(basename "$0"): $*"; exit 1; }

# Runs a command; shows what it said only if it failed.
quietly() {
  local why=$1 log
  shift
  log=$("$@" 2>&1 </dev/null) || { say "$log"; fail "$why Its words are above."; }
}

# A line "PACKAGE unless COMMAND VERSION" asks for a package only where that command is missing or older: whoever has a newer one
# from elsewhere keeps it.
listed_packages() {
  local package word command oldest lists=("${@/#/$root/third_party/}")
  while read -r package word command oldest; do
    if [[ $word == unless ]] && has_command "$command" "$oldest"; then continue; fi
    echo "$package"
  done < <(sed -e 's/#.*//' -e 's/[[:space:]]*$//' -e '/^$/d' "${lists[@]}")
}

# Whether COMMAND is there and says a version whose first number is VERSION or higher.
has_command() {
  local version
  version=$("$1" --version 2>/dev/null </dev/null) || return 1
  [[ $version =~ [0-9]+ ]] && ((BASH_REMATCH[0] >= $2))
}

missing_packages() {
  local wanted installed
  wanted=$(listed_packages "$@")
  # dpkg-query complains about packages it never heard of; those are missing all the same.
  # shellcheck disable=SC2086
  installed=$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' $wanted 2>/dev/null | sed -n 's/ installed$//p')
  grep -vxF -f <(printf '%s\n' "$installed") <<<"$wanted" || true
}

install_packages() {
  if [[ -n ${ODONTOSCOPE_SKIP_PACKAGES:-} ]]; then return; fi
  if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
    say "This is no Debian, so nothing can be installed for you. Odontoscope needs what these Debian packages hold:"
    say "  $(listed_packages "$@" | tr '\n' ' ')"
    say "Install their counterparts (README.md, \"Other systems\"), then run again with ODONTOSCOPE_SKIP_PACKAGES=1."
    exit 1
  fi
  local missing
  missing=$(missing_packages "$@" | tr '\n' ' ')
  if [[ -z ${missing// /} ]]; then return; fi

  local as_root=(env)
  if [[ $(id -u) -ne 0 ]]; then
    command -v sudo >/dev/null || fail "these packages are missing, and installing them needs root or sudo. Ask for:
  apt-get install --no-install-recommends $missing"
    as_root=(sudo env)
  fi
  say "Installing with apt, which takes minutes the first time: $missing"
  quietly "apt-get update failed. Is the network up?" "${as_root[@]}" apt-get update
  # shellcheck disable=SC2086
  quietly "apt-get could not install the packages. The list is written for Debian 12." "${as_root[@]}" \
    DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends $missing
  newly_installed=yes
}

# One job for each processor, but no more than the free memory carries: a file with CGAL's triangulations takes 1 GB.
jobs_that_fit() {
  local processors kilobytes limit fit
  processors=$(nproc)
  kilobytes=$(sed -n 's/^MemAvailable: *\([0-9]*\) kB/\1/p' /proc/meminfo 2>/dev/null || true)
  limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null || true)
  if [[ $limit =~ ^[0-9]+$ ]] && ((limit / 1024 < ${kilobytes:-0})); then kilobytes=$((limit / 1024)); fi
  fit=$((${kilobytes:-0} / 1300000))
  if ((fit < 1)); then fit=1; fi
  echo $((processors < fit ? processors : fit))
}

# A folder that was configured somewhere else, or only half, starts afresh. One from before packages came looks for them again.
configure() {
  local preset=$1 folder=$2 home
  home=$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$folder/CMakeCache.txt" 2>/dev/null || true)
  if [[ -f $folder/build.ninja && $home == "$root" ]]; then
    if [[ $newly_installed == yes ]]; then quietly "CMake failed." cmake --preset "$preset"; fi
    return
  fi
  local launcher=()
  if command -v ccache >/dev/null; then launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache); fi
  say "Configuring $folder"
  quietly "CMake failed." cmake --fresh --preset "$preset" "${launcher[@]}"
}

build() {
  local preset=$1 folder=$2
  shift 2
  cd "$root" || exit 1
  configure "$preset" "$folder"
  if [[ $(ninja -C "$folder" -n "$@" 2>/dev/null) == *"no work to do"* ]]; then return; fi
  local jobs
  jobs=$(jobs_that_fit)
  say "Building $folder ($*, $jobs at a time; the first time takes minutes)"
  ninja -C "$folder" -j "$jobs" "$@" >&2 || fail "the build failed. Its words are above."
}
