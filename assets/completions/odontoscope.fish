# Completion of odontoscope's command line for fish: subcommands and options as its own help names them, else files.
function __odontoscope_subcommands
    odontoscope --help 2>/dev/null | string replace -rf '^  ([a-z][a-z, -]*[a-z])   +(\S.*)' '$1\t$2' | while read -d \t names about
        for name in (string split ', ' $names)
            printf '%s\t%s\n' $name $about
        end
    end
end

function __odontoscope_subcommand
    set -l known (__odontoscope_subcommands | string split -f1 \t)
    for word in (commandline -opc)[2..]
        contains -- $word $known; and echo $word; and return 0
    end
    return 1
end

function __odontoscope_options
    odontoscope (__odontoscope_subcommand) --help 2>/dev/null | string replace -rf '^  (?:-[a-z],)?(--[a-z][a-z-]*)\S*(?: \S+)*?   +(\S.*)' '$1\t$2'
end

complete -c odontoscope -n 'not __odontoscope_subcommand >/dev/null' -f -a '(__odontoscope_subcommands)'
complete -c odontoscope -n 'string match -q -- "-*" (commandline -ct)' -f -a '(__odontoscope_options)'
