#!/usr/bin/env bash
# Installs the Debian packages of the given sections of packages.txt, only those that are missing.
# usage: install_packages.sh SECTION...
set -euo pipefail
list="$(dirname "${BASH_SOURCE[0]}")/packages.txt"

missing=()
for section in "$@"; do
    while read -r package; do
        status="$(dpkg-query --show --showformat='${db:Status-Status}' "$package" 2>/dev/null || true)"
        [[ $status == installed ]] || missing+=("$package")
    done < <(sed -n "/^\[$section\]$/,/^\[/p" "$list" | grep -v '^[[#]' || true)
done
((${#missing[@]})) || exit 0

if ! command -v apt-get >/dev/null; then
    echo "emberleaf needs these packages, and there is no apt-get here: ${missing[*]}" >&2
    exit 1
fi
as_root=()
if ((EUID != 0)); then
    if ! command -v sudo >/dev/null || ! sudo -v; then
        echo "emberleaf needs packages that only an administrator may install. Please run:" >&2
        echo "    sudo apt-get install --no-install-recommends ${missing[*]}" >&2
        exit 1
    fi
    as_root=(sudo)
fi
echo "installing: ${missing[*]}" >&2
log="$(mktemp)"
if ! { "${as_root[@]}" apt-get update &&
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install -y --no-install-recommends "${missing[@]}"; } >"$log" 2>&1; then
    tail -n 20 "$log" >&2
    echo "the packages could not be installed; the whole log is in $log" >&2
    exit 1
fi
rm -f "$log"
