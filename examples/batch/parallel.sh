#!/bin/sh
# The same by GNU parallel, on one machine or (MACHINES=a file with their names) on several that share a folder:
#   PARTS=20 ./parallel.sh teeth.txt models [options of odontoscope batch]
set -e
list=$1 folder=$2
shift 2
if [ -n "$MACHINES" ]; then set -- --sshloginfile "$MACHINES" --workdir . -- "$@"; else set -- -- "$@"; fi
where=
while [ "$1" != -- ]; do where="$where $1"; shift; done
shift
# A part whose teeth failed ends with 1: the last call tells, so it stops nothing here.
seq "${PARTS:-20}" | parallel $where odontoscope batch "$list" -o "$folder" --part "{}/${PARTS:-20}" "$@" || true
exec odontoscope batch "$list" -o "$folder" "$@"
