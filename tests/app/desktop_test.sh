#!/usr/bin/env bash
# What the program brings to a desktop and a shell: completions that follow its own help, a valid menu entry and description.
#   desktop_test.sh REPOSITORY PROGRAM
set -euo pipefail
assets=$1/assets
PATH=$(dirname "$2"):$PATH

fail() { echo "$*" >&2; exit 1; }

source "$assets/completions/odontoscope.bash"
# What is offered at the end of a command line.
offered() {
  COMP_WORDS=("$@")
  COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
  _odontoscope
  echo "${COMPREPLY[*]}"
}
expect() {
  local wanted=$1
  shift
  [[ $(offered "$@") == "$wanted" ]] || fail "bash, \"$*\": offered \"$(offered "$@")\", expected \"$wanted\""
}
expect reconstruct odontoscope rec
expect section odontoscope sec
expect "compare compare-images" odontoscope comp
expect --threads odontoscope --th
expect anatomy odontoscope --threads 2 an
expect --triangles odontoscope reconstruct molar.json --tri
expect "" odontoscope reconstruct mol
for subcommand in $(offered odontoscope ""); do
  [[ $(offered odontoscope "$subcommand" --hel) == --help ]] || fail "bash: $subcommand has no --help"
done

if command -v fish >/dev/null; then
  told() { fish --no-config -c "source $assets/completions/odontoscope.fish; complete -C '$1'" | cut -f1 | tr '\n' ' '; }
  [[ $(told "odontoscope rec") == "reconstruct " ]] || fail "fish, subcommand: $(told "odontoscope rec")"
  [[ $(told "odontoscope --threads 2 sec") == "section " ]] || fail "fish, after an option: $(told "odontoscope --threads 2 sec")"
  [[ $(told "odontoscope reconstruct --tri") == "--triangles " ]] || fail "fish, option: $(told "odontoscope reconstruct --tri")"
else
  echo "fish is not installed; third_party/test_packages.debian lists it"
fi
if command -v appstreamcli >/dev/null; then
  appstreamcli validate --no-net "$assets"/desktop/*.metainfo.xml
fi
if command -v desktop-file-validate >/dev/null; then
  desktop-file-validate --no-hints "$assets/desktop/odontoscope.desktop"
fi
