# Completion of odontoscope's command line for bash: subcommands and options as its own help names them, else files.
_odontoscope() {
  local program=${COMP_WORDS[0]} word=${COMP_WORDS[COMP_CWORD]} subcommands subcommand='' i
  subcommands=$("$program" --help 2>/dev/null | sed -n '/^Subcommands:/,/^$/s/^  \([a-z][a-z, -]*[a-z]\)   *.*/\1/p' | tr -d ,)
  COMPREPLY=()
  for ((i = 1; i < COMP_CWORD; ++i)); do
    [[ " ${subcommands//$'\n'/ } " == *" ${COMP_WORDS[i]} "* ]] && subcommand=${COMP_WORDS[i]} && break
  done
  if [[ $word == -* ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$("$program" $subcommand --help 2>/dev/null | sed -n 's/^  \(-[a-z],\)\{0,1\}\(--[a-z][a-z-]*\).*/\2/p')" -- "$word")
  elif [[ -z $subcommand ]]; then
    mapfile -t COMPREPLY < <(compgen -W "$subcommands" -- "$word")
  fi
}
complete -o default -F _odontoscope odontoscope
