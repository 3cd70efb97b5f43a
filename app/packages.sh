# SPDX-License-Identifier: GPL-3.0-or-later
# Packages that the program and its tests need, and how to install them. Sourced by app/run and tests/run.
# shellcheck shell=bash disable=SC2034

programPackages=(g++ cmake ninja-build libeigen3-dev libhwy-dev libqcustomplot-dev qt6-base-dev qt6-svg-dev
    qt6-tools-dev qt6-l10n-tools qt6-translations-l10n libboost-dev libmpfrc++-dev fonts-dejavu-core)

# Programs that open exported files, for tests/run only. If one is missing, its tests are skipped.
testPackages=(poppler-utils librsvg2-bin netpbm)

# Packages that exist since Debian 13 only; before, their files are part of a package above.
packagesSplitOff=(qt6-svg-plugins)

requirements="a C++20 compiler, CMake 3.25 or later, Ninja, Eigen 3.4 or later, Highway 1.0.3 or later, \
Boost's headers, MPFR C++, Qt 6.4 or later with its SVG and print modules and Linguist's tools, and QCustomPlot 2.1 built \
for Qt 6"

# isInstalled PACKAGE
isInstalled() {
    [[ $(dpkg-query -W -f '${db:Status-Status}' "$1" 2>/dev/null) == installed* ]]
}

# asRoot COMMAND…: runs a command as root, with sudo if necessary.
asRoot() {
    if ((EUID == 0)); then
        "$@"
    else
        sudo "$@"
    fi
}

# Without a network, apt would wait for minutes.
aptOptions=(-o Acquire::Retries=1 -o DPkg::Lock::Timeout=300)

# installMissing LOG PACKAGE…: installs the missing packages and prints their names. On a system without apt it does nothing,
# and CMake reports what is missing.
installMissing() {
    local log=$1 package missing=()
    shift
    command -v apt-get >/dev/null || return 0
    for package in "$@"; do
        isInstalled "$package" || missing+=("$package")
    done
    if ((${#missing[@]} > 0)); then
        echo "Installing ${missing[*]}" >&2
        # If the package lists cannot be updated, the old ones may be sufficient.
        asRoot apt-get update "${aptOptions[@]}" >"$log" 2>&1 </dev/null || true
    fi
    for package in "${packagesSplitOff[@]}"; do
        # apt-cache prints nothing, but succeeds, for a package that exists only as a dependency of another one.
        if ! isInstalled "$package" && [[ -n $(apt-cache show "$package" 2>/dev/null) ]]; then
            echo "Installing $package" >&2
            missing+=("$package")
        fi
    done
    ((${#missing[@]} > 0)) || return 0
    if ! asRoot env DEBIAN_FRONTEND=noninteractive apt-get install --yes --no-install-recommends \
        "${aptOptions[@]}" "${missing[@]}" >>"$log" 2>&1 </dev/null; then
        echo "Could not install ${missing[*]} (no network, or no permission?), see $log." >&2
        return 1
    fi
}
