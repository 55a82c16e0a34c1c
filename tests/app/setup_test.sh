#!/usr/bin/env bash
# What ./run and ./test do about packages, with stand-ins for apt and sudo: which are asked for, and what is said.
#   setup_test.sh REPOSITORY
set -euo pipefail
repository=$1
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
passed=0

# A PATH of its own, so that nothing of this machine's is called by mistake.
tools=$scratch/tools
mkdir "$tools"
for tool in bash basename cat dirname env grep sed tr; do ln -s "$(command -v "$tool")" "$tools/$tool"; done

stand_in() {
  printf '#!%s\n%s\n' "$tools/bash" "$2" >"$tools/$1"
  chmod +x "$tools/$1"
}

# Runs install_packages with the lists given, by default that of the program; leaves what was said in $said, the exit code in $code and the calls of apt-get in $calls.
install() {
  : >"$scratch/calls"
  code=0
  said=$(PATH=$tools "$tools/bash" -c 'set -euo pipefail; source "$1/third_party/setup.sh"; install_packages "${@:2}"' x "$repository" "${@:-packages.debian}" 2>&1) ||
    code=$?
  calls=$(cat "$scratch/calls")
}

expect() {
  local what=$1
  shift
  if "$@"; then
    passed=$((passed + 1))
  else
    printf 'FAILED: %s\nexit code %s, said:\n%s\ncalls:\n%s\n' "$what" "$code" "$said" "$calls"
    exit 1
  fi
}
says() { [[ $said == *"$1"* ]]; }

install
expect "without apt it stops" [ "$code" -eq 1 ]
expect "without apt it says what is needed" says libcgal-dev
expect "without apt it says how to go on" says ODONTOSCOPE_SKIP_PACKAGES=1

# Everything but two packages is there; one of the two was removed but not purged.
stand_in dpkg-query 'shift 3; for name; do case $name in libtbb-dev) ;; libgtest-dev) echo "$name config-files" ;; *) echo "$name installed" ;; esac; done'
stand_in apt-get "echo \"apt-get \$*\" >>'$scratch/calls'"
stand_in id 'echo 0'
install
expect "root installs" [ "$code" -eq 0 ]
expect "the missing ones and no others" [ "${calls##*--no-install-recommends }" = "libtbb-dev libgtest-dev" ]
expect "after an update" [ "${calls%%$'\n'*}" = "apt-get update" ]
expect "and says which" says "libtbb-dev libgtest-dev"

stand_in id 'echo 1000'
install
expect "nobody in particular without sudo stops" [ "$code" -eq 1 ]
expect "and says what to ask for" says "apt-get install --no-install-recommends libtbb-dev libgtest-dev"
expect "and calls nothing" [ -z "$calls" ]

stand_in sudo "echo sudo >>'$scratch/calls'; \"\$@\""
install
expect "with sudo it installs" [ "$code" -eq 0 ]
expect "through sudo" [ "${calls%%$'\n'*}" = sudo ]

stand_in apt-get 'echo "E: no network"; exit 100'
install
expect "a failure of apt stops it" [ "$code" -eq 1 ]
expect "with apt's own words" says "E: no network"

stand_in dpkg-query 'shift 3; for name; do echo "$name installed"; done'
stand_in apt-get "echo \"apt-get \$*\" >>'$scratch/calls'"
install
expect "with all there it succeeds" [ "$code" -eq 0 ]
expect "without a word" [ -z "$said" ]
expect "and without calling apt" [ -z "$calls" ]

# A package that is only wanted where a command is missing or too old.
stand_in dpkg-query 'shift 3; for name; do case $name in nodejs | npm) ;; *) echo "$name installed" ;; esac; done'
install
expect "without Node.js it is installed" [ "${calls##*--no-install-recommends }" = "nodejs npm" ]
stand_in node 'echo v16.20.2'
stand_in npm 'echo 10.2.4'
install
expect "in place of one that is too old, too" [ "${calls##*--no-install-recommends }" = nodejs ]
stand_in node 'echo v22.1.0'
install
expect "and one from elsewhere is kept" [ -z "$calls" ]

# Only tests ask for what they alone need.
stand_in dpkg-query 'shift 3; for name; do case $name in chromium | gmsh) ;; *) echo "$name installed" ;; esac; done'
install
expect "the program needs no browser" [ -z "$calls" ]
install packages.debian test_packages.debian
expect "its tests do" [ "${calls##*--no-install-recommends }" = "gmsh chromium" ]

echo "$passed passed, 0 failed"
