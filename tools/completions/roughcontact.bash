# bash completion for roughcontact, by the command's own option parser
_roughcontact() {
  local IFS=$'\n' found
  found=$("${COMP_WORDS[0]}" complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
  # bash replaces only what follows an equals sign.
  case "${COMP_WORDS[COMP_CWORD]}:${COMP_WORDS[COMP_CWORD - 1]}" in =:* | *:=) found=$(sed 's/^[^=]*=//' <<<"$found") ;; esac
  COMPREPLY=($found)
  [[ ${#COMPREPLY[@]} -eq 1 && ${COMPREPLY[0]} == *= ]] && compopt -o nospace
  return 0
}
complete -o bashdefault -o default -F _roughcontact roughcontact
