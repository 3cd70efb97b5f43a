# SPDX-License-Identifier: GPL-3.0-or-later
# Completion for bash: the options and their choices are read from the program's own help.
# shellcheck shell=bash

_slidercrank() {
    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command='' help line choices
    case ${COMP_WORDS[1]-} in
    solve | limits | check | compare | identify | study | render) ((COMP_CWORD > 1)) && command=${COMP_WORDS[1]} ;;
    esac
    # shellcheck disable=SC2086 # without a command, there must be no word
    help=$(LC_ALL=C.UTF-8 LANGUAGE=en "${COMP_WORDS[0]}" $command --help 2>/dev/null)
    COMPREPLY=()
    [[ $previous == -o ]] && previous=--output
    if [[ $previous == --* ]]; then
        line=$(grep -m 1 -E -- "^  ${previous}[ ,]" <<<"$help")
        choices=${line#"  $previous"}
        choices=${choices#, -?}
        choices=${choices# }
        choices=${choices%% *}
        case $choices in
        FILE*) mapfile -t COMPREPLY < <(compgen -f -- "$current") && return ;;
        WHAT) choices='figure|mechanism|polygons|frames|report|theta3|R4_x|theta3_diff|R4_x_diff|theta3_diff2|R4_x_diff2|error_position|error_velocity|error_acceleration' ;;
        esac
        if [[ $choices == *'|'* ]]; then
            mapfile -t COMPREPLY < <(compgen -W "${choices//|/ }" -- "$current")
            return
        elif [[ $choices =~ ^[A-Z] ]]; then
            return # a number cannot be completed
        fi
    fi
    if [[ $current == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(grep -o '^  --[a-z0-9-]*' <<<"$help")" -- "$current")
        return
    fi
    if [[ ${COMP_WORDS[1]} == help ]] && ((COMP_CWORD > 1)); then
        mapfile -t COMPREPLY < <(compgen -W "solve limits check compare identify study render" -- "$current")
        return
    fi
    mapfile -t COMPREPLY < <(compgen -f -- "$current")
    if ((COMP_CWORD == 1)); then
        mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "solve limits check compare identify study render help" -- "$current")
    fi
}

complete -o filenames -F _slidercrank slidercrank
