# SPDX-License-Identifier: GPL-3.0-or-later
# Steps that build libraries from Debian's sources, each with a log and done once. Sourced by the scripts that make the program for
# Windows and for a browser, after `app/packages.sh`; they set `work`, the folder for everything that is built.
# shellcheck shell=bash disable=SC2154,SC2016

# make NAME COMMAND…: runs the command with its output in a log. If it fails, the end of the log is shown.
make() {
    local from=$SECONDS
    step=$1
    "${@:2}" >"$work/$step.log" 2>&1 </dev/null
    echo "Made $step: $((SECONDS - from)) s" >&2
    step=
}

# makeOnce NAME COMMAND…: the same, unless an earlier run succeeded.
makeOnce() {
    if [[ ! -e $work/$1.made ]]; then
        make "$@"
        touch "$work/$1.made"
    fi
}

step=
reportFailure() {
    if [[ -n $step ]]; then
        tail -n 40 "$work/$step.log" >&2
        echo "Could not make $step, see $work/$step.log." >&2
    fi
}
trap reportFailure EXIT

# unpack NAME PACKAGE: unpacks the sources of a Debian package into source/NAME.
unpack() {
    local from=$work/apt/source given=("${SLIDERCRANK_SOURCES:-/nowhere}/$1"-*.tar.*)
    rm -rf "$work/source/$1" "$from"
    mkdir -p "$work/source" "$from"
    if [[ -e ${given[0]} ]]; then
        tar --extract --directory "$from" --file "${given[0]}"
    else
        # Uses package lists of its own, because the system's may not include sources.
        local apt=(-o APT::Sandbox::User=root -o Dir::Etc::SourceList="$work/apt/sources.list" -o Dir::Etc::SourceParts=-
            -o Dir::State::Lists="$work/apt/lists" -o Dir::Cache="$work/apt/cache" "${aptOptions[@]}")
        mkdir -p "$work/apt/lists/partial" "$work/apt/cache/archives/partial"
        apt-get indextargets --format 'deb-src $(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' 'Origin: Debian' \
            >"$work/apt/sources.list"
        apt-get "${apt[@]}" update
        (cd "$from" && apt-get "${apt[@]}" source "$2")
    fi
    mv "$from"/*/ "$work/source/$1"
}

# notices FILE PACKAGE…: prints the file, and the copyright notices of the libraries, as Debian lists them, with the licences that
# the lists refer to. (Boost's licence does not require a notice with a compiled program.)
notices() {
    local package licence
    cat "$1"
    for package in "${@:2}"; do
        dpkg-query --show --showformat '\n\n======== ${source:Package} ${source:Version}\n\n' "$package"
        cat "/usr/share/doc/$package/copyright"
    done
    for licence in LGPL-3 LGPL-2.1 GPL-2 Apache-2.0 MPL-2.0; do
        printf '\n\n======== %s\n\n' "$licence"
        cat "/usr/share/common-licenses/$licence"
    done
}
